//! Double-exponential quadrature of a law on one side of its anchor.
//!
//! ```text
//! x = low + length / (1 + exp(-pi sinh t)),   dx/dt = pi cosh t (x - low)(high - x)/length,   t = 0, +-h, +-2h ..
//! ```
//!
//! H. Takahasi, M. Mori, "Double exponential formulas for numerical integration", Publ. RIMS 9 (1974) 721-741. The
//! trapezoidal rule in t converges like exp(-c/h) whatever algebraic singularity sits at an end, so halving h squares
//! the error. Where the density is negligible long before an end, the panel is cut there first.

use std::f64::consts::PI;

use crate::law::density::{Density, Place};

/// A part of the support below e^-60 = 1e-26 of its largest value is negligible beside rounding.
const NEGLIGIBLE: f64 = 60.0;
/// Fall, as a logarithm, by which a tail is followed past the peak of density times polynomial; beyond it the true product falls faster than the
/// estimate by which it is followed.
const NEGLIGIBLE_TAIL: f64 = 40.0;
/// Step of the search along a tail.
const STRIDE: f64 = 1.25;
/// Farthest |t| of the search: exp(pi sinh t) is beyond any power that a law has there.
const FARTHEST: f64 = 20.0;

/// A law restricted to \[low, high\], with its anchor.
#[derive(Clone, Copy)]
pub(crate) struct Restricted<'a> {
    pub(crate) density: &'a dyn Density,
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) anchor: f64,
}

/// A side of the anchor, cut where the tail is negligible.
#[derive(Clone, Copy)]
pub(crate) struct Panel<'a> {
    law: Restricted<'a>,
    /// 1 above the anchor, -1 below
    side: f64,
    /// distance from the anchor to the far end
    pub(crate) length: f64,
    /// distance within which the density falls by a factor e
    scale: f64,
    /// whether the far end is that of the restricted law
    whole: bool,
}

/// A point of a panel and the logarithm of f(x)/f(m) dx/dt there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    /// |x - m|
    pub(crate) near: f64,
    /// distance from the panel's far end
    pub(crate) far: f64,
    pub(crate) ln_weight: f64,
}

impl<'a> Panel<'a> {
    /// The side of the anchor, with room for polynomials of this degree. `None` if it is empty.
    pub(crate) fn new(law: Restricted<'a>, side: f64, degree: f64) -> Option<Self> {
        let whole = if side > 0.0 {
            law.high - law.anchor
        } else {
            law.anchor - law.low
        };
        let mut panel = Self {
            law,
            side,
            length: whole,
            scale: whole,
            whole: true,
        };
        if whole <= 0.0 {
            return None;
        }
        panel.scale = panel.find_scale(whole);
        if let Some(cut) = panel.find_cut(whole, degree) {
            (panel.length, panel.whole) = (cut, false);
        }
        Some(panel)
    }

    /// Whether nothing was cut off.
    pub(crate) fn is_whole(&self) -> bool {
        self.whole
    }

    fn find_scale(&self, whole: f64) -> f64 {
        let smallest = self.law.density.width().min(whole) * 2f64.powi(-60);
        let mut distance = smallest.max(f64::MIN_POSITIVE);
        while distance < whole && distance.is_finite() {
            if self.ln_ratio_at(distance) <= -1.0 {
                return distance;
            }
            distance *= 2.0;
        }
        whole
    }

    /// Finds where density times (1 + d/scale)^degree has passed its peak and fallen by e^-40.
    fn find_cut(&self, whole: f64, degree: f64) -> Option<f64> {
        let mut peak = f64::NEG_INFINITY;
        let mut distance = self.scale;
        while distance < whole {
            let value = self.ln_ratio_at(distance) + degree * (distance / self.scale).ln_1p();
            if value < peak - NEGLIGIBLE_TAIL {
                return Some(distance);
            }
            peak = peak.max(value);
            distance *= STRIDE;
        }
        None
    }

    fn ln_ratio_at(&self, distance: f64) -> f64 {
        let law = &self.law;
        let place = Place::new(law.density.support(), law.anchor, self.side * distance);
        law.density.ln_ratio(&place)
    }

    /// All points with step h that matter to polynomials of this degree.
    pub(crate) fn samples(&self, h: f64, degree: f64) -> Vec<Sample> {
        // Towards the anchor what counts is the weight, away from it the weight times the largest polynomial.
        let inward = self.samples_one_way(0, -h, 0.0);
        let outward = self.samples_one_way(1, h, degree);
        inward.into_iter().chain(outward).collect()
    }

    fn samples_one_way(&self, first: usize, step: f64, degree: f64) -> Vec<Sample> {
        let mut samples = Vec::new();
        let mut peak = f64::NEG_INFINITY;
        for k in first..(FARTHEST / step.abs()) as usize {
            let sample = self.sample(step * k as f64);
            let size = sample.ln_weight + degree * (sample.near / self.scale).ln_1p();
            peak = peak.max(size);
            if size < peak - NEGLIGIBLE {
                break;
            }
            samples.push(sample);
        }
        samples
    }

    fn sample(&self, t: f64) -> Sample {
        let argument = PI * t.sinh();
        let (near, ln_near) = share(self.length, argument);
        let (far, ln_far) = share(self.length, -argument);
        let slope = ln_near + ln_far - self.length.ln() + (PI * t.cosh()).ln();
        let law = &self.law;
        let (start, end) = law.density.support();
        let place = Place::new((start, end), law.anchor, self.side * near);
        // Near the end of the panel its distance from there says more than that from the anchor.
        let beyond = |gap: f64| match gap {
            0.0 => (far, ln_far),
            gap => (gap + far, (gap + far).ln()),
        };
        let place = match (self.whole, self.side > 0.0) {
            (true, true) => place.refined(None, Some(beyond(end - law.high))),
            (true, false) => place.refined(Some(beyond(law.low - start)), None),
            (false, _) => place,
        };
        Sample {
            near,
            far,
            ln_weight: law.density.ln_ratio(&place) + slope,
        }
    }
}

/// length / (1 + exp(-y)) and its logarithm.
fn share(length: f64, y: f64) -> (f64, f64) {
    let ln_part = if y > 0.0 {
        -(-y).exp().ln_1p()
    } else {
        y - y.exp().ln_1p()
    };
    (length / (1.0 + (-y).exp()), length.ln() + ln_part)
}
