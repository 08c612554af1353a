//! Writing SSP documents: deterministic, indented, valid against the schemas of their version.

use super::NAMESPACE;
use super::types::*;
use crate::types::{DataType, DefaultExperiment, FmiVersion, Item};
use crate::write::{WriteError, base_unit};
use crate::xml_out::{Document, Element as Xml, hex, join};

/// Writes a system description as the text of an `.ssd` file.
///
/// # Errors
///
/// [`WriteError`] if something in it is not in its version of the standard (arrays and most types are new in SSP 2.0),
/// a value is not of its type, or a text holds a character that XML cannot hold.
pub fn write_system(description: &SystemStructureDescription) -> Result<String, WriteError> {
    let mut writer = Writer { document: Document::new(), version: description.version };
    let root = Xml::new("ssd:SystemStructureDescription")
        .text("xmlns:ssd", &format!("{NAMESPACE}SystemStructureDescription"))
        .text("xmlns:ssc", &format!("{NAMESPACE}SystemStructureCommon"))
        .text("xmlns:ssv", &format!("{NAMESPACE}SystemStructureParameterValues"))
        .text("xmlns:ssm", &format!("{NAMESPACE}SystemStructureParameterMapping"))
        .text("version", &description.version.to_string())
        .text("name", &description.name)
        .maybe("description", description.description.as_deref());
    writer.document.open(root);
    writer.system(&description.system)?;
    writer.enumerations(["ssd:Enumerations", "ssc:Enumeration", "ssc:Item"], &description.enumerations)?;
    writer.units("ssd:Units", &description.units);
    if let Some(DefaultExperiment { start_time, stop_time, .. }) = description.default_experiment {
        let experiment = Xml::new("ssd:DefaultExperiment");
        writer.document.empty(experiment.maybe_float("startTime", start_time).maybe_float("stopTime", stop_time));
    }
    Ok(writer.document.finish()?)
}

/// Writes a parameter set as the text of an `.ssv` file.
///
/// # Errors
///
/// As of [`write_system`].
pub fn write_parameters(set: &ParameterSet) -> Result<String, WriteError> {
    let mut writer = Writer { document: Document::new(), version: set.version };
    let root = Xml::new("ssv:ParameterSet")
        .text("xmlns:ssv", &format!("{NAMESPACE}SystemStructureParameterValues"))
        .text("xmlns:ssc", &format!("{NAMESPACE}SystemStructureCommon"));
    writer.parameter_set(root, set)?;
    Ok(writer.document.finish()?)
}

/// Writes a parameter mapping as the text of an `.ssm` file.
///
/// # Errors
///
/// As of [`write_system`].
pub fn write_mapping(mapping: &ParameterMapping) -> Result<String, WriteError> {
    let mut writer = Writer { document: Document::new(), version: mapping.version };
    let root = Xml::new("ssm:ParameterMapping")
        .text("xmlns:ssm", &format!("{NAMESPACE}SystemStructureParameterMapping"))
        .text("xmlns:ssc", &format!("{NAMESPACE}SystemStructureCommon"));
    writer.mapping(root, mapping);
    Ok(writer.document.finish()?)
}

struct Writer {
    document: Document,
    version: SspVersion,
}

/// The element of a type, under the names that both versions know where there is one.
fn type_element(data_type: DataType) -> &'static str {
    match data_type {
        DataType::Float64 => "Real",
        DataType::Int32 => "Integer",
        other => other.as_str(),
    }
}

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

impl Writer {
    fn refuse_in_v1(&self, new: bool, what: impl FnOnce() -> String) -> Result<(), WriteError> {
        if new && self.version == SspVersion::V1 {
            return Err(WriteError::not_in("SSP 1.0", what()));
        }
        Ok(())
    }

    fn check_type(&self, data_type: DataType, of: &str) -> Result<(), WriteError> {
        let known = matches!(
            data_type,
            DataType::Float64
                | DataType::Int32
                | DataType::Boolean
                | DataType::String
                | DataType::Binary
                | DataType::Enumeration
        );
        self.refuse_in_v1(!known, || format!("the type {} of `{of}`", type_element(data_type)))
    }

    fn system(&mut self, system: &System) -> Result<(), WriteError> {
        self.document.open(
            Xml::new("ssd:System").text("name", &system.name).maybe("description", system.description.as_deref()),
        );
        self.connectors(&system.connectors)?;
        self.bindings(&system.parameter_bindings)?;
        if !system.elements.is_empty() {
            self.document.open(Xml::new("ssd:Elements"));
            for element in &system.elements {
                match element {
                    Element::Component(component) => self.component(component)?,
                    Element::System(system) => self.system(system)?,
                }
            }
            self.document.close();
        }
        if !system.connections.is_empty() {
            self.document.open(Xml::new("ssd:Connections"));
            for connection in &system.connections {
                self.connection(connection)?;
            }
            self.document.close();
        }
        self.document.close();
        Ok(())
    }

