//! Time that a model takes to be learnt, and to predict, by its sizes alone: on one core of the machine on which `lab/benches/fit_times.py` was run.

use crate::model::ann::{Sizes as AnnSizes, nodes_and_weights};
use crate::model::contract::Effort;
use crate::model::gpr::{DEVIATION_ROWS, SCREENED_ROWS, Sizes as GprSizes};
use crate::recipe::{Kind, Lengths, Models};

/// A line, s: sums by row and pair of features, left-out errors by row and feature, factors by cube of features.
const RIDGE: [f64; 3] = [8.0e-10, 2.6e-8, 2.0e-8];
/// A look at a process's likelihood, s: by cube of rows, and by pair of rows, for each length where features have their own.
const LOOK: [f64; 3] = [9.0e-11, 3.3e-9, 7.0e-10];
/// Looks of a start on few rows, and of the best places on all.
const LOOKS: [f64; 2] = [20.0, 65.0];
/// Conditioning of a process by cube of rows, s, and its mean of a row by row and feature.
const CONDITION: [f64; 2] = [5.0e-11, 1.5e-9];
/// Deviation of a process's prediction by pair of its rows, s.
const DEVIATION: f64 = 4.0e-10;
/// A network's loss and gradient by row and node, s, and by row and weight; and a prediction by node.
const NETWORK: [f64; 3] = [1.1e-8, 2.0e-10, 1.0e-8];

/// A model to be learnt, by its sizes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LearningTask<'m> {
    pub kind: Kind,
    pub models: &'m Models,
    pub effort: Effort,
    /// Rows that it is learnt from.
    pub rows: usize,
    pub features: usize,
}

impl LearningTask<'_> {
    /// Seconds in which it is learnt.
    pub(crate) fn learning_s(&self) -> f64 {
        let (n, d) = (self.rows as f64, self.features as f64);
        match self.kind {
            Kind::Mean | Kind::Blend => 0.0,
            Kind::Ridge => RIDGE[0] * n * d * d + RIDGE[1] * n * d + RIDGE[2] * d.powi(3),
            Kind::Gpr => {
                let sizes = GprSizes::of(&self.models.gpr, self.effort, self.rows);
                let screened = self.look_s(SCREENED_ROWS.min(sizes.search_rows));
                let followed = self.look_s(sizes.search_rows);
                let searched = sizes.restarts as f64 * LOOKS[0] * screened + LOOKS[1] * followed;
                searched + CONDITION[0] * (sizes.most_rows as f64).powi(3)
            }
            Kind::Ann => {
                let sizes = AnnSizes::of(&self.models.ann, self.effort, self.rows);
                let looks = (sizes.networks * sizes.iterations) as f64;
                let (nodes, weights) = nodes_and_weights(&self.models.ann, self.features);
                looks * sizes.rows as f64 * (NETWORK[0] * nodes + NETWORK[1] * weights)
            }
        }
    }

    /// Seconds in which it predicts a row.
    pub(crate) fn predicting_s(&self) -> f64 {
        let d = self.features as f64;
        match self.kind {
            Kind::Mean | Kind::Blend => 0.0,
            Kind::Ridge => RIDGE[0] * d * d,
            Kind::Gpr => {
                let known = GprSizes::of(&self.models.gpr, self.effort, self.rows).most_rows;
                let deviating = DEVIATION_ROWS.min(known) as f64;
                CONDITION[1] * (known as f64 + deviating) * (d + 4.0)
                    + DEVIATION * deviating * deviating
            }
            Kind::Ann => {
                let networks = AnnSizes::of(&self.models.ann, self.effort, self.rows).networks;
                let (nodes, _) = nodes_and_weights(&self.models.ann, self.features);
                NETWORK[2] * networks as f64 * nodes
            }
        }
    }

    /// Seconds of a look at the likelihood of a process of so many rows.
    fn look_s(&self, rows: usize) -> f64 {
        let lengths = match self.models.gpr.lengths {
            Lengths::Shared => 1.0,
            Lengths::Each => self.features as f64,
        };
        let n = rows as f64;
        n * n * (LOOK[0] * n + LOOK[1] + LOOK[2] * lengths)
    }
}
