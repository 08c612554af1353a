//! Checks a file against its standard without running it: all problems, each with its place.

mod fmus;

use std::fmt;
use std::path::Path;

use swayless_modeldesc::problem::{Problem, ReadError, Severity};
use swayless_modeldesc::terminals::TERMINALS_AND_ICONS;
use swayless_modeldesc::types::ModelDescription;
use swayless_modeldesc::{check, ssp};

use crate::archive::Unpacked;
use crate::error::{Error, Result};
use crate::terminals;

/// One thing that is wrong with a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The document inside an archive that is meant, if not the whole file.
    pub document: Option<String>,
    /// What is wrong with it.
    pub problem: Problem,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(document) = &self.document {
            write!(f, "{document}: ")?;
        }
        write!(f, "{}", self.problem)
    }
}

const DESCRIPTION: &str = "modelDescription.xml";

/// Checks an FMU (its archive, its model description, its terminals, whether there is something to run), or an SSP document or archive
/// with the parameter sets it names. A system without errors of its own is checked against the FMUs that it names, too.
///
/// # Errors
///
/// Only if the file cannot be read; what is wrong with its content is what this function is asked for.
pub fn validate(path: &Path) -> Result<Vec<Finding>> {
    let extension = path.extension().map(|e| e.to_ascii_lowercase()).unwrap_or_default();
    match extension.to_str() {
        Some("ssd") => system(path, path, None),
        Some("ssv") => Ok(document(ssp::read_parameters(&text(path)?), None).1),
        Some("ssm") => Ok(document(ssp::read_mapping(&text(path)?), None).1),
        Some("ssp") => in_archive(path, ssp::SYSTEM_STRUCTURE, "SSP archive", |file, _| {
            system(path, file, Some(ssp::SYSTEM_STRUCTURE))
        }),
        _ => in_archive(path, DESCRIPTION, "FMU", fmu),
    }
}

/// Unpacks an archive and checks its main document, which must be at the root.
fn in_archive(
    path: &Path,
    main: &str,
    kind: &str,
    check: impl FnOnce(&Path, &Path) -> Result<Vec<Finding>>,
) -> Result<Vec<Finding>> {
    let archive = match Unpacked::open(path) {
        Ok(archive) => archive,
        Err(Error::Archive { problem, .. }) => return Ok(vec![whole(problem.to_string())]),
        Err(error) => return Err(error),
    };
    let file = archive.folder().join(main);
    if file.is_file() {
        check(&file, archive.folder())
    } else {
        Ok(vec![whole(format!("there is no {main} at the root, so this is no {kind}"))])
    }
}

fn fmu(file: &Path, folder: &Path) -> Result<Vec<Finding>> {
    let bytes = std::fs::read(file).map_err(|source| Error::io("read", file, source))?;
    let (description, mut findings) = document(check::read_and_check(&bytes), Some(DESCRIPTION));
    let Some(description) = description else { return Ok(findings) };
    if let Some(read) = terminals::read(folder, &description)? {
        findings.extend(document(read, Some(TERMINALS_AND_ICONS)).1);
    }
    findings.extend(binaries(&description, folder));
    Ok(findings)
}

/// Checks a system description, the parameter sets beside it and, if all of that is right, how it goes with its FMUs.
fn system(path: &Path, file: &Path, name: Option<&str>) -> Result<Vec<Finding>> {
    let (description, mut findings) = document(ssp::read_system(&text(file)?), name);
    let Some(description) = description else { return Ok(findings) };
    findings.extend(ssp::check(&description).into_iter().map(|problem| in_document(name, problem)));
    findings.sort_by_key(|f| f.problem.line);
    for (source, line) in parameter_files(&description.system) {
        // A source that is no path was found by the check of the description.
        let Ok(set) = ssp::source_path(source) else { continue };
        match text(&file.with_file_name(&set)) {
            Ok(xml) => findings.extend(document(ssp::read_parameters(&xml), Some(&set)).1),
            Err(error) => {
                let message = format!("the parameter set `{set}` cannot be read: {error}");
                findings.push(in_document(name, Problem { line, severity: Severity::Error, message }));
            }
        }
    }
    if !findings.iter().any(|finding| finding.problem.severity == Severity::Error) {
        findings.extend(fmus::check(path, name, &description));
    }
    Ok(findings)
}

/// The parameter sets in files of their own beside the system description, each with the line that names it.
fn parameter_files(system: &ssp::System) -> Vec<(&str, usize)> {
    let mut files = named_files(&system.parameter_bindings);
    for element in &system.elements {
        match element {
            ssp::Element::Component(component) => files.extend(named_files(&component.parameter_bindings)),
            ssp::Element::System(inner) => files.extend(parameter_files(inner)),
        }
    }
    files
}

fn named_files(bindings: &[ssp::ParameterBinding]) -> Vec<(&str, usize)> {
    let mut files = Vec::new();
    for binding in bindings {
        if let ssp::Source::File { source, base: ssp::SourceBase::Ssd } = &binding.values {
            files.push((source.as_str(), binding.line));
        }
    }
    files
}

/// What a reader made of a document, and what it had to say.
fn document<T>(read: Result<(T, Vec<Problem>), ReadError>, name: Option<&str>) -> (Option<T>, Vec<Finding>) {
    match read {
        Ok((content, problems)) => (Some(content), problems.into_iter().map(|p| in_document(name, p)).collect()),
        Err(error) => (None, vec![in_document(name, error.into())]),
    }
}

fn text(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).map_err(|source| Error::io("read", path, source))
}

fn whole(message: String) -> Finding {
    in_document(None, Problem { line: 0, severity: Severity::Error, message })
}

fn in_document(name: Option<&str>, problem: Problem) -> Finding {
    Finding { document: name.map(str::to_owned), problem }
}

/// Every interface needs a binary of its name for some platform, or sources.
fn binaries(description: &ModelDescription, folder: &Path) -> Vec<Finding> {
    if folder.join("sources").is_dir() {
        return Vec::new();
    }
    let interfaces = [&description.model_exchange, &description.co_simulation, &description.scheduled_execution];
    let mut names: Vec<&str> = interfaces.into_iter().flatten().map(|i| i.model_identifier.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let files = || {
        let platforms = std::fs::read_dir(folder.join("binaries")).into_iter().flatten().flatten();
        platforms.flat_map(|p| std::fs::read_dir(p.path()).into_iter().flatten().flatten()).map(|f| f.path())
    };
    let missing = |name: &&str| !files().any(|f| f.file_stem().is_some_and(|stem| stem == *name));
    let message = |name: &str| format!("there are neither sources nor a binary called `{name}` below binaries/");
    names.into_iter().filter(missing).map(|name| whole(message(name))).collect()
}
