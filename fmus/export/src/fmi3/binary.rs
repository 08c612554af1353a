//! Binary variables in FMI 3.0: no model has any, so the functions succeed for no variables only.

use swayless_abi::fmi3::*;

use super::values::none_of;
use crate::model::Model;
use crate::phase::Call;
use crate::raw::call;

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
}
