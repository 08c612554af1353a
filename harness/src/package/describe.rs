//! Asks an FMU library to describe itself. The only unsafe code of the packager.

use std::ffi::{CStr, c_void};
use std::path::Path;

use swayless_abi::describe;
use swayless_modeldesc::problem::Severity;
use swayless_modeldesc::types::ModelDescription;
use swayless_modeldesc::{check, terminals};

use super::Error;

/// What a library says about itself.
#[derive(Debug)]
pub struct Parts {
    /// `modelIdentifier` of both model descriptions.
    pub name: String,
    /// `modelDescription.xml` for FMI 2.0.
    pub fmi2: String,
    /// `modelDescription.xml` for FMI 3.0.
    pub fmi3: String,
    /// `modelDescription.xml` of the FMU with clocks, for FMI 3.0, if there is one.
    pub clocked: Option<String>,
    /// `terminalsAndIcons.xml` for FMI 3.0.
    pub terminals: String,
    /// The documentation, in Markdown.
    pub documentation: String,
    /// The icon, in SVG.
    pub icon: String,
}

impl Parts {
    /// `modelIdentifier` of the FMU with clocks.
    pub fn clocked_name(&self) -> String {
        format!("{}Clocked", self.name)
    }
}

/// Loads the library and asks for all it can tell.
pub fn describe(path: &Path) -> Result<Parts, Error> {
    let load = |source| Error::Load { path: path.to_owned(), source };
    // SAFETY: the library was just compiled from this workspace; loading an FMU runs no code of its own beyond the
    // standard library's, and it stays loaded until `library` is dropped, after the last call.
    let library = unsafe { libloading::Library::new(path) }.map_err(load)?;
    // SAFETY: the symbol's type is fixed in `swayless_abi::describe`, from which the library exports it.
    let symbol = unsafe { library.get::<describe::Describe>(describe::SYMBOL) }.map_err(load)?;
    let ask_for = |item: &CStr| -> Result<Option<String>, Error> {
        let mut answer = Vec::<u8>::new();
        // SAFETY: `item` ends in NUL; `collect` fits the context, a vector that outlives the call and is used by
        // nothing else during it.
        let status = unsafe { symbol(item.as_ptr(), Some(collect), (&raw mut answer).cast()) };
        let text = String::from_utf8(answer).map_err(|_| Error::bad_answer(path, item, "is not UTF-8"))?;
        match status {
            0 => Ok(Some(text)),
            describe::CANNOT => Err(Error::bad_answer(path, item, format!("cannot be made: {text}"))),
            _ => Ok(None),
        }
    };
    let ask = |item: &CStr| {
        let none = || Error::NoAnswer { path: path.to_owned(), item: item.to_string_lossy().into_owned() };
        ask_for(item)?.ok_or_else(none)
    };
    let (fmi2, fmi3) = (ask(describe::FMI2)?, ask(describe::FMI3)?);
    let (name, description) = name(path, describe::FMI3, &fmi3)?;
    if self::name(path, describe::FMI2, &fmi2)?.0 != name {
        return Err(Error::bad_answer(path, describe::FMI2, format!("is not named `{name}` as that for FMI 3.0")));
    }
    let parts = Parts {
        name,
        fmi2,
        fmi3,
        clocked: ask_for(describe::CLOCKED)?,
        terminals: ask(describe::TERMINALS)?,
        documentation: ask(describe::DOCUMENTATION)?,
        icon: ask(describe::ICON)?,
    };
    check_terminals(path, &parts.terminals, &description)?;
    if let Some(clocked) = &parts.clocked {
        let wanted = parts.clocked_name();
        let (name, description) = self::name(path, describe::CLOCKED, clocked)?;
        if name != wanted {
            return Err(Error::bad_answer(path, describe::CLOCKED, format!("is not named `{wanted}`")));
        }
        check_terminals(path, &parts.terminals, &description)?;
    }
    Ok(parts)
}

/// Takes the answer.
unsafe extern "C" fn collect(context: *mut c_void, bytes: *const u8, count: usize) {
    if context.is_null() || bytes.is_null() {
        return;
    }
    // SAFETY: `describe` passes a vector as context and nothing else refers to it while the library is asked.
    let answer = unsafe { &mut *context.cast::<Vec<u8>>() };
    // SAFETY: `Sink` promises `count` bytes that are valid during the call.
    answer.extend_from_slice(unsafe { std::slice::from_raw_parts(bytes, count) });
}

/// Terminals group variables that exist.
fn check_terminals(path: &Path, xml: &str, description: &ModelDescription) -> Result<(), Error> {
    let bad = |problem: String| Error::bad_answer(path, describe::TERMINALS, problem);
    let (_, problems) =
        terminals::read_and_check(xml.as_bytes(), description).map_err(|e| bad(format!("is unreadable: {e}")))?;
    match problems.iter().find(|p| p.severity == Severity::Error) {
        Some(problem) => Err(bad(format!("is wrong: {problem}"))),
        None => Ok(()),
    }
}

/// The model identifier in a model description, after which the archive and the library in it are named, and the
/// description.
fn name(path: &Path, item: &CStr, xml: &str) -> Result<(String, ModelDescription), Error> {
    let bad = |problem: String| Error::bad_answer(path, item, problem);
    let (description, problems) =
        check::read_and_check(xml.as_bytes()).map_err(|e| bad(format!("is unreadable: {e}")))?;
    if let Some(problem) = problems.iter().find(|p| p.severity == Severity::Error) {
        return Err(bad(format!("is wrong: {problem}")));
    }
    let interfaces = [&description.co_simulation, &description.model_exchange, &description.scheduled_execution];
    let name = interfaces.into_iter().flatten().next().map(|i| i.model_identifier.clone()).unwrap_or_default();
    let is_identifier = |name: &str| {
        name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
            && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
    };
    if is_identifier(&name) {
        Ok((name, description))
    } else {
        Err(bad(format!("has a modelIdentifier that names no file: `{name}`")))
    }
}

#[cfg(test)]
mod tests {
    use swayless_modeldesc::types::{Causality, DataType, FmiVersion, Variability, Variable};

    use super::*;

    #[test]
    fn a_terminal_of_a_variable_that_is_not_there_is_refused() {
        let mut description = ModelDescription::new(FmiVersion::V3, "Sample", "token");
        let xml = |variable: &str| {
            format!(
                "<fmiTerminalsAndIcons fmiVersion='3.0'><Terminals><Terminal name='axis' matchingRule='bus'>\
                 <TerminalMemberVariable variableName='{variable}' memberName='rate' variableKind='signal'/>\
                 </Terminal></Terminals></fmiTerminalsAndIcons>"
            )
        };
        let rate = Variable::new("rate", 1, DataType::Float64, Causality::Input, Variability::Continuous);
        description.variables.push(rate);
        check_terminals("Sample.so".as_ref(), &xml("rate"), &description).unwrap();
        let error = check_terminals("Sample.so".as_ref(), &xml("speed"), &description).unwrap_err().to_string();
        assert!(error.contains("Sample.so") && error.contains("`axis` has the variable `speed`"), "{error}");
    }
}
