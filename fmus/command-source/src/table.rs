//! Reading a column of a CSV file.

use std::path::{Path, PathBuf};

use csv::{ReaderBuilder, Trim};
use swayless_export::{Environment, Problem};

use crate::variables::Parameters;

/// The rows (time, value) of the file and column that the parameters name.
pub fn read(p: &Parameters<f64>, environment: &Environment<'_>) -> Result<Vec<(f64, f64)>, Problem> {
    let path = find(&p.file, environment)?;
    let wrong = |message: String| Problem::new("file", format!("{}: {message}", path.display()));
    let mut reader = ReaderBuilder::new()
        .trim(Trim::All)
        .comment(Some(b'#'))
        .from_path(&path)
        .map_err(|error| wrong(error.to_string()))?;
    let headers = reader.headers().map_err(|error| wrong(error.to_string()))?.clone();
    let names: Vec<&str> = headers.iter().collect();
    let listed = names.join(", ");
    let time = names
        .iter()
        .position(|name| name.eq_ignore_ascii_case("time"))
        .ok_or_else(|| wrong(format!("there is no column `time`; the columns are {listed}")))?;
    let value = if p.column.is_empty() {
        (0..names.len()).find(|index| *index != time)
    } else {
        names.iter().position(|name| *name == p.column)
    }
    .ok_or_else(|| {
        Problem::new("column", format!("is `{}`, but {} has the columns {listed}", p.column, path.display()))
    })?;

    let mut rows: Vec<(f64, f64)> = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| wrong(error.to_string()))?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |column: usize| -> Result<f64, Problem> {
            let text = record.get(column).unwrap_or_default();
            let parsed = text.parse::<f64>().ok().filter(|number| number.is_finite());
            parsed
                .ok_or_else(|| wrong(format!("line {line}, column {}: `{text}` is not a finite number", names[column])))
        };
        let row = (number(time)?, number(value)?);
        if rows.last().is_some_and(|(before, _)| row.0 < *before) {
            return Err(wrong(format!("line {line}: time {} s goes back", row.0)));
        }
        rows.push(row);
    }
    if rows.is_empty() {
        return Err(wrong("there are no rows below the header".to_string()));
    }
    Ok(rows)
}

/// The file where it is: as named, if absolute; else in the resources; else from the working directory.
fn find(name: &str, environment: &Environment<'_>) -> Result<PathBuf, Problem> {
    let name = Path::new(name);
    let candidates = [environment.resources.map(|resources| resources.join(name)), Some(name.to_path_buf())];
    let tried: Vec<PathBuf> = candidates.into_iter().flatten().collect();
    if let Some(found) = tried.iter().find(|path| path.is_file()) {
        return Ok(found.clone());
    }
    let mut places: Vec<String> = tried.iter().map(|path| path.display().to_string()).collect();
    places.dedup();
    Err(Problem::new("file", format!("is {}, and there is no file at {}", name.display(), places.join(" or "))))
}
