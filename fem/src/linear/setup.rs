//! Geometry, equation numbers, scatter lists and symbolic factorisation: all that assembly and factorisation need before any state. Made once per
//! mesh and contact border, shared by all solves.

use std::sync::Arc;

use crate::cell::mesh::Surface;
use crate::linear::coupled::cells;
use crate::linear::sparsity::{Equations, NONE, Pattern};
use crate::linear::symbolic::{LinearError, Symbolic};
use crate::problem::{Loads, Problem, State};
use crate::solid::{InvalidReference, SolidGeometry};
use crate::surface::membrane::Membrane;
use crate::surface::sheet::Sheet;

/// Setting up a problem failed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SetupError {
    /// The mesh is invalid.
    #[error(transparent)]
    Mesh(#[from] InvalidReference),
    /// The linear solver can't be set up.
    #[error(transparent)]
    Linear(#[from] LinearError),
}

/// The part of a discretised problem that no state changes.
#[derive(Debug)]
pub struct Setup {
    /// Equation numbers; the border holds the displacements that contact acts on.
    pub equations: Equations,
    /// Symbolic factorisation.
    pub symbolic: Arc<Symbolic>,
    pub(crate) geometry: Arc<SolidGeometry>,
    pub(crate) brick_scatter: Vec<u32>,
    pub(crate) membrane_scatter: Vec<Vec<u32>>,
    /// Scatter lists of the sheet's elements.
    pub(crate) sheet_scatter: Vec<Vec<u32>>,
    pub(crate) pressure_scatter: Vec<u32>,
    /// Shear modulus times volume^(2/3), and fibre stiffnesses times the root of their area, N.
    pub(crate) natural_force: f64,
    /// Whether the border serves each contact face.
    pub(crate) border_faces: Vec<bool>,
}

impl Setup {
    /// Sets a problem up with a border that serves contact from `state` with the ground of `loads`. Without a ground
    /// there is no border.
    ///
    /// # Errors
    /// [`SetupError`] when a brick is inverted or the factor doesn't fit in memory.
    pub fn new(problem: &Problem, state: &State, loads: &Loads) -> Result<Self, SetupError> {
        let geometry = Arc::new(SolidGeometry::new(&problem.mesh)?);
        let faces = contact_faces(problem, state, loads);
        Self::with_border(problem, geometry, border_axes(problem, &faces), faces)
    }

    /// Returns this set-up with a border that serves these contact faces too; `None` when its own border does.
    ///
    /// # Errors
    /// As [`Setup::new`].
    pub(crate) fn widened(
        &self,
        problem: &Problem,
        faces: &[bool],
    ) -> Result<Option<Self>, SetupError> {
        let served = &self.border_faces;
        if faces
            .iter()
            .zip(served)
            .all(|(needed, has)| !needed || *has)
        {
            return Ok(None);
        }
        let both: Vec<bool> = faces.iter().zip(served).map(|(a, b)| *a || *b).collect();
        let border = border_axes(problem, &both);
        Self::with_border(problem, self.geometry.clone(), border, both).map(Some)
    }

    /// Returns the set-up of a problem with the same elements, supports and border on nodes that lie elsewhere.
    ///
    /// # Errors
    /// As [`Setup::new`].
    pub(crate) fn reshaped(&self, problem: &Problem) -> Result<Self, SetupError> {
        let geometry = Arc::new(SolidGeometry::new(&problem.mesh)?);
        let faces = self.border_faces.clone();
        Self::with_border(problem, geometry, border_axes(problem, &faces), faces)
    }

    fn with_border(
        problem: &Problem,
        geometry: Arc<SolidGeometry>,
        border: Vec<[bool; 3]>,
        border_faces: Vec<bool>,
    ) -> Result<Self, SetupError> {
        let mesh = &problem.mesh;
        let cells = cells(problem);
        let equations = Equations::new(&cells, &problem.supports, &border);
        let pattern = Pattern::new(&cells, &equations);
        let scatter = |nodes: &[u32]| pattern.scatter(&equations.of(nodes).collect::<Vec<_>>());
        let of_surface = |surface: &Surface| surface.iter().flat_map(scatter).collect::<Vec<_>>();
        let brick_scatter = (0..mesh.brick_count())
            .flat_map(|e| scatter(mesh.brick(e)))
            .collect();
        let membranes = problem.membranes.iter();
        let membrane_scatter = membranes.map(|m| of_surface(&m.surface)).collect();
        let sheet = problem.sheet.iter();
        let sheet_scatter = sheet.flat_map(|sheet| {
            (0..sheet.element_count()).map(|element| scatter(sheet.nodes(element)))
        });
        let sheet_scatter = sheet_scatter.collect();
        let pressure = problem.pressure.as_ref();
        let pressure_scatter = pressure.map_or_else(Vec::new, |p| of_surface(&p.surface));
        let symbolic = Symbolic::new(pattern, equations.interior)?;
        Ok(Self {
            equations,
            symbolic: Arc::new(symbolic),
            natural_force: natural_force(problem, &geometry),
            geometry,
            brick_scatter,
            membrane_scatter,
            sheet_scatter,
            pressure_scatter,
            border_faces,
        })
    }

    /// Size of the border.
    pub fn border(&self) -> usize {
        self.equations.count - self.equations.interior
    }

    /// Place of an equation in the border; `None` outside it.
    pub(crate) fn in_border(&self, equation: u32) -> Option<usize> {
        if equation == NONE {
            None
        } else {
            (equation as usize).checked_sub(self.equations.interior)
        }
    }
}

/// Contact faces that may touch the ground from a state.
pub(crate) fn contact_faces(problem: &Problem, state: &State, loads: &Loads) -> Vec<bool> {
    match (&problem.contact, loads.ground_in(state)) {
        (Some(contact), Some(ground)) => {
            contact.faces_near(&ground, |node| state.position(&problem.mesh, node))
        }
        (Some(contact), None) => vec![false; contact.surface.face_count()],
        _ => Vec::new(),
    }
}

/// Displacements that contact on these faces can push: level ground has no slope along y, so that y is free of it but for friction.
fn border_axes(problem: &Problem, faces: &[bool]) -> Vec<[bool; 3]> {
    let mut border = vec![[false; 3]; problem.mesh.nodes.len()];
    let Some(contact) = &problem.contact else {
        return border;
    };
    for (nodes, _) in contact.surface.iter().zip(faces).filter(|(_, of)| **of) {
        for &node in nodes {
            border[node as usize] = [true, contact.acts_across(), true];
        }
    }
    border
}

fn natural_force(problem: &Problem, geometry: &SolidGeometry) -> f64 {
    let volume: f64 = (0..problem.mesh.brick_count())
        .map(|e| geometry.volume(e))
        .sum();
    let fibres: f64 = problem.membranes.iter().map(Membrane::natural_force).sum();
    let sheet = problem.sheet.as_ref().map_or(0.0, Sheet::natural_force);
    problem.solid.material.shear_modulus() * volume.powf(2.0 / 3.0) + fibres + sheet
}
