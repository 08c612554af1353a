//! What can go wrong: typed errors that name the FMU, the variable, the file and the place, and say what to do.

mod parts;

use std::collections::HashSet;
use std::path::PathBuf;

use crate::slave::{Failure, LogMessage};

pub use parts::{ArchiveProblem, Suggestion};
use parts::{at, built, cycle, given, instead, list, or_none, said, until};

/// A result whose error is [`Error`] unless said otherwise.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Everything that can go wrong between opening a file and the last step of a run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file is not there.
    #[error("there is no file {}; check the path{}", path.display(), built(path))]
    FileNotFound {
        /// The file asked for.
        path: PathBuf,
    },
    /// A file that a document names is not there.
    #[error("{place}: {what}: there is no file {}; check its source{}", path.display(), built(path))]
    SourceNotFound {
        /// The document and its line.
        place: String,
        /// What names the file.
        what: String,
        /// The file.
        path: PathBuf,
    },
    /// A file cannot be read or written.
    #[error("cannot {action} {}: {source}", path.display())]
    Io {
        /// What was tried: `read`, `write`, …
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        source: std::io::Error,
    },
    /// An archive is broken or not to be trusted.
    #[error("{}: {problem}", path.display())]
    Archive {
        /// The archive.
        path: PathBuf,
        /// What is wrong with it.
        problem: ArchiveProblem,
    },
    /// An FMU has no `modelDescription.xml`.
    #[error("{} has no modelDescription.xml at its root, so it is no FMU", path.display())]
    NoDescription {
        /// The FMU.
        path: PathBuf,
    },
    /// A description (of a model or a system) has errors; all of them are given.
    #[error("{} is not valid:{}", path.display(), list(problems))]
    InvalidDescription {
        /// The document, inside an archive as `archive/document`.
        path: PathBuf,
        /// The problems, each with its line.
        problems: Vec<String>,
    },
    /// An FMU does not offer co-simulation.
    #[error("{}: `{model}` offers no co-simulation interface, only {offered}; the master needs one", path.display())]
    NoCoSimulation {
        /// The FMU.
        path: PathBuf,
        /// `modelName`.
        model: String,
        /// What it offers.
        offered: String,
    },
    /// An FMU has clocks that somebody else must tick.
    #[error(
        "{}: `{model}` leaves its clocks to the importer ({}), and this master ticks none{}",
        path.display(), clocks.join(", "), instead(alternative)
    )]
    Clocked {
        /// The FMU.
        path: PathBuf,
        /// `modelName`.
        model: String,
        /// Its input clocks.
        clocks: Vec<String>,
        /// An FMU beside it that ticks by itself.
        alternative: Option<PathBuf>,
    },
    /// An FMU has no binary for this platform.
    #[error(
        "{} has no binary for this platform: binaries/{wanted} is missing; it has {}",
        path.display(), or_none(available)
    )]
    NoBinary {
        /// The FMU.
        path: PathBuf,
        /// The file looked for, below `binaries/`.
        wanted: String,
        /// The binaries it has.
        available: Vec<String>,
    },
    /// A library cannot be loaded.
    #[error("cannot load {}: {reason}", path.display())]
    Load {
        /// The library.
        path: PathBuf,
        /// What the loader says; a missing dependency is named here.
        reason: String,
    },
    /// A library lacks a function of the standard.
    #[error("{} does not export {}; it is no FMI {version} co-simulation binary", path.display(), symbols.join(", "))]
    MissingSymbol {
        /// The library.
        path: PathBuf,
        /// The functions it lacks.
        symbols: Vec<&'static str>,
        /// The version of FMI that its description claims.
        version: &'static str,
    },
    /// An FMU cannot be instantiated twice.
    #[error("{}: `{model}` can be instantiated only once per process, and an instance exists", path.display())]
    OnlyOnce {
        /// The FMU.
        path: PathBuf,
        /// `modelName`.
        model: String,
    },
    /// Instantiation returned NULL.
    #[error(
        "{}: instantiating `{instance}` failed; usually the instantiation token of modelDescription.xml (`{token}`) is not \
         the one compiled into the binary, or resources are missing{}",
        path.display(), said(messages)
    )]
    Instantiate {
        /// The FMU.
        path: PathBuf,
        /// The instance.
        instance: String,
        /// The token that was passed.
        token: String,
        /// What the FMU logged.
        messages: Vec<LogMessage>,
    },
    /// Two instances share a name.
    #[error("the system has two instances called `{name}`; rename one")]
    DuplicateInstance {
        /// The name.
        name: String,
    },
    /// No instance has this name.
    #[error("{place}: there is no instance `{name}`{suggestion}")]
    UnknownInstance {
        /// Where it was named.
        place: String,
        /// The name.
        name: String,
        /// A name that was perhaps meant.
        suggestion: Suggestion,
    },
    /// No variable has this name.
    #[error("{place}: {of} has no variable `{name}`{suggestion}")]
    UnknownVariable {
        /// Where it was named.
        place: String,
        /// What it was looked for in.
        of: String,
        /// The name.
        name: String,
        /// A name that was perhaps meant.
        suggestion: Suggestion,
    },
    /// An array has no such element, or what is indexed is no array.
    #[error("{place}: {of} has no element `{name}`: {reason}")]
    UnknownElement {
        /// Where it was named.
        place: String,
        /// What it was looked for in.
        of: String,
        /// The element as written.
        name: String,
        /// Which elements there are.
        reason: String,
    },
    /// A connection does not lead from an output to an input.
    #[error("connection {from} → {to}: `{wrong}` is {causality}, but a connection leads from an output to an input")]
    Direction {
        /// The connection's source.
        from: String,
        /// The connection's sink.
        to: String,
        /// The end that is wrong.
        wrong: String,
        /// What it is.
        causality: String,
    },
    /// The types of a connection's ends do not go together.
    #[error("connection {from} → {to}: {from_type} cannot be connected to {to_type}")]
    TypeMismatch {
        /// The connection's source.
        from: String,
        /// The connection's sink.
        to: String,
        /// The source's type, with its dimensions.
        from_type: String,
        /// The sink's type, with its dimensions.
        to_type: String,
    },
    /// The units of a connection's ends do not go together.
    #[error("connection {from} → {to}: `{from_unit}` cannot be converted to `{to_unit}`: {reason}")]
    UnitMismatch {
        /// The connection's source.
        from: String,
        /// The connection's sink.
        to: String,
        /// The source's unit.
        from_unit: String,
        /// The sink's unit.
        to_unit: String,
        /// Why not.
        reason: String,
    },
    /// An input has more than one source.
    #[error("`{to}` has {} sources: {}; an input takes one", sources.len(), sources.join(", "))]
    SeveralSources {
        /// The input.
        to: String,
        /// What drives it.
        sources: Vec<String>,
    },
    /// Outputs depend on each other in a circle, directly.
    #[error(
        "algebraic loop: {}; the declared dependencies make each of these depend on itself at the same instant. Break it \
         with a component whose output does not feed through, declare the true dependencies in ModelStructure, or let \
         the loop's last connection pass its values a step late (--break-loops)",
        cycle(variables)
    )]
    AlgebraicLoop {
        /// The variables of the loop, each feeding the next and the last the first.
        variables: Vec<String>,
    },
    /// A value became NaN.
    #[error("`{variable}` is NaN at t = {time} s; the run stops before it spreads")]
    NotANumber {
        /// The variable that delivered it.
        variable: String,
        /// When (s).
        time: f64,
    },
    /// A start value does not fit its variable.
    #[error("{}start value {variable} = {value}: {reason}", given(place))]
    StartValue {
        /// The file and line where it was given, if in one.
        place: Option<String>,
        /// The variable.
        variable: String,
        /// The value as given.
        value: String,
        /// What is wrong with it.
        reason: String,
    },
    /// An FMU refused a start value.
    #[error(
        "{}{variable} = {value} was refused by the FMU ({}){}",
        given(place), failure.summary(), said(&failure.messages)
    )]
    Refused {
        /// The file and line where it was given, if in one.
        place: Option<String>,
        /// The variable.
        variable: String,
        /// The value.
        value: String,
        /// What the FMU answered.
        failure: Box<Failure>,
    },
    /// A call failed.
    #[error("`{instance}`: {}{}{}", failure.summary(), at(time), said(&failure.messages))]
    Call {
        /// The instance.
        instance: String,
        /// When (s), if the run had begun.
        time: Option<f64>,
        /// What the FMU answered.
        failure: Box<Failure>,
    },
    /// A step failed.
    #[error(
        "`{instance}` failed to step from t = {time} s by {step_size} s: {}{}{}",
        failure.summary(), until(failure, last_successful_time), said(&failure.messages)
    )]
    StepFailed {
        /// The instance.
        instance: String,
        /// Where the step began (s).
        time: f64,
        /// Its length (s).
        step_size: f64,
        /// How far the instance got, if it says (s).
        last_successful_time: Option<f64>,
        /// What the FMU answered.
        failure: Box<Failure>,
    },
    /// An input file has an error.
    #[error("{}:{line}: {reason}", path.display())]
    Signals {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: u64,
        /// What is wrong.
        reason: String,
    },
    /// An observer stopped the run.
    #[error("interrupted at t = {time} s; what was written until then is whole")]
    Interrupted {
        /// When (s).
        time: f64,
    },
    /// An option makes no sense.
    #[error("{0}")]
    Option(String),
    /// Several problems at once.
    #[error("{} problems:{}", .0.len(), list(.0))]
    Several(Vec<Error>),
}

