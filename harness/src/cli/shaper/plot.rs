//! Sensitivity curves and shaped steps.

use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;

use swayless::Error;
use swayless::report::{Curve, Dash, Figure, Panel, Report, Style, Table, html, svg};
use swayless::shapers::{Candidate, Figures, Recommendation, UncertainMode};
use swayless_shaping::{Kind, Mode};

use super::request::{Given, Question};
use super::{parameters, table, words};
use crate::cli::Failure;

/// How curves are drawn.
#[derive(Debug, Clone, Copy)]
pub enum Format {
    Picture,
    Page,
}

impl Format {
    /// By the file's name.
    pub fn of(path: &Path) -> Result<Self, Error> {
        match path.extension().and_then(|extension| extension.to_str()).map(str::to_lowercase).as_deref() {
            Some("svg") => Ok(Self::Picture),
            Some("html") => Ok(Self::Page),
            _ => {
                let text = format!(
                    "`--plot {}`: the name must end in .svg, for a picture, or .html, for a page",
                    path.display()
                );
                Err(Error::Option(text))
            }
        }
    }
}

/// Points of a sensitivity curve.
const POINTS: usize = 900;

/// The page, or the picture of the sensitivity curves.
pub fn draw(
    format: Format,
    question: &Question,
    candidates: &[Candidate],
    found: Option<Recommendation>,
) -> Result<String, Failure> {
    let curves = sensitivity(question, candidates, found);
    Ok(match format {
        Format::Picture => svg::picture(&curves, 960, 480)?,
        Format::Page => {
            let chosen = found.map(|found| {
                [words::recommendation(question, candidates, found), parameters::line(&candidates[found.choice])]
            });
            let refused = Table {
                title: words::REFUSED.to_owned(),
                notes: candidates.iter().filter_map(words::refusal).collect(),
                ..Table::default()
            };
            html::page(&Report {
                title: "Input shapers compared".to_owned(),
                introduction: table::heading(question).into_iter().chain(chosen.into_iter().flatten()).collect(),
                tables: [(found.is_some(), table::report(question, candidates)), (!refused.notes.is_empty(), refused)]
                    .into_iter()
                    .filter_map(|(is_shown, table)| is_shown.then_some(table))
                    .collect(),
                figures: vec![curves, steps(question, candidates, found)],
            })
        }
    })
}

/// A shaper whose curve is drawn.
struct Drawn<'a> {
    candidate: &'a Candidate,
    figures: &'a Figures,
    style: Style,
    hidden: bool,
}

/// The shapers that are drawn; where all kinds are compared, most are hidden at first.
fn drawn<'a>(question: &Question, candidates: &'a [Candidate], found: Option<Recommendation>) -> Vec<Drawn<'a>> {
    let named = found.map(|found| [Some(found.choice), found.runner_up, found.quicker, found.quickest]);
    let is_shown = |place: usize, kind: Kind| {
        candidates.len() <= FEW || BASIC.contains(&kind) || named.is_some_and(|named| named.contains(&Some(place)))
    };
    // Behind a drive, the bare command leaves less than all.
    let bare = question.request.drive.is_some();
    let shaping = candidates.iter().enumerate().filter(|(_, one)| bare || one.kind != Kind::None);
    let mut drawn: Vec<Drawn> = shaping
        .filter_map(|(place, candidate)| {
            let hidden = !is_shown(place, candidate.kind);
            Some(Drawn { candidate, figures: candidate.figures()?, style: Style::at(0), hidden })
        })
        .collect();
    // Those that are seen differ most; the first style is the limit's.
    drawn.sort_by_key(|one| one.hidden);
    (1..).zip(&mut drawn).for_each(|(place, one)| one.style = Style::at(place));
    drawn
}

/// As many curves as can be told apart.
const FEW: usize = 6;

/// What everybody knows, to compare with.
const BASIC: [Kind; 3] = [Kind::None, Kind::ZV, Kind::ZVD];

fn sensitivity(question: &Question, candidates: &[Candidate], found: Option<Recommendation>) -> Figure {
    let request = &question.request;
    let (factor, horizontal) = match question.given {
        Given::Hertz => (1.0 / TAU, "frequency (Hz)"),
        Given::Length { .. } | Given::Frequency => (1.0, "frequency (rad/s)"),
    };
    // A panel for each damping ratio.
    let mut ratios: Vec<f64> = request.modes.iter().map(|mode| mode.mode.damping_ratio()).collect();
    ratios.dedup();
    let end =
        request.modes.iter().map(|mode| (1.7 * mode.mode.frequency()).max(1.2 * mode.range.end())).fold(0.0, f64::max);
    let panel = |ratio: &f64| {
        let frequencies: Arc<[f64]> =
            (0..POINTS).map(|point| factor * end * point as f64 / (POINTS - 1) as f64).collect();
        let curve = |Drawn { candidate, figures, style, hidden }: Drawn| Curve {
            name: candidate.name(),
            places: frequencies.clone(),
            values: frequencies
                .iter()
                .map(|frequency| {
                    Mode::new(frequency / factor, *ratio).map_or(1.0, |mode| request.vibration(&figures.design, mode))
                })
                .map(|vibration| 100.0 * vibration)
                .collect(),
            style,
            held: false,
            hidden,
        };
        let limit = Curve {
            name: "vibration limit".to_owned(),
            places: [0.0, factor * end].as_slice().into(),
            values: vec![100.0 * request.vibration_limit; 2],
            style: Style { color: 0, width: 1.2, dash: Dash::Dotted },
            held: false,
            hidden: false,
        };
        let label = if ratios.len() > 1 {
            format!("V (%) at damping ratio {ratio}")
        } else {
            "residual vibration V (%)".to_owned()
        };
        Panel {
            label,
            height: 2,
            curves: drawn(question, candidates, found).into_iter().map(curve).chain([limit]).collect(),
        }
    };
    let span = |(place, UncertainMode { range, .. }): (usize, &UncertainMode)| {
        let words = if request.modes.len() > 1 { format!("range of mode {}", place + 1) } else { "range".to_owned() };
        (factor * range.start(), factor * range.end(), words)
    };
    Figure {
        title: "Sensitivity".to_owned(),
        caption: "What is left of a vibration, as a share of what the unshaped command leaves, over the mode’s true frequency."
            .to_owned(),
        horizontal: horizontal.to_owned(),
        panels: ratios.iter().map(panel).collect(),
        spans: request.modes.iter().enumerate().map(span).collect(),
    }
}

fn steps(question: &Question, candidates: &[Candidate], found: Option<Recommendation>) -> Figure {
    let longest = candidates.iter().filter_map(|one| Some(one.figures()?.design.duration())).fold(0.0, f64::max);
    let curve = |Drawn { candidate, figures, style, hidden }: Drawn| {
        let mut sum = 0.0;
        let mut points = vec![(-0.05 * longest, 0.0)];
        for impulse in figures.design.shaper().impulses() {
            sum += impulse.amplitude;
            points.push((impulse.time, sum));
        }
        points.push((1.05 * longest, sum));
        let (places, values): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
        Curve { name: candidate.name(), places: places.into(), values, style, held: true, hidden }
    };
    let panel = Panel {
        label: "command".to_owned(),
        height: 2,
        curves: drawn(question, candidates, found).into_iter().map(curve).collect(),
    };
    Figure {
        title: "Shaped steps".to_owned(),
        caption: "What the shapers make of a unit step at time 0.".to_owned(),
        panels: vec![panel],
        ..Figure::default()
    }
}
