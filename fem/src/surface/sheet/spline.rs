//! Quadratic B-splines on uniform spans, whose slopes are continuous: a sheet made of them bends without hinges.
//!
//! The knots at both ends are threefold, so that the outermost functions are one there. The function with number i + k is nonzero on span i for k = 0, 1, 2
//! (L. Piegl and W. Tiller, The NURBS Book, 2nd ed., 1997, section 2.2).

/// Values, first and second derivatives of the three functions on a span; lengths in spans.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Basis {
    pub(super) values: [f64; 3],
    pub(super) first: [f64; 3],
    pub(super) second: [f64; 3],
}

/// Functions on a line of `spans`.
pub(super) fn function_count(spans: usize) -> usize {
    spans + 2
}

/// The functions of span `span` out of `spans`, at the share `t` of it, 0 to 1.
pub(super) fn basis(spans: usize, span: usize, t: f64) -> Basis {
    // Widths of the supports of the first and the last function within and beside this span: knots at the ends coincide.
    let before = if span == 0 { 1.0 } else { 2.0 };
    let after = if span + 1 == spans { 1.0 } else { 2.0 };
    let rest = 1.0 - t;
    let [low, high] = [rest * rest / before, t * t / after];
    let [low_1, high_1] = [-2.0 * rest / before, 2.0 * t / after];
    let [low_2, high_2] = [2.0 / before, 2.0 / after];
    Basis {
        values: [low, 1.0 - low - high, high],
        first: [low_1, -low_1 - high_1, high_1],
        second: [low_2, -low_2 - high_2, high_2],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients whose spline is x^2 on `spans` spans: products of the two inner knots of each function (polar form).
    fn square(spans: usize) -> Vec<f64> {
        let knot = |j: usize| (j.saturating_sub(2).min(spans)) as f64;
        (0..function_count(spans))
            .map(|i| knot(i + 1) * knot(i + 2))
            .collect()
    }

    #[test]
    fn a_parabola_is_exact_with_both_derivatives() {
        for spans in [1, 2, 5] {
            let coefficients = square(spans);
            for span in 0..spans {
                for t in [0.0, 0.3, 1.0] {
                    let x = span as f64 + t;
                    let basis = basis(spans, span, t);
                    let sum = |weights: [f64; 3]| -> f64 {
                        (0..3).map(|k| weights[k] * coefficients[span + k]).sum()
                    };
                    assert!((sum(basis.values) - x * x).abs() < 1e-13);
                    assert!((sum(basis.first) - 2.0 * x).abs() < 1e-13);
                    assert!((sum(basis.second) - 2.0).abs() < 1e-13);
                }
            }
        }
    }

    #[test]
    fn neighbouring_spans_meet_with_the_same_slope() {
        for spans in [2, 3, 6] {
            for span in 1..spans {
                let (left, right) = (basis(spans, span - 1, 1.0), basis(spans, span, 0.0));
                for k in 0..2 {
                    assert!((left.values[k + 1] - right.values[k]).abs() < 1e-15);
                    assert!((left.first[k + 1] - right.first[k]).abs() < 1e-15);
                }
                assert!(left.values[0].abs() < 1e-15 && left.first[0].abs() < 1e-15);
            }
        }
    }
}
