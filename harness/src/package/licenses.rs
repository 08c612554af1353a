//! The licences that an FMU carries: its own, those of the crates linked into it, and those of what the tools add.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use cargo_metadata::{Metadata, MetadataCommand, Package};

use super::workspace::{FmuCrate, Workspace};
use super::{Error, compile};

/// Beginnings of the names of files that hold a licence or a notice, in capitals.
const NAMES: [&str; 6] = ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE", "UNLICENSE"];

/// The notices that come with the compiler, below its folder.
const STANDARD_LIBRARY: &str = "share/doc/rust/COPYRIGHT-library.html";

/// Files for `documentation/licenses/`, each by its name.
pub type Files = Vec<(&'static str, String)>;

/// Knows the licences of all that may be linked into an FMU of a workspace.
pub struct Licenses<'a> {
    workspace: &'a Workspace,
    metadata: Metadata,
    own: Option<String>,
    standard_library: Option<String>,
    /// What the linker of a portable build adds, with its texts.
    runtime: Vec<Licensed>,
}

/// Something that is linked into an FMU, with the files of its licence, each by its name.
struct Licensed {
    what: String,
    texts: Vec<(String, String)>,
}

impl<'a> Licenses<'a> {
    /// Asks cargo and the compiler.
    pub fn find(workspace: &'a Workspace, portable: bool) -> Result<Self, Error> {
        let metadata = MetadataCommand::new().current_dir(&workspace.root).exec().map_err(Error::Workspace)?;
        Ok(Self {
            workspace,
            metadata,
            own: own(&workspace.root)?,
            standard_library: standard_library(&workspace.root)?,
            runtime: if portable { vec![zig()?] } else { Vec::new() },
        })
    }

    /// The files for an FMU.
    pub fn of(&self, krate: &FmuCrate) -> Result<Files, Error> {
        let mut linked = self.crates(krate)?.into_iter().map(licensed).collect::<Result<Vec<_>, _>>()?;
        linked.extend(self.runtime.iter().map(|r| Licensed { what: r.what.clone(), texts: r.texts.clone() }));
        let mut files: Files = self.own.iter().map(|text| ("license.txt", text.clone())).collect();
        files.push(("third-party.txt", third_party(&linked, self.standard_library.is_some())));
        files.extend(self.standard_library.iter().map(|text| ("rust-standard-library.html", text.clone())));
        Ok(files)
    }

    /// The crates of others that are linked into an FMU, in the order of their names: no build scripts, no macros. Cargo
    /// knows which optional ones are in use.
    fn crates(&self, krate: &FmuCrate) -> Result<Vec<&Package>, Error> {
        let mut command = Command::new(compile::cargo());
        command.current_dir(&self.workspace.root).args(["tree", "--package", &krate.name]);
        command.args(["--edges", "normal,no-proc-macro", "--prefix", "none", "--no-dedupe", "--format", "{p}"]);
        let mut names: Vec<(String, String)> = lines(&mut command)?
            .iter()
            .filter_map(|line| {
                let mut words = line.split_whitespace();
                Some((words.next()?.to_owned(), words.next()?.trim_start_matches('v').to_owned()))
            })
            .collect();
        names.sort();
        names.dedup();
        let package = |(name, version): &(String, String)| {
            self.metadata.packages.iter().find(|p| *p.name == *name && p.version.to_string() == *version)
        };
        Ok(names.iter().filter_map(package).filter(|p| p.source.is_some()).collect())
    }
}

/// The licences of the workspace's own code, as one text.
fn own(root: &Path) -> Result<Option<String>, Error> {
    let read = |name: &str| {
        let path = root.join(name);
        if path.is_file() { std::fs::read_to_string(&path).map(Some).map_err(Error::io(&path)) } else { Ok(None) }
    };
    let (Some(mit), Some(apache)) = (read("LICENSE-MIT")?, read("LICENSE-APACHE")?) else { return Ok(None) };
    Ok(Some(format!("Licensed under either of the following, at your option.\n\n{mit}\n\n{apache}")))
}

/// The compiler's page of notices, if it came with one.
fn standard_library(root: &Path) -> Result<Option<String>, Error> {
    let mut command = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    let folder = lines(command.current_dir(root).args(["--print", "sysroot"]))?;
    let path = folder.first().map(|folder| Path::new(folder).join(STANDARD_LIBRARY));
    path.filter(|p| p.is_file()).map(|p| std::fs::read_to_string(&p).map_err(Error::io(&p))).transpose()
}

