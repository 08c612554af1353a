//! Files of results.

use std::path::Path;

use super::{Failure, console};

/// Writes a result into a file, in a folder that is made if need be, and says so.
pub fn write(path: &Path, text: &str) -> Result<(), Failure> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|source| write_failed(folder, source))?;
    }
    std::fs::write(path, text).map_err(|source| write_failed(path, source))?;
    console::note(format_args!("Wrote {}", path.display()));
    Ok(())
}

/// A file of results that cannot be written.
pub fn write_failed(path: &Path, source: std::io::Error) -> swayless::Error {
    swayless::Error::Io { action: "write", path: path.to_owned(), source }
}
