//! What the user is told on stderr, and tables on stdout.

use std::error::Error;

use comfy_table::presets::NOTHING;
use comfy_table::{CellAlignment, ContentArrangement, Table};

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
    eprintln!("error: {message}");
}

/// Prints a line of news.
pub fn note(text: impl std::fmt::Display) {
    eprintln!("{text}");
}

/// Prints a warning.
pub fn warn(text: impl std::fmt::Display) {
    eprintln!("warning: {text}");
}

/// A table with a header; the columns named in `numbers` are aligned to the right.
pub fn table<const N: usize>(header: [&str; N], numbers: impl IntoIterator<Item = usize>) -> Table {
    let mut table = Table::new();
    table.load_style(NOTHING).set_content_arrangement(ContentArrangement::Dynamic).set_header(header);
    for index in numbers {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}
