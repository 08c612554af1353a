//! The state functions, which are the same in both versions but for their names.

use std::ffi::c_void;

use crate::instance::Refusal;
use crate::model::Model;
use crate::phase::Call;
use crate::raw::{call, put, slice, slice_mut};
use crate::snapshot::Snapshot;

fn missing(what: &str) -> Refusal {
    Refusal::error(format!("{what} is NULL"))
}

/// A state that was given out.
///
/// # Safety
/// The pointer is NULL or came from [`get`] or [`deserialize`] for the same model and has not been freed.
unsafe fn given<'a, M: Model>(state: *mut c_void) -> Result<&'a mut Snapshot<M>, Refusal> {
    // SAFETY: the caller's promise.
    unsafe { state.cast::<Snapshot<M>>().as_mut() }.ok_or_else(|| missing("FMUState"))
}

/// Gives a new state out, or puts it into one that was given out before.
///
/// # Safety
/// The place is valid for reading and writing and holds NULL or a state that was given out and not freed.
unsafe fn give<M: Model>(place: *mut *mut c_void, snapshot: Snapshot<M>) {
    // SAFETY: the caller's promise.
    unsafe {
        match given::<M>(*place) {
            Ok(state) => *state = snapshot,
            Err(_) => *place = Box::into_raw(Box::new(snapshot)).cast(),
        }
    }
}

/// `GetFMUState`.
///
/// # Safety
/// As [`call`]; and as [`give`] for a place that is not NULL.
pub unsafe fn get<M: Model>(instance: *mut c_void, place: *mut *mut c_void, function: &str) -> i32 {
    // SAFETY: the caller's promises.
    unsafe {
        call::<M>(instance, Call::State, function, |instance| {
            if place.is_null() {
                return Err(missing("FMUState"));
            }
            give(place, instance.snapshot());
            Ok(())
        })
    }
}

/// `SetFMUState`.
///
/// # Safety
/// As [`call`]; the state was given out and not freed.
pub unsafe fn set<M: Model>(instance: *mut c_void, state: *mut c_void, function: &str) -> i32 {
    // SAFETY: the caller's promises.
    unsafe { call::<M>(instance, Call::State, function, |instance| instance.restore(given::<M>(state)?)) }
}

/// `FreeFMUState`; NULL is nothing to do.
///
/// # Safety
/// As [`call`]; the place is NULL or as for [`give`].
pub unsafe fn free<M: Model>(instance: *mut c_void, place: *mut *mut c_void, function: &str) -> i32 {
    // SAFETY: the caller's promises; the box is the one that `give` made.
    unsafe {
        call::<M>(instance, Call::State, function, |_| {
            if !place.is_null() && !(*place).is_null() {
                drop(Box::from_raw((*place).cast::<Snapshot<M>>()));
                *place = std::ptr::null_mut();
            }
            Ok(())
        })
    }
}

/// `SerializedFMUStateSize`.
///
/// # Safety
/// As [`set`]; the place is NULL or valid for writing.
pub unsafe fn size<M: Model>(instance: *mut c_void, state: *mut c_void, size: *mut usize, function: &str) -> i32 {
    // SAFETY: the caller's promises.
    unsafe {
        call::<M>(instance, Call::State, function, |_| {
            let bytes = given::<M>(state)?.to_bytes()?;
            if size.is_null() {
                return Err(missing("size"));
            }
            put(size, bytes.len());
            Ok(())
        })
    }
}

/// `SerializeFMUState`.
///
/// # Safety
/// As [`set`]; the place has room for as many bytes as announced.
pub unsafe fn serialize<M: Model>(
    instance: *mut c_void,
    state: *mut c_void,
    place: *mut u8,
    room: usize,
    function: &str,
) -> i32 {
    // SAFETY: the caller's promises.
    unsafe {
        call::<M>(instance, Call::State, function, |_| {
            let bytes = given::<M>(state)?.to_bytes()?;
            let room = slice_mut(place, room, "serializedState")?;
            let Some(place) = room.get_mut(..bytes.len()) else {
                let (needed, given) = (bytes.len(), room.len());
                return Err(Refusal::error(format!("the state needs {needed} bytes, but there is room for {given}")));
            };
            place.copy_from_slice(&bytes);
            Ok(())
        })
    }
}

/// `DeserializeFMUState`.
///
/// # Safety
/// As [`get`]; there are as many bytes as announced.
pub unsafe fn deserialize<M: Model>(
    instance: *mut c_void,
    bytes: *const u8,
    n: usize,
    place: *mut *mut c_void,
    function: &str,
) -> i32 {
    // SAFETY: the caller's promises.
    unsafe {
        call::<M>(instance, Call::State, function, |instance| {
            if place.is_null() {
                return Err(missing("FMUState"));
            }
            let snapshot = Snapshot::<M>::from_bytes(slice(bytes, n, "serializedState")?)?;
            instance.check_snapshot(&snapshot)?;
            give(place, snapshot);
            Ok(())
        })
    }
}
