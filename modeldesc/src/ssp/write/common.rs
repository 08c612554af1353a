//! What the documents share: types, units, enumerations, dimensions, transformations.

use super::Writer;
use crate::ssp::types::*;
use crate::types::{DataType, Item};
use crate::write::{WriteError, base_unit};
use crate::xml_out::{Document, Element as Xml};

/// The name of a type's element under a prefix.
macro_rules! prefixed {
    ($prefix:literal, $data_type:expr) => {
        match $data_type {
            DataType::Float64 => concat!($prefix, "Real"),
            DataType::Float32 => concat!($prefix, "Float32"),
            DataType::Int8 => concat!($prefix, "Int8"),
            DataType::UInt8 => concat!($prefix, "UInt8"),
            DataType::Int16 => concat!($prefix, "Int16"),
            DataType::UInt16 => concat!($prefix, "UInt16"),
            DataType::Int32 => concat!($prefix, "Integer"),
            DataType::UInt32 => concat!($prefix, "UInt32"),
            DataType::Int64 => concat!($prefix, "Int64"),
            DataType::UInt64 => concat!($prefix, "UInt64"),
            DataType::Boolean => concat!($prefix, "Boolean"),
            DataType::String => concat!($prefix, "String"),
            DataType::Binary => concat!($prefix, "Binary"),
            DataType::Enumeration => concat!($prefix, "Enumeration"),
            DataType::Clock => concat!($prefix, "Clock"),
        }
    };
}
pub(super) use prefixed;

impl Writer {
    pub(super) fn refuse_in_v1(&self, new: bool, what: impl FnOnce() -> String) -> Result<(), WriteError> {
        if new && self.version == SspVersion::V1 {
            return Err(WriteError::not_in("SSP 1.0", what()));
        }
        Ok(())
    }

    pub(super) fn check_type(&self, data_type: DataType, of: &str) -> Result<(), WriteError> {
        let known = matches!(
            data_type,
            DataType::Float64
                | DataType::Int32
                | DataType::Boolean
                | DataType::String
                | DataType::Binary
                | DataType::Enumeration
        );
        self.refuse_in_v1(!known, || format!("the type {} of `{of}`", data_type.as_str()))
    }

    pub(super) fn enumerations(
        &mut self,
        [list, element, item]: [&'static str; 3],
        enumerations: &[Enumeration],
    ) -> Result<(), WriteError> {
        if let Some(empty) = enumerations.iter().find(|enumeration| enumeration.items.is_empty()) {
            return Err(WriteError::not_in("SSP", format!("the enumeration `{}`, which has no items,", empty.name)));
        }
        self.document.list(list, enumerations, |document, enumeration| {
            document.open(
                Xml::new(element)
                    .text("name", &enumeration.name)
                    .maybe("description", enumeration.description.as_deref()),
            );
            for Item { name, value, .. } in &enumeration.items {
                document.empty(Xml::new(item).text("name", name).text("value", &value.to_string()));
            }
            document.close();
        });
        Ok(())
    }

    pub(super) fn units(&mut self, list: &'static str, units: &[Unit]) {
        self.document.list(list, units, |document, unit| {
            document
                .open(Xml::new("ssc:Unit").text("name", &unit.name).maybe("description", unit.description.as_deref()));
            document.empty(base_unit("ssc:BaseUnit", &unit.base));
            document.close();
        });
    }
}

pub(super) fn dimensions(document: &mut Document, dimensions: &[Dimension]) {
    for dimension in dimensions {
        let element = Xml::new("ssc:Dimension");
        document.empty(match dimension {
            Dimension::Fixed(size) => element.text("size", &size.to_string()),
            Dimension::Connector(name) => element.text("sizeConnector", name),
            Dimension::Unspecified => element,
        });
    }
}

/// An element with its transformation inside, if there is one.
pub(super) fn transformed(document: &mut Document, element: Xml, transformation: Option<&Transformation>) {
    let Some(transformation) = transformation else { return document.empty(element) };
    document.open(element);
    let mut entries = |name: &'static str, pairs: Vec<(String, String)>| {
        document.open(Xml::new(name));
        for (source, target) in pairs {
            document.empty(Xml::new("ssc:MapEntry").text("source", &source).text("target", &target));
        }
        document.close();
    };
    match transformation {
        Transformation::Linear { factor, offset } => {
            document.empty(Xml::new("ssc:LinearTransformation").float("factor", *factor).float("offset", *offset));
        }
        Transformation::Boolean(pairs) => entries(
            "ssc:BooleanMappingTransformation",
            pairs.iter().map(|(a, b)| (a.to_string(), b.to_string())).collect(),
        ),
        Transformation::Integer(pairs) => entries(
            "ssc:IntegerMappingTransformation",
            pairs.iter().map(|(a, b)| (a.to_string(), b.to_string())).collect(),
        ),
        Transformation::Enumeration(pairs) => entries("ssc:EnumerationMappingTransformation", pairs.clone()),
    }
    document.close();
}
