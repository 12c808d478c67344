//! Features on one scale, learnt from training rows.

use ndarray::{Array2, ArrayView1, ArrayView2};
use serde::{Deserialize, Serialize};

use crate::model::contract::check_numbers;
use crate::recipe::Scale;

/// x becomes (x - shift) / width.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FeatureScale {
    shift: Vec<f64>,
    width: Vec<f64>,
}

/// A feature that varies by less than this share of its size varies by rounding alone.
const ROUNDING: f64 = 1e-12;
/// Least width: over smaller ones nothing stays finite.
const LEAST_WIDTH: f64 = 1e-100;

impl FeatureScale {
    /// Learns it from rows x features. A feature that varies by no more than rounding keeps its width.
    pub fn learn(scale: Scale, rows: &ArrayView2<f64>) -> Self {
        let of_column = |column: ArrayView1<'_, f64>| {
            let low = column.iter().copied().fold(f64::INFINITY, f64::min);
            let high = column.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let (shift, width) = match scale {
                Scale::Standardise => {
                    let mean = column.sum() / column.len().max(1) as f64;
                    let squares: f64 = column.iter().map(|x| (x - mean) * (x - mean)).sum();
                    (mean, (squares / column.len().max(1) as f64).sqrt())
                }
                Scale::Normalise => (low, high - low),
                Scale::Off => (0.0, 1.0),
            };
            let varies = width > ROUNDING * low.abs().max(high.abs()) && width > LEAST_WIDTH;
            (shift, if varies { width } else { 1.0 })
        };
        let (shift, width) = rows.columns().into_iter().map(of_column).unzip();
        Self { shift, width }
    }

    /// A row on the scale.
    pub fn scaled(&self, row: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let scale = self.shift.iter().zip(&self.width);
        row.into_iter()
            .zip(scale)
            .map(|(x, (shift, width))| (x - shift) / width)
            .collect()
    }

    /// All rows on the scale.
    pub(crate) fn scaled_rows(&self, rows: &ArrayView2<f64>) -> Array2<f64> {
        let mut scaled = rows.to_owned();
        for ((mut column, shift), width) in scaled
            .columns_mut()
            .into_iter()
            .zip(&self.shift)
            .zip(&self.width)
        {
            column.mapv_inplace(|x| (x - shift) / width);
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
        let standard = FeatureScale::learn(Scale::Standardise, &rows.view());
        let root = (8.0f64 / 3.0).sqrt();
        assert_eq!(standard.scaled([5.0, 6.0]), [2.0 / root, 1.0]);
        let normal = FeatureScale::learn(Scale::Normalise, &rows.view());
        assert_eq!(
            normal.scaled_rows(&rows.view()).column(0).to_vec(),
            [0.0, 0.5, 1.0]
        );
        let off = FeatureScale::learn(Scale::Off, &rows.view());
        assert_eq!(off.scaled_rows(&rows.view()), rows);
        assert!(off.check(2).is_ok() && off.check(3).is_err());
    }
}
