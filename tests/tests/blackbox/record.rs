//! A run of an example by the command, and what it records.

use std::collections::BTreeMap;

use crate::packaged::{self, VERSIONS, repository};

/// The columns of a run's record by their names; truth values are 0 and 1.
pub type Record = BTreeMap<String, Vec<f64>>;

/// Runs an example by the command, with steps of this size (s), and with the FMUs of both versions, which must give the
/// same.
pub fn run(example: &str, step_size: &str, more: &[&str]) -> Record {
    let [old, new] = VERSIONS.map(|version| {
        let output = packaged::command()
            .arg("run")
            .arg(repository().join("examples").join(example).join("SystemStructure.ssd"))
            .arg("--fmu-dir")
            .arg(packaged::all().folder(version))
            .args(["--step-size", step_size, "--output-file", "-"])
            .args(more)
            .output()
            .expect("the command");
        assert!(output.status.success(), "{example}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("text")
    });
    assert!(old == new, "{example}: the versions differ");
    let mut lines = new.lines();
    let names = lines.next().expect("a header").split(',');
    let mut columns: Vec<_> = names.map(|name| (name.to_owned(), Vec::new())).collect();
    for line in lines {
        for (column, text) in columns.iter_mut().zip(line.split(',')) {
            column.1.push(text.parse().unwrap_or_else(|_| f64::from(u8::from(text == "true"))));
        }
    }
    columns.into_iter().collect()
}

/// The last value of a column.
pub fn last(record: &Record, name: &str) -> f64 {
    *record[name].last().expect("a row")
}
