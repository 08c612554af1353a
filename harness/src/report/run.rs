//! The report of any single run: for each instance a figure, for variables of one group and unit a panel.

use std::sync::Arc;

use super::{Curve, Figure, Panel, Report, Shown, Style, Table, html};
use crate::{Recording, Summary};

/// The report of a run of a system.
pub fn report(system: &str, recording: &Recording, summary: &Summary) -> Report {
    let times: Arc<[f64]> = recording.times.as_slice().into();
    let mut figures: Vec<Figure> = Vec::new();
    for ((name, unit), values) in recording.names.iter().zip(&recording.units).zip(&recording.columns) {
        let (instance, variable) = name.split_once('.').unwrap_or((system, name));
        let group = variable.rsplit_once('.').map_or(variable, |(group, _)| group);
        let shown = Shown::of(unit.as_deref());
        let figure = figure(&mut figures, instance, &shown.label(group));
        let style = Style::at(figure.panels.iter().map(|p| p.curves.len()).sum());
        let panel = panel(figure, shown.label(group));
        panel.curves.push(Curve {
            name: variable.to_owned(),
            places: times.clone(),
            values: shown.values(values),
            style,
            held: false,
            hidden: false,
        });
    }
    Report { title: system.to_owned(), introduction: Vec::new(), tables: vec![table(summary)], figures }
}

/// The figure of an instance that has this panel, or has room for it; a new one if there is none.
fn figure<'a>(figures: &'a mut Vec<Figure>, instance: &str, label: &str) -> &'a mut Figure {
    let of_instance =
        |f: &Figure| f.title.strip_prefix(instance).is_some_and(|rest| rest.is_empty() || rest == CONTINUED);
    let fits = |f: &Figure| f.panels.len() < html::PANELS || f.panels.iter().any(|p| p.label == label);
    let place = figures.iter().position(|f| of_instance(f) && fits(f)).unwrap_or_else(|| {
        let again = figures.iter().any(of_instance);
        let title = if again { format!("{instance}{CONTINUED}") } else { instance.to_owned() };
        figures.push(Figure { title, ..Figure::default() });
        figures.len() - 1
    });
    &mut figures[place]
}

/// What the title of an instance's further figures ends in.
const CONTINUED: &str = " (continued)";

fn panel(figure: &mut Figure, label: String) -> &mut Panel {
    let place = figure.panels.iter().position(|p| p.label == label).unwrap_or_else(|| {
        figure.panels.push(Panel { label, height: 1, curves: Vec::new() });
        figure.panels.len() - 1
    });
    &mut figure.panels[place]
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
