//! Errors over a scale: how many, their root mean square, the worst, and what others like them stay within.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Squares of errors and the largest of them.
#[derive(Default)]
pub(crate) struct Errors {
    squares: f64,
    count: usize,
    worst: f64,
}

impl Errors {
    /// Adds what was found less what was expected, over a scale.
    pub fn compare(&mut self, found: &[f64], expected: &[f64], scale: f64) {
        let errors = found.iter().zip(expected).map(|(a, b)| a - b);
        self.add(errors, scale);
    }

    /// Adds errors over a scale.
    pub fn add(&mut self, errors: impl IntoIterator<Item = f64>, scale: f64) {
        for error in errors {
            let error = error / scale;
            self.squares += error * error;
            self.count += 1;
            self.worst = self.worst.max(error.abs());
        }
    }

    /// Counts the errors.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Root mean square; 0 of none.
    pub fn rms(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }

    /// Bound that 95 % of errors at other contacts like these stay within, where errors at one contact go together: their root mean square times the quantile of Student's t with as
    /// many degrees of freedom as contacts. Infinite of none.
    pub fn claim(&self, contacts: usize) -> f64 {
        let student = StudentsT::new(0.0, 1.0, contacts as f64);
        student.map_or(f64::INFINITY, |student| {
            self.rms() * student.inverse_cdf(0.975)
        })
    }

    /// The largest absolute one; 0 of none.
    pub fn worst(&self) -> f64 {
        self.worst
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_contacts_claim_more_than_many() {
        let mut errors = Errors::default();
        errors.add([3.0, -4.0], 2.0);
        let rms = 12.5_f64.sqrt() / 2.0;
        // Tables of Student's t: 3.182446 for three degrees of freedom, 2.042272 for thirty, 1.962339 for a thousand.
        for (contacts, quantile) in [(3, 3.182_446), (30, 2.042_272), (1000, 1.962_339)] {
            assert!((errors.claim(contacts) / rms - quantile).abs() < 1e-6);
        }
        assert_eq!(errors.claim(0), f64::INFINITY);
    }
}
