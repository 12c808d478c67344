//! Residual and tangent of the whole problem.

use std::sync::Arc;

use crate::cell::element::Order;
use crate::linear::face_buffers::{FaceBuffers, gather, gathered};
use crate::linear::setup::Setup;
use crate::linear::system::{Entries, Imbalance, Residuals};
use crate::problem::{Loads, Problem, State};
use crate::solid::{SolidContribution, SolidGeometry};
use crate::surface::sheet::Buffers;
use crate::surface::stretch::StretchRange;
use crate::tensor::Vector;

/// Share of the body's natural force below which forces count as round-off: a body that nothing loads is in balance
/// although its forces, each rounded, are as large as their sum.
const ROUND_OFF_SHARE: f64 = 1e-5;
/// Weight of what the ground's force lacks, see [`Imbalance::ground`].
const GROUND_SHARE: f64 = 0.01;

/// Sums element contributions, with the buffers that this takes.
#[derive(Debug)]
pub(crate) struct Assembler<'p> {
    pub(super) problem: &'p Problem,
    pub(super) setup: Arc<Setup>,
    solid: SolidContribution,
    pub(super) displacement: Vec<Vector>,
    face: FaceBuffers,
    /// Displacements at which the sheet's tangent was last taken.
    linearised_at: Option<Vec<Vector>>,
}

impl<'p> Assembler<'p> {
    /// Allocates the buffers.
    pub fn new(problem: &'p Problem, setup: Arc<Setup>) -> Self {
        let order = problem.mesh.order;
        Self {
            problem,
            setup,
            solid: SolidContribution::new(order),
            displacement: vec![[0.0; 3]; order.brick_nodes()],
            face: FaceBuffers::new(order),
            linearised_at: None,
        }
    }

    /// Buffers of the residuals.
    pub fn residuals(&self) -> Residuals {
        let pressures = self.problem.mesh.brick_count() * self.order().pressure_modes();
        Residuals::new(&self.setup, pressures, self.problem.mesh.nodes.len())
    }

    fn order(&self) -> Order {
        self.problem.mesh.order
    }

    /// Unknowns of a brick's displacements and of its pressures.
    pub(super) fn sizes(&self) -> (usize, usize) {
        (
            3 * self.order().brick_nodes(),
            self.order().pressure_modes(),
        )
    }

    /// Entries of the coupling between pressures and displacements: brick, mode, unknown.
    pub(crate) fn coupling_len(&self) -> usize {
        let (unknowns, modes) = self.sizes();
        self.problem.mesh.brick_count() * modes * unknowns
    }

    /// Residuals at a state. `served` says which contact faces the solver is ready for.
    pub fn residual(
        &mut self,
        state: &State,
        loads: &Loads,
        served: &[bool],
        target: &mut Residuals,
    ) -> Imbalance {
        target.clear();
        self.add_solid_residuals(state, target);
        let problem = self.problem;
        let setup = self.setup.clone();
        for membrane in &problem.membranes {
            for (index, nodes) in membrane.surface.iter().enumerate() {
                self.face.clear(false);
                gather(&state.displacement, nodes, &mut self.face.positions);
                membrane.integrate(index, &self.face.positions, &mut self.face.residual, None);
                target.add(&setup.equations, nodes, &self.face.residual);
            }
        }
        self.add_sheet_residuals(state, target);
        if let Some(surface) = problem.pressure.as_ref().filter(|_| loads.pressure != 0.0) {
            for nodes in surface.surface.iter() {
                self.face.clear(false);
                self.face.move_to(problem, state, nodes);
                surface.integrate(
                    loads.pressure,
                    &self.face.positions,
                    &mut self.face.residual,
                    None,
                );
                target.add(&setup.equations, nodes, &self.face.residual);
            }
        }
        if loads.traction_factor != 0.0 {
            for (node, force) in &problem.dead_forces {
                let force = force.map(|component| -loads.traction_factor * component);
                target.add(&setup.equations, &[*node], &force);
            }
        }
        self.add_contact(state, loads, served, target);
        self.imbalance(target, loads)
    }

