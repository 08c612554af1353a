//! Intermediate updates: the importer looks, sets and ends the step, from within it.

use std::cell::RefCell;
use std::rc::Rc;

use swayless_export::abi::fmi3::{DISCARD, ERROR, OK};
use swayless_export::fmi3;

use crate::chain::Chain;
use crate::host::{CO_SIMULATION, Host, Wish, on_update};

type Shared = Rc<RefCell<Option<Host<Chain>>>>;

/// An instance that calls back; what happens then is given the instance, the time, and whether it may return early.
fn calling(wish: Wish, mut act: impl FnMut(&Host<Chain>, f64, bool) -> Option<f64> + 'static) -> Shared {
    let shared = Shared::default();
    let inner = Rc::clone(&shared);
    on_update(move |t, early| act(inner.borrow().as_ref().unwrap(), t, early));
    shared.replace(Some(Host::new(wish)));
    shared
}

#[test]
fn time_goes_up_to_the_end_of_the_step_over_an_event() {
    let times = Rc::new(RefCell::new(Vec::new()));
    let list = Rc::clone(&times);
    let host = calling(CO_SIMULATION, move |host, t, early| {
        assert!(!early && (host.get("double") - 2.0 * (1.0 - t % 1.0)).abs() < 1e-6, "{t}: {}", host.get("double"));
        list.borrow_mut().push(t);
        None
    });
    let host = host.borrow();
    let host = host.as_ref().unwrap();
    host.initialize();
    assert_eq!(host.step(0.0, 1.5), OK, "{:?}", host.log);
    assert_eq!(host.get("refills"), 1.0);
    let times = times.borrow();
    assert!(
        times.is_sorted() && times.iter().any(|t| (t - 1.0).abs() < 1e-9) && times.last() == Some(&1.5),
        "{times:?}"
    );
}

#[test]
fn an_input_set_within_a_step_holds_from_there_and_a_discarded_step_gives_all_else_back() {
    let set = Rc::new(RefCell::new(None));
    let wanted = Rc::clone(&set);
    let host = calling(CO_SIMULATION, move |host, t, _| {
        if let Some(value) = wanted.borrow_mut().take() {
            assert_eq!(host.set("inflow", value), OK);
            assert!(t < 1.4);
        }
        None
    });
    let host = host.borrow();
    let host = host.as_ref().unwrap();
    host.initialize();
    set.replace(Some(f64::NAN));
    // Discarded behind the event at 1 s or before it: neither has been.
    assert_eq!(host.step(0.0, 1.5), DISCARD);
    assert_eq!((host.get("time"), host.get("refills"), host.get("double")), (0.0, 0.0, 2.0));
    assert_eq!(host.set("inflow", 0.0), OK);
    assert_eq!(host.step(0.0, 0.5), OK);
    set.replace(Some(1.0));
    let before = host.get("double");
    assert_eq!(host.step(0.5, 0.25), OK);
    // The level falls until the first update, which is within the step, and stays from there.
    let after = host.get("double");
    assert!(after <= before && after >= before - 0.5 - 1e-9);
    assert_eq!(host.step(0.75, 10.0), OK);
    assert!((host.get("double") - after).abs() < 1e-9);
}

#[test]
fn a_step_ends_where_the_importer_wants_or_at_an_event_before() {
    let wanted = Rc::new(RefCell::new(Some(0.75)));
    let ask = Rc::clone(&wanted);
    let wish = Wish { event_mode: true, early_return: true, ..CO_SIMULATION };
    let host = calling(wish, move |_, _, early| ask.borrow().filter(|_| early));
    let host = host.borrow();
    let host = host.as_ref().unwrap();
    host.initialize();
    host.handle_event(false);
    let (status, event, early, last) = host.step_to_event(0.0, 0.9);
    assert_eq!((status, event, early), (OK, false, last < 0.9));
    assert!(last >= 0.75, "not before it was asked for");
    // The event at 1 s and the wish to return there meet: it is told as an event.
    wanted.replace(Some(1.0));
    let (status, event, early, end) = host.step_to_event(last, 2.0 - last);
    assert_eq!((status, event, early), (OK, true, true));
    assert!((end - 1.0).abs() < 1e-9);
    host.handle_event(true);
    assert_eq!(host.get("refills"), 1.0);
}

#[test]
fn what_fails_within_fails_the_step() {
    let host = calling(CO_SIMULATION, |host, _, _| {
        host.step_to_event(0.0, 1.0);
        None
    });
    let host = host.borrow();
    let host = host.as_ref().unwrap();
    host.initialize();
    assert_eq!(host.step(0.0, 0.5), ERROR);
    assert_eq!(host.reset(), OK);
}

#[test]
fn nothing_is_freed_within_a_callback() {
    let host = calling(CO_SIMULATION, |host, _, _| {
        // SAFETY: an instance; freeing it here is what an importer must not do.
        unsafe { fmi3::fmi3FreeInstance::<Chain>(host.instance) };
        None
    });
    let host = host.borrow();
    let host = host.as_ref().unwrap();
    host.initialize();
    assert_eq!(host.step(0.0, 0.5), OK, "{:?}", host.log);
    assert!(host.get("double").is_finite());
}
