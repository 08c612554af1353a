//! The `#[variable(…)]` attribute and the documentation of a field.

use syn::{Attribute, Error, Expr, Lit, LitStr, Meta, Result};

/// What a `#[variable(…)]` attribute says.
#[derive(Default)]
pub struct Attributes {
    /// Whether the attribute stands there at all.
    pub present: bool,
    pub unit: Option<LitStr>,
    pub start: Option<Expr>,
    pub min: Option<Expr>,
    pub max: Option<Expr>,
    pub nominal: Option<Expr>,
    pub output: bool,
    pub tunable: bool,
    pub discrete: bool,
    pub calculated: bool,
    pub length: Option<LitStr>,
    pub alias: Option<LitStr>,
    pub name: Option<LitStr>,
    pub clock: Option<LitStr>,
    pub depends_on: Option<Expr>,
}

impl Attributes {
    pub fn read(attributes: &[Attribute]) -> Result<Self> {
        let mut found = Self::default();
        for attribute in attributes.iter().filter(|a| a.path().is_ident("variable")) {
            found.present = true;
            if matches!(attribute.meta, Meta::Path(_)) {
                continue;
            }
            attribute.parse_nested_meta(|meta| {
                let name = meta.path.require_ident()?.to_string();
                match name.as_str() {
                    "output" => found.output = true,
                    "tunable" => found.tunable = true,
                    "discrete" => found.discrete = true,
                    "calculated" => found.calculated = true,
                    "length" => found.length = Some(meta.value()?.parse()?),
                    "name" => found.name = Some(meta.value()?.parse()?),
                    "alias" => found.alias = Some(meta.value()?.parse()?),
                    "clock" => found.clock = Some(meta.value()?.parse()?),
                    "unit" => found.unit = Some(meta.value()?.parse()?),
                    "start" => found.start = Some(meta.value()?.parse()?),
                    "min" => found.min = Some(meta.value()?.parse()?),
                    "max" => found.max = Some(meta.value()?.parse()?),
                    "nominal" => found.nominal = Some(meta.value()?.parse()?),
                    "depends_on" => found.depends_on = Some(meta.value()?.parse()?),
                    _ => {
                        return Err(meta.error(
                            "unknown attribute: a variable has name, unit, start, min, max, nominal, output, tunable, \
                             discrete, calculated, length, alias, clock and depends_on",
                        ));
                    }
                }
                Ok(())
            })?;
        }
        Ok(found)
    }
}

/// The documentation of an item as one line; an item without is an error, since users read it in their tools.
pub fn documentation(attributes: &[Attribute], of: &syn::Ident) -> Result<String> {
    let lines: Vec<String> = attributes
        .iter()
        .filter_map(|attribute| match &attribute.meta {
            Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
                Expr::Lit(literal) => match &literal.lit {
                    Lit::Str(text) => Some(text.value().trim().to_string()),
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        })
        .filter(|line| !line.is_empty())
        .collect();
    if lines.is_empty() {
        return Err(Error::new(
            of.span(),
            format!("`{of}` needs a documentation comment: users see it in their tools"),
        ));
    }
    Ok(lines.join(" "))
}
