//! The rows as curves of the open circuit's voltage.

use crate::signals::curve_trend::{CurvePoint, trend};
use crate::signals::line_fit::LineFit;
use results::{SignalCurve, SignalRow};

/// The curves of rows, whose points follow one another.
pub fn curves(rows: &[SignalRow]) -> Vec<SignalCurve> {
    of_curves(rows).map(curve).collect()
}

/// The rows of each curve.
pub(crate) fn of_curves(rows: &[SignalRow]) -> impl Iterator<Item = &[SignalRow]> {
    let of = |row: &SignalRow| (row.film, row.position, row.direction, row.over);
    rows.chunk_by(move |a, b| a.tire == b.tire && of(a) == of(b))
}

fn curve(rows: &[SignalRow]) -> SignalCurve {
    let points = points(rows);
    let (monotone, monotone_certain) = trend(&points);
    let line = line(&points);
    let SignalRow {
        tire,
        film,
        position,
        direction,
        over,
        ..
    } = &rows[0];
    SignalCurve {
        tire: tire.clone(),
        film: *film,
        position: *position,
        direction: *direction,
        over: *over,
        slope: line
            .map(|line| line.slope)
            .filter(|slope| slope.is_finite()),
        monotone,
        monotone_certain,
        linear_r2: line.and_then(|line| line.r2),
    }
}

/// Returns those points of a curve that have a voltage, in the order of what changes along it.
pub fn points(rows: &[SignalRow]) -> Vec<CurvePoint> {
    let point = |row: &SignalRow| {
        Some(CurvePoint {
            at: row.along(),
            value: row.open_circuit_v?,
            error: row.error.map(|error| error.open_circuit_v),
        })
    };
    let mut points: Vec<CurvePoint> = rows.iter().filter_map(point).collect();
    points.sort_by(|a, b| a.at.total_cmp(&b.at));
    points
}

/// The line through the points.
pub fn line(points: &[CurvePoint]) -> Option<LineFit> {
    let pairs: Vec<(f64, f64)> = points.iter().map(|point| (point.at, point.value)).collect();
    LineFit::of(&pairs)
}
