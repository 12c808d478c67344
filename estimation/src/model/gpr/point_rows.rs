//! Rows of features, feature by feature.

use ndarray::ArrayView2;
use serde::{Deserialize, Serialize};

use crate::model::contract::check_numbers;

/// Rows of features, feature by feature: distances to all rows are then sums of whole columns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointRows {
    rows: usize,
    /// All rows of feature 0, then of feature 1, ..
    columns: Vec<f64>,
}

impl PointRows {
    /// Copies rows x features.
    pub fn from_rows(rows: &ArrayView2<f64>) -> Self {
        Self {
            rows: rows.nrows(),
            columns: rows.t().iter().copied().collect(),
        }
    }

    /// Counts the rows.
    pub fn len(&self) -> usize {
        self.rows
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// Counts the features.
    pub fn features(&self) -> usize {
        self.columns.len().checked_div(self.rows).unwrap_or(0)
    }

    /// The columns, each with an entry a row.
    pub fn columns(&self) -> impl Iterator<Item = &[f64]> {
        self.columns.chunks_exact(self.rows.max(1))
    }

    /// Some of the rows.
    pub fn select(&self, rows: &[usize]) -> Self {
        Self {
            rows: rows.len(),
            columns: self
                .columns()
                .flat_map(|column| rows.iter().map(|row| column[*row]))
                .collect(),
        }
    }

    pub(crate) fn check(&self, features: usize) -> Result<(), String> {
        if self.rows == 0 {
            return Err("a process's rows are none".to_owned());
        }
        let count = self
            .rows
            .checked_mul(features)
            .ok_or("a process has too many rows")?;
        check_numbers("a process's rows", &self.columns, count)
    }
}
