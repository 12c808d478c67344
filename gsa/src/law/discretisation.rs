//! Polynomials of a law without closed recurrence: by Stieltjes' procedure on a fine discretisation of it.
//!
//! ```text
//! a_k = sum_i W_i x_i p_k(x_i)^2,    b_{k+1} = ||(x - a_k) p_k - sqrt(b_k) p_{k-1}||^2
//! ```
//!
//! W. Gautschi, "On generating orthogonal polynomials", SIAM J. Sci. Stat. Comput. 3 (1982) 289-317. The points are
//! those of [`crate::law::panel`], some ten times as many as nodes. p_k is carried times sqrt(W), so that tails whose weight is below the
//! range of doubles still count where the polynomial is large. The step is halved until the coefficients stay.

use crate::law::basis::{Basis, crowds};
use crate::law::density::Density;
use crate::law::panel::{Panel, Restricted};
use crate::law::recurrence::Recurrence;

/// First step of the trapezoidal rule, and how often it may be halved.
const FIRST_STEP: f64 = 1.0 / 16.0;
const HALVINGS: usize = 5;
/// Halving squares the error: coefficients that moved by less than 1e-10 are now off by rounding alone.
const SETTLED: f64 = 1e-10;

/// A law restricted to an interval as points and probabilities.
pub(crate) struct Discretisation {
    /// ends of what was discretised, infinite tails cut
    ends: (f64, f64),
    anchor: f64,
    points: Vec<Point>,
    /// square roots of the probabilities
    roots: Vec<f64>,
}

/// Distances of a point, each accurate by itself: from the lower end, the anchor and the upper end.
#[derive(Debug, Clone, Copy)]
struct Point {
    below: f64,
    from_anchor: f64,
    above: f64,
}

impl Discretisation {
    /// Discretises a law with step h, for polynomials up to this degree. `None` if a tail goes on beyond the range of doubles.
    fn new(law: Restricted<'_>, h: f64, degree: f64) -> Option<Self> {
        let panels = [-1.0, 1.0].map(|side| Panel::new(law, side, degree));
        let [lower, upper] = panels.map(|panel| panel.map_or(0.0, |panel| panel.length));
        if !(lower + upper).is_finite() {
            return None;
        }
        let (mut points, mut ln_weights) = (Vec::new(), Vec::new());
        for (side, panel) in [-1.0, 1.0].into_iter().zip(&panels) {
            let samples = panel.iter().flat_map(|panel| panel.samples(h, degree));
            for sample in samples {
                points.push(if side < 0.0 {
                    Point {
                        below: sample.far,
                        from_anchor: -sample.near,
                        above: upper + sample.near,
                    }
                } else {
                    Point {
                        below: lower + sample.near,
                        from_anchor: sample.near,
                        above: sample.far,
                    }
                });
                ln_weights.push(sample.ln_weight);
            }
        }
        let peak = ln_weights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let sum: f64 = ln_weights.iter().map(|w| (w - peak).exp()).sum();
        let root = |w: &f64| (0.5 * (w - peak)).exp() / sum.sqrt();
        Some(Self {
            ends: (law.anchor - lower, law.anchor + upper),
            anchor: law.anchor,
            roots: ln_weights.iter().map(root).collect(),
            points,
        })
    }

    fn mean(&self, f: impl Fn(&Point) -> f64) -> f64 {
        let terms = self.roots.iter().zip(&self.points);
        terms.map(|(root, point)| root * root * f(point)).sum()
    }

    /// Mean distance of the law from its anchor, and its standard deviation.
    fn moments(&self) -> (f64, f64) {
        let shift = self.mean(|point| point.from_anchor);
        let variance = self.mean(|point| (point.from_anchor - shift).powi(2));
        (shift, variance.sqrt())
    }

    /// Length that makes the coordinate of a folded law of order one.
    fn length(&self) -> f64 {
        self.ends.1 - self.ends.0
    }
}

/// Coordinate in which the polynomials of a law are computed.
#[derive(Debug, Clone, Copy)]
enum Coordinate {
    Plain { shift: f64, std: f64 },
    FromBelow,
    FromAbove,
}

impl Coordinate {
    fn of(law: &Discretisation) -> Self {
        let (shift, std) = law.moments();
        let below = law.mean(|point| point.below);
        let above = law.mean(|point| point.above);
        if !crowds(below.min(above), std) {
            Self::Plain { shift, std }
        } else if below <= above {
            Self::FromBelow
        } else {
            Self::FromAbove
        }
    }

