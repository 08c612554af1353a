//! A memory that panics when it is copied, saved or freed, if it is told to.

use serde::{Deserialize, Serialize, Serializer};

/// What the parameter said at the last event.
#[derive(Default, Deserialize)]
pub struct Memory {
    pub fault: String,
}

impl Memory {
    fn fault(&self, place: &str) {
        assert!(self.fault != place, "a fault in {place} of the memory, as wanted");
    }
}

impl Clone for Memory {
    fn clone(&self) -> Self {
        self.fault("clone");
        Self { fault: self.fault.clone() }
    }
}

impl Serialize for Memory {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Plain<'a> {
            fault: &'a str,
        }
        self.fault("serialize");
        Plain { fault: &self.fault }.serialize(serializer)
    }
}

impl Drop for Memory {
    fn drop(&mut self) {
        // A second panic while a first one is on its way would abort the process, in Rust as it is.
        if !std::thread::panicking() {
            self.fault("drop");
        }
    }
}
