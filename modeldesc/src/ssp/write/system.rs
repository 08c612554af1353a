//! Writing systems: elements, connectors, connections, parameter bindings.

use super::Writer;
use super::common::{dimensions, prefixed, transformed};
use crate::ssp::types::*;
use crate::types::DataType;
use crate::write::WriteError;
use crate::xml_out::{Element as Xml, join};

impl Writer {
    pub(super) fn system(&mut self, system: &System) -> Result<(), WriteError> {
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

    pub(super) fn component(&mut self, component: &Component) -> Result<(), WriteError> {
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

    pub(super) fn connectors(&mut self, connectors: &[Connector]) -> Result<(), WriteError> {
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

    pub(super) fn connection(&mut self, connection: &Connection) -> Result<(), WriteError> {
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

    pub(super) fn bindings(&mut self, bindings: &[ParameterBinding]) -> Result<(), WriteError> {
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
}

fn file(element: Xml, source: &str, base: SourceBase) -> Xml {
    let element = element.text("source", source);
    match base {
        SourceBase::Ssd => element,
        SourceBase::Component => element.text("sourceBase", "component"),
    }
}
