//! Trend of a curve, and whether its points are sure enough to say so.

use results::Trend;

/// A point of a curve: where, its value, and the value's error where that is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// Load, pressure or angle.
    pub at: f64,
    /// Voltage, V.
    pub value: f64,
    /// Error of the voltage, V.
    pub error: Option<f64>,
}

/// Step from one point to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Place where it begins.
    pub from: f64,
    /// Place where it ends.
    pub to: f64,
    /// Change of the value.
    pub change: f64,
    /// Whether it is larger than the errors of its two ends together.
    pub certain: bool,
}

/// The steps of a curve.
pub fn steps(points: &[CurvePoint]) -> impl Iterator<Item = Step> {
    points.windows(2).filter_map(|pair| {
        let &[a, b] = pair else { return None };
        let change = b.value - a.value;
        let errors = a.error.zip(b.error).map(|(a, b)| a + b);
        Some(Step {
            from: a.at,
            to: b.at,
            change,
            certain: errors.is_some_and(|errors| change.abs() > errors),
        })
    })
}

/// Returns which way the values go, and whether every step is certain; `None` of fewer than two points.
pub fn trend(points: &[CurvePoint]) -> (Option<Trend>, bool) {
    let steps: Vec<Step> = steps(points).collect();
    let all = |goes: fn(&Step) -> bool| steps.iter().all(goes);
    let trend = match () {
        () if steps.is_empty() => return (None, false),
        () if all(|step| step.change > 0.0) => Trend::Up,
        () if all(|step| step.change < 0.0) => Trend::Down,
        () => Trend::No,
    };
    (Some(trend), all(|step| step.certain))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of<const N: usize>(points: [(f64, Option<f64>); N]) -> (Option<Trend>, bool) {
        let points = points.map(|(value, error)| CurvePoint {
            at: value,
            value,
            error,
        });
        trend(&points)
    }

    #[test]
    fn a_curve_goes_up_down_or_neither() {
        let sure = Some(0.4);
        assert_eq!(
            of([(1.0, sure), (2.0, sure), (4.0, sure)]),
            (Some(Trend::Up), true)
        );
        assert_eq!(of([(4.0, sure), (2.0, sure)]), (Some(Trend::Down), true));
        assert_eq!(
            of([(1.0, sure), (2.0, sure), (1.0, sure)]),
            (Some(Trend::No), true)
        );
        assert_eq!(of([(1.0, sure), (1.0, sure)]), (Some(Trend::No), false));
    }

    #[test]
    fn a_step_within_the_errors_of_its_ends_is_uncertain() {
        assert_eq!(
            of([(1.0, Some(0.5)), (2.0, Some(0.5))]),
            (Some(Trend::Up), false)
        );
        assert_eq!(
            of([(1.0, Some(0.1)), (2.0, Some(0.8))]),
            (Some(Trend::Up), true)
        );
        assert_eq!(
            of([(1.0, Some(0.1)), (2.0, None)]),
            (Some(Trend::Up), false)
        );
        assert_eq!(of([(1.0, Some(0.1))]), (None, false));
    }
}
