//! Saving and restoring the state of an instance in FMI 3.0.

use swayless_abi::fmi3::*;

use crate::model::Model;
use crate::raw_state;

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetFMUState<M: Model>(instance: Instance, state: *mut FMUState) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::get::<M>(instance, state, "fmi3GetFMUState") }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3SetFMUState<M: Model>(instance: Instance, state: FMUState) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::set::<M>(instance, state, "fmi3SetFMUState") }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3FreeFMUState<M: Model>(instance: Instance, state: *mut FMUState) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::free::<M>(instance, state, "fmi3FreeFMUState") }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3SerializedFMUStateSize<M: Model>(instance: Instance, state: FMUState, size: *mut usize) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::size::<M>(instance, state, size, "fmi3SerializedFMUStateSize") }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3SerializeFMUState<M: Model>(
    instance: Instance,
    state: FMUState,
    bytes: *mut Byte,
    size: usize,
) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::serialize::<M>(instance, state, bytes, size, "fmi3SerializeFMUState") }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3DeserializeFMUState<M: Model>(
    instance: Instance,
    bytes: *const Byte,
    size: usize,
    state: *mut FMUState,
) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::deserialize::<M>(instance, bytes, size, state, "fmi3DeserializeFMUState") }
}
