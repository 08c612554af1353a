//! Ctrl-C and SIGTERM: a run stops after the step under way, so that its files are whole and its folders are removed.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use swayless::Observer;

/// The code that a shell gives to a process that Ctrl-C ended.
pub const INTERRUPTED: u8 = 130;

/// Stops the run that it follows once the user wants to.
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Watches from now on. Who asks twice, because a step does not end, ends the process at once.
    pub fn watch() -> Self {
        let wanted = Arc::new(AtomicBool::new(false));
        let flag = wanted.clone();
        let watched = ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                std::process::exit(INTERRUPTED.into());
            }
        });
        // Without a handler Ctrl-C does what it does anyway.
        drop(watched);
        Self(wanted)
    }
}

impl Observer for Interrupt {
    fn records(&self) -> bool {
        false
    }

    fn stops(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
