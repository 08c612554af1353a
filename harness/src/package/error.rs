//! What can go wrong when FMUs are built.

use std::path::{Path, PathBuf};

/// A build that did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file or folder could not be read or written.
    #[error("cannot use {}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// Cargo does not know a workspace here.
    #[error("cannot read the cargo workspace: run this inside a clone of Swayless, or name one with --workspace")]
    Workspace(#[source] cargo_metadata::Error),
    /// The workspace holds no FMUs.
    #[error("{} has no FMU crates: packages below fmus/ or tests/fmus/ that build a cdylib", .0.display())]
    NoFmus(PathBuf),
    /// An FMU of this name is not in the workspace.
    #[error("there is no FMU named `{name}`{}; known are {}", hint(suggestion), known.join(", "))]
    UnknownFmu {
        /// The name asked for.
        name: String,
        /// The one that was probably meant.
        suggestion: Option<String>,
        /// All there are, by crate.
        known: Vec<String>,
    },
    /// Cargo could not be started.
    #[error("cannot start `{program}`: is Rust installed and on the PATH?")]
    NoCargo {
        /// The program.
        program: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// A portable build needs tools that are not there.
    #[error(
        "a portable build takes cargo-zigbuild and zig, and one of them is not there: \
         run `pip install cargo-zigbuild ziglang`, or build without --portable"
    )]
    NoZig,
    /// A portable build is asked for where there is none.
    #[error("a portable build is for Linux; on {0}, build without --portable")]
    PortableElsewhere(&'static str),
    /// An FMU that binaries are to be added to, or taken from, cannot be used.
    #[error("{0}")]
    Fmu(#[source] Box<crate::Error>),
    /// There are no binaries to add.
    #[error("{} has no binary named `{name}` for a platform that FMI has a name for: {known}", folder.display())]
    NothingToAdd {
        /// The folder that was looked into.
        folder: PathBuf,
        /// What the binaries would be named.
        name: String,
        /// The platforms.
        known: String,
    },
    /// A binary that is to be added does not fit.
    #[error("{} is not added: {problem}", path.display())]
    Foreign {
        /// The binary.
        path: PathBuf,
        /// Why not.
        problem: String,
    },
    /// A tool that was asked for something failed.
    #[error("{command} failed: {said}")]
    Tool {
        /// The command.
        command: String,
        /// What it said.
        said: String,
    },
    /// Something linked into an FMU brings no text of its licence.
    #[error(
        "no licence text for {of} in {}: an FMU that holds it must not be passed on without; \
         use another crate, or a release of it that brings its licence",
        folder.display()
    )]
    NoLicense {
        /// What it is.
        of: String,
        /// Where the text was looked for.
        folder: PathBuf,
    },
    /// Cargo's answer cannot be read.
    #[error("cannot understand cargo's messages")]
    Messages(#[source] std::io::Error),
    /// The FMUs do not compile.
    #[error("the FMUs do not compile; cargo's messages above say why")]
    Compile,
    /// Cargo built a crate without naming a library.
    #[error("cargo named no dynamic library for `{0}`")]
    NoLibrary(String),
    /// A library cannot be loaded.
    #[error("cannot load {}", path.display())]
    Load {
        /// The library.
        path: PathBuf,
        /// What the loader said.
        source: libloading::Error,
    },
    /// A library does not describe itself.
    #[error("{} does not tell its `{item}`", path.display())]
    NoAnswer {
        /// The library.
        path: PathBuf,
        /// What it was asked for.
        item: String,
    },
    /// A library's description of itself is not what a packager can use.
    #[error("{}: its `{item}` {problem}", path.display())]
    BadAnswer {
        /// The library.
        path: PathBuf,
        /// What it was asked for.
        item: String,
        /// What is wrong with the answer.
        problem: String,
    },
    /// There is no name for this platform in FMI.
    #[error("FMI has no name for {arch} on {os}, so no FMU can be built here")]
    Platform {
        /// The architecture.
        arch: &'static str,
        /// The operating system.
        os: &'static str,
    },
    /// An archive could not be written.
    #[error("cannot write {}", path.display())]
    Zip {
        /// The archive.
        path: PathBuf,
        /// What is wrong.
        source: zip::result::ZipError,
    },
}

impl Error {
    /// For `map_err`: an error of the system about this path.
    pub(super) fn io(path: &Path) -> impl FnOnce(std::io::Error) -> Self + use<> {
        let path = path.to_owned();
        move |source| Self::Io { path, source }
    }

    /// For `map_err`: an FMU that cannot be used.
    pub(super) fn fmu(error: crate::Error) -> Self {
        Self::Fmu(Box::new(error))
    }

    /// An answer of a library that cannot be used.
    pub(super) fn bad_answer(path: &Path, item: &std::ffi::CStr, problem: impl std::fmt::Display) -> Self {
        Self::BadAnswer {
            path: path.to_owned(),
            item: item.to_string_lossy().into_owned(),
            problem: problem.to_string(),
        }
    }
}

fn hint(suggestion: &Option<String>) -> String {
    suggestion.as_ref().map(|s| format!(" (did you mean `{s}`?)")).unwrap_or_default()
}
