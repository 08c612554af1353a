//! Archives that try to get out or to fill the disk.

use std::io::Cursor;
use std::path::Component;

use proptest::prelude::*;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::*;

/// Builds an archive of entries with the names as given; the writer itself refuses nothing here.
fn archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries {
        writer.start_file(*name, SimpleFileOptions::default().compression_method(CompressionMethod::Deflated)).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

fn open(bytes: &[u8], limits: Limits) -> Result<Unpacked> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("test.fmu");
    std::fs::write(&path, bytes).unwrap();
    Unpacked::open_with(&path, limits)
}

fn problem(bytes: &[u8], limits: Limits) -> ArchiveProblem {
    match open(bytes, limits) {
        Err(Error::Archive { problem, .. }) => problem,
        other => panic!("{other:?}"),
    }
}

/// Replaces a name in the archive's bytes by one of the same length, in the local and the central header.
fn rename(bytes: &mut [u8], from: &str, to: &str) {
    assert_eq!(from.len(), to.len());
    for at in 0..bytes.len() - from.len() {
        if &bytes[at..at + from.len()] == from.as_bytes() {
            bytes[at..at + from.len()].copy_from_slice(to.as_bytes());
        }
    }
}

#[test]
fn an_archive_unpacks_and_is_removed_again() {
    let unpacked = open(&archive(&[("modelDescription.xml", b"<x/>"), ("binaries/a/b.so", b"1")]), Limits::default());
    let unpacked = unpacked.unwrap();
    let folder = unpacked.folder().to_owned();
    assert_eq!(std::fs::read(folder.join("binaries/a/b.so")).unwrap(), b"1");
    let again = Unpacked::open(&folder).unwrap();
    assert_eq!(again.folder(), folder);
    drop(again);
    assert!(folder.exists());
    drop(unpacked);
    assert!(!folder.exists());
}

#[test]
fn no_entry_leaves_the_folder() {
    for name in [
        "../evil.txt",
        "/evil/a.txt",
        "a/../../evi",
        "a\\..\\evil.t",
        "C:/evil.txt",
        "./evil.txtt",
        "a//evil.txt",
        ".. /evil.tx",
    ] {
        let mut bytes = archive(&[("ok.txt", b"1"), (&"x".repeat(name.len()), b"evil")]);
        rename(&mut bytes, &"x".repeat(name.len()), name);
        assert!(
            matches!(problem(&bytes, Limits::default()), ArchiveProblem::Escapes { entry, .. } if entry == name),
            "{name}"
        );
    }
}

#[test]
fn links_and_duplicates_are_refused() {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    writer.add_symlink("link", "/etc", SimpleFileOptions::default()).unwrap();
    let bytes = writer.finish().unwrap().into_inner();
    assert!(matches!(problem(&bytes, Limits::default()), ArchiveProblem::Special { .. }));

    let mut bytes = archive(&[("a-file-1", b"1"), ("a-file-2", b"2")]);
    rename(&mut bytes, "a-file-2", "a-file-1");
    assert!(matches!(problem(&bytes, Limits::default()), ArchiveProblem::Duplicate { .. }));
    let bytes = archive(&[("File", b"1"), ("fILE", b"2")]);
    assert!(matches!(problem(&bytes, Limits::default()), ArchiveProblem::Duplicate { .. }));
}

#[test]
fn limits_hold_for_the_bytes_that_come_out() {
    let zeros = vec![0; 1 << 20];
    let bytes = archive(&[("a", &zeros), ("b", &zeros)]);
    let limits = Limits { entries: 1, ..Limits::default() };
    assert!(matches!(problem(&bytes, limits), ArchiveProblem::TooManyEntries { count: 2, limit: 1 }));
    let limits = Limits { bytes: (2 << 20) - 1, ..Limits::default() };
    assert!(matches!(problem(&bytes, limits), ArchiveProblem::TooLarge { .. }));
    assert!(open(&bytes, Limits { bytes: 2 << 20, ..Limits::default() }).is_ok());

    let bomb = vec![0; Limits::FREE_BYTES as usize + (1 << 20)];
    assert!(matches!(problem(&archive(&[("bomb", &bomb)]), Limits::default()), ArchiveProblem::Inflates { .. }));
}

#[test]
fn broken_archives_are_typed_errors() {
    let whole = archive(&[("modelDescription.xml", b"<fmiModelDescription/>")]);
    for bytes in [&b""[..], b"not a zip", &whole[..whole.len() / 2]] {
        assert!(matches!(problem(bytes, Limits::default()), ArchiveProblem::Broken { .. }));
    }
    assert!(matches!(Unpacked::open(Path::new("no/such.fmu")), Err(Error::FileNotFound { .. })));
}

/// A field of a header, or a part of the data.
fn field() -> impl Strategy<Value = Vec<u8>> {
    prop_oneof![
        3 => any::<u8>().prop_map(|byte| vec![byte]),
        // A size, an offset or a count that nothing can have; the greatest of them announces 64-bit fields.
        1 => Just(vec![0xff; 4]),
        1 => Just(vec![0xfe, 0xff, 0xff, 0x7f]),
        1 => Just(vec![0xff; 2]),
        1 => Just(vec![0; 4]),
    ]
}

proptest! {
    /// Whatever is changed, cut or put in, unpacking returns and writes nothing beside the folder.
    #[test]
    fn damaged_archives_never_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), field()), 1..8),
        cut in prop::option::of(any::<prop::sample::Index>()),
        again in any::<bool>(),
    ) {
        let mut bytes = archive(&[("modelDescription.xml", b"<fmiModelDescription/>"), ("binaries/x/y.so", &[7; 300])]);
        for (index, field) in changes {
            let at = index.index(bytes.len());
            let end = (at + field.len()).min(bytes.len());
            bytes[at..end].copy_from_slice(&field[..end - at]);
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()));
        }
        if again {
            bytes.extend(bytes.clone());
        }
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("test.fmu");
        std::fs::write(&path, &bytes).unwrap();
        let begin = std::time::Instant::now();
        let opened = Unpacked::open_with(&path, Limits { bytes: 1 << 20, ..Limits::default() });
        prop_assert!(begin.elapsed().as_secs() < 30);
        prop_assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        drop(opened);
    }

    #[test]
    fn accepted_names_stay_below(name in "[a./\\\\: ]{0,12}") {
        if check_name(&name).is_ok() {
            prop_assert!(Path::new(&name).components().all(|component| matches!(component, Component::Normal(_))));
        }
    }
}
