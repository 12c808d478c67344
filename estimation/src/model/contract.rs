//! Contract of the models: what they are given and what they say.

use ndarray::ArrayView2;

/// Prediction of a row: the force, and how far off it may be as one standard deviation, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prediction {
    /// N
    pub mean: f64,
    /// N, positive
    pub deviation: f64,
}

impl Prediction {
    /// Joins what several say: the median of their means, which one that goes astray can't move far, and the root of the squared distance from it that is
    /// expected where each is as likely to be right as the others. What one says stays as it is.
    pub fn together(of: &[Self]) -> Self {
        if let [one] = of {
            return *one;
        }
        let mut means: Vec<f64> = of.iter().map(|said| said.mean).collect();
        means.sort_by(f64::total_cmp);
        let count = means.len();
        let median = 0.5 * (means[(count - 1) / 2] + means[count / 2]);
        let square = |said: &Self| said.deviation.powi(2) + (said.mean - median).powi(2);
        let squares: f64 = of.iter().map(square).sum();
        Self {
            mean: median,
            deviation: (squares / count as f64).sqrt(),
        }
    }
}

/// Rows from which a model is learnt.
#[derive(Debug, Clone, Copy)]
pub struct Training<'a> {
    /// Rows x features, on one scale.
    pub features: ArrayView2<'a, f64>,
    /// The force of each row, N.
    pub forces: &'a [f64],
    /// The cycle of each row: what a model leaves out of its own learning, it leaves out by cycles.
    pub cycles: &'a [usize],
    /// The run of each row.
    pub runs: &'a [usize],
}

/// Work that is put into a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// Work for one fold of a split: fewer rows, starts and networks.
    Fold,
    /// Work for the model that is kept.
    Whole,
}

/// Reason why nothing was learnt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum FitError {
    /// A covariance or normal matrix has no Cholesky factor.
    #[error("the {0} has no Cholesky factor: features are equal or too large")]
    NotPositive(&'static str),
    /// Too few rows aren't left out.
    #[error("fewer than 10 rows are learnt from once suspect ones and outliers are left out")]
    TooFew,
    /// No network has a finite loss.
    #[error("no network has a finite loss")]
    NoLoss,
    /// A blend was to be learnt as if it were a model.
    #[error("a blend is learnt by its members")]
    NotAlone,
    /// Poisson's loss takes no negative forces.
    #[error("the Poisson loss takes forces of 0 and more; a training row has a negative one")]
    Negative,
}

/// Numbers of a model that was read: finite, and so many.
pub(crate) fn check_numbers(what: &str, numbers: &[f64], count: usize) -> Result<(), String> {
    if numbers.len() != count {
        return Err(format!(
            "{what} must have {count} numbers; it has {}",
            numbers.len()
        ));
    }
    if numbers.iter().any(|x| !x.is_finite()) {
        return Err(format!("{what} has a number that isn't finite"));
    }
    Ok(())
}

/// A deviation of a model that was read.
pub(crate) fn check_deviation(what: &str, deviation: f64) -> Result<(), String> {
    if deviation.is_finite() && deviation > 0.0 {
        Ok(())
    } else {
        Err(format!("{what} must be positive; it is {deviation}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn several_are_as_wide_as_each_and_their_disagreement() {
        let said = |mean: f64, deviation: f64| Prediction { mean, deviation };
        // 1 and 7 are 3 from 4: (3^2 + 5^2)/2 + 3^2 = 26.
        let two = Prediction::together(&[said(7.0, 5.0), said(1.0, 3.0)]);
        assert_eq!((two.mean, two.deviation), (4.0, 26f64.sqrt()));
        // One that is astray widens the interval and leaves the estimate: (3 x 1 + 1^2 + 0 + 10^2)/3.
        let three = Prediction::together(&[said(12.0, 1.0), said(1.0, 1.0), said(2.0, 1.0)]);
        assert_eq!((three.mean, three.deviation), (2.0, (104f64 / 3.0).sqrt()));
        assert_eq!(Prediction::together(&[said(0.1, 0.3)]), said(0.1, 0.3));
    }
}
