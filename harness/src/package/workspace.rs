//! Finds the FMU crates of a cargo workspace.

use std::path::{Path, PathBuf};

use cargo_metadata::{MetadataCommand, TargetKind};

use super::Error;

/// A crate that builds an FMU.
#[derive(Debug, Clone)]
pub struct FmuCrate {
    /// The package's name.
    pub name: String,
    /// The package's description.
    pub description: String,
    /// Whether it is there for tests only, below `tests/fmus/`.
    pub is_test: bool,
}

/// A workspace with its FMU crates, in the order of their names.
#[derive(Debug)]
pub struct Workspace {
    /// Its folder.
    pub root: PathBuf,
    /// Where cargo compiles unless told otherwise.
    pub target_dir: PathBuf,
    pub crates: Vec<FmuCrate>,
}

impl Workspace {
    /// Asks cargo about the workspace that this manifest or folder belongs to.
    pub fn find(path: Option<&Path>) -> Result<Self, Error> {
        let mut command = MetadataCommand::new();
        command.no_deps();
        match path {
            Some(path) if path.is_dir() => command.current_dir(path),
            Some(path) => command.manifest_path(path),
            None => &mut command,
        };
        let metadata = command.exec().map_err(Error::Workspace)?;
        let root = metadata.workspace_root.clone().into_std_path_buf();
        let (fmus, tests) = (metadata.workspace_root.join("fmus"), metadata.workspace_root.join("tests/fmus"));
        let mut crates: Vec<FmuCrate> = metadata
            .workspace_packages()
            .into_iter()
            .filter(|p| p.manifest_path.starts_with(&fmus) || p.manifest_path.starts_with(&tests))
            .filter(|p| p.targets.iter().any(|t| t.kind.contains(&TargetKind::CDyLib)))
            .map(|p| FmuCrate {
                name: p.name.to_string(),
                description: p.description.clone().unwrap_or_default(),
                is_test: p.manifest_path.starts_with(&tests),
            })
            .collect();
        crates.sort_by(|a, b| a.name.cmp(&b.name));
        if crates.is_empty() {
            return Err(Error::NoFmus(root));
        }
        Ok(Self { root, target_dir: metadata.target_directory.into_std_path_buf(), crates })
    }

    /// The crates of these names; when none is given, all that are shipped, and those for tests if wanted.
    pub fn select(&self, names: &[String], test_fmus: bool) -> Result<Vec<FmuCrate>, Error> {
        for name in names {
            if !self.crates.iter().any(|c| plain(&c.name) == plain(name)) {
                let known: Vec<String> = self.crates.iter().map(|c| c.name.clone()).collect();
                let suggestion = known
                    .iter()
                    .map(|k| (strsim::jaro_winkler(&plain(k), &plain(name)), k))
                    .filter(|(likeness, _)| *likeness > 0.8)
                    .max_by(|a, b| a.0.total_cmp(&b.0))
                    .map(|(_, k)| k.clone());
                return Err(Error::UnknownFmu { name: name.clone(), suggestion, known });
            }
        }
        let wanted = |c: &&FmuCrate| match names {
            [] => test_fmus || !c.is_test,
            _ => names.iter().any(|n| plain(n) == plain(&c.name)),
        };
        Ok(self.crates.iter().filter(wanted).cloned().collect())
    }
}

/// `BoomCrane`, `boom-crane` and `boom_crane` mean the same FMU.
fn plain(name: &str) -> String {
    name.chars().filter(char::is_ascii_alphanumeric).map(|c| c.to_ascii_lowercase()).collect()
}
