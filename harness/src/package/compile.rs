//! Compiles FMU crates with cargo so that their bytes do not depend on where that happens.

use std::ffi::OsString;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use cargo_metadata::{Artifact, CrateType, Message};

use super::Error;
use super::workspace::{FmuCrate, Workspace};

/// The cargo profile that FMUs are compiled with.
const PROFILE: &str = "fmu";

/// Separates flags in `CARGO_ENCODED_RUSTFLAGS`.
const SEPARATOR: char = '\x1f';

/// Cargo with zig as the linker.
pub const ZIGBUILD: &str = "cargo-zigbuild";

/// The version of the GNU C library that portable libraries make do with.
const GLIBC: &str = "2.28";

/// Compiles FMU crates and returns their libraries, in the same order. The bytes of one should not depend on the others
/// that are built with it: cargo unites the features of the packages it is given, so what all of them share asks for all
/// features that any of them needs.
pub fn compile(
    workspace: &Workspace,
    crates: &[FmuCrate],
    target_dir: &Path,
    portable: bool,
) -> Result<Vec<PathBuf>, Error> {
    let artifacts = run(builder(portable)?, workspace, crates, target_dir)?;
    crates.iter().map(|c| library(&artifacts, c).ok_or_else(|| Error::NoLibrary(c.name.clone()))).collect()
}

/// One run of cargo, and what it produced.
fn run(
    mut command: Command,
    workspace: &Workspace,
    crates: &[FmuCrate],
    target_dir: &Path,
) -> Result<Vec<Artifact>, Error> {
    // Cargo reads configuration from the current folder upwards, so it is run in the workspace, as a user would.
    command.current_dir(&workspace.root);
    command.args(["--profile", PROFILE, "--message-format", "json-render-diagnostics", "--target-dir"]);
    command.arg(target_dir);
    for krate in crates {
        command.args(["--package", &krate.name]);
    }
    remap_paths(&mut command, workspace);
    command.stdin(Stdio::null()).stdout(Stdio::piped());
    let mut child = command.spawn().map_err(|source| {
        let program = command.get_program().to_string_lossy().into_owned();
        Error::NoCargo { program, source }
    })?;
    let mut artifacts = Vec::new();
    if let Some(stdout) = child.stdout.take() {
        for message in Message::parse_stream(BufReader::new(stdout)) {
            if let Message::CompilerArtifact(artifact) = message.map_err(Error::Messages)? {
                artifacts.push(artifact);
            }
        }
    }
    if !child.wait().map_err(Error::Messages)?.success() {
        return Err(Error::Compile);
    }
    Ok(artifacts)
}

/// The command that builds.
fn builder(portable: bool) -> Result<Command, Error> {
    if portable {
        return zigbuild();
    }
    let mut command = Command::new(cargo());
    command.arg("build");
    Ok(command)
}

/// Cargo: the one that runs us, if one does.
pub fn cargo() -> OsString {
    std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// Cargo with zig as the linker: zig knows which symbols each version of the C library has.
fn zigbuild() -> Result<Command, Error> {
    use std::env::consts::{ARCH, OS};
    if OS != "linux" {
        return Err(Error::PortableElsewhere(OS));
    }
    // Asks the tool for zig's compiler: both are there, or one message says what to do.
    let asked = Command::new(ZIGBUILD).args(["zig", "cc", "--", "--version"]).stdin(Stdio::null()).output();
    if !asked.is_ok_and(|answer| answer.status.success()) {
        return Err(Error::NoZig);
    }
    let mut command = Command::new(ZIGBUILD);
    command.args(["zigbuild", "--target", &format!("{ARCH}-unknown-linux-gnu.{GLIBC}")]);
    Ok(command)
}

/// The dynamic library among what cargo produced for a crate.
fn library(artifacts: &[Artifact], krate: &FmuCrate) -> Option<PathBuf> {
    artifacts
        .iter()
        .filter(|a| a.target.crate_types.contains(&CrateType::CDyLib))
        .filter(|a| a.target.name.replace('_', "-") == krate.name.replace('_', "-"))
        .flat_map(|a| &a.filenames)
        .find(|f| f.extension().is_some_and(|e| e == std::env::consts::DLL_EXTENSION))
        .map(|f| f.clone().into_std_path_buf())
}

/// Has the compiler write `/swayless` and `/cargo` for the workspace and cargo's home. Flags of the user's environment
/// stay in force; flags in `build.rustflags` of a cargo configuration do as well. Cargo takes flags from one place
/// only, so flags in `target.<triple>.rustflags` of a configuration would displace ours: the build says so then.
fn remap_paths(command: &mut Command, workspace: &Workspace) {
    let ours: Vec<OsString> = local_paths(workspace)
        .into_iter()
        .map(|(path, name)| {
            let mut flag = OsString::from("--remap-path-prefix=");
            flag.push(path);
            flag.push("=");
            flag.push(name);
            flag
        })
        .collect();
    let encoded = std::env::var_os("CARGO_ENCODED_RUSTFLAGS").or_else(|| {
        let plain = std::env::var("RUSTFLAGS").ok()?;
        Some(plain.split_whitespace().collect::<Vec<_>>().join(&SEPARATOR.to_string()).into())
    });
    if let Some(mut flags) = encoded {
        for flag in ours {
            if !flags.is_empty() {
                flags.push(SEPARATOR.to_string());
            }
            flags.push(flag);
        }
        command.env("CARGO_ENCODED_RUSTFLAGS", flags);
    } else {
        // A JSON array of strings is a TOML one too.
        let flags: Vec<_> = ours.iter().map(|f| f.to_string_lossy()).collect();
        command.arg("--config").arg(format!("build.rustflags={}", serde_json::json!(flags)));
    }
}

/// Folders that must not show in a library, and what shows in their place.
fn local_paths(workspace: &Workspace) -> Vec<(PathBuf, &'static str)> {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(std::env::home_dir()?.join(".cargo")));
    // The last match wins, so the workspace, which may lie below cargo's home, comes last.
    home.map(|h| (h, "/cargo")).into_iter().chain([(workspace.root.clone(), "/swayless")]).collect()
}

/// Whether a library names a folder of this machine.
pub fn tells_where_it_was_built(library: &[u8], workspace: &Workspace) -> bool {
    local_paths(workspace).iter().any(|(path, _)| {
        let path = path.as_os_str().as_encoded_bytes();
        path.len() > 1 && library.windows(path.len()).any(|w| w == path)
    })
}
