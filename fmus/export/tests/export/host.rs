//! A host that calls the C functions of FMI 3.0 on the ball, and keeps what is logged.

use std::ffi::{CStr, CString, c_void};
use std::ptr::null_mut;

use swayless_export::abi::{describe, fmi3 as abi};
use swayless_export::{fmi3, swayless_describe};
use swayless_modeldesc::types::ModelDescription;

use crate::ball::Ball;

/// What the log has: status, category and text of each message.
pub type Messages = Vec<(i32, String, String)>;

/// An instance with its log.
pub struct Host {
    pub instance: abi::Instance,
    pub log: Box<Messages>,
    pub description: ModelDescription,
}

unsafe extern "C" fn log(environment: *mut c_void, status: i32, category: abi::String, message: abi::String) {
    // SAFETY: the environment is the log that `Host` keeps, and the runtime passes texts that end with a NUL.
    unsafe {
        let text = |text| CStr::from_ptr(text).to_string_lossy().into_owned();
        (*environment.cast::<Messages>()).push((status, text(category), text(message)));
    }
}

pub unsafe extern "C" fn collect(context: *mut c_void, bytes: *const u8, n: usize) {
    // SAFETY: the context is the buffer of `describe`, and the runtime passes `n` bytes.
    unsafe { (*context.cast::<Vec<u8>>()).extend_from_slice(std::slice::from_raw_parts(bytes, n)) };
}

/// An item of the description.
pub fn describe(item: &CStr) -> Option<String> {
    let mut bytes: Vec<u8> = Vec::new();
    // SAFETY: a text, and a sink that takes this context.
    let status = unsafe { swayless_describe::<Ball>(item.as_ptr(), Some(collect), (&raw mut bytes).cast()) };
    (status == 0).then(|| String::from_utf8(bytes).unwrap())
}

impl Host {
    /// An instance for co-simulation.
    pub fn co_simulation() -> Self {
        Self::new(Some((false, false)))
    }

    /// An instance for co-simulation whose events the host handles; with or without early return.
    pub fn with_event_mode(early_return: bool) -> Self {
        Self::new(Some((true, early_return)))
    }

    /// An instance for model exchange.
    pub fn model_exchange() -> Self {
        Self::new(None)
    }

    /// Co-simulation with `eventModeUsed` and `earlyReturnAllowed`, or model exchange.
    fn new(co_simulation: Option<(bool, bool)>) -> Self {
        let (description, problems) = swayless_modeldesc::read::read(&describe(describe::FMI3).unwrap()).unwrap();
        assert_eq!(problems, Vec::new());
        let token = CString::new(description.instantiation_token.clone()).unwrap();
        let mut log_of_host: Box<Messages> = Box::default();
        let environment: *mut c_void = (&raw mut *log_of_host).cast();
        // SAFETY: texts and the log live long enough.
        let instance = unsafe {
            if let Some((event_mode, early_return)) = co_simulation {
                fmi3::fmi3InstantiateCoSimulation::<Ball>(
                    c"ball".as_ptr(),
                    token.as_ptr(),
                    null_mut(),
                    0,
                    1,
                    event_mode.into(),
                    early_return.into(),
                    null_mut(),
                    0,
                    environment,
                    Some(log),
                    None,
                )
            } else {
                fmi3::fmi3InstantiateModelExchange::<Ball>(
                    c"ball".as_ptr(),
                    token.as_ptr(),
                    null_mut(),
                    0,
                    1,
                    environment,
                    Some(log),
                )
            }
        };
        assert!(!instance.is_null(), "{log_of_host:?}");
        Self { instance, log: log_of_host, description }
    }

    /// The value reference of a variable.
    pub fn reference(&self, name: &str) -> u32 {
        self.description.variables.iter().find(|v| v.name == name).unwrap_or_else(|| panic!("{name}")).value_reference
    }

