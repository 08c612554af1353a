//! `CartesianController`: moves the load of a crane in Cartesian directions (thesis chapter 3).

use serde::{Deserialize, Serialize};
use swayless_crane::{cut, terminals};
use swayless_export::{Clock, Event, Info, Interval, Model, Point, Problem, Scalar, Terminal, export_fmu};
use swayless_mechanics::{AXES, Axis, AxisRates};
use swayless_sensing::Timing;

mod motion;
mod response;
mod variables;

use motion::{Joints, is_physical, rates};
use response::{Driven, Response};
use variables::{Discrete, Inputs, Parameters};

/// The model.
struct CartesianController;

/// What is remembered from sample to sample.
#[derive(Clone, Default, Serialize, Deserialize)]
#[serde(try_from = "Parts")]
struct Memory {
    /// When the last sample was taken (s).
    last: Option<f64>,
    drives: [Driven; AXES],
}

/// What a memory is serialized as.
#[derive(Deserialize)]
struct Parts {
    last: Option<f64>,
    drives: [Driven; AXES],
}

impl TryFrom<Parts> for Memory {
    type Error = &'static str;

    fn try_from(Parts { last, drives }: Parts) -> Result<Self, Self::Error> {
        let is_time = last.is_none_or(f64::is_finite);
        is_time.then_some(Self { last, drives }).ok_or("the time of the last sample is none")
    }
}

/// No drives are slower (rad/s), unless they follow at once.
const SLOWEST_DRIVE: f64 = 0.1;

fn response(p: &Parameters<f64>) -> Response {
    Response { frequency: p.drive.natural_frequency, damping: p.drive.damping_ratio }
}

fn told(d: &Discrete<f64>) -> AxisRates {
    let mut rates = AxisRates::zeros();
    rates[Axis::Slew as usize] = d.slew.rate;
    rates[Axis::Luff as usize] = d.luff.rate;
    rates[Axis::Hoist as usize] = d.hoist.rate;
    rates[Axis::Trolley as usize] = d.trolley.rate;
    rates[Axis::Extension as usize] = d.extension.rate;
    rates[Axis::LuffLine as usize] = d.luff.line_speed;
    rates[Axis::HoistLine as usize] = d.hoist.line_speed;
    rates
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

/// Lets the drives go on until now with what they have been told. A second sample at the same instant changes nothing.
fn drive(memory: &mut Memory, response: Response, t: f64, told: &AxisRates) {
    let passed = memory.last.map_or(0.0, |last| t - last);
    if passed > 0.0 {
        memory.drives.iter_mut().zip(told).for_each(|(drive, told)| *drive = response.driven(*drive, *told, passed));
    }
    memory.last = Some(t);
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
    Terminal { members: &[("hoist.rate", "rate")], ..terminals::HOIST },
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
        drive(memory, response, at.t, &told(d));
        let measured = Joints::measured(p, u);
        let way = |axis: Axis| response.way_to_go(memory.drives[axis as usize]);
        let mut joints = measured.moved(way, yaw_rate * response.delay());
        if p.look_ahead > 0.0 {
            let now = rates(p, u, joints).rates;
            joints = joints.moved(|axis| now[axis as usize] * p.look_ahead, yaw_rate * p.look_ahead);
        }
        let motion = rates(p, u, joints);
        tell(&motion.rates, d);
        d.speed_fraction = motion.second;
        d.base.cancelled_fraction = motion.first;
        d.saturated = !motion.is_whole() || !is_physical(p, u);
        d.singular = measured.are_singular(p);
    }
}

export_fmu!(CartesianController);
