//! Wrong things fail well: through the `swayless` command and real FMUs, with exit codes and messages.

mod archives;
mod systems;
mod values;

use std::path::Path;

use tempfile::TempDir;

use crate::packaged;

const FAILED: i32 = 1;
const WRONG_USAGE: i32 = 2;
const FOUND_PROBLEMS: i32 = 3;

/// Runs the command and returns what it says on stdout and stderr.
#[track_caller]
fn swayless(arguments: &[&str], code: i32) -> (String, String) {
    let output = packaged::command().args(arguments).output().expect("the command starts");
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_owned()).expect("text");
    let (stdout, stderr) = (text(&output.stdout), text(&output.stderr));
    assert_eq!(output.status.code(), Some(code), "swayless {arguments:?}\n{stdout}\n{stderr}");
    assert!(!stderr.contains("panicked"), "{stderr}");
    (stdout, stderr)
}

/// Runs the command, which must fail and say all of this on stderr, and nothing on stdout.
#[track_caller]
fn fails(arguments: &[&str], code: i32, wanted: &[&str]) {
    let (stdout, stderr) = swayless(arguments, code);
    assert_eq!(stdout, "", "{stderr}");
    assert!(stderr.starts_with("error: "), "{stderr}");
    for part in wanted {
        assert!(stderr.contains(part), "`{part}` is missing in: {stderr}");
    }
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}
