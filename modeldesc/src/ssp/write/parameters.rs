//! Writing parameter sets and parameter mappings, inline or as files.

use super::Writer;
use super::common::{dimensions, prefixed, transformed};
use crate::ssp::types::*;
use crate::types::{DataType, FmiVersion};
use crate::write::WriteError;
use crate::xml_out::{Element as Xml, hex};

impl Writer {
    pub(super) fn parameter_set(&mut self, root: Xml, set: &ParameterSet) -> Result<(), WriteError> {
        self.document.open(
            root.text("version", &set.version.to_string())
                .text("name", &set.name)
                .maybe("description", set.description.as_deref()),
        );
        self.document.open(Xml::new("ssv:Parameters"));
        for parameter in &set.parameters {
            self.parameter(parameter)?;
        }
        self.document.close();
        self.enumerations(["ssv:Enumerations", "ssc:Enumeration", "ssc:Item"], &set.enumerations)?;
        self.units("ssv:Units", &set.units);
        self.document.close();
        Ok(())
    }

    pub(super) fn parameter(&mut self, parameter: &Parameter) -> Result<(), WriteError> {
        let name = &parameter.name;
        let wrong = || WriteError::StartType { variable: name.clone(), data_type: parameter.data_type };
        let integers = parameter.data_type.integer_range(FmiVersion::V3);
        let fits = match (&parameter.value, parameter.data_type) {
            (Value::Float(_), data_type) => data_type.is_float(),
            (Value::Integer(_), DataType::Enumeration) => false,
            (Value::Integer(values), _) => {
                integers.is_some_and(|(least, greatest)| values.iter().all(|value| (least..=greatest).contains(value)))
            }
            (Value::Boolean(_), data_type) => data_type == DataType::Boolean,
            (Value::String(_), data_type) => data_type == DataType::String,
            (Value::Enumeration(_), data_type) => data_type == DataType::Enumeration,
            (Value::Binary(_), data_type) => data_type == DataType::Binary,
        };
        if !fits || (parameter.dimensions.is_empty() && count(&parameter.value) != 1) {
            return Err(wrong());
        }
        self.check_type(parameter.data_type, name)?;
        self.refuse_in_v1(!parameter.dimensions.is_empty(), || format!("dimensions of `{name}`"))?;
        self.document
            .open(Xml::new("ssv:Parameter").text("name", name).maybe("description", parameter.description.as_deref()));
        let typed = Xml::new(prefixed!("ssv:", parameter.data_type));
        let unit = parameter.unit.as_deref().filter(|_| parameter.data_type.is_float());
        let enumeration = parameter.enumeration.as_deref().filter(|_| parameter.data_type == DataType::Enumeration);
        let with_type = |element: Xml| element.maybe("unit", unit).maybe("name", enumeration);
        // Values that may hold blanks stand in elements of their own unless there is just one.
        let texts: Option<Vec<String>> = match &parameter.value {
            Value::String(values) | Value::Enumeration(values) => Some(values.clone()),
            Value::Binary(values) => Some(values.iter().map(|bytes| hex(bytes)).collect()),
            _ => None,
        };
        match texts.as_deref() {
            None => self.document.empty(with_type(typed.text("value", &parameter.value.to_string()))),
            Some([one]) => self.document.empty(with_type(typed.text("value", one))),
            Some(several) => {
                self.document.open(with_type(typed));
                for value in several {
                    self.document.empty(Xml::new("ssv:Value").text("value", value));
                }
                self.document.close();
            }
        }
        dimensions(&mut self.document, &parameter.dimensions);
        self.document.close();
        Ok(())
    }

    pub(super) fn mapping(&mut self, root: Xml, mapping: &ParameterMapping) {
        let root =
            root.text("version", &mapping.version.to_string()).maybe("description", mapping.description.as_deref());
        self.document.open(root);
        for entry in &mapping.entries {
            let element = Xml::new("ssm:MappingEntry")
                .text("source", &entry.source)
                .text("target", &entry.target)
                .flag("suppressUnitConversion", entry.suppress_unit_conversion);
            transformed(&mut self.document, element, entry.transformation.as_ref());
        }
        self.document.close();
    }
}

fn count(value: &Value) -> usize {
    match value {
        Value::Float(values) => values.len(),
        Value::Integer(values) => values.len(),
        Value::Boolean(values) => values.len(),
        Value::String(values) | Value::Enumeration(values) => values.len(),
        Value::Binary(values) => values.len(),
    }
}
