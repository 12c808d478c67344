//! Errors over a scale: how many, their root mean square, the worst.

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

    /// The largest absolute one; 0 of none.
    pub fn worst(&self) -> f64 {
        self.worst
    }
}
