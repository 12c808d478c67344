//! A number with what it should be, and the verdict on it.

use serde::Serialize;

/// An observed slope must be nearer to the theoretical order than to the next lower one: two meshes are rarely asymptotic.
const SLOPE_MARGIN: f64 = 0.5;

/// Verdict on a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// The error is within the tolerance, and the convergence as fast as it should be.
    Pass,
    /// An error beyond the tolerance, or no answer.
    Fail,
}

/// Measure of an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Measure {
    /// Difference over the expected value.
    Relative,
    /// Difference.
    Absolute,
}

/// Rate at which the error falls with the size of the elements: exponent of h. For Hertz's formulas, which hold in a
/// limit, with the radius of the contact instead.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Slope {
    /// Slope from the errors on the two finest meshes, over the whole curve that the value belongs to.
    pub observed: f64,
    /// Least slope that theory promises.
    pub theoretical: f64,
}

/// A number with what it should be.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Case {
    /// Quantity that was computed, with its unit.
    pub name: String,
    /// The computed value, in the unit that the name says; `None` when there is none.
    pub computed: Option<f64>,
    /// Value that it should have, in that unit.
    pub expected: f64,
    /// Error as measured; `None` when there is no value.
    pub error: Option<f64>,
    /// Largest error that passes.
    pub tolerance: f64,
    /// Measure of the error.
    pub measure: Measure,
    /// Convergence under refinement, where more than one mesh was solved.
    pub slope: Option<Slope>,
    /// Source of the expected value.
    pub source: &'static str,
    /// Verdict.
    pub verdict: Verdict,
    /// Reason why there is no value, or end of the solve.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub detail: Option<String>,
}

impl Case {
    fn new(name: String, computed: f64, expected: f64, measure: Measure) -> Self {
        let error = match measure {
            Measure::Relative => (computed / expected - 1.0).abs(),
            Measure::Absolute => (computed - expected).abs(),
        };
        let finite = |value: f64| value.is_finite().then_some(value);
        Self {
            name,
            computed: finite(computed),
            expected,
            error: finite(error),
            tolerance: 0.0,
            measure,
            slope: None,
            source: "",
            verdict: Verdict::Fail,
            detail: None,
        }
    }

    /// A value whose error is relative.
    pub fn relative(name: impl Into<String>, computed: f64, expected: f64) -> Self {
        Self::new(name.into(), computed, expected, Measure::Relative)
    }

    /// A value whose error is absolute.
    pub fn absolute(name: impl Into<String>, computed: f64, expected: f64) -> Self {
        Self::new(name.into(), computed, expected, Measure::Absolute)
    }

    /// Adds how fast the error falls.
    pub fn slope(mut self, observed: f64, theoretical: f64) -> Self {
        self.slope = Some(Slope {
            observed,
            theoretical,
        });
        self
    }

    /// Judges the case by its tolerance and, where there is one, its slope. An error at round-off has no slope.
    pub fn within(mut self, tolerance: f64, source: &'static str) -> Self {
        self.tolerance = tolerance;
        self.source = source;
        if self.slope.is_some_and(|slope| !slope.observed.is_finite()) {
            self.slope = None;
        }
        let steep = self
            .slope
            .is_none_or(|slope| slope.observed >= slope.theoretical - SLOPE_MARGIN);
        if steep && self.error.is_some_and(|error| error <= tolerance) {
            self.verdict = Verdict::Pass;
        }
        self
    }

    /// Adds how the solve ended.
    pub fn ended(mut self, detail: impl Into<String>) -> Self {
        self.detail = Some(detail.into());
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_passes_only_within_its_tolerance_and_at_its_slope() {
        let case = |computed| Case::relative("case", computed, 2.0);
        assert_eq!(case(2.02).within(0.011, "x").verdict, Verdict::Pass);
        assert_eq!(case(2.03).within(0.011, "x").verdict, Verdict::Fail);
        assert_eq!(case(f64::NAN).within(0.011, "x").verdict, Verdict::Fail);
        assert_eq!(case(f64::NAN).within(0.011, "x").computed, None);
        let slow = case(2.0).slope(1.4, 2.0).within(0.011, "x");
        assert_eq!(slow.verdict, Verdict::Fail);
        let fast = case(2.0).slope(4.1, 2.0).within(0.011, "x");
        assert_eq!(fast.verdict, Verdict::Pass);
    }
}
