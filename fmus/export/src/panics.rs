//! Panics that end at the boundary to C: caught, told with their place, and kept from the host's stderr.

use std::any::Any;
use std::cell::Cell;
use std::mem::ManuallyDrop;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    /// How many calls of [`caught`] are under way on this thread.
    static DEPTH: Cell<usize> = const { Cell::new(0) };
    /// Where the last panic in one of them was. Nothing is dropped with the thread: a destructor registered for it would
    /// keep the library from being unloaded.
    static PLACE: Cell<ManuallyDrop<String>> = const { Cell::new(ManuallyDrop::new(String::new())) };
}

/// Runs something and returns what a panic in it said, and where it was.
///
/// A hook keeps the panic quiet: stderr is the host's. It changes no more than this library, which has its own copy of
/// Rust's standard library; where several share one, as in unit tests, other panics go to the hook that was there.
pub fn caught<T>(body: impl FnOnce() -> T) -> Result<T, String> {
    static HOOK: Once = Once::new();
    HOOK.call_once(keep_quiet);
    DEPTH.set(DEPTH.get() + 1);
    // What a panic leaves half done is the caller's to lock away.
    let outcome = catch_unwind(AssertUnwindSafe(body));
    DEPTH.set(DEPTH.get() - 1);
    outcome.map_err(told)
}

fn keep_quiet() {
    let other = take_hook();
    set_hook(Box::new(move |panic| if DEPTH.get() == 0 { other(panic) } else { remember(panic) }));
}

#[cold]
#[inline(never)]
fn told(panic: Box<dyn Any + Send>) -> String {
    format!("{}{}", reason(panic), ManuallyDrop::into_inner(PLACE.take()))
}

fn remember(panic: &PanicHookInfo<'_>) {
    let place = panic.location().map(|at| format!(" ({}:{})", at.file(), at.line())).unwrap_or_default();
    drop(ManuallyDrop::into_inner(PLACE.replace(ManuallyDrop::new(place))));
}

/// What a panic said.
fn reason(panic: Box<dyn Any + Send>) -> String {
    panic.downcast::<String>().map(|text| *text).unwrap_or_else(|panic| match panic.downcast::<&str>() {
        Ok(text) => (*text).to_owned(),
        Err(panic) => {
            // What was thrown may be anything, a thing that panics when it is dropped included.
            std::mem::forget(panic);
            "no reason given".to_owned()
        }
    })
}
