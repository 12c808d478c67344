//! Elimination of the pressures on each brick, as it changes a Newton step: forces before it, pressures after it.

use crate::linear::assembly::Assembler;
use crate::linear::face_buffers::gather;
use crate::linear::sparsity::NONE;
use crate::solid::SolidContribution;
use crate::tensor::Vector;

/// Most pressure unknowns of a brick.
const MODES: usize = 4;

impl Assembler<'_> {
    /// Adds to `forces` what the elimination of the pressures moves there: B^T M^-1 r_p / c, N.
    pub(crate) fn add_condensed_volumes(
        &self,
        coupling: &[f64],
        volumes: &[f64],
        forces: &mut [f64],
    ) {
        let (unknowns, modes) = self.sizes();
        let mut pressure = [0.0; MODES];
        let bricks = coupling
            .chunks_exact(modes * unknowns)
            .zip(volumes.chunks_exact(modes));
        for (element, (coupling, volumes)) in bricks.enumerate() {
            let pressure = &mut pressure[..modes];
            self.pressure_increment(element, volumes, pressure);
            for (mode, rows) in pressure.iter().zip(coupling.chunks_exact(unknowns)) {
                let equations = self.setup.equations.of(self.problem.mesh.brick(element));
                for (equation, b) in equations.zip(rows) {
                    if equation != NONE {
                        forces[equation as usize] += mode * b;
                    }
                }
            }
        }
    }

    /// Pressure increments (MPa) that belong to displacement increments (mm), held ones included.
    pub(crate) fn pressure_increments(
        &mut self,
        coupling: &[f64],
        volumes: &[f64],
        increments: &[Vector],
        target: &mut [f64],
    ) {
        let (unknowns, modes) = self.sizes();
        let mut change = [0.0; MODES];
        let bricks = coupling
            .chunks_exact(modes * unknowns)
            .zip(volumes.chunks_exact(modes))
            .zip(target.chunks_exact_mut(modes));
        for (element, ((coupling, volumes), target)) in bricks.enumerate() {
            let nodes = self.problem.mesh.brick(element);
            gather(increments, nodes, &mut self.displacement);
            let rows = coupling.chunks_exact(unknowns).zip(volumes);
            for (change, (row, volume)) in change.iter_mut().zip(rows) {
                let du = self.displacement.as_flattened();
                *change = volume + row.iter().zip(du).map(|(b, u)| b * u).sum::<f64>();
            }
            self.pressure_increment(element, &change[..modes], target);
        }
    }

    fn pressure_increment(&self, element: usize, volume_change: &[f64], target: &mut [f64]) {
        SolidContribution::pressure_increment(
            &self.problem.solid,
            &self.setup.geometry,
            element,
            volume_change,
            target,
        );
    }
}
