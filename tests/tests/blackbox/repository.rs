//! What holds for the repository's files: the invariants that can be read off the source.

use std::path::{Path, PathBuf};

use crate::packaged::repository;

/// Where `unsafe` may stand: the C types, the functions of the standard, the loaders of libraries.
const UNSAFE_ROOMS: [&str; 13] = [
    "fmus/abi/src/",
    "fmus/export/src/fmi2/",
    "fmus/export/src/fmi3/",
    "fmus/export/src/raw.rs",
    "fmus/export/src/raw_state.rs",
    "fmus/export/src/describe.rs",
    "fmus/export/src/symbols.rs",
    // They call the functions as an importer does.
    "fmus/export/tests/",
    "fmus/export/benches/",
    "harness/src/loader/",
    "harness/src/package/describe.rs",
    // The bare loop over the same C functions that the master is measured against.
    "harness/benches/",
    // They call the packaged libraries as a careless importer does.
    "tests/tests/blackbox/fuzz/",
];

/// Files with this extension: their paths from the repository's folder, with `/`, and their texts.
fn files(extension: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders = vec![repository().to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder") {
            let path: PathBuf = entry.expect("an entry").path();
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            if path.is_dir() {
                if !["target", "out", ".git"].contains(&name.as_str()) {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(|e| e == extension) {
                let text = std::fs::read_to_string(&path).expect("a text");
                found.push((relative(&path), text));
            }
        }
    }
    assert!(!found.is_empty());
    found
}

fn relative(path: &Path) -> String {
    let path = path.strip_prefix(repository()).expect("in the repository");
    path.components().map(|c| c.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// The code of a line: without a comment at its end.
fn code(line: &str) -> &str {
    line.split("//").next().unwrap_or_default()
}

/// Places where a predicate holds for a line's code.
fn lines(files: &[(String, String)], wrong: impl Fn(&str, &str) -> bool) -> Vec<String> {
    let places = files.iter().flat_map(|(path, text)| {
        let numbered = text.lines().enumerate().filter(|(_, line)| wrong(path, code(line)));
        numbered.map(move |(i, line)| format!("{path}:{}: {}", i + 1, line.trim()))
    });
    places.collect()
}

#[test]
fn every_file_begins_with_what_it_is_about() {
    for (path, text) in files("rs") {
        assert!(text.starts_with("//! "), "{path}");
    }
    for (path, text) in files("py") {
        assert!(text.starts_with("\"\"\""), "{path}");
    }
}

#[test]
fn nothing_is_left_to_do() {
    // Put together, so that this file does not find itself.
    let marks = [concat!("to", "do!("), concat!("unimpl", "emented!("), concat!("db", "g!("), concat!("#[ig", "nore")];
    let found = lines(&files("rs"), |_, line| marks.iter().any(|mark| line.contains(mark)));
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn no_lint_is_switched_off_without_a_reason() {
    for (path, text) in files("rs") {
        for part in text.split(concat!("[", "allow(")).skip(1) {
            let list = part.split(")]").next().unwrap_or_default();
            assert!(list.contains("reason = "), "{path}: allow({list})");
            assert!(!list.contains("clippy::all") && !list.contains("warnings"), "{path}: allow({list})");
        }
    }
}

#[test]
fn unsafe_code_stays_in_its_rooms() {
    let word = concat!("uns", "afe");
    let marks = ["{", "fn", "impl", "extern", "trait"].map(|next| format!("{word} {next}"));
    let attribute = format!("{word}(");
    let marked = |line: &str| marks.iter().any(|mark| line.contains(mark)) || line.contains(&attribute);
    let files = files("rs");
    let outside = lines(&files, |path, line| marked(line) && !UNSAFE_ROOMS.iter().any(|room| path.starts_with(room)));
    assert!(outside.is_empty(), "{outside:#?}");
    // The search does find it where it is.
    assert!(lines(&files, |path, line| marked(line) && path.starts_with("fmus/export/src/raw.rs")).len() > 5);
}

/// Dependencies point one way: `abi ← export ← fmus`, `abi ← harness`, `shaping ← harness`, `modeldesc ← harness`,
/// `modeldesc ← export`.
#[test]
fn dependencies_point_one_way() {
    let fmus = [
        "swayless-control",
        "swayless-crane",
        "swayless-export",
        "swayless-mechanics",
        "swayless-sensing",
        "swayless-shaping",
        "swayless-supervision",
    ];
    let allowed = |path: &str| -> Vec<&str> {
        match path {
            "fmus/abi/Cargo.toml" | "fmus/scalar/Cargo.toml" | "modeldesc/Cargo.toml" => vec![],
            "fmus/export-derive/Cargo.toml" | "fmus/sensing/Cargo.toml" | "fmus/shaping/Cargo.toml" => vec![],
            "fmus/supervision/Cargo.toml" => vec![],
            "fmus/control/Cargo.toml" => vec!["swayless-shaping"],
            "fmus/mechanics/Cargo.toml" => vec!["swayless-scalar"],
            "fmus/crane/Cargo.toml" => vec!["swayless-export", "swayless-mechanics"],
            "fmus/export/Cargo.toml" => {
                vec!["swayless-abi", "swayless-export-derive", "swayless-modeldesc", "swayless-scalar"]
            }
            "harness/Cargo.toml" => vec!["swayless-abi", "swayless-modeldesc", "swayless-shaping"],
            "tests/Cargo.toml" => vec!["swayless", "swayless-abi", "swayless-modeldesc"],
            path if path.starts_with("fmus/") || path.starts_with("tests/fmus/") => fmus.to_vec(),
            other => panic!("{other} is new: say what it may depend on"),
        }
    };
    for (path, text) in files("toml") {
        if !path.ends_with("Cargo.toml") || path == "Cargo.toml" {
            continue;
        }
        let sections =
            text.split("\n[").filter(|s| s.starts_with("dependencies]") || s.starts_with("dev-dependencies]"));
        let names = sections.flat_map(str::lines).filter_map(|line| line.split([' ', '.', '=']).next());
        let ours: Vec<&str> = names.filter(|name| name.starts_with("swayless")).collect();
        assert!(ours.iter().all(|name| allowed(&path).contains(name)), "{path} depends on {ours:?}");
    }
}

/// Models know no FMI; the harness knows no crane.
#[test]
fn rooms_keep_to_their_subject() {
    let files = files("rs");
    let knows = |room: &str, word: &str| {
        lines(&files, |path, line| path.starts_with(room) && line.to_lowercase().contains(word))
    };
    for room in ["control", "mechanics", "sensing", "shaping", "supervision"].map(|room| format!("fmus/{room}/src/")) {
        let room = &*room;
        assert_eq!(knows(room, "fmi"), Vec::<String>::new());
        assert_eq!(knows(room, "std::fs"), Vec::<String>::new());
    }
    let mut harness = knows("harness/src/", "crane");
    // The command's demo and its examples are about the crane.
    harness.retain(|place| !place.starts_with("harness/src/cli/"));
    assert_eq!(harness, Vec::<String>::new());
}
