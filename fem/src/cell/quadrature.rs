//! Gauss-Legendre rules on the reference interval, square and cube [-1, 1]^d.

/// Points and weights of a rule on [-1, 1]; exact for polynomials up to degree `2 n - 1`.
///
/// Newton's method on the Legendre recurrence, from the asymptotic roots cos(pi (i + 3/4) / (n + 1/2)).
pub(crate) fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    assert!(n > 0, "a rule has at least one point");
    let mut rule: Vec<(f64, f64)> = (0..n).map(|i| root_and_weight(n, i)).collect();
    rule.reverse();
    rule
}

fn root_and_weight(n: usize, i: usize) -> (f64, f64) {
    let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
    let mut slope = 1.0;
    // Newton doubles the digits of the asymptotic start (2 to 3) each time: 8 steps reach any double.
    for _ in 0..8 {
        let (value, derivative) = legendre(n, x);
        slope = derivative;
        x -= value / derivative;
    }
    (x, 2.0 / ((1.0 - x * x) * slope * slope))
}

/// Value and derivative of the Legendre polynomial of degree `n` at `x` inside (-1, 1).
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut previous, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (previous, value) = (
            value,
            ((2.0 * k - 1.0) * x * value - (k - 1.0) * previous) / k,
        );
    }
    (value, n as f64 * (x * value - previous) / (x * x - 1.0))
}

/// Tensor-product rule on the square with this many points along each coordinate, the first running fastest.
pub(crate) fn rectangle(points: [usize; 2]) -> Vec<([f64; 2], f64)> {
    let [line_x, line_y] = points.map(gauss_legendre);
    let mut rule = Vec::with_capacity(points.iter().product());
    for &(y, wy) in &line_y {
        for &(x, wx) in &line_x {
            rule.push(([x, y], wx * wy));
        }
    }
    rule
}

/// Tensor-product rule on the cube with this many points along each coordinate, the first running fastest.
pub fn brick(points: [usize; 3]) -> Vec<([f64; 3], f64)> {
    let [line_x, line_y, line_z] = points.map(gauss_legendre);
    let mut rule = Vec::with_capacity(points.iter().product());
    for &(z, wz) in &line_z {
        for &(y, wy) in &line_y {
            for &(x, wx) in &line_x {
                rule.push(([x, y, z], wx * wy * wz));
            }
        }
    }
    rule
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rule_is_exact_to_its_degree() {
        for n in 1..=6 {
            let rule = gauss_legendre(n);
            for degree in 0..2 * n {
                let integral: f64 = rule.iter().map(|&(x, w)| w * x.powi(degree as i32)).sum();
                let exact = if degree % 2 == 0 {
                    2.0 / (degree as f64 + 1.0)
                } else {
                    0.0
                };
                assert!(
                    (integral - exact).abs() < 4e-16 * 2.0 * n as f64,
                    "n {n} degree {degree}: {integral}"
                );
            }
        }
    }

    #[test]
    fn weights_sum_to_the_volume() {
        assert!((rectangle([4, 3]).iter().map(|p| p.1).sum::<f64>() - 4.0).abs() < 1e-14);
        // At most 27 roundings of partial sums up to 8.
        assert!(
            (brick([3, 1, 2]).iter().map(|p| p.1).sum::<f64>() - 8.0).abs()
                < 27.0 * 8.0 * f64::EPSILON
        );
    }
}
