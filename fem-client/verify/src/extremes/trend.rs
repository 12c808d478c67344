//! Laws that a series of values must follow.

use crate::known_case::Case;

/// Safety on a bound that follows from a leading term: the next ones may add as much.
const SAFETY: f64 = 2.0;
/// A distance from the limit that is this much above the noise has a slope.
const CLEAR: f64 = 10.0;

/// A value of a series.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Place at which it was taken, for people.
    pub label: String,
    /// The parameter that grows, in the unit that the label says.
    pub parameter: f64,
    /// The value there, in the unit of the quantity.
    pub value: f64,
}

/// A limit that values go to as their parameter grows, their distance from it falling like 1 / parameter^order.
#[derive(Debug, Clone, Copy)]
pub struct Limit {
    /// The limit, in the unit of the quantity.
    pub value: f64,
    /// Remainder of the distance that is allowed however large the parameter is, in its unit.
    pub noise: f64,
    /// Power by which the distance falls.
    pub order: f64,
    /// Source of limit and power.
    pub source: &'static str,
}

impl Limit {
    /// Each value but the first against the limit: its distance may be twice what the law says after the distance before it.
    pub fn cases(&self, quantity: &str, points: &[Point]) -> Vec<Case> {
        points
            .windows(2)
            .map(|pair| self.case(quantity, &pair[0], &pair[1]))
            .collect()
    }

    fn case(&self, quantity: &str, before: &Point, now: &Point) -> Case {
        let growth = now.parameter / before.parameter;
        let far = (before.value - self.value).abs();
        let distance = (now.value - self.value).abs();
        let tolerance = SAFETY * far / growth.powf(self.order) + self.noise;
        let name = format!("{}: {quantity}", now.label);
        let (case, tolerance) = if self.value == 0.0 {
            (Case::absolute(name, now.value, 0.0), tolerance)
        } else {
            let case = Case::relative(name, now.value, self.value);
            (case, tolerance / self.value.abs())
        };
        let clear = distance > CLEAR * self.noise;
        let slope = (far / distance).ln() / growth.ln();
        let case = if clear {
            case.slope(slope, self.order)
        } else {
            case
        };
        case.within(tolerance, self.source)
    }
}

/// Counts how often a series that must rise falls, by more than the noise.
pub fn rises(quantity: &str, values: &[f64], noise: f64, source: &'static str) -> Case {
    let falls = values.windows(2).filter(|pair| pair[1] < pair[0] - noise);
    let not_finite = values.iter().filter(|value| !value.is_finite());
    let count = (falls.count() + not_finite.count()) as f64;
    let name = format!("{quantity}: steps against the trend");
    Case::absolute(name, count, 0.0).within(0.0, source)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::known_case::Verdict;

    const TO_TWO: Limit = Limit {
        value: 2.0,
        noise: 1e-9,
        order: 1.0,
        source: "x",
    };

    fn points(values: &[f64]) -> Vec<Point> {
        let point = |(k, value): (usize, &f64)| Point {
            label: String::new(),
            parameter: 10f64.powi(k as i32),
            value: *value,
        };
        values.iter().enumerate().map(point).collect()
    }

    fn verdicts(values: &[f64]) -> Vec<Verdict> {
        let cases = TO_TWO.cases("x", &points(values));
        cases.iter().map(|case| case.verdict).collect()
    }

    #[test]
    fn values_must_close_in_at_the_rate_until_the_noise_is_reached() {
        use Verdict::{Fail, Pass};
        assert_eq!(verdicts(&[2.1, 2.01, 2.001]), [Pass, Pass]);
        assert_eq!(verdicts(&[2.1, 2.06, 2.006]), [Fail, Pass], "too slow");
        assert_eq!(verdicts(&[2.1, 2.0, 2.0 + 5e-10]), [Pass, Pass]);
        assert_eq!(verdicts(&[2.1, f64::NAN]), [Fail]);
    }

    #[test]
    fn a_step_back_and_a_missing_number_are_counted() {
        assert_eq!(
            rises("x", &[1.0, 2.0, 3.0], 0.0, "x").verdict,
            Verdict::Pass
        );
        assert_eq!(
            rises("x", &[1.0, 0.999, 3.0], 0.01, "x").verdict,
            Verdict::Pass
        );
        assert_eq!(
            rises("x", &[1.0, 0.9, 3.0], 0.01, "x").verdict,
            Verdict::Fail
        );
        assert_eq!(
            rises("x", &[1.0, f64::NAN], 0.0, "x").verdict,
            Verdict::Fail
        );
    }
}
