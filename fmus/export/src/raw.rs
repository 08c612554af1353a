//! Where C meets Rust: pointers are checked, panics caught, and refusals turned into a status and a log message.

use std::borrow::Cow;
use std::cell::UnsafeCell;
use std::ffi::{CStr, CString, c_char, c_void};
use std::path::PathBuf;
use std::ptr;
use std::sync::atomic::{AtomicUsize, Ordering};

use swayless_abi::fmi3::{
    ClockUpdateCallback, InstanceEnvironment, IntermediateUpdateCallback, LockPreemptionCallback,
    UnlockPreemptionCallback,
};

use crate::instance::{Instance, Refusal};
use crate::log::{Category, Log, Severity};
use crate::model::Model;
use crate::panics::caught;
use crate::phase::{Call, Interface, Phase};
use crate::token::{self, Variant};

/// A slice of `n` values; NULL and dangling pointers are fine when there are none.
///
/// # Safety
/// Unless `n` is 0 or the pointer NULL, it points to `n` values that stay as they are for `'a`.
pub unsafe fn slice<'a, T>(pointer: *const T, n: usize, what: &str) -> Result<&'a [T], Refusal> {
    if n == 0 {
        return Ok(&[]);
    }
    if pointer.is_null() {
        return Err(Refusal::error(format!("{what} is NULL, but {n} values are announced")));
    }
    // SAFETY: not NULL and not empty, so that the caller's promise holds.
    Ok(unsafe { std::slice::from_raw_parts(pointer, n) })
}

/// A slice of `n` places to write to.
///
/// # Safety
/// Unless `n` is 0 or the pointer NULL, it points to `n` initialized values that nobody else touches for `'a`.
pub unsafe fn slice_mut<'a, T>(pointer: *mut T, n: usize, what: &str) -> Result<&'a mut [T], Refusal> {
    if n == 0 {
        return Ok(&mut []);
    }
    if pointer.is_null() {
        return Err(Refusal::error(format!("{what} is NULL, but {n} values are announced")));
    }
    // SAFETY: not NULL and not empty, so that the caller's promise holds.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, n) })
}

/// Writes through a pointer, unless it is NULL.
///
/// # Safety
/// The pointer is NULL or valid for writing.
pub unsafe fn put<T>(pointer: *mut T, value: T) {
    if !pointer.is_null() {
        // SAFETY: the caller's promise.
        unsafe { pointer.write(value) };
    }
}

/// A text, or `None` for NULL. Bytes that are not UTF-8 are replaced.
///
/// # Safety
/// The pointer is NULL or points to a text that ends with a NUL and stays as it is for `'a`.
pub unsafe fn text<'a>(pointer: *const c_char) -> Option<Cow<'a, str>> {
    if pointer.is_null() {
        return None;
    }
    // SAFETY: the caller's promise.
    Some(unsafe { CStr::from_ptr(pointer) }.to_string_lossy())
}

/// Refuses derivatives of another order than the first.
pub fn first_order(orders: &[i32]) -> Result<(), Refusal> {
    match orders.iter().find(|order| **order != 1) {
        Some(order) => Err(Refusal::error(format!("there is no derivative of order {order}, only of order 1"))),
        None => Ok(()),
    }
}

/// A text for C: what cannot stand in it is left out, and `#`, which begins a variable's reference, is doubled.
pub fn message(text: &str) -> CString {
    let clean: String = text.chars().filter(|c| *c != '\0').collect();
    CString::new(clean.replace('#', "##")).unwrap_or_default()
}

/// A text for C; what stands behind a NUL is left out.
pub fn c_text(text: &str) -> CString {
    CString::new(text.split('\0').next().unwrap_or_default()).unwrap_or_default()
}

/// What an importer holds: an instance, and what may be looked at while the instance is in use.
struct Shell<M: Model> {
    surroundings: Surroundings,
    /// How many callbacks are under way from which the importer may call back; while there are, nothing is freed.
    callbacks: AtomicUsize,
    instance: UnsafeCell<Instance<M>>,
}

