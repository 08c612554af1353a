//! The limits of an axis.

use crate::Braking;

/// The limits of an axis, in its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The least position.
    pub position_min: f64,
    /// The greatest position.
    pub position_max: f64,
    /// The greatest speed.
    pub velocity: f64,
    /// How strongly it slows down.
    pub deceleration: f64,
}

/// Where an axis has to go slowly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowZone {
    /// How far from either end of the range it reaches.
    pub length: f64,
    /// The greatest speed there.
    pub speed: f64,
}

/// The velocities that an axis may have, around 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The most negative one.
    pub down: f64,
    /// The most positive one.
    pub up: f64,
}

impl Range {
    /// Any velocity.
    pub const FREE: Self = Self { down: f64::NEG_INFINITY, up: f64::INFINITY };

    /// No slower and no faster than is allowed.
    pub fn cut(&self, velocity: f64) -> f64 {
        // Without the sign of a zero.
        velocity.clamp(self.down, self.up) + 0.0
    }

    /// What both allow.
    pub fn and(&self, other: Self) -> Self {
        Self { down: self.down.max(other.down), up: self.up.min(other.up) }
    }

    /// No faster than it is, either way; but a speed that is always allowed.
    pub fn no_faster(velocity: f64, always: f64) -> Self {
        Self { down: velocity.min(-always), up: velocity.max(always) }
    }
}

impl Limits {
    /// The velocities that an axis may have at a position. Away from an end it may go as fast as it can.
    pub fn range(&self, braking: Braking, zone: SlowZone, position: f64) -> Range {
        let towards = |room: f64| {
            let speed = self.velocity.min(braking.fastest(room, 0.0));
            // Without a zone there is no speed to be slowed down to.
            if zone.length > 0.0 { speed.min(braking.fastest(room - zone.length, zone.speed)) } else { speed }
        };
        Range { down: -towards(position - self.position_min), up: towards(self.position_max - position) }
    }
}
