//! A model without states that has a clock of every kind, and writes down when each has ticked.

use swayless_export::{Clock, Event, Info, Interval, Model, Point, Scalar, Variables};

/// The model.
pub struct Sampler;

const SAMPLE: usize = 0;
const BEAT: usize = 1;
const ALARM: usize = 2;
const PULSE: usize = 3;
const CROSSING: usize = 5;

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Interval of the samples.
    #[variable(unit = "s", start = 0.25, min = 0.0, tunable)]
    pub every: R,
    /// Time from a sample above 1 to the alarm.
    #[variable(unit = "s", start = 0.125, min = 0.0, tunable)]
    pub delay: R,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// What is sampled.
    #[variable(discrete)]
    pub signal: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    /// The last sample.
    #[variable(output, clock = "sample", depends_on = ["signal"])]
    pub held: R,
    /// How many samples have been taken.
    #[variable(output, clock = "sample", depends_on = [])]
    pub samples: i32,
    /// When the last was.
    #[variable(output, unit = "s", clock = "sample", depends_on = [])]
    pub sampled: R,
    /// How often it has beaten.
    #[variable(output, clock = "beat", depends_on = [])]
    pub beats: i32,
    /// How often the alarm has rung.
    #[variable(output, clock = "alarm", depends_on = [])]
    pub alarms: i32,
    /// How many pulses there have been.
    #[variable(output, clock = "pulse", depends_on = [])]
    pub pulses: i32,
    /// The interval of the samples, as the first event sees it.
    #[variable(output, unit = "s", depends_on = [])]
    pub first_interval: R,
}

impl Model for Sampler {
    const INFO: Info = Info::new("Sampler", "A clock of every kind");
    const CLOCKS: &'static [Clock] = &[
        Clock { priority: 1, ..Clock::new("sample", "Takes a sample", Interval::OfTunableParameters) },
        Clock { shift: 0.05, ..Clock::new("beat", "Beats", Interval::Constant(0.1)) },
        Clock { priority: 2, ..Clock::new("alarm", "Rings", Interval::Countdown) },
        Clock::new("pulse", "Pulses, each 0.1 s later than the one before", Interval::Changing),
        Clock::new("trim", "Nothing", Interval::Tunable(0.5)),
        Clock { by: &["sample"], ..Clock::new("crossing", "A sample is above 1", Interval::Triggered) },
    ];
    type Parameters<R: Scalar> = Parameters<R>;
    type Inputs<R: Scalar> = Inputs<R>;
    type States<R: Scalar> = ();
    type Outputs<R: Scalar> = ();
    type Discrete<R: Scalar> = Discrete<R>;
    /// When the alarm and the pulse tick.
    type Memory = (Option<f64>, f64);
    type Indicators = [f64; 0];

    fn derivatives<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn outputs<R: Scalar>(_: &Point<'_, Self, R>) {}

    fn interval(_: usize, p: &Parameters<f64>) -> f64 {
        p.every
    }

    fn next_tick(clock: usize, at: &Point<'_, Self, f64>) -> Option<f64> {
        if clock == ALARM { at.memory.0 } else { Some(at.memory.1) }
    }

    fn tick(clock: usize, at: &mut Event<'_, Self>) {
        match clock {
            SAMPLE => {
                (at.d.held, at.d.sampled) = (at.u.signal, at.t);
                at.d.samples += 1;
                if at.u.signal > 1.0 {
                    at.memory.0 = Some(at.t + at.p.delay);
                    at.fire(CROSSING);
                }
            }
            BEAT => at.d.beats += 1,
            ALARM => {
                at.d.alarms += 1;
                at.memory.0 = None;
            }
            PULSE => {
                at.d.pulses += 1;
                at.memory.1 = at.t + 0.1 * f64::from(at.d.pulses + 1);
            }
            _ => {}
        }
    }

    fn event(at: &mut Event<'_, Self>) -> Option<f64> {
        if at.initial {
            at.memory.1 = at.t + 0.1;
            at.d.first_interval = at.intervals[SAMPLE];
        }
        None
    }
}
