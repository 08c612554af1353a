//! Clocks: when they tick, in the FMU that ticks them itself and in the hands of an importer, against the times written
//! down in the model.

use swayless_export::abi::fmi3::{ERROR, OK};
use swayless_export::fmi3;

use crate::host::{CO_SIMULATION, Host, Interface, Wish};
use crate::sampler::Sampler;

/// `fmi3IntervalQualifier`.
pub const INTERVAL_NOT_YET_KNOWN: i32 = 0;
pub const INTERVAL_UNCHANGED: i32 = 1;
pub const INTERVAL_CHANGED: i32 = 2;

const MODEL_EXCHANGE: Wish = Wish { interface: Interface::ModelExchange, ..CO_SIMULATION };
const CLOCKED: Wish = Wish { event_mode: true, early_return: true, clocked: true, ..CO_SIMULATION };

impl Host<Sampler> {
    /// Status, interval and qualifier.
    pub fn interval(&self, clock: &str) -> (i32, f64, i32) {
        let (mut interval, mut qualifier) = (f64::NAN, -1);
        let clock = self.reference(clock);
        // SAFETY: one reference and one place for each answer.
        let status =
            unsafe { fmi3::fmi3GetIntervalDecimal::<Sampler>(self.instance, &clock, 1, &mut interval, &mut qualifier) };
        (status, interval, qualifier)
    }

    fn set_interval(&self, clock: &str, interval: f64) -> i32 {
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3SetIntervalDecimal::<Sampler>(self.instance, &self.reference(clock), 1, &interval) }
    }

    fn tick(&self, clock: &str) -> i32 {
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3SetClock::<Sampler>(self.instance, &self.reference(clock), 1, &1) }
    }

    pub fn ticks(&self, clock: &str) -> bool {
        let mut active = 9;
        // SAFETY: one reference and one place.
        let status = unsafe { fmi3::fmi3GetClock::<Sampler>(self.instance, &self.reference(clock), 1, &mut active) };
        assert_eq!(status, OK, "{:?}", self.log);
        active == 1
    }

    fn enter_event(&self) -> i32 {
        // SAFETY: an instance.
        unsafe { fmi3::fmi3EnterEventMode::<Sampler>(self.instance) }
    }

    fn set_time(&self, t: f64) {
        // SAFETY: an instance.
        unsafe {
            assert_eq!(fmi3::fmi3EnterContinuousTimeMode::<Sampler>(self.instance), OK);
            assert_eq!(fmi3::fmi3SetTime::<Sampler>(self.instance, t), OK);
        }
        assert_eq!(self.enter_event(), OK);
    }

    fn begin_at(&self, t: f64) {
        // SAFETY: an instance.
        let status = unsafe { fmi3::fmi3EnterInitializationMode::<Sampler>(self.instance, 0, 0.0, t, 0, 0.0) };
        assert_eq!(status, OK, "{:?}", self.log);
    }
}

#[test]
fn ticks_are_counted_from_the_start_and_never_summed_up() {
    for start in [0.0, -3.0, 1e4] {
        let host = Host::<Sampler>::new(CO_SIMULATION);
        host.begin_at(start);
        assert_eq!(host.exit_initialization(), OK);
        assert_eq!((host.integer("samples"), host.integer("beats")), (1, 0), "the shift of the beat is 0.05 s");
        let mut t = start;
        for n in 1..=1000 {
            let next = start + f64::from(n) * 0.0137;
            assert_eq!(host.step_to_event(t, next - t).0, OK, "{:?}", host.log);
            t = host.get("time");
            assert!((t - next).abs() < 1e-11);
            let run = next - start;
            assert_eq!(host.integer("samples"), 1 + (run / 0.25) as i32, "{run}");
            assert_eq!(host.integer("beats"), ((run + 0.05) / 0.1 + 1e-9) as i32, "{run}");
            // The n-th pulse is 0.1 s · n after the one before.
            let pulses = (0..).take_while(|n| 0.05 * f64::from((n + 1) * (n + 2)) <= run).count();
            assert_eq!(host.integer("pulses"), i32::try_from(pulses).unwrap(), "{run}");
        }
        assert_eq!(host.get("sampled"), start + 54.0 * 0.25);
    }
}

