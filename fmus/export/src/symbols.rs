//! `export_fmu!`: the C symbols of an FMU library.

/// Makes all functions of FMI 2.0 and FMI 3.0 and `swayless_describe` from a [`Model`](crate::Model); stands once at
/// the end of an FMU crate.
#[macro_export]
macro_rules! export_fmu {
    ($model:ident) => {
        $crate::abi::fmi2_functions! { [$crate::c_symbols] $model fmi2 }
        $crate::abi::fmi3_functions! { [$crate::c_symbols] $model fmi3 }

        /// Describes the FMU to the packager.
        ///
        /// # Safety
        /// The name is NULL or ends with a NUL; the sink takes the context.
        #[unsafe(no_mangle)]
        unsafe extern "C" fn swayless_describe(
            name: *const ::core::ffi::c_char,
            sink: ::core::option::Option<$crate::abi::describe::Sink>,
            context: *mut ::core::ffi::c_void,
        ) -> ::core::ffi::c_int {
            // SAFETY: the caller's promise.
            unsafe { $crate::swayless_describe::<$model>(name, sink, context) }
        }
    };
}

/// Makes the C symbols of one FMI version from its table of functions.
#[macro_export]
#[doc(hidden)]
macro_rules! c_symbols {
    ([$model:ident $version:ident] $(fn $name:ident($($argument:ident: $type:ty),*) $(-> $return:ty)?;)*) => {
        #[allow(non_snake_case, clippy::too_many_arguments, reason = "names and signatures are the standard's")]
        const _: () = {
            use $crate::abi::$version::*;
            $(
                #[unsafe(no_mangle)]
                unsafe extern "C" fn $name($($argument: $type),*) $(-> $return)? {
                    // SAFETY: the importer keeps to the standard, which is what the function asks for.
                    unsafe { $crate::$version::$name::<$model>($($argument),*) }
                }
            )*
        };
    };
}
