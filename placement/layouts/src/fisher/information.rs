//! Fisher information of a few unknowns, and what it says of their errors.

/// Most unknowns: contact angle, depth, and the ground's shift along and across.
pub const MOST: usize = 4;
/// Pivot over its diagonal below which an unknown can't be told from those before it: rounding of the sums.
const SINGULAR: f64 = 1e-12;
/// Share in the blind direction from which an unknown counts as blind.
const PART: f64 = 1e-3;

/// A symmetric matrix of the first `count` unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Information {
    count: usize,
    matrix: [[f64; MOST]; MOST],
}

/// The unknowns that can't be told from each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Blind(pub [bool; MOST]);

impl Information {
    /// Begins without any information on so many unknowns.
    ///
    /// # Panics
    /// With more than [`MOST`].
    pub fn of(count: usize) -> Self {
        assert!(count <= MOST, "{count} unknowns");
        Self {
            count,
            matrix: [[0.0; MOST]; MOST],
        }
    }

    /// Adds a measurement with these derivatives and this variance.
    pub fn add(&mut self, slopes: &[f64], variance: f64) {
        for i in 0..self.count {
            for j in 0..self.count {
                self.matrix[i][j] += slopes[i] * slopes[j] / variance;
            }
        }
    }

    /// Takes the information off that is hidden along these derivatives.
    pub fn take(&mut self, slopes: &[f64; MOST]) {
        for i in 0..self.count {
            for j in 0..self.count {
                self.matrix[i][j] -= slopes[i] * slopes[j];
            }
        }
    }

    /// Adds what is known before: independent standard deviations.
    #[must_use]
    pub fn with_prior(mut self, deviations: &[f64]) -> Self {
        for (i, deviation) in deviations.iter().take(self.count).enumerate() {
            self.matrix[i][i] += deviation.powi(-2);
        }
        self
    }

    /// The matrix' entry.
    pub fn entry(&self, i: usize, j: usize) -> f64 {
        self.matrix[i][j]
    }

    /// Least standard deviations of unbiased estimates: roots of the inverse's diagonal (Cramer and Rao).
    ///
    /// # Errors
    /// [`Blind`] when the matrix is singular or not finite.
    pub fn deviations(&self) -> Result<[f64; MOST], Blind> {
        let factor = self.factor()?;
        let mut deviations = [0.0; MOST];
        for (unknown, deviation) in deviations.iter_mut().enumerate().take(self.count) {
            let mut unit = [0.0; MOST];
            unit[unknown] = 1.0;
            *deviation = self.length(&factor, &unit);
        }
        Ok(deviations)
    }

    /// Least standard deviation of an unbiased estimate of what has these derivatives by the unknowns.
    ///
    /// # Errors
    /// See [`deviations`](Self::deviations).
    pub fn deviation_of(&self, slopes: &[f64; MOST]) -> Result<f64, Blind> {
        Ok(self.length(&self.factor()?, slopes))
    }

    /// Solution of the normal equations with this right side: what the unknowns are estimated to be.
    ///
    /// # Errors
    /// See [`deviations`](Self::deviations).
    pub fn estimate(&self, right: &[f64; MOST]) -> Result<[f64; MOST], Blind> {
        let factor = self.factor()?;
        let mut solved = [0.0; MOST];
        for i in 0..self.count {
            let before: f64 = (0..i).map(|k| factor[i][k] * solved[k]).sum();
            solved[i] = (right[i] - before) / factor[i][i];
        }
        for i in (0..self.count).rev() {
            let after: f64 = (i + 1..self.count).map(|k| factor[k][i] * solved[k]).sum();
            solved[i] = (solved[i] - after) / factor[i][i];
        }
        Ok(solved)
    }

    /// Root of a form with the inverse: the length of the half solved vector.
    fn length(&self, factor: &[[f64; MOST]; MOST], vector: &[f64; MOST]) -> f64 {
        let mut half = [0.0; MOST];
        for i in 0..self.count {
            let before: f64 = (0..i).map(|k| factor[i][k] * half[k]).sum();
            half[i] = (vector[i] - before) / factor[i][i];
        }
        half.iter().map(|x| x * x).sum::<f64>().sqrt()
    }

