//! Shifted product that fits the check points best.
//!
//! The family h0 + (prod_i (1 + t d_i) - 1)/t (equation (7) of `mdrm`) is smooth in t, from M-DRM at t = 1/h0 through the
//! additive form at t = 0. t is fitted to the values at the check points by Gauss-Newton steps from both of these ends;
//! where only two coordinates of a point leave the cut, the first step from t = 0 is the closed solution.

use crate::design::CheckPoint;
use crate::form::mdrm::departure;
use crate::form::section::Sections;

/// Quadratic convergence from a start in its basin takes five or six.
const STEPS: usize = 12;
/// Relative size of the last step, and of what rounding adds to a squared misfit that falls no more.
const ARRIVED: f64 = 1e-14;
const LEVEL: f64 = 1e-9;

/// The t with the least squared misfit found, and never a worse one than both ends have.
pub(crate) fn fit(sections: &Sections, checks: &[(&CheckPoint, f64)]) -> f64 {
    let ends = [0.0, 1.0 / sections.centre];
    let finite = ends.into_iter().filter(|t| t.is_finite());
    let fitted = finite.map(|start| descend(sections, checks, start));
    let best = fitted.min_by(|a, b| a.1.total_cmp(&b.1));
    best.map_or(0.0, |(t, _)| t)
}

fn descend(sections: &Sections, checks: &[(&CheckPoint, f64)], start: f64) -> (f64, f64) {
    let mut t = start;
    let (mut square, mut step) = misfit(sections, checks, t);
    for _ in 0..STEPS {
        let (there, next) = misfit(sections, checks, t + step);
        if there.is_nan() || there > square * (1.0 + LEVEL) {
            break;
        }
        t += step;
        if step.abs() <= ARRIVED * t.abs() {
            break;
        }
        (square, step) = (there, next);
    }
    (t, square)
}

/// Squared misfit at t, and the Gauss-Newton step from there.
fn misfit(sections: &Sections, checks: &[(&CheckPoint, f64)], t: f64) -> (f64, f64) {
    let (mut square, mut slope, mut curvature) = (0.0, 0.0, 0.0);
    for (check, h) in checks {
        // f as in `departure`, and its derivative to t
        let (mut f, mut f_t) = (0.0, 0.0);
        for d in sections.differences_at(check) {
            f_t += f * d + t * f_t * d;
            f += d + t * f * d;
        }
        let residual = h - sections.centre - f;
        square += residual * residual;
        slope += residual * f_t;
        curvature += f_t * f_t;
    }
    let step = if curvature > 0.0 {
        slope / curvature
    } else {
        0.0
    };
    (square, step)
}

/// The form at t, at a check point.
pub(crate) fn predict(sections: &Sections, check: &CheckPoint, t: f64) -> f64 {
    sections.centre + departure(t, sections.differences_at(check))
}

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;

    use super::*;
    use crate::design::Design;
    use crate::law::distribution::Distribution;

    /// Fitted t, and the t of the model, for c + prod (1 + a_i x_i) with x uniform on [-1, 1].
    fn fitted(constant: f64, checks: usize) -> (f64, f64) {
        let inputs = vec![Distribution::uniform(-1.0, 1.0).unwrap(); 4];
        let design = Design::new(&inputs, 5, checks, &mut ChaCha8Rng::seed_from_u64(3)).unwrap();
        let model = |x: &[f64]| {
            let factors = x.iter().zip([0.5, 0.3, -0.6, 0.9]);
            constant + factors.map(|(x, a)| 1.0 + a * x).product::<f64>()
        };
        let values: Vec<f64> = design.points().iter().map(|x| model(x)).collect();
        let sections = Sections::new(&design, &values).unwrap();
        let unit = 2f64.powi(sections.exponent);
        let checks: Vec<(&CheckPoint, f64)> = design
            .checks()
            .iter()
            .map(|check| (check, values[check.ordinal()] / unit))
            .collect();
        // h - c is the product, with the value 1 at the cut
        (fit(&sections, &checks), unit)
    }

    #[test]
    fn a_shifted_product_is_found_again() {
        for constant in [10.0, -0.9, -3.0, 1000.0, 0.0] {
            let (t, expected) = fitted(constant, 5);
            // the values have lost |c| eps of the product's interactions, of order 0.1
            let tolerance = 1e-12 + 100.0 * f64::EPSILON * constant.abs();
            assert!((t / expected - 1.0).abs() < tolerance, "{constant} {t}");
        }
    }
}