    fn add_solid_residuals(&mut self, state: &State, target: &mut Residuals) {
        let (_, modes) = self.sizes();
        for element in 0..self.problem.mesh.brick_count() {
            self.integrate_solid(state, element, false);
            target.volumes[element * modes..(element + 1) * modes]
                .copy_from_slice(&self.solid.pressure_residual);
            target.min_volume_ratio = target.min_volume_ratio.min(self.solid.min_volume_ratio);
            let nodes = self.problem.mesh.brick(element);
            target.add(&self.setup.equations, nodes, &self.solid.residual);
        }
    }

    fn add_sheet_residuals(&mut self, state: &State, target: &mut Residuals) {
        let Some(sheet) = &self.problem.sheet else {
            return;
        };
        for element in 0..sheet.element_count() {
            let nodes = sheet.nodes(element);
            let displacement = gathered(&state.displacement, nodes);
            let mut residual = vec![0.0; 3 * nodes.len()];
            let buffers = Buffers {
                residual: &mut residual,
                stiffness: None,
            };
            sheet.integrate(element, &displacement, None, buffers);
            target.add(&self.setup.equations, nodes, &residual);
        }
    }

    /// Lets the next tangent of the sheet have the tensions of its own state.
    pub(crate) fn forget_last_tangent(&mut self) {
        self.linearised_at = None;
    }

    fn add_sheet_tangents(&mut self, state: &State, pending: &[Vector], entries: &mut Entries) {
        let Some(sheet) = &self.problem.sheet else {
            return;
        };
        let before = self.linearised_at.take();
        for element in 0..sheet.element_count() {
            let nodes = sheet.nodes(element);
            let displacement = gathered(&state.displacement, nodes);
            let before = before.as_ref().map(|before| gathered(before, nodes));
            let unknowns = 3 * nodes.len();
            let (mut residual, mut stiffness) =
                (vec![0.0; unknowns], vec![0.0; unknowns * unknowns]);
            let buffers = Buffers {
                residual: &mut residual,
                stiffness: Some(&mut stiffness),
            };
            sheet.integrate(element, &displacement, before.as_deref(), buffers);
            let scatter = &self.setup.sheet_scatter[element];
            entries.add(&self.setup.equations, nodes, &stiffness, scatter, pending);
        }
        self.linearised_at = Some(state.displacement.clone());
    }

    fn integrate_solid(&mut self, state: &State, element: usize, tangent: bool) {
        let (_, modes) = self.sizes();
        let nodes = self.problem.mesh.brick(element);
        gather(&state.displacement, nodes, &mut self.displacement);
        let pressure = &state.pressure[element * modes..(element + 1) * modes];
        self.solid.integrate(
            &self.problem.solid,
            &self.setup.geometry,
            element,
            &self.displacement,
            pressure,
            tangent,
        );
    }

    fn add_contact(
        &mut self,
        state: &State,
        loads: &Loads,
        served: &[bool],
        target: &mut Residuals,
    ) {
        let (Some(surface), Some(ground)) = (&self.problem.contact, loads.ground_in(state)) else {
            return;
        };
        let [_, _, up] = ground.axes.vectors();
        for (index, nodes) in surface.surface.iter().enumerate() {
            self.face.clear(false);
            self.face.move_to(self.problem, state, nodes);
            let FaceBuffers {
                residual,
                positions,
                ..
            } = &mut self.face;
            if surface.integrate(&ground, index, positions, &state.anchors, residual, None) {
                target.add_contact(&self.setup.equations, nodes, residual, &up);
                target.touches_outside |= !served[index];
            }
        }
    }

