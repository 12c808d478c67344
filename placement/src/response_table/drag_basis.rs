//! Dependence of a response on the ground's shift, by its values at shares of the largest one.
//!
//! Flat ground has two mirror planes, so that a response splits into four parts: even or odd in the shift along the wheel, even or odd in the one across. Each
//! part is a polynomial through the solved shares 0, 1/2 and 1: with the nodes s_i, Lagrange's in s^2 where it is even, and s / s_i times those in s^2 of
//! the nodes 1/2 and 1 where it is odd. On all nine pairs of shares and their images that is the polynomial of degree four in each shift.

/// Shares of the largest shift that are solved, beside none.
pub(crate) const SHARES: [f64; 2] = [0.5, 1.0];

/// Solved shifts, along and across, as numbers of shares: 0 is none. The undragged one isn't among them.
pub(crate) const DRAGS: [[usize; 2]; 8] = [
    [1, 0],
    [2, 0],
    [0, 1],
    [0, 2],
    [1, 1],
    [2, 1],
    [1, 2],
    [2, 2],
];

/// Parts of a response: whether each is odd in the shift along, and in the one across.
pub(crate) const PARTS: [[bool; 2]; 4] =
    [[false, false], [true, false], [false, true], [true, true]];

/// Products of a drag and a part.
pub(crate) const PRODUCTS: usize = DRAGS.len() * PARTS.len();

/// Returns what each part of each drag's response, less the undragged one, contributes at a shift, as shares of the largest along and across: by drag, then
/// part.
pub fn products(shares: [f64; 2]) -> [f64; PRODUCTS] {
    let even = shares.map(even);
    let odd = shares.map(odd);
    let mut products = [0.0; PRODUCTS];
    for (d, drag) in DRAGS.iter().enumerate() {
        for (p, part) in PARTS.iter().enumerate() {
            let factor = |axis: usize| match part[axis] {
                false => even[axis][drag[axis]],
                true => odd[axis][drag[axis]],
            };
            products[d * PARTS.len() + p] = factor(0) * factor(1);
        }
    }
    products
}

/// Even polynomials that are one at 0, 1/2 or 1 and vanish at the two others.
fn even(share: f64) -> [f64; 3] {
    let [a, b] = SHARES.map(|node| node * node);
    let x = share * share;
    [
        (x - a) * (x - b) / (a * b),
        x * (x - b) / (a * (a - b)),
        x * (x - a) / (b * (b - a)),
    ]
}

/// Odd polynomials that are one at 1/2 or 1 and vanish at the other; none belongs to 0.
fn odd(share: f64) -> [f64; 3] {
    let [a, b] = SHARES.map(|node| node * node);
    let x = share * share;
    [
        0.0,
        share / SHARES[0] * (x - b) / (a - b),
        share / SHARES[1] * (x - a) / (b - a),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Interpolates a response by the products: its parts at the drags, taken apart by its four images.
    fn interpolated(response: impl Fn(f64, f64) -> f64, at: [f64; 2]) -> f64 {
        let products = products(at);
        let mut sum = response(0.0, 0.0);
        for (d, drag) in DRAGS.iter().enumerate() {
            let share = |axis: usize| match drag[axis] {
                0 => 0.0,
                node => SHARES[node - 1],
            };
            let [x, y] = [share(0), share(1)];
            for (p, part) in PARTS.iter().enumerate() {
                let signs = part.map(|odd| if odd { -1.0 } else { 1.0 });
                let images = response(x, y)
                    + signs[0] * response(-x, y)
                    + signs[1] * response(x, -y)
                    + signs[0] * signs[1] * response(-x, -y);
                let undragged = if part == &[false; 2] {
                    response(0.0, 0.0)
                } else {
                    0.0
                };
                sum += products[d * PARTS.len() + p] * (0.25 * images - undragged);
            }
        }
        sum
    }

    #[test]
    fn polynomials_of_degree_four_are_met() {
        let response = |x: f64, y: f64| {
            1.0 + 0.3 * x - 0.7 * y + 2.0 * x * y + 0.5 * x * x - y * y * x + x.powi(3) * y.powi(4)
                - 0.2 * y.powi(3) * x.powi(2)
                + x.powi(4)
        };
        for at in [
            [0.0, 0.0],
            [0.3, -0.8],
            [-0.9, 0.1],
            [1.0, 1.0],
            [-0.5, -0.5],
        ] {
            let found = interpolated(response, at);
            assert!(
                (found - response(at[0], at[1])).abs() < 1e-12,
                "{at:?} {found}"
            );
        }
    }

    #[test]
    fn sliding_is_met_to_its_third_difference() {
        // Mindlin's pull of a ball that slips at its rim, over the load times the coefficient: 1 - (1 - s)^(3/2). Its square term has the sign of s, which no
        // polynomial has: the rest is at most 0.375 max |s |s| - (a s + b s^3)| = 0.375 x 0.055 with a = 1/3 and b = 2/3, and the higher terms a tenth of it.
        let pull = |s: f64| 0.7 * s.signum() * (1.0 - (1.0 - 0.7 * s.abs()).powf(1.5));
        for k in -10..=10 {
            let s = 0.1 * f64::from(k);
            let found = interpolated(|x, _| pull(x), [s, 0.3]);
            assert!(
                (found - pull(s)).abs() < 0.375 * 0.055 * 0.7f64.powi(3) * 1.1,
                "{s}: {}",
                found - pull(s)
            );
        }
    }
}
