//! Directional and adjoint derivatives, and derivatives of outputs over time, in FMI 3.0.

use swayless_abi::fmi3::*;

use super::values::each_scalar;
use crate::instance::{Instance as Runtime, Refusal};
use crate::layout::Layout;
use crate::model::Model;
use crate::phase::Call;
use crate::raw::{call, first_order, slice, slice_mut};

/// The numbers of the scalars of variables, arrays being as many as they have elements.
fn numbers<M: Model>(instance: &Runtime<M>, references: &[ValueReference]) -> Result<Vec<usize>, Refusal> {
    let mut numbers = Vec::new();
    each_scalar::<M>(instance.sizes.as_deref(), references, None, |_, block, index| {
        numbers.push(Layout::<M>::first(block) + index);
        Ok(())
    })?;
    Ok(numbers)
}

macro_rules! derivatives {
    ($($name:ident, $method:ident;)*) => { $(
        /// See [`fmi3GetVersion`](super::fmi3GetVersion).
        #[allow(clippy::too_many_arguments, reason = "the signature is the standard's")]
        pub unsafe fn $name<M: Model>(
            instance: Instance,
            unknowns: *const ValueReference,
            n_unknowns: usize,
            knowns: *const ValueReference,
            n_knowns: usize,
            seed: *const Float64,
            n_seed: usize,
            sensitivity: *mut Float64,
            n_sensitivity: usize,
        ) -> Status {
            // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
            unsafe {
                call::<M>(instance, Call::GetDerivative, stringify!($name), |instance| {
                    let unknowns = numbers(instance, slice(unknowns, n_unknowns, "unknowns")?)?;
                    let knowns = numbers(instance, slice(knowns, n_knowns, "knowns")?)?;
                    let seed = slice(seed, n_seed, "seed")?;
                    let sensitivity = slice_mut(sensitivity, n_sensitivity, "sensitivity")?;
                    Runtime::$method(instance, &unknowns, &knowns, seed, sensitivity)
                })
            }
        }
    )* };
}

derivatives! {
    fmi3GetDirectionalDerivative, directional;
    fmi3GetAdjointDerivative, adjoint;
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetOutputDerivatives<M: Model>(
    instance: Instance,
    value_references: *const ValueReference,
    n_value_references: usize,
    orders: *const Int32,
    values: *mut Float64,
    n_values: usize,
) -> Status {
    // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
    unsafe {
        call::<M>(instance, Call::GetOutputDerivatives, "fmi3GetOutputDerivatives", |instance| {
            first_order(slice(orders, n_value_references, "orders")?)?;
            let outputs = numbers(instance, slice(value_references, n_value_references, "valueReferences")?)?;
            instance.output_derivatives(&outputs, slice_mut(values, n_values, "values")?)
        })
    }
}
