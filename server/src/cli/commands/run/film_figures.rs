//! Films' voltages as pictures: over load and pressure (figure 5 of the study that the shipped placement study computes), and over the contact angle (figure 4).
//!
//! Each panel is of one tire and one direction of the films, with a curve for each position, each reading with its error: coupled films solid, bare ones dashed and
//! on an axis of their own, because they read some fifty times as much.

use documents::parts::film_model::FilmModel;
use fem_client::solver::Position;
use fem_client::solver::direction::Direction;
use plotters::coord::Shift;
use plotters::prelude::*;
use results::SignalAxis;
use results::SignalRow;
use results::Signals;

/// Width and height of a panel, pixels.
const PANEL: (u32, u32) = (500, 280);
/// Height of the legend, and width of one of its letters, at most, pixels.
const HEAD: u32 = 28;
const LETTER: i32 = 7;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Volts over load and over pressure.
///
/// # Errors
/// A sentence, when it can't be drawn.
pub(crate) fn figure_5(signals: &Signals) -> Result<String, String> {
    svg(signals, &[SignalAxis::Load, SignalAxis::Pressure])
}

/// Volts over the contact angle.
///
/// # Errors
/// A sentence, when it can't be drawn.
pub(crate) fn figure_4(signals: &Signals) -> Result<String, String> {
    svg(signals, &[SignalAxis::Contact])
}

/// A row of panels for each tire and direction, a column for each axis.
fn svg(signals: &Signals, axes: &[SignalAxis]) -> Result<String, String> {
    let mut text = String::new();
    let mut rows: Vec<(&str, Direction)> = Vec::new();
    for row in &signals.rows {
        if !rows.contains(&(&row.tire, row.direction)) {
            rows.push((&row.tire, row.direction));
        }
    }
    let size = (
        PANEL.0 * axes.len() as u32,
        HEAD + PANEL.1 * rows.len().max(1) as u32,
    );
    draw(signals, &rows, axes, size, &mut text)
        .map_err(|error| format!("the plot can't be drawn: {error}"))?;
    Ok(text)
}

fn draw(
    signals: &Signals,
    rows: &[(&str, Direction)],
    axes: &[SignalAxis],
    size: (u32, u32),
    text: &mut String,
) -> Drawn {
    let area = SVGBackend::with_string(text, size).into_drawing_area();
    area.fill(&WHITE)?;
    let (head, body) = area.split_vertically(HEAD);
    draw_legend(&head)?;
    let panels = body.split_evenly((rows.len().max(1), axes.len()));
    let all = rows
        .iter()
        .flat_map(|row| axes.iter().map(move |axis| (row, axis)));
    for (((tire, direction), axis), panel) in all.zip(&panels) {
        let of_panel = |row: &&SignalRow| {
            row.tire == *tire && row.direction == *direction && row.over == *axis
        };
        let readings: Vec<&SignalRow> = signals.rows.iter().filter(of_panel).collect();
        let title = format!("{tire} tire, films along {direction}");
        draw_panel(panel, &title, *axis, &readings)?;
    }
    area.present()
}

/// Draws what colours and dashes mean.
fn draw_legend(area: &Area<'_>) -> Drawn {
    let mut x = 12;
    let mut entry = |text: &str, style: ShapeStyle, dashed: bool| -> Drawn {
        let ends: &[(i32, i32)] = match dashed {
            true => &[(0, 6), (10, 16), (20, 26)],
            false => &[(0, 26)],
        };
        for (from, to) in ends {
            area.draw(&PathElement::new([(x + from, 14), (x + to, 14)], style))?;
        }
        area.draw(&Text::new(text.to_owned(), (x + 32, 8), ("sans-serif", 12)))?;
        x += 44 + LETTER * text.len() as i32;
        Ok(())
    };
    for position in Position::ALL {
        entry(position.as_str(), colour(position).stroke_width(2), false)?;
    }
    entry("bare", BLACK.stroke_width(1), true)?;
    entry("coupled", BLACK.stroke_width(1), false)
}

