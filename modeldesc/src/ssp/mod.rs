//! System Structure and Parameterization (SSP 1.0 and 2.0): how FMUs are wired and parameterized.
//!
//! A system description (`.ssd`) names the components and their connections; parameter sets (`.ssv`) and parameter
//! mappings (`.ssm`) stand inside it or in files of their own; a package (`.ssp`) is an archive with
//! [`SYSTEM_STRUCTURE`] at its root. Unpacking archives is the harness's business.
//!
//! As with model descriptions, a reader returns what it could read and all problems with their lines. Annotations,
//! geometry and signal dictionaries are skipped, the latter with a warning because connections to them go nowhere.

mod check;
mod flow;
mod read;
mod source;
pub mod types;
mod write;

pub use check::check;
pub use flow::{Flow, FlowError};
pub use read::{read_mapping, read_parameters, read_system};
pub use source::{SourceError, source_path};
pub use types::*;
pub use write::{write_mapping, write_parameters, write_system};

/// The entry of a package that holds its default system description (SSP 2.0, section 3).
pub const SYSTEM_STRUCTURE: &str = "SystemStructure.ssd";

/// Where the standard's namespaces begin; the name of the schema follows. SSP 2.0 still uses those of SSP 1.
const NAMESPACE: &str = "http://ssp-standard.org/SSP1/";
