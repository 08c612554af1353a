//! A bouncing ball with one of everything that a variable can be.

use swayless_export::{Enumeration, Event, Info, Model, Point, Scalar, Terminal, Variables};

/// The model.
pub struct Ball;

#[derive(Clone, Copy, Debug, PartialEq, Enumeration)]
pub enum Ground {
    /// The ball bounces.
    Hard,
    /// The ball stays.
    Soft,
}

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Gravity.
    #[variable(unit = "m/s2", start = 9.81, min = 0.1)]
    pub gravity: R,
    /// Part of the speed left after a bounce.
    #[variable(unit = "1", start = 0.5, min = 0.0, max = 1.0, tunable)]
    pub restitution: R,
    /// What the ball falls on.
    #[variable(start = Ground::Hard)]
    pub ground: Ground,
    /// Weights of nothing.
    #[variable(start = [1.0, 2.0, 3.0])]
    pub weights: [R; 3],
    /// A name.
    #[variable(start = "ball & <co>")]
    pub label: String,
    /// Makes the model panic at its first event.
    pub panics: bool,
    /// A number.
    #[variable(start = -7)]
    pub number: i32,
    /// Interval of a tick; 0 for none.
    #[variable(unit = "s", min = 0.0)]
    pub tick: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// Force on the ball, by its mass.
    #[variable(unit = "m/s2")]
    pub push: R,
    /// Lifts the ground.
    #[variable(unit = "m", discrete)]
    pub floor: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    /// Height.
    #[variable(unit = "m", output, start = 1.0)]
    pub height: R,
    /// Velocity, upwards.
    #[variable(unit = "m/s")]
    pub velocity: R,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    /// Acceleration.
    #[variable(unit = "m/s2")]
    pub acceleration: R,
    /// Height above the ground.
    #[variable(unit = "m")]
    pub clearance: R,
    /// Energy by mass.
    pub energy: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    /// How often it has bounced.
    #[variable(output, depends_on = ["height"])]
    pub bounces: i32,
    /// Where the ground is.
    #[variable(unit = "m", depends_on = ["floor"])]
    pub surface: R,
    /// How often it has ticked.
    #[variable(output, depends_on = [])]
    pub ticks: i32,
    /// Whether it lies.
    #[variable(output)]
    pub lies: bool,
}

impl Model for Ball {
    const INFO: Info = Info {
        name: "Ball",
        description: "A bouncing ball",
        documentation: "# Ball",
        icon: "<svg/>",
        terminals: &[
            Terminal {
                name: "above",
                description: "What it does",
                kind: "ball",
                members: &[("lies", "lies"), ("ticks", "ticks")],
            },
            Terminal {
                name: "below",
                description: "What acts on it",
                kind: "push",
                members: &[("push", "force"), ("floor", "floor")],
            },
        ],
        stop_time: 3.0,
        step_size: 0.01,
    };
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete<R>;
    /// How often it has ticked.
    type Memory = i32;
    type Indicators = [f64; 1];

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        let falling = at.u.push - at.p.gravity;
        States {
            height: R::select(at.d.lies, R::zero(), at.x.velocity),
            velocity: R::select(at.d.lies, R::zero(), falling),
        }
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        Outputs {
            acceleration: Self::derivatives(at).velocity,
            clearance: at.x.height - at.d.surface,
            energy: at.x.velocity * at.x.velocity * 0.5 + at.x.height * at.p.gravity,
        }
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 1] {
        // Positive as soon as the ball goes up again, so that leaving the ground is no event.
        [if at.d.lies { 1.0 } else { (at.x.height - at.d.surface).max(at.x.velocity) }]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        assert!(at.initial || !at.p.panics, "the ball panics");
        at.d.surface = at.u.floor;
        if !at.d.lies && at.x.height <= at.d.surface && at.x.velocity < 0.0 {
            at.x.height = at.d.surface;
            at.x.velocity *= -at.p.restitution;
            at.d.bounces += 1;
            at.d.lies = at.p.ground == Ground::Soft || at.x.velocity < 1e-3;
        }
        if at.p.tick == 0.0 {
            return None;
        }
        if !at.initial && at.t >= f64::from(*at.memory + 1) * at.p.tick {
            *at.memory += 1;
            at.d.ticks = *at.memory;
        }
        Some(f64::from(*at.memory + 1) * at.p.tick)
    }
}
