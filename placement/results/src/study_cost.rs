//! Cost of a study.

use serde::{Deserialize, Serialize};

/// Cost of a study.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct StudyCost {
    /// Points of the plan.
    pub solves: usize,
    /// Points of the plan solved once more on a coarser mesh, for the error of the mesh.
    pub coarser_solves: usize,
    /// Solves that show what the model leaves out.
    pub effect_solves: usize,
    /// Solves of films' signals, on both meshes.
    pub signal_solves: usize,
    /// Solves of layouts' loads, on both meshes.
    pub layout_solves: usize,
    /// Solves of a rig's table of responses.
    pub table_solves: usize,
    /// Wall-clock time of each rung of the climb, s.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub rungs_wall_s: Vec<f64>,
    /// Points taken from the archive instead of being solved.
    pub reused: usize,
    /// Newton iterations of all solves.
    pub newton_iterations: usize,
    /// Factorisations of all solves, without the tangent that the solves from one equilibrium share.
    pub factorisations: usize,
    /// Wall-clock time of this run, s.
    pub wall_s: f64,
    /// Processor time of this run's own threads, s; 0 where the system doesn't tell it.
    pub cpu_s: f64,
    /// Peak memory of the process, bytes.
    pub peak_memory_bytes: u64,
    /// Share of the solves' time in numeric factorisation.
    pub factorisation_share: f64,
    /// Share in substitutions with the factor, and in the contact solved between them.
    pub substitution_share: f64,
    /// Share in assembly.
    pub assembly_share: f64,
    /// Share in all the rest, and in solves that found no equilibrium.
    pub other_share: f64,
}
