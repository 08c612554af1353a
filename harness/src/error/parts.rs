//! Parts of error messages.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::slave::{Failure, LogMessage, Status};

/// What is wrong with an archive.
#[derive(Debug, thiserror::Error)]
#[allow(missing_docs, reason = "each message says what its variant is")]
pub enum ArchiveProblem {
    #[error("cannot be read as a zip archive: {reason}; perhaps it was not copied completely")]
    Broken { reason: String },
    #[error("the entry `{entry}` would leave the folder that the archive is unpacked to ({why}); do not use this file")]
    Escapes { entry: String, why: &'static str },
    #[error("the entry `{entry}` is a {kind}, which no FMU may contain")]
    Special { entry: String, kind: &'static str },
    #[error("the entry `{entry}` occurs twice (upper and lower case count as the same)")]
    Duplicate { entry: String },
    #[error("it has {count} entries, more than the {limit} that are allowed")]
    TooManyEntries { count: usize, limit: usize },
    #[error("it unpacks to more than the {limit} bytes that are allowed")]
    TooLarge { limit: u64 },
    #[error("it unpacks to more than {limit} times its own size, like a zip bomb")]
    Inflates { limit: u64 },
}

/// "did you mean …?", or nothing when no name is close.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Suggestion(pub Option<String>);

impl Suggestion {
    /// The candidate that is closest to `name`, if it is close enough to be a slip.
    pub fn find<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Self {
        let best = candidates
            .into_iter()
            .map(|candidate| (strsim::damerau_levenshtein(&name.to_lowercase(), &candidate.to_lowercase()), candidate))
            .min_by_key(|&(distance, _)| distance);
        let allowed = (name.chars().count() / 3).max(2);
        Self(best.filter(|&(distance, _)| distance <= allowed).map(|(_, candidate)| candidate.to_owned()))
    }
}

impl fmt::Display for Suggestion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Some(name) => write!(f, "; did you mean `{name}`?"),
            None => Ok(()),
        }
    }
}

pub(super) fn list<T: fmt::Display>(items: &[T]) -> String {
    items.iter().map(|item| format!("\n  {item}")).collect()
}

pub(super) fn or_none(items: &[String]) -> String {
    if items.is_empty() { "none".to_owned() } else { items.join(", ") }
}

pub(super) fn cycle(variables: &[String]) -> String {
    variables.iter().chain(variables.first()).map(|name| format!("`{name}`")).collect::<Vec<_>>().join(" → ")
}

pub(super) fn at(time: &Option<f64>) -> String {
    time.map(|time| format!(" at t = {time} s")).unwrap_or_default()
}

/// How far a step got. After Discard the instance is not broken, and somebody may know a way on.
pub(super) fn until(failure: &Failure, time: &Option<f64>) -> String {
    let reached = time.map(|time| format!("; it got as far as t = {time} s")).unwrap_or_default();
    match failure.status {
        Status::Discard => format!("{reached}; it may succeed with a smaller --step-size or other inputs"),
        _ => reached,
    }
}

/// The file and line that a message begins with.
pub(super) fn given(place: &Option<String>) -> String {
    place.as_ref().map(|place| format!("{place}: ")).unwrap_or_default()
}

/// Where a file comes from that is not there.
pub(super) fn built(path: &Path) -> &'static str {
    match path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("fmu")) {
        true => " (FMUs are built with `swayless build`)",
        false => "",
    }
}

/// The FMU to take instead of one that cannot be run.
pub(super) fn instead(alternative: &Option<PathBuf>) -> String {
    alternative.as_ref().map(|path| format!("; {} ticks them itself", path.display())).unwrap_or_default()
}

pub(super) fn said(messages: &[LogMessage]) -> String {
    if messages.is_empty() {
        return "; the FMU logged nothing".to_owned();
    }
    format!("; the FMU says:{}", list(messages))
}
