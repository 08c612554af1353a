//! `#[derive(Variables)]`.

use proc_macro2::TokenStream;
use quote::{format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Data, DeriveInput, Error, Expr, Fields, LitStr, Result};

use crate::attributes::Attributes;
use crate::field::{Kind, Leaf, Variable};

pub fn expand(input: DeriveInput) -> Result<TokenStream> {
    let name = &input.ident;
    let Data::Struct(data) = &input.data else {
        return Err(Error::new(name.span(), "variables are a struct"));
    };
    let Fields::Named(fields) = &data.fields else {
        return Err(Error::new(name.span(), "variables have names: use a struct with named fields"));
    };
    let real = input.generics.type_params().next().map(|parameter| parameter.ident.clone());
    if input.generics.params.len() > usize::from(real.is_some()) || real.as_ref().is_some_and(|real| real != "R") {
        return Err(Error::new(input.generics.span(), "variables have at most one type parameter, `R: Scalar`"));
    }
    let variables =
        fields.named.iter().map(|field| Variable::read(field, real.as_ref())).collect::<Result<Vec<_>>>()?;

    let counts: Vec<_> = variables.iter().map(Variable::count).collect();
    let idents: Vec<_> = variables.iter().map(|v| &v.ident).collect();
    let starts = variables.iter().map(Variable::start).collect::<Result<Vec<_>>>()?;
    let declares = variables.iter().map(declare).collect::<Result<Vec<_>>>()?;
    let gets: Vec<_> = variables.iter().map(get).collect();
    let sets: Vec<_> = variables.iter().map(set).collect();
    let extents: Vec<_> = variables.iter().map(extent).collect();
    let reads: Vec<_> = variables.iter().filter_map(|v| each(v, false)).collect();
    let writes: Vec<_> = variables.iter().filter_map(|v| each(v, true)).collect();
    let of = if real.is_some() {
        quote! { #name<R> }
    } else {
        quote! { #name }
    };
    Ok(quote! {
        #[automatically_derived]
        impl<R: ::swayless_export::Scalar> ::swayless_export::Variables<R> for #of {
            const COUNT: usize = 0 #(+ #counts)*;
            fn start() -> Self {
                Self { #(#idents: #starts),* }
            }
            fn declare(into: &mut ::swayless_export::Declarer) {
                #(#declares)*
            }
            fn get(&self, index: usize) -> ::swayless_export::Value<'_, R> {
                let rest = index;
                #(#gets)*
                unreachable!("there is no variable {rest} behind the last")
            }
            fn set(&mut self, index: usize, value: ::swayless_export::Value<'_, R>) -> bool {
                let rest = index;
                #(#sets)*
                unreachable!("there is no variable {rest} behind the last")
            }
            fn extent(index: usize) -> usize {
                let rest = index;
                #(#extents)*
                unreachable!("there is no variable {rest} behind the last")
            }
            #[inline]
            fn each_real(&self, f: &mut impl FnMut(R)) {
                #(#reads)*
            }
            #[inline]
            fn each_real_mut(&mut self, f: &mut impl FnMut(&mut R)) {
                #(#writes)*
            }
        }
    })
}

/// Runs `body` with `rest` counted from the field's first scalar, when the index falls into the field.
fn within(variable: &Variable, body: TokenStream) -> TokenStream {
    let count = variable.count();
    quote! {
        if rest < #count {
            return #body;
        }
        let rest = rest - #count;
    }
}

