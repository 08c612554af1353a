//! What a field of a `Variables` struct is.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Error, Expr, Field, Ident, LitStr, Result, Type};

use crate::attributes::{Attributes, documentation};

/// A field, with what it takes to generate code for it.
pub struct Variable {
    pub ident: Ident,
    pub name: String,
    pub description: String,
    pub kind: Kind,
    pub attributes: Attributes,
}

pub enum Kind {
    /// A nested struct of variables.
    Group(Type),
    /// A scalar of the type.
    Scalar(Leaf),
    /// An array: its element type and length.
    Array(Leaf, Expr),
}

/// The type of a scalar.
pub enum Leaf {
    Real,
    Boolean,
    Integer,
    /// The length of arrays.
    Size,
    Text,
    Enumeration(Box<Type>),
}

impl Variable {
    /// Reads a field; `real` is the name of the struct's scalar type parameter.
    pub fn read(field: &Field, real: Option<&Ident>) -> Result<Self> {
        let ident = field.ident.clone().ok_or_else(|| Error::new(field.span(), "variables have names"))?;
        let attributes = Attributes::read(&field.attrs)?;
        let kind = match &field.ty {
            Type::Array(array) => {
                let leaf = leaf(&array.elem, real).unwrap_or_else(|| Leaf::Enumeration(array.elem.clone()));
                Kind::Array(leaf, array.len.clone())
            }
            other => match leaf(other, real) {
                Some(leaf) => Kind::Scalar(leaf),
                None if attributes.present => Kind::Scalar(Leaf::Enumeration(Box::new(other.clone()))),
                None => Kind::Group(other.clone()),
            },
        };
        let description = match kind {
            Kind::Group(_) => String::new(),
            _ => documentation(&field.attrs, &ident)?,
        };
        let field = || ident.to_string().trim_start_matches("r#").to_string();
        let name = attributes.name.as_ref().map_or_else(field, LitStr::value);
        Ok(Self { ident, name, description, kind, attributes })
    }

    /// How many scalars the field holds.
    pub fn count(&self) -> TokenStream {
        match &self.kind {
            Kind::Group(group) => quote! { <#group as ::swayless_export::Variables<R>>::COUNT },
            Kind::Scalar(_) => quote! { 1usize },
            Kind::Array(_, length) => quote! { (#length) },
        }
    }

    /// The start value, as the field's type.
    pub fn start(&self) -> Result<TokenStream> {
        let given = self.attributes.start.as_ref();
        let one = |leaf: &Leaf| -> Result<TokenStream> {
            Ok(match (leaf, given) {
                (Leaf::Real, Some(value)) => quote_spanned! { value.span() => <R as From<f64>>::from(#value) },
                (Leaf::Real, None) => quote! { <R as From<f64>>::from(0.0) },
                (Leaf::Text, Some(value)) => quote! { ::std::string::String::from(#value) },
                (Leaf::Text, None) => quote! { ::std::string::String::new() },
                (Leaf::Enumeration(_), None) => {
                    return Err(Error::new(self.ident.span(), "an enumeration needs a start value"));
                }
                (_, Some(value)) => quote! { #value },
                (Leaf::Boolean, None) => quote! { false },
                (Leaf::Integer, None) => quote! { 0i32 },
                (Leaf::Size, None) => quote! { 0u32 },
            })
        };
        Ok(match &self.kind {
            Kind::Group(group) => quote! { <#group as ::swayless_export::Variables<R>>::start() },
            Kind::Scalar(leaf) => one(leaf)?,
            Kind::Array(Leaf::Real, length) if matches!(given, Some(Expr::Array(_))) => {
                quote! { { let start: [f64; #length] = #given; start.map(<R as From<f64>>::from) } }
            }
            Kind::Array(_, _) if matches!(given, Some(Expr::Array(_))) => quote! { #given },
            Kind::Array(leaf, _) => {
                let element = one(leaf)?;
                quote! { ::std::array::from_fn(|_| #element) }
            }
        })
    }
}

fn leaf(of: &Type, real: Option<&Ident>) -> Option<Leaf> {
    let Type::Path(path) = of else { return None };
    let ident = path.path.get_ident()?;
    if real.is_some_and(|real| real == ident) {
        return Some(Leaf::Real);
    }
    match ident.to_string().as_str() {
        "bool" => Some(Leaf::Boolean),
        "i32" => Some(Leaf::Integer),
        "u32" => Some(Leaf::Size),
        "String" => Some(Leaf::Text),
        _ => None,
    }
}
