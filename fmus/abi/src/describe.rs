//! The one function of ours that every FMU library exports beside the standard's: it describes itself.
//!
//! The packager asks the library for its model descriptions, terminals, documentation and icon, so that what lies in the archive
//! cannot drift from what the library does.

use core::ffi::{c_char, c_int, c_void};

/// The symbol's name.
pub const SYMBOL: &str = "swayless_describe";

/// Takes a piece of the answer: the context given, its bytes and their number. The bytes are valid during the call.
pub type Sink = unsafe extern "C" fn(*mut c_void, *const u8, usize);

/// `swayless_describe(item, sink, context)`: hands the item to the sink in one call and returns 0. An unknown item or a
/// NULL returns 1 without a call; for an item that cannot be made, the sink gets the reason and 2 is returned.
pub type Describe = unsafe extern "C" fn(*const c_char, Option<Sink>, *mut c_void) -> c_int;

/// What is returned for an item that cannot be made.
pub const CANNOT: c_int = 2;

/// `modelDescription.xml` for FMI 2.0.
pub const FMI2: &core::ffi::CStr = c"fmi2/modelDescription.xml";
/// `modelDescription.xml` for FMI 3.0.
pub const FMI3: &core::ffi::CStr = c"fmi3/modelDescription.xml";
/// `modelDescription.xml` of the FMU with clocks, `<Name>Clocked`, for FMI 3.0; most libraries have none.
pub const CLOCKED: &core::ffi::CStr = c"fmi3-clocked";
/// `terminalsAndIcons.xml` of FMI 3.0.
pub const TERMINALS: &core::ffi::CStr = c"fmi3/terminalsAndIcons.xml";
/// The base name under which [`TERMINALS`] refers to the picture of a terminal, which the packager draws.
pub const TERMINAL_PICTURE: &str = "terminal";
/// The documentation page, in Markdown.
pub const DOCUMENTATION: &core::ffi::CStr = c"documentation.md";
/// The icon, in SVG.
pub const ICON: &core::ffi::CStr = c"icon.svg";
