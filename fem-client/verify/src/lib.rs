//! Verification: problems whose answer is known, solved by `fem` and compared.
//!
//! A case is a number with what it should be. Answers come from closed forms where there are any, else from independent
//! codes. Tolerances come from theory: round-off and Newton's tolerance for homogeneous deformations, the discretisation
//! error estimated from two meshes (and the rate that theory promises) for the others, what a formula neglects for
//! Hertz's, and the other code's own error for comparisons. The families, each a file:
//!
//! - `homogeneous`: stretches, shear, bulk compression, patch test, rigid rotation
//! - `cylinder`: inflated thick cylinder in plane strain
//! - `sphere`: inflated thick sphere, through its limit point
//! - `cook`: Cook's membrane
//! - `hertz`: contact of a cylinder and of a ball with a plane
//! - `ring`: a ring between plates

use std::sync::atomic::AtomicBool;

use fem::linear::setup::SetupError;
use fem::newton::iteration::Cause;
use serde::Serialize;

use fem_client::solver::SolveError;

pub(crate) mod body;
pub(crate) mod convergence;
mod cook;
pub(crate) mod cylinder;
pub mod extremes;
pub(crate) mod hertz;
pub(crate) mod homogeneous;
pub(crate) mod plate;
mod ring;
pub(crate) mod sphere;

/// An observed slope must be nearer to the theoretical order than to the next lower one: two meshes are rarely asymptotic.
const SLOPE_MARGIN: f64 = 0.5;

/// Verdict on a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// The error is within the tolerance, and the convergence as fast as it should be.
    Pass,
    /// It isn't, or there is no answer.
    Fail,
}

/// How an error is measured.
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
    /// From the errors on the two finest meshes, over the whole curve that the value belongs to.
    pub observed: f64,
    /// What theory promises at least.
    pub theoretical: f64,
}

/// A number with what it should be.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Case {
    /// What was computed, with its unit.
    pub name: String,
    /// The computed value; `None` when there is none.
    pub computed: Option<f64>,
    /// What it should be.
    pub expected: f64,
    /// Error as measured; `None` when there is no value.
    pub error: Option<f64>,
    /// Largest error that passes.
    pub tolerance: f64,
    /// How the error is measured.
    pub measure: Measure,
    /// Convergence under refinement, where more than one mesh was solved.
    pub slope: Option<Slope>,
    /// Where the expected value comes from.
    pub source: &'static str,
    /// Verdict.
    pub verdict: Verdict,
    /// Why there is no value, or how the solve ended.
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

    /// A family that has no answer.
    fn unsolved(family: &str, failure: &Unsolved) -> Self {
        Self {
            detail: Some(failure.to_string()),
            ..Self::absolute(family, f64::NAN, 0.0)
        }
    }
}

/// Why a case has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Unsolved {
    /// The model can't be set up.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// A load has no equilibrium that Newton's method finds.
    #[error("no equilibrium beyond {reached} of the load: {cause:?}")]
    Load {
        /// Fraction of the load that was reached.
        reached: f64,
        /// What ended the last attempt.
        cause: Cause,
    },
    /// A volume has none.
    #[error("no equilibrium at a volume ratio of {ratio}: {cause:?}")]
    Volume {
        /// Volume over that of the reference state.
        ratio: f64,
        /// What ended the attempt.
        cause: Cause,
    },
    /// The way to the limit point can't be followed.
    #[error("no way to the limit point: {cause:?}")]
    LimitPoint {
        /// What ended the last attempt.
        cause: Cause,
    },
    /// The pressure rises all the way.
    #[error("no limit point up to a volume ratio of {ratio}")]
    NoLimitPoint {
        /// Largest volume over that of the reference state.
        ratio: f64,
    },
    /// A scene has no equilibrium.
    #[error(transparent)]
    Scene(#[from] SolveError),
    /// Something else, in words.
    #[error("{0}")]
    Other(String),
}

/// Solves the cases of a family; `true` stops it.
pub type Solve = fn(&AtomicBool) -> Result<Vec<Case>, Unsolved>;

/// Cases that are solved together.
#[derive(Debug, Clone, Copy)]
pub struct Family {
    /// Its name, by which it is chosen.
    pub name: &'static str,
    solve: Solve,
}

/// All families, roughly from the quickest to the slowest.
pub const FAMILIES: [Family; 9] = [
    Family::new("homogeneous", homogeneous::stretches),
    Family::new("patch", homogeneous::others),
    Family::new("cook", cook::cases),
    Family::new("cylinder", cylinder::cases),
    Family::new("ring", ring::cases),
    Family::new("hertz-line", hertz::line),
    Family::new("sphere", sphere::mooney_rivlin),
    Family::new("hertz-ball", hertz::ball),
    Family::new("sphere-limit", sphere::limit_points),
];

impl Family {
    /// A family of this name.
    pub const fn new(name: &'static str, solve: Solve) -> Self {
        Self { name, solve }
    }

    /// Solves its cases. A family without an answer is one failed case.
    pub fn cases(&self, stop: &AtomicBool) -> Vec<Case> {
        (self.solve)(stop).unwrap_or_else(|failure| vec![Case::unsolved(self.name, &failure)])
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
