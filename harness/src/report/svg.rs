//! A figure as a picture, for pages that cannot hold curves one may touch.

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{Curve, Dash, Figure, Panel, palette};

/// The picture is drawn this much larger than it is shown: the backend knows whole pixels only.
const SCALE: u32 = 4;

/// How many points of a curve are drawn.
const POINTS: usize = 900;

const INK: RGBColor = RGBColor(28, 39, 51);
const SOFT: RGBColor = RGBColor(91, 104, 117);
const GRID: RGBColor = RGBColor(228, 233, 238);
const SPAN: RGBColor = RGBColor(238, 243, 248);
const FONT: &str = "Helvetica, Arial, sans-serif";

/// Why a picture could not be drawn.
#[derive(Debug, thiserror::Error)]
#[error("cannot draw the picture: {0}")]
pub struct DrawError(String);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Draws a figure of this width and height (px).
pub fn picture(figure: &Figure, width: u32, height: u32) -> Result<String, DrawError> {
    let mut svg = String::new();
    draw(figure, SVGBackend::with_string(&mut svg, (width * SCALE, height * SCALE)).into_drawing_area())
        .map_err(|e| DrawError(e.to_string()))?;
    // Shown at the size asked for, whatever it was drawn at.
    let drawn = format!("width=\"{}\" height=\"{}\"", width * SCALE, height * SCALE);
    Ok(svg.replacen(&drawn, &format!("width=\"{width}\" height=\"{height}\""), 1))
}

fn draw(figure: &Figure, area: Area) -> Result<(), Box<dyn std::error::Error>> {
    area.fill(&WHITE)?;
    let head = area.titled("", (FONT, 1))?.split_vertically(px(64));
    draw_legend(figure, &head.0)?;
    let total: u32 = figure.panels.iter().map(|p| p.height.max(1)).sum();
    let axis = px(40);
    let mut rest = head.1;
    let available = rest.dim_in_pixel().1 as i32 - axis;
    let (from, to) = horizontal_range(figure);
    for (place, panel) in figure.panels.iter().enumerate() {
        let last = place + 1 == figure.panels.len();
        let share = available * panel.height.max(1) as i32 / total.max(1) as i32;
        let (this, below) = rest.split_vertically(if last { share + axis } else { share });
        draw_panel(figure, panel, &this, (from, to), last)?;
        rest = below;
    }
    Ok(())
}

fn draw_panel(
    figure: &Figure,
    panel: &Panel,
    area: &Area,
    (from, to): (f64, f64),
    last: bool,
) -> Result<(), Box<dyn std::error::Error>> {
    let words_here = !figure.spans.is_empty() && std::ptr::eq(panel, &figure.panels[0]);
    let mut chart = ChartBuilder::on(area)
        .margin_left(px(12))
        .margin_right(px(16))
        .margin_top(px(10))
        .set_label_area_size(LabelAreaPosition::Left, px(60))
        .set_label_area_size(LabelAreaPosition::Bottom, if last { px(40) } else { 0 })
        .build_cartesian_2d(from..to, value_range(panel, words_here))?;
    for (start, end, words) in &figure.spans {
        let (low, high) = (chart.y_range().start, chart.y_range().end);
        chart.draw_series([Rectangle::new([(*start, low), (*end, high)], SPAN.filled())])?;
        if words_here {
            let style = text(12, SOFT).pos(Pos::new(HPos::Left, VPos::Top));
            chart.draw_series([Text::new(
                words.clone(),
                (*start + (to - from) * 0.006, high - (high - low) * 0.02),
                style,
            )])?;
        }
    }
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID.stroke_width(SCALE))
        .axis_style(SOFT.stroke_width(SCALE))
        .y_labels(if area.dim_in_pixel().1 < SCALE * 130 { 3 } else { 6 })
        .x_labels(10)
        .x_label_formatter(&|v| label(*v))
        .y_label_formatter(&|v| label(*v))
        .label_style(text(12, INK))
        .axis_desc_style(text(13, INK))
        .y_desc(&panel.label)
        .x_desc(if last { figure.horizontal.as_str() } else { "" })
        .draw()?;
    for curve in panel.curves.iter().filter(|c| !c.hidden) {
        let (points, style) = (points(curve), stroke(curve));
        match dashes(curve.style.dash) {
            None => drop(chart.draw_series(LineSeries::new(points, style))?),
            Some((dash, gap)) => drop(chart.draw_series(DashedLineSeries::new(points, dash, gap, style))?),
        }
    }
    Ok(())
}

