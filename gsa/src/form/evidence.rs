//! Evidence of the check points: how far each form is from the model off the cut lines.
//!
//! No quantity taken from the lines alone can tell a product from anything else, so this is the only judge of the form.

use std::collections::HashMap;

use crate::design::{CheckPoint, Design};
use crate::form::additive;
use crate::form::mdrm::Mdrm;
use crate::form::scale::times_power_of_two;
use crate::form::section::Sections;
use crate::form::shift;

/// Check points with a finite value, and their values in the units of the sections.
pub(crate) type Checks<'a> = Vec<(&'a CheckPoint, f64)>;

/// A fit of one number to fewer points would prove nothing.
const LEAST_FOR_SHIFT: usize = 3;
/// The shifted form must lower the misfit this many times to be preferred: being fitted, it lowers it a little for any
/// model, and near-products it makes worse. It must do so without the point that the sum misses most, too: one number explains
/// all of a kink that shows at a single point and its mirror image.
const SHIFT_GAIN: f64 = 10.0;

/// Misfits of each form at the check points. Misfits are root mean squares in the units of the sections, infinite where a form overflows.
#[derive(Debug, Clone)]
pub(crate) struct Evidence<'a> {
    pub(crate) checks: Checks<'a>,
    /// misfit of the product form; infinite where it does not exist
    pub(crate) product: f64,
    /// misfit of the additive form
    pub(crate) additive: f64,
    /// the shifted product and its misfit, where it is a good deal better than both
    pub(crate) shifted: Option<(Mdrm, f64)>,
    /// largest |h - h0|
    pub(crate) departure: f64,
    /// misfit that rounding alone explains
    rounding: f64,
}

/// Returns by check point the number of its mirror image, itself where it has no other; nothing where none has.
pub(crate) fn images(checks: &Checks<'_>) -> Vec<usize> {
    let is_other = |(check, _): &(&CheckPoint, f64)| {
        let image = check.image();
        image.is_some_and(|image| image != check.ordinal())
    };
    if !checks.iter().any(is_other) {
        return Vec::new();
    }
    let places = checks.iter().enumerate();
    let places: HashMap<usize, usize> =
        places.map(|(k, (check, _))| (check.ordinal(), k)).collect();
    let place = |(k, (check, _)): (usize, &(&CheckPoint, f64))| {
        let image = check.image().and_then(|image| places.get(&image));
        image.copied().unwrap_or(k)
    };
    checks.iter().enumerate().map(place).collect()
}

/// Counts the draws of check points: mirror images were drawn together.
pub(crate) fn draws(checks: &Checks<'_>) -> usize {
    let images = images(checks);
    let second = images.iter().enumerate().filter(|(k, image)| *image < k);
    checks.len() - second.count()
}

impl<'a> Evidence<'a> {
    /// Judges the forms; `None` if there is no check point with a finite value.
    pub(crate) fn new(
        design: &'a Design,
        values: &[f64],
        sections: &Sections,
        mdrm: Option<&Mdrm>,
    ) -> Option<Self> {
        let scaled = |ordinal: usize| times_power_of_two(values[ordinal], -sections.exponent);
        let checks: Checks<'a> = design
            .checks()
            .iter()
            .filter(|check| values[check.ordinal()].is_finite())
            .map(|check| (check, scaled(check.ordinal())))
            .collect();
        if checks.is_empty() {
            return None;
        }
        let largest = checks
            .iter()
            .fold(sections.largest, |max, (_, h)| max.max(h.abs()));
        let mut evidence = Self {
            product: mdrm.map_or(f64::INFINITY, |mdrm| {
                misfit(&checks, |check| mdrm.predict(sections, check))
            }),
            additive: misfit(&checks, |check| additive::predict(sections, check)),
            shifted: None,
            departure: checks
                .iter()
                .fold(0.0, |max, (_, h)| max.max((h - sections.centre).abs())),
            // n ratios, each off by an eps, and the model's own few.
            rounding: (sections.inputs() as f64 + 4.0) * f64::EPSILON * largest,
            checks,
        };
        evidence.shifted = evidence.shifted(sections);
        Some(evidence)
    }

    fn shifted(&self, sections: &Sections) -> Option<(Mdrm, f64)> {
        let others = self.product.min(self.additive);
        if draws(&self.checks) < LEAST_FOR_SHIFT || others <= SHIFT_GAIN * self.rounding {
            return None;
        }
        let t = shift::fit(sections, &self.checks);
        let fitted = |checks: &[(&CheckPoint, f64)]| {
            misfit(checks, |check| shift::predict(sections, check, t))
        };
        let of_sum = |check: &CheckPoint| additive::predict(sections, check);
        let form = Mdrm::shifted(sections, 1.0 / t - sections.centre).ok()?;
        let mut rest = self.checks.clone();
        let missed = |(check, h): &(&CheckPoint, f64)| (h - of_sum(check)).abs();
        let most =
            (0..rest.len()).max_by(|a, b| missed(&rest[*a]).total_cmp(&missed(&rest[*b])))?;
        let image = images(&self.checks).get(most).copied().unwrap_or(most);
        rest.swap_remove(most.max(image));
        if image != most {
            rest.swap_remove(most.min(image));
        }
        let others_there = misfit(&rest, of_sum);
        let holds_there =
            fitted(&rest) * SHIFT_GAIN < others_there && others_there > SHIFT_GAIN * self.rounding;
        let misfit = fitted(&self.checks);
        (holds_there && misfit * SHIFT_GAIN < others).then_some((form, misfit))
    }

