//! `swayless_describe`: what the packager asks a library for.

use std::ffi::{CStr, c_char, c_int, c_void};

use swayless_abi::describe::{CLOCKED, DOCUMENTATION, FMI2, FMI3, ICON, Sink, TERMINALS};
use swayless_modeldesc::types::FmiVersion;

use crate::description;
use crate::model::Model;
use crate::panics::caught;
use crate::token::Variant;

/// An item of the description of a model.
fn item<M: Model>(name: &CStr) -> Option<String> {
    let xml = |version, variant| swayless_modeldesc::write::write(&description::of::<M>(version, variant)).ok();
    match name {
        name if name == FMI2 => xml(FmiVersion::V2, Variant::Plain),
        name if name == FMI3 => xml(FmiVersion::V3, Variant::Plain),
        name if name == CLOCKED && !M::CLOCKS.is_empty() => xml(FmiVersion::V3, Variant::Clocked),
        name if name == TERMINALS => swayless_modeldesc::terminals::write(&description::terminals::of::<M>()).ok(),
        name if name == DOCUMENTATION => Some(M::INFO.documentation.to_string()),
        name if name == ICON => Some(M::INFO.icon.to_string()),
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
    match caught(|| item::<M>(name)) {
        Ok(Some(text)) => {
            // SAFETY: the caller's sink with its own context, and bytes that live during the call.
            unsafe { sink(context, text.as_ptr(), text.len()) };
            0
        }
        _ => 1,
    }
}
