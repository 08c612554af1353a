//! Getting and setting variables in FMI 3.0; an array is one variable with many values.

use swayless_abi::fmi3::*;

use crate::instance::Refusal;
use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::phase::Call;
use crate::raw::{c_text, call, slice, slice_mut, text};
use crate::sizes::Sizes;
use crate::variables::Value;

/// Visits every scalar of the variables with its place among the values; there must be as many of these, if their
/// number is given.
pub(super) fn each_scalar<M: Model>(
    sizes: Option<&Sizes>,
    references: &[ValueReference],
    n_values: Option<usize>,
    mut visit: impl FnMut(usize, Block, usize) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    let mut next = 0;
    for reference in references {
        let found = Layout::<M>::locate(*reference);
        let capacity = found.map_or(0, |(block, index)| Layout::<M>::extent(block, index));
        let Some((block, index)) = found.filter(|_| capacity > 0) else {
            return Err(Refusal::error(format!("there is no variable with value reference {reference}")));
        };
        let extent = sizes.map_or(capacity, |sizes| sizes.extent(Layout::<M>::first(block) + index, capacity));
        // What does not fit is counted on, for the message.
        if n_values.is_none_or(|n| next + extent <= n) {
            for element in 0..extent {
                visit(next + element, block, index + element)?;
            }
        }
        next += extent;
    }
    match n_values {
        Some(n) if n != next => Err(Refusal::error(format!("the variables have {next} values, but nValues is {n}"))),
        _ => Ok(()),
    }
}

#[cold]
#[inline(never)]
fn wrong_type<M: Model>(block: Block, index: usize, function: &str) -> Refusal {
    Refusal::error(format!("{function} was called for {}, which is of another type", Layout::<M>::name(block, index)))
}

/// Makes a getter and a setter of a type that variables can have.
macro_rules! accessors {
    ($type:ty, $variant:ident, $get:ident, $of_value:expr, $set:ident, $to_value:expr) => {
        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        pub unsafe fn $get<M: Model>(
            instance: Instance,
            value_references: *const ValueReference,
            n_value_references: usize,
            values: *mut $type,
            n_values: usize,
        ) -> Status {
            // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
            unsafe {
                call::<M>(instance, Call::Get, stringify!($get), |instance| {
                    let references = slice(value_references, n_value_references, "valueReferences")?;
                    let values = slice_mut(values, n_values, "values")?;
                    let sizes = instance.sizes.clone();
                    each_scalar::<M>(sizes.as_deref(), references, Some(n_values), |place, block, index| {
                        let Value::$variant(value) = instance.get(block, index)? else {
                            return Err(wrong_type::<M>(block, index, stringify!($get)));
                        };
                        values[place] = $of_value(value);
                        Ok(())
                    })
                })
            }
        }

        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        pub unsafe fn $set<M: Model>(
            instance: Instance,
            value_references: *const ValueReference,
            n_value_references: usize,
            values: *const $type,
            n_values: usize,
        ) -> Status {
            // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
            unsafe {
                call::<M>(instance, Call::Set, stringify!($set), |instance| {
                    let references = slice(value_references, n_value_references, "valueReferences")?;
                    let values = slice(values, n_values, "values")?;
                    let sizes = instance.sizes.clone();
                    let all = |visit: &mut dyn FnMut(usize, Block, usize) -> Result<(), Refusal>| {
                        each_scalar::<M>(sizes.as_deref(), references, Some(n_values), visit)
                    };
                    all(&mut |place, block, index| {
                        instance.admit(block, index, Value::$variant($to_value(values[place])))
                    })?;
                    all(&mut |place, block, index| {
                        instance.set(block, index, Value::$variant($to_value(values[place])))
                    })
                })
            }
        }
    };
}

accessors!(Float64, Real, fmi3GetFloat64, |value| value, fmi3SetFloat64, |value| value);
accessors!(Int32, Integer, fmi3GetInt32, |value| value, fmi3SetInt32, |value| value);
accessors!(Boolean, Boolean, fmi3GetBoolean, u8::from, fmi3SetBoolean, |value| value != 0);
// Enumerations are exchanged as Int64. A value no item can have becomes 0, which is none.
accessors!(Int64, Enumeration, fmi3GetInt64, Int64::from, fmi3SetInt64, |value| i32::try_from(value).unwrap_or(0));

