//! What moves the load as it is commanded: the crane as the controller sees it, and the rates of its axes.

use swayless_crane::{are_physical, cut};
use swayless_mechanics::{
    AXES, Axis, AxisRates, Machine as Crane, Margin, Pace, RateRanges, Restraint, Rigging, Scaling as Together, Vector,
};

use crate::ramp::Ramp;
use crate::variables::{FARTHEST, Frame, Inputs, MOST_TURNED, Machine, Parameters, Scaling};

/// No boom is shorter (m).
const SHORTEST: f64 = 1e-3;
/// No axis slows down less (rad/s², m/s²).
const WEAKEST: f64 = 1e-6;
/// No component of a velocity is a smaller share of it, but 0: what rounding leaves where x and y are turned into the
/// crane's directions is no motion towards a singular position.
const NOTHING: f64 = 1e-12;

/// The positions of the joints, and the yaw of what the crane stands on.
#[derive(Clone, Copy)]
pub struct Joints {
    slew: f64,
    luff: f64,
    /// The suspension length.
    hoist: f64,
    radius: f64,
    /// The boom's length with its extension.
    length: f64,
    yaw: f64,
}

fn cut_angle(angle: f64) -> f64 {
    angle.clamp(-MOST_TURNED, MOST_TURNED)
}

impl Joints {
    /// As they are measured.
    pub fn measured(p: &Parameters<f64>, u: &Inputs<f64>) -> Self {
        Self {
            slew: cut_angle(u.slew.angle),
            luff: cut_angle(u.luff.angle),
            hoist: u.hoist.length.clamp(0.0, FARTHEST),
            radius: u.trolley.radius.clamp(0.0, FARTHEST),
            length: (p.boom.length + u.extension.length).clamp(SHORTEST, FARTHEST),
            yaw: cut_angle(u.base.yaw),
        }
    }

    /// After each axis has gone a way, and the base has turned by an angle.
    #[must_use]
    pub fn moved(self, way: impl Fn(Axis) -> f64, yaw: f64) -> Self {
        Self {
            slew: self.slew + way(Axis::Slew),
            luff: self.luff + way(Axis::Luff),
            hoist: self.hoist + way(Axis::Hoist),
            radius: (self.radius + way(Axis::Trolley)).clamp(0.0, FARTHEST),
            length: (self.length + way(Axis::Extension)).clamp(SHORTEST, FARTHEST),
            yaw: self.yaw + yaw,
        }
    }

    /// The crane with its joints there.
    fn crane(&self, p: &Parameters<f64>) -> Crane {
        let Self { luff, length, radius, .. } = *self;
        match p.machine {
            Machine::Boom => Crane::Boom { length, luff, ropes: self.rigging(p).at(luff) },
            Machine::Tower => Crane::Tower { radius },
            Machine::BoomLift => Crane::BoomLift { length, luff },
        }
    }

    fn rigging(&self, p: &Parameters<f64>) -> Rigging<f64> {
        let (jib, sheave) = (p.jib.length, p.hoist_sheave.distance);
        Rigging { boom: self.length, jib, sheave, jib_angle: p.jib.angle }
    }

    /// Whether the crane is close to a singular position.
    pub fn are_singular(&self, p: &Parameters<f64>) -> bool {
        let in_line = || self.rigging(p).from_dead_angles(self.luff).iter().any(|way| *way <= 0.0);
        self.crane(p).clearance(margin(p)) < 1.0 || (p.machine == Machine::Boom && in_line())
    }
}

fn margin(p: &Parameters<f64>) -> Margin {
    Margin { luff: p.singularity_margin, radius: p.trolley.singularity_margin }
}

/// Something of each axis.
fn of_axes(values: [(Axis, f64); AXES]) -> AxisRates {
    let mut all = AxisRates::zeros();
    values.into_iter().for_each(|(axis, value)| all[axis as usize] = value);
    all
}

/// How fast each axis may be, with an `interval` (s) until it is told anew, on the way with such speeds: no faster than it
/// can, and than it can stop before its ends. All rates get slower together there, so that the one that takes longest says how
/// soon.
fn limits(p: &Parameters<f64>, joints: &Joints, speeds: &AxisRates, interval: f64) -> RateRanges {
    let accelerations = acceleration_limits(p);
    let soonest = accelerations.component_div(speeds).min();
    let deceleration = |axis: usize| {
        if speeds[axis] == 0.0 { accelerations[axis] } else { (soonest * speeds[axis]).max(WEAKEST) }
    };
    let mut ranges = RateRanges::either_way(&of_axes([
        (Axis::Slew, p.slew.rate_limit),
        (Axis::Luff, p.luff.rate_limit),
        (Axis::Hoist, p.hoist.rate_limit),
        (Axis::Trolley, p.trolley.rate_limit),
        (Axis::Extension, p.extension.rate_limit),
        (Axis::LuffLine, p.luff.line_speed_limit),
        (Axis::HoistLine, p.hoist.line_speed_limit),
    ]));
    let extension = joints.length - p.boom.length;
    let ends = [
        (Axis::Luff, joints.luff, [p.luff.angle_min, p.luff.angle_max]),
        (Axis::Hoist, joints.hoist, [p.hoist.length_min, p.hoist.length_max]),
        (Axis::Trolley, joints.radius, [p.trolley.radius_min, p.trolley.radius_max]),
        (Axis::Extension, extension, [p.extension.length_min, p.extension.length_max]),
    ];
    for (axis, at, [min, max]) in ends {
        let range = &mut ranges.0[axis as usize];
        *range = range.before_ends([at - min, max - at], deceleration(axis as usize), interval);
    }
    ranges
}

