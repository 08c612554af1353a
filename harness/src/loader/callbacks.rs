//! What FMUs call: loggers and memory functions.

use std::collections::VecDeque;
use std::ffi::{CStr, c_char, c_int, c_void};
use std::sync::{Arc, Mutex, PoisonError};

use swayless_abi::{fmi2, fmi3};

use crate::slave::{Failure, LogMessage, Status};

/// How many messages of an instance are kept; the oldest go first.
const KEPT: usize = 1000;

/// What an instance gets as its environment and hands back in every callback. The logger's C part finds its Rust part
/// in the first field.
#[repr(C)]
pub(super) struct Environment {
    take: unsafe extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char),
    instance: String,
    /// Behind a lock, since an FMU may log from a thread of its own.
    messages: Mutex<VecDeque<LogMessage>>,
}

unsafe extern "C" {
    fn swayless_fmi2_logger(
        environment: *mut c_void,
        instance: *const c_char,
        status: c_int,
        category: *const c_char,
        format: *const c_char,
        ...
    );
    fn calloc(count: usize, size: usize) -> *mut c_void;
    fn free(memory: *mut c_void);
}

impl Environment {
    /// For the instance of this name.
    pub(super) fn new(instance: &str) -> Arc<Self> {
        Arc::new(Self { take: take_fmi2, instance: instance.to_owned(), messages: Mutex::default() })
    }

    /// The pointer that the instance gets. It is valid as long as the `Arc` lives.
    pub(super) fn pointer(self: &Arc<Self>) -> *mut c_void {
        Arc::as_ptr(self).cast_mut().cast()
    }

    /// The callbacks of FMI 2.0 with this environment. Steps are never asynchronous, so none is told when one ends.
    pub(super) fn fmi2_callbacks(self: &Arc<Self>) -> fmi2::CallbackFunctions {
        fmi2::CallbackFunctions {
            logger: Some(swayless_fmi2_logger),
            allocate_memory: Some(calloc),
            free_memory: Some(free),
            step_finished: None,
            component_environment: self.pointer(),
        }
    }

    /// The logger of FMI 3.0.
    pub(super) fn fmi3_logger() -> fmi3::LogMessageCallback {
        Some(take_fmi3)
    }

    /// All messages since the last call.
    pub(super) fn take_messages(&self) -> Vec<LogMessage> {
        self.messages.lock().unwrap_or_else(PoisonError::into_inner).drain(..).collect()
    }

    /// A failure with the messages that complain; those that do not stay.
    pub(super) fn failure(&self, call: &'static str, status: c_int) -> Failure {
        let (messages, rest): (Vec<_>, Vec<_>) = self.take_messages().into_iter().partition(|m| m.status != Status::Ok);
        *self.messages.lock().unwrap_or_else(PoisonError::into_inner) = rest.into();
        Failure { call, status: status.into(), last_successful_time: None, messages }
    }

    fn push(&self, status: c_int, category: *const c_char, text: *const c_char) {
        let mut messages = self.messages.lock().unwrap_or_else(PoisonError::into_inner);
        if messages.len() == KEPT {
            messages.pop_front();
        }
        messages.push_back(LogMessage {
            instance: self.instance.clone(),
            status: status.into(),
            // SAFETY: the callbacks below pass on what an FMU gave them.
            category: unsafe { text_of(category) },
            // SAFETY: as above.
            text: unsafe { text_of(text) },
        });
    }
}

/// A string from an FMU; NULL is an empty one.
///
/// # Safety
/// The pointer is NULL or points to a string that ends with a NUL.
unsafe fn text_of(pointer: *const c_char) -> String {
    if pointer.is_null() {
        return String::new();
    }
    // SAFETY: the caller's promise.
    unsafe { CStr::from_ptr(pointer) }.to_string_lossy().trim_end().to_owned()
}

/// The Rust part of FMI 2.0's logger. The instance's name is not asked for: the environment knows it.
unsafe extern "C" fn take_fmi2(
    environment: *mut c_void,
    _instance: *const c_char,
    status: c_int,
    category: *const c_char,
    text: *const c_char,
) {
    // SAFETY: the C part has found the pointer not to be NULL; an FMU that follows the standard hands back what it was
    // given, and calls only while its instance lives, which keeps the environment.
    let environment = unsafe { &*environment.cast::<Environment>() };
    environment.push(status, category, text);
}

/// FMI 3.0's logger.
unsafe extern "C" fn take_fmi3(environment: *mut c_void, status: c_int, category: *const c_char, text: *const c_char) {
    if environment.is_null() {
        return;
    }
    // SAFETY: as for `take_fmi2`, with NULL looked for just now.
    let environment = unsafe { &*environment.cast::<Environment>() };
    environment.push(status, category, text);
}
