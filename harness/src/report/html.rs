//! The page. Everything it needs is in it, and its content security policy keeps the browser from loading more.

use std::fmt::Write;

use plotly::common::{Anchor, DashType, Font, Label, Line, LineShape, Mode, Orientation, Title, Visible};
use plotly::configuration::DisplayModeBar;
use plotly::layout::{
    Annotation, Axis, GroupClick, HoverMode, Layout, Legend, Margin, Shape, ShapeLayer, ShapeLine, ShapeType,
};
use plotly::{Configuration, Plot, Scatter};

use super::{Dash, Figure, Panel, Report, Table, palette};

/// How many panels a figure can have.
pub const PANELS: usize = 8;

/// How many points of a curve are drawn; more cannot be told apart on a screen.
const POINTS: usize = 2000;

/// Heights (px): of a panel, of the gap between two of them, of the horizontal axis, of the plot's buttons, of a legend's row.
const PANEL_HEIGHT: u32 = 180;
const GAP: f64 = 22.0;
const AXIS_HEIGHT: u32 = 56;
const BUTTONS_HEIGHT: u32 = 46;
const ROW_HEIGHT: u32 = 21;

/// The width of a page (px) and of the room for a name in the legend: what is left of it, and what a letter takes.
const WIDTH: usize = 1000;
const NAME_WIDTH: usize = 48;
const LETTER_WIDTH: usize = 8;

const STYLE: &str = include_str!("page.css");
const INK: &str = "#1c2733";
const GRID: &str = "#e4e9ee";
const FONT: &str = "system-ui, \"Segoe UI\", \"Helvetica Neue\", Arial, sans-serif";

/// Writes the page.
pub fn page(report: &Report) -> String {
    let mut body = format!("<h1>{}</h1>\n", escape(&report.title));
    for paragraph in &report.introduction {
        let _ = writeln!(body, "<p>{}</p>", prose(paragraph));
    }
    report.tables.iter().for_each(|table| write_table(&mut body, table));
    for (index, figure) in report.figures.iter().enumerate() {
        write_figure(&mut body, figure, index);
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; \
         style-src 'unsafe-inline'; img-src data: blob:\">\n\
         <title>{}</title>\n<style>\n{STYLE}</style>\n{}\n</head>\n<body>\n{body}</body>\n</html>\n",
        escape(&report.title),
        script(),
    )
}

/// The plotting library. The crate offers it together with one for formulas, of which we have none.
fn script() -> String {
    let both = Plot::offline_js_sources();
    let end = "</script>";
    both.find(end).map(|at| both[..at + end.len()].to_owned()).unwrap_or(both)
}

