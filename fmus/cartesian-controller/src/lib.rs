//! `CartesianController`: moves the load of a crane in Cartesian directions (thesis chapter 3).

use serde::{Deserialize, Serialize};
use swayless_crane::{cut, terminals};
use swayless_export::{Clock, Event, Info, Interval, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_mechanics::{AXES, Axis, AxisRates};
use swayless_sensing::Timing;

mod motion;
mod ramp;
mod response;
mod variables;

use motion::{Joints, Moved, acceleration_limits, is_physical, moved};
use ramp::{Ramp, Told};
use response::{Driven, Response};
use variables::{Discrete, Inputs, Parameters};

/// The model.
struct CartesianController;

/// What is remembered from sample to sample.
#[derive(Clone, Default, Serialize, Deserialize)]
#[serde(try_from = "Parts")]
struct Memory {
    /// When the last sample was taken (s), and how long after the one before it.
    last: Option<f64>,
    passed: f64,
    /// What was told then, and at the sample before.
    now: Told,
    before: Told,
    drives: [Driven; AXES],
}

/// What a memory is serialized as.
#[derive(Deserialize)]
struct Parts {
    last: Option<f64>,
    passed: f64,
    now: Told,
    before: Told,
    drives: [Driven; AXES],
}

impl TryFrom<Parts> for Memory {
    type Error = &'static str;

    fn try_from(Parts { last, passed, now, before, drives }: Parts) -> Result<Self, Self::Error> {
        let are_times = last.is_none_or(f64::is_finite) && (0.0..=f64::MAX).contains(&passed);
        are_times.then_some(Self { last, passed, now, before, drives }).ok_or("the times of samples are none")
    }
}

impl Memory {
    /// Goes on to a sample: the drives have gone on with what they were told. A second sample at the same instant takes the
    /// place of the first.
    fn advance(&mut self, t: f64, response: Response) {
        let passed = self.last.map_or(0.0, |last| t - last);
        if passed > 0.0 {
            (self.before, self.passed) = (self.now, passed);
            let drives = self.drives.iter_mut().zip(&self.now.rates);
            drives.for_each(|(drive, told)| *drive = response.driven(*drive, *told, passed));
        }
        self.last = Some(t);
    }
}

/// No drives are slower (rad/s), unless they follow at once.
const SLOWEST_DRIVE: f64 = 0.1;

fn response(p: &Parameters<f64>) -> Response {
    Response { frequency: p.drive.natural_frequency, damping: p.drive.damping_ratio }
}

fn tell(rates: &AxisRates, d: &mut Discrete<f64>) {
    d.slew.rate = rates[Axis::Slew as usize];
    d.luff.rate = rates[Axis::Luff as usize];
    d.hoist.rate = rates[Axis::Hoist as usize];
    d.trolley.rate = rates[Axis::Trolley as usize];
    d.extension.rate = rates[Axis::Extension as usize];
    d.luff.line_speed = rates[Axis::LuffLine as usize];
    d.hoist.line_speed = rates[Axis::HoistLine as usize];
}

/// What is connected together: a crane's axes, and the ropes' instead of them.
const TERMINALS: &[Terminal] = &[
    Terminal {
        name: "velocity_x",
        description: "Commanded velocity along x",
        kind: "command",
        members: &[("velocity.x", "command")],
    },
    Terminal {
        name: "velocity_y",
        description: "Commanded velocity along y",
        kind: "command",
        members: &[("velocity.y", "command")],
    },
    Terminal {
        name: "velocity_z",
        description: "Commanded velocity upwards",
        kind: "command",
        members: &[("velocity.z", "command")],
    },
    terminals::SLEW,
    terminals::LUFF,
    terminals::HOIST,
    Terminal {
        name: "trolley",
        description: "Trolley axis",
        kind: "axis",
        members: &[("trolley.rate", "rate"), ("trolley.radius", "position")],
    },
    Terminal {
        name: "extension",
        description: "Extension of the boom",
        kind: "axis",
        members: &[("extension.rate", "rate"), ("extension.length", "position")],
    },
    Terminal { name: "luff_line", description: "Luff line", kind: "axis", members: &[("luff.line_speed", "rate")] },
    Terminal { name: "hoist_line", description: "Hoist line", kind: "axis", members: &[("hoist.line_speed", "rate")] },
    Terminal {
        name: "base",
        description: "Motion of the base on the ground",
        kind: "base",
        members: &[
            ("base.velocity.x", "velocity.x"),
            ("base.velocity.y", "velocity.y"),
            ("base.yaw_rate", "yaw_rate"),
            ("base.yaw", "yaw"),
        ],
    },
];

impl Model for CartesianController {
    const INFO: Info = Info {
        name: "CartesianController",
        description: "Controller that moves the load of a crane in Cartesian directions",
        documentation: include_str!("../README.md"),
        icon: include_str!("../icon.svg"),
        terminals: TERMINALS,
        stop_time: 20.0,
        step_size: 0.01,
    };
    const CLOCKS: &'static [Clock] = &[Clock::new("sample", "Computes the rates", Interval::OfFixedParameters)];
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    type Memory = Memory;
    type Indicators = [f64; 0];

    fn check(p: &Parameters<f64>, (): &()) -> Vec<Problem> {
        let timing = Timing { sample_time: p.sample_time, latency: 0.0 }.check();
        let mut problems: Vec<_> =
            timing.err().map(|error| Problem::new(error.quantity(), error.to_string())).into_iter().collect();
        let frequency = p.drive.natural_frequency;
        if frequency > 0.0 && frequency < SLOWEST_DRIVE {
            let message =
                format!("is {frequency}; it must be 0, for drives that follow at once, or at least {SLOWEST_DRIVE}");
            problems.push(Problem::new("drive.natural_frequency", message));
        }
        let ends = [
            ("luff.angle", p.luff.angle_min, p.luff.angle_max),
            ("hoist.length", p.hoist.length_min, p.hoist.length_max),
            ("trolley.radius", p.trolley.radius_min, p.trolley.radius_max),
            ("extension.length", p.extension.length_min, p.extension.length_max),
        ];
        problems.extend(ends.into_iter().filter(|(_, min, max)| min > max).map(|(name, min, max)| {
            Problem::new(format!("{name}_max"), format!("is {max}; it must be at least {name}_min of {min}"))
        }));
        problems
    }

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn interval(_: usize, p: &Parameters<f64>) -> f64 {
        p.sample_time
    }

    /// The rates for the joints as they will be when what is told now has its effect.
    fn tick(_: usize, at: &mut Event<'_, Self>) {
        let (p, u, d, memory) = (at.p, at.u, &mut *at.d, &mut *at.memory);
        let (response, yaw_rate) = (response(p), cut(u.base.yaw_rate));
        memory.advance(at.t, response);
        let ramp = Ramp::new(memory.before, &acceleration_limits(p), memory.passed);
        // Whoever samples when it suits is taken to go on as before.
        let interval = if p.sample_time > 0.0 { p.sample_time } else { memory.passed };
        let measured = Joints::measured(p, u);
        let way = |axis: Axis| response.way_to_go(memory.drives[axis as usize]);
        let mut joints = measured.moved(way, yaw_rate * response.delay());
        if p.look_ahead > 0.0 {
            let now = moved(p, u, joints, interval, ramp.as_ref()).rates;
            joints = joints.moved(|axis| now[axis as usize] * p.look_ahead, yaw_rate * p.look_ahead);
        }
        let Moved { rates, velocity, shares, is_whole } = moved(p, u, joints, interval, ramp.as_ref());
        memory.now = Told { velocity, rates };
        tell(&rates, d);
        [d.base.cancelled_fraction, d.speed_fraction] = shares;
        d.saturated = !is_whole || !is_physical(p, u);
        d.singular = measured.are_singular(p);
    }
}

export_fmu!(CartesianController);
