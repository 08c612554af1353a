//! Writes an `.fmu`: a zip archive with the layout that each version of the standard lays down.
//!
//! Entries come in a fixed order with a fixed date, fixed permissions and one method of compression, so that equal
//! contents give equal bytes.

use std::env::consts::{ARCH, OS};
use std::io::{Seek, Write};
use std::path::Path;

use swayless_abi::describe::TERMINAL_PICTURE;
use swayless_modeldesc::terminals;
use swayless_modeldesc::types::FmiVersion;
use zip::write::{SimpleFileOptions, ZipWriter};
use zip::{CompressionMethod, DateTime};

use super::describe::Parts;
use super::platform::Platform;
use super::{Error, icon, page};

/// The picture of every terminal, in SVG.
const TERMINAL: &str = include_str!("terminal.svg");

/// What goes into an archive.
#[derive(Debug, Clone, Copy)]
pub struct Contents<'a> {
    /// The version whose layout it gets.
    pub version: FmiVersion,
    /// `modelIdentifier`.
    pub name: &'a str,
    /// `modelDescription.xml`.
    pub description: &'a str,
    /// What the library says about itself.
    pub parts: &'a Parts,
    /// The library.
    pub binary: &'a [u8],
    /// Files for `documentation/licenses`.
    pub licenses: &'a [(&'static str, String)],
}

/// Writes an archive of these entries, by way of a temporary file: nobody ever sees half of one.
pub fn write(path: &Path, entries: &[(String, Vec<u8>)]) -> Result<(), Error> {
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder).map_err(Error::io(folder))?;
    let mut file = tempfile::Builder::new().suffix(".fmu").tempfile_in(folder).map_err(Error::io(folder))?;
    pack(file.as_file_mut(), entries).map_err(|source| Error::Zip { path: path.to_owned(), source })?;
    readable_by_all(file.as_file()).map_err(Error::io(path))?;
    file.persist(path).map_err(|e| Error::io(path)(e.error))?;
    Ok(())
}

/// A temporary file belongs to its user alone; an FMU is for everyone.
fn readable_by_all(file: &std::fs::File) -> std::io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        file.set_permissions(std::fs::Permissions::from_mode(0o644))?;
    }
    let _ = file;
    Ok(())
}

/// Names and contents, in the order in which they are packed: the description first, where a reader looks for it.
pub fn entries(contents: &Contents) -> Result<Vec<(String, Vec<u8>)>, Error> {
    let Contents { version, name, description, parts, binary, licenses } = *contents;
    let page = page::page(name, &parts.documentation, &parts.icon);
    let svg = parts.icon.as_bytes();
    let mut entries: Vec<(String, Vec<u8>)> = Vec::new();
    let mut add = |name: &str, bytes: &[u8]| entries.push((name.to_owned(), bytes.to_owned()));
    let platform = Platform::here().ok_or(Error::Platform { arch: ARCH, os: OS })?;
    let binary_name = format!("binaries/{}/{name}.{}", platform.name(version), platform.extension);
    add("modelDescription.xml", description.as_bytes());
    match version {
        FmiVersion::V2 => add("model.png", &icon::png(&parts.icon, name)?),
        FmiVersion::V3 => {
            add(terminals::TERMINALS_AND_ICONS, parts.terminals.as_bytes());
            // An SVG there requires the PNG beside it.
            add("terminalsAndIcons/icon.png", &icon::png(&parts.icon, name)?);
            add("terminalsAndIcons/icon.svg", svg);
            if parts.terminals.contains(&format!("iconBaseName=\"{TERMINAL_PICTURE}\"")) {
                add(&format!("terminalsAndIcons/{TERMINAL_PICTURE}.png"), &icon::png(TERMINAL, name)?);
                add(&format!("terminalsAndIcons/{TERMINAL_PICTURE}.svg"), TERMINAL.as_bytes());
            }
        }
    }
    add("documentation/index.html", page.as_bytes());
    for (name, text) in licenses {
        add(&format!("documentation/licenses/{name}"), text.as_bytes());
    }
    add(&binary_name, binary);
    Ok(entries)
}

fn pack<W: Write + Seek>(writer: W, entries: &[(String, Vec<u8>)]) -> zip::result::ZipResult<()> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .compression_level(Some(9))
        .last_modified_time(DateTime::DEFAULT)
        .unix_permissions(0o644);
    let mut zip = ZipWriter::new(writer);
    for (name, bytes) in entries {
        zip.start_file(name.as_str(), options)?;
        zip.write_all(bytes)?;
    }
    zip.finish()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::io::{Cursor, Read};
    use std::sync::LazyLock;

    use super::super::licenses::Files;
    use super::*;

    fn parts() -> Parts {
        Parts {
            name: "Sample".into(),
            fmi2: "<two/>".into(),
            fmi3: "<three/>".into(),
            clocked: None,
            terminals: "<terminal iconBaseName=\"terminal\"/>".into(),
            documentation: "# Sample\n\nWords.".into(),
            icon: r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><path d="M0 0h9v9z"/></svg>"#.into(),
        }
    }

    static LICENSES: LazyLock<Files> = LazyLock::new(|| vec![("license.txt", "licence".to_owned())]);

    fn contents<'a>(version: FmiVersion, parts: &'a Parts, binary: &'a [u8]) -> Contents<'a> {
        Contents { version, name: &parts.name, description: &parts.fmi3, parts, binary, licenses: &LICENSES }
    }

    #[test]
    fn each_version_has_its_layout() {
        let parts = parts();
        let entries = |version| entries(&contents(version, &parts, b"binary")).unwrap();
        let names = |version| entries(version).into_iter().map(|(name, _)| name).collect::<Vec<_>>();
        let (two, three) = (names(FmiVersion::V2), names(FmiVersion::V3));
        for names in [&two, &three] {
            assert_eq!(names[0], "modelDescription.xml");
            assert!(names.contains(&"documentation/index.html".to_owned()));
            assert!(names.contains(&"documentation/licenses/license.txt".to_owned()));
        }
        assert!(two.contains(&"model.png".to_owned()));
        for name in ["terminalsAndIcons.xml", "icon.png", "icon.svg", "terminal.png", "terminal.svg"] {
            assert!(three.contains(&format!("terminalsAndIcons/{name}")), "{name}");
        }
    }

    #[test]
    fn equal_contents_give_equal_bytes_that_unpack() {
        let parts = parts();
        let contents = contents(FmiVersion::V3, &parts, &[7; 10_000]);
        let bytes = || {
            let mut buffer = Cursor::new(Vec::new());
            pack(&mut buffer, &entries(&contents).unwrap()).unwrap();
            buffer.into_inner()
        };
        let first = bytes();
        assert_eq!(first, bytes());
        // `version needed to extract` at most 2.0, as the standard demands.
        assert!(first[4] <= 20);
        let mut archive = zip::ZipArchive::new(Cursor::new(first)).unwrap();
        let mut text = String::new();
        archive.by_name("modelDescription.xml").unwrap().read_to_string(&mut text).unwrap();
        assert_eq!(text, "<three/>");
    }
}