    /// Whether the product misses the model by more than the additive form does, and by more than rounding; one that
    /// overflows has missed it.
    pub(crate) fn refutes_product(&self) -> bool {
        self.product.is_infinite() || (self.product > self.additive && self.product > self.rounding)
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

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;

    use super::*;
    use crate::law::distribution::Distribution;

    fn with_evidence(model: impl Fn(&[f64]) -> f64, check: impl Fn(&Evidence<'_>)) {
        let inputs = vec![Distribution::uniform(0.5, 1.5).unwrap(); 3];
        let design = Design::new(&inputs, 5, 8, &mut ChaCha8Rng::seed_from_u64(5)).unwrap();
        let values: Vec<f64> = design.points().iter().map(|x| model(x)).collect();
        let sections = Sections::new(&design, &values).unwrap();
        let mdrm = Mdrm::new(&sections).ok();
        check(&Evidence::new(&design, &values, &sections, mdrm.as_ref()).unwrap());
    }

    #[test]
    fn each_form_fits_what_it_was_made_for() {
        with_evidence(
            |x| 2.0 * x[0] * x[1] * x[2],
            |product| {
                assert!(product.product <= product.rounding && product.additive > 0.01);
                assert!(!product.refutes_product() && product.shifted.is_none());
            },
        );
        with_evidence(
            |x| 2.0 + x[0] + x[1] + x[2],
            |sum| {
                assert!(sum.additive <= sum.rounding && sum.product > 1e-3);
                assert!(sum.refutes_product() && sum.shifted.is_none());
            },
        );
        with_evidence(
            |x| 3.0 + x[0] * x[1] * x[2],
            |shifted| {
                let (_, misfit) = shifted.shifted.as_ref().unwrap();
                assert!(*misfit < 1e-14 && shifted.product > 1e-3);
            },
        );
    }

    #[test]
    fn a_number_fitted_to_one_point_explains_nothing() {
        // max(x, y) - 1 beside a sum that misses it where both are above the cut, here at one of the points
        let inputs = vec![Distribution::uniform(0.5, 1.5).unwrap(); 2];
        let design = Design::new(&inputs, 5, 5, &mut ChaCha8Rng::seed_from_u64(5)).unwrap();
        let run = |x: &Vec<f64>| x[0].max(1.0).max(x[1]);
        let mut values: Vec<f64> = design.points().iter().map(run).collect();
        let above = |check: &CheckPoint| design.points()[check.ordinal()].iter().all(|x| *x > 1.0);
        for check in design.checks().iter().filter(|check| above(check)).skip(1) {
            values[check.ordinal()] = f64::NAN;
        }
        let sections = Sections::new(&design, &values).unwrap();
        let evidence = Evidence::new(&design, &values, &sections, None).unwrap();
        assert!(evidence.checks.len() >= LEAST_FOR_SHIFT && evidence.additive > 0.01);
        assert!(evidence.shifted.is_none());
    }

    #[test]
    fn a_misfit_of_rounding_size_refutes_nothing() {
        // so flat that product and sum differ by 1e-20
        with_evidence(
            |x| (1.0 + 1e-10 * x[0]) * (1.0 + 1e-10 * x[1]) + 1e-10 * x[2],
            |flat| assert!(!flat.refutes_product(), "{flat:?}"),
        );
    }

    #[test]
    fn a_form_that_overflows_is_refuted() {
        // beside sections of order one, the scaled value at every check point overflows
        let inputs = vec![Distribution::uniform(0.5, 1.5).unwrap(); 2];
        let design = Design::new(&inputs, 3, 2, &mut ChaCha8Rng::seed_from_u64(5)).unwrap();
        let mut values: Vec<f64> = design
            .points()
            .iter()
            .map(|x| 1e-300 * (x[0] + x[1]))
            .collect();
        for check in design.checks() {
            values[check.ordinal()] = 1e300;
        }
        let sections = Sections::new(&design, &values).unwrap();
        let mdrm = Mdrm::new(&sections).ok();
        let evidence = Evidence::new(&design, &values, &sections, mdrm.as_ref()).unwrap();
        assert!(evidence.refutes_product());
    }
}
