//! Scheduled execution in FMI 3.0.

use swayless_abi::fmi3::*;

use crate::model::Model;
use crate::phase::{Call, Phase};
use crate::raw::{call, callback, surroundings};

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3ActivateModelPartition<M: Model>(
    instance: Instance,
    clock_reference: ValueReference,
    activation_time: Float64,
) -> Status {
    // SAFETY: the instance is the importer's.
    unsafe {
        let surroundings = surroundings::<M>(instance);
        let mut news = false;
        let status = call::<M>(instance, Call::ActivateModelPartition, "fmi3ActivateModelPartition", |instance| {
            news = instance.activate_partition(clock_reference, activation_time)?;
            if news && surroundings.clock_update.is_some() {
                instance.phase = Phase::ClockUpdate;
            }
            Ok(())
        });
        let Some(update) = surroundings.clock_update.filter(|_| news) else { return status };
        // No reference to the instance is held: the importer asks it for clocks and intervals.
        callback::<M, _>(instance, || update(surroundings.environment));
        call::<M>(instance, Call::EndClockUpdate, "fmi3ActivateModelPartition", |instance| {
            instance.phase = Phase::ClockActivation;
            Ok(())
        })
    }
}