/// The importer's callbacks beside the log, all of FMI 3.0.
#[derive(Clone, Copy, Default)]
pub struct Surroundings {
    /// Handed back to the callbacks.
    pub environment: InstanceEnvironment,
    /// Co-simulation: called after each accepted step of the integrator.
    pub intermediate_update: IntermediateUpdateCallback,
    /// Scheduled execution: called when there is news of clocks.
    pub clock_update: ClockUpdateCallback,
    /// Scheduled execution: called around everything that must not be preempted.
    pub lock_preemption: LockPreemptionCallback,
    /// See `lock_preemption`.
    pub unlock_preemption: UnlockPreemptionCallback,
}

/// Keeps other tasks of the importer's scheduler away, as long as it lives.
struct Locked(UnlockPreemptionCallback);

impl Surroundings {
    fn lock(&self) -> Locked {
        if let Some(lock) = self.lock_preemption {
            // SAFETY: the importer's callback, which takes nothing.
            unsafe { lock() };
        }
        Locked(self.unlock_preemption)
    }
}

impl Drop for Locked {
    fn drop(&mut self) {
        if let Some(unlock) = self.0 {
            // SAFETY: the importer's callback, which takes nothing.
            unsafe { unlock() };
        }
    }
}

/// What an instance is made from.
pub struct Order<'a> {
    /// The interface.
    pub interface: Interface,
    /// Whether the importer's FMI version knows clocks.
    pub may_have_clocks: bool,
    /// `instanceName`.
    pub name: Option<&'a str>,
    /// `instantiationToken`.
    pub token: Option<&'a str>,
    /// Where the resources lie.
    pub resources: Option<PathBuf>,
    /// The importer's callbacks.
    pub surroundings: Surroundings,
}

/// Makes an instance, prepares it, or returns NULL and says why.
pub fn instantiate<M: Model>(
    order: Order<'_>,
    log: Log,
    prepare: impl FnOnce(&mut Instance<M>) -> Result<(), Refusal>,
) -> *mut c_void {
    let name = order.name.unwrap_or_default();
    // What goes wrong is told through a log of its own, since the instance takes this one.
    let told = log.twin();
    let made = caught(|| make::<M>(&order, log, prepare));
    match made {
        Ok(Ok(instance)) => {
            let shell = Shell {
                surroundings: order.surroundings,
                callbacks: AtomicUsize::new(0),
                instance: UnsafeCell::new(instance),
            };
            Box::into_raw(Box::new(shell)).cast()
        }
        Ok(Err(refusal)) => {
            told.write(name, Category::Status(Severity::Error), &refusal.message);
            ptr::null_mut()
        }
        Err(why) => {
            let why = format!("internal error: {why}; please report it");
            told.write(name, Category::Status(Severity::Fatal), &why);
            ptr::null_mut()
        }
    }
}

fn make<M: Model>(
    order: &Order<'_>,
    log: Log,
    prepare: impl FnOnce(&mut Instance<M>) -> Result<(), Refusal>,
) -> Result<Instance<M>, Refusal> {
    let Some(name) = order.name.filter(|name| !name.is_empty()) else {
        return Err(Refusal::error("instanceName is missing or empty"));
    };
    let expected = token::of::<M>(Variant::Plain);
    let clocked = order.may_have_clocks
        && !M::CLOCKS.is_empty()
        && order.token == Some(token::of::<M>(Variant::Clocked).as_str());
    if order.token != Some(expected.as_str()) && !clocked {
        let given = order.token.unwrap_or("NULL");
        return Err(Refusal::error(format!(
            "the instantiation token (GUID) is {given}, but this library of {} has {expected}: model description and \
             library are not from the same FMU",
            M::INFO.name
        )));
    }
    let scheduled = order.interface == Interface::ScheduledExecution;
    if scheduled && !(clocked && Variant::has_scheduled_execution::<M>()) {
        return Err(Refusal::error("this FMU does not offer scheduled execution"));
    }
    let mut instance = Instance::<M>::new(order.interface, name, log, order.resources.clone());
    instance.clocked = clocked;
    prepare(&mut instance)?;
    if clocked && order.interface == Interface::CoSimulation && !instance.event_mode.used {
        return Err(Refusal::error(
            "an FMU with clocks needs eventModeUsed = true: without, its clocks could not tick; the FMU without clocks \
             ticks them itself",
        ));
    }
    Ok(instance)
}

