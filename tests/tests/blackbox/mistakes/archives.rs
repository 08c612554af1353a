//! Files that are missing, broken or not to be trusted.

use std::fs::File;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use swayless_modeldesc::types::FmiVersion;
use tempfile::TempDir;
use zip::write::SimpleFileOptions;
use zip::{ZipArchive, ZipWriter};

use super::{FAILED, FOUND_PROBLEMS, fails, folder, swayless, text};
use crate::packaged::{self, VERSIONS};

/// An entry of an archive: name and contents.
type Entry = (String, Vec<u8>);

/// A copy of `BoomCrane` with changed entries.
fn altered(folder: &TempDir, version: FmiVersion, change: impl Fn(&mut Vec<Entry>)) -> PathBuf {
    let mut archive =
        ZipArchive::new(File::open(packaged::path("BoomCrane", version)).expect("a file")).expect("a zip");
    let mut entries = Vec::new();
    for i in 0..archive.len() {
        let mut entry = archive.by_index(i).expect("an entry");
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).expect("bytes");
        entries.push((entry.name().expect("a name").into_owned(), bytes));
    }
    change(&mut entries);
    let path = folder.path().join("altered.fmu");
    let mut writer = ZipWriter::new(File::create(&path).expect("a file"));
    for (name, bytes) in &entries {
        writer.start_file(name.as_str(), SimpleFileOptions::default()).expect("an entry");
        writer.write_all(bytes).expect("room");
    }
    writer.finish().expect("an archive");
    path
}

#[test]
fn a_missing_file_is_named() {
    fails(&["run", "no/such.fmu"], FAILED, &["no/such.fmu"]);
    fails(&["run", "no/such.ssd"], FAILED, &["no/such.ssd"]);
    let crane = packaged::path("BoomCrane", FmiVersion::V3);
    fails(&["run", text(&crane), "--input-file", "no/such.csv"], FAILED, &["no/such.csv"]);
}

#[test]
fn a_broken_zip_is_told_from_a_missing_one() {
    let folder = folder();
    for version in VERSIONS {
        let whole = std::fs::read(packaged::path("BoomCrane", version)).expect("an archive");
        let path = folder.path().join("half.fmu");
        std::fs::write(&path, &whole[..whole.len() / 2]).expect("half a file");
        fails(&["run", text(&path)], FAILED, &["half.fmu", "zip archive"]);
        let (stdout, _) = swayless(&["validate", text(&path)], FOUND_PROBLEMS);
        assert!(stdout.contains("zip archive"), "{stdout}");
    }
}

#[test]
fn damaged_contents_are_noticed() {
    let folder = folder();
    let mut bytes = std::fs::read(packaged::path("BoomCrane", FmiVersion::V3)).expect("an archive");
    // Somewhere in the compressed library, which is most of the archive.
    let middle = bytes.len() / 2;
    bytes[middle..middle + 16].iter_mut().for_each(|byte| *byte ^= 0xff);
    let path = folder.path().join("damaged.fmu");
    std::fs::write(&path, bytes).expect("a file");
    fails(&["run", text(&path)], FAILED, &["damaged.fmu", "zip archive"]);
}

#[test]
fn a_path_that_leaves_the_archive_is_refused() {
    let folder = folder();
    for escape in ["../escaped.txt", "resources/../../escaped.txt", "/tmp/escaped-from-an-fmu.txt"] {
        let path = altered(&folder, FmiVersion::V3, |entries| entries.push((escape.to_owned(), b"out".to_vec())));
        fails(&["run", text(&path)], FAILED, &[escape, "leave the folder"]);
        let (stdout, _) = swayless(&["validate", text(&path)], FOUND_PROBLEMS);
        assert!(stdout.contains(escape), "{stdout}");
    }
    assert!(!Path::new("/tmp/escaped-from-an-fmu.txt").exists());
    assert!(!std::env::temp_dir().join("escaped.txt").exists());
}

#[test]
fn a_wrong_token_is_refused_by_the_library() {
    let folder = folder();
    for version in VERSIONS {
        let path = altered(&folder, version, |entries| {
            for (_, bytes) in entries.iter_mut().filter(|(name, _)| name == "modelDescription.xml") {
                let xml = String::from_utf8(bytes.clone()).expect("UTF-8");
                let begin = xml.find('{').expect("a token") + 1;
                let other = if xml[begin..].starts_with('0') { "1" } else { "0" };
                *bytes = format!("{}{other}{}", &xml[..begin], &xml[begin + 1..]).into_bytes();
            }
        });
        fails(&["run", text(&path)], FAILED, &["instantiati", "token", "the FMU says"]);
    }
}

#[test]
fn a_missing_binary_is_named_with_those_that_are_there() {
    let folder = folder();
    let library = format!("BoomCrane.{}", std::env::consts::DLL_EXTENSION);
    for version in VERSIONS {
        let moved = altered(&folder, version, |entries| {
            for (name, _) in entries.iter_mut().filter(|(name, _)| name.starts_with("binaries/")) {
                *name = format!("binaries/pdp11-unix/{library}");
            }
        });
        fails(&["run", text(&moved)], FAILED, &["no binary for this platform", &library, "pdp11-unix"]);
        let none = altered(&folder, version, |entries| entries.retain(|(name, _)| !name.starts_with("binaries/")));
        fails(&["run", text(&none)], FAILED, &["no binary for this platform", "none"]);
    }
}

#[test]
fn a_missing_description_makes_no_fmu() {
    let folder = folder();
    let path = altered(&folder, FmiVersion::V3, |entries| entries.retain(|(name, _)| name != "modelDescription.xml"));
    fails(&["run", text(&path)], FAILED, &["modelDescription.xml"]);
    let cut = altered(&folder, FmiVersion::V3, |entries| entries[0].1.truncate(2000));
    fails(&["run", text(&cut)], FAILED, &["modelDescription.xml", "line"]);
}
