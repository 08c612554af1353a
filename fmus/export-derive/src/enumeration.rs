//! `#[derive(Enumeration)]`.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Data, DeriveInput, Error, Fields, Result};

use crate::attributes::documentation;

pub fn expand(input: DeriveInput) -> Result<TokenStream> {
    let name = &input.ident;
    let Data::Enum(data) = &input.data else {
        return Err(Error::new(name.span(), "an enumeration is an enum"));
    };
    let mut items = Vec::new();
    let mut values = Vec::new();
    for (position, variant) in data.variants.iter().enumerate() {
        let ident = &variant.ident;
        if !matches!(variant.fields, Fields::Unit) || variant.discriminant.is_some() {
            return Err(Error::new(
                ident.span(),
                "an item of an enumeration has neither fields nor a value of its own",
            ));
        }
        let text = ident.to_string();
        let description = documentation(&variant.attrs, ident)?;
        let value = i32::try_from(position + 1)
            .map_err(|_| Error::new(ident.span(), "an enumeration has fewer items than that"))?;
        items.push(quote! { (#text, #description) });
        values.push(quote! { #value => Some(Self::#ident) });
    }
    let text = name.to_string();
    Ok(quote! {
        impl ::swayless_export::Enumeration for #name {
            const NAME: &'static str = #text;
            const ITEMS: &'static [(&'static str, &'static str)] = &[#(#items),*];
            fn value(self) -> i32 {
                self as i32 + 1
            }
            fn from_value(value: i32) -> Option<Self> {
                match value {
                    #(#values,)*
                    _ => None,
                }
            }
        }
    })
}
