//! The example of `fmus/README.md` is the one that compiles, and it does what an oscillator does.

use std::ffi::{CString, c_char, c_int, c_void};
use std::ptr::{null, null_mut};

use swayless_export::abi::describe::{FMI3, Sink};
use swayless_export::abi::fmi3::{
    Instance, IntermediateUpdateCallback, LogMessageCallback, OK, Status, String as Text,
};
use swayless_modeldesc::read::read;

use crate::host::collect;

#[path = "../../examples/oscillator.rs"]
mod oscillator;

// What `export_fmu!` has made, as an importer finds it.
unsafe extern "C" {
    fn swayless_describe(item: *const c_char, sink: Option<Sink>, context: *mut c_void) -> c_int;
    fn fmi3InstantiateCoSimulation(
        name: Text,
        token: Text,
        resources: Text,
        visible: u8,
        logging: u8,
        event_mode: u8,
        early_return: u8,
        required: *const u32,
        n_required: usize,
        environment: *mut c_void,
        log: LogMessageCallback,
        update: IntermediateUpdateCallback,
    ) -> Instance;
    fn fmi3EnterInitializationMode(instance: Instance, d: u8, tolerance: f64, start: f64, s: u8, stop: f64) -> Status;
    fn fmi3ExitInitializationMode(instance: Instance) -> Status;
    fn fmi3GetFloat64(instance: Instance, r: *const u32, n: usize, values: *mut f64, m: usize) -> Status;
    fn fmi3DoStep(
        instance: Instance,
        t: f64,
        h: f64,
        no_set_state: u8,
        event: *mut u8,
        terminate: *mut u8,
        early: *mut u8,
        last: *mut f64,
    ) -> Status;
    fn fmi3FreeInstance(instance: Instance);
}

#[test]
fn the_text_shows_what_is_compiled() {
    let text = include_str!("../../../README.md");
    let code = include_str!("../../examples/oscillator.rs");
    assert!(text.contains(&format!("```rust\n{code}```")), "fmus/README.md shows another oscillator");
}

#[test]
fn the_oscillator_oscillates() {
    let mut xml: Vec<u8> = Vec::new();
    // SAFETY: an item's name and a sink that takes the buffer.
    assert_eq!(unsafe { swayless_describe(FMI3.as_ptr(), Some(collect), (&raw mut xml).cast()) }, 0);
    let (description, problems) = read(std::str::from_utf8(&xml).unwrap()).unwrap();
    assert_eq!((problems, swayless_modeldesc::check::check(&description)), (vec![], vec![]));
    let token = CString::new(description.instantiation_token.as_str()).unwrap();
    let position = description.variables.iter().find(|v| v.name == "position").unwrap().value_reference;
    // SAFETY: texts, an instance, and places of the sizes announced.
    unsafe {
        let (name, nowhere) = (c"oscillator".as_ptr(), null_mut());
        let instance =
            fmi3InstantiateCoSimulation(name, token.as_ptr(), null(), 0, 0, 0, 0, null(), 0, nowhere, None, None);
        assert!(!instance.is_null());
        assert_eq!(fmi3EnterInitializationMode(instance, 1, 1e-11, 0.0, 0, 0.0), OK);
        assert_eq!(fmi3ExitInitializationMode(instance), OK);
        for n in 0..1000 {
            let t = f64::from(n) * 0.01;
            let (mut flags, mut last, mut x) = ([0; 3], 0.0, f64::NAN);
            let [event, terminate, early] = &mut flags;
            assert_eq!(fmi3DoStep(instance, t, 0.01, 1, event, terminate, early, &mut last), OK);
            assert_eq!(fmi3GetFloat64(instance, &position, 1, &mut x, 1), OK);
            let expected = (2.0 * (t + 0.01)).cos();
            assert!((x - expected).abs() < 1e-9, "{x} for {expected} at {last} s");
        }
        fmi3FreeInstance(instance);
    }
}