/// The names of the curves in a line at the top, each after a piece of its line.
fn draw_legend(figure: &Figure, area: &Area) -> Result<(), Box<dyn std::error::Error>> {
    let title = text(16, INK).pos(Pos::new(HPos::Left, VPos::Center));
    area.draw_text(&figure.title, &title, (px(16), px(18)))?;
    let mut seen: Vec<&str> = Vec::new();
    let mut x = px(64);
    for curve in figure.panels.iter().flat_map(|p| &p.curves).filter(|c| !c.hidden) {
        if seen.contains(&curve.name.as_str()) {
            continue;
        }
        seen.push(&curve.name);
        let line = [(x, px(46)), (x + px(24), px(46))];
        match dashes(curve.style.dash) {
            None => area.draw(&PathElement::new(line, stroke(curve)))?,
            Some((dash, gap)) => area.draw(&DashedPathElement::new(line, dash, gap, stroke(curve)))?,
        }
        let style = text(13, INK).pos(Pos::new(HPos::Left, VPos::Center));
        area.draw_text(&curve.name, &style, (x + px(30), px(46)))?;
        x += px(52) + px(7) * curve.name.chars().count() as i32;
    }
    Ok(())
}

fn points(curve: &Curve) -> Vec<(f64, f64)> {
    let (places, values) = curve.points(POINTS);
    let mut points: Vec<(f64, f64)> = Vec::with_capacity(places.len() * 2);
    for (place, value) in places.into_iter().zip(values).filter(|(_, v)| v.is_finite()) {
        if curve.held
            && let Some(&(_, before)) = points.last()
        {
            points.push((place, before));
        }
        points.push((place, value));
    }
    points
}

fn stroke(curve: &Curve) -> ShapeStyle {
    let [r, g, b] = palette::color(curve.style.color);
    RGBColor(r, g, b).stroke_width((curve.style.width * f64::from(SCALE)).round() as u32)
}

/// The lengths of dashes and gaps in the drawing.
fn dashes(dash: Dash) -> Option<(u32, u32)> {
    match dash {
        Dash::Solid => None,
        Dash::Dashed => Some((7 * SCALE, 4 * SCALE)),
        Dash::Dotted => Some((2 * SCALE, 3 * SCALE)),
    }
}

fn horizontal_range(figure: &Figure) -> (f64, f64) {
    let places = || figure.panels.iter().flat_map(|p| &p.curves).flat_map(|c| c.places.iter().copied());
    range(places().fold(f64::INFINITY, f64::min), places().fold(f64::NEG_INFINITY, f64::max), 0.0)
}

/// With room above for words, where some stand there.
fn value_range(panel: &Panel, words: bool) -> std::ops::Range<f64> {
    let values =
        || panel.curves.iter().filter(|c| !c.hidden).flat_map(|c| c.values.iter().copied()).filter(|v| v.is_finite());
    let (low, high) = range(values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max), 0.06);
    low..high + if words { 0.08 * (high - low) } else { 0.0 }
}

/// From lowest to highest with some room, and never empty. A range that begins next to 0 begins there.
fn range(low: f64, high: f64, room: f64) -> (f64, f64) {
    if low > high {
        return (0.0, 1.0);
    }
    let width = if high > low { high - low } else { 1.0 };
    let below = if (0.0..=room * width).contains(&low) { low } else { room * width };
    (low - below, if high > low { high } else { low + 1.0 } + room * width)
}

fn label(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.replace('-', "−") }
}

fn text(size: i32, color: RGBColor) -> TextStyle<'static> {
    TextStyle { color: color.to_backend_color(), ..TextStyle::from((FONT, px(size))) }
}

fn px(length: i32) -> i32 {
    length * SCALE as i32
}

#[cfg(test)]
mod tests {
    use super::super::Style;
    use super::*;

    #[test]
    fn draws_every_curve_at_the_size_asked_for() {
        let style = Style { color: 1, width: 2.0, dash: Dash::Solid };
        let curve = |name: &str, held| Curve {
            name: name.into(),
            places: [0.0, 1.0, 2.0].as_slice().into(),
            values: vec![0.0, 3.0, f64::NAN],
            style,
            held,
            hidden: false,
        };
        let panel = Panel { label: "swing (°)".into(), height: 1, curves: vec![curve("a", false), curve("b", true)] };
        let spans = vec![(1.0, 2.0, "rest".to_owned())];
        let figure = Figure { title: "Swing".into(), panels: vec![panel.clone(), panel], spans, ..Figure::default() };
        let svg = picture(&figure, 600, 400).unwrap();
        assert!(svg.contains("width=\"600\" height=\"400\" viewBox=\"0 0 2400 1600\""), "{}", &svg[..200]);
        assert!(svg.matches("<polyline").count() >= 4);
        assert!(svg.contains("swing (°)") && svg.contains("rest"));
    }

    #[test]
    fn draws_nothing_without_failing() {
        assert!(picture(&Figure::default(), 300, 200).is_ok());
        assert_eq!((label(-0.5), label(20.0), label(-0.0)), ("−0.5".into(), "20".into(), "0".into()));
    }
}
