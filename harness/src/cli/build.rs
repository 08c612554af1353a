//! `swayless build`.

use std::path::PathBuf;

use swayless::package::{self, Options};

use super::{Failure, Outcome, console};

/// Compile the FMUs and package each for FMI 2.0 and FMI 3.0.
///
/// Writes <OUTPUT-DIR>/fmi2/<Name>.fmu and <OUTPUT-DIR>/fmi3/<Name>.fmu, and <OUTPUT-DIR>/fmi3/<Name>Clocked.fmu where
/// an FMU has clocks. The same source, toolchain and lock file give
/// the same bytes from any folder. RUSTFLAGS in the environment and `build.rustflags` in a cargo configuration stay in
/// force; `target.<triple>.rustflags` in a cargo configuration would let local paths into the binaries.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// FMUs to build, by name (BoomCrane) or crate (boom-crane) [default: all below fmus/]
    #[arg(value_name = "FMU")]
    names: Vec<String>,
    /// The workspace's folder or Cargo.toml [default: the one around the current folder]
    #[arg(long, value_name = "PATH")]
    workspace: Option<PathBuf>,
    /// Where cargo compiles [default: cargo's own choice]
    #[arg(long, value_name = "DIR")]
    target_dir: Option<PathBuf>,
    /// Where the folders fmi2 and fmi3 are made [default: `fmus` in the target folder]
    #[arg(long, short, value_name = "DIR")]
    output_dir: Option<PathBuf>,
    /// With all below fmus/, those below tests/fmus/ too
    #[arg(long)]
    test_fmus: bool,
    /// Make libraries for old Linux systems too: they need no symbol newer than GLIBC_2.28. Takes cargo-zigbuild and
    /// zig (`pip install cargo-zigbuild ziglang`)
    #[arg(long)]
    portable: bool,
    /// Build nothing, but add to an FMU the binaries of the same model in FROM: an FMU, or the folder of an unpacked
    /// one, that was built on another platform. Each is checked: its format, its functions, its variables' texts
    #[arg(long, num_args = 2, value_names = ["FMU", "FROM"])]
    #[arg(conflicts_with_all = ["names", "workspace", "target_dir", "output_dir", "test_fmus", "portable", "json"])]
    add_platform: Option<Vec<PathBuf>>,
    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    if let Some([fmu, from]) = arguments.add_platform.as_deref() {
        let added = package::add_platforms(fmu, from)?;
        if added.is_empty() {
            console::note(format_args!("{} has all of them already", fmu.display()));
        }
        added.iter().try_for_each(|name| console::print(format_args!("{}: {name}", fmu.display())))?;
        return Ok(Outcome::Done);
    }
    let built = build(Options {
        workspace: arguments.workspace.clone(),
        target_dir: arguments.target_dir.clone(),
        output_dir: arguments.output_dir.clone(),
        names: arguments.names.clone(),
        test_fmus: arguments.test_fmus,
        portable: arguments.portable,
    })?;
    if arguments.json {
        let fmus: Vec<_> = built.packages.iter().map(json).collect();
        console::print(format_args!("{:#}", serde_json::json!(fmus)))?;
    } else {
        for package in &built.packages {
            for archive in package.archives() {
                console::print(archive.display())?;
            }
        }
    }
    Ok(Outcome::Done)
}

/// A package as JSON; `clocked` is there if there is one.
fn json(package: &package::Package) -> serde_json::Value {
    let package::Package { name, description, fmi2, fmi3, clocked } = package;
    let mut json = serde_json::json!({ "name": name, "description": description, "fmi2": fmi2, "fmi3": fmi3 });
    if let Some(clocked) = clocked {
        json["clocked"] = serde_json::json!(clocked);
    }
    json
}

/// Builds, telling of the progress.
pub fn build(options: Options) -> Result<package::Built, Failure> {
    let built = package::build(&options, |krate| console::note(format_args!("   Packaging {krate}")))?;
    for name in &built.with_local_paths {
        console::warn(format_args!(
            "the binary of {name} tells in which folder it was built, so it is not reproducible elsewhere; \
             is `target.<triple>.rustflags` set in a cargo configuration?"
        ));
    }
    Ok(built)
}
