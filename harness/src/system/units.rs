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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn kelvin(factor: f64, offset: f64) -> Option<BaseUnit> {
        Some(BaseUnit { exponents: [0, 0, 0, 0, 1, 0, 0, 0], factor, offset })
    }

    #[test]
    fn equal_definitions_need_nothing_whatever_their_names() {
        assert_eq!(conversion(("K", kelvin(1.0, 0.0)), ("kelvin", kelvin(1.0, 0.0)), false), Ok(None));
        assert_eq!(conversion(("K", kelvin(1.0, 0.0)), ("degC", kelvin(1.0, 273.15)), true), Ok(None));
        assert_eq!(conversion(("x", None), ("x", None), false), Ok(None));
    }

    #[test]
    fn a_factor_of_zero_is_no_definition() {
        assert!(conversion(("K", kelvin(1.0, 0.0)), ("zero", kelvin(0.0, 0.0)), false).is_err());
    }

    proptest! {
        #[test]
        fn there_and_back_is_where_it_began(
            value in -1e3..1e3f64, a in (0.01..100.0f64, -300.0..300.0f64), b in (0.01..100.0f64, -300.0..300.0f64)
        ) {
            let (a, b) = (("a", kelvin(a.0, a.1)), ("b", kelvin(b.0, b.1)));
            let convert = |from, to, value: f64| {
                conversion(from, to, false).unwrap().map_or(value, |(factor, offset)| factor * value + offset)
            };
            let back = convert(b, a, convert(a, b, value));
            prop_assert!((back - value).abs() <= 1e-6 * (1.0 + value.abs()), "{back} {value}");
        }
    }
}