fn get(variable: &Variable) -> TokenStream {
    let ident = &variable.ident;
    let value = |leaf: &Leaf, place: TokenStream| match leaf {
        Leaf::Real => quote! { ::swayless_export::Value::Real(#place) },
        Leaf::Boolean => quote! { ::swayless_export::Value::Boolean(#place) },
        Leaf::Integer => quote! { ::swayless_export::Value::Integer(#place) },
        Leaf::Size => quote! { ::swayless_export::Value::Size(#place) },
        Leaf::Text => quote! { ::swayless_export::Value::Text(&#place) },
        Leaf::Enumeration(_) => {
            quote! { ::swayless_export::Value::Enumeration(::swayless_export::Enumeration::value(#place)) }
        }
    };
    let body = match &variable.kind {
        Kind::Group(group) => quote! { <#group as ::swayless_export::Variables<R>>::get(&self.#ident, rest) },
        Kind::Scalar(leaf) => value(leaf, quote! { self.#ident }),
        Kind::Array(leaf, _) => value(leaf, quote! { self.#ident[rest] }),
    };
    within(variable, body)
}

fn set(variable: &Variable) -> TokenStream {
    let ident = &variable.ident;
    let assign = |leaf: &Leaf, place: TokenStream| {
        let (pattern, value) = match leaf {
            Leaf::Real => (quote! { Real(value) }, quote! { Some(value) }),
            Leaf::Boolean => (quote! { Boolean(value) }, quote! { Some(value) }),
            Leaf::Integer => (quote! { Integer(value) }, quote! { Some(value) }),
            Leaf::Size => (quote! { Size(value) }, quote! { Some(value) }),
            Leaf::Text => (quote! { Text(value) }, quote! { Some(::std::string::String::from(value)) }),
            Leaf::Enumeration(of) => {
                (quote! { Enumeration(value) }, quote! { <#of as ::swayless_export::Enumeration>::from_value(value) })
            }
        };
        quote! {
            match value {
                ::swayless_export::Value::#pattern => match #value {
                    Some(value) => {
                        #place = value;
                        true
                    }
                    None => false,
                },
                _ => false,
            }
        }
    };
    let body = match &variable.kind {
        Kind::Group(group) => {
            quote! { <#group as ::swayless_export::Variables<R>>::set(&mut self.#ident, rest, value) }
        }
        Kind::Scalar(leaf) => assign(leaf, quote! { self.#ident }),
        Kind::Array(leaf, _) => assign(leaf, quote! { self.#ident[rest] }),
    };
    within(variable, body)
}

fn extent(variable: &Variable) -> TokenStream {
    let body = match &variable.kind {
        Kind::Group(group) => quote! { <#group as ::swayless_export::Variables<R>>::extent(rest) },
        Kind::Scalar(_) => quote! { 1 },
        Kind::Array(_, length) => quote! { if rest == 0 { #length } else { 0 } },
    };
    within(variable, body)
}

fn each(variable: &Variable, mutable: bool) -> Option<TokenStream> {
    let ident = &variable.ident;
    Some(match (&variable.kind, mutable) {
        (Kind::Group(group), false) => {
            quote! { <#group as ::swayless_export::Variables<R>>::each_real(&self.#ident, f); }
        }
        (Kind::Group(group), true) => {
            quote! { <#group as ::swayless_export::Variables<R>>::each_real_mut(&mut self.#ident, f); }
        }
        (Kind::Scalar(Leaf::Real), false) => quote! { f(self.#ident); },
        (Kind::Scalar(Leaf::Real), true) => quote! { f(&mut self.#ident); },
        (Kind::Array(Leaf::Real, _), false) => quote! { for element in self.#ident { f(element); } },
        (Kind::Array(Leaf::Real, _), true) => quote! { for element in &mut self.#ident { f(element); } },
        _ => return None,
    })
}

fn declare(variable: &Variable) -> Result<TokenStream> {
    let name = &variable.name;
    let (leaf, dimension) = match &variable.kind {
        Kind::Group(group) => {
            if variable.attributes.present {
                return Err(Error::new(variable.ident.span(), "a group has no attributes of its own"));
            }
            return Ok(quote! { into.group(#name, <#group as ::swayless_export::Variables<R>>::declare); });
        }
        Kind::Scalar(leaf) => (leaf, quote! { None }),
        Kind::Array(leaf, length) => (leaf, quote! { Some(#length) }),
    };
    let attributes = &variable.attributes;
    let real = matches!(leaf, Leaf::Real);
    if !real && (attributes.unit.is_some() || attributes.nominal.is_some()) {
        return Err(Error::new(variable.ident.span(), "only a real number has a unit and a nominal value"));
    }
    let kind = match leaf {
        Leaf::Real => quote! { ::swayless_export::Kind::Real },
        Leaf::Boolean => quote! { ::swayless_export::Kind::Boolean },
        Leaf::Integer => quote! { ::swayless_export::Kind::Integer },
        Leaf::Size => quote! { ::swayless_export::Kind::Size },
        Leaf::Text => quote! { ::swayless_export::Kind::Text },
        Leaf::Enumeration(of) => quote! { ::swayless_export::Kind::enumeration::<#of>() },
    };
    let description = &variable.description;
    if matches!(leaf, Leaf::Size) && (attributes.min.is_none() || attributes.max.is_none()) {
        return Err(Error::new(variable.ident.span(), "a structural parameter has min and max"));
    }
    if attributes.length.is_some() && !matches!(variable.kind, Kind::Array(..)) {
        return Err(Error::new(variable.ident.span(), "only an array has a length"));
    }
    let said = said(attributes);
    Ok(quote! {{
        let declaration = into.variable(#name, #description, #kind, #dimension);
        #(declaration.#said;)*
    }})
}

/// What the attributes say, as assignments to the fields of a declaration.
fn said(attributes: &Attributes) -> Vec<TokenStream> {
    let number = |field: &str, value: &Option<Expr>| {
        let field = format_ident!("{field}");
        value.as_ref().map(|value| quote! { #field = Some((#value) as f64) })
    };
    let text = |field: &str, value: &Option<LitStr>| {
        let field = format_ident!("{field}");
        value.as_ref().map(|value| quote! { #field = Some(#value) })
    };
    let flag = |field: &str, value: bool| {
        let field = format_ident!("{field}");
        value.then(|| quote! { #field = true })
    };
    let unit = attributes.unit.as_ref().map(|unit| {
        // A constant, so that an unknown unit fails to compile at its place.
        quote_spanned! { unit.span() => unit = Some(const { &::swayless_export::Unit::named(#unit) }) }
    });
    let depends_on = attributes.depends_on.as_ref().map(|names| quote! { depends_on = Some(&#names) });
    let said = [
        unit,
        number("min", &attributes.min),
        number("max", &attributes.max),
        number("nominal", &attributes.nominal),
        flag("output", attributes.output),
        flag("tunable", attributes.tunable),
        flag("discrete", attributes.discrete),
        flag("calculated", attributes.calculated),
        text("length", &attributes.length),
        text("alias", &attributes.alias),
        text("clock", &attributes.clock),
        depends_on,
    ];
    said.into_iter().flatten().collect()
}
