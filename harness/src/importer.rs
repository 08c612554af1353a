//! Opens an FMU: unpacks it, reads its description and loads its binary.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use swayless_modeldesc::problem::{Problem, Severity};
use swayless_modeldesc::read::read_bytes;
use swayless_modeldesc::types::{Causality, FmiVersion, Interface, ModelDescription};

use crate::archive::Unpacked;
use crate::error::{Error, Result};
use crate::loader::{Binary, Instantiation, Once};
use crate::slave::{Model, Slave};

/// The standard's log categories for calls that did not go well.
const PROBLEMS: [&str; 4] = ["logStatusWarning", "logStatusDiscard", "logStatusError", "logStatusFatal"];

/// An FMU that is open. Its library is loaded when the first instance is made; it, and the folder that the FMU was
/// unpacked to, stay as long as the FMU or an instance of it lives.
pub struct Fmu {
    path: PathBuf,
    unpacked: Arc<Unpacked>,
    description: ModelDescription,
    warnings: Vec<Problem>,
    binary: Mutex<Option<Binary>>,
    instantiated: Arc<AtomicBool>,
}

impl Fmu {
    /// Opens an `.fmu` or the folder of an unpacked one.
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let unpacked = Unpacked::open(path)?;
        let file = unpacked.folder().join("modelDescription.xml");
        let xml = std::fs::read(&file).map_err(|source| match source.kind() {
            std::io::ErrorKind::NotFound => Error::NoDescription { path: path.to_owned() },
            _ => Error::io("read", &file, source),
        })?;
        let invalid =
            |problems: Vec<String>| Error::InvalidDescription { path: path.join("modelDescription.xml"), problems };
        let (description, problems) = read_bytes(&xml).map_err(|error| invalid(vec![error.to_string()]))?;
        if problems.iter().any(|problem| problem.severity == Severity::Error) {
            return Err(invalid(problems.iter().map(ToString::to_string).collect()));
        }
        Ok(Self {
            path: path.to_owned(),
            unpacked: Arc::new(unpacked),
            description,
            warnings: problems,
            binary: Mutex::new(None),
            instantiated: Arc::default(),
        })
    }

    /// The file or folder it was opened from.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Its description.
    pub fn description(&self) -> &ModelDescription {
        &self.description
    }

    /// What is odd about its description without being wrong.
    pub fn warnings(&self) -> &[Problem] {
        &self.warnings
    }

    /// The folder with its files, absolute.
    pub fn folder(&self) -> &Path {
        self.unpacked.folder()
    }

    /// The binaries it has, each as `folder/file` below `binaries/`, in order.
    pub fn binaries(&self) -> Vec<String> {
        let names = |folder: &Path| -> Vec<String> {
            let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
            entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
        };
        let binaries = self.folder().join("binaries");
        let mut found: Vec<String> = names(&binaries)
            .into_iter()
            .flat_map(|platform| {
                let files = names(&binaries.join(&platform));
                files.into_iter().map(move |file| format!("{platform}/{file}"))
            })
            .filter(|file| [".so", ".dll", ".dylib"].iter().any(|suffix| file.ends_with(suffix)))
            .collect();
        found.sort();
        found
    }

    /// The binary for this platform.
    fn find_binary(&self, interface: &Interface) -> Result<PathBuf> {
        let name = &interface.model_identifier;
        if !is_c_identifier(name) {
            return Err(Error::InvalidDescription {
                path: self.path.join("modelDescription.xml"),
                problems: vec![format!(
                    "modelIdentifier `{name}` is not a C identifier, as the file of a binary must be"
                )],
            });
        }
        let file = format!("{name}.{}", std::env::consts::DLL_EXTENSION);
        let folders = platform_folders(self.description.fmi_version);
        let found = folders.iter().map(|folder| self.folder().join("binaries").join(folder).join(&file));
        found.into_iter().find(|path| path.is_file()).ok_or_else(|| Error::NoBinary {
            path: self.path.clone(),
            wanted: format!("{}/{file}", folders[0]),
            available: self.binaries(),
        })
    }
}

