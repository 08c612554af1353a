//! `UnitDefinitions` and `TypeDefinitions`.

use swayless_modeldesc::types::{
    Attributes, BaseUnit, DataType, DisplayUnit, Item, TypeDefinition, Unit as UnitDefinition,
};

use super::variables::Entry;
use crate::declaration::Kind;
use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::unit::{UNITS, Unit};

/// The units used, in the order of the table.
pub fn units(entries: &[Entry]) -> Vec<Unit> {
    let used = |unit: &&Unit| entries.iter().any(|e| e.variable.attributes.unit.as_deref() == Some(unit.symbol));
    UNITS.iter().filter(used).copied().collect()
}

/// A unit with its display units.
pub fn unit(unit: Unit) -> UnitDefinition {
    UnitDefinition {
        name: unit.symbol.to_string(),
        base: Some(BaseUnit { exponents: unit.exponents, factor: 1.0, offset: 0.0 }),
        display_units: unit
            .display
            .iter()
            .map(|(name, factor)| DisplayUnit {
                name: (*name).to_string(),
                factor: *factor,
                offset: 0.0,
                inverse: false,
            })
            .collect(),
    }
}

/// A type for each unit used, and the enumerations.
pub fn types<M: Model>(units: &[Unit]) -> Vec<TypeDefinition> {
    let quantities = units.iter().map(|unit| TypeDefinition {
        name: unit.quantity.to_string(),
        description: None,
        data_type: DataType::Float64,
        attributes: Attributes {
            quantity: Some(unit.quantity.to_string()),
            unit: Some(unit.symbol.to_string()),
            display_unit: unit.display.first().map(|(name, _)| (*name).to_string()),
            ..Attributes::default()
        },
        items: Vec::new(),
        clock: None,
    });
    quantities.chain(enumerations::<M>()).collect()
}

/// The enumerations of all variables, each once.
fn enumerations<M: Model>() -> Vec<TypeDefinition> {
    let mut found: Vec<TypeDefinition> = Vec::new();
    for block in [Block::Parameters, Block::Inputs, Block::Discrete] {
        for declaration in Layout::<M>::declarations(block) {
            let Kind::Enumeration { name, items } = declaration.kind else { continue };
            if found.iter().any(|known| known.name == name) {
                continue;
            }
            let items = items.iter().zip(1..).map(|((name, description), value)| Item {
                name: (*name).to_string(),
                value,
                description: Some((*description).to_string()),
            });
            found.push(TypeDefinition {
                name: name.to_string(),
                description: None,
                data_type: DataType::Enumeration,
                attributes: Attributes::default(),
                items: items.collect(),
                clock: None,
            });
        }
    }
    found
}
