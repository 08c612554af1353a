//! Tanks that run dry on their own: as many states as a structural parameter says, and an event when the first is empty.

use swayless_export::{Event, Info, Model, Point, Scalar, Variables};

/// The model.
pub struct Chain;

/// Room for tanks.
pub const ROOM: usize = 3;

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// How many tanks there are.
    #[variable(start = 2, min = 1, max = 3, tunable)]
    pub count: u32,
    /// What flows out of each.
    #[variable(unit = "m/s", start = [1.0, 2.0, 4.0], length = "count")]
    pub outflow: [R; ROOM],
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// What flows into each.
    #[variable(unit = "m/s")]
    pub inflow: R,
}

#[derive(Clone, Variables)]
pub struct States<R: Scalar> {
    /// The levels.
    #[variable(unit = "m", output, start = [1.0, 10.0, 100.0], length = "count")]
    pub level: [R; ROOM],
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    /// The first level, twice.
    #[variable(unit = "m")]
    pub double: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    /// How often the first tank has been filled again, to 1 m, when it was empty.
    #[variable(output, depends_on = ["level"])]
    pub refills: R,
}

impl Model for Chain {
    const INFO: Info = Info::new("Chain", "Tanks");
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = ();
    type Indicators = [f64; 1];

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        States { level: std::array::from_fn(|i| at.u.inflow - at.p.outflow[i]) }
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        Outputs { double: at.x.level[0] + at.x.level[0] }
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 1] {
        [at.x.level[0]]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        if at.x.level[0] <= 0.0 {
            at.x.level[0] = 1.0;
            at.d.refills += 1.0;
        }
        None
    }
}
