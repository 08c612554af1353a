//! A host that calls the C functions of FMI 3.0 on the ball, and keeps what is logged.

use std::cell::{Cell, RefCell};
use std::ffi::{CStr, CString, c_void};
use std::marker::PhantomData;
use std::ptr::null_mut;

use swayless_export::abi::{describe, fmi3 as abi};
use swayless_export::{Model, fmi3, swayless_describe};
use swayless_modeldesc::types::ModelDescription;

use crate::ball::Ball;

/// What the log has: status, category and text of each message.
pub type Messages = Vec<(i32, String, String)>;

/// An instance with its log.
pub struct Host<M: Model = Ball> {
    pub instance: abi::Instance,
    pub log: Box<Messages>,
    pub description: ModelDescription,
    model: PhantomData<M>,
}

/// What a host wants of an instance.
#[derive(Clone, Copy)]
pub struct Wish {
    pub interface: Interface,
    /// `eventModeUsed` and `earlyReturnAllowed`.
    pub event_mode: bool,
    pub early_return: bool,
    /// Whether the host ticks the clocks.
    pub clocked: bool,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Interface {
    ModelExchange,
    CoSimulation,
    ScheduledExecution,
}

/// Called with the time of an intermediate update and whether the step may end there; returns where it shall.
type Update = Box<dyn FnMut(f64, bool) -> Option<f64>>;

thread_local! {
    static UPDATE: RefCell<Option<Update>> = const { RefCell::new(None) };
    static NEWS: RefCell<Option<Box<dyn FnMut()>>> = const { RefCell::new(None) };
    /// How deep the importer's tasks are locked.
    pub static LOCKS: Cell<(i32, i32)> = const { Cell::new((0, 0)) };
}

/// What happens in intermediate updates of all instances of this thread.
pub fn on_update(update: impl FnMut(f64, bool) -> Option<f64> + 'static) {
    UPDATE.set(Some(Box::new(update)));
}

/// What happens when scheduled execution has news of clocks.
pub fn on_news(news: impl FnMut() + 'static) {
    NEWS.set(Some(Box::new(news)));
}

unsafe extern "C" fn update(
    _: *mut c_void,
    t: f64,
    _may_set: u8,
    _may_get: u8,
    _finished: u8,
    may_return: u8,
    requested: *mut u8,
    until: *mut f64,
) {
    let wanted = UPDATE.with_borrow_mut(|update| update.as_mut().and_then(|update| update(t, may_return != 0)));
    if let Some(time) = wanted {
        // SAFETY: the runtime's places for the answers.
        unsafe { (*requested, *until) = (1, time) };
    }
}

unsafe extern "C" fn news(_: *mut c_void) {
    NEWS.with_borrow_mut(|news| news.as_mut().map(|news| news()));
}

unsafe extern "C" fn lock() {
    let (depth, most) = LOCKS.get();
    LOCKS.set((depth + 1, most.max(depth + 1)));
}

unsafe extern "C" fn unlock() {
    let (depth, most) = LOCKS.get();
    LOCKS.set((depth - 1, most));
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
    describe_of::<Ball>(item)
}

fn describe_of<M: Model>(item: &CStr) -> Option<String> {
    let mut bytes: Vec<u8> = Vec::new();
    // SAFETY: a text, and a sink that takes this context.
    let status = unsafe { swayless_describe::<M>(item.as_ptr(), Some(collect), (&raw mut bytes).cast()) };
    (status == 0).then(|| String::from_utf8(bytes).unwrap())
}

/// Co-simulation as most importers use it.
pub const CO_SIMULATION: Wish =
    Wish { interface: Interface::CoSimulation, event_mode: false, early_return: false, clocked: false };

impl Host<Ball> {
    /// An instance for co-simulation.
    pub fn co_simulation() -> Self {
        Self::new(CO_SIMULATION)
    }

    /// An instance for co-simulation whose events the host handles; with or without early return.
    pub fn with_event_mode(early_return: bool) -> Self {
        Self::new(Wish { event_mode: true, early_return, ..CO_SIMULATION })
    }

