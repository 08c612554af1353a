//! The importer's log callback of FMI 3.0.

use std::sync::Arc;

use swayless_abi::fmi3::{InstanceEnvironment, LogMessageCallback};

use crate::log::{Log, Sink};
use crate::raw::{c_text, message};

struct Logger {
    callback: LogMessageCallback,
    environment: InstanceEnvironment,
}

// SAFETY: the environment is never followed here, only handed back; that the callback may be called from the thread
// that steps the instance is the importer's part of the contract (FMI 3.0.2, 2.3.1).
unsafe impl Send for Logger {}
// SAFETY: as above; one instance is used by one thread at a time.
unsafe impl Sync for Logger {}

impl Sink for Logger {
    fn emit(&self, _instance: &str, status: i32, category: &str, text: &str) {
        let Some(callback) = self.callback else { return };
        let (category, text) = (c_text(category), message(text));
        // SAFETY: the importer's callback with its own environment and texts that live during the call.
        unsafe { callback(self.environment, status, category.as_ptr(), text.as_ptr()) };
    }
}

/// The log that calls the importer's callback, which may be missing.
pub fn log(callback: LogMessageCallback, environment: InstanceEnvironment, on: bool) -> Log {
    Log::new(Arc::new(Logger { callback, environment }), on)
}