    pub fn set(&self, name: &str, value: f64) -> i32 {
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3SetFloat64::<Ball>(self.instance, &self.reference(name), 1, &value, 1) }
    }

    pub fn get(&self, name: &str) -> f64 {
        let mut value = f64::NAN;
        // SAFETY: one reference and one value.
        let status = unsafe { fmi3::fmi3GetFloat64::<Ball>(self.instance, &self.reference(name), 1, &mut value, 1) };
        assert_eq!(status, abi::OK, "{name}: {:?}", self.log);
        value
    }

    pub fn integer(&self, name: &str) -> i32 {
        let mut value = i32::MIN;
        // SAFETY: one reference and one value.
        let status = unsafe { fmi3::fmi3GetInt32::<Ball>(self.instance, &self.reference(name), 1, &mut value, 1) };
        assert_eq!(status, abi::OK, "{name}: {:?}", self.log);
        value
    }

    pub fn set_boolean(&self, name: &str, value: bool) -> i32 {
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3SetBoolean::<Ball>(self.instance, &self.reference(name), 1, &value.into(), 1) }
    }

    pub fn set_item(&self, name: &str, value: i64) -> i32 {
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3SetInt64::<Ball>(self.instance, &self.reference(name), 1, &value, 1) }
    }

    pub fn enter_initialization(&self) -> i32 {
        // SAFETY: an instance.
        unsafe { fmi3::fmi3EnterInitializationMode::<Ball>(self.instance, 1, 1e-10, 0.0, 0, 0.0) }
    }

    pub fn exit_initialization(&self) -> i32 {
        // SAFETY: an instance.
        unsafe { fmi3::fmi3ExitInitializationMode::<Ball>(self.instance) }
    }

    pub fn initialize(&self) {
        assert_eq!(self.enter_initialization(), abi::OK, "{:?}", self.log);
        assert_eq!(self.exit_initialization(), abi::OK, "{:?}", self.log);
    }

    /// A step that nothing cuts short.
    pub fn step(&self, t: f64, h: f64) -> i32 {
        let (status, event, early, last) = self.step_to_event(t, h);
        if status == abi::OK {
            assert_eq!((event, early, last), (false, false, t + h));
        }
        status
    }

    /// A step: its status, whether there is an event at its end, whether it ended early, and where.
    pub fn step_to_event(&self, t: f64, h: f64) -> (i32, bool, bool, f64) {
        let (mut events, mut terminate, mut early, mut last) = (9, 9, 9, f64::NAN);
        // SAFETY: an instance and places for the answers.
        let status = unsafe {
            fmi3::fmi3DoStep::<Ball>(self.instance, t, h, 0, &mut events, &mut terminate, &mut early, &mut last)
        };
        assert!(events <= 1 && early <= 1 && terminate == 0 || status != abi::OK);
        (status, events == 1, early == 1, last)
    }

    /// Through Event Mode, back to Step Mode. Returns the time of the next event.
    pub fn handle_event(&self, enter: bool) -> Option<f64> {
        let mut flags = [9; 5];
        let mut next = f64::NAN;
        // SAFETY: an instance and places for the answers.
        unsafe {
            if enter {
                assert_eq!(fmi3::fmi3EnterEventMode::<Ball>(self.instance), abi::OK, "{:?}", self.log);
            }
            let [again, terminate, nominals, _states, defined] = &mut flags;
            let mut states = 9;
            let status = fmi3::fmi3UpdateDiscreteStates::<Ball>(
                self.instance,
                again,
                terminate,
                nominals,
                &mut states,
                defined,
                &mut next,
            );
            assert_eq!((status, *again, *terminate, *nominals), (abi::OK, 0, 0, 0));
            assert_eq!(fmi3::fmi3EnterStepMode::<Ball>(self.instance), abi::OK);
        }
        (flags[4] == 1).then_some(next)
    }

    pub fn reset(&self) -> i32 {
        // SAFETY: an instance.
        unsafe { fmi3::fmi3Reset::<Ball>(self.instance) }
    }

    /// The text of the last message.
    pub fn last_message(&self) -> &str {
        self.log.last().map_or("", |(_, _, text)| text)
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        // SAFETY: an instance that is not used again.
        unsafe { fmi3::fmi3FreeInstance::<Ball>(self.instance) };
    }
}