#[test]
fn ticks_fall_on_the_ends_of_steps_that_are_added_up() {
    // After some hundred steps the sum lies before n · 0.1 by more than a few last bits.
    let host = Host::<Sampler>::new(CO_SIMULATION);
    assert_eq!(host.set("every", 0.1), OK);
    host.initialize();
    let mut t = 0.0;
    for n in 1..=20_000 {
        assert_eq!(host.step(t, 0.1), OK);
        t += 0.1;
        assert_eq!(host.integer("samples"), n + 1, "{t}");
    }
    assert!(2000.0 - t > 1e-10, "{t}");
}

/// Without trying: ten million ticks are seconds of computing, a hundred thousand are told at once.
#[test]
fn ticks_without_end_are_refused_and_many_are_not() {
    for (every, answer) in [(1e-5, OK), (1e-9, ERROR), (5e-324, ERROR)] {
        let host = Host::<Sampler>::new(CO_SIMULATION);
        assert_eq!(host.set("every", every), OK);
        host.initialize();
        assert_eq!(host.step(0.0, 2.0), answer, "{every}");
        let told = host.log.iter().any(|(_, _, text)| text.contains("more than 100000 events in one step"));
        assert_eq!(told, answer == ERROR, "{every}");
        assert_eq!(host.get("sampled"), if answer == OK { 2.0 } else { 0.0 });
    }
}

#[test]
fn a_new_interval_counts_from_where_it_was_set() {
    let host = Host::<Sampler>::new(CO_SIMULATION);
    host.initialize();
    assert_eq!(host.step(0.0, 0.375), OK);
    assert_eq!(host.set("every", 0.5), OK);
    assert_eq!(host.step(0.375, 0.375), OK);
    assert_eq!(host.get("sampled"), 0.25);
    assert_eq!(host.step(0.75, 0.25), OK);
    assert_eq!((host.get("sampled"), host.integer("samples")), (0.875, 3));
}

#[test]
fn the_first_event_knows_the_intervals_whatever_has_been_looked_at() {
    let host = Host::<Sampler>::new(CO_SIMULATION);
    host.initialize();
    assert_eq!(host.get("first_interval"), 0.25);
    for look in [false, true] {
        assert_eq!(host.reset(), OK);
        assert_eq!(host.enter_initialization(), OK);
        if look {
            assert_eq!(host.get("first_interval"), 0.25);
        }
        assert_eq!(host.set("every", 0.75), OK);
        assert_eq!(host.exit_initialization(), OK);
        assert_eq!(host.get("first_interval"), 0.75);
    }
}

#[test]
fn a_countdown_of_nothing_ticks_at_once() {
    // At the start, at the end of a step, and in Event Mode of model exchange.
    let host = Host::<Sampler>::new(CO_SIMULATION);
    assert_eq!((host.set("delay", 0.0), host.set("signal", 2.0)), (OK, OK));
    host.initialize();
    assert_eq!(host.integer("alarms"), 1);
    assert_eq!(host.step(0.0, 0.25), OK);
    assert_eq!((host.integer("samples"), host.integer("alarms")), (2, 2));
    let host = Host::<Sampler>::new(MODEL_EXCHANGE);
    assert_eq!((host.set("delay", 0.0), host.set("signal", 2.0)), (OK, OK));
    host.initialize();
    let next = host.update();
    assert_eq!((host.integer("alarms"), next), (1, Some(0.05)));
    host.set_time(0.25);
    let next = host.update();
    assert_eq!((host.integer("alarms"), next.is_some_and(|next| next > 0.25)), (2, true));
}

#[test]
fn ticks_that_were_jumped_over_are_not_made_up_for() {
    let host = Host::<Sampler>::new(MODEL_EXCHANGE);
    assert_eq!(host.set("every", 0.1), OK);
    host.initialize();
    host.update();
    // 0.3/0.1 is less than 3 in floating point: the tick at this very time must not follow once more.
    host.set_time(0.3);
    let next = host.update().unwrap();
    assert_eq!(host.integer("samples"), 2);
    assert!(next > 0.3 + 1e-3, "{next}");
}

#[test]
fn a_long_step_has_as_many_ticks_as_fit() {
    let host = Host::<Sampler>::new(CO_SIMULATION);
    assert_eq!(host.set("every", 1e-3), OK);
    host.initialize();
    assert_eq!(host.step(0.0, 101.0), OK, "{:?}", host.log.last());
    assert_eq!(host.integer("samples"), 101_001);
}

#[test]
fn an_interval_too_short_to_count_ends_the_step_and_not_the_host() {
    let host = Host::<Sampler>::new(CO_SIMULATION);
    host.initialize();
    assert_eq!(host.step(0.0, 1.0), OK);
    assert_eq!(host.set("every", 1e-17), OK);
    assert_eq!(host.step(1.0, 1.0), ERROR);
    assert!(host.last_message().contains("events"), "{}", host.last_message());
}

