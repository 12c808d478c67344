//! Features on one scale, learnt from training rows.

use ndarray::{Array2, ArrayView1, ArrayView2};
use serde::{Deserialize, Serialize};

use crate::model::contract::check_numbers;
use crate::recipe::Scale;

/// x becomes (x - shift) / width. A value that no load explains says nothing of a force: the mean stands in for it, as for one that is missing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FeatureScale {
    shift: Vec<f64>,
    width: Vec<f64>,
    /// Values of each feature that are believed; empty in models of earlier versions, which believe all.
    #[serde(default)]
    believed: Vec<Believed>,
}

/// Values of a feature that are believed, in its unit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Believed {
    low: f64,
    high: f64,
    /// Value that stands in for others.
    mean: f64,
}

impl Believed {
    fn or_mean(&self, x: f64) -> f64 {
        // What isn't finite stays so, and is told.
        if (self.low..=self.high).contains(&x) || !x.is_finite() {
            x
        } else {
            self.mean
        }
    }
}

/// A feature that varies by less than this share of its size varies by rounding alone.
const ROUNDING: f64 = 1e-12;
/// Least width: over smaller ones nothing stays finite.
const LEAST_WIDTH: f64 = 1e-100;

impl FeatureScale {
    /// Learns it from rows x features. A feature that varies by no more than rounding keeps its width. `reach`: the ranges of each feature beyond which its
    /// values aren't believed.
    pub fn learn(
        scale: Scale,
        rows: &ArrayView2<f64>,
        reach: impl IntoIterator<Item = f64>,
    ) -> Self {
        let of_column = |(column, reach): (ArrayView1<'_, f64>, f64)| {
            let low = column.iter().copied().fold(f64::INFINITY, f64::min);
            let high = column.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let mean = column.sum() / column.len().max(1) as f64;
            let (shift, width) = match scale {
                Scale::Standardise => {
                    let squares: f64 = column.iter().map(|x| (x - mean) * (x - mean)).sum();
                    (mean, (squares / column.len().max(1) as f64).sqrt())
                }
                Scale::Normalise => (low, high - low),
                Scale::Off => (0.0, 1.0),
            };
            let is_wide =
                |width: f64| width > ROUNDING * low.abs().max(high.abs()) && width > LEAST_WIDTH;
            // One that doesn't vary tells no range.
            let beyond = match is_wide(high - low) {
                true => reach * (high - low),
                false => f64::MAX,
            };
            let believed = Believed {
                low: (low - beyond).max(f64::MIN),
                high: (high + beyond).min(f64::MAX),
                mean,
            };
            (shift, if is_wide(width) { width } else { 1.0 }, believed)
        };
        let columns = rows.columns().into_iter().zip(reach).map(of_column);
        let mut found = Self {
            shift: Vec::new(),
            width: Vec::new(),
            believed: Vec::new(),
        };
        for (shift, width, believed) in columns {
            found.shift.push(shift);
            found.width.push(width);
            found.believed.push(believed);
        }
        found
    }

    /// A row on the scale.
    pub fn scaled(&self, row: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let scale = self.shift.iter().zip(&self.width).enumerate();
        row.into_iter()
            .zip(scale)
            .map(|(x, (feature, (shift, width)))| (self.believed(feature, x) - shift) / width)
            .collect()
    }

    fn believed(&self, feature: usize, x: f64) -> f64 {
        let believed = self.believed.get(feature);
        believed.map_or(x, |believed| believed.or_mean(x))
    }

    /// All rows on the scale.
    pub(crate) fn scaled_rows(&self, rows: &ArrayView2<f64>) -> Array2<f64> {
        let mut scaled = rows.to_owned();
        let scale = self.shift.iter().zip(&self.width).enumerate();
        for (mut column, (feature, (shift, width))) in scaled.columns_mut().into_iter().zip(scale) {
            column.mapv_inplace(|x| (self.believed(feature, x) - shift) / width);
        }
        scaled
    }

    /// Whether it was read as a scale of so many features.
    ///
    /// # Errors
    /// A sentence, when it wasn't.
    pub fn check(&self, features: usize) -> Result<(), String> {
        check_numbers("a scale's shift", &self.shift, features)?;
        check_numbers("a scale's width", &self.width, features)?;
        if self.width.iter().any(|width| *width <= 0.0) {
            return Err("a scale's width must be positive".to_owned());
        }
        if !self.believed.is_empty() {
            let of = |number: fn(&Believed) -> f64| -> Vec<f64> {
                self.believed.iter().map(number).collect()
            };
            check_numbers("a scale's low ends", &of(|of| of.low), features)?;
            check_numbers("a scale's high ends", &of(|of| of.high), features)?;
            check_numbers("a scale's means", &of(|of| of.mean), features)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::array;

    #[test]
    fn scales_are_those_of_their_formulas() {
        let rows = array![[1.0, 5.0], [3.0, 5.0], [5.0, 5.0]];
        let standard = FeatureScale::learn(Scale::Standardise, &rows.view(), [1e9; 2]);
        let root = (8.0f64 / 3.0).sqrt();
        assert_eq!(standard.scaled([5.0, 6.0]), [2.0 / root, 1.0]);
        let normal = FeatureScale::learn(Scale::Normalise, &rows.view(), [1e9; 2]);
        assert_eq!(
            normal.scaled_rows(&rows.view()).column(0).to_vec(),
            [0.0, 0.5, 1.0]
        );
        let off = FeatureScale::learn(Scale::Off, &rows.view(), [1e9; 2]);
        assert_eq!(off.scaled_rows(&rows.view()), rows);
        assert!(off.check(2).is_ok() && off.check(3).is_err());
    }

    #[test]
    fn the_mean_stands_in_for_what_no_load_explains() {
        let rows = array![[0.0, 7.0], [1.0, 7.0], [5.0, 7.0]];
        for scale in [Scale::Standardise, Scale::Normalise, Scale::Off] {
            let learnt = FeatureScale::learn(scale, &rows.view(), [2.0; 2]);
            let of_mean = learnt.scaled([2.0, 7.0]);
            // From 0 to 5 and two ranges beyond; what never varied is believed whatever it does.
            for x in [-10.1, 15.1, 1e300] {
                assert_eq!(learnt.scaled([x, 7.0]), of_mean, "{x}");
                let as_rows = learnt.scaled_rows(&array![[x, 7.0]].view());
                assert_eq!(as_rows.row(0).to_vec(), of_mean, "{x}");
            }
            let believed = learnt.scaled([15.0, 1e9]);
            assert!(believed[0] > of_mean[0] && believed[1] > 1e8);
            assert!(learnt.scaled([f64::INFINITY, 7.0])[0].is_infinite());
        }
    }

    #[test]
    fn a_scale_of_an_earlier_version_believes_all() {
        let read = serde_json::from_str(r#"{"shift": [1.0], "width": [2.0]}"#);
        let earlier: FeatureScale = read.expect("reads");
        assert!(earlier.check(1).is_ok());
        assert_eq!(earlier.scaled([2001.0]), [1000.0]);
    }
}
