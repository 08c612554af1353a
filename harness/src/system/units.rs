//! Converts between units by the definitions that the FMUs give them.

use swayless_modeldesc::types::{BaseUnit, ModelDescription};

/// What is wrong between two units.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Mismatch(pub String);

/// A unit by its name, with its definition if there is one.
pub(crate) type Unit<'a> = (&'a str, Option<BaseUnit>);

/// `to = factor · from + offset`, or `None` when nothing has to be done.
pub(crate) fn conversion(
    (from, from_base): Unit,
    (to, to_base): Unit,
    relative: bool,
) -> Result<Option<(f64, f64)>, Mismatch> {
    let (Some(a), Some(b)) = (from_base, to_base) else {
        // Without definitions the name is all there is to go by.
        let undefined = if from_base.is_none() { from } else { to };
        return match from == to {
            true => Ok(None),
            false => Err(Mismatch(format!("`{undefined}` is not defined by base units in its FMU"))),
        };
    };
    if a.exponents != b.exponents {
        return Err(Mismatch(format!("one is {}, the other {}", dimensions(a), dimensions(b))));
    }
    if a.factor == b.factor && (relative || a.offset == b.offset) {
        return Ok(None);
    }
    if b.factor == 0.0 || !(a.factor / b.factor).is_finite() {
        return Err(Mismatch(format!("the factor of `{to}` is {}", b.factor)));
    }
    let offset = if relative { 0.0 } else { (a.offset - b.offset) / b.factor };
    Ok(Some((a.factor / b.factor, offset)))
}

/// What a model description says of a unit.
pub(crate) fn definition(model: &ModelDescription, name: &str) -> Option<BaseUnit> {
    model.units.iter().find(|unit| unit.name == name)?.base
}

fn dimensions(unit: BaseUnit) -> String {
    let factors: Vec<String> = BaseUnit::SYMBOLS
        .iter()
        .zip(unit.exponents)
        .filter(|&(_, exponent)| exponent != 0)
        .map(|(symbol, exponent)| if exponent == 1 { (*symbol).to_owned() } else { format!("{symbol}^{exponent}") })
        .collect();
    if factors.is_empty() { "a plain number".to_owned() } else { factors.join("·") }
}
