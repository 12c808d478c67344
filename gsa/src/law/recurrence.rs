//! Orthogonal polynomials of a probability law, by their three-term recurrence.
//!
//! With p_k orthonormal for the law (E\[p_j p_k\] = 1 if j = k, else 0),
//!
//! ```text
//! sqrt(b_{k+1}) p_{k+1}(t) = (t - a_k) p_k(t) - sqrt(b_k) p_{k-1}(t),    p_0 = 1,  p_{-1} = 0
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | a_k, b_k | recurrence coefficients of the monic polynomials |
//! | N | size of the Gauss rule: its nodes are the zeros of p_N |
//!
//! Coefficients: W. Gautschi, *Orthogonal Polynomials: Computation and Approximation*, Oxford 2004, table 1.1.

/// The first N coefficients of a law's recurrence, with the off-diagonal already rooted.
#[derive(Debug, Clone)]
pub(crate) struct Recurrence {
    /// a_0 .. a_{N-1}
    diagonal: Vec<f64>,
    /// sqrt(b_1) .. sqrt(b_{N-1})
    off_diagonal: Vec<f64>,
}

impl Recurrence {
    /// Legendre: the uniform law on \[-1, 1\]; a_k = 0, b_k = k^2 / (4 k^2 - 1).
    pub(crate) fn legendre(size: usize) -> Self {
        Self::symmetric(size, |k| k * k / (4.0 * k * k - 1.0))
    }

    /// Probabilists' Hermite: the standard normal law; a_k = 0, b_k = k.
    pub(crate) fn hermite(size: usize) -> Self {
        Self::symmetric(size, |k| k)
    }

    /// A law symmetric about zero, from b_k.
    pub(crate) fn symmetric(size: usize, b: impl Fn(f64) -> f64) -> Self {
        Self::general(size, |_| 0.0, b)
    }

    /// Computes the recurrence from a_k and b_k.
    pub(crate) fn general(size: usize, a: impl Fn(f64) -> f64, b: impl Fn(f64) -> f64) -> Self {
        Self {
            diagonal: (0..size).map(|k| a(k as f64)).collect(),
            off_diagonal: (1..size).map(|k| b(k as f64).sqrt()).collect(),
        }
    }

    /// Makes a recurrence of a_0 .. a_{N-1} and sqrt(b_1) .. sqrt(b_{N-1}).
    pub(crate) fn from_coefficients(diagonal: Vec<f64>, off_diagonal: Vec<f64>) -> Self {
        Self {
            diagonal,
            off_diagonal,
        }
    }

    pub(crate) fn size(&self) -> usize {
        self.diagonal.len()
    }

    pub(crate) fn diagonal(&self) -> &[f64] {
        &self.diagonal
    }

    pub(crate) fn off_diagonal(&self) -> &[f64] {
        &self.off_diagonal
    }

    /// A law symmetric about zero has no diagonal.
    pub(crate) fn is_symmetric(&self) -> bool {
        self.diagonal.iter().all(|&a| a == 0.0)
    }

    /// p_0(t) .. p_{N-1}(t).
    pub(crate) fn orthonormal(&self, t: f64) -> Vec<f64> {
        let mut p = Vec::with_capacity(self.size());
        p.push(1.0);
        for k in 1..self.size() {
            let before = if k > 1 {
                self.off_diagonal[k - 2] * p[k - 2]
            } else {
                0.0
            };
            p.push(((t - self.diagonal[k - 1]) * p[k - 1] - before) / self.off_diagonal[k - 1]);
        }
        p
    }

    /// The Newton step r/r' towards a zero of p_N, where r = sqrt(b_N) p_N.
    pub(crate) fn newton_step(&self, t: f64) -> f64 {
        let (mut p, mut p_before) = (1.0, 0.0);
        let (mut slope, mut slope_before) = (0.0, 0.0);
        for k in 0..self.size() {
            let back = if k > 0 { self.off_diagonal[k - 1] } else { 0.0 };
            // The last row is left unscaled: the step does not depend on b_N.
            let scale = self.off_diagonal.get(k).copied().unwrap_or(1.0);
            let next = ((t - self.diagonal[k]) * p - back * p_before) / scale;
            let next_slope = (p + (t - self.diagonal[k]) * slope - back * slope_before) / scale;
            (p_before, p) = (p, next);
            (slope_before, slope) = (slope, next_slope);
        }
        p / slope
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn legendre_polynomials_are_the_closed_ones() {
        // orthonormal for the uniform law: sqrt(2k+1) P_k
        let t: f64 = 0.3;
        let p = Recurrence::legendre(4).orthonormal(t);
        let closed = [
            1.0,
            3f64.sqrt() * t,
            5f64.sqrt() * (3.0 * t * t - 1.0) / 2.0,
            7f64.sqrt() * (5.0 * t * t * t - 3.0 * t) / 2.0,
        ];
        for (value, expected) in p.iter().zip(closed) {
            assert!(
                (value - expected).abs() < 4.0 * f64::EPSILON,
                "{value} {expected}"
            );
        }
    }

    #[test]
    fn hermite_polynomials_are_the_closed_ones() {
        let t: f64 = 1.7;
        let p = Recurrence::hermite(4).orthonormal(t);
        let closed = [
            1.0,
            t,
            (t * t - 1.0) / 2f64.sqrt(),
            (t * t * t - 3.0 * t) / 6f64.sqrt(),
        ];
        for (value, expected) in p.iter().zip(closed) {
            assert!(
                (value - expected).abs() < 8.0 * f64::EPSILON,
                "{value} {expected}"
            );
        }
    }

    #[test]
    fn newton_step_vanishes_at_a_zero() {
        // zeros of He_3 are 0 and +-sqrt(3)
        let hermite = Recurrence::hermite(3);
        assert_eq!(hermite.newton_step(0.0), 0.0);
        assert!(hermite.newton_step(3f64.sqrt()).abs() < 4.0 * f64::EPSILON);
    }
}
