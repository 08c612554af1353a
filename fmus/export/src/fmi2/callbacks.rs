//! The importer's logger of FMI 2.0.

use std::sync::Arc;

use swayless_abi::fmi2::{CallbackFunctions, CallbackLogger, ComponentEnvironment};

use crate::log::{Log, Sink};
use crate::raw::{c_text, message};

struct Logger {
    logger: CallbackLogger,
    environment: ComponentEnvironment,
}

// SAFETY: the pointers are never followed here, only handed back; that the logger may be called from the thread that
// steps the instance is the importer's part of the contract (FMI 2.0.5, 2.1.5).
unsafe impl Send for Logger {}
// SAFETY: as above; one instance is used by one thread at a time.
unsafe impl Sync for Logger {}

impl Sink for Logger {
    fn emit(&self, instance: &str, status: i32, category: &str, text: &str) {
        let Some(logger) = self.logger else { return };
        let (instance, category, text) = (c_text(instance), c_text(category), message(text));
        // SAFETY: the importer's logger with its own environment and texts that live during the call. It is
        // printf-like, so the message goes through "%s".
        unsafe {
            logger(self.environment, instance.as_ptr(), status, category.as_ptr(), c"%s".as_ptr(), text.as_ptr());
        }
    }
}

/// The log that calls the importer's logger, which may be missing.
///
/// # Safety
/// `functions` is NULL or points to the importer's callbacks.
pub unsafe fn log(functions: *const CallbackFunctions, on: bool) -> Log {
    // SAFETY: the caller's promise.
    let functions = unsafe { functions.as_ref() };
    let logger = functions.and_then(|functions| functions.logger);
    let environment = functions.map_or(std::ptr::null_mut(), |functions| functions.component_environment);
    Log::new(Arc::new(Logger { logger, environment }), on)
}
