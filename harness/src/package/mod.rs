//! Compiles the workspace's FMU crates and packages each library for FMI 2.0 and FMI 3.0.
//!
//! The archive's description is asked from the library that lies in it, so the two cannot drift. The same source,
//! toolchain and lock file give the same bytes from any folder: the compiler is told to leave local paths out, and
//! everything in an archive that usually depends on the day or the machine is fixed.

mod archive;
mod compile;
mod describe;
mod error;
mod icon;
mod licenses;
mod merge;
mod page;
mod platform;
mod reference;
mod workspace;

use std::path::{Path, PathBuf};

use swayless_modeldesc::types::FmiVersion;

pub use error::Error;
pub use merge::add_platforms;

/// What to build, from where and to where.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// A `Cargo.toml`, or a folder in the workspace; the current folder unless given.
    pub workspace: Option<PathBuf>,
    /// Where cargo compiles; cargo's own choice unless given.
    pub target_dir: Option<PathBuf>,
    /// Where the folders `fmi2` and `fmi3` are made; `fmus` in the target folder unless given.
    pub output_dir: Option<PathBuf>,
    /// The FMUs wanted, by name (`BoomCrane`) or by crate (`boom-crane`); all that are shipped when empty.
    pub names: Vec<String>,
    /// With all that are shipped, those below `tests/fmus/` too.
    pub test_fmus: bool,
    /// Whether the libraries run on old systems as well; see [`build`].
    pub portable: bool,
}

/// One FMU, packaged for both versions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Package {
    /// Its name: the file stem of both archives.
    pub name: String,
    /// What it is, in a line: the crate's description.
    pub description: String,
    /// The archive for FMI 2.0.
    pub fmi2: PathBuf,
    /// The archive for FMI 3.0.
    pub fmi3: PathBuf,
    /// The archive of the FMU with clocks, for FMI 3.0, if the library has one.
    pub clocked: Option<PathBuf>,
}

impl Package {
    /// All its archives.
    pub fn archives(&self) -> impl Iterator<Item = &Path> {
        [&self.fmi2, &self.fmi3].into_iter().chain(&self.clocked).map(PathBuf::as_path)
    }
}

/// What came of a build.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Built {
    /// The workspace's folder.
    pub workspace: PathBuf,
    /// The folder that holds `fmi2` and `fmi3`.
    pub output_dir: PathBuf,
    /// The FMUs, in the order of their crates' names.
    pub packages: Vec<Package>,
    /// Names of FMUs whose library tells where it was built, so that its bytes depend on the folder.
    pub with_local_paths: Vec<String>,
}

impl Built {
    /// The folder with the archives for this version.
    pub fn folder(&self, version: FmiVersion) -> PathBuf {
        self.output_dir.join(folder(version))
    }
}

/// Compiles and packages. What cargo has to say goes to stderr; `progress` hears of each FMU before it is written.
///
/// A portable build is for Linux: its libraries need no symbol newer than GLIBC_2.28 and no library beside the C
/// library's own. It takes `cargo-zigbuild` and `zig`, and puts the libraries into a folder of their own in the target
/// folder.
pub fn build(options: &Options, mut progress: impl FnMut(&str)) -> Result<Built, Error> {
    let workspace = workspace::Workspace::find(options.workspace.as_deref())?;
    let crates = workspace.select(&options.names, options.test_fmus)?;
    let target_dir = absolute(options.target_dir.as_deref().unwrap_or(&workspace.target_dir))?;
    let output_dir = match &options.output_dir {
        Some(folder) => absolute(folder)?,
        None => target_dir.join("fmus"),
    };
    let libraries = compile::compile(&workspace, &crates, &target_dir, options.portable)?;
    let licenses = licenses::Licenses::find(&workspace, options.portable)?;
    let mut built =
        Built { workspace: workspace.root.clone(), output_dir, packages: Vec::new(), with_local_paths: Vec::new() };
    for (krate, library) in crates.iter().zip(libraries) {
        progress(&krate.name);
        let parts = describe::describe(&library)?;
        let binary = std::fs::read(&library).map_err(Error::io(&library))?;
        if compile::tells_where_it_was_built(&binary, &workspace) {
            built.with_local_paths.push(parts.name.clone());
        }
        let licenses = licenses.of(krate)?;
        let entries = |version, name: &str, description: &str| {
            let (parts, binary, licenses) = (&parts, &*binary, &*licenses);
            archive::entries(&archive::Contents { version, name, description, parts, binary, licenses })
        };
        // The run takes an FMU that can be imported; both versions give the same bits, so one run serves both.
        let reference = {
            let draft = tempfile::tempdir().map_err(Error::io(&std::env::temp_dir()))?;
            let path = draft.path().join("draft.fmu");
            archive::write(&path, &entries(FmiVersion::V3, &parts.name, &parts.fmi3)?)?;
            reference::entries(&path)?
        };
        let write = |version, name: &str, description: &str, reference: &[(String, Vec<u8>)]| {
            let path = built.output_dir.join(folder(version)).join(format!("{name}.fmu"));
            let mut entries = entries(version, name, description)?;
            // The binary stays last.
            let binary = entries.len() - 1;
            entries.splice(binary..binary, reference.iter().cloned());
            archive::write(&path, &entries).map(|()| path)
        };
        let clocked = |description: &String| write(FmiVersion::V3, &parts.clocked_name(), description, &[]);
        built.packages.push(Package {
            fmi2: write(FmiVersion::V2, &parts.name, &parts.fmi2, &reference)?,
            fmi3: write(FmiVersion::V3, &parts.name, &parts.fmi3, &reference)?,
            clocked: parts.clocked.as_ref().map(clocked).transpose()?,
            description: krate.description.clone(),
            name: parts.name,
        });
    }
    Ok(built)
}

/// The name of the folder for a version.
fn folder(version: FmiVersion) -> &'static str {
    match version {
        FmiVersion::V2 => "fmi2",
        FmiVersion::V3 => "fmi3",
    }
}

fn absolute(path: &Path) -> Result<PathBuf, Error> {
    std::path::absolute(path).map_err(Error::io(path))
}
