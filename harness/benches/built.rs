//! The built FMUs that are measured.

use std::fmt;
use std::path::{Path, PathBuf};

use swayless::Fmu;
use swayless_modeldesc::types::DataType;

/// A built FMU by the version's folder and its file's stem.
#[derive(Clone)]
pub struct Built(pub PathBuf);

impl fmt::Display for Built {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |path: Option<&Path>| path.and_then(Path::file_stem).unwrap_or_default().display().to_string();
        write!(f, "{}/{}", part(self.0.parent()), part(Some(&self.0)))
    }
}

/// Every archive in the folder that `SWAYLESS_FMUS` names, or in `target/fmus`, of an FMU that the harness can make an
/// instance of: one with clocks is not among them.
pub fn built() -> Vec<Built> {
    let default = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/fmus");
    let folder = std::env::var_os("SWAYLESS_FMUS").map_or_else(default, PathBuf::from);
    let mut found: Vec<_> = ["fmi2", "fmi3"]
        .iter()
        .filter_map(|version| folder.join(version).read_dir().ok())
        .flat_map(|entries| entries.filter_map(|entry| Some(Built(entry.ok()?.path()))))
        .filter(|built| built.0.extension().is_some_and(|extension| extension == "fmu"))
        .filter(|built| {
            let has_clocks = |fmu: &Fmu| fmu.description().variables.iter().any(|v| v.data_type == DataType::Clock);
            Fmu::open(&built.0).is_ok_and(|fmu| !has_clocks(&fmu))
        })
        .collect();
    found.sort_by(|a, b| a.0.cmp(&b.0));
    if found.is_empty() {
        println!("no FMUs in {}: run `swayless build` first", folder.display());
    }
    found
}