#[test]
fn qualifiers_tell_what_is_new() {
    // FMI 3.0.2, 2.2.8.4; from a start time that is not 0.
    let host = Host::<Sampler>::new(CLOCKED);
    host.begin_at(2.0);
    assert_eq!(host.interval("sample"), (OK, 0.25, INTERVAL_CHANGED));
    assert_eq!(host.interval("sample"), (OK, 0.25, INTERVAL_UNCHANGED));
    assert_eq!(host.interval("beat"), (OK, 0.1, INTERVAL_UNCHANGED));
    assert_eq!(host.interval("alarm").2, INTERVAL_NOT_YET_KNOWN);
    let (status, pulse, qualifier) = host.interval("pulse");
    assert_eq!((status, qualifier, (pulse - 0.1).abs() < 1e-12), (OK, INTERVAL_CHANGED, true));
    // Set again, though to what it was: nothing is new.
    assert_eq!(host.set("every", 0.25), OK);
    assert_eq!(host.interval("sample").2, INTERVAL_UNCHANGED);
    assert_eq!(host.interval("pulse"), (OK, pulse, INTERVAL_UNCHANGED));
    assert_eq!((host.set_interval("trim", 0.75), host.interval("trim")), (OK, (OK, 0.75, INTERVAL_UNCHANGED)));
    assert_eq!(host.exit_initialization(), OK);
    assert_eq!((host.set("signal", 2.0), host.tick("sample")), (OK, OK));
    assert!(host.ticks("sample") && host.ticks("crossing"));
    host.update();
    assert!(!host.ticks("sample") && !host.ticks("crossing"));
    assert_eq!(host.interval("alarm"), (OK, 0.125, INTERVAL_CHANGED));
    assert_eq!(host.interval("alarm"), (OK, 0.125, INTERVAL_UNCHANGED));
    assert_eq!(host.set("every", 0.5), OK);
    host.update();
    assert_eq!(host.interval("sample"), (OK, 0.5, INTERVAL_CHANGED));
    assert_eq!((host.tick("alarm"), host.integer("alarms")), (OK, 1));
    host.update();
    assert_eq!(host.interval("alarm").2, INTERVAL_NOT_YET_KNOWN);
    assert_eq!(host.tick("alarm"), ERROR, "a clock ticks once");
}

#[test]
fn an_interval_that_is_over_is_not_negative() {
    let host = Host::<Sampler>::new(CLOCKED);
    host.initialize();
    assert_eq!((host.set("signal", 2.0), host.tick("sample")), (OK, OK));
    host.enter_step();
    assert_eq!(host.integer("samples"), 0, "an event that is not ended has not been");
    assert_eq!(host.step(0.0, 0.5), OK);
    assert_eq!(host.integer("samples"), 0, "and its clocks do not tick later");
    assert_eq!((host.enter_event(), host.tick("sample")), (OK, OK));
    host.update();
    host.enter_step();
    assert_eq!((host.step(0.5, 0.5), host.enter_event()), (OK, OK));
    assert_eq!(host.interval("alarm"), (OK, 0.0, INTERVAL_CHANGED));
}

#[test]
fn outputs_of_every_kind_have_dependencies() {
    let host = Host::<Sampler>::new(CLOCKED);
    let count = |name: &str| {
        let mut n = usize::MAX;
        // SAFETY: an instance and a place.
        let status = unsafe {
            fmi3::fmi3GetNumberOfVariableDependencies::<Sampler>(host.instance, host.reference(name), &mut n)
        };
        assert_eq!(status, OK, "{name}: {:?}", host.log);
        n
    };
    host.initialize();
    assert_eq!((count("held"), count("samples")), (1, 0));
    assert_eq!(count("crossing"), 2, "what a clock depends on is not traced: on time and the input");
}

#[test]
fn what_was_computed_for_looking_is_given_back() {
    let host = Host::<Sampler>::new(CLOCKED);
    host.initialize();
    assert_eq!(host.set("signal", 0.5), OK);
    assert_eq!((host.tick("sample"), host.get("held"), host.integer("samples")), (OK, 0.5, 1));
    // Set again before the event is over: one sample, of what is set last.
    assert_eq!(host.set("signal", 0.7), OK);
    assert_eq!((host.get("held"), host.integer("samples")), (0.7, 1));
    host.update();
    assert_eq!((host.get("held"), host.integer("samples")), (0.7, 1));
}
