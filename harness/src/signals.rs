//! Inputs of a run, read from a CSV file with a time column.

use std::path::{Path, PathBuf};

use crate::error::{Error, Result};

/// Columns of values over time, all finite, at times that never decrease.
#[derive(Debug, Clone, PartialEq)]
pub struct InputSignals {
    /// Where they were read from, for messages.
    pub path: PathBuf,
    /// The columns' names: `instance.variable`, or `variable` when the system is a single FMU.
    pub names: Vec<String>,
    /// The times (s).
    pub times: Vec<f64>,
    /// For each column its values, one for each time.
    pub columns: Vec<Vec<f64>>,
}

impl InputSignals {
    /// Reads a CSV file whose first column is `time` (s) and whose header names the variables.
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let text = std::fs::read(path).map_err(|source| Error::io("read", path, source))?;
        Self::read(path, &text)
    }

    /// Reads CSV; `path` names it in errors. All errors of the file are returned at once.
    pub fn read(path: impl Into<PathBuf>, text: &[u8]) -> Result<Self> {
        let path = path.into();
        let mut errors = Vec::new();
        let mut error = |line: u64, reason: String| errors.push(Error::Signals { path: path.clone(), line, reason });

        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).flexible(true).from_reader(text);
        let header = match reader.headers() {
            Ok(header) => header.clone(),
            Err(problem) => return Err(Error::Signals { path, line: 1, reason: problem.to_string() }),
        };
        let mut names: Vec<String> = header.iter().map(|name| name.trim_matches('\u{feff}').to_owned()).collect();
        if names.first().is_none_or(|name| !name.eq_ignore_ascii_case("time")) {
            error(1, format!("the first column must be `time`, not `{}`", names.first().map_or("", String::as_str)));
        }
        for (index, name) in names.iter().enumerate() {
            if name.is_empty() {
                error(1, format!("column {} has no name", index + 1));
            } else if names[..index].contains(name) {
                error(1, format!("the column `{name}` occurs twice"));
            }
        }

        let mut times: Vec<f64> = Vec::new();
        let mut columns: Vec<Vec<f64>> = vec![Vec::new(); names.len().saturating_sub(1)];
        for record in reader.records() {
            let record = match record {
                Ok(record) => record,
                Err(problem) => {
                    error(line_of(text, problem.position()), problem.to_string());
                    continue;
                }
            };
            let line = || line_of(text, record.position());
            if record.len() != names.len() {
                error(line(), format!("{} fields where the header has {}", record.len(), names.len()));
                continue;
            }
            let mut numbers = Vec::with_capacity(names.len());
            for (field, name) in record.iter().zip(&names) {
                match number(field) {
                    Some(value) => numbers.push(value),
                    None => error(line(), format!("`{name}`: `{field}` is not a finite number, true or false")),
                }
            }
            if numbers.len() < names.len() {
                continue;
            }
            if let (Some(&last), Some(&time)) = (times.last(), numbers.first())
                && time < last
            {
                error(line(), format!("the time {time} lies before {last}"));
                continue;
            }
            times.push(numbers[0]);
            for (column, &value) in columns.iter_mut().zip(&numbers[1..]) {
                column.push(value);
            }
        }
        if times.is_empty() && errors.is_empty() {
            errors.push(Error::Signals { path: path.clone(), line: 1, reason: "there are no values".to_owned() });
        }
        Error::all(errors)?;
        names.remove(0);
        Ok(Self { path, names, times, columns })
    }
}

/// The line, from 1, that a record begins in. The reader itself counts from the end of the record before, so that empty
/// lines in between would belong to the next record.
fn line_of(text: &[u8], position: Option<&csv::Position>) -> u64 {
    let byte = position.and_then(|position| usize::try_from(position.byte()).ok()).unwrap_or(0).min(text.len());
    let empty = text[byte..].iter().take_while(|&&byte| byte == b'\n' || byte == b'\r').count();
    1 + text[..byte + empty].iter().filter(|&&byte| byte == b'\n').count() as u64
}

fn number(field: &str) -> Option<f64> {
    match field {
        "true" => Some(1.0),
        "false" => Some(0.0),
        _ => field.parse().ok().filter(|value: &f64| value.is_finite()),
    }
}

/// A place in the rows that moves forward with time, so that finding the row costs nothing in the long run.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Cursor {
    /// The last row whose time is not after the present, or the first.
    row: usize,
    /// How far the present is on the way to the next row, from 0 to 1.
    fraction: f64,
}

impl Cursor {
    /// Moves to a time (s) that is not before the last one. Of several rows with one time the last holds.
    pub(crate) fn advance(&mut self, times: &[f64], time: f64) {
        while times.get(self.row + 1).is_some_and(|&next| next <= time) {
            self.row += 1;
        }
        self.fraction = match (times.get(self.row), times.get(self.row + 1)) {
            (Some(&here), Some(&next)) if time > here => (time - here) / (next - here),
            _ => 0.0,
        };
    }

    /// The value of a continuous variable: interpolated, and constant before the first and after the last row.
    pub(crate) fn interpolate(&self, column: &[f64]) -> f64 {
        let here = column[self.row];
        if self.fraction == 0.0 { here } else { here + self.fraction * (column[self.row + 1] - here) }
    }

    /// The value of a discrete variable: held until the next row.
    pub(crate) fn hold(&self, column: &[f64]) -> f64 {
        column[self.row]
    }
}

#[cfg(test)]
mod tests;
