//! Clocks and their intervals in FMI 3.0.

use swayless_abi::fmi3::*;

use crate::instance::{Instance as Runtime, Refusal};
use crate::model::Model;
use crate::phase::Call;
use crate::raw::{call, slice, slice_mut};

/// Makes a function that reads a value of each clock.
macro_rules! getters {
    ($($name:ident, $call:ident, $type:ty, $method:ident;)*) => { $(
        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        pub unsafe fn $name<M: Model>(
            instance: Instance,
            value_references: *const ValueReference,
            n_value_references: usize,
            values: *mut $type,
        ) -> Status {
            // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
            unsafe {
                call::<M>(instance, Call::$call, stringify!($name), |instance| {
                    let references = slice(value_references, n_value_references, "valueReferences")?;
                    let values = slice_mut(values, n_value_references, "values")?;
                    for (reference, value) in references.iter().zip(values) {
                        *value = Runtime::$method(instance, *reference)?.into();
                    }
                    Ok(())
                })
            }
        }
    )* };
}

/// Makes a function that sets a value of each clock.
macro_rules! setters {
    ($($name:ident, $call:ident, $type:ty, $method:ident, $to_value:expr;)*) => { $(
        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        pub unsafe fn $name<M: Model>(
            instance: Instance,
            value_references: *const ValueReference,
            n_value_references: usize,
            values: *const $type,
        ) -> Status {
            // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
            unsafe {
                call::<M>(instance, Call::$call, stringify!($name), |instance| {
                    let references = slice(value_references, n_value_references, "valueReferences")?;
                    let values = slice(values, n_value_references, "values")?;
                    for (reference, value) in references.iter().zip(values) {
                        Runtime::$method(instance, *reference, $to_value(*value))?;
                    }
                    Ok(())
                })
            }
        }
    )* };
}

getters! {
    fmi3GetClock, GetClock, Clock, get_clock;
    fmi3GetShiftDecimal, GetShift, Float64, clock_shift;
}

setters! {
    fmi3SetClock, SetClock, Clock, set_clock, |active| active != 0;
    fmi3SetIntervalDecimal, SetInterval, Float64, set_interval, |interval| interval;
    fmi3SetShiftDecimal, SetShift, Float64, set_clock_shift, |shift| shift;
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetIntervalDecimal<M: Model>(
    instance: Instance,
    value_references: *const ValueReference,
    n_value_references: usize,
    intervals: *mut Float64,
    qualifiers: *mut IntervalQualifier,
) -> Status {
    // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
    unsafe {
        call::<M>(instance, Call::GetInterval, "fmi3GetIntervalDecimal", |instance| {
            let references = slice(value_references, n_value_references, "valueReferences")?;
            let intervals = slice_mut(intervals, n_value_references, "intervals")?;
            let qualifiers = slice_mut(qualifiers, n_value_references, "qualifiers")?;
            for ((reference, interval), qualifier) in references.iter().zip(intervals).zip(qualifiers) {
                let (value, known) = instance.tell_interval(*reference)?;
                (*interval, *qualifier) = (value, known as IntervalQualifier);
            }
            Ok(())
        })
    }
}

/// Functions for fractions: every clock has `supportsFraction="false"`, so they succeed for no clocks only.
macro_rules! of_fractions {
    ($($name:ident, $call:ident($($type:ty),*);)*) => { $(
        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        pub unsafe fn $name<M: Model>(
            instance: Instance,
            value_references: *const ValueReference,
            n_value_references: usize,
            $(_: $type),*
        ) -> Status {
            // SAFETY: the instance and the array are the importer's, as the standard specifies.
            unsafe {
                call::<M>(instance, Call::$call, stringify!($name), |instance| {
                    match slice(value_references, n_value_references, "valueReferences")?.first() {
                        None => Ok(()),
                        Some(reference) => {
                            let (_, clock) = instance.clock(*reference)?;
                            Err(Refusal::error(format!(
                                "{}: clock {} does not support fractions; use the decimal function",
                                stringify!($name),
                                clock.name
                            )))
                        }
                    }
                })
            }
        }
    )* };
}

of_fractions! {
    fmi3GetIntervalFraction, GetInterval(*mut UInt64, *mut UInt64, *mut IntervalQualifier);
    fmi3SetIntervalFraction, SetInterval(*const UInt64, *const UInt64);
    fmi3GetShiftFraction, GetShift(*mut UInt64, *mut UInt64);
    fmi3SetShiftFraction, SetShift(*const UInt64, *const UInt64);
}