/// How fast each axis may get faster.
pub fn acceleration_limits(p: &Parameters<f64>) -> AxisRates {
    of_axes([
        (Axis::Slew, p.slew.acceleration_limit),
        (Axis::Luff, p.luff.acceleration_limit),
        (Axis::Hoist, p.hoist.acceleration_limit),
        (Axis::Trolley, p.trolley.acceleration_limit),
        (Axis::Extension, p.extension.acceleration_limit),
        (Axis::LuffLine, p.luff.line_acceleration_limit),
        (Axis::HoistLine, p.hoist.line_acceleration_limit),
    ])
}

/// A horizontal velocity in directions that are turned by an angle (rad) against its own.
fn seen_from(angle: f64, [x, y]: [f64; 2], up: f64) -> Vector<f64> {
    let (sin, cos) = angle.sin_cos();
    let nothing = NOTHING * x.hypot(y);
    let [radial, tangential] = [x * cos + y * sin, y * cos - x * sin].map(|v| if v.abs() <= nothing { 0.0 } else { v });
    Vector::new(radial, tangential, up)
}

/// How the load is moved.
pub struct Moved {
    /// The rates of the axes.
    pub rates: AxisRates,
    /// The velocity that the load is given of the command, in the world (m/s).
    pub velocity: Vector<f64>,
    /// The share of the base's motion that is made up for, and that of the command that the axes have the speed for.
    pub shares: [f64; 2],
    /// Whether nothing is lost.
    pub is_whole: bool,
}

/// The rates that give the load its velocity with the joints there, or come closer to it as fast as axes can follow.
///
/// The slewing axis moves with v_base + a ψ̇ b₂. Relative to it, and in directions that are turned by ψ + θ, a load at the
/// distance R moves with Ṙ along and R (ψ̇ + θ̇) across. So the base's motion is made up for by T(−v_base − a ψ̇ b₂) and
/// θ̇ = −ψ̇, and goes before: of the command there is what fits beside it. The rates hold for an `interval` (s).
pub fn moved(p: &Parameters<f64>, u: &Inputs<f64>, joints: Joints, interval: f64, ramp: Option<&Ramp>) -> Moved {
    let crane = joints.crane(p);
    let direction = joints.yaw + joints.slew;
    let from = match p.frame {
        Frame::World => direction,
        Frame::Crane => 0.0,
        Frame::Ground => direction - cut_angle(u.operator.heading),
    };
    let [x, y, up] = [u.velocity.x, u.velocity.y, u.velocity.z].map(cut);
    let [base_x, base_y, yaw_rate] = [u.base.velocity.x, u.base.velocity.y, u.base.yaw_rate].map(cut);
    let (sin, cos) = joints.yaw.sin_cos();
    let carried = p.boom.offset * yaw_rate;
    let axis = [base_x - carried * sin, base_y + carried * cos];
    let mut base = crane.rates(-seen_from(direction, axis, 0.0));
    base[Axis::Slew as usize] -= yaw_rate;

    let wanted = seen_from(from, [x, y], up);
    let limits = limits(p, &joints, &(base.abs() + crane.rates(wanted).abs()), interval);
    let restraint = Restraint { limits, margin: margin(p), scaling: together(p.scaling) };
    let saturate = |velocity: Vector<f64>| {
        let pace = Pace {
            horizontal: axis[0].hypot(axis[1]) + velocity.x.hypot(velocity.y),
            vertical: velocity.z,
            yaw: yaw_rate,
        };
        crane.saturate([base, crane.rates(velocity)], pace, &restraint)
    };
    // What is left of a velocity: the hoist by itself keeps it.
    let left = |velocity: Vector<f64>, share: f64| match p.scaling {
        Scaling::Uniform => velocity * share,
        Scaling::Thesis => velocity,
    };
    let full = saturate(wanted);
    let (mut velocity, mut given, mut share) = (left(wanted, full.second), full, 1.0);
    if let Some(Ramp { before, changes }) = ramp {
        let there = seen_from(direction, [before.velocity.x, before.velocity.y], before.velocity.z);
        let rates = |velocity| base * full.first + crane.rates(velocity);
        let (here, goal) = (rates(there), rates(velocity));
        share = changes.share(&(here - before.rates), &(goal - here));
        if share < 1.0 {
            velocity = there + (velocity - there) * share;
            given = saturate(velocity);
            velocity = left(velocity, given.second);
        }
    }
    let [x, y] = [velocity.x, velocity.y];
    Moved {
        rates: given.rates,
        velocity: seen_from(-direction, [x, y], velocity.z),
        shares: [full.first, full.second],
        is_whole: full.is_whole() && share == 1.0,
    }
}

fn together(scaling: Scaling) -> Together {
    match scaling {
        Scaling::Uniform => Together::Uniform,
        Scaling::Thesis => Together::WithoutHoist,
    }
}

/// Whether no input is cut.
pub fn is_physical(p: &Parameters<f64>, u: &Inputs<f64>) -> bool {
    let rates = [u.velocity.x, u.velocity.y, u.velocity.z, u.base.velocity.x, u.base.velocity.y, u.base.yaw_rate];
    let angles = [u.slew.angle, u.luff.angle, u.base.yaw, u.operator.heading];
    let length = p.boom.length + u.extension.length;
    let is_way = |way: f64| (0.0..=FARTHEST).contains(&way);
    let reach = match p.machine {
        Machine::Tower => is_way(u.trolley.radius) && is_way(u.hoist.length),
        Machine::Boom => (SHORTEST..=FARTHEST).contains(&length) && is_way(u.hoist.length),
        Machine::BoomLift => (SHORTEST..=FARTHEST).contains(&length),
    };
    reach && are_physical(&rates) && angles.iter().all(|angle| angle.abs() <= MOST_TURNED)
}
