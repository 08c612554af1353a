//! Getting and setting variables in FMI 2.0.

use swayless_abi::fmi2::*;

use crate::instance::{Instance, Refusal};
use crate::layout::Layout;
use crate::model::Model;
use crate::phase::Call;
use crate::raw::{c_text, call, slice, slice_mut, text};
use crate::variables::Value;

/// Makes a getter and a setter of a type.
macro_rules! accessors {
    ($type:ty, $get:ident, $of_value:expr, $set:ident, $to_value:expr) => {
        /// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
        pub unsafe fn $get<M: Model>(c: Component, vr: *const ValueReference, nvr: usize, value: *mut $type) -> Status {
            // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
            unsafe {
                call::<M>(c, Call::Get, stringify!($get), |instance| {
                    let references = slice(vr, nvr, "vr")?;
                    let values = slice_mut(value, nvr, "value")?;
                    for (reference, value) in references.iter().zip(values) {
                        let (block, index) = instance.locate(*reference)?;
                        let of_value: fn(Value<'_, f64>) -> Option<$type> = $of_value;
                        *value = of_value(instance.get(block, index)?)
                            .ok_or_else(|| wrong_type::<M>(*reference, stringify!($get)))?;
                    }
                    Ok(())
                })
            }
        }

        /// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
        pub unsafe fn $set<M: Model>(
            c: Component,
            vr: *const ValueReference,
            nvr: usize,
            value: *const $type,
        ) -> Status {
            // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
            unsafe {
                call::<M>(c, Call::Set, stringify!($set), |instance| {
                    let references = slice(vr, nvr, "vr")?;
                    let values = slice(value, nvr, "value")?;
                    let to_value: fn(&Instance<M>, u32, $type) -> Value<'static, f64> = $to_value;
                    for (reference, value) in references.iter().zip(values) {
                        let (block, index) = instance.locate(*reference)?;
                        instance.admit(block, index, to_value(instance, *reference, *value))?;
                    }
                    for (reference, value) in references.iter().zip(values) {
                        let (block, index) = instance.locate(*reference)?;
                        let value = to_value(instance, *reference, *value);
                        instance.set(block, index, value)?;
                    }
                    Ok(())
                })
            }
        }
    };
}

accessors!(
    Real,
    fmi2GetReal,
    |value| match value {
        Value::Real(value) => Some(value),
        _ => None,
    },
    fmi2SetReal,
    |_, _, value| Value::Real(value)
);
accessors!(
    Integer,
    fmi2GetInteger,
    |value| match value {
        Value::Integer(value) | Value::Enumeration(value) => Some(value),
        _ => None,
    },
    fmi2SetInteger,
    |instance, reference, value| if instance.is_enumeration(reference) {
        Value::Enumeration(value)
    } else {
        Value::Integer(value)
    }
);
accessors!(
    Boolean,
    fmi2GetBoolean,
    |value| match value {
        Value::Boolean(value) => Some(value.into()),
        _ => None,
    },
    fmi2SetBoolean,
    |_, _, value| Value::Boolean(value != 0)
);

#[cold]
#[inline(never)]
fn wrong_type<M: Model>(reference: u32, function: &str) -> Refusal {
    let name = Layout::<M>::locate(reference).map(|(block, index)| Layout::<M>::name(block, index));
    Refusal::error(format!("{function} was called for {}, which is of another type", name.unwrap_or_default()))
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetString<M: Model>(
    c: Component,
    vr: *const ValueReference,
    nvr: usize,
    value: *mut String,
) -> Status {
    // SAFETY: the instance and the arrays are the importer's; the texts returned live until the next call.
    unsafe {
        call::<M>(c, Call::Get, "fmi2GetString", |instance| {
            let references = slice(vr, nvr, "vr")?;
            let values = slice_mut(value, nvr, "value")?;
            instance.returned.clear();
            for reference in references {
                let (block, index) = instance.locate(*reference)?;
                let Value::Text(text) = instance.get(block, index)? else {
                    return Err(wrong_type::<M>(*reference, "fmi2GetString"));
                };
                let text = c_text(text);
                instance.returned.push(text);
            }
            for (text, value) in instance.returned.iter().zip(values) {
                *value = text.as_ptr();
            }
            Ok(())
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2SetString<M: Model>(
    c: Component,
    vr: *const ValueReference,
    nvr: usize,
    value: *const String,
) -> Status {
    // SAFETY: the instance, the arrays and the texts are the importer's; the texts are copied.
    unsafe {
        call::<M>(c, Call::Set, "fmi2SetString", |instance| {
            let references = slice(vr, nvr, "vr")?;
            let values = slice(value, nvr, "value")?;
            for (reference, value) in references.iter().zip(values) {
                let (block, index) = instance.locate(*reference)?;
                let value = text(*value).ok_or_else(|| Refusal::error("a text to set is NULL"))?;
                instance.set(block, index, Value::Text(&value))?;
            }
            Ok(())
        })
    }
}
