//! Checks a file against its standard without running it: all problems, each with its place.

use std::fmt;
use std::path::Path;

use swayless_modeldesc::problem::{Problem, Severity};
use swayless_modeldesc::read;
use swayless_modeldesc::types::ModelDescription;

use crate::archive::Unpacked;
use crate::error::{Error, Result};

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

/// Checks an FMU: its archive, its model description and whether there is something to run.
///
/// # Errors
///
/// Only if the file cannot be read; what is wrong with its content is what this function is asked for.
pub fn validate(path: &Path) -> Result<Vec<Finding>> {
    let archive = match Unpacked::open(path) {
        Ok(archive) => archive,
        Err(Error::Archive { problem, .. }) => return Ok(vec![whole(Severity::Error, problem.to_string())]),
        Err(error) => return Err(error),
    };
    let file = archive.folder().join(DESCRIPTION);
    if !file.is_file() {
        return Ok(vec![whole(Severity::Error, format!("there is no {DESCRIPTION} at the root, so this is no FMU"))]);
    }
    let bytes = std::fs::read(&file).map_err(|source| Error::io("read", file, source))?;
    let mut findings = Vec::new();
    match read::read_bytes(&bytes) {
        Ok((description, problems)) => {
            findings.extend(problems.into_iter().map(in_description));
            findings.extend(binaries(&description, archive.folder()));
        }
        Err(error) => findings.push(in_description(error.into())),
    }
    Ok(findings)
}

fn whole(severity: Severity, message: String) -> Finding {
    Finding { document: None, problem: Problem { line: 0, severity, message } }
}

fn in_description(problem: Problem) -> Finding {
    Finding { document: Some(DESCRIPTION.to_owned()), problem }
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
    names.into_iter().filter(missing).map(|name| whole(Severity::Error, message(name))).collect()
}
