//! `BoomLift`: an articulated boom lift, driven by rates (thesis 3.5, fig. 3.7).

use swayless_crane::{are_physical, cut, terminals};
use swayless_export::{Event, Info, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_mechanics::{Boom, SwingFrame};

mod variables;

use variables::{Discrete, Inputs, Outputs, Parameters, States};

/// The model.
struct BoomLift;

/// What is connected together; a drive's axis has the same member names.
const TERMINALS: &[Terminal] = &[
    terminals::SLEW,
    terminals::LUFF,
    Terminal {
        name: "extension",
        description: "Extension of the boom",
        kind: "axis",
        members: &[("extension.rate", "rate"), ("extension.length", "position")],
    },
    terminals::TIP,
];

impl Model for BoomLift {
    const INFO: Info = Info {
        name: "BoomLift",
        description: "Articulated boom lift, driven by rates",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 20.0,
        step_size: 0.01,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete;
    type Memory = ();
    type Indicators = [f64; 4];

    fn check(p: &Parameters<f64>, declared: &States<f64>) -> Vec<Problem> {
        let joints = [
            ("luff.angle", p.luff.limits(), declared.luff.angle),
            ("extension.length", p.extension.limits(), declared.extension.length),
        ];
        joints.into_iter().filter_map(|(name, limits, start)| Some(Problem::new(name, limits.check(start)?))).collect()
    }

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let mut dx = at.x.clone();
        dx.slew.angle = cut(at.u.slew.rate);
        dx.luff.angle = R::select(at.d.luff.stopped, R::zero(), cut(at.u.luff.rate));
        dx.extension.length = R::select(at.d.extension.stopped, R::zero(), cut(at.u.extension.rate));
        dx
    }

    /// x = (r + ρ) cos γ cos θ, y = (r + ρ) cos γ sin θ, z = h + (r + ρ) sin γ.
    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let Point { p, x, .. } = *at;
        let boom = Boom {
            base: [R::zero(); 2],
            yaw: R::zero(),
            slew: x.slew.angle,
            luff: x.luff.angle,
            length: p.boom.length + x.extension.length,
            offset: R::zero(),
            height: p.boom.height,
        };
        let tip = boom.tip(&SwingFrame::new(x.slew.angle, R::zero()));
        Outputs { tip: tip.into() }
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 4] {
        let [lowest, highest] = at.p.luff.limits().indicators(at.x.luff.angle, at.u.luff.rate);
        let [shortest, longest] = at.p.extension.limits().indicators(at.x.extension.length, at.u.extension.rate);
        [lowest, highest, shortest, longest]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        let rates = [at.u.slew.rate, at.u.luff.rate, at.u.extension.rate];
        at.d.luff.stopped = at.p.luff.limits().hold(&mut at.x.luff.angle, at.u.luff.rate);
        at.d.extension.stopped = at.p.extension.limits().hold(&mut at.x.extension.length, at.u.extension.rate);
        at.d.at_limit = at.d.luff.stopped || at.d.extension.stopped || !are_physical(&rates);
        None
    }
}

export_fmu!(BoomLift);
