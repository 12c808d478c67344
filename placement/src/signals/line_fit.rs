//! The line of least squares through points.

/// A line through points, and how well it explains them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineFit {
    /// Rise of the line.
    pub slope: f64,
    /// Share of the variance that it explains; `None` of fewer than three points, and where nothing varies.
    pub r2: Option<f64>,
}

impl LineFit {
    /// Fits points (x, y); `None` of fewer than two different x.
    pub fn of(points: &[(f64, f64)]) -> Option<Self> {
        let n = points.len() as f64;
        let mean = |part: fn(&(f64, f64)) -> f64| points.iter().map(part).sum::<f64>() / n;
        let (mean_x, mean_y) = (mean(|point| point.0), mean(|point| point.1));
        let sum = |of: fn(f64, f64) -> f64| -> f64 {
            let parts = points.iter().map(|(x, y)| of(x - mean_x, y - mean_y));
            parts.sum()
        };
        let (xx, xy, yy) = (sum(|x, _| x * x), sum(|x, y| x * y), sum(|_, y| y * y));
        let explained = xy * xy / (xx * yy);
        (xx > 0.0).then(|| Self {
            slope: xy / xx,
            r2: (points.len() > 2 && explained.is_finite()).then(|| explained.min(1.0)),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exact_line_has_its_slope_and_explains_all() {
        let on_line = |x: f64| (x, 3.0 - 0.25 * x);
        let fit = LineFit::of(&[0.0, 5.0, 10.0, 30.0].map(on_line)).expect("a line");
        assert!((fit.slope + 0.25).abs() < 1e-15);
        assert!((fit.r2.expect("varies") - 1.0).abs() < 1e-14);
    }

    /// Figures by hand: x 0 1 2, y 0 1 0: the line is flat, and explains nothing.
    #[test]
    fn a_line_through_other_points_explains_what_it_does() {
        let fit = |ys: [f64; 3]| LineFit::of(&[(0.0, ys[0]), (1.0, ys[1]), (2.0, ys[2])]);
        let bent = fit([0.0, 1.0, 0.0]).expect("a line");
        assert_eq!((bent.slope, bent.r2), (0.0, Some(0.0)));
        let rising = fit([0.0, 1.0, 1.0]).expect("a line");
        assert!((rising.slope - 0.5).abs() < 1e-15);
        assert!((rising.r2.expect("varies") - 0.75).abs() < 1e-14);
        assert_eq!(fit([2.0; 3]).expect("a line").r2, None);
    }

    #[test]
    fn few_points_have_no_line_and_two_no_share() {
        assert_eq!(LineFit::of(&[]), None);
        assert_eq!(LineFit::of(&[(1.0, 2.0)]), None);
        let two = LineFit::of(&[(0.0, 1.0), (2.0, 5.0)]).expect("a line");
        assert_eq!((two.slope, two.r2), (2.0, None));
    }
}
