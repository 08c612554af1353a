//! Derive macros for the variables of a model: `Variables` and `Enumeration` of `swayless-export`.
//!
//! A field is declared once, as in
//!
//! ```text
//! /// Length of the boom.
//! #[variable(unit = "m", start = 18.0, min = 0.1)]
//! length: R,
//! ```
//!
//! and from that come its storage, its value reference, both model descriptions and the instantiation token. What a
//! field is follows from its type: `R` is a real number, `bool`, `i32` and `String` are what they say,
//! `u32` is a structural parameter (the length of arrays that name it with `length = "…"`), `[T; N]` is an
//! array of one of them or of an enumeration, another type with a `#[variable]` attribute is an enumeration, and one without is a group.

mod attributes;
mod enumeration;
mod field;
mod variables;

use proc_macro::TokenStream;
use syn::{DeriveInput, parse_macro_input};

/// Implements `Variables` for a struct of named fields, each with its documentation.
#[proc_macro_derive(Variables, attributes(variable))]
pub fn derive_variables(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    variables::expand(input).unwrap_or_else(syn::Error::into_compile_error).into()
}

/// Implements `Enumeration` for an enum of unit variants, each with its documentation; the values count from 1.
#[proc_macro_derive(Enumeration)]
pub fn derive_enumeration(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    enumeration::expand(input).unwrap_or_else(syn::Error::into_compile_error).into()
}
