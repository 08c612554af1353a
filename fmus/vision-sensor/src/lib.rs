//! `VisionSensor`: a camera below the pivot that measures the swing of the payload (thesis 4.1.1, 6.2.2).

use swayless_export::{Clock, Environment, Event, Info, Interval, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_sensing::{Camera, Located, Noise, Sampler, Timing, quantise};

mod variables;

use variables::{Discrete, Inputs, Parameters};

/// The model.
struct VisionSensor;

const SAMPLE: usize = 0;
const DELIVERY: usize = 1;

/// Displacement and swing, radial and tangential each.
type Reading = [f64; 4];

fn timing(p: &Parameters<f64>) -> Timing {
    Timing { sample_time: p.sample_time, latency: p.latency }
}

/// What is measured in an image taken now.
fn measure(p: &Parameters<f64>, u: &Inputs<f64>, noise: &mut Noise) -> Option<Reading> {
    let noise = [noise.draw(), noise.draw()];
    let camera = Camera { drop: p.camera.drop, field_of_view: p.field_of_view };
    let pitch = p.leveling.gain * (u.luff.angle - p.leveling.luff_reference);
    let image = camera.image(u.hoist.length, [u.swing.radial, u.swing.tangential], pitch)?;
    let seen = std::array::from_fn(|axis| quantise(image[axis] + p.noise * noise[axis], p.pixel_size));
    let Located { displacement, swing } = camera.locate(u.hoist.length, seen)?;
    Some([displacement[0], displacement[1], swing[0], swing[1]])
}

/// Shows a reading; without one the last stays.
fn show(reading: Option<Reading>, d: &mut Discrete<f64>) {
    d.valid = reading.is_some();
    let Some([radial, tangential, swing_radial, swing_tangential]) = reading else { return };
    (d.measured.displacement.radial, d.measured.displacement.tangential) = (radial, tangential);
    (d.measured.swing.radial, d.measured.swing.tangential) = (swing_radial, swing_tangential);
}

/// What is connected together: what is measured has the member names of what is looked at.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "swing",
        description: "Swing of what the camera looks at",
        kind: "swing",
        members: &[("swing.radial", "radial"), ("swing.tangential", "tangential")],
    },
    Terminal { name: "hoist", description: "Hoisting axis", kind: "axis", members: &[("hoist.length", "position")] },
    Terminal {
        name: "luff",
        description: "Luffing axis, which pitches a camera that is not levelled well",
        kind: "axis",
        members: &[("luff.angle", "position")],
    },
    Terminal {
        name: "measured",
        description: "Swing as it is measured",
        kind: "swing",
        members: &[
            ("measured.swing.radial", "radial"),
            ("measured.swing.tangential", "tangential"),
            ("measured.displacement.radial", "displacement.radial"),
            ("measured.displacement.tangential", "displacement.tangential"),
            ("valid", "valid"),
        ],
    },
];

impl Model for VisionSensor {
    const INFO: Info = Info {
        name: "VisionSensor",
        description: "Camera that measures the swing of the payload",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 20.0,
        step_size: 0.01,
    };
    // What falls due when a sample is taken leaves its room to it.
    const CLOCKS: &'static [Clock] = &[
        Clock { priority: 1, ..Clock::new("sample", "Takes an image", Interval::OfFixedParameters) },
        Clock::new("delivery", "Gives out what was measured in an image", Interval::Countdown),
    ];
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = Sampler<Reading>;
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

export_fmu!(VisionSensor);