/// What zig's linker adds: the unwinder of LLVM and the compiler's runtime of zig.
fn zig() -> Result<Licensed, Error> {
    let said = lines(Command::new(compile::ZIGBUILD).args(["zig", "cc", "--", "-print-search-dirs"]))?;
    // The first folder of programs is that of zig itself.
    let programs = said.iter().find_map(|line| line.strip_prefix("programs: ="));
    let folder = PathBuf::from(programs.unwrap_or_default().split(':').next().unwrap_or_default());
    let what = "libunwind of LLVM and compiler_rt of zig".to_owned();
    let texts = ["LICENSE", "lib/libunwind/LICENSE.TXT"].map(|name| {
        let read = std::fs::read_to_string(folder.join(name));
        read.map(|text| (name.to_owned(), text))
            .map_err(|_| Error::NoLicense { of: what.clone(), folder: folder.clone() })
    });
    Ok(Licensed { texts: texts.into_iter().collect::<Result<_, _>>()?, what })
}

/// The licence files of a crate.
fn licensed(package: &Package) -> Result<Licensed, Error> {
    let folder = package.manifest_path.parent().map(|p| p.as_std_path().to_owned()).unwrap_or_default();
    let declared = package.license_file.as_ref().map(|file| file.as_str().to_owned());
    let entries = std::fs::read_dir(&folder).map_err(Error::io(&folder))?.flatten();
    let mut names: Vec<String> = entries.filter_map(|e| e.file_name().into_string().ok()).collect();
    names.retain(|name| NAMES.iter().any(|start| name.to_uppercase().starts_with(start)));
    names.extend(declared);
    names.sort();
    names.dedup();
    let mut texts = Vec::new();
    for name in names {
        let path = folder.join(&name);
        if path.is_file() {
            texts.push((name, std::fs::read_to_string(&path).map_err(Error::io(&path))?));
        }
    }
    let what = format!("{} {}", package.name, package.version);
    if texts.is_empty() {
        return Err(Error::NoLicense { of: what, folder });
    }
    let license = package.license.as_deref().unwrap_or("see below");
    Ok(Licensed { what: format!("{what} ({license})"), texts })
}

/// All licences as one text, each once, after the list of those that they are of.
fn third_party(linked: &[Licensed], standard_library: bool) -> String {
    let mut page = "The library of this FMU holds, each under its own licence:\n\n".to_owned();
    let line = |page: &mut String, text: &str| {
        // Writing to a string does not fail.
        let _ = writeln!(page, "{text}");
    };
    linked.iter().for_each(|l| line(&mut page, &format!("  {}", l.what)));
    let notices = if standard_library {
        "see rust-standard-library.html"
    } else {
        "for its notices see COPYRIGHT at https://github.com/rust-lang/rust"
    };
    line(&mut page, &format!("  the Rust standard library (MIT OR Apache-2.0), {notices}"));
    let mut texts: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    let mut order = Vec::new();
    for one in linked {
        for (name, text) in &one.texts {
            let users = texts.entry(text.trim()).or_insert_with(|| {
                order.push(text.trim());
                Vec::new()
            });
            users.push(format!("{} of {}", name, one.what));
        }
    }
    for text in order {
        line(&mut page, &format!("\n{}\n", "=".repeat(80)));
        texts[text].iter().for_each(|user| line(&mut page, user));
        line(&mut page, &format!("\n{text}"));
    }
    page
}

/// What a program prints, line by line.
fn lines(command: &mut Command) -> Result<Vec<String>, Error> {
    let program = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|source| Error::NoCargo { program: program.clone(), source })?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
        return Err(Error::Tool { command: format!("{command:?}"), said });
    }
    Ok(String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn linked(what: &str, texts: &[(&str, &str)]) -> Licensed {
        let texts = texts.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        Licensed { what: what.to_owned(), texts }
    }

    #[test]
    fn every_text_stands_once_with_all_that_it_is_of() {
        let one = linked("one 1.0.0", &[("LICENSE-MIT", "mit of one"), ("LICENSE-APACHE", "apache\n")]);
        let two = linked("two 2.0.0", &[("LICENSE", "apache")]);
        let page = third_party(&[one, two], true);
        assert_eq!(page.matches("apache").count(), 1, "{page}");
        assert!(page.contains("LICENSE-APACHE of one 1.0.0\nLICENSE of two 2.0.0\n\napache\n"), "{page}");
        assert!(page.contains("mit of one") && page.contains("rust-standard-library.html"), "{page}");
    }

    #[test]
    fn a_crate_without_a_licence_text_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let manifest = folder.path().join("Cargo.toml");
        let package = serde_json::json!({
            "name": "bare", "version": "1.2.3", "id": "bare 1.2.3", "license": "MIT", "dependencies": [], "targets": [],
            "features": {}, "manifest_path": manifest, "source": null,
        });
        let package: Package = serde_json::from_value(package).unwrap();
        let error = licensed(&package).map(|_| ()).unwrap_err().to_string();
        assert!(error.contains("bare 1.2.3") && error.contains(&*folder.path().to_string_lossy()), "{error}");
        std::fs::write(folder.path().join("licence.md"), "text").unwrap();
        assert_eq!(licensed(&package).unwrap().texts, [("licence.md".to_owned(), "text".to_owned())]);
    }
}
