//! Configuration Mode and structural parameters in FMI 3.0.

use swayless_abi::fmi3::*;

use crate::model::Model;
use crate::phase::Call;
use crate::raw::call;

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3EnterConfigurationMode<M: Model>(instance: Instance) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(instance, Call::EnterConfigurationMode, "fmi3EnterConfigurationMode", |instance| {
            instance.enter_configuration()
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3ExitConfigurationMode<M: Model>(instance: Instance) -> Status {
    // SAFETY: the importer's instance.
    unsafe {
        call::<M>(instance, Call::ExitConfigurationMode, "fmi3ExitConfigurationMode", |instance| {
            instance.exit_configuration()
        })
    }
}
