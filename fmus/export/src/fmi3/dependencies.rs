//! Dependencies of single elements in FMI 3.0.

use swayless_abi::fmi3::*;

use crate::dependencies::Dependency;
use crate::instance::Refusal;
use crate::model::Model;
use crate::phase::Call;
use crate::raw::{call, put, slice_mut};

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
pub unsafe fn fmi3GetNumberOfVariableDependencies<M: Model>(
    instance: Instance,
    value_reference: ValueReference,
    n_dependencies: *mut usize,
) -> Status {
    // SAFETY: the instance and the place for the answer are the importer's.
    unsafe {
        call::<M>(instance, Call::GetDependencies, "fmi3GetNumberOfVariableDependencies", |instance| {
            put(n_dependencies, instance.dependencies(value_reference)?.len());
            Ok(())
        })
    }
}

/// See [`fmi3GetVersion`](super::fmi3GetVersion).
#[allow(clippy::too_many_arguments, reason = "the signature is the standard's")]
pub unsafe fn fmi3GetVariableDependencies<M: Model>(
    instance: Instance,
    dependent: ValueReference,
    element_indices_of_dependent: *mut usize,
    independents: *mut ValueReference,
    element_indices_of_independents: *mut usize,
    dependency_kinds: *mut DependencyKind,
    n_dependencies: usize,
) -> Status {
    // SAFETY: the instance and the arrays are the importer's, as the standard specifies.
    unsafe {
        call::<M>(instance, Call::GetDependencies, "fmi3GetVariableDependencies", |instance| {
            let found = instance.dependencies(dependent)?;
            if found.len() != n_dependencies {
                let (found, given) = (found.len(), n_dependencies);
                return Err(Refusal::error(format!("there are {found} dependencies, but room for {given}")));
            }
            let elements = slice_mut(element_indices_of_dependent, n_dependencies, "elementIndicesOfDependent")?;
            let references = slice_mut(independents, n_dependencies, "independents")?;
            let others = slice_mut(element_indices_of_independents, n_dependencies, "elementIndicesOfIndependents")?;
            let kinds = slice_mut(dependency_kinds, n_dependencies, "dependencyKinds")?;
            for (i, Dependency { element, on, on_element, kind }) in found.into_iter().enumerate() {
                (elements[i], references[i], others[i], kinds[i]) = (element, on, on_element, kind.into());
            }
            Ok(())
        })
    }
}
