//! `RangeSensor`: a laser that measures a distance (thesis 6.2.2).

use swayless_export::{Clock, Environment, Event, Info, Interval, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_sensing::{Noise, Sampler, Timing, quantise};

mod variables;

use variables::{Discrete, Inputs, Parameters};

/// The model.
struct RangeSensor;

const SAMPLE: usize = 0;
const DELIVERY: usize = 1;

fn timing(p: &Parameters<f64>) -> Timing {
    Timing { sample_time: p.sample_time, latency: p.latency }
}

/// The distance that is measured now.
fn measure(p: &Parameters<f64>, u: &Inputs<f64>, noise: &mut Noise) -> Option<[f64; 1]> {
    let noise = p.noise * noise.draw();
    let reading = || quantise(u.distance + noise, p.resolution).clamp(0.0, p.range);
    (0.0..=p.range).contains(&u.distance).then(|| [reading()])
}

/// Shows a reading; without one the last stays.
fn show(reading: Option<[f64; 1]>, d: &mut Discrete<f64>) {
    d.valid = reading.is_some();
    if let Some([distance]) = reading {
        d.measured.distance = distance;
    }
}

/// What is connected together: a crane's axis, and the axis as it is measured.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "axis",
        description: "Axis whose position is the distance to the target",
        kind: "axis",
        members: &[("distance", "position")],
    },
    Terminal {
        name: "measured",
        description: "Position of the axis as it is measured",
        kind: "axis",
        members: &[("measured.distance", "position"), ("valid", "valid")],
    },
];

impl Model for RangeSensor {
    const INFO: Info = Info {
        name: "RangeSensor",
        description: "Laser that measures a distance",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 20.0,
        step_size: 0.01,
    };
    // What falls due when a sample is taken leaves its room to it.
    const CLOCKS: &'static [Clock] = &[
        Clock { priority: 1, ..Clock::new("sample", "Takes a sample", Interval::OfFixedParameters) },
        Clock::new("delivery", "Gives out a measured distance", Interval::Countdown),
    ];
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = Sampler<[f64; 1]>;
    type Indicators = [f64; 0];

    fn check(p: &Parameters<f64>, (): &()) -> Vec<Problem> {
        timing(p).check().err().map(|error| Problem::new(error.quantity(), error.to_string())).into_iter().collect()
    }

    fn memory(p: &Parameters<f64>, _: &Environment<'_>) -> Result<Self::Memory, Problem> {
        Ok(Sampler::new(p.seed.cast_unsigned().into(), timing(p)))
    }

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn interval(_: usize, p: &Parameters<f64>) -> f64 {
        p.sample_time
    }

    fn next_tick(_: usize, at: &Point<'_, Self, f64>) -> Option<f64> {
        at.memory.next_delivery()
    }

    fn tick(clock: usize, at: &mut Event<'_, Self>) {
        let (p, u, d) = (at.p, at.u, &mut *at.d);
        match clock {
            SAMPLE => {
                let reading = at.memory.sample(at.t, timing(p), |noise| measure(p, u, noise));
                if let Some(reading) = reading {
                    show(reading, d);
                }
            }
            DELIVERY => at.memory.deliver(at.t, |reading| show(reading, d)),
            _ => {}
        }
    }
}

export_fmu!(RangeSensor);
