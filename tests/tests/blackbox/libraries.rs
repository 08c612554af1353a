//! The libraries inside the archives: what they export and what they need.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::Read;
use std::path::Path;

use object::Object;
use object::read::NameOrOrdinal;

use crate::packaged;

/// The library of an archive.
pub fn library(path: &Path) -> Vec<u8> {
    let mut archive = zip::ZipArchive::new(File::open(path).expect("an archive")).expect("a zip archive");
    let suffix = format!(".{}", std::env::consts::DLL_EXTENSION);
    let names = archive.file_names().map(|name| name.expect("a name").into_owned());
    let names: Vec<String> = names.filter(|name| name.ends_with(&suffix)).collect();
    assert_eq!(names.len(), 1, "{}: {names:?}", path.display());
    let mut bytes = Vec::new();
    archive.by_name(&names[0]).expect("the library").read_to_end(&mut bytes).expect("bytes");
    bytes
}

/// Checks that a library exports the standard's functions and its description of itself, and nothing else.
pub fn check_exports(path: &Path) {
    let listed = std::fs::read_to_string(packaged::repository().join("tests/data/fmi_functions.txt")).expect("names");
    let mut wanted: BTreeSet<&str> = listed.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(wanted.len(), 44 + 75);
    wanted.insert("swayless_describe");
    let bytes = library(path);
    let file = object::File::parse(&*bytes).expect("a library");
    let exports = file.exports().expect("exports").map(|export| export.expect("an export"));
    let names: BTreeSet<String> = exports
        .map(|export| match export.into_name() {
            NameOrOrdinal::Name(name) => String::from_utf8(name.into_owned()).expect("a name"),
            NameOrOrdinal::Ordinal(number) => format!("#{number}"),
        })
        // Mach-O puts an underscore before each name.
        .map(|name| if cfg!(target_os = "macos") { name.trim_start_matches('_').to_owned() } else { name })
        .collect();
    let missing: Vec<_> = wanted.iter().filter(|name| !names.contains(**name)).collect();
    let more: Vec<_> = names.iter().filter(|name| !wanted.contains(name.as_str())).collect();
    assert!(missing.is_empty() && more.is_empty(), "{}: no {missing:?}, but {more:?}", path.display());
}

/// The bytes that a stripped library may take.
pub const SIZE: usize = 1_000_000;

/// Libraries that come with the C library, without the end of their names.
pub const C_LIBRARY: [&str; 6] =
    ["libc.so", "libm.so", "libpthread.so", "libdl.so", "ld-linux-x86-64.so", "ld-linux-aarch64.so"];

/// The libraries that a library needs (ELF's `DT_NEEDED`).
#[cfg(target_os = "linux")]
pub fn needed(path: &Path) -> Vec<String> {
    use object::elf::DT_NEEDED;
    use object::read::elf::ElfFile64;

    let bytes = library(path);
    let file = ElfFile64::<object::Endianness>::parse(&*bytes).expect("a 64-bit ELF file");
    let table = file.elf_section_table().dynamic_table(file.endian(), &*bytes).expect("a dynamic section");
    let needed = table.iter().filter(|entry| entry.tag == DT_NEEDED);
    let name = |entry| String::from_utf8(table.string(entry).expect("a string").to_owned()).expect("a name");
    let needed: Vec<String> = needed.map(name).collect();
    assert!(!needed.is_empty());
    needed
}

#[test]
fn libraries_export_the_standards_functions_and_their_description_only() {
    packaged::paths().iter().for_each(|path| check_exports(path));
}

/// An FMU loads wherever the C library and the compiler's runtime are.
#[cfg(target_os = "linux")]
#[test]
fn libraries_need_the_c_library_only() {
    for path in packaged::paths() {
        let known = |name: &String| C_LIBRARY.iter().chain(&["libgcc_s.so"]).any(|allowed| name.starts_with(allowed));
        let needed = needed(&path);
        assert!(needed.iter().all(known), "{} needs {needed:?}", path.display());
    }
}

#[test]
fn libraries_tell_nothing_of_where_they_were_built() {
    assert_eq!(packaged::all().with_local_paths, Vec::<String>::new());
}

/// They are stripped, and what is called more than a hundred times is not written out as often.
#[test]
fn libraries_are_small() {
    for path in packaged::paths() {
        let bytes = library(&path);
        let file = object::File::parse(&*bytes).expect("a library");
        assert!(!file.has_debug_symbols() && file.symbols().next().is_none(), "{} is not stripped", path.display());
        assert!(bytes.len() <= SIZE, "{}: {} bytes", path.display(), bytes.len());
    }
}