fn write_table(body: &mut String, table: &Table) {
    let row = |cells: &[String], tag: &str| -> String {
        let cells: String = cells.iter().map(|c| format!("<{tag}>{}</{tag}>", escape(c))).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let _ = writeln!(body, "<section>\n<h2>{}</h2>", escape(&table.title));
    if !table.rows.is_empty() {
        body.push_str("<div class=\"wide\"><table>\n");
        if !table.header.is_empty() {
            let _ = writeln!(body, "<thead>{}</thead>", row(&table.header, "th"));
        }
        let rows: String = table.rows.iter().map(|r| row(r, "td")).collect();
        let _ = writeln!(body, "<tbody>\n{rows}</tbody></table></div>");
    }
    for note in &table.notes {
        let _ = writeln!(body, "<p class=\"note\">{}</p>", prose(note));
    }
    body.push_str("</section>\n");
}

fn write_figure(body: &mut String, figure: &Figure, index: usize) {
    let height = panels_height(figure) + head_height(figure) + AXIS_HEIGHT;
    let _ = write!(
        body,
        "<section>\n<h2>{}</h2>\n<p>{}</p>\n<div style=\"height:{height}px\">{}</div>\n</section>\n",
        escape(&figure.title),
        escape(&figure.caption),
        plot(figure).to_inline_html(Some(&format!("figure-{index}"))),
    );
}

fn panels(figure: &Figure) -> &[Panel] {
    &figure.panels[..figure.panels.len().min(PANELS)]
}

fn panels_height(figure: &Figure) -> u32 {
    panels(figure).iter().map(|p| PANEL_HEIGHT * p.height.max(1)).sum()
}

/// The height of buttons and legend. The legend breaks into rows, for which nobody but us makes room.
fn head_height(figure: &Figure) -> u32 {
    let mut names: Vec<&str> = panels(figure).iter().flat_map(|p| &p.curves).map(|c| c.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let widest = names.iter().map(|n| n.chars().count()).max().unwrap_or_default();
    // Columns of a legend are as wide as its longest name.
    let rows = (names.len() * (NAME_WIDTH + LETTER_WIDTH * widest)).div_ceil(WIDTH).max(1);
    BUTTONS_HEIGHT + ROW_HEIGHT * u32::try_from(rows).unwrap_or(1)
}

fn plot(figure: &Figure) -> Plot {
    let panels = panels(figure);
    let inner = f64::from(panels_height(figure));
    let mut layout = Layout::new()
        .auto_size(true)
        .font(Font::new().family(FONT).size(13).color(INK))
        .paper_background_color("#ffffff")
        .plot_background_color("#ffffff")
        .hover_mode(HoverMode::X)
        .hover_label(Label::new().font(Font::new().size(12)))
        .margin(Margin::new().left(72).right(16).top(head_height(figure) as usize).bottom(AXIS_HEIGHT as usize))
        .legend(
            Legend::new()
                .orientation(Orientation::Horizontal)
                .group_click(GroupClick::ToggleGroup)
                .x(0.0)
                .x_anchor(Anchor::Left)
                .y(1.0 + 6.0 / inner)
                .y_anchor(Anchor::Bottom),
        )
        .x_axis(axis().title(title(&figure.horizontal)).anchor(axis_name(panels.len().saturating_sub(1))));
    let mut plot = Plot::new();
    let mut named: Vec<&str> = Vec::new();
    let mut top = 1.0;
    let total: u32 = panels.iter().map(|p| p.height.max(1)).sum();
    for (place, panel) in panels.iter().enumerate() {
        let share = f64::from(panel.height.max(1)) / f64::from(total);
        let bottom = top - share;
        let gap = if place + 1 < panels.len() { GAP / inner } else { 0.0 };
        let vertical = axis().title(title(&panel.label)).domain(&[(bottom + gap).max(0.0), top]);
        layout = with_axis(layout, place, vertical);
        add_curves(&mut plot, panel, place, &mut named);
        top = bottom;
    }
    for (from, to, words) in &figure.spans {
        layout.add_shape(
            Shape::new()
                .shape_type(ShapeType::Rect)
                .layer(ShapeLayer::Below)
                .x_ref("x")
                .y_ref("paper")
                .x0(*from)
                .x1(*to)
                .y0(0.0)
                .y1(1.0)
                .fill_color("#eef3f8")
                .line(ShapeLine::new().width(0.0)),
        );
        layout.add_annotation(
            Annotation::new()
                .x_ref("x")
                .y_ref("paper")
                .x(*from)
                .y(1.0)
                .x_anchor(Anchor::Left)
                .y_anchor(Anchor::Top)
                .text(words)
                .font(Font::new().size(12).color("#5b6875"))
                .show_arrow(false),
        );
    }
    plot.set_layout(layout);
    plot.set_configuration(
        Configuration::new().responsive(true).display_logo(false).display_mode_bar(DisplayModeBar::Hover),
    );
    plot
}

fn add_curves<'a>(plot: &mut Plot, panel: &'a Panel, place: usize, named: &mut Vec<&'a str>) {
    for curve in &panel.curves {
        let (places, values) = curve.points(POINTS);
        let dash = match curve.style.dash {
            Dash::Solid => DashType::Solid,
            Dash::Dashed => DashType::Dash,
            Dash::Dotted => DashType::Dot,
        };
        let first = !named.contains(&curve.name.as_str());
        if first {
            named.push(&curve.name);
        }
        let shape = if curve.held { LineShape::Hv } else { LineShape::Linear };
        let line = Line::new().color(palette::css(curve.style.color)).width(curve.style.width).dash(dash).shape(shape);
        let visible = if curve.hidden { Visible::LegendOnly } else { Visible::True };
        plot.add_trace(
            Scatter::new(places, values)
                .mode(Mode::Lines)
                .name(&curve.name)
                .legend_group(&curve.name)
                .show_legend(first)
                .visible(visible)
                .line(line)
                .y_axis(axis_name(place))
                .hover_template("%{y:.4~g}"),
        );
    }
}

fn title(text: &str) -> Title {
    Title::with_text(text).font(Font::new().size(13))
}

fn axis() -> Axis {
    Axis::new().grid_color(GRID).zero_line_color("#b9c3cd").line_color("#b9c3cd").show_line(true).auto_margin(true)
}

/// What the axis of a panel is called.
fn axis_name(place: usize) -> String {
    if place == 0 { "y".to_owned() } else { format!("y{}", place + 1) }
}

fn with_axis(layout: Layout, place: usize, axis: Axis) -> Layout {
    match place {
        0 => layout.y_axis(axis),
        1 => layout.y_axis2(axis),
        2 => layout.y_axis3(axis),
        3 => layout.y_axis4(axis),
        4 => layout.y_axis5(axis),
        5 => layout.y_axis6(axis),
        6 => layout.y_axis7(axis),
        _ => layout.y_axis8(axis),
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Words in which what stands between backticks is to be typed.
fn prose(text: &str) -> String {
    let parts = escape(text);
    let each =
        |(place, part): (usize, &str)| if place % 2 == 1 { format!("<code>{part}</code>") } else { part.to_owned() };
    parts.split('`').enumerate().map(each).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{Curve, Style};
    use super::*;

    fn report() -> Report {
        let style = Style { color: 1, width: 2.0, dash: Dash::Solid };
        let curve = Curve {
            name: "</script><b>".into(),
            places: [0.0, 1.0].as_slice().into(),
            values: vec![0.0, f64::NAN],
            style,
            held: true,
            hidden: false,
        };
        let panel = Panel { label: "swing (°)".into(), height: 1, curves: vec![curve] };
        let figure = Figure { title: "Swing".into(), panels: vec![panel; 3], ..Figure::default() };
        Report { title: "A & B".into(), figures: vec![figure], ..Report::default() }
    }

    #[test]
    fn a_page_loads_nothing_and_forbids_loading() {
        let page = page(&report());
        let own = page.replace(&script(), "");
        assert!(!own.contains("src=") && !own.contains("http://") && !own.contains("https://"), "{own}");
        assert!(own.contains("default-src 'none'"));
    }

    #[test]
    fn names_cannot_break_out() {
        let page = page(&report()).replace(&script(), "");
        assert!(page.contains("A &amp; B"));
        assert_eq!(page.matches("</script>").count(), 1);
    }

    #[test]
    fn what_is_to_be_typed_stands_out() {
        assert_eq!(prose("give `--a <B>` & `c`"), "give <code>--a &lt;B&gt;</code> &amp; <code>c</code>");
        let table = Table { title: "T".into(), notes: vec!["`n`".into()], ..Table::default() };
        let page = page(&Report { tables: vec![table], ..Report::default() }).replace(&script(), "");
        assert!(page.contains("<p class=\"note\"><code>n</code></p>") && !page.contains("<table>"), "{page}");
    }

    #[test]
    fn panels_share_the_horizontal_axis() {
        let plot = plot(&report().figures[0]).to_json();
        assert!(plot.contains("\"yaxis3\"") && !plot.contains("\"xaxis2\""));
    }
}