    fn component(&mut self, component: &Component) -> Result<(), WriteError> {
        self.refuse_in_v1(component.implementation == Implementation::ScheduledExecution, || {
            format!("the implementation ScheduledExecution of `{}`", component.name)
        })?;
        let implementation = Implementation::NAMES
            .iter()
            .find(|(_, i)| *i == component.implementation && *i != Implementation::Any)
            .map(|(name, _)| *name);
        let element = Xml::new("ssd:Component")
            .text("name", &component.name)
            .maybe("description", component.description.as_deref())
            .maybe("type", component.media_type.as_deref())
            .text("source", &component.source)
            .maybe("implementation", implementation);
        if component.connectors.is_empty() && component.parameter_bindings.is_empty() {
            self.document.empty(element);
            return Ok(());
        }
        self.document.open(element);
        self.connectors(&component.connectors)?;
        self.bindings(&component.parameter_bindings)?;
        self.document.close();
        Ok(())
    }

    fn connectors(&mut self, connectors: &[Connector]) -> Result<(), WriteError> {
        for connector in connectors {
            let new = matches!(
                connector.kind,
                ConnectorKind::StructuralParameter
                    | ConnectorKind::Constant
                    | ConnectorKind::Local
                    | ConnectorKind::Unspecified
            );
            self.refuse_in_v1(new, || format!("the kind {} of `{}`", connector.kind.as_str(), connector.name))?;
            self.refuse_in_v1(!connector.dimensions.is_empty(), || format!("dimensions of `{}`", connector.name))?;
            if let Some(connector_type) = &connector.connector_type {
                self.check_type(connector_type.data_type, &connector.name)?;
            }
        }
        self.document.list("ssd:Connectors", connectors, |document, connector| {
            let element = Xml::new("ssd:Connector")
                .text("name", &connector.name)
                .maybe("description", connector.description.as_deref())
                .text("kind", connector.kind.as_str());
            if connector.connector_type.is_none() && connector.dimensions.is_empty() {
                return document.empty(element);
            }
            document.open(element);
            if let Some(connector_type) = &connector.connector_type {
                let name = prefixed!("ssc:", connector_type.data_type);
                document.empty(
                    Xml::new(name)
                        .maybe("unit", connector_type.unit.as_deref())
                        .maybe("name", connector_type.enumeration.as_deref()),
                );
            }
            dimensions(document, &connector.dimensions);
            document.close();
        });
        Ok(())
    }

    fn connection(&mut self, connection: &Connection) -> Result<(), WriteError> {
        let (start, end) = (&connection.start, &connection.end);
        self.refuse_in_v1(!start.indices.is_empty() || !end.indices.is_empty(), || {
            format!("indices of the connection from `{start}` to `{end}`")
        })?;
        let indices =
            |endpoint: &Endpoint| (!endpoint.indices.is_empty()).then(|| join(&endpoint.indices, u64::to_string));
        let element = Xml::new("ssd:Connection")
            .maybe("startElement", start.element.as_deref())
            .text("startConnector", &start.connector)
            .maybe("startIndices", indices(start).as_deref())
            .maybe("endElement", end.element.as_deref())
            .text("endConnector", &end.connector)
            .maybe("endIndices", indices(end).as_deref())
            .flag("suppressUnitConversion", connection.suppress_unit_conversion);
        transformed(&mut self.document, element, connection.transformation.as_ref());
        Ok(())
    }

    fn bindings(&mut self, bindings: &[ParameterBinding]) -> Result<(), WriteError> {
        if bindings.is_empty() {
            return Ok(());
        }
        self.document.open(Xml::new("ssd:ParameterBindings"));
        for binding in bindings {
            let mut element = Xml::new("ssd:ParameterBinding").maybe("type", binding.media_type.as_deref());
            if let Source::File { source, base } = &binding.values {
                element = file(element, source, *base);
            }
            if !binding.prefix.is_empty() {
                element = element.text("prefix", &binding.prefix);
            }
            self.document.open(element);
            if let Source::Inline(set) = &binding.values {
                self.document.open(Xml::new("ssd:ParameterValues"));
                self.parameter_set(Xml::new("ssv:ParameterSet"), set)?;
                self.document.close();
            }
            match &binding.mapping {
                Some(Source::File { source, base }) => {
                    self.document.empty(file(Xml::new("ssd:ParameterMapping"), source, *base));
                }
                Some(Source::Inline(mapping)) => {
                    self.document.open(Xml::new("ssd:ParameterMapping"));
                    self.mapping(Xml::new("ssm:ParameterMapping"), mapping);
                    self.document.close();
                }
                None => {}
            }
            self.document.close();
        }
        self.document.close();
        Ok(())
    }

    fn parameter_set(&mut self, root: Xml, set: &ParameterSet) -> Result<(), WriteError> {
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

    fn parameter(&mut self, parameter: &Parameter) -> Result<(), WriteError> {
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

    fn mapping(&mut self, root: Xml, mapping: &ParameterMapping) {
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

    fn enumerations(
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

    fn units(&mut self, list: &'static str, units: &[Unit]) {
        self.document.list(list, units, |document, unit| {
            document
                .open(Xml::new("ssc:Unit").text("name", &unit.name).maybe("description", unit.description.as_deref()));
            document.empty(base_unit("ssc:BaseUnit", &unit.base));
            document.close();
        });
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

fn file(element: Xml, source: &str, base: SourceBase) -> Xml {
    let element = element.text("source", source);
    match base {
        SourceBase::Ssd => element,
        SourceBase::Component => element.text("sourceBase", "component"),
    }
}

fn dimensions(document: &mut Document, dimensions: &[Dimension]) {
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
fn transformed(document: &mut Document, element: Xml, transformation: Option<&Transformation>) {
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