    fn basis(self, law: &Discretisation, size: usize) -> Basis {
        let fold = |distance: fn(&Point) -> f64, origin, sign| {
            let length = law.length();
            let t = law.points.iter().map(|p| (distance(p) / length).sqrt());
            let recurrence = stieltjes(&t.collect::<Vec<_>>(), &law.roots, 2 * size, true);
            Basis::folded(recurrence, origin, sign * length)
        };
        match self {
            Self::Plain { shift, std } => {
                let t = law.points.iter().map(|p| (p.from_anchor - shift) / std);
                let recurrence = stieltjes(&t.collect::<Vec<_>>(), &law.roots, size, false);
                Basis::plain(recurrence, law.anchor + shift, std)
            }
            Self::FromBelow => fold(|p| p.below, law.ends.0, 1.0),
            Self::FromAbove => fold(|p| p.above, law.ends.1, -1.0),
        }
    }
}

/// Polynomials of the law restricted to \[low, high\]. `None` if the coefficients do not settle.
pub(crate) fn basis(density: &dyn Density, low: f64, high: f64, size: usize) -> Option<Basis> {
    let centre = density.symmetry(low, high);
    // Of a symmetric law one half says all.
    let low = centre.unwrap_or(low);
    let anchor = density.anchor(low, high);
    let law = Restricted {
        density,
        low,
        high,
        anchor,
    };
    // Twice the 2N that p_N^2 has: so weighted, densities exp(-x) and exp(-x^2) peak just where the outermost node is.
    let degree = 4.0 * size as f64;
    let (mut before, mut coordinate): (Option<Basis>, Option<Coordinate>) = (None, None);
    for level in 0..=HALVINGS {
        let h = FIRST_STEP * 0.5f64.powi(level as i32);
        let law = Discretisation::new(law, h, degree)?;
        let basis = match centre {
            Some(centre) => symmetric_basis(&law, centre, size),
            None => coordinate
                .get_or_insert_with(|| Coordinate::of(&law))
                .basis(&law, size),
        };
        if before.is_some_and(|before| before.difference(&basis) < SETTLED) {
            return Some(basis);
        }
        before = Some(basis);
    }
    None
}

fn symmetric_basis(half: &Discretisation, centre: f64, size: usize) -> Basis {
    let length = half.length();
    let t: Vec<f64> = half.points.iter().map(|p| p.below / length).collect();
    Basis::plain(stieltjes(&t, &half.roots, size, true), centre, length)
}

/// Recurrence of the discrete law with probabilities roots^2 at t; if `symmetric`, of the law that has the mirror
/// images -t too.
fn stieltjes(t: &[f64], roots: &[f64], size: usize, symmetric: bool) -> Recurrence {
    let (mut diagonal, mut off_diagonal) = (vec![0.0; size], Vec::with_capacity(size));
    // p_{k-1} and p_k, times the root of the weight
    let mut before = vec![0.0; t.len()];
    let mut now = roots.to_vec();
    let mut coupling = 0.0;
    for k in 0..size {
        if !symmetric {
            diagonal[k] = sum(t.iter().zip(&now).map(|(t, p)| t * p * p));
        }
        if k + 1 == size {
            break;
        }
        for ((t, before), now) in t.iter().zip(&mut before).zip(&now) {
            *before = (t - diagonal[k]) * now - coupling * *before;
        }
        coupling = sum(before.iter().map(|p| p * p)).sqrt();
        before.iter_mut().for_each(|p| *p /= coupling);
        std::mem::swap(&mut before, &mut now);
        off_diagonal.push(coupling);
    }
    Recurrence::from_coefficients(diagonal, off_diagonal)
}

/// A sum in eight strands, which rounds less than one and leaves the processor room to run them at once.
fn sum(terms: impl ExactSizeIterator<Item = f64>) -> f64 {
    let mut strands = [0.0; 8];
    for (i, term) in terms.enumerate() {
        strands[i % 8] += term;
    }
    strands.iter().sum()
}

/// Mean and standard deviation of g(x - m) for the law restricted to \[low, high\], with anchor m; g grows no faster
/// than a polynomial of this degree. `None` if they are beyond the range of doubles.
pub(crate) fn moments(
    law: Restricted<'_>,
    degree: f64,
    g: impl Fn(f64) -> f64,
) -> Option<(f64, f64)> {
    let law = Discretisation::new(law, FIRST_STEP / 4.0, degree)?;
    let mean = law.mean(|point| g(point.from_anchor));
    let variance = law.mean(|point| (g(point.from_anchor) - mean).powi(2));
    Some((mean, variance.sqrt()))
}