/// Frees an instance; NULL is nothing to do, and within a callback nothing is freed.
///
/// # Safety
/// The pointer is NULL or came from [`instantiate`] of the same model and is not used again.
pub unsafe fn free<M: Model>(instance: *mut c_void) {
    if instance.is_null() {
        return;
    }
    // SAFETY: by the caller's promise a shell that `instantiate` gave away.
    let callbacks = unsafe { (*instance.cast::<Shell<M>>()).callbacks.load(Ordering::Acquire) };
    if callbacks == 0 {
        // SAFETY: by the caller's promise this is the box that `instantiate` gave away.
        let shell = unsafe { Box::from_raw(instance.cast::<Shell<M>>()) };
        let _ = caught(|| drop(shell));
    }
}

/// The callbacks that came with an instance; none with NULL.
///
/// # Safety
/// The pointer is NULL or came from [`instantiate`] of the same model.
pub unsafe fn surroundings<M: Model>(instance: *mut c_void) -> Surroundings {
    // SAFETY: the caller's promise; the callbacks never change, whatever is done with the instance beside them.
    unsafe { instance.cast::<Shell<M>>().as_ref() }.map(|shell| shell.surroundings).unwrap_or_default()
}

/// Runs a callback of the importer from which it may call back.
///
/// # Safety
/// The pointer is NULL or came from [`instantiate`] of the same model, and no reference to its instance is held.
pub unsafe fn callback<M: Model, T>(instance: *mut c_void, run: impl FnOnce() -> T) -> T {
    // SAFETY: the caller's promise; the shell lives on, since it is not freed while a callback is under way.
    let shell = unsafe { instance.cast::<Shell<M>>().as_ref() };
    let under_way = shell.map(|shell| &shell.callbacks);
    under_way.inspect(|count| {
        count.fetch_add(1, Ordering::AcqRel);
    });
    let answer = run();
    under_way.inspect(|count| {
        count.fetch_sub(1, Ordering::AcqRel);
    });
    answer
}

/// The way of every call on an instance: checks the pointer and the phase, runs the body, catches a panic, logs.
///
/// # Safety
/// The pointer is NULL or came from [`instantiate`] of the same model, and no other call on it is under way.
pub unsafe fn call<M: Model>(
    instance: *mut c_void,
    call: Call,
    function: &str,
    body: impl FnOnce(&mut Instance<M>) -> Result<(), Refusal>,
) -> i32 {
    if instance.is_null() {
        return Severity::Error as i32;
    }
    // SAFETY: not NULL, so by the caller's promise a shell of this model.
    let shell = unsafe { &*instance.cast::<Shell<M>>() };
    let _locked = shell.surroundings.lock();
    // SAFETY: by the caller's promise nobody else uses the instance now; in scheduled execution, where tasks preempt
    // each other, the lock keeps them away. No reference is held while a callback runs that may call back.
    let instance = unsafe { &mut *shell.instance.get() };
    let outcome = caught(|| {
        instance.allow(call, function)?;
        body(instance)
    });
    match outcome {
        Ok(Ok(())) => 0,
        failed => fail(instance, function, failed),
    }
}

/// Logs why a call failed, and returns its status. On its own, since there are more than a hundred calls.
#[cold]
#[inline(never)]
fn fail<M: Model>(instance: &mut Instance<M>, function: &str, outcome: Result<Result<(), Refusal>, String>) -> i32 {
    let refusal = match outcome {
        Ok(Ok(())) => return 0,
        Ok(Err(refusal)) => refusal,
        Err(why) => Refusal {
            severity: Severity::Fatal,
            message: format!("internal error in {function}: {why}; please report it"),
        },
    };
    match refusal.severity {
        Severity::Fatal => instance.phase = Phase::Broken,
        Severity::Error if instance.phase != Phase::Broken => instance.phase = Phase::Failed,
        _ => {}
    }
    instance.log.write(&instance.name, Category::Status(refusal.severity), &refusal.message);
    refusal.severity as i32
}
