//! The terminals of an unpacked FMU, and the pictures they are drawn with.

use std::path::Path;

use swayless_modeldesc::problem::{Problem, ReadError, Severity};
use swayless_modeldesc::terminals::{TERMINALS_AND_ICONS, TerminalsAndIcons, read_and_check};
use swayless_modeldesc::types::ModelDescription;

use crate::error::{Error, Result};

/// What a reader made of a document.
type Read = std::result::Result<(TerminalsAndIcons, Vec<Problem>), ReadError>;

/// The terminals in the folder of an FMU, with all that is wrong with them; `None` if it has none.
///
/// # Errors
///
/// If the file is there but cannot be read.
pub fn read(folder: &Path, description: &ModelDescription) -> Result<Option<Read>> {
    let file = folder.join(TERMINALS_AND_ICONS);
    if !file.is_file() {
        return Ok(None);
    }
    let bytes = std::fs::read(&file).map_err(|source| Error::io("read", &file, source))?;
    Ok(Some(read_and_check(&bytes, description).map(|(content, mut problems)| {
        problems.extend(missing_pictures(&content, &folder.join("terminalsAndIcons")));
        problems.sort_by_key(|problem| problem.line);
        (content, problems)
    })))
}

/// A picture must be there as PNG; SVG is for those who want it.
fn missing_pictures(content: &TerminalsAndIcons, folder: &Path) -> Vec<Problem> {
    let mut problems = Vec::new();
    let mut missing = |line, message| problems.push(Problem { line, severity: Severity::Error, message });
    if folder.join("icon.svg").is_file() && !folder.join("icon.png").is_file() {
        missing(0, "there is an icon.svg without an icon.png; add the PNG".to_owned());
    }
    for terminal in content.all_terminals() {
        let Some(graphics) = &terminal.graphics else { continue };
        let name = &graphics.icon_base_name;
        // Names that lead elsewhere have been found, and escaped ones may be anything.
        let is_plain = !name.is_empty() && !name.contains([':', '%']) && Path::new(name).is_relative();
        if is_plain && !name.contains("..") && !folder.join(format!("{name}.png")).is_file() {
            let file = format!("terminalsAndIcons/{name}.png");
            missing(
                terminal.line,
                format!("the terminal `{}` is drawn with {file}, which is not there", terminal.name),
            );
        }
    }
    problems
}

#[cfg(test)]
mod tests {
    use swayless_modeldesc::types::FmiVersion;

    use super::*;

    #[test]
    fn pictures_must_be_there() {
        let description = ModelDescription::new(FmiVersion::V3, "Sample", "token");
        let folder = tempfile::tempdir().unwrap();
        assert!(read(folder.path(), &description).unwrap().is_none());
        let pictures = folder.path().join("terminalsAndIcons");
        std::fs::create_dir(&pictures).unwrap();
        let xml = "<fmiTerminalsAndIcons fmiVersion='3.0'>\n<Terminals><Terminal name='a' matchingRule='bus'>\n\
                   <TerminalGraphicalRepresentation x1='0' y1='0' x2='1' y2='1' iconBaseName='stub'/>\n\
                   </Terminal></Terminals></fmiTerminalsAndIcons>";
        std::fs::write(folder.path().join(TERMINALS_AND_ICONS), xml).unwrap();
        std::fs::write(pictures.join("icon.svg"), "").unwrap();
        let problems = || read(folder.path(), &description).unwrap().unwrap().unwrap().1;
        let found: Vec<String> = problems().iter().map(ToString::to_string).collect();
        assert_eq!(
            found,
            [
                "error: there is an icon.svg without an icon.png; add the PNG",
                "line 2: error: the terminal `a` is drawn with terminalsAndIcons/stub.png, which is not there",
            ]
        );
        std::fs::write(pictures.join("icon.png"), "").unwrap();
        std::fs::write(pictures.join("stub.png"), "").unwrap();
        assert_eq!(problems(), []);
    }
}
