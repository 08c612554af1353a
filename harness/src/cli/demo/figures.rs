//! What the shapers are worth, in curves.

use std::sync::Arc;

use swayless::report::{Curve, Dash, Figure, Panel, Shown, Style};

use super::results::{Results, column};
use super::{AXES, KINDS, Run};

/// The shaper whose curves are shown at first where those of all would hide each other.
const EXAMPLE: &str = "ZVD";

/// The figures of the page.
pub fn figures(runs: &[Run], results: &Results) -> Vec<Figure> {
    vec![swing(runs, results), axes(runs), crane(runs, results)]
}

/// The figure that stands for all of them: the swing, and what the operator did.
pub fn picture(runs: &[Run], results: &Results) -> Figure {
    let mut panels = vec![panel(runs, "swing.amplitude", "rad", "swing", 5, |_| true)];
    for axis in &AXES {
        let shown = Shown::of(Some(axis.unit));
        let command = runs.first().map(|run| Curve {
            name: "operator’s command".to_owned(),
            held: true,
            style: Style { color: 6, width: 1.4, dash: Dash::Solid },
            ..curve(run, &format!("{}_command.command", axis.name), &shown)
        });
        panels.push(Panel { label: shown.label(axis.name), height: 1, curves: command.into_iter().collect() });
    }
    Figure {
        panels,
        spans: rest(runs, results),
        title: "Swing of the payload, by shaper".to_owned(),
        ..Figure::default()
    }
}

fn swing(runs: &[Run], results: &Results) -> Figure {
    Figure {
        title: "Swing".to_owned(),
        caption: "The amplitude is what the payload would swing with if the boom tip went on as it does at that moment, \
                  so once the drives rest it is the residual swing. Radial swing is positive away from the slewing axis, \
                  tangential swing towards increasing slew."
            .to_owned(),
        panels: vec![
            panel(runs, "swing.amplitude", "rad", "amplitude", 2, |_| true),
            panel(runs, "swing.radial", "rad", "radial", 1, |_| true),
            panel(runs, "swing.tangential", "rad", "tangential", 1, |_| true),
        ],
        spans: rest(runs, results),
        ..Figure::default()
    }
}

fn axes(runs: &[Run]) -> Figure {
    let mut panels = Vec::new();
    for axis in &AXES {
        let shown = Shown::of(Some(axis.unit));
        let variable = |part: &str| format!("{}_{part}", axis.name);
        let mut curves: Vec<Curve> = Vec::new();
        if let Some(run) = runs.first() {
            curves.push(Curve {
                name: "command".to_owned(),
                held: true,
                style: Style { color: 0, width: 1.4, dash: Dash::Dotted },
                ..curve(run, &variable("command.command"), &shown)
            });
        }
        for run in runs {
            let hidden = run.kind != EXAMPLE;
            let drive = curve(run, &variable("drive.velocity"), &shown);
            // Unshaped, the shaped command is the command.
            if run.kind != KINDS[0] {
                let style = Style { width: 1.0, dash: Dash::Dashed, ..drive.style };
                let shaped = curve(run, &variable("shaper.shaped"), &shown);
                curves.push(Curve { name: format!("{}: shaped", shaped.name), held: true, hidden, style, ..shaped });
            }
            curves.push(Curve { name: format!("{}: drive", drive.name), hidden, ..drive });
        }
        panels.push(Panel { label: shown.label(axis.name), height: 1, curves });
    }
    Figure {
        title: "From the lever to the motor".to_owned(),
        caption: "The operator’s command, what the shaper makes of it, and how fast the drive then moves the axis."
            .to_owned(),
        panels,
        ..Figure::default()
    }
}

fn crane(runs: &[Run], results: &Results) -> Figure {
    let few = |kind: &str| kind == KINDS[0] || kind == EXAMPLE;
    Figure {
        title: "The crane".to_owned(),
        caption: "Where the joints are.".to_owned(),
        panels: vec![
            panel(runs, "slew.angle", "rad", "slew", 1, few),
            panel(runs, "luff.angle", "rad", "luff", 1, few),
            panel(runs, "hoist.length", "m", "suspension length", 1, few),
            panel(runs, "base.x", "m", "base", 1, few),
        ],
        spans: rest(runs, results),
        ..Figure::default()
    }
}

/// One variable of the crane in all runs; those whose kind is not `shown` wait to be asked for.
fn panel(runs: &[Run], variable: &str, unit: &str, label: &str, height: u32, shown: impl Fn(&str) -> bool) -> Panel {
    let display = Shown::of(Some(unit));
    let curve = |run: &Run| Curve { hidden: !shown(run.kind), ..curve(run, &format!("crane.{variable}"), &display) };
    Panel { label: display.label(label), height, curves: runs.iter().map(curve).collect() }
}

/// A variable of a run, in the run's colour and under its name.
fn curve(run: &Run, variable: &str, shown: &Shown) -> Curve {
    let place = KINDS.iter().position(|k| *k == run.kind).unwrap_or_default();
    let dash = match run.kind {
        "ZVDD" | "EI" => Dash::Dashed,
        "UMZV" => Dash::Dotted,
        _ => Dash::Solid,
    };
    let width = if place == 0 { 1.4 } else { 1.9 };
    Curve {
        name: if place == 0 { "no shaper".to_owned() } else { run.kind.to_owned() },
        places: Arc::from(run.recording.times.as_slice()),
        values: shown.values(column(&run.recording, variable)),
        style: Style { color: place, width, dash },
        held: false,
        hidden: false,
    }
}

/// The time after the last drive of the last run has stopped.
fn rest(runs: &[Run], results: &Results) -> Vec<(f64, f64, String)> {
    let end = runs.first().and_then(|run| run.recording.times.last().copied());
    let rest = end.filter(|end| results.rest_from < *end);
    rest.map(|end| (results.rest_from, end, "all drives at rest".to_owned())).into_iter().collect()
}
