//! Functions behind capabilities that the model description does not offer: the standard wants them present, and a
//! call is an error of the importer.

use swayless_abi::fmi3::*;

use super::values::none_of;
use crate::model::Model;
use crate::phase::Call;
use crate::raw::call;

macro_rules! not_offered {
    ($($name:ident($($type:ty),*);)*) => { $(
        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        #[allow(clippy::too_many_arguments, reason = "the signature is the standard's")]
        pub unsafe fn $name<M: Model>(instance: Instance, $(_: $type),*) -> Status {
            // SAFETY: the importer's instance.
            unsafe { call::<M>(instance, Call::NotOffered, stringify!($name), |_| Ok(())) }
        }
    )* };
}

not_offered! {
    fmi3GetNumberOfVariableDependencies(ValueReference, *mut usize);
    fmi3GetVariableDependencies(
        ValueReference, *mut usize, *mut ValueReference, *mut usize, *mut DependencyKind, usize
    );
    fmi3EnterConfigurationMode();
    fmi3ExitConfigurationMode();
    fmi3EvaluateDiscreteStates();
    fmi3ActivateModelPartition(ValueReference, Float64);
}

/// Functions on variables of a type that no variable has: they succeed for no variables only.
macro_rules! of_no_variable {
    ($($call:ident $name:ident($($type:ty),*);)*) => { $(
        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        pub unsafe fn $name<M: Model>(
            instance: Instance,
            _: *const ValueReference,
            n_value_references: usize,
            $(_: $type),*
        ) -> Status {
            // SAFETY: the importer's instance.
            unsafe { call::<M>(instance, Call::$call, stringify!($name), |_| none_of(n_value_references, stringify!($name))) }
        }
    )* };
}

of_no_variable! {
    Get fmi3GetBinary(*mut usize, *mut Binary, usize);
    Set fmi3SetBinary(*const usize, *const Binary, usize);
    Get fmi3GetClock(*mut Clock);
    Set fmi3SetClock(*const Clock);
    Get fmi3GetIntervalDecimal(*mut Float64, *mut IntervalQualifier);
    Get fmi3GetIntervalFraction(*mut UInt64, *mut UInt64, *mut IntervalQualifier);
    Get fmi3GetShiftDecimal(*mut Float64);
    Get fmi3GetShiftFraction(*mut UInt64, *mut UInt64);
    Set fmi3SetIntervalDecimal(*const Float64);
    Set fmi3SetIntervalFraction(*const UInt64, *const UInt64);
    Set fmi3SetShiftDecimal(*const Float64);
    Set fmi3SetShiftFraction(*const UInt64, *const UInt64);
}
