//! What the user is told: results on stdout, messages and progress on stderr.

use std::error::Error;
use std::fmt::Display;
use std::io::{ErrorKind, Write};

use comfy_table::presets::NOTHING;
use comfy_table::{CellAlignment, ContentArrangement, Row, Table};
use indicatif::{ProgressBar, ProgressStyle};
use swayless::Observer;

use super::Failure;

/// How long lines of text get.
const WIDTH: usize = 100;

/// Prints a result.
pub fn print(text: impl Display) -> Result<(), Failure> {
    Ok(writeln!(std::io::stdout().lock(), "{text}")?)
}

/// Prints an error with its causes as one message. A cause that its error already tells is not told again.
pub fn error(error: &dyn Error) {
    let mut message = error.to_string();
    let mut cause = error.source();
    while let Some(error) = cause {
        let text = error.to_string();
        if !message.contains(&text) {
            message = format!("{message}: {text}");
        }
        cause = error.source();
    }
    note(format_args!("error: {message}"));
}

/// Prints a line of news, if anybody listens: `eprintln` panics when nobody does.
pub fn note(text: impl Display) {
    let _ = writeln!(std::io::stderr().lock(), "{text}");
}

/// Prints a warning.
pub fn warn(text: impl Display) {
    note(format_args!("warning: {text}"));
}

/// Whether all that happened is that nobody reads stdout any more.
pub fn is_closed_pipe(error: &(dyn Error + 'static)) -> bool {
    let is_closed = |e: &std::io::Error| e.kind() == ErrorKind::BrokenPipe;
    let here = match error.downcast_ref::<std::io::Error>() {
        // The CSV writer wraps what the system said, twice.
        Some(io) => is_closed(io) || io.get_ref().is_some_and(|inner| is_closed_pipe(inner)),
        None => {
            let csv = error.downcast_ref::<csv::Error>();
            csv.is_some_and(|e| matches!(e.kind(), csv::ErrorKind::Io(io) if is_closed(io)))
        }
    };
    here || error.source().is_some_and(is_closed_pipe)
}

/// A table with a header; the columns named in `numbers` are aligned to the right.
pub fn table(header: impl Into<Row>, numbers: impl IntoIterator<Item = usize>) -> Table {
    let mut table = Table::new();
    table.load_style(NOTHING).set_content_arrangement(ContentArrangement::Dynamic).set_header(header);
    for index in numbers {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

/// Text in lines that are not too long to read.
pub fn paragraph(text: &str) -> String {
    // A number keeps its percent sign.
    textwrap::fill(&text.replace(" %", "\u{a0}%"), WIDTH).replace('\u{a0}', " ")
}

/// A number as people read it: five significant digits, without a tail of zeros.
pub fn number(value: f64) -> String {
    significant(value, 5)
}

/// A number with so many significant digits, without a tail of zeros.
pub fn significant(value: f64, digits: u8) -> String {
    let further = f64::from(digits) - 1.0;
    let magnitude = value.abs();
    if value == 0.0 || !value.is_finite() {
        format!("{value}")
    } else if (1e-3..1e6).contains(&magnitude) {
        let decimals = (further - magnitude.log10().floor()).clamp(0.0, further + 3.0) as usize;
        let text = format!("{value:.decimals$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{value:.*e}", further as usize)
    }
}

/// A bar that shows how far a run is, where there is a terminal to show it on.
pub struct Progress(ProgressBar);

impl Progress {
    /// How finely progress is told.
    const PARTS: f64 = 1000.0;

    /// A bar with the run's name.
    pub fn new(name: impl Into<String>) -> Self {
        let bar = ProgressBar::new(Self::PARTS as u64).with_message(name.into());
        // The template is ours and right; a bar of another look would do no harm.
        if let Ok(style) = ProgressStyle::with_template("{msg:28} {bar:32} {percent:>3} % {eta}") {
            bar.set_style(style);
        }
        Self(bar)
    }
}

impl Observer for Progress {
    fn records(&self) -> bool {
        false
    }

    fn progress(&mut self, fraction: f64) {
        self.0.set_position((fraction * Self::PARTS) as u64);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let texts = [0.0, 1.0, -0.25, 123.456789, 0.001234567, 1e-9, 12345678.0].map(number);
        assert_eq!(texts, ["0", "1", "-0.25", "123.46", "0.0012346", "1.0000e-9", "1.2346e7"]);
    }

    #[test]
    fn a_closed_pipe_is_found_among_causes() {
        let error = swayless::Error::Io { action: "write", path: "-".into(), source: ErrorKind::BrokenPipe.into() };
        assert!(is_closed_pipe(&error));
        assert!(!is_closed_pipe(&std::io::Error::from(ErrorKind::NotFound)));
    }
}
