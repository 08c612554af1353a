//! A shared library, loaded for itself alone.

use std::ffi::{CStr, c_char, c_void};
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[cfg(unix)]
use libloading::os::unix as os;
#[cfg(windows)]
use libloading::os::windows as os;

use crate::archive::Unpacked;
use crate::error::{Error, Result};

/// A loaded library. It is unloaded before its folder is removed, since fields are dropped in order.
pub(super) struct Library {
    handle: os::Library,
    /// Its file.
    pub(super) path: PathBuf,
    _unpacked: Arc<Unpacked>,
}

impl Library {
    /// Loads a library so that its symbols serve nobody else, and all that it needs must be there now rather than
    /// in the middle of a run.
    pub(super) fn open(path: &Path, unpacked: Arc<Unpacked>) -> Result<Self> {
        #[cfg(unix)]
        // SAFETY: the library's initializers run; that they are sound is what loading an FMU trusts its author with.
        let handle = unsafe { os::Library::open(Some(path), os::RTLD_NOW | os::RTLD_LOCAL) };
        #[cfg(windows)]
        // SAFETY: as above. The flag makes libraries beside the binary be found.
        let handle = unsafe { os::Library::load_with_flags(path, os::LOAD_WITH_ALTERED_SEARCH_PATH) };
        let handle = handle.map_err(|error| {
            use std::error::Error as _;
            let reason = error.source().map_or_else(|| error.to_string(), ToString::to_string);
            Error::Load { path: path.to_owned(), reason }
        })?;
        Ok(Self { handle, path: path.to_owned(), _unpacked: unpacked })
    }

    /// The address of a symbol, or NULL.
    pub(super) fn address(&self, name: &str) -> *mut c_void {
        // SAFETY: the symbol is only taken as an address here; who uses it must know its type.
        match unsafe { self.handle.get::<*mut c_void>(name) } {
            Ok(symbol) => symbol.as_raw_ptr(),
            Err(_) => std::ptr::null_mut(),
        }
    }

    /// Refuses a library that lacks functions or says that it is of another version.
    pub(super) fn check(
        &self,
        version: &'static str,
        required: &[(&'static str, bool)],
        get_version: Option<unsafe extern "C" fn() -> *const c_char>,
    ) -> Result<()> {
        let symbols: Vec<_> = required.iter().filter(|(_, found)| !found).map(|&(name, _)| name).collect();
        if !symbols.is_empty() {
            return Err(Error::MissingSymbol { path: self.path.clone(), symbols, version });
        }
        // SAFETY: the function is the standard's, takes nothing, and may be called at any time.
        let answer = get_version.map(|get_version| unsafe { get_version() }).unwrap_or(std::ptr::null());
        // SAFETY: the standard promises a string that ends with a NUL and stays; NULL is looked for first.
        let answer = if answer.is_null() { c"" } else { unsafe { CStr::from_ptr(answer) } }.to_string_lossy();
        if answer.chars().next() != version.chars().next() {
            let reason = format!("modelDescription.xml is of FMI {version}, but the binary says it is of `{answer}`");
            return Err(Error::Load { path: self.path.clone(), reason });
        }
        Ok(())
    }
}