/// The co-simulation interface of a model that this master can run.
pub(crate) fn co_simulation<'a>(path: &Path, description: &'a ModelDescription) -> Result<&'a Interface> {
    let Some(interface) = &description.co_simulation else {
        let others = [
            (description.model_exchange.is_some(), "model exchange"),
            (description.scheduled_execution.is_some(), "scheduled execution"),
        ];
        let offered: Vec<_> = others.iter().filter(|(offered, _)| *offered).map(|&(_, name)| name).collect();
        return Err(Error::NoCoSimulation {
            path: path.to_owned(),
            model: description.model_name.clone(),
            offered: if offered.is_empty() { "nothing".to_owned() } else { offered.join(" and ") },
        });
    };
    let clocks = description.variables.iter().filter(|v| v.clock.is_some() && v.causality == Causality::Input);
    let clocks: Vec<String> = clocks.map(|clock| format!("`{}`", clock.name)).collect();
    if !clocks.is_empty() {
        let (path, model) = (path.to_owned(), description.model_name.clone());
        let alternative = without_clocks(&path);
        return Err(Error::Clocked { path, model, clocks, alternative });
    }
    Ok(interface)
}

/// The FMU of the same model beside one with clocks, as the packager names both.
fn without_clocks(path: &Path) -> Option<PathBuf> {
    let name = path.file_stem()?.to_str()?.strip_suffix("Clocked")?;
    let beside = path.with_file_name(format!("{name}.fmu"));
    beside.is_file().then_some(beside)
}

impl Model for Fmu {
    fn path(&self) -> &Path {
        &self.path
    }

    fn description(&self) -> &ModelDescription {
        &self.description
    }

    fn instantiate(&self, name: &str, logging: bool) -> Result<Box<dyn Slave>> {
        let interface = co_simulation(&self.path, &self.description)?;
        let once = match interface.can_be_instantiated_only_once_per_process {
            false => None,
            true if self.instantiated.swap(true, Ordering::AcqRel) => {
                let model = self.description.model_name.clone();
                return Err(Error::OnlyOnce { path: self.path.clone(), model });
            }
            true => Some(Once(self.instantiated.clone())),
        };
        let mut binary = self.binary.lock().unwrap_or_else(PoisonError::into_inner);
        let binary = match &mut *binary {
            Some(binary) => binary,
            empty => {
                let file = self.find_binary(interface)?;
                empty.insert(Binary::load(self.description.fmi_version, &file, self.unpacked.clone())?)
            }
        };
        let categories = self.description.log_categories.iter().map(|category| category.name.as_str());
        let problems: Vec<&str> = categories.filter(|name| PROBLEMS.contains(name)).collect();
        let resources = self.folder().join("resources");
        let token = &self.description.instantiation_token;
        binary.instantiate(Instantiation {
            fmu: &self.path,
            name,
            token,
            resources: &resources,
            logging,
            problems: &problems,
            once,
        })
    }
}

fn is_c_identifier(name: &str) -> bool {
    let letter = |c: char| c.is_ascii_alphabetic() || c == '_';
    name.starts_with(letter) && name.chars().all(|c| letter(c) || c.is_ascii_digit())
}

/// The folders below `binaries/` that serve this platform, the usual one first.
pub fn platform_folders(version: FmiVersion) -> Vec<String> {
    let architecture = match std::env::consts::ARCH {
        "arm" => "aarch32",
        other => other,
    };
    let system = match std::env::consts::OS {
        "macos" => "darwin",
        other => other,
    };
    let tuple = format!("{architecture}-{system}");
    if version == FmiVersion::V3 {
        return vec![tuple];
    }
    let short = match system {
        "windows" => "win",
        other => other,
    };
    // FMI 2.0 knows its short names on x86 only; since 2.0.4 the tuples of FMI 3.0 are allowed as well. Tools for
    // other processors used the short names before that.
    let bits = if cfg!(target_pointer_width = "32") { "32" } else { "64" };
    match architecture {
        "x86" | "x86_64" => vec![format!("{short}{bits}"), tuple],
        _ => vec![tuple, format!("{short}{bits}")],
    }
}