impl Error {
    /// The single problems that this error consists of.
    pub fn problems(&self) -> Vec<&Error> {
        match self {
            Self::Several(errors) => errors.iter().flat_map(Self::problems).collect(),
            single => vec![single],
        }
    }

    /// Whether a description or an archive is at fault, so that validation found problems rather than a run failed.
    pub fn is_invalid_file(&self) -> bool {
        matches!(self, Self::Archive { .. } | Self::NoDescription { .. } | Self::InvalidDescription { .. })
    }

    /// Whether what was asked for makes no sense, so that the usage is at fault.
    pub fn is_usage(&self) -> bool {
        match self {
            Self::Several(errors) => errors.iter().all(Self::is_usage),
            single => matches!(single, Self::Option(_)),
        }
    }

    /// An error of the operating system, told apart from a file that is not there.
    pub(crate) fn io(action: &'static str, path: impl Into<PathBuf>, source: std::io::Error) -> Self {
        let path = path.into();
        match source.kind() {
            std::io::ErrorKind::NotFound if action == "read" => Self::FileNotFound { path },
            _ => Self::Io { action, path, source },
        }
    }

    /// `Ok` without problems, the problem itself when it is one, else all of them, each once.
    pub(crate) fn all(mut errors: Vec<Error>) -> Result<()> {
        let mut seen = HashSet::new();
        errors.retain(|error| seen.insert(error.to_string()));
        match errors.len() {
            0 => Ok(()),
            1 => Err(errors.remove(0)),
            _ => Err(Self::Several(errors)),
        }
    }
}
