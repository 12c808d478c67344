//! Error of a mesh, from its results and those of a coarser one.

/// Safety on the estimate: the two meshes may not be asymptotic yet.
const SAFETY: f64 = 2.0;

/// Points of one curve on a coarse and a fine mesh. Errors are taken over the whole curve, at their largest: where the
/// leading term of the error changes sign along the curve, a single point has no slope.
#[derive(Debug, Clone)]
pub(crate) struct Refinement {
    coarse: Vec<f64>,
    fine: Vec<f64>,
    /// Element size of the coarse over that of the fine mesh.
    ratio: f64,
}

impl Refinement {
    /// Two curves of equal length.
    pub fn new(coarse: Vec<f64>, fine: Vec<f64>, ratio: f64) -> Self {
        Self {
            coarse,
            fine,
            ratio,
        }
    }

    /// Bound of the fine curve's relative error, by Richardson: the difference of the meshes over ratio^slope - 1, with a
    /// safety of two.
    pub fn bound(&self, slope: f64) -> f64 {
        SAFETY * distance(&self.coarse, &self.fine) / (self.ratio.powf(slope) - 1.0)
    }

    /// Observed slope towards the exact curve.
    pub fn slope(&self, exact: &[f64]) -> f64 {
        let reduction = distance(&self.coarse, exact) / distance(&self.fine, exact);
        reduction.ln() / self.ratio.ln()
    }
}

/// Largest relative difference of two curves.
fn distance(values: &[f64], reference: &[f64]) -> f64 {
    let pairs = values.iter().zip(reference);
    pairs.map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max)
}

/// Graded division of [0, 1] into cells: cell boundaries at (k / cells)^exponent, uniform within each cell, so that
/// middle nodes stay in the middle.
pub(crate) fn graded(s: f64, cells: usize, exponent: f64) -> f64 {
    let cell = (s * cells as f64).floor().min(cells as f64 - 1.0);
    let boundary = |k: f64| (k / cells as f64).powf(exponent);
    let (low, high) = (boundary(cell), boundary(cell + 1.0));
    low + (s * cells as f64 - cell) * (high - low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_is_recognised() {
        let curve = |h: f64| vec![3.0 + 0.5 * h.powi(4), 2.0 - 0.1 * h.powi(4)];
        let refinement = Refinement::new(curve(0.2), curve(0.1), 2.0);
        assert!((refinement.slope(&[3.0, 2.0]) - 4.0).abs() < 1e-6);
        let error = curve(0.1)[0] / 3.0 - 1.0;
        // The bound refers to the fine value, the error to the exact one: they differ by the error itself, 2e-5.
        assert!((refinement.bound(4.0) / (2.0 * error) - 1.0).abs() < 1e-4);
    }

    #[test]
    fn a_graded_line_keeps_its_ends_and_its_middle_nodes() {
        assert_eq!([0.0, 1.0].map(|s| graded(s, 4, 2.0)), [0.0, 1.0]);
        assert_eq!(graded(0.25, 4, 2.0), 1.0 / 16.0);
        assert_eq!(graded(0.375, 4, 2.0), 0.5 * (1.0 / 16.0 + 4.0 / 16.0));
    }
}
