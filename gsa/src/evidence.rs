//! What the check points say: how far each form is from the model off the cut lines.
//!
//! No quantity taken from the lines alone can tell a product from anything else, so this is the only judge of the form.

use crate::additive;
use crate::design::{CheckPoint, Design};
use crate::mdrm::Mdrm;
use crate::scale::times_power_of_two;
use crate::section::Sections;

/// Root mean squares over the check points, in the units of the sections; infinite where a form overflows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Evidence {
    /// check points with a finite value
    pub(crate) count: usize,
    /// misfit of the product form; infinite where it does not exist
    pub(crate) product: f64,
    /// misfit of the additive form
    pub(crate) additive: f64,
    /// largest |h - h0|
    pub(crate) departure: f64,
    /// misfit that rounding alone explains
    rounding: f64,
}

impl Evidence {
    /// `None` if there is no check point with a finite value.
    pub(crate) fn new(
        design: &Design,
        values: &[f64],
        sections: &Sections,
        mdrm: Option<&Mdrm>,
    ) -> Option<Self> {
        let finite: Vec<(&CheckPoint, f64)> = design
            .checks()
            .iter()
            .filter(|check| values[check.ordinal()].is_finite())
            .map(|check| {
                (
                    check,
                    times_power_of_two(values[check.ordinal()], -sections.exponent),
                )
            })
            .collect();
        if finite.is_empty() {
            return None;
        }
        let largest = finite
            .iter()
            .fold(sections.largest, |max, (_, h)| max.max(h.abs()));
        Some(Self {
            count: finite.len(),
            product: mdrm.map_or(f64::INFINITY, |mdrm| {
                misfit(&finite, |check| mdrm.predict(sections, check))
            }),
            additive: misfit(&finite, |check| additive::predict(sections, check)),
            departure: finite
                .iter()
                .fold(0.0, |max, (_, h)| max.max((h - sections.centre).abs())),
            // n ratios, each off by an eps, and the model's own few.
            rounding: (sections.inputs() as f64 + 4.0) * f64::EPSILON * largest,
        })
    }

    /// Whether the product misses the model by more than the additive form does, and by more than rounding.
    pub(crate) fn refutes_product(&self) -> bool {
        self.product > self.additive && self.product > self.rounding
    }
}

fn misfit(checks: &[(&CheckPoint, f64)], predict: impl Fn(&CheckPoint) -> f64) -> f64 {
    let square = |(check, h): &(&CheckPoint, f64)| (h - predict(check)).powi(2);
    let mean_square = checks.iter().map(square).sum::<f64>() / checks.len() as f64;
    // An overflowing product may come out as infinity times zero: as far off as can be.
    if mean_square.is_nan() {
        f64::INFINITY
    } else {
        mean_square.sqrt()
    }
}
