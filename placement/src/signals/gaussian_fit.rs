//! A Gaussian about 0 by least squares: y = offset + amplitude exp(-x^2 / (2 width^2)).
//!
//! For a given width amplitude and offset are those of a line over the bell, so that only the width is searched: on a coarse grid of widths first, then by golden
//! section between the neighbours of the best (G. H. Golub and V. Pereyra, SIAM J. Numer. Anal. 10, 1973, call it variable projection).

/// Ratio of neighbouring widths of the grid.
const GRID: f64 = 1.1;
/// Golden sections: 0.618^70 of the interval is below rounding.
const SECTIONS: usize = 70;

/// A fitted Gaussian.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GaussianFit {
    /// Height above the offset.
    pub amplitude: f64,
    /// Standard deviation.
    pub width: f64,
    /// Value far away.
    pub offset: f64,
    /// Share of the variance that it explains.
    pub r2: f64,
}

impl GaussianFit {
    /// Fits points (x, y), with a width between the given ones; `None` of fewer than four points, where nothing varies, and where the best width isn't between
    /// them.
    pub fn of(points: &[(f64, f64)], [narrowest, widest]: [f64; 2]) -> Option<Self> {
        let r2 = |width: f64| Self::with_width(points, width).map_or(f64::NEG_INFINITY, |f| f.r2);
        if points.len() < 4 {
            return None;
        }
        let steps = ((widest / narrowest).ln() / GRID.ln()).ceil() as i32;
        let grid: Vec<f64> = (0..=steps).map(|k| narrowest * GRID.powi(k)).collect();
        let best = (0..grid.len()).max_by(|a, b| r2(grid[*a]).total_cmp(&r2(grid[*b])))?;
        let [low, high] = [*grid.get(best.checked_sub(1)?)?, *grid.get(best + 1)?];
        Self::with_width(points, golden_section(low, high, r2))
    }

    /// The best amplitude and offset at a width: the line over the bell.
    fn with_width(points: &[(f64, f64)], width: f64) -> Option<Self> {
        let n = points.len() as f64;
        let bell = |x: f64| (-0.5 * (x / width).powi(2)).exp();
        let mean_b = points.iter().map(|(x, _)| bell(*x)).sum::<f64>() / n;
        let mean_y = points.iter().map(|(_, y)| y).sum::<f64>() / n;
        let (mut bb, mut by, mut yy) = (0.0, 0.0, 0.0);
        for (x, y) in points {
            let (b, y) = (bell(*x) - mean_b, y - mean_y);
            bb += b * b;
            by += b * y;
            yy += y * y;
        }
        let amplitude = by / bb;
        let r2 = amplitude * by / yy;
        r2.is_finite().then(|| Self {
            amplitude,
            width,
            offset: mean_y - amplitude * mean_b,
            r2: r2.min(1.0),
        })
    }
}

/// Finds where a function with one peak between two places has it.
fn golden_section(mut low: f64, mut high: f64, of: impl Fn(f64) -> f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..SECTIONS {
        let (left, right) = (high - ratio * (high - low), low + ratio * (high - low));
        if of(left) < of(right) {
            low = left;
        } else {
            high = right;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTHS: [f64; 2] = [0.5, 60.0];

    fn around(f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        let angles = (-60..=60).map(f64::from);
        angles.map(|x| (x, f(x))).collect()
    }

    #[test]
    fn exact_gaussians_are_recovered() {
        for (amplitude, width, offset) in [
            (0.3, 6.1, 0.05),
            (-2.0, 12.8, 1.0),
            (1e-3, 1.7, 40.0),
            (5.0, 30.0, 0.0),
        ] {
            let points = around(|x| offset + amplitude * (-x * x / (2.0 * width * width)).exp());
            let fit = GaussianFit::of(&points, WIDTHS).expect("a bell");
            // The peak of r2 is flat: a width is known to the root of rounding.
            for (found, exact) in [
                (fit.amplitude, amplitude),
                (fit.width, width),
                (fit.offset, offset),
            ] {
                assert!(
                    (found - exact).abs() < 1e-6 * exact.abs().max(amplitude.abs()),
                    "{fit:?}"
                );
            }
            assert!(fit.r2 > 1.0 - 1e-9, "{fit:?}");
        }
    }

    /// A box of half-width 10 on 121 points: no bell explains it wholly, and the best one is about as wide.
    #[test]
    fn another_shape_is_explained_in_part() {
        let fit = GaussianFit::of(&around(|x| f64::from(x.abs() <= 10.0)), WIDTHS).expect("a bell");
        assert!(
            (5.0..10.0).contains(&fit.width) && (0.8..0.95).contains(&fit.r2),
            "{fit:?}"
        );
    }

    #[test]
    fn what_is_no_bell_has_none() {
        assert_eq!(GaussianFit::of(&around(|_| 1.0), WIDTHS), None);
        assert_eq!(GaussianFit::of(&around(|x| x * x), WIDTHS), None);
        assert_eq!(
            GaussianFit::of(&[(0.0, 1.0), (1.0, 0.5), (2.0, 0.1)], WIDTHS),
            None
        );
        assert_eq!(GaussianFit::of(&around(|_| f64::NAN), WIDTHS), None);
    }
}
