//! `swayless_describe`: what the packager asks a library for.

use std::ffi::{CStr, c_char, c_int, c_void};

use swayless_abi::describe::{CANNOT, CLOCKED, DOCUMENTATION, FMI2, FMI3, ICON, Sink, TERMINALS};
use swayless_modeldesc::types::FmiVersion;

use crate::description;
use crate::model::Model;
use crate::panics::caught;
use crate::token::Variant;

/// An item of the description of a model, or why it cannot be made.
fn item<M: Model>(name: &CStr) -> Option<Result<String, String>> {
    let xml = |version, variant| {
        let wrong = description::names::wrong::<M>();
        if !wrong.is_empty() {
            return Some(Err(wrong.join("; ")));
        }
        let written = swayless_modeldesc::write::write(&description::of::<M>(version, variant));
        Some(written.map_err(|error| error.to_string()))
    };
    match name {
        name if name == FMI2 => xml(FmiVersion::V2, Variant::Plain),
        name if name == FMI3 => xml(FmiVersion::V3, Variant::Plain),
        name if name == CLOCKED && !M::CLOCKS.is_empty() => xml(FmiVersion::V3, Variant::Clocked),
        name if name == TERMINALS => {
            let written = swayless_modeldesc::terminals::write(&description::terminals::of::<M>());
            Some(written.map_err(|error| error.to_string()))
        }
        name if name == DOCUMENTATION => Some(Ok(M::INFO.documentation.to_string())),
        name if name == ICON => Some(Ok(M::INFO.icon.to_string())),
        _ => None,
    }
}

/// See [`Describe`](swayless_abi::describe::Describe).
///
/// # Safety
/// The name is NULL or ends with a NUL; the sink takes the context.
pub unsafe fn swayless_describe<M: Model>(name: *const c_char, sink: Option<Sink>, context: *mut c_void) -> c_int {
    let Some(sink) = sink.filter(|_| !name.is_null()) else { return 1 };
    // SAFETY: not NULL, so a text by the caller's promise.
    let name = unsafe { CStr::from_ptr(name) };
    let (text, status) = match caught(|| item::<M>(name)) {
        Ok(Some(Ok(text))) => (text, 0),
        Ok(Some(Err(why))) | Err(why) => (why, CANNOT),
        Ok(None) => return 1,
    };
    // SAFETY: the caller's sink with its own context, and bytes that live during the call.
    unsafe { sink(context, text.as_ptr(), text.len()) };
    status
}
