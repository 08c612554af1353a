//! `swayless build --add-platform`: binaries of other platforms join an FMU, and those that do not fit are refused.
//!
//! The libraries for other systems are compiled by zig from C: real files of each format that export the standard's
//! functions and hold the texts of an FMU's variables. They stand for what a build on such a system would bring.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{Read, Write as _};
use std::path::{Path, PathBuf};
use std::process::Command;

use object::{Architecture, BinaryFormat, Object};
use swayless_modeldesc::types::{FmiVersion, ModelDescription};
use tempfile::TempDir;

use crate::packaged::{self, VERSIONS};
use crate::{libraries, python};

const NAME: &str = "VectorDrive";

/// Name in FMI 2.0, name in FMI 3.0, extension, and what zig calls it.
const OTHERS: [(&str, &str, &str, &str); 5] = [
    ("win64", "x86_64-windows", "dll", "x86_64-windows-gnu"),
    ("aarch64-windows", "aarch64-windows", "dll", "aarch64-windows-gnu"),
    ("darwin64", "x86_64-darwin", "dylib", "x86_64-macos"),
    ("aarch64-darwin", "aarch64-darwin", "dylib", "aarch64-macos"),
    ("aarch64-linux", "aarch64-linux", "so", "aarch64-linux-gnu"),
];

/// A folder `binaries/<platform>/<NAME>.<extension>` with one library.
fn unpacked(folder: &TempDir, platform: &str, extension: &str, bytes: &[u8]) -> PathBuf {
    let source = tempfile::tempdir_in(folder).expect("a folder").keep();
    let binaries = source.join("binaries").join(platform);
    std::fs::create_dir_all(&binaries).expect("a folder");
    std::fs::write(binaries.join(format!("{NAME}.{extension}")), bytes).expect("a file");
    source
}

/// A copy of the FMU.
fn copy(folder: &TempDir, version: FmiVersion) -> PathBuf {
    let path = tempfile::tempdir_in(folder).expect("a folder").keep().join(format!("{NAME}.fmu"));
    std::fs::copy(packaged::path(NAME, version), &path).expect("a copy");
    path
}

fn add(fmu: &Path, from: &Path) -> (bool, String) {
    let output =
        packaged::command().args(["build", "--add-platform"]).arg(fmu).arg(from).output().expect("the command");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.success(), text(&output.stdout) + &text(&output.stderr))
}

#[track_caller]
fn refused(fmu: &Path, from: &Path, reasons: &[&str]) {
    let before = std::fs::read(fmu).expect("an archive");
    let (added, said) = add(fmu, from);
    assert!(!added && reasons.iter().all(|reason| said.contains(reason)), "{said}");
    assert!(before == std::fs::read(fmu).expect("an archive"), "refused, and yet changed");
}

/// Compiles a library for another system that exports some functions and holds the texts of a description.
fn library(folder: &TempDir, target: &str, functions: &str, description: &ModelDescription) -> Vec<u8> {
    let mut source = String::from(
        "#ifdef _WIN32\n#define EXPORT __declspec(dllexport)\n\
         int DllMainCRTStartup(void *a, unsigned b, void *c) { return 1; }\n#else\n#define EXPORT\n#endif\n",
    );
    for name in functions.lines().filter(|line| !line.starts_with('#')) {
        writeln!(source, "EXPORT void {name}(void) {{}}").expect("room");
    }
    source.push_str("EXPORT const unsigned char texts[] = {");
    for variable in &description.variables {
        let text = variable.description.as_deref().unwrap_or_default();
        text.bytes().chain([0]).for_each(|byte| write!(source, "{byte},").expect("room"));
    }
    source.push_str("};\n");
    let (file, library) = (folder.path().join("library.c"), folder.path().join("library"));
    std::fs::write(&file, source).expect("a file");
    let mut zig = Command::new(python::environment());
    zig.args(["-m", "ziglang", "cc", "-target", target, "-shared", "-nostdlib", "-o"]).arg(&library).arg(&file);
    let output = zig.current_dir(folder).output().expect("zig starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    std::fs::read(library).expect("a library")
}

fn functions() -> String {
    std::fs::read_to_string(packaged::repository().join("tests/data/fmi_functions.txt")).expect("names")
}

#[test]
fn binaries_of_other_platforms_join_in_any_order_with_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let description = packaged::open(NAME, FmiVersion::V3).description().clone();
    let libraries = OTHERS.map(|(_, tuple, extension, target)| {
        let bytes = library(&folder, target, &functions(), &description);
        (tuple, extension, bytes)
    });
    for version in VERSIONS {
        let (one, two) = (copy(&folder, version), copy(&folder, version));
        for (tuple, extension, bytes) in &libraries {
            let (added, said) = add(&one, &unpacked(&folder, tuple, extension, bytes));
            assert!(added, "{said}");
        }
        for (tuple, extension, bytes) in libraries.iter().rev() {
            let (added, said) = add(&two, &unpacked(&folder, tuple, extension, bytes));
            assert!(added, "{said}");
        }
        let merged = std::fs::read(&one).expect("an archive");
        assert!(merged == std::fs::read(&two).expect("an archive"), "the order shows");
        // All that was there is there still, and the rest lies where the standard wants it.
        let entries = entries(&one);
        for (name, bytes) in self::entries(&packaged::path(NAME, version)) {
            assert!(entries.contains(&(name.clone(), bytes)), "{name} is gone");
        }
        for ((short, tuple, extension, _), (_, _, bytes)) in OTHERS.iter().zip(&libraries) {
            let platform = if version == FmiVersion::V2 { short } else { tuple };
            let name = format!("binaries/{platform}/{NAME}.{extension}");
            assert!(entries.contains(&(name.clone(), bytes.clone())), "{name} is missing");
        }
        assert_eq!(entries.len(), self::entries(&packaged::path(NAME, version)).len() + OTHERS.len());
        // It runs as before, and another time changes nothing.
        let run = packaged::command().arg("run").arg(&one).output().expect("the command");
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        assert!(add(&one, &packaged::path(NAME, version)).0);
        assert!(merged == std::fs::read(&one).expect("an archive"));
        // From one archive to another, of the other version too.
        let three = copy(&folder, FmiVersion::V2);
        assert!(add(&three, &one).0);
        assert_eq!(
            self::entries(&three).len(),
            self::entries(&packaged::path(NAME, FmiVersion::V2)).len() + OTHERS.len()
        );
    }
}

