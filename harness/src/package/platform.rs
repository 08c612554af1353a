//! The platforms that FMI has names for, and what a library for each looks like.

use object::{Architecture, BinaryFormat, Object};
use swayless_modeldesc::types::FmiVersion;

/// A platform.
#[derive(Debug, PartialEq, Eq)]
pub struct Platform {
    /// Its name in FMI 3.0 and, since 2.0.4, in FMI 2.0.
    tuple: &'static str,
    /// Its name in FMI 2.0 from the beginning, if it had one.
    short: Option<&'static str>,
    /// What libraries are called there, after the dot.
    pub extension: &'static str,
    format: BinaryFormat,
    architecture: Architecture,
}

const fn platform(
    tuple: &'static str,
    short: Option<&'static str>,
    extension: &'static str,
    format: BinaryFormat,
    architecture: Architecture,
) -> Platform {
    Platform { tuple, short, extension, format, architecture }
}

/// All that FMUs are built for.
const PLATFORMS: [Platform; 6] = [
    platform("x86_64-linux", Some("linux64"), "so", BinaryFormat::Elf, Architecture::X86_64),
    platform("aarch64-linux", None, "so", BinaryFormat::Elf, Architecture::Aarch64),
    platform("x86_64-windows", Some("win64"), "dll", BinaryFormat::Pe, Architecture::X86_64),
    platform("aarch64-windows", None, "dll", BinaryFormat::Pe, Architecture::Aarch64),
    platform("x86_64-darwin", Some("darwin64"), "dylib", BinaryFormat::MachO, Architecture::X86_64),
    platform("aarch64-darwin", None, "dylib", BinaryFormat::MachO, Architecture::Aarch64),
];

impl Platform {
    /// The one that this is compiled for.
    pub fn here() -> Option<&'static Self> {
        let system = match std::env::consts::OS {
            "macos" => "darwin",
            other => other,
        };
        Self::named(&format!("{}-{system}", std::env::consts::ARCH))
    }

    /// The one with this name in either version.
    pub fn named(name: &str) -> Option<&'static Self> {
        PLATFORMS.iter().find(|p| p.tuple == name || p.short == Some(name))
    }

    /// Its name in a version: the folder below `binaries/`.
    pub fn name(&self, version: FmiVersion) -> &'static str {
        self.short.filter(|_| version == FmiVersion::V2).unwrap_or(self.tuple)
    }

    /// The names of all, for messages.
    pub fn names(version: FmiVersion) -> String {
        PLATFORMS.iter().map(|p| p.name(version)).collect::<Vec<_>>().join(", ")
    }

    /// What is wrong with a library that is said to be for this platform, if anything.
    pub fn problem(&self, file: &object::File<'_>) -> Option<String> {
        let (format, architecture) = (file.format(), file.architecture());
        let wanted = (self.format, self.architecture);
        (wanted != (format, architecture)).then(|| {
            format!("it is {format:?} for {architecture:?}, and {} takes {:?} for {:?}", self.tuple, wanted.0, wanted.1)
        })
    }
}
