//! `FlexibleModes`: lightly damped modes on a moving base, as the flexible rods of thesis 5.3.

use std::array::from_fn;

use swayless_crane::{are_physical, cut};
use swayless_export::{Event, Info, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_mechanics::{Mode, ModeState};

mod variables;

use variables::{Discrete, Inputs, ModeOutputs, Outputs, Parameters, ROOM, States};

/// No start is farther away or faster (m, m/s).
const FARTHEST: f64 = 1e6;

/// The model.
struct FlexibleModes;

/// A mode and where it is.
fn mode<R: Scalar>(at: &Point<'_, FlexibleModes, R>, i: usize) -> (Mode<R>, ModeState<R>) {
    let (p, x) = (&at.p.mode, &at.x.mode);
    let mode = Mode { frequency: p.frequency[i], damping_ratio: p.damping_ratio[i] };
    (mode, ModeState { deflection: x.deflection[i], velocity: x.velocity[i] })
}

/// What is connected together.
const TERMINALS: &[Terminal] = &[Terminal {
    name: "axis",
    description: "The axis that moves the base",
    kind: "axis",
    members: &[("base.velocity", "rate")],
}];

impl Model for FlexibleModes {
    const INFO: Info = Info {
        name: "FlexibleModes",
        description: "Lightly damped modes on a moving base",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 5.0,
        step_size: 0.005,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete;
    type Memory = ();
    type Indicators = [f64; 0];

    fn check(p: &Parameters<f64>, declared: &States<f64>) -> Vec<Problem> {
        let starts = [("mode.deflection", &declared.mode.deflection), ("mode.velocity", &declared.mode.velocity)];
        let each = starts
            .iter()
            .flat_map(|(name, values)| values.iter().map(move |value| (*name, *value)).take(p.mode.count as usize));
        let far = each.filter(|(_, value)| value.abs() > FARTHEST);
        far.map(|(name, value)| {
            Problem::new(name, format!("is {value}; it must lie between -{FARTHEST} and {FARTHEST}"))
        })
        .collect()
    }

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let base = cut(at.u.base.velocity);
        let mut dx = at.x.clone();
        for i in 0..ROOM {
            let (mode, state) = mode(at, i);
            let rates = mode.rates(&state, base);
            dx.mode.deflection[i] = rates.deflection;
            dx.mode.velocity[i] = rates.velocity;
        }
        dx
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        let base = cut(at.u.base.velocity);
        let each: [_; ROOM] = from_fn(|i| mode(at, i));
        let rate = each.map(|(_, state)| state.rate(base));
        let amplitude = each.map(|(mode, state)| mode.amplitude(&state, base));
        let count = at.p.mode.count as usize;
        let sum = |values: &[R; ROOM]| values.iter().take(count).fold(R::zero(), |sum, value| sum + *value);
        Outputs {
            deflection: sum(&at.x.mode.deflection),
            amplitude: sum(&amplitude),
            mode: ModeOutputs { rate, amplitude },
        }
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        at.d.at_limit = !are_physical(&[at.u.base.velocity]);
        None
    }
}

export_fmu!(FlexibleModes);
