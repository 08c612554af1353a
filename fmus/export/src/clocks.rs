//! Clocks: the instants at which a part of a model is computed (FMI 3.0.2, 2.2.8).
//!
//! A sampled model declares its clocks once. In the standard FMU the runtime ticks them itself, as time events; in the
//! FMU with clocks (`<Name>Clocked`) the importer does.

/// A clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// Its name.
    pub name: &'static str,
    /// Its documentation.
    pub description: &'static str,
    /// When it ticks.
    pub interval: Interval,
    /// How long after the start a periodic clock ticks first (s).
    pub shift: f64,
    /// The clocks at whose ticks an output clock can tick.
    pub by: &'static [&'static str],
    /// Which of several that tick at once is computed first: the one with the smallest number.
    pub priority: u32,
}

impl Clock {
    /// A clock that ticks when the simulation starts, if it is periodic, and before all others.
    pub const fn new(name: &'static str, description: &'static str, interval: Interval) -> Self {
        Self { name, description, interval, shift: 0.0, by: &[], priority: 0 }
    }
}

/// When a clock ticks, by its `intervalVariability`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Interval {
    /// `constant`: every so many seconds.
    Constant(f64),
    /// `fixed`: every so many seconds, unless the importer sets another interval before the start.
    Fixed(f64),
    /// `tunable`: every so many seconds, until the importer sets another interval.
    Tunable(f64),
    /// `fixed`: [`Model::interval`](crate::Model::interval) calculates it from fixed parameters.
    OfFixedParameters,
    /// `tunable`: [`Model::interval`](crate::Model::interval) calculates it from tunable parameters.
    OfTunableParameters,
    /// `changing`: at each tick [`Model::next_tick`](crate::Model::next_tick) says when the next one is.
    Changing,
    /// `countdown`: after every event [`Model::next_tick`](crate::Model::next_tick) says when it ticks, if at all.
    Countdown,
    /// `triggered`: an output, which the model ticks with [`Event::fire`](crate::Event::fire).
    Triggered,
}

impl Interval {
    /// Whether ticks follow each other at an interval that holds until something changes it.
    pub fn is_periodic(self) -> bool {
        !matches!(self, Self::Changing | Self::Countdown | Self::Triggered)
    }

    /// Whether the interval comes from the model's parameters.
    pub fn is_of_parameters(self) -> bool {
        matches!(self, Self::OfFixedParameters | Self::OfTunableParameters)
    }

    /// The interval that is declared, if one is (s).
    pub fn declared(self) -> Option<f64> {
        match self {
            Self::Constant(interval) | Self::Fixed(interval) | Self::Tunable(interval) => Some(interval),
            _ => None,
        }
    }

    /// Whether the importer may set it: before the start only, or at events as well.
    pub fn is_set_by_importer(self, running: bool) -> bool {
        matches!(self, Self::Tunable(_)) || !running && matches!(self, Self::Fixed(_))
    }

    /// Whether the model ticks the clock, not the importer.
    pub fn is_output(self) -> bool {
        self == Self::Triggered
    }
}
