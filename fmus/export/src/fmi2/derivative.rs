//! Directional derivatives, and derivatives of inputs and outputs over time, in FMI 2.0.

use swayless_abi::fmi2::*;

use crate::model::Model;
use crate::phase::Call;
use crate::raw::{call, first_order, slice, slice_mut};

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetDirectionalDerivative<M: Model>(
    c: Component,
    unknowns: *const ValueReference,
    n_unknown: usize,
    knowns: *const ValueReference,
    n_known: usize,
    seed: *const Real,
    sensitivity: *mut Real,
) -> Status {
    // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
    unsafe {
        call::<M>(c, Call::GetDerivative, "fmi2GetDirectionalDerivative", |instance| {
            let numbers = |references: &[ValueReference]| references.iter().map(|r| *r as usize).collect::<Vec<_>>();
            let unknowns = numbers(slice(unknowns, n_unknown, "vUnknown_ref")?);
            let knowns = numbers(slice(knowns, n_known, "vKnown_ref")?);
            let seed = slice(seed, n_known, "dvKnown")?;
            let sensitivity = slice_mut(sensitivity, n_unknown, "dvUnknown")?;
            instance.directional(&unknowns, &knowns, seed, sensitivity)
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2GetRealOutputDerivatives<M: Model>(
    c: Component,
    vr: *const ValueReference,
    nvr: usize,
    order: *const Integer,
    value: *mut Real,
) -> Status {
    // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
    unsafe {
        call::<M>(c, Call::GetOutputDerivatives, "fmi2GetRealOutputDerivatives", |instance| {
            first_order(slice(order, nvr, "order")?)?;
            let outputs: Vec<_> = slice(vr, nvr, "vr")?.iter().map(|reference| *reference as usize).collect();
            instance.output_derivatives(&outputs, slice_mut(value, nvr, "value")?)
        })
    }
}

/// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
pub unsafe fn fmi2SetRealInputDerivatives<M: Model>(
    c: Component,
    vr: *const ValueReference,
    nvr: usize,
    order: *const Integer,
    value: *const Real,
) -> Status {
    // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
    unsafe {
        call::<M>(c, Call::SetInputDerivatives, "fmi2SetRealInputDerivatives", |instance| {
            let (references, orders) = (slice(vr, nvr, "vr")?, slice(order, nvr, "order")?);
            let values = slice(value, nvr, "value")?;
            for ((reference, order), value) in references.iter().zip(orders).zip(values) {
                instance.set_input_derivative(*reference, *order, *value)?;
            }
            Ok(())
        })
    }
}
