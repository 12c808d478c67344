//! Probabilities and quantiles by integrating a density, for laws whose distribution function has no closed form or
//! loses its digits.
//!
//! P(X <= x) = A/T with A the integral below x and T the whole one, both of positive terms relative to an anchor: no
//! normalising constant is needed, and far in a tail A has as many digits as T. Quantiles are Newton's zeros of
//! ln(A/(T - A)) - ln(p/q), nearly straight in both tails, between brackets.

use crate::law::density::{Density, Place};
use crate::law::panel::{Panel, Restricted, Sample};

/// Resolves densities without a polynomial to rounding (the tests compare with extended precision).
const STEP: f64 = 1.0 / 16.0;
/// A part of the whole larger than this is the whole less the rest; a smaller one's rest has lost two digits at most.
const MOST: f64 = 0.99;
/// Bisection alone takes 64 steps from the widest bracket to neighbouring doubles; Newton takes three or four.
const MOST_STEPS: usize = 100;
/// Newton's step is quadratic: from odds off by 1e-8 it leads to odds off by 1e-16.
const NEARLY: f64 = 1e-8;
/// Logarithm of the largest ratio of distances from the two ends of a law that is told apart.
const WIDEST: f64 = 700.0;

/// A law known by its density alone, restricted to \[low, high\], of which low is finite.
#[derive(Clone, Copy)]
pub(crate) struct Integrated<'a> {
    pub(crate) density: &'a dyn Density,
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// An integral of f(x)/f(anchor).
#[derive(Clone, Copy)]
struct Mass {
    anchor: f64,
    sum: f64,
}

impl Integrated<'_> {
    /// (P(X <= x), P(X > x)), each with its own digits.
    pub(crate) fn probabilities(&self, x: f64) -> (f64, f64) {
        if x <= self.low {
            return (0.0, 1.0);
        }
        if x >= self.high {
            return (1.0, 0.0);
        }
        self.shares(x, self.mass(self.low, self.high))
    }

    /// The x with P(X <= x) = p = 1 - q, each of them given with its own digits.
    pub(crate) fn quantile(&self, p: f64, q: f64) -> f64 {
        if p <= 0.0 {
            return self.low;
        }
        if q <= 0.0 {
            return self.high;
        }
        let wanted = p.ln() - q.ln();
        let (mut left, mut v, mut right) = (-WIDEST, self.start(wanted), WIDEST);
        let whole = self.mass(self.low, self.high);
        for _ in 0..MOST_STEPS {
            let x = self.at(v);
            let (below, above) = self.shares(x, whole);
            let miss = below.ln() - above.ln() - wanted;
            if miss > 0.0 {
                right = v;
            } else {
                left = v;
            }
            let density = self.ln_ratio(whole.anchor, x).exp() / whole.sum;
            let newton = v - miss * below * above / (density * self.stretch(x));
            let inside = newton > left && newton < right;
            if miss.abs() < NEARLY {
                return self.at(if inside { newton } else { v });
            }
            v = if inside { newton } else { left.midpoint(right) };
            if self.at(left) == self.at(right) {
                break;
            }
        }
        self.at(v)
    }

    /// A coordinate near a quantile, from running sums over the points of one integration, which miss the odds by a
    /// few per cent.
    fn start(&self, wanted: f64) -> f64 {
        let mut points = self.points();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut above: Vec<f64> = points.iter().map(|point| point.1).collect();
        for i in (1..above.len()).rev() {
            above[i - 1] += above[i];
        }
        let mut below = 0.0;
        let index = points.iter().zip(&above).position(|(&(_, weight), above)| {
            let odds = (below + 0.5 * weight).ln() - (above - 0.5 * weight).ln();
            below += weight;
            odds >= wanted
        });
        let index = index.unwrap_or(points.len() - 1);
        points[index].0.clamp(-WIDEST, WIDEST)
    }

    /// Coordinates and weights of an integration.
    fn points(&self) -> Vec<(f64, f64)> {
        let law = self.restricted(self.low, self.high);
        let (lower, upper) = (law.anchor - self.low, self.high - law.anchor);
        let mut points = Vec::new();
        for (side, panel) in both_sides(law) {
            let point = |sample: Sample| {
                let (mut below, mut above) =
                    (lower + side * sample.near, upper - side * sample.near);
                if panel.is_whole() && side < 0.0 {
                    below = sample.far;
                } else if panel.is_whole() {
                    above = sample.far;
                }
                (self.coordinate(below, above), sample.ln_weight.exp())
            };
            points.extend(panel.samples(STEP, 0.0).into_iter().map(point));
        }
        points
    }

    /// The coordinate that Newton works in, in which tails are nearly straight: the logarithm of the ratio of the
    /// distances from both ends, or of the one distance that is finite.
    fn coordinate(&self, below: f64, above: f64) -> f64 {
        if self.high.is_finite() {
            below.ln() - above.ln()
        } else {
            below.ln()
        }
    }

    fn at(&self, v: f64) -> f64 {
        let length = self.high - self.low;
        let x = if length.is_infinite() {
            self.low + v.exp()
        } else if v < 0.0 {
            self.low + length / (1.0 + (-v).exp())
        } else {
            self.high - length / (1.0 + v.exp())
        };
        x.clamp(self.low, self.high)
    }

    /// dx/dv
    fn stretch(&self, x: f64) -> f64 {
        let (below, above) = (x - self.low, self.high - x);
        if above.is_finite() {
            below * (above / (self.high - self.low))
        } else {
            below
        }
    }

    /// Probabilities below and above an inner x, given the whole integral.
    fn shares(&self, x: f64, whole: Mass) -> (f64, f64) {
        let share = |part: Mass| {
            let share = part.sum / whole.sum * self.ln_ratio(whole.anchor, part.anchor).exp();
            // A part rounds to more than the whole where that is all of it.
            share.min(1.0)
        };
        let below = || share(self.mass(self.low, x));
        let above = || share(self.mass(x, self.high));
        // First the side of the nearer end: an infinite density there is integrated with its own exponent.
        if x - self.low <= self.high - x {
            let p = below();
            if p <= MOST {
                return (p, 1.0 - p);
            }
            let q = above();
            (1.0 - q, q)
        } else {
            let q = above();
            if q <= MOST {
                return (1.0 - q, q);
            }
            let p = below();
            (p, 1.0 - p)
        }
    }

    fn ln_ratio(&self, anchor: f64, x: f64) -> f64 {
        let (start, end) = self.density.support();
        let exact = |distance: f64| Some((distance, distance.ln()));
        let place = Place::new((start, end), anchor, x - anchor);
        self.density
            .ln_ratio(&place.refined(exact(x - start), exact(end - x)))
    }

    fn mass(&self, low: f64, high: f64) -> Mass {
        let law = self.restricted(low, high);
        let samples = both_sides(law).flat_map(|(_, panel)| panel.samples(STEP, 0.0));
        let sum: f64 = samples.map(|sample| sample.ln_weight.exp()).sum();
        Mass {
            anchor: law.anchor,
            sum: STEP * sum,
        }
    }

    fn restricted(&self, low: f64, high: f64) -> Restricted<'_> {
        Restricted {
            density: self.density,
            low,
            high,
            anchor: self.density.anchor(low, high),
        }
    }
}

fn both_sides<'a>(law: Restricted<'a>) -> impl Iterator<Item = (f64, Panel<'a>)> {
    [-1.0, 1.0]
        .into_iter()
        .filter_map(move |side| Some((side, Panel::new(law, side, 0.0)?)))
}
