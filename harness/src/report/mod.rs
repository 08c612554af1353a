//! Reports: one HTML file with interactive curves that needs nothing else, and pictures in SVG.
//!
//! A [`Report`] is plain data, so that what is shown is decided in one place and how it is drawn in another: [`html`]
//! makes the page, [`svg`] a picture of one figure, [`run`] the report of any single run.

pub mod html;
pub mod palette;
pub mod run;
pub mod svg;
mod thin;
mod units;

use std::sync::Arc;

pub use units::Shown;

/// What a page shows, from top to bottom.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Report {
    /// The heading.
    pub title: String,
    /// What this is, one paragraph each.
    pub introduction: Vec<String>,
    /// Results in numbers.
    pub tables: Vec<Table>,
    /// Results in curves.
    pub figures: Vec<Figure>,
}

/// A table of results.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// What it is about.
    pub title: String,
    /// The columns' headings.
    pub header: Vec<String>,
    /// The rows; the first cell of each names the row.
    pub rows: Vec<Vec<String>>,
    /// What to know when reading it.
    pub notes: Vec<String>,
}

/// Panels above each other that share the horizontal axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// What it is about.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// The horizontal axis's label, with its unit.
    pub horizontal: String,
    /// The panels, from top to bottom.
    pub panels: Vec<Panel>,
    /// Spans of the horizontal axis that are shaded, each from, to, and the words that say why.
    pub spans: Vec<(f64, f64, String)>,
}

/// Of nothing, over time.
impl Default for Figure {
    fn default() -> Self {
        let horizontal = "time (s)".to_owned();
        Self { title: String::new(), caption: String::new(), horizontal, panels: Vec::new(), spans: Vec::new() }
    }
}

/// Curves with one vertical axis.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Panel {
    /// The axis's label, with its unit.
    pub label: String,
    /// Its height compared with other panels.
    pub height: u32,
    /// The curves, in the order in which they are drawn.
    pub curves: Vec<Curve>,
}

/// One curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its name. Curves of one name are shown and hidden together, across the panels of a figure.
    pub name: String,
    /// Where on the horizontal axis its values stand, which several curves share.
    pub places: Arc<[f64]>,
    /// The values, one for each place.
    pub values: Vec<f64>,
    /// How it is drawn.
    pub style: Style,
    /// Whether each value holds until the next one rather than being joined to it.
    pub held: bool,
    /// Whether it is hidden until the reader asks for it.
    pub hidden: bool,
}

/// How a curve is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Style {
    /// Its place in the [`palette`].
    pub color: usize,
    /// Its width, in pixels.
    pub width: f64,
    /// Its dashes, which tell it apart without colour.
    pub dash: Dash,
}

/// The dashes of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dash {
    /// None.
    #[default]
    Solid,
    /// Long ones.
    Dashed,
    /// Short ones.
    Dotted,
}

impl Style {
    /// For the curve at this place of a figure: curves differ in colour, and in dashes once the colours are used up.
    pub fn at(place: usize) -> Self {
        let dash = match place / palette::COLORS {
            0 => Dash::Solid,
            1 => Dash::Dashed,
            _ => Dash::Dotted,
        };
        Self { color: place, width: 1.7, dash }
    }
}

impl Curve {
    /// What is drawn of it, with about this many points at most.
    fn points(&self, limit: usize) -> (Vec<f64>, Vec<f64>) {
        if self.held {
            thin::changes(&self.places, &self.values)
        } else {
            thin::thin(&self.places, &self.values, limit)
        }
    }
}
