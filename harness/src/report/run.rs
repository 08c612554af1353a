//! The report of any single run: for each instance a figure, for each unit a panel.

use std::sync::Arc;

use super::{Curve, Dash, Figure, Panel, Report, Shown, Style, Table, html};
use crate::{Recording, Summary};

/// The report of a run of a system.
pub fn report(system: &str, recording: &Recording, summary: &Summary) -> Report {
    let times: Arc<[f64]> = recording.times.as_slice().into();
    let mut figures: Vec<Figure> = Vec::new();
    for (index, name) in recording.names.iter().enumerate() {
        let (instance, variable) = name.split_once('.').unwrap_or((system, name));
        let shown = Shown::of(recording.units[index].as_deref());
        let label = if shown.unit.is_empty() { "no unit".to_owned() } else { shown.unit.clone() };
        // A plot has room for a few panels only; what is left begins another of the same title.
        let fits = |f: &&mut Figure| {
            f.title == instance && (f.panels.len() < html::PANELS || f.panels.iter().any(|p| p.label == label))
        };
        let figure = match figures.iter().position(|f| fits(&&mut f.clone())) {
            Some(place) => &mut figures[place],
            None => {
                figures.push(Figure { title: instance.to_owned(), ..Figure::default() });
                let last = figures.len() - 1;
                &mut figures[last]
            }
        };
        let place = figure.panels.iter().position(|p| p.label == label).unwrap_or_else(|| {
            figure.panels.push(Panel { label, height: 1, curves: Vec::new() });
            figure.panels.len() - 1
        });
        let curves = &mut figure.panels[place].curves;
        let style = Style { color: curves.len() + 1, width: 1.6, dash: Dash::Solid };
        curves.push(Curve {
            name: variable.to_owned(),
            times: times.clone(),
            values: shown.values(&recording.columns[index]),
            style,
            held: false,
            hidden: false,
        });
    }
    Report { title: system.to_owned(), introduction: Vec::new(), tables: vec![table(summary)], figures }
}

fn table(summary: &Summary) -> Table {
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let mut rows = vec![
        row("Simulated", format!("{} s to {} s", summary.start_time, summary.stop_time)),
        row("Steps", format!("{} of {} s", summary.steps, summary.step_size)),
        row("Real-time factor", format!("{:.0}", summary.real_time_factor())),
    ];
    if let Some(instance) = &summary.terminated_by {
        rows.push(row("Ended early by", instance.clone()));
    }
    Table { title: "The run".to_owned(), rows, ..Table::default() }
}
