//! Checks a system against the FMUs that it names: whether all that is declared and connected is there and fits.

use std::path::Path;

use swayless_modeldesc::problem::{Problem, Severity};
use swayless_modeldesc::ssp::{self, Connector, ConnectorKind, Element};
use swayless_modeldesc::types::Causality;

use super::{Finding, in_document};
use crate::error::Error;
use crate::system::{Kind, Names, System, units};

/// Opens a system that is right by itself, and checks it with its FMUs. `name` is the document inside an archive.
pub(super) fn check(path: &Path, name: Option<&str>, description: &ssp::SystemStructureDescription) -> Vec<Finding> {
    let shown = name.map_or_else(|| path.to_owned(), |name| path.join(name)).display().to_string();
    let finding = |error: &Error| {
        let (severity, note) = match error {
            // The description may have come without its FMUs.
            Error::SourceNotFound { path, .. } if is_fmu(path) => {
                (Severity::Warning, "; so the system is not checked against its FMUs")
            }
            _ => (Severity::Error, ""),
        };
        let text = error.to_string();
        let (line, message) = placed(&text, &shown).unwrap_or((0, &text));
        in_document(name, Problem { line, severity, message: format!("{message}{note}") })
    };
    let system = match System::open(path) {
        Ok(system) => system,
        Err(error) => return error.problems().into_iter().map(finding).collect(),
    };
    let mut findings: Vec<Finding> = match system.check() {
        Ok(()) => Vec::new(),
        Err(error) => error.problems().into_iter().map(finding).collect(),
    };
    let names = Names::of(&system);
    for (owner, connector) in connectors(&description.system, "") {
        let full = format!("{owner}.{}", connector.name);
        let problem = match names.find(&full, &format!("{shown}:{}", connector.line)) {
            Err(error) => Some(finding(&error)),
            Ok(port) => differs(&names, port, connector, description).map(|what| {
                let message = format!("the connector `{full}` is {what}");
                in_document(name, Problem { line: connector.line, severity: Severity::Error, message })
            }),
        };
        findings.extend(problem);
    }
    findings.sort_by_key(|finding| finding.problem.line);
    findings.dedup();
    findings
}

fn is_fmu(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("fmu"))
}

/// The line and the rest of a message that begins with the document and a line in it.
fn placed<'a>(text: &'a str, shown: &str) -> Option<(usize, &'a str)> {
    let (line, message) = text.strip_prefix(shown)?.strip_prefix(':')?.split_once(": ")?;
    Some((line.parse().ok()?, message))
}

/// The connectors of all components, each with the name of its instance.
fn connectors<'a>(system: &'a ssp::System, path: &str) -> Vec<(String, &'a Connector)> {
    let found = system.elements.iter().flat_map(|element| {
        let name = format!("{path}{}", element.name());
        match element {
            Element::Component(component) => component.connectors.iter().map(|c| (name.clone(), c)).collect(),
            Element::System(inner) => connectors(inner, &format!("{name}.")),
        }
    });
    found.collect()
}

/// In what a connector differs from its variable.
fn differs(
    names: &Names,
    port: crate::system::Port,
    connector: &Connector,
    description: &ssp::SystemStructureDescription,
) -> Option<String> {
    use ConnectorKind as K;
    let variable = names.variable(port);
    let fits = match connector.kind {
        K::Input => variable.causality == Causality::Input,
        K::Output => variable.causality == Causality::Output,
        K::Parameter => matches!(variable.causality, Causality::Parameter | Causality::StructuralParameter),
        K::StructuralParameter => variable.causality == Causality::StructuralParameter,
        K::CalculatedParameter => variable.causality == Causality::CalculatedParameter,
        K::Inout | K::Constant | K::Local | K::Unspecified => true,
    };
    if !fits {
        return Some(format!(
            "of kind {}, the variable of causality {:?}",
            connector.kind.as_str(),
            variable.causality
        ));
    }
    let declared = connector.connector_type.as_ref()?;
    if Kind::of(declared.data_type) != Kind::of(variable.data_type) {
        return Some(format!("{:?}, the variable {:?}", declared.data_type, variable.data_type));
    }
    let (from, to) = (declared.unit.as_deref()?, names.unit(port)?);
    let own = description.units.iter().find(|unit| unit.name == from).map(|unit| unit.base);
    let its = units::definition(names.description(port.instance), to);
    let units::Mismatch(reason) = units::conversion((from, Some(own?)), (to, Some(its?)), false).err()?;
    Some(format!("in `{from}`, the variable in `{to}`: {reason}"))
}