/// Coupled films on the left axis, bare ones, which read far more, on the right one.
fn draw_panel(area: &Area<'_>, title: &str, axis: SignalAxis, rows: &[&SignalRow]) -> Drawn {
    let curve = |film: FilmModel, position: Position| -> Vec<Point> {
        let of_curve = |row: &&&SignalRow| row.position == position && row.film == film;
        let points = rows.iter().filter(of_curve);
        let mut points: Vec<Point> = points.filter_map(|row| point(row)).collect();
        points.sort_by(|a, b| a.at.total_cmp(&b.at));
        points
    };
    let all = |film| {
        Position::ALL
            .into_iter()
            .flat_map(move |position| curve(film, position))
    };
    let volts = |film| {
        let ends = all(film).flat_map(|p| [p.volts - p.error, p.volts + p.error]);
        padded(ends.chain([0.0]))
    };
    let [coupled, bare] = [FilmModel::Coupled, FilmModel::Bare];
    let along = padded(rows.iter().map(|row| row.along()));
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 14))
        .margin(8)
        .x_label_area_size(36)
        .y_label_area_size(52)
        .right_y_label_area_size(56)
        .build_cartesian_2d(along.clone(), volts(coupled))?
        .set_secondary_coord(along, volts(bare));
    chart
        .configure_mesh()
        .x_desc(match axis {
            SignalAxis::Load => "load, N",
            SignalAxis::Pressure => "pressure, MPa",
            SignalAxis::Contact => "contact angle, degrees",
        })
        .y_desc("coupled, V")
        .light_line_style(WHITE)
        .draw()?;
    chart.configure_secondary_axes().y_desc("bare, V").draw()?;
    for position in Position::ALL {
        let style = colour(position).stroke_width(2);
        let points = curve(coupled, position);
        let line = points.iter().map(|p| (p.at, p.volts));
        chart.draw_series(LineSeries::new(line, style))?;
        chart.draw_series(points.iter().map(|p| p.bar(style)))?;
        let points = curve(bare, position);
        let line = points.iter().map(|p| (p.at, p.volts));
        chart.draw_secondary_series(DashedLineSeries::new(line, 6, 4, style))?;
        chart.draw_secondary_series(points.iter().map(|p| p.bar(style)))?;
    }
    Ok(())
}

/// A reading in a panel; without a known error, its own.
#[derive(Clone, Copy)]
struct Point {
    at: f64,
    volts: f64,
    error: f64,
}

impl Point {
    /// Draws a bar from the least that it may be to the most.
    fn bar(self, style: ShapeStyle) -> PathElement<(f64, f64)> {
        let ends = [self.volts - self.error, self.volts + self.error];
        PathElement::new(ends.map(|volts| (self.at, volts)), style)
    }
}

fn point(row: &SignalRow) -> Option<Point> {
    Some(Point {
        at: row.along(),
        volts: row.open_circuit_v?,
        error: row.error.map_or(0.0, |error| error.open_circuit_v),
    })
}

/// A range that holds all values and a little more.
fn padded(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low > high {
        return 0.0..1.0;
    }
    let margin = match 0.05 * (high - low) {
        0.0 => 1.0,
        margin => margin,
    };
    low - margin..high + margin
}

fn colour(position: Position) -> RGBColor {
    match position {
        Position::Crown => RGBColor(0, 90, 156),
        Position::Shoulder => RGBColor(200, 110, 20),
        Position::Sidewall => RGBColor(40, 130, 70),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn row(film: FilmModel, over: SignalAxis, at: f64, volts: Option<f64>) -> SignalRow {
        let row = json!({
            "tire": "own", "film": film, "position": "crown", "direction": "x", "over": over,
            "load_n": at, "pressure_mpa": at, "contact_deg": at, "open_circuit_v": volts,
        });
        serde_json::from_value(row).expect("a row")
    }

    #[test]
    fn every_axis_has_its_panel_and_every_film_its_line() {
        let rows = SignalAxis::ALL.into_iter().flat_map(|over| {
            [FilmModel::Bare, FilmModel::Coupled]
                .map(|film| [1.0, 2.0, 3.0].map(|at| row(film, over, at, (at < 3.0).then_some(at))))
        });
        let signals = Signals {
            rows: rows.flatten().collect(),
            ..Signals::default()
        };
        let (four, five) = (figure_4(&signals), figure_5(&signals));
        let (four, five) = (four.expect("draws"), five.expect("draws"));
        for (text, words) in [
            (&four, vec!["contact angle, degrees"]),
            (&five, vec!["load, N", "pressure, MPa"]),
        ] {
            for word in words.into_iter().chain(["crown", "bare, V", "coupled, V"]) {
                assert!(text.contains(word), "{word}");
            }
            assert!(!text.contains("NaN"));
        }
    }

    #[test]
    fn a_study_in_which_nothing_was_solved_has_empty_panels() {
        let rows = vec![row(FilmModel::Bare, SignalAxis::Load, 1.0, None)];
        let signals = Signals {
            rows,
            ..Signals::default()
        };
        assert!(figure_5(&signals).expect("draws").contains("load, N"));
        assert!(figure_4(&Signals::default()).is_ok());
    }
}
