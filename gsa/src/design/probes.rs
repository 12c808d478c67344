//! Runs off all nodes, where what the nodes know is interpolated: they tell whether the rules resolve the model.

use rand::Rng;

use super::Design;
use crate::design::node_grid::latin_hypercube;

impl Design {
    /// Adds points drawn by the laws, a Latin hypercube of them. A single input needs none: it has all of the variance.
    pub(crate) fn add_probes(&mut self, count: usize, rng: &mut impl Rng) {
        if self.inputs.len() < 2 {
            return;
        }
        for u in latin_hypercube(count, self.inputs.len(), rng) {
            let coordinates = self.inputs.iter().zip(u);
            let point = coordinates.map(|(law, v)| law.inverse_cdf(v)).collect();
            let ordinal = self.add_point(point);
            self.probes.push(ordinal);
        }
    }

    /// Returns the numbers of these points.
    pub(crate) fn probes(&self) -> &[usize] {
        &self.probes
    }
}
