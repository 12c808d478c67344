//! The coordinate in which a law's polynomials are computed: where small nodes must keep their digits, folded.
//!
//! | basis | node | used where |
//! |---|---|---|
//! | plain | x = origin + scale t | the spread is not far below the distance from both ends |
//! | folded | x = origin + scale t^2 | the law crowds at one end, the origin |
//!
//! A law of u >= 0 and the law of t = +-sqrt(u), either sign equally likely, share their polynomials: p_k(u) = P_2k(t)
//! (Gautschi 2004, theorem 1.18). The law of t is symmetric, so its recurrence is the b_k alone, all positive: nothing
//! cancels, and nodes come out with full relative accuracy in u even where they span twenty orders of magnitude.

use crate::law::golub_welsch;
use crate::law::recurrence::Recurrence;

/// A law further than this many standard deviations from both of its ends gains nothing from folding, and would lose
/// as many eps as that.
const FARTHEST_FOLD: f64 = 4.0;

/// Whether a law with this mean distance from an end crowds there.
pub(crate) fn crowds(mean_distance: f64, std: f64) -> bool {
    mean_distance <= FARTHEST_FOLD * std
}

/// The polynomials of a law, and how their coordinate is carried to the law's own.
#[derive(Debug, Clone)]
pub(crate) struct Basis {
    recurrence: Recurrence,
    folded: bool,
    origin: f64,
    scale: f64,
}

impl Basis {
    /// x = origin + scale t
    pub(crate) fn plain(recurrence: Recurrence, origin: f64, scale: f64) -> Self {
        Self {
            recurrence,
            folded: false,
            origin,
            scale,
        }
    }

    /// x = origin + scale t^2, from b_1 .. b_{2N-1} of the law of t; a negative scale counts from an upper end.
    pub(crate) fn folded(recurrence: Recurrence, origin: f64, scale: f64) -> Self {
        Self {
            recurrence,
            folded: true,
            origin,
            scale,
        }
    }

    /// Zeros of p_N in the order of ascending x; `None` if they cannot be told apart.
    pub(crate) fn zeros(&self) -> Option<Vec<f64>> {
        let mut t = golub_welsch::zeros(&self.recurrence)?;
        if self.folded {
            // The other half mirrors them.
            t.drain(..t.len() / 2);
        }
        if self.scale < 0.0 {
            t.reverse();
        }
        Some(t)
    }

    /// Largest difference between the coefficients of two recurrences in the same coordinate, relative to the spread
    /// of the law or, where all are positive, to each of them.
    pub(crate) fn difference(&self, other: &Self) -> f64 {
        let (a, b) = (&self.recurrence, &other.recurrence);
        let diagonal = a
            .diagonal()
            .iter()
            .zip(b.diagonal())
            .map(|(a, b)| (a - b).abs());
        let off_diagonal = a
            .off_diagonal()
            .iter()
            .zip(b.off_diagonal())
            .map(|(a, b)| (a / b - 1.0).abs());
        diagonal.chain(off_diagonal).fold(0.0, f64::max)
    }

    /// Carries a zero to the law's coordinate.
    pub(crate) fn place(&self, t: f64) -> f64 {
        let u = if self.folded { t * t } else { t };
        self.origin + self.scale * u
    }

    /// p_0 .. p_{N-1} at a zero.
    pub(crate) fn orthonormal(&self, t: f64) -> Vec<f64> {
        let p = self.recurrence.orthonormal(t);
        if self.folded {
            p.into_iter().step_by(2).collect()
        } else {
            p
        }
    }
}