/// The library of every FMU is taken for its own: without it and with it added again, an archive has the bytes it had.
#[test]
fn every_fmu_takes_its_own_library() {
    let folder = tempfile::tempdir().expect("a folder");
    for path in packaged::paths() {
        let bare = folder.path().join("bare.fmu");
        let mut writer = zip::ZipWriter::new(File::create(&bare).expect("a file"));
        for (name, bytes) in entries(&path).iter().filter(|(name, _)| !name.starts_with("binaries/")) {
            writer.start_file(name.as_str(), zip::write::SimpleFileOptions::default()).expect("an entry");
            writer.write_all(bytes).expect("room");
        }
        writer.finish().expect("an archive");
        let (added, said) = add(&bare, &path);
        assert!(added, "{said}");
        assert!(std::fs::read(&bare).expect("an archive") == std::fs::read(&path).expect("an archive"), "{said}");
    }
}

fn entries(path: &Path) -> Vec<(String, Vec<u8>)> {
    let mut archive = zip::ZipArchive::new(File::open(path).expect("an archive")).expect("a zip archive");
    let count = archive.len();
    let entry = |index| {
        let mut entry = archive.by_index(index).expect("an entry");
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).expect("bytes");
        (entry.name().expect("a name").into_owned(), bytes)
    };
    (0..count).map(entry).collect()
}

#[test]
fn what_does_not_fit_is_refused_and_changes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    for version in VERSIONS {
        let fmu = copy(&folder, version);
        let description = packaged::open(NAME, version).description().clone();
        let ours = libraries::library(&fmu);
        let refuse = |platform, extension, bytes: &[u8], reasons: &[&str]| {
            refused(&fmu, &unpacked(&folder, platform, extension, bytes), reasons);
        };
        // Said to be for another platform than it is.
        let dll = library(&folder, "x86_64-windows-gnu", &functions(), &description);
        assert_eq!(object::File::parse(&*dll).expect("a library").format(), BinaryFormat::Pe);
        refuse("x86_64-darwin", "dylib", &dll, &["Pe", "MachO"]);
        refuse("aarch64-windows", "dll", &dll, &["X86_64", "Aarch64"]);
        let elf = library(&folder, "aarch64-linux-gnu", &functions(), &description);
        assert_eq!(object::File::parse(&*elf).expect("a library").architecture(), Architecture::Aarch64);
        refuse("x86_64-linux", "so", &elf, &["Aarch64", "X86_64"]);
        // No library, or a part of one.
        refuse("win64", "dll", b"text", &["no library"]);
        refuse("win64", "dll", &dll[..100], &["win64"]);
        // One function is missing, or a text.
        let fewer = functions().replace("fmi2DoStep\n", "").replace("fmi3DoStep\n", "");
        let dll = library(&folder, "x86_64-windows-gnu", &fewer, &description);
        refuse("win64", "dll", &dll, &["DoStep"]);
        let other = packaged::open("BoomCrane", version).description().clone();
        let dll = library(&folder, "x86_64-windows-gnu", &functions(), &other);
        refuse("win64", "dll", &dll, &["another model", "more"]);
        // Nothing there, or nothing of this name.
        refused(&fmu, folder.path(), &["binaries"]);
        refused(&fmu, &packaged::path("BoomCrane", version), &[NAME]);
        // The place is taken.
        if cfg!(all(target_os = "linux", target_arch = "x86_64")) {
            refuse("linux64", "so", &[&ours[..], b"\0"].concat(), &["already"]);
            refuse("linux64", "so", &libraries::library(&packaged::path("BoomCrane", version)), &["another model"]);
        }
    }
}
