//! Unpacks an archive from anywhere without trusting it: nothing is written outside the unpack folder, and neither the
//! number nor the size of what is written exceeds the limits.

use std::collections::HashSet;
use std::fs::{File, OpenOptions};
use std::io::{BufReader, Read, Write};
use std::path::{Path, PathBuf};

use tempfile::TempDir;
use zip::ZipArchive;

use crate::error::{ArchiveProblem, Error, Result};

/// How much an archive may hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// The number of entries.
    pub entries: usize,
    /// The bytes of all unpacked entries together.
    pub bytes: u64,
    /// The unpacked bytes over the archive's own size. It counts only above [`Limits::FREE_BYTES`]: tables of zeros pack
    /// well.
    pub ratio: u64,
}

impl Limits {
    /// Unpacked bytes below which the ratio does not matter.
    pub const FREE_BYTES: u64 = 64 << 20;
}

impl Default for Limits {
    fn default() -> Self {
        Self { entries: 20_000, bytes: 4 << 30, ratio: 200 }
    }
}

/// A folder with the contents of an archive. A temporary one is removed when this is dropped.
#[derive(Debug)]
pub struct Unpacked {
    folder: PathBuf,
    _temporary: Option<TempDir>,
}

impl Unpacked {
    /// Opens an archive, or takes a folder as an archive that someone else unpacked.
    pub fn open(path: &Path) -> Result<Self> {
        Self::open_with(path, Limits::default())
    }

    /// Opens with other limits.
    pub fn open_with(path: &Path, limits: Limits) -> Result<Self> {
        // Some FMUs want their resources' path to be absolute.
        let absolute = path.canonicalize().map_err(|source| Error::io("read", path, source))?;
        if absolute.is_dir() {
            return Ok(Self { folder: absolute, _temporary: None });
        }
        let temporary = tempfile::Builder::new()
            .prefix("swayless-")
            .tempdir()
            .map_err(|source| Error::io("create", std::env::temp_dir(), source))?;
        unpack(path, temporary.path(), limits)?;
        let folder = temporary.path().canonicalize().map_err(|source| Error::io("read", temporary.path(), source))?;
        Ok(Self { folder, _temporary: Some(temporary) })
    }

    /// The folder, absolute.
    pub fn folder(&self) -> &Path {
        &self.folder
    }
}

/// Writes all entries of an archive below a folder.
fn unpack(path: &Path, folder: &Path, limits: Limits) -> Result<()> {
    let problem = |problem| Error::Archive { path: path.to_owned(), problem };
    let broken = |reason: String| problem(ArchiveProblem::Broken { reason });

    let file = File::open(path).map_err(|source| Error::io("read", path, source))?;
    let packed_size = file.metadata().map_err(|source| Error::io("read", path, source))?.len();
    let mut archive = ZipArchive::new(BufReader::new(file)).map_err(|error| broken(error.to_string()))?;
    if archive.len() > limits.entries {
        return Err(problem(ArchiveProblem::TooManyEntries { count: archive.len(), limit: limits.entries }));
    }
    if archive.has_duplicate_names() {
        return Err(problem(ArchiveProblem::Duplicate { entry: "(some entry)".to_owned() }));
    }

    let inflated = packed_size.saturating_mul(limits.ratio).max(Limits::FREE_BYTES);
    let mut budget = limits.bytes.min(inflated);
    let exceeded = || {
        problem(match inflated < limits.bytes {
            true => ArchiveProblem::Inflates { limit: limits.ratio },
            false => ArchiveProblem::TooLarge { limit: limits.bytes },
        })
    };

    let mut seen = HashSet::new();
    let mut buffer = vec![0; 1 << 16];
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).map_err(|error| broken(error.to_string()))?;
        let name = entry.name().map_err(|error| broken(error.to_string()))?.into_owned();
        check_name(&name).map_err(|why| problem(ArchiveProblem::Escapes { entry: name.clone(), why }))?;
        if let Some(kind) = special(&entry) {
            return Err(problem(ArchiveProblem::Special { entry: name, kind }));
        }
        if !seen.insert(name.trim_end_matches('/').to_lowercase()) {
            return Err(problem(ArchiveProblem::Duplicate { entry: name }));
        }
        let target = folder.join(&name);
        if name.ends_with('/') {
            std::fs::create_dir_all(&target).map_err(|source| Error::io("create", &target, source))?;
            continue;
        }
        if let Some(parent) = target.parent() {
            std::fs::create_dir_all(parent).map_err(|source| Error::io("create", parent, source))?;
        }
        // `create_new` follows no link and overwrites nothing, whatever the names above may have missed.
        let mut file = OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(&target)
            .map_err(|source| Error::io("create", &target, source))?;
        loop {
            // The bytes that really come out count, not those that a header promises.
            let count = entry.read(&mut buffer).map_err(|error| broken(format!("`{name}`: {error}")))?;
            if count == 0 {
                break;
            }
            budget = budget.checked_sub(count as u64).ok_or_else(exceeded)?;
            file.write_all(&buffer[..count]).map_err(|source| Error::io("write", &target, source))?;
        }
    }
    Ok(())
}

/// What an entry is that is neither a file nor a folder.
fn special<R: Read>(entry: &zip::read::ZipFile<'_, R>) -> Option<&'static str> {
    const FILE_TYPE: u32 = 0o170_000;
    let file_type = entry.unix_mode().map_or(0, |mode| mode & FILE_TYPE);
    match file_type {
        _ if entry.is_symlink() => Some("symbolic link"),
        _ if entry.encrypted() => Some("encrypted file"),
        0 | 0o100_000 | 0o040_000 => None,
        _ => Some("device, pipe or socket"),
    }
}

/// Whether an entry's name is a plain path below the unpack folder, on every platform.
fn check_name(name: &str) -> Result<(), &'static str> {
    if name.starts_with('/') {
        return Err("it is an absolute path");
    }
    if name.contains('\\') {
        return Err("it contains a backslash");
    }
    if name.contains(':') {
        return Err("it contains a colon, as after a drive letter");
    }
    if name.contains(char::is_control) {
        return Err("it contains a control character");
    }
    let components = name.strip_suffix('/').unwrap_or(name);
    for component in components.split('/') {
        match component.trim_end_matches([' ', '.']) {
            "" if component.is_empty() => return Err("it has an empty component"),
            // On Windows, blanks and dots at the end of a name are dropped.
            "" => return Err("it contains `.` or `..`"),
            _ => {}
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
