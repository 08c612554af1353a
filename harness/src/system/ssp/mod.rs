//! Reads a system from SSP: nested systems become one level, whose instances are named by their path.

mod flatten;
mod parameters;

pub(super) use parameters::of_file;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use swayless_modeldesc::problem::{Problem, ReadError, Severity};
use swayless_modeldesc::ssp::{self, Component, Element, Implementation, SystemStructureDescription};

use super::System;
use crate::archive::Unpacked;
use crate::error::{Error, Result};

/// Opens an `.ssd` file, or the one in an `.ssp` archive. FMUs are taken from `fmus` by their file name, if given.
pub(super) fn open(path: &Path, is_archive: bool, fmus: Option<&Path>) -> Result<System> {
    if !is_archive {
        return read(path, path, None, fmus);
    }
    let unpacked = Arc::new(Unpacked::open(path)?);
    let file = unpacked.folder().join(ssp::SYSTEM_STRUCTURE);
    if !file.is_file() {
        let problems = vec![format!("there is no {} at its root, so it is no SSP", ssp::SYSTEM_STRUCTURE)];
        return Err(Error::InvalidDescription { path: path.to_owned(), problems });
    }
    read(&file, &path.join(ssp::SYSTEM_STRUCTURE), Some(unpacked), fmus)
}

/// A system description that is being read.
struct Reader<'a> {
    /// The name of the `.ssd` file in messages.
    shown: &'a Path,
    /// Where relative sources begin.
    folder: PathBuf,
    /// The archive that sources must not leave, if it came in one.
    archive: Option<Arc<Unpacked>>,
    /// Where FMUs are taken from instead of their sources.
    fmus: Option<&'a Path>,
    description: &'a SystemStructureDescription,
    system: System,
    errors: Vec<Error>,
}

fn read(file: &Path, shown: &Path, archive: Option<Arc<Unpacked>>, fmus: Option<&Path>) -> Result<System> {
    let text = std::fs::read_to_string(file).map_err(|source| Error::io("read", file, source))?;
    let description = document(shown, ssp::read_system(&text), ssp::check)?;
    let absolute = file.canonicalize().map_err(|source| Error::io("read", file, source))?;
    let mut system = System::new(description.name.clone());
    if let Some(experiment) = description.default_experiment {
        system.default_experiment = experiment;
    }
    system.archive = archive.clone();
    let folder = absolute.parent().unwrap_or(Path::new("/")).to_owned();
    let mut reader = Reader { shown, folder, archive, fmus, description: &description, system, errors: Vec::new() };
    reader.components(&description.system, "");
    flatten::connections(&mut reader);
    parameters::bindings(&mut reader, &description.system, "");
    let Reader { system, errors, .. } = reader;
    Error::all(errors)?;
    Ok(system)
}

/// A document without errors, or all that is wrong with it.
fn document<T>(
    path: &Path,
    read: Result<(T, Vec<Problem>), ReadError>,
    check: impl FnOnce(&T) -> Vec<Problem>,
) -> Result<T> {
    let invalid = |problems: Vec<String>| Error::InvalidDescription { path: path.to_owned(), problems };
    let (document, mut problems) = read.map_err(|error| invalid(vec![error.to_string()]))?;
    problems.extend(check(&document));
    problems.retain(|problem| problem.severity == Severity::Error);
    if problems.is_empty() { Ok(document) } else { Err(invalid(problems.iter().map(ToString::to_string).collect())) }
}

impl Reader<'_> {
    /// Adds the components of a system and of those inside it; `path` is empty or ends with a dot.
    fn components(&mut self, system: &ssp::System, path: &str) {
        for element in &system.elements {
            let name = format!("{path}{}", element.name());
            match element {
                Element::System(inner) => self.components(inner, &format!("{name}.")),
                Element::Component(component) => {
                    let added = self.fmu(component).and_then(|file| self.system.add_fmu(name, file));
                    let what = format!("component `{}`", component.name);
                    added.unwrap_or_else(|error| self.errors.push(self.named(component.line, &what, error)));
                }
            }
        }
    }

    /// The FMU of a component.
    fn fmu(&self, component: &Component) -> Result<PathBuf> {
        let wrong = |text: String| self.wrong(component.line, format!("component `{}`: {text}", component.name));
        match component.media_type.as_deref() {
            None | Some(Component::FMU) => {}
            Some(other) => return Err(wrong(format!("a source of type `{other}` cannot be run here; only FMUs can"))),
        }
        if matches!(component.implementation, Implementation::ModelExchange | Implementation::ScheduledExecution) {
            let implementation = component.implementation;
            return Err(wrong(format!("{implementation:?} is asked for, but the master steps co-simulation FMUs")));
        }
        let source = self.path(&component.source).map_err(wrong)?;
        Ok(match (self.fmus, source.file_name()) {
            (Some(folder), Some(name)) => folder.join(name),
            _ => source,
        })
    }

    /// The file that a source means.
    fn path(&self, source: &str) -> Result<PathBuf, String> {
        let path = ssp::source_path(source).map_err(|error| error.to_string())?;
        let path = self.folder.join(path);
        if let Some(archive) = &self.archive {
            let inside = path.canonicalize().is_ok_and(|path| path.starts_with(archive.folder()));
            if path.exists() && !inside {
                return Err(format!("the source `{source}` lies outside the archive, which is not allowed"));
            }
        }
        Ok(path)
    }

    /// A problem at a line of the description.
    fn wrong(&self, line: usize, text: String) -> Error {
        let at = if line > 0 { format!("line {line}: ") } else { String::new() };
        Error::InvalidDescription { path: self.shown.to_owned(), problems: vec![format!("{at}{text}")] }
    }

    /// An error with the line that names the file, if the file is not there.
    fn named(&self, line: usize, what: &str, error: Error) -> Error {
        match error {
            Error::FileNotFound { path } => {
                Error::SourceNotFound { place: self.place(line), what: what.to_owned(), path }
            }
            error => error,
        }
    }

    /// A place for messages of the wiring.
    fn place(&self, line: usize) -> String {
        format!("{}:{line}", self.shown.display())
    }
}
