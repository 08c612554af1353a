//! The checks in Python: FMPy, fmu-manipulation-toolbox and CVode, in an environment of their own.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::packaged::{self, locked, repository};

#[test]
fn checks_in_python_pass() {
    let fmus = packaged::all().output_dir.clone();
    let python = environment();
    let output = Command::new(python)
        .args(["-m", "pytest", "-p", "no:cacheprovider", "-v", "--capture=no", "--tb=short", "."])
        .current_dir(repository().join("tests/python"))
        .env("SWAYLESS_FMUS", fmus)
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .output()
        .expect("pytest starts");
    println!("{}", String::from_utf8_lossy(&output.stdout));
    eprintln!("{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "checks in Python failed; their output is above");
}

/// The interpreter of a virtual environment with the pinned packages, which is made anew when they change.
pub fn environment() -> PathBuf {
    let requirements = repository().join("tests/python/requirements.txt");
    let wanted = std::fs::read_to_string(&requirements).expect("requirements");
    let folder = packaged::target().join("python");
    let python = folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    let stamp = folder.join("installed.txt");
    locked("python", || {
        if std::fs::read_to_string(&stamp).is_ok_and(|installed| installed == wanted) && works(&python) {
            return;
        }
        if folder.exists() {
            std::fs::remove_dir_all(&folder).expect("an old environment goes");
        }
        let system = if cfg!(windows) { "python" } else { "python3" };
        run(Command::new(system).args(["-m", "venv"]).arg(&folder));
        // Everything is pinned, and what FMPy wants for its graphical and web tools is left out: no dependencies.
        let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps", "--requirement"];
        run(Command::new(&python).args(pip).arg(&requirements));
        std::fs::write(&stamp, &wanted).expect("a stamp");
    });
    python
}

/// Whether the interpreter is still there: it is a link to the system's.
fn works(python: &Path) -> bool {
    Command::new(python).arg("--version").output().is_ok_and(|output| output.status.success())
}

#[track_caller]
fn run(command: &mut Command) {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(output.status.success(), "{command:?}\n{}{}", text(&output.stdout), text(&output.stderr));
}
