//! What the tests run on: every FMU, built and packaged once, and the `swayless` command.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use swayless::Fmu;
use swayless::package::{self, Built, Options, Package};
use swayless_modeldesc::types::FmiVersion;

/// The versions that every FMU is packaged for.
pub const VERSIONS: [FmiVersion; 2] = [FmiVersion::V2, FmiVersion::V3];

/// The repository's folder.
pub fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace's folder")
}

/// A file of reference values.
pub fn data(name: &str) -> serde_json::Value {
    let text = std::fs::read_to_string(repository().join("tests/data").join(name)).expect("a file");
    serde_json::from_str(&text).expect("JSON")
}

/// The tests' own target folder, so that building FMUs neither waits for nor disturbs the build of the tests.
pub fn target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("tests")
}

/// Runs something that other test processes may do at the same time, one after the other.
pub fn locked<T>(name: &str, work: impl FnOnce() -> T) -> T {
    std::fs::create_dir_all(target()).expect("a folder");
    let lock = File::create(target().join(format!("{name}.lock"))).expect("a lock file");
    lock.lock().expect("a lock");
    // Released when the file is closed, also when `work` panics.
    work()
}

/// All FMUs, those for tests included. Cargo decides what is out of date.
pub fn all() -> &'static Built {
    static BUILT: LazyLock<Result<Built, package::Error>> = LazyLock::new(|| {
        let options = Options {
            workspace: Some(repository().to_owned()),
            target_dir: Some(target()),
            output_dir: Some(target().join("fmus")),
            test_fmus: true,
            ..Options::default()
        };
        locked("package", || package::build(&options, |_| ()))
    });
    BUILT.as_ref().unwrap_or_else(|error| panic!("no FMUs to test: {error}"))
}

/// The archive of an FMU.
pub fn path(name: &str, version: FmiVersion) -> PathBuf {
    all().folder(version).join(format!("{name}.fmu"))
}

/// The archives of all FMUs, in both versions and with clocks where there are any.
pub fn paths() -> Vec<PathBuf> {
    all().packages.iter().flat_map(Package::archives).map(Path::to_owned).collect()
}

/// An opened FMU.
pub fn open(name: &str, version: FmiVersion) -> Fmu {
    Fmu::open(path(name, version)).unwrap_or_else(|error| panic!("{error}"))
}

/// The `swayless` command of the same build as the tests.
pub fn command() -> Command {
    static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
        let test = std::env::current_exe().expect("the test program");
        let folder = test.ancestors().nth(2).expect("target/<profile>/deps").to_owned();
        let profile = folder.file_name().and_then(|name| name.to_str()).expect("a profile");
        let profile = if profile == "debug" { "dev" } else { profile };
        let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("target");
        // A run of all tests has built it already; a run of these alone has not.
        let status = Command::new(env!("CARGO"))
            .args(["build", "--quiet", "--package", "swayless", "--bin", "swayless", "--profile", profile])
            .arg("--target-dir")
            .arg(target)
            .current_dir(repository())
            .status()
            .expect("cargo");
        assert!(status.success());
        folder.join(format!("swayless{}", std::env::consts::EXE_SUFFIX))
    });
    Command::new(&*PROGRAM)
}
