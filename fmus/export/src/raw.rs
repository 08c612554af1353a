//! Where C meets Rust: pointers are checked, panics caught, and refusals turned into a status and a log message.

use std::borrow::Cow;
use std::ffi::{CStr, CString, c_char, c_void};
use std::path::PathBuf;
use std::ptr;

use crate::instance::{Instance, Refusal};
use crate::log::{Category, Log, Severity};
use crate::model::Model;
use crate::panics::caught;
use crate::phase::{Call, Interface, Phase};
use crate::token;

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

/// Makes an instance, or returns NULL and says why.
pub fn instantiate<M: Model>(
    interface: Interface,
    name: Option<&str>,
    given_token: Option<&str>,
    log: Log,
    resources: Option<PathBuf>,
) -> *mut c_void {
    let made = caught(|| {
        let refuse = |message: &str| {
            log.write(name.unwrap_or_default(), Category::Status(Severity::Error), message);
        };
        let Some(name) = name.filter(|name| !name.is_empty()) else {
            refuse("instanceName is missing or empty");
            return ptr::null_mut();
        };
        let expected = token::of::<M>();
        if given_token != Some(expected.as_str()) {
            let given = given_token.unwrap_or("NULL");
            refuse(&format!(
                "the instantiation token (GUID) is {given}, but this library of {} has {expected}: model description \
                 and library are not from the same FMU",
                M::INFO.name
            ));
            return ptr::null_mut();
        }
        Box::into_raw(Box::new(Instance::<M>::new(interface, name, log, resources))).cast()
    });
    made.unwrap_or(ptr::null_mut())
}

/// Frees an instance; NULL is nothing to do.
///
/// # Safety
/// The pointer is NULL or came from [`instantiate`] of the same model and is not used again.
pub unsafe fn free<M: Model>(instance: *mut c_void) {
    if !instance.is_null() {
        // SAFETY: by the caller's promise this is the box that `instantiate` gave away.
        let instance = unsafe { Box::from_raw(instance.cast::<Instance<M>>()) };
        let _ = caught(|| drop(instance));
    }
}

/// Refuses an interface that the FMU does not have.
pub fn no_such_interface(name: Option<&str>, log: &Log, interface: &str) -> *mut c_void {
    let why = format!("this FMU does not offer {interface}");
    log.write(name.unwrap_or_default(), Category::Status(Severity::Error), &why);
    ptr::null_mut()
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
    // SAFETY: not NULL, so by the caller's promise an instance of this model that nobody else uses now.
    let instance = unsafe { &mut *instance.cast::<Instance<M>>() };
    let outcome = caught(|| {
        instance.allow(call, function)?;
        body(instance)
    });
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
