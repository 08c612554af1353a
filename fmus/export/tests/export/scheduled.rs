//! Scheduled execution: model partitions, locks, and news of clocks.

use std::cell::RefCell;
use std::rc::Rc;

use swayless_export::abi::fmi3::{ERROR, OK};
use swayless_export::fmi3;

use crate::clocks::INTERVAL_CHANGED;
use crate::host::{CO_SIMULATION, Host, Interface, LOCKS, Wish, on_news};
use crate::sampler::Sampler;

const SCHEDULED: Wish = Wish { interface: Interface::ScheduledExecution, clocked: true, ..CO_SIMULATION };

fn activate(host: &Host<Sampler>, clock: &str, t: f64) -> i32 {
    // SAFETY: an instance.
    unsafe { fmi3::fmi3ActivateModelPartition::<Sampler>(host.instance, host.reference(clock), t) }
}

#[test]
fn a_partition_computes_what_its_clock_computes() {
    let host = Host::<Sampler>::new(SCHEDULED);
    host.initialize();
    assert_eq!(host.integer("samples"), 0, "nothing ticks but by the importer");
    assert_eq!(host.set("signal", 0.5), OK);
    assert_eq!((activate(&host, "sample", 0.0), activate(&host, "beat", 0.05)), (OK, OK));
    assert_eq!((host.get("held"), host.integer("samples"), host.integer("beats")), (0.5, 1, 1));
    // Another partition may lag behind, the same one may not.
    assert_eq!(activate(&host, "sample", 0.01), OK);
    assert_eq!(host.get("sampled"), 0.01);
    assert_eq!(activate(&host, "sample", 0.01), ERROR);
    assert!(host.last_message().contains("sample"), "{}", host.last_message());
}

#[test]
fn the_importer_is_told_unlocked_and_once() {
    let host: Rc<RefCell<Option<Host<Sampler>>>> = Rc::default();
    let told = Rc::new(RefCell::new(Vec::new()));
    let (inner, list) = (Rc::clone(&host), Rc::clone(&told));
    on_news(move || {
        let host = inner.borrow();
        let host = host.as_ref().unwrap();
        assert_eq!(LOCKS.get().0, 0, "the importer may call back");
        let alarm = host.interval("alarm");
        list.borrow_mut().push((host.ticks("crossing"), host.ticks("crossing"), alarm));
    });
    host.replace(Some(Host::new(SCHEDULED)));
    let host = host.borrow();
    let host = host.as_ref().unwrap();
    host.initialize();
    assert_eq!(activate(host, "sample", 0.0), OK);
    assert_eq!(told.borrow().len(), 0, "no news");
    assert_eq!((host.set("signal", 2.0), activate(host, "sample", 0.25)), (OK, OK));
    assert_eq!(*told.borrow(), [(true, false, (OK, 0.125, INTERVAL_CHANGED))]);
    assert_eq!(activate(host, "beat", 0.3), OK);
    assert_eq!(told.borrow().len(), 1);
    assert_eq!(LOCKS.get(), (0, 1), "never locked twice, always unlocked");
}