    /// Cholesky's factor, by rows.
    fn factor(&self) -> Result<[[f64; MOST]; MOST], Blind> {
        let mut factor = [[0.0; MOST]; MOST];
        for j in 0..self.count {
            for i in j..self.count {
                let before: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
                let rest = self.matrix[i][j] - before;
                if i > j {
                    factor[i][j] = rest / factor[j][j];
                } else if rest > SINGULAR * self.matrix[j][j] && rest.is_finite() {
                    factor[j][j] = rest.sqrt();
                } else {
                    return Err(self.blind(j, &factor));
                }
            }
        }
        Ok(factor)
    }

    /// The unknowns in the direction without information, where the factor ends at unknown `last`.
    fn blind(&self, last: usize, factor: &[[f64; MOST]; MOST]) -> Blind {
        // L' v = -l, with l the rows before `last`: v makes the form vanish. In units of each unknown's own information.
        let mut direction = [0.0; MOST];
        direction[last] = 1.0;
        for i in (0..last).rev() {
            let after: f64 = (i + 1..=last).map(|k| factor[k][i] * direction[k]).sum();
            direction[i] = -after / factor[i][i];
        }
        let size = |i: usize| direction[i].abs() * self.matrix[i][i].sqrt();
        let largest = (0..last).map(size).fold(0.0, f64::max);
        let mut blind = [false; MOST];
        for (i, blind) in blind.iter_mut().enumerate().take(last) {
            *blind = largest > 0.0 && size(i) > PART * largest && size(last) > 0.0;
        }
        blind[last] = true;
        Blind(blind)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_estimate_solves_the_normal_equations() {
        let mut information = Information::of(3);
        information.add(&[2.0, 1.0, 0.0], 0.25);
        information.add(&[0.0, 3.0, -1.0], 1.0);
        information.add(&[1.0, 0.0, 5.0], 4.0);
        // [[16.25, 8, 1.25], [8, 13, -3], [1.25, -3, 7.25]] times (1, -2, 3).
        let found = information
            .estimate(&[4.0, -27.0, 29.0, 0.0])
            .expect("regular");
        for (found, expected) in found.iter().zip([1.0, -2.0, 3.0, 0.0]) {
            assert!((found - expected).abs() < 1e-12, "{found}");
        }
    }

    #[test]
    fn deviations_are_those_of_the_inverse() {
        let mut information = Information::of(3);
        information.add(&[2.0, 1.0, 0.0], 0.25);
        information.add(&[0.0, 3.0, -1.0], 1.0);
        information.add(&[1.0, 0.0, 5.0], 4.0);
        // The matrix [[16.25, 8, 1.25], [8, 13, -3], [1.25, -3, 7.25]], determinant 812.25: cofactors on the diagonal 85.25, 116.25, 147.25.
        let found = information.deviations().expect("regular");
        let determinant: f64 = 16.25 * 85.25 - 8.0 * (8.0 * 7.25 + 3.75) + 1.25 * (-24.0 - 16.25);
        for (found, cofactor) in found.iter().zip([85.25, 116.25, 147.25]) {
            let expected: f64 = (cofactor / determinant).sqrt();
            assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        }
        let alone = Information::of(2)
            .with_prior(&[104.0, 1.0])
            .deviations()
            .expect("a prior is enough");
        assert!((alone[0] - 104.0).abs() < 1e-12 && (alone[1] - 1.0).abs() < 1e-15);
    }

    #[test]
    fn what_is_blind_is_named() {
        // Angle and depth always change together; the shift along stands apart.
        let mut information = Information::of(3);
        information.add(&[1.0, 2.0, 0.0], 1.0);
        information.add(&[2.0, 4.0, 0.0], 1.0);
        information.add(&[0.0, 0.0, 1.0], 1.0);
        assert_eq!(
            information.deviations(),
            Err(Blind([true, true, false, false]))
        );
        // Nothing is known of the depth.
        let mut information = Information::of(2);
        information.add(&[1.0, 0.0], 1.0);
        assert_eq!(
            information.deviations(),
            Err(Blind([false, true, false, false]))
        );
        // No variance: nothing finite.
        information.add(&[1.0, 1.0], 0.0);
        assert!(information.deviations().is_err());
    }
}
