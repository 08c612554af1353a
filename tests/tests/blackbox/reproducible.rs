//! The same source gives the same archives from any folder, whichever FMUs are built together.

use std::collections::BTreeSet;
use std::path::Path;

use swayless::package::{self, Options};

use crate::packaged::{self, locked, repository, target};

/// Some stand for all: one of them has dependencies of its own.
const SOME: [&str; 2] = ["boom-crane", "command-source"];

#[test]
fn another_folder_and_other_company_give_the_same_bytes() {
    locked("reproducible", || {
        // The copy stays, so that a later run compiles only what has changed.
        let copy = target().join("a copy of the repository");
        synchronize(repository(), &copy);
        let options = Options {
            names: SOME.map(str::to_owned).to_vec(),
            workspace: Some(copy.clone()),
            target_dir: Some(target().join("reproducible")),
            output_dir: Some(target().join("reproducible/fmus")),
            ..Options::default()
        };
        let built = package::build(&options, |_| ()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(built.workspace, copy.canonicalize().expect("the copy"));
        assert_eq!(built.packages.len(), SOME.len());
        for there in &built.packages {
            let here = packaged::all().packages.iter().find(|here| here.name == there.name).expect("the same FMU");
            for (a, b) in here.archives().zip(there.archives()) {
                let same = std::fs::read(a).expect("an archive") == std::fs::read(b).expect("an archive");
                assert!(same, "{} and {} differ", a.display(), b.display());
            }
        }
    });
}

/// Makes `to` hold what `from` holds, but for what is built, without touching files that are the same.
pub fn synchronize(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("a folder");
    let mut kept = BTreeSet::new();
    for entry in std::fs::read_dir(from).expect("a folder") {
        let entry = entry.expect("an entry");
        let (source, name) = (entry.path(), entry.file_name());
        if [".git", "target", "out"].iter().any(|built| name == *built) || source.starts_with(to) {
            continue;
        }
        let copy = to.join(&name);
        kept.insert(name);
        if source.is_dir() {
            synchronize(&source, &copy);
        } else {
            let bytes = std::fs::read(&source).expect("a file");
            if std::fs::read(&copy).ok().as_ref() != Some(&bytes) {
                std::fs::write(&copy, bytes).expect("a copy");
            }
        }
    }
    for entry in std::fs::read_dir(to).expect("a folder") {
        let entry = entry.expect("an entry");
        if !kept.contains(&entry.file_name()) {
            let gone = entry.path();
            let removed = if gone.is_dir() { std::fs::remove_dir_all(gone) } else { std::fs::remove_file(gone) };
            removed.expect("an old copy goes");
        }
    }
}
