//! `Faulty`: a first-order lag with a threshold that panics where a parameter says; for tests of what the host sees.

use swayless_export::{Environment, Event, Info, Model, Point, Problem, Scalar, Variables, export_fmu};

mod memory;

use memory::Memory;

struct Faulty;

#[derive(Clone, Variables)]
struct Parameters<R: Scalar> {
    /// Where to panic: check, memory, start, derivatives, outputs, indicators, event, and clone, serialize or drop of
    /// the memory; nowhere where empty.
    #[variable(tunable)]
    fault: String,
    /// Time constant of the lag.
    #[variable(unit = "s", start = 0.5, min = 1e-3)]
    time_constant: R,
}

#[derive(Clone, Variables)]
struct Inputs<R: Scalar> {
    /// What the lag follows.
    #[variable(discrete)]
    u: R,
}

#[derive(Clone, Variables)]
struct States<R: Scalar> {
    /// The lag's value.
    #[variable(output)]
    x: R,
}

#[derive(Clone, Variables)]
struct Outputs<R: Scalar> {
    /// How fast the lag moves.
    rate: R,
}

#[derive(Clone, Variables)]
struct Discrete<R: Scalar> {
    /// Whether the lag's value is above the threshold of 0.1.
    #[variable(output, depends_on = ["x"])]
    above: bool,
    /// How often the lag's value has crossed the threshold.
    #[variable(output, depends_on = ["x"])]
    crossings: R,
    /// The input, not beyond ±1000.
    #[variable(depends_on = ["u"])]
    target: R,
}

/// Panics if the parameter names this place.
fn fault<R: Scalar>(p: &Parameters<R>, place: &str) {
    assert!(p.fault != place, "a fault in {place}, as wanted: 100 %s");
}

impl Model for Faulty {
    const INFO: Info = Info::new("Faulty", "A lag that panics where a parameter says");
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = States<R>;
    type Outputs<R: Scalar> = Outputs<R>;
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = Memory;
    type Indicators = [f64; 1];

    fn check(p: &Parameters<f64>, _: &States<f64>) -> Vec<Problem> {
        fault(p, "check");
        Vec::new()
    }

    fn memory(p: &Parameters<f64>, _: &Environment<'_>) -> Result<Memory, Problem> {
        fault(p, "memory");
        Ok(Memory { fault: p.fault.clone() })
    }

    fn start<R: Scalar>(p: &Parameters<R>, _: &Inputs<R>, declared: &States<R>) -> States<R> {
        fault(p, "start");
        declared.clone()
    }

    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> States<R> {
        fault(at.p, "derivatives");
        States { x: (at.d.target - at.x.x) / at.p.time_constant }
    }

    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Outputs<R> {
        fault(at.p, "outputs");
        Outputs { rate: (at.d.target - at.x.x) / at.p.time_constant }
    }

    fn indicators(at: &Point<'_, Self, f64>) -> [f64; 1] {
        fault(at.p, "indicators");
        // The threshold lies a little lower once it is crossed, so that the event does not chatter.
        [at.x.x - if at.d.above { 0.099 } else { 0.1 }]
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        fault(at.p, "event");
        at.memory.fault.clone_from(&at.p.fault);
        let above = at.x.x > if at.d.above { 0.099 } else { 0.1 };
        at.d.crossings += if above == at.d.above { 0.0 } else { 1.0 };
        at.d.above = above;
        at.d.target = at.u.u.clamp(-1e3, 1e3);
        None
    }
}

export_fmu!(Faulty);
