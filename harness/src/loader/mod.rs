//! The one room of the harness with unsafe code: FMU binaries, their C functions and the callbacks they get.
//!
//! Loading a binary runs foreign code, and nothing can make that safe: who does not trust an FMU must not run it. What
//! this room guarantees is its own side: every pointer that it passes is valid for as many values as it says, for as
//! long as the standard demands; everything that comes back (status, Booleans, strings, NULL) may be anything that the
//! types of the C functions allow.

mod callbacks;
mod fmi2;
mod fmi3;
mod library;
mod scratch;

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use swayless_modeldesc::types::{DataType, FmiVersion};

use crate::archive::Unpacked;
use crate::error::{Error, Result};
use crate::slave::{Failure, Slave, Status};

/// A loaded binary of either version.
#[derive(Clone)]
pub(crate) enum Binary {
    /// Of FMI 2.0.
    V2(Arc<fmi2::Binary>),
    /// Of FMI 3.0.
    V3(Arc<fmi3::Binary>),
}

/// What an instance is made with.
pub(crate) struct Instantiation<'a> {
    /// The FMU, for messages.
    pub fmu: &'a Path,
    /// The instance's name.
    pub name: &'a str,
    /// The token of the description.
    pub token: &'a str,
    /// The folder of the resources, absolute.
    pub resources: &'a Path,
    /// Whether debug messages are wanted.
    pub logging: bool,
    /// The log categories of problems that the FMU declares; they are wanted without debug messages too.
    pub problems: &'a [&'a str],
    /// Held by the instance when the FMU allows only one.
    pub once: Option<Once>,
}

/// Marks an FMU as instantiated for as long as it lives.
pub(crate) struct Once(pub Arc<AtomicBool>);

impl Drop for Once {
    fn drop(&mut self) {
        self.0.store(false, Ordering::Release);
    }
}

impl Binary {
    /// Loads a library and looks up its functions. `unpacked` is kept as long as the library is loaded.
    pub(crate) fn load(version: FmiVersion, path: &Path, unpacked: Arc<Unpacked>) -> Result<Self> {
        let library = library::Library::open(path, unpacked)?;
        Ok(match version {
            FmiVersion::V2 => Self::V2(Arc::new(fmi2::Binary::new(library)?)),
            FmiVersion::V3 => Self::V3(Arc::new(fmi3::Binary::new(library)?)),
        })
    }

    /// Makes an instance for co-simulation.
    pub(crate) fn instantiate(&self, with: Instantiation) -> Result<Box<dyn Slave>> {
        Ok(match self {
            Self::V2(binary) => Box::new(fmi2::Instance::new(binary.clone(), with)?),
            Self::V3(binary) => Box::new(fmi3::Instance::new(binary.clone(), with)?),
        })
    }
}

/// Where an instance is in its life cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Phase {
    Instantiated,
    Configuration,
    Initialization,
    Stepping,
    /// A step was discarded: it can be terminated, and that is all.
    StepFailed,
    Terminated,
    /// A call returned Error: only reset and free are allowed.
    Failed,
    /// A call returned Fatal: nothing is allowed, not even free.
    Broken,
}

impl Phase {
    /// Refuses a call that the standard does not allow in this phase.
    #[inline]
    fn expect(self, call: &'static str, allowed: &[Phase]) -> Result<(), Failure> {
        if allowed.contains(&self) { Ok(()) } else { Err(self.refuse(call)) }
    }

    #[cold]
    fn refuse(self, call: &'static str) -> Failure {
        let now = match self {
            Self::Instantiated => "only instantiated",
            Self::Configuration => "in configuration mode",
            Self::Initialization => "being initialized",
            Self::Stepping => "initialized and ready to step",
            Self::StepFailed => "in the middle of a step that failed",
            Self::Terminated => "terminated",
            Self::Failed => "unusable since a call returned Error; it can only be reset",
            Self::Broken => "unusable since a call returned Fatal",
        };
        Failure::new(call, Status::NotCalled, format!("out of order: the instance is {now}"))
    }

    /// Refuses to get or set values where the standard never allows it.
    #[inline]
    fn expect_accessible(self, call: &'static str) -> Result<(), Failure> {
        match self {
            Self::Failed | Self::Broken => Err(self.refuse(call)),
            _ => Ok(()),
        }
    }
}

/// Refuses slices of which the C function would read or write more than there is.
#[inline]
fn check_lengths(call: &'static str, references: usize, values: usize, scalars_only: bool) -> Result<(), Failure> {
    if references == values || !scalars_only && values > references {
        return Ok(());
    }
    Err(wrong_lengths(call, references, values))
}

#[cold]
fn wrong_lengths(call: &'static str, references: usize, values: usize) -> Failure {
    Failure::new(call, Status::NotCalled, format!("{references} value references but {values} values"))
}

/// A function that may be missing in a sloppy library.
fn present<F>(name: &'static str, function: Option<F>) -> Result<F, Failure> {
    function.ok_or_else(|| Failure::new(name, Status::NotCalled, "the library does not export it"))
}

fn wrong_type(call: &'static str, data_type: DataType) -> Failure {
    Failure::new(call, Status::NotCalled, format!("a {data_type:?} is asked for as another type"))
}

/// A C string for an FMU; it cannot hold a NUL.
fn c_string(text: &str) -> Result<std::ffi::CString> {
    std::ffi::CString::new(text)
        .map_err(|_| Error::Option(format!("{text:?} contains a NUL, which no FMU can be told")))
}