    /// An instance for model exchange.
    pub fn model_exchange() -> Self {
        Self::new(Wish { interface: Interface::ModelExchange, ..CO_SIMULATION })
    }
}

impl<M: Model> Host<M> {
    /// An instance as it is wanted.
    pub fn new(wish: Wish) -> Self {
        let item = if wish.clocked { describe::CLOCKED } else { describe::FMI3 };
        let (description, problems) = swayless_modeldesc::read::read(&describe_of::<M>(item).unwrap()).unwrap();
        assert_eq!(problems, Vec::new());
        let token = CString::new(description.instantiation_token.clone()).unwrap();
        let (name, token) = (c"host".as_ptr(), token.as_ptr());
        let mut messages: Box<Messages> = Box::default();
        let environment: *mut c_void = (&raw mut *messages).cast();
        let (log, path): (abi::LogMessageCallback, _) = (Some(log), null_mut());
        // SAFETY: texts and the log live long enough.
        let instance = unsafe {
            match wish.interface {
                Interface::ModelExchange => {
                    fmi3::fmi3InstantiateModelExchange::<M>(name, token, path, 0, 1, environment, log)
                }
                Interface::CoSimulation => fmi3::fmi3InstantiateCoSimulation::<M>(
                    name,
                    token,
                    path,
                    0,
                    1,
                    wish.event_mode.into(),
                    wish.early_return.into(),
                    null_mut(),
                    0,
                    environment,
                    log,
                    UPDATE.with_borrow(|wanted| wanted.as_ref().map(|_| update as _)),
                ),
                Interface::ScheduledExecution => fmi3::fmi3InstantiateScheduledExecution::<M>(
                    name,
                    token,
                    path,
                    0,
                    1,
                    environment,
                    log,
                    NEWS.with_borrow(|wanted| wanted.as_ref().map(|_| news as _)),
                    Some(lock),
                    Some(unlock),
                ),
            }
        };
        assert!(!instance.is_null(), "{messages:?}");
        Self { instance, log: messages, description, model: PhantomData }
    }

    /// The value reference of a variable.
    pub fn reference(&self, name: &str) -> u32 {
        self.description.variables.iter().find(|v| v.name == name).unwrap_or_else(|| panic!("{name}")).value_reference
    }

    pub fn set(&self, name: &str, value: f64) -> i32 {
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3SetFloat64::<M>(self.instance, &self.reference(name), 1, &value, 1) }
    }

    pub fn get(&self, name: &str) -> f64 {
        let mut value = f64::NAN;
        // SAFETY: one reference and one value.
        let status = unsafe { fmi3::fmi3GetFloat64::<M>(self.instance, &self.reference(name), 1, &mut value, 1) };
        assert_eq!(status, abi::OK, "{name}: {:?}", self.log);
        value
    }

    pub fn integer(&self, name: &str) -> i32 {
        let mut value = i32::MIN;
        // SAFETY: one reference and one value.
        let status = unsafe { fmi3::fmi3GetInt32::<M>(self.instance, &self.reference(name), 1, &mut value, 1) };
        assert_eq!(status, abi::OK, "{name}: {:?}", self.log);
        value
    }

    pub fn set_boolean(&self, name: &str, value: bool) -> i32 {
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3SetBoolean::<M>(self.instance, &self.reference(name), 1, &value.into(), 1) }
    }

    pub fn set_item(&self, name: &str, value: i64) -> i32 {
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3SetInt64::<M>(self.instance, &self.reference(name), 1, &value, 1) }
    }

    pub fn enter_initialization(&self) -> i32 {
        // SAFETY: an instance.
        unsafe { fmi3::fmi3EnterInitializationMode::<M>(self.instance, 1, 1e-10, 0.0, 0, 0.0) }
    }

    pub fn exit_initialization(&self) -> i32 {
        // SAFETY: an instance.
        unsafe { fmi3::fmi3ExitInitializationMode::<M>(self.instance) }
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
            fmi3::fmi3DoStep::<M>(self.instance, t, h, 0, &mut events, &mut terminate, &mut early, &mut last)
        };
        assert!(events <= 1 && early <= 1 && terminate == 0 || status != abi::OK);
        (status, events == 1, early == 1, last)
    }

    /// Ends the event. Returns the time of the next.
    pub fn update(&self) -> Option<f64> {
        let [mut again, mut terminate, mut nominals, mut states, mut defined] = [9; 5];
        let mut next = f64::NAN;
        // SAFETY: an instance and places for the answers.
        let status = unsafe {
            fmi3::fmi3UpdateDiscreteStates::<M>(
                self.instance,
                &mut again,
                &mut terminate,
                &mut nominals,
                &mut states,
                &mut defined,
                &mut next,
            )
        };
        assert_eq!((status, again, terminate, nominals), (abi::OK, 0, 0, 0), "{:?}", self.log);
        (defined == 1).then_some(next)
    }

    pub fn enter_step(&self) {
        // SAFETY: an instance.
        assert_eq!(unsafe { fmi3::fmi3EnterStepMode::<M>(self.instance) }, abi::OK, "{:?}", self.log);
    }

    /// Through Event Mode, back to Step Mode. Returns the time of the next event.
    pub fn handle_event(&self, enter: bool) -> Option<f64> {
        if enter {
            // SAFETY: an instance.
            assert_eq!(unsafe { fmi3::fmi3EnterEventMode::<M>(self.instance) }, abi::OK, "{:?}", self.log);
        }
        let next = self.update();
        self.enter_step();
        next
    }

    pub fn reset(&self) -> i32 {
        // SAFETY: an instance.
        unsafe { fmi3::fmi3Reset::<M>(self.instance) }
    }

    /// The text of the last message.
    pub fn last_message(&self) -> &str {
        self.log.last().map_or("", |(_, _, text)| text)
    }
}

impl<M: Model> Drop for Host<M> {
    fn drop(&mut self) {
        // SAFETY: an instance that is not used again.
        unsafe { fmi3::fmi3FreeInstance::<M>(self.instance) };
    }
}
