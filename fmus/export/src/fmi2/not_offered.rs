//! Functions behind capabilities that the model description does not offer: the standard wants them present, and a
//! call is an error of the importer.

use swayless_abi::fmi2::*;

use crate::model::Model;
use crate::phase::Call;
use crate::raw::call;

macro_rules! not_offered {
    ($($name:ident($($type:ty),*);)*) => { $(
        /// See [`fmi2GetTypesPlatform`](super::fmi2GetTypesPlatform).
        pub unsafe fn $name<M: Model>(c: Component, $(_: $type),*) -> Status {
            // SAFETY: the importer's instance.
            unsafe { call::<M>(c, Call::NotOffered, stringify!($name), |_| Ok(())) }
        }
    )* };
}

not_offered! {
    fmi2CancelStep();
}