// Structural parameters are UInt64. A length no array can have becomes the greatest, which is refused.
accessors!(UInt64, Size, fmi3GetUInt64, UInt64::from, fmi3SetUInt64, |value| u32::try_from(value).unwrap_or(u32::MAX));

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetString<M: Model>(
    instance: Instance,
    value_references: *const ValueReference,
    n_value_references: usize,
    values: *mut String,
    n_values: usize,
) -> Status {
    // SAFETY: the instance and the arrays are the importer's; the texts returned live until the next call.
    unsafe {
        call::<M>(instance, Call::Get, "fmi3GetString", |instance| {
            let references = slice(value_references, n_value_references, "valueReferences")?;
            let values = slice_mut(values, n_values, "values")?;
            instance.returned.clear();
            let sizes = instance.sizes.clone();
            each_scalar::<M>(sizes.as_deref(), references, Some(n_values), |_, block, index| {
                let Value::Text(text) = instance.get(block, index)? else {
                    return Err(wrong_type::<M>(block, index, "fmi3GetString"));
                };
                let text = c_text(text);
                instance.returned.push(text);
                Ok(())
            })?;
            for (text, value) in instance.returned.iter().zip(values) {
                *value = text.as_ptr();
            }
            Ok(())
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3SetString<M: Model>(
    instance: Instance,
    value_references: *const ValueReference,
    n_value_references: usize,
    values: *const String,
    n_values: usize,
) -> Status {
    // SAFETY: the instance, the arrays and the texts are the importer's; the texts are copied.
    unsafe {
        call::<M>(instance, Call::Set, "fmi3SetString", |instance| {
            let references = slice(value_references, n_value_references, "valueReferences")?;
            let values = slice(values, n_values, "values")?;
            let sizes = instance.sizes.clone();
            each_scalar::<M>(sizes.as_deref(), references, Some(n_values), |place, block, index| {
                let value = text(values[place]).ok_or_else(|| Refusal::error("a text to set is NULL"))?;
                instance.set(block, index, Value::Text(&value))
            })
        })
    }
}

/// Makes a getter and a setter of a type that no variable has: they succeed for no variables only.
macro_rules! of_no_variable {
    ($($type:ty, $get:ident, $set:ident;)*) => { $(
        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        pub unsafe fn $get<M: Model>(
            instance: Instance,
            _value_references: *const ValueReference,
            n_value_references: usize,
            _values: *mut $type,
            _n_values: usize,
        ) -> Status {
            // SAFETY: the importer's instance.
            unsafe { call::<M>(instance, Call::Get, stringify!($get), |_| none_of(n_value_references, stringify!($get))) }
        }

        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        pub unsafe fn $set<M: Model>(
            instance: Instance,
            _value_references: *const ValueReference,
            n_value_references: usize,
            _values: *const $type,
            _n_values: usize,
        ) -> Status {
            // SAFETY: the importer's instance.
            unsafe { call::<M>(instance, Call::Set, stringify!($set), |_| none_of(n_value_references, stringify!($set))) }
        }
    )* };
}

of_no_variable! {
    Float32, fmi3GetFloat32, fmi3SetFloat32;
    Int8, fmi3GetInt8, fmi3SetInt8;
    UInt8, fmi3GetUInt8, fmi3SetUInt8;
    Int16, fmi3GetInt16, fmi3SetInt16;
    UInt16, fmi3GetUInt16, fmi3SetUInt16;
    UInt32, fmi3GetUInt32, fmi3SetUInt32;
}

/// Refuses a call for variables of a type that none has.
pub(super) fn none_of(n: usize, function: &str) -> Result<(), Refusal> {
    if n == 0 { Ok(()) } else { Err(Refusal::error(format!("{function}: no variable is of this type"))) }
}
