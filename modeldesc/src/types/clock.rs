//! Clocks (FMI 3.0).

use super::name_of;

/// What a `Clock` or a `ClockType` says about its ticks. Times are in the unit of the independent variable; on a
/// variable, what is absent holds from its declared type.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// `intervalVariability`.
    pub interval_variability: IntervalVariability,
    /// `canBeDeactivated`.
    pub can_be_deactivated: bool,
    /// `priority` in scheduled execution; the smaller, the more urgent.
    pub priority: Option<u32>,
    /// `intervalDecimal`: the time between ticks.
    pub interval_decimal: Option<f64>,
    /// `shiftDecimal`: the time from the start to the first tick; 0 when absent.
    pub shift_decimal: Option<f64>,
    /// `supportsFraction`: whether times can also be had as fractions.
    pub supports_fraction: bool,
    /// `resolution`: what the counters are divided by.
    pub resolution: Option<u64>,
    /// `intervalCounter`: the time between ticks, times the resolution.
    pub interval_counter: Option<u64>,
    /// `shiftCounter`: the time from the start to the first tick, times the resolution; 0 when absent.
    pub shift_counter: Option<u64>,
}

impl Clock {
    /// A clock with nothing said about it but what every clock must say.
    pub fn new(interval_variability: IntervalVariability) -> Self {
        Self {
            interval_variability,
            can_be_deactivated: false,
            priority: None,
            interval_decimal: None,
            shift_decimal: None,
            supports_fraction: false,
            resolution: None,
            interval_counter: None,
            shift_counter: None,
        }
    }
}

/// `intervalVariability`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum IntervalVariability {
    Constant,
    Fixed,
    Tunable,
    Changing,
    Countdown,
    Triggered,
}

impl IntervalVariability {
    /// Every one with its name in the XML.
    pub(crate) const NAMES: [(&'static str, Self); 6] = [
        ("constant", Self::Constant),
        ("fixed", Self::Fixed),
        ("tunable", Self::Tunable),
        ("changing", Self::Changing),
        ("countdown", Self::Countdown),
        ("triggered", Self::Triggered),
    ];

    /// The name in the XML.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }

    /// Whether the clock ticks at equal distances, as long as nobody tunes them.
    pub fn is_periodic(self) -> bool {
        matches!(self, Self::Constant | Self::Fixed | Self::Tunable)
    }
}