    /// Condensed tangent of all but contact, and the coupling of pressures and displacements. `pending` holds increments
    /// of the held displacements that the step must make.
    pub fn tangent(
        &mut self,
        state: &State,
        loads: &Loads,
        pending: &[Vector],
        entries: &mut Entries,
        coupling: &mut [f64],
    ) {
        entries.clear();
        self.add_solid_tangents(state, pending, entries, coupling);
        let (problem, setup) = (self.problem, self.setup.clone());
        for (membrane, scatter) in problem.membranes.iter().zip(&setup.membrane_scatter) {
            for (index, nodes) in membrane.surface.iter().enumerate() {
                self.face.clear(true);
                gather(&state.displacement, nodes, &mut self.face.positions);
                let (positions, residual, stiffness) = self.face.parts();
                membrane.integrate(index, positions, residual, Some(stiffness));
                self.face
                    .scatter(&setup, nodes, index, scatter, pending, entries);
            }
        }
        self.add_sheet_tangents(state, pending, entries);
        if let Some(surface) = problem.pressure.as_ref().filter(|_| loads.pressure != 0.0) {
            for (index, nodes) in surface.surface.iter().enumerate() {
                self.face.clear(true);
                self.face.move_to(problem, state, nodes);
                let (positions, residual, stiffness) = self.face.parts();
                surface.integrate(loads.pressure, positions, residual, Some(stiffness));
                let scatter = &setup.pressure_scatter;
                self.face
                    .scatter(&setup, nodes, index, scatter, pending, entries);
            }
        }
    }

    fn add_solid_tangents(
        &mut self,
        state: &State,
        pending: &[Vector],
        entries: &mut Entries,
        coupling: &mut [f64],
    ) {
        let (unknowns, modes) = self.sizes();
        let packed = unknowns * (unknowns + 1) / 2;
        let coupling = coupling.chunks_exact_mut(modes * unknowns);
        for (element, coupling) in (0..self.problem.mesh.brick_count()).zip(coupling) {
            self.integrate_solid(state, element, true);
            coupling.copy_from_slice(&self.solid.coupling);
            self.solid
                .condense(&self.problem.solid, &self.setup.geometry, element);
            entries.add(
                &self.setup.equations,
                self.problem.mesh.brick(element),
                &self.solid.stiffness,
                &self.setup.brick_scatter[element * packed..(element + 1) * packed],
                pending,
            );
        }
    }

    fn imbalance(&self, residuals: &Residuals, loads: &Loads) -> Imbalance {
        let norm = |values: &[f64]| values.iter().map(|v| v * v).sum::<f64>().sqrt();
        let ratio = |value: f64, scale: f64| if value == 0.0 { 0.0 } else { value / scale };
        let bricks = self.problem.mesh.brick_count();
        let volumes = (0..bricks)
            .map(|e| self.setup.geometry.volume(e).powi(2))
            .sum::<f64>()
            .sqrt();
        let forces = norm(&residuals.magnitudes).max(ROUND_OFF_SHARE * self.setup.natural_force);
        Imbalance {
            force: ratio(norm(&residuals.forces), forces),
            volume: ratio(norm(&residuals.volumes), volumes),
            ground: loads.ground_force.map_or(0.0, |force| {
                GROUND_SHARE * ratio((residuals.ground_force - force).abs(), force)
            }),
        }
    }

    /// Largest |J - 1| of a brick's mean.
    pub fn max_volume_change(&mut self, state: &State) -> f64 {
        let change = |geometry: &SolidGeometry, element, displacement: &[Vector]| {
            (geometry.mean_volume_ratio(element, displacement) - 1.0).abs()
        };
        self.over_bricks(state, change).fold(0.0, f64::max)
    }

    /// Extremes of the principal stretches at the integration points.
    pub fn stretch_range(&mut self, state: &State) -> StretchRange {
        self.over_bricks(state, SolidGeometry::stretch_range)
            .fold(StretchRange::UNDEFORMED, StretchRange::with)
    }

    /// A figure of each brick from its displacements.
    fn over_bricks<T>(
        &mut self,
        state: &State,
        figure: impl Fn(&SolidGeometry, usize, &[Vector]) -> T,
    ) -> impl Iterator<Item = T> {
        let mesh = &self.problem.mesh;
        (0..mesh.brick_count()).map(move |element| {
            gather(
                &state.displacement,
                mesh.brick(element),
                &mut self.displacement,
            );
            figure(&self.setup.geometry, element, &self.displacement)
        })
    }
}
