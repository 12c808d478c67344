//! Transfer from the bare wall's strains to the tensions of a glued film, by a matrix that two equilibria give: N = T e.

/// Largest ratio of the singular values of the strains that still give a matrix.
const WORST_CONDITION: f64 = 1e6;

/// Tensions along and across, N/mm, by the bare wall's strains along and across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TensionTransfer([[f64; 2]; 2]);

impl TensionTransfer {
    /// Fits the matrix to the strains and the tensions of two equilibria.
    ///
    /// # Errors
    /// When the strains are so nearly proportional that they don't tell the two directions apart.
    pub fn of(strains: [[f64; 2]; 2], tensions: [[f64; 2]; 2]) -> Result<Self, String> {
        let [[a, b], [c, d]] = strains;
        let determinant = a * d - b * c;
        // The sum of the squared singular values over their product is the condition with its inverse.
        let squares = a * a + b * b + c * c + d * d;
        let both = squares / determinant.abs();
        let condition = 0.5 * (both + (both * both - 4.0).max(0.0).sqrt());
        if !condition.is_finite() || condition > WORST_CONDITION {
            return Err(
                "the strains of the two loads are proportional: they give no transfer".to_owned(),
            );
        }
        // Each row of T times the two strains is that row of the tensions: Cramer's rule.
        let row = |k: usize| {
            let [n, m] = [tensions[0][k], tensions[1][k]];
            [(n * d - m * b) / determinant, (m * a - n * c) / determinant]
        };
        Ok(Self([row(0), row(1)]))
    }

    /// Tensions along and across, N/mm, of a film where the bare wall has these strains.
    pub fn tension(&self, strain: [f64; 2]) -> [f64; 2] {
        self.0.map(|row| row[0] * strain[0] + row[1] * strain[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const T: TensionTransfer = TensionTransfer([[3.0, -1.5], [0.4, 7.0]]);

    #[test]
    fn a_known_matrix_is_recovered_from_two_equilibria() {
        let strains = [[1e-3, 4e-3], [3e-3, 9e-3]];
        let found = TensionTransfer::of(strains, strains.map(|e| T.tension(e))).expect("regular");
        for (row, expected) in found.0.iter().flatten().zip(T.0.iter().flatten()) {
            assert!((row - expected).abs() < 1e-12, "{found:?}");
        }
        let other = [-2e-3, 5e-4];
        for (a, b) in found.tension(other).iter().zip(T.tension(other)) {
            assert!((a - b).abs() < 1e-15);
        }
    }

    #[test]
    fn proportional_strains_give_none() {
        for strains in [
            [[1e-3, 2e-3], [2e-3, 4e-3]],
            [[1e-3, 2e-3], [1e-3, 2e-3 + 1e-10]],
            [[0.0; 2]; 2],
            [[f64::NAN; 2]; 2],
        ] {
            assert!(
                TensionTransfer::of(strains, [[1.0; 2]; 2]).is_err(),
                "{strains:?}"
            );
        }
        // Singular values 1 and 2e-6: just regular enough.
        assert!(TensionTransfer::of([[1.0, 0.0], [0.0, 2e-6]], [[1.0; 2]; 2]).is_ok());
    }
}
