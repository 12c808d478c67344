//! Claims about films in a tire, and what holds of them: that the voltage rises with the load, that it falls with the pressure, and that it is linear over the
//! contact angle.
//!
//! A film's sign is that of its wires, so that a voltage counts with the sign that makes the largest of its curve positive.

use crate::signals::curve_trend::{CurvePoint, Step, steps};
use crate::signals::signal_curves::{line, of_curves, points};
use results::{Claim, ClaimRow, Holds, SignalAxis, SignalRow};

/// Share of the variance that a line explains where a curve counts as linear.
const LINEAR_R2: f64 = 0.9;

/// A verdict with what the curve does.
type Verdict = (Holds, String);

/// A claim for each curve.
pub fn claims(rows: &[SignalRow]) -> Vec<ClaimRow> {
    of_curves(rows).map(claim).collect()
}

fn claim(rows: &[SignalRow]) -> ClaimRow {
    let points = points(rows);
    let (claim, (holds, detail)) = match rows[0].over {
        SignalAxis::Load => (Claim::RisesWithLoad, rises(&points, 1.0, "N")),
        SignalAxis::Pressure => (Claim::FallsWithPressure, rises(&points, -1.0, "MPa")),
        SignalAxis::Contact => (Claim::Linear, is_linear(&points)),
    };
    let (holds, detail) = with_gaps(holds, detail, rows.len() - points.len());
    let SignalRow {
        tire,
        film,
        position,
        direction,
        ..
    } = &rows[0];
    ClaimRow {
        tire: tire.clone(),
        film: *film,
        position: *position,
        direction: *direction,
        claim,
        holds,
        detail,
    }
}

/// Weakens a verdict by gaps: what isn't solved can't confirm a claim.
fn with_gaps(holds: Holds, detail: String, gaps: usize) -> Verdict {
    match (gaps, holds) {
        (0, _) => (holds, detail),
        (_, Holds::Yes) => (
            Holds::Uncertain,
            format!("{detail}; without a reading: {gaps}"),
        ),
        _ => (holds, format!("{detail}; without a reading: {gaps}")),
    }
}

/// Whether the voltage rises at every step, or with the sign -1 falls.
fn rises(points: &[CurvePoint], sign: f64, unit: &str) -> Verdict {
    if points.len() < 2 {
        return (Holds::Uncertain, "fewer than two points".to_owned());
    }
    let largest = points
        .iter()
        .max_by(|a, b| a.value.abs().total_cmp(&b.value.abs()));
    let wires = largest.map_or(1.0, |point| point.value.signum());
    let (along, against) = if sign > 0.0 {
        ("rises", "falls")
    } else {
        ("falls", "rises")
    };
    let steps: Vec<Step> = steps(points).collect();
    let is_wrong = |step: &&Step| step.change * wires * sign < 0.0;
    let wrong = |step: &Step| format!("{against} from {} {unit}", step.from);
    if let Some(step) = steps.iter().find(|step| is_wrong(step) && step.certain) {
        return (Holds::No, wrong(step));
    }
    if points.iter().any(|point| point.error.is_none()) {
        let detail = match steps.iter().find(is_wrong) {
            Some(step) => wrong(step),
            None => format!("{along} throughout"),
        };
        return (
            Holds::Uncertain,
            format!("{detail}, with errors that aren't known"),
        );
    }
    match steps.iter().find(|step| !step.certain) {
        Some(step) => {
            let Step { from, to, .. } = step;
            let detail = format!("from {from} to {to} {unit} the change is within its error");
            (Holds::Uncertain, detail)
        }
        None => (Holds::Yes, format!("{along} throughout")),
    }
}

fn is_linear(points: &[CurvePoint]) -> Verdict {
    let Some(r2) = line(points).and_then(|line| line.r2) else {
        let detail = "fewer than three points, or no change";
        return (Holds::Uncertain, detail.to_owned());
    };
    let holds = if r2 >= LINEAR_R2 {
        Holds::Yes
    } else {
        Holds::No
    };
    (holds, format!("R2 {r2:.2}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve<const N: usize>(values: [f64; N], error: Option<f64>) -> Vec<CurvePoint> {
        let point = |(k, value): (usize, &f64)| CurvePoint {
            at: 10.0 * k as f64,
            value: *value,
            error,
        };
        values.iter().enumerate().map(point).collect()
    }

    #[test]
    fn a_voltage_rises_whichever_way_the_wires_are() {
        let sure = Some(0.1);
        for wires in [1.0, -1.0] {
            let of =
                |values: [f64; 3], error| rises(&curve(values.map(|v| wires * v), error), 1.0, "N");
            assert_eq!(
                of([1.0, 2.0, 3.0], sure),
                (Holds::Yes, "rises throughout".to_owned())
            );
            assert_eq!(
                of([1.0, 3.0, 2.0], sure),
                (Holds::No, "falls from 10 N".to_owned())
            );
            let (holds, detail) = of([1.0, 3.0, 2.9], sure);
            assert_eq!(holds, Holds::Uncertain);
            assert_eq!(detail, "from 10 to 20 N the change is within its error");
            assert_eq!(of([1.0, 2.0, 3.0], None).0, Holds::Uncertain);
            // Through zero: it falls before it rises in size, but with its wires it only rises.
            assert_eq!(of([-1.0, 0.5, 3.0], sure).0, Holds::Yes);
        }
    }

    #[test]
    fn a_voltage_falls_with_pressure() {
        let of = |values: [f64; 3]| rises(&curve(values, Some(0.1)), -1.0, "MPa");
        assert_eq!(
            of([3.0, 2.0, 1.0]),
            (Holds::Yes, "falls throughout".to_owned())
        );
        assert_eq!(
            of([-3.0, -2.0, -2.5]),
            (Holds::No, "rises from 10 MPa".to_owned())
        );
    }

    #[test]
    fn a_line_explains_nine_tenths_of_what_counts_as_linear() {
        assert_eq!(
            is_linear(&curve([1.0, 2.0, 3.0], None)),
            (Holds::Yes, "R2 1.00".to_owned())
        );
        assert_eq!(
            is_linear(&curve([0.0, 1.0, 1.0], None)),
            (Holds::No, "R2 0.75".to_owned())
        );
        assert_eq!(is_linear(&curve([0.0, 1.0], None)).0, Holds::Uncertain);
    }

    #[test]
    fn what_is_not_solved_confirms_nothing() {
        let with = |holds| with_gaps(holds, "R2 0.95".to_owned(), 2).0;
        assert_eq!(
            [Holds::Yes, Holds::No].map(with),
            [Holds::Uncertain, Holds::No]
        );
    }
}
