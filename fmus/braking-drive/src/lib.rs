//! `BrakingDrive`: a drive that accelerates and brakes with unequal time constants (thesis 5.2, fig. 5.12).

use swayless_crane::terminals;
use swayless_export::{Event, Info, Model, Point, Scalar, export_fmu};

mod variables;

use variables::{Discrete, Inputs, Outputs, Parameters, States};

/// The model.
struct BrakingDrive;

/// v̇ = (v_c − v)/τ, with τ_b while the axis brakes and τ_a else.
fn acceleration<R: Scalar>(at: &Point<'_, BrakingDrive, R>) -> R {
    let constant = R::select(at.d.braking, at.p.braking_time_constant, at.p.acceleration_time_constant);
    (at.d.target - at.x.velocity) / constant
}

impl Model for BrakingDrive {
    const INFO: Info = Info {
        name: "BrakingDrive",
        description: "Drive of one crane axis that brakes with another time constant than it accelerates",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: &[terminals::COMMAND, terminals::DRIVEN_AXIS],
        stop_time: 5.0,
        step_size: 0.01,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = ();
    type Indicators = [f64; 0];

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        States { position: at.x.velocity, velocity: acceleration(at) }
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        Outputs { acceleration: acceleration(at) }
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        let (p, d) = (at.p, &mut *at.d);
        let target = at.u.command.clamp(-p.velocity_limit, p.velocity_limit);
        d.saturated = target != at.u.command;
        if target != d.target || at.initial {
            let v = at.x.velocity;
            d.target = target;
            d.reversal.ahead = (v > 0.0 && target < 0.0) || (v < 0.0 && target > 0.0);
            d.braking = d.reversal.ahead || target.abs() < v.abs();
            if d.reversal.ahead {
                // v_c + (v₀ − v_c) e^{−(t − t₀)/τ_b} = 0; the quotient of tiny commands would overflow.
                d.reversal.time = at.t + p.braking_time_constant * (v / target).abs().min(f64::MAX).ln_1p();
            }
        }
        if d.reversal.ahead && at.t >= d.reversal.time {
            at.x.velocity = 0.0;
            d.reversal.ahead = false;
            d.braking = false;
        }
        d.reversal.ahead.then_some(d.reversal.time)
    }
}

export_fmu!(BrakingDrive);
