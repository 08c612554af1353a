//! Saving and restoring the state of an instance in FMI 2.0.

use swayless_abi::fmi2::*;

use crate::model::Model;
use crate::raw_state;

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetFMUstate<M: Model>(instance: Component, state: *mut FMUstate) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::get::<M>(instance, state, "fmi2GetFMUstate") }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2SetFMUstate<M: Model>(instance: Component, state: FMUstate) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::set::<M>(instance, state, "fmi2SetFMUstate") }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2FreeFMUstate<M: Model>(instance: Component, state: *mut FMUstate) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::free::<M>(instance, state, "fmi2FreeFMUstate") }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2SerializedFMUstateSize<M: Model>(instance: Component, state: FMUstate, size: *mut usize) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::size::<M>(instance, state, size, "fmi2SerializedFMUstateSize") }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2SerializeFMUstate<M: Model>(
    instance: Component,
    state: FMUstate,
    bytes: *mut Byte,
    size: usize,
) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::serialize::<M>(instance, state, bytes.cast(), size, "fmi2SerializeFMUstate") }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2DeSerializeFMUstate<M: Model>(
    instance: Component,
    bytes: *const Byte,
    size: usize,
    state: *mut FMUstate,
) -> Status {
    // SAFETY: instance, states and places are the importer's, as the standard specifies.
    unsafe { raw_state::deserialize::<M>(instance, bytes.cast(), size, state, "fmi2DeSerializeFMUstate") }
}
