//! Points whose values follow from others by a symmetry of the model.
//!
//! Where inputs of equal laws can be exchanged, and the model then answers one output's values in place of another's, a run tells the
//! values at its mirror image too. The lines of such inputs are images of each other already; check points and probes get theirs
//! here, behind all points that are run.

use std::collections::HashMap;

use super::{CheckPoint, Design};
use crate::exchange::exchanged;

impl Design {
    /// The design with the mirror images of its check points and probes, and by point which one is its image, where that is among
    /// them. `None` where the exchange of inputs isn't one: not its own inverse, or of inputs with different laws, lines or means.
    pub(crate) fn with_images(&self, inputs: &[usize]) -> Option<(Self, Vec<Option<usize>>)> {
        self.allows(inputs).then(|| {
            let mut whole = self.clone();
            whole.to_run = Some(self.points.len());
            let mut known: HashMap<Vec<u64>, usize> = HashMap::new();
            for (ordinal, point) in self.points.iter().enumerate() {
                known.entry(bits(point)).or_insert(ordinal);
            }
            whole.add_images_of_checks(inputs);
            whole.add_images_of_probes(inputs, &known);
            for (ordinal, point) in whole.points.iter().enumerate().skip(self.points.len()) {
                known.insert(bits(point), ordinal);
            }
            let image = |point: &Vec<f64>| known.get(&bits(&exchanged(point, inputs))).copied();
            let images = whole.points.iter().map(image).collect();
            (whole, images)
        })
    }

    /// Returns the number of points that are to be run.
    pub(crate) fn to_run(&self) -> usize {
        self.to_run.unwrap_or(self.points.len())
    }

    fn allows(&self, inputs: &[usize]) -> bool {
        let same = |(i, &j): (usize, &usize)| {
            inputs.get(j) == Some(&i)
                && self.inputs[i] == self.inputs[j]
                && self.points[0][i] == self.points[0][j]
                && self
                    .lines_of(i)
                    .map(|line| line.rule().len())
                    .eq(self.lines_of(j).map(|line| line.rule().len()))
        };
        inputs.len() == self.inputs.len() && inputs.iter().enumerate().all(same)
    }

    fn add_images_of_checks(&mut self, inputs: &[usize]) {
        let mut known: HashMap<Vec<usize>, usize> = HashMap::new();
        for check in &self.checks {
            known.insert(check.nodes.clone(), check.ordinal);
        }
        for k in 0..self.checks.len() {
            let (ordinal, nodes) = (
                self.checks[k].ordinal,
                exchanged(&self.checks[k].nodes, inputs),
            );
            let image = known.get(&nodes).copied().unwrap_or_else(|| {
                let image = self.add_point(exchanged(&self.points[ordinal], inputs));
                self.checks.push(CheckPoint {
                    ordinal: image,
                    nodes,
                    image: Some(ordinal),
                });
                image
            });
            self.checks[k].image = Some(image);
        }
    }

    fn add_images_of_probes(&mut self, inputs: &[usize], known: &HashMap<Vec<u64>, usize>) {
        for k in 0..self.probes.len() {
            let point = exchanged(&self.points[self.probes[k]], inputs);
            if !known.contains_key(&bits(&point)) {
                let image = self.add_point(point);
                self.probes.push(image);
            }
        }
    }
}

fn bits(point: &[f64]) -> Vec<u64> {
    point.iter().map(|x| x.to_bits()).collect()
}
