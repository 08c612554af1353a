//! Portable libraries: they run on old Linux systems, and run as the plain ones do.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use object::Endianness;
use object::read::elf::ElfFile64;

use crate::libraries::{C_LIBRARY, SIZE, check_exports, library, needed};
use crate::packaged::{self, locked, repository, target};
use crate::python;

/// The newest version of the GNU C library whose symbols are needed: that of Debian 10 and RHEL 8.
const GLIBC: [u32; 2] = [2, 28];

/// `swayless build --portable` with the tools of the Python environment.
fn build(workspace: &Path, target: &Path, output: &Path, more: &[&str]) -> Output {
    let tools = python::environment().parent().expect("the folder of programs").to_owned();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(std::iter::once(tools).chain(std::env::split_paths(&path))).expect("a path");
    let mut command = packaged::command();
    command.args(["build", "--portable"]).args(more).arg("--workspace").arg(workspace);
    command.arg("--target-dir").arg(target).arg("--output-dir").arg(output);
    run(command.env("PATH", path))
}

#[track_caller]
fn run(command: &mut Command) -> Output {
    let output = command.output().expect("the command starts");
    assert!(output.status.success(), "{command:?}\n{}", String::from_utf8_lossy(&output.stderr));
    output
}

/// Some stand for all: the FMUs of an example, the largest ones, those with dependencies of their own or with clocks, and
/// one that panics.
const SOME: [&str; 7] =
    ["boom-crane", "bridge-crane", "command-source", "input-shaper", "vector-drive", "vision-sensor", "faulty"];

/// The folder with their portable archives.
fn some() -> &'static Path {
    static BUILT: LazyLock<PathBuf> = LazyLock::new(|| {
        let output = target().join("portable-fmus");
        locked("package", || build(repository(), &target(), &output, &SOME));
        output
    });
    &BUILT
}

/// The portable archives.
fn paths() -> Vec<PathBuf> {
    let folders = ["fmi2", "fmi3"].map(|version| some().join(version).read_dir().expect("a folder"));
    let paths: Vec<_> = folders.into_iter().flatten().map(|entry| entry.expect("an entry").path()).collect();
    assert!(paths.len() > 2 * SOME.len(), "{paths:?}");
    paths
}

#[test]
fn portable_libraries_need_an_old_c_library_only() {
    for path in paths() {
        check_exports(&path);
        let known = |name: &String| C_LIBRARY.iter().any(|allowed| name.starts_with(allowed));
        let needed = needed(&path);
        assert!(needed.iter().all(known), "{} needs {needed:?}", path.display());
        let bytes = library(&path);
        assert!(bytes.len() <= SIZE, "{}: {} bytes", path.display(), bytes.len());
        let versions = versions(&bytes);
        // The oldest there is for this architecture: the check reads something.
        assert!(versions.iter().any(|v| v == "GLIBC_2.2.5" || v == "GLIBC_2.17"), "{versions:?}");
        let newer: Vec<_> = versions.iter().filter(|version| !is_old(version)).collect();
        assert!(newer.is_empty(), "{} needs {newer:?}", path.display());
    }
}

/// All versions that a library's symbols ask other libraries for.
fn versions(bytes: &[u8]) -> Vec<String> {
    let file = ElfFile64::<Endianness>::parse(bytes).expect("a 64-bit ELF file");
    let sections = file.elf_section_table();
    let (mut needs, strings) = sections.gnu_verneed(file.endian(), bytes).expect("sections").expect("versions");
    let strings = sections.strings(file.endian(), bytes, strings).expect("their names");
    let mut names = Vec::new();
    while let Some((_, mut versions)) = needs.next().expect("a library") {
        while let Some(version) = versions.next().expect("a version") {
            let name = version.name(file.endian(), strings).expect("a name");
            names.push(String::from_utf8(name.to_owned()).expect("a name"));
        }
    }
    names
}

/// Whether a version of a symbol is among those of the C library that portable libraries make do with.
fn is_old(version: &str) -> bool {
    let Some(number) = version.strip_prefix("GLIBC_") else { return false };
    number.split('.').map_while(|part| part.parse().ok()).collect::<Vec<u32>>() <= GLIBC.to_vec()
}

#[test]
fn versions_are_compared_as_numbers() {
    assert!(is_old("GLIBC_2.2.5") && is_old("GLIBC_2.28"));
    assert!(!is_old("GLIBC_2.29") && !is_old("GLIBC_2.100") && !is_old("GCC_3.0"));
}

/// The linker and the version of the C library change no bit of a result.
#[test]
fn portable_fmus_give_the_bits_of_plain_ones() {
    let folder = tempfile::tempdir().expect("a folder");
    for version in ["fmi2", "fmi3"] {
        let results = [&packaged::all().output_dir, &some().to_owned()].map(|fmus| {
            let result = folder.path().join("result.csv");
            let mut command = packaged::command();
            command.arg("run").arg(repository().join("examples/boom-crane/SystemStructure.ssd"));
            command.arg("--fmu-dir").arg(fmus.join(version)).arg("--output-file").arg(&result);
            run(&mut command);
            std::fs::read_to_string(result).expect("results")
        });
        assert!(results[0].lines().count() > 1000);
        assert!(results[0] == results[1], "{version}: portable FMUs give other results");
    }
}

/// Zig brings its own unwinder; a panic must find its way through it.
#[test]
fn a_panic_in_a_portable_library_ends_the_run_and_not_the_host() {
    for version in ["fmi2", "fmi3"] {
        let fmu = some().join(version).join("Faulty.fmu");
        let run = packaged::command().arg("run").arg(fmu).args(["--start-value", "fault=derivatives"]).output();
        let run = run.expect("the command starts");
        let message = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(1), "{message}");
        assert!(message.contains("a fault in derivatives"), "{message}");
    }
}

/// One FMU stands for all: the flags are the same.
#[test]
fn another_folder_gives_the_same_portable_bytes() {
    locked("reproducible", || {
        let copy = target().join("a copy of the repository");
        crate::reproducible::synchronize(repository(), &copy);
        let target = target().join("reproducible");
        let output = target.join("portable");
        let built = build(&copy, &target, &output, &["faulty"]);
        let messages = String::from_utf8_lossy(&built.stderr);
        assert!(!messages.contains("not reproducible"), "{messages}");
        for archive in ["fmi2/Faulty.fmu", "fmi3/Faulty.fmu"] {
            let [here, there] = [some(), &output].map(|fmus| std::fs::read(fmus.join(archive)).expect("an archive"));
            assert!(here == there, "{archive} differs");
        }
    });
}

#[test]
fn without_its_tools_a_portable_build_says_what_to_install() {
    let mut command = packaged::command();
    command.args(["build", "--portable", "--workspace"]).arg(repository());
    // Cargo itself is found by its full path.
    let output = command.env("CARGO", env!("CARGO")).env("PATH", "").output().expect("the command starts");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("pip install cargo-zigbuild ziglang"), "{message}");
}
