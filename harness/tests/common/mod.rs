//! Builds the foreign FMUs of `foreign/` with the C compiler.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use swayless::importer::platform_folders;
use swayless_modeldesc::types::FmiVersion;
use tempfile::TempDir;

/// The folder of an unpacked foreign FMU; built once per test process.
pub fn foreign(version: FmiVersion) -> PathBuf {
    static FOLDER: OnceLock<TempDir> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| {
        let folder = tempfile::Builder::new().prefix("foreign {ü} ").tempdir().unwrap();
        build(folder.path(), FmiVersion::V2);
        build(folder.path(), FmiVersion::V3);
        folder
    });
    folder.path().join(version.to_string())
}

fn build(folder: &Path, version: FmiVersion) {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/foreign");
    let number = if version == FmiVersion::V2 { 2 } else { 3 };
    let fmu = folder.join(version.to_string());
    let binaries = fmu.join("binaries").join(&platform_folders(version)[0]);
    std::fs::create_dir_all(&binaries).unwrap();
    std::fs::copy(source.join(format!("foreign{number}.xml")), fmu.join("modelDescription.xml")).unwrap();
    let status = Command::new("cc")
        .args(["-shared", "-fPIC", "-O2", "-Wall", "-Wextra", "-Werror", "-o"])
        .arg(binaries.join(format!("foreign.{}", std::env::consts::DLL_EXTENSION)))
        .arg(source.join(format!("foreign{number}.c")))
        .arg("-lm")
        .status()
        .unwrap();
    assert!(status.success());
}
