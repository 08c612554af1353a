//! The importer's side of a function table: one optional pointer per function, found by name.

/// Makes `Functions`, the struct of function pointers, from a table such as [`fmi2_functions!`](crate::fmi2_functions).
#[macro_export]
#[doc(hidden)]
macro_rules! function_pointers {
    ($table:ident) => {
        $table! { [$crate::function_pointers] @struct }
    };
    ([@struct] $(fn $name:ident($($argument:ident: $type:ty),*) $(-> $return:ty)?;)*) => {
        /// The functions of a loaded library; those it lacks are `None`.
        #[allow(non_snake_case, missing_docs, reason = "the names are the standard's, and so is their meaning")]
        #[derive(Debug, Clone, Copy, Default)]
        pub struct Functions {
            $(pub $name: Option<unsafe extern "C" fn($($argument: $type),*) $(-> $return)?>,)*
        }

        impl Functions {
            /// The names of all functions of the standard, in the order of its header.
            pub const NAMES: &[&str] = &[$(stringify!($name)),*];

            /// Looks every function up by name.
            ///
            /// # Safety
            /// What `find` returns for a name is NULL or the address of the function that the standard declares under
            /// that name, and it stays callable for as long as the result is used.
            pub unsafe fn find(mut find: impl FnMut(&str) -> *mut c_void) -> Self {
                Self {
                    $($name: {
                        let address = find(stringify!($name));
                        // SAFETY: an `Option` of a function pointer has the layout of a pointer, NULL being `None`;
                        // that the address has this type is the caller's promise.
                        unsafe {
                            core::mem::transmute::<
                                *mut c_void,
                                Option<unsafe extern "C" fn($($argument: $type),*) $(-> $return)?>,
                            >(address)
                        }
                    },)*
                }
            }
        }
    };
}
