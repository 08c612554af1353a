//! Adds binaries that were built on other platforms to an FMU.
//!
//! They cannot be loaded here, so they are read: format and architecture, the functions they export, and that they hold
//! the texts of the FMU's variables. That the variables' numbers are the same is checked by the library itself: it
//! refuses to be instantiated with a token that is not its own.

use std::collections::{BTreeSet, HashSet};
use std::io::Read;
use std::path::{Path, PathBuf};

use object::Object;
use object::read::NameOrOrdinal;
use swayless_abi::{fmi2, fmi3};
use swayless_modeldesc::types::{Causality, FmiVersion, ModelDescription};

use super::platform::Platform;
use super::{Error, archive};
use crate::Fmu;

/// Adds to `fmu` the binaries of its model that lie in `from`, an FMU or the folder of an unpacked one, of either
/// version of the standard. Returns the entries that were added; those that are there already with the same bytes are
/// left as they are. When one of them is refused, nothing is changed.
pub fn add_platforms(fmu: &Path, from: &Path) -> Result<Vec<String>, Error> {
    let target = Fmu::open(fmu).map_err(Error::fmu)?;
    let description = target.description();
    let mut entries = read(fmu)?;
    let source = crate::archive::Unpacked::open(from).map_err(Error::fmu)?;
    let mut added = Vec::new();
    for (platform, path) in binaries(source.folder(), &identifier(description))? {
        let bytes = std::fs::read(&path).map_err(Error::io(&path))?;
        // What was unpacked has a path that says nothing.
        let shown = from.join(path.strip_prefix(source.folder()).unwrap_or(&path));
        let refused = |problem| Error::Foreign { path: shown.clone(), problem };
        check(&bytes, platform, description).map_err(refused)?;
        let version = description.fmi_version;
        let name = format!("binaries/{}/{}.{}", platform.name(version), identifier(description), platform.extension);
        match entries.iter().find(|(entry, _)| *entry == name) {
            Some((_, there)) if *there == bytes => {}
            Some(_) => return Err(refused(format!("{} has another `{name}` already", fmu.display()))),
            None => {
                entries.push((name.clone(), bytes));
                added.push(name);
            }
        }
    }
    // Binaries come last, in the order of their names: in whatever order they were added, the bytes are the same.
    let (mut binaries, mut entries): (Vec<_>, Vec<_>) =
        entries.into_iter().partition(|(name, _)| name.starts_with("binaries/"));
    binaries.sort();
    entries.extend(binaries);
    if !added.is_empty() {
        archive::write(fmu, &entries)?;
    }
    Ok(added)
}

/// The file name of the binaries, without extension.
fn identifier(description: &ModelDescription) -> String {
    let interfaces = [&description.co_simulation, &description.model_exchange, &description.scheduled_execution];
    interfaces.into_iter().flatten().next().map(|i| i.model_identifier.clone()).unwrap_or_default()
}

/// The entries of an archive that has been opened as an FMU, and so is known to hold nothing dangerous.
fn read(path: &Path) -> Result<Vec<(String, Vec<u8>)>, Error> {
    let zip = |source| Error::Zip { path: path.to_owned(), source };
    let file = std::fs::File::open(path).map_err(Error::io(path))?;
    let mut archive = zip::ZipArchive::new(std::io::BufReader::new(file)).map_err(zip)?;
    let mut entries = Vec::new();
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).map_err(zip)?;
        if entry.is_file() {
            let mut bytes = Vec::new();
            entry.read_to_end(&mut bytes).map_err(Error::io(path))?;
            entries.push((entry.name().map_err(zip)?.into_owned(), bytes));
        }
    }
    Ok(entries)
}

/// The binaries of this name below `binaries/`, each with its platform.
fn binaries(folder: &Path, name: &str) -> Result<Vec<(&'static Platform, PathBuf)>, Error> {
    let binaries = folder.join("binaries");
    let mut found = Vec::new();
    let entries = std::fs::read_dir(&binaries).map_err(Error::io(&binaries))?;
    let mut folders: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).filter(|p| p.is_dir()).collect();
    folders.sort();
    for folder in &folders {
        let platform = folder.file_name().and_then(|n| n.to_str()).and_then(Platform::named);
        if let Some(path) = platform.map(|p| folder.join(format!("{name}.{}", p.extension))).filter(|p| p.is_file()) {
            found.extend(platform.map(|p| (p, path)));
        }
    }
    if found.is_empty() {
        let known = Platform::names(FmiVersion::V3);
        return Err(Error::NothingToAdd { folder: binaries, name: name.to_owned(), known });
    }
    Ok(found)
}

/// What keeps bytes from being the library of this model on a platform.
fn check(bytes: &[u8], platform: &Platform, description: &ModelDescription) -> Result<(), String> {
    let file = object::File::parse(bytes).map_err(|error| format!("it is no library: {error}"))?;
    if let Some(problem) = platform.problem(&file) {
        return Err(problem);
    }
    let exports = exports(&file)?;
    let wanted = match description.fmi_version {
        FmiVersion::V2 => fmi2::Functions::NAMES,
        FmiVersion::V3 => fmi3::Functions::NAMES,
    };
    let missing: Vec<_> = wanted.iter().copied().filter(|name| !exports.contains(*name)).collect();
    if let Some(first) = missing.first() {
        return Err(format!("it does not export `{first}`{}", others(missing.len())));
    }
    let holds = |text: &str| text.is_empty() || occurs(bytes, text.as_bytes());
    // The exporter makes up the texts of time, derivatives and second names (FMI 2.0 tells them by the value reference)
    // when it is asked; all others stand in the library.
    let mut seen = HashSet::new();
    let lacking: Vec<_> = description
        .variables
        .iter()
        .filter(|v| seen.insert((v.data_type, v.value_reference)))
        .filter(|v| v.causality != Causality::Independent && v.derivative.is_none())
        .filter(|v| !v.description.as_deref().is_none_or(holds))
        .map(|v| v.name.as_str())
        .collect();
    if let Some(first) = lacking.first() {
        return Err(format!(
            "it is of another model, or of another version of it: it lacks the description of `{first}`{}",
            others(lacking.len())
        ));
    }
    Ok(())
}

/// The names that a library exports, without the underscore that Mach-O puts before each.
fn exports(file: &object::File<'_>) -> Result<BTreeSet<String>, String> {
    let is_macho = file.format() == object::BinaryFormat::MachO;
    let mut names = BTreeSet::new();
    for export in file.exports().map_err(|error| format!("its exports are unreadable: {error}"))? {
        let export = export.map_err(|error| format!("its exports are unreadable: {error}"))?;
        if let NameOrOrdinal::Name(name) = export.into_name() {
            let name = String::from_utf8_lossy(&name).into_owned();
            names.insert(if is_macho { name.strip_prefix('_').unwrap_or(&name).to_owned() } else { name });
        }
    }
    Ok(names)
}

/// Whether a text is among the bytes.
fn occurs(bytes: &[u8], text: &[u8]) -> bool {
    bytes.windows(text.len()).any(|window| window == text)
}

fn others(count: usize) -> String {
    if count > 1 { format!(" and {} more", count - 1) } else { String::new() }
}
