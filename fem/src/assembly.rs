//! Residual and tangent of the whole problem.

use crate::element::Order;
use crate::membrane::Membrane;
use crate::mesh::Surface;
use crate::problem::{Loads, Problem, State};
use crate::solid::{InvalidReference, SolidContribution, SolidGeometry};
use crate::sparsity::{Equations, Pattern};
use crate::system::{Imbalance, System};
use crate::tensor::Vector;

/// Share of the body's natural force below which forces count as round-off: a body that nothing loads is in balance
/// although its forces, each rounded, are as large as their sum.
const ROUND_OFF_SHARE: f64 = 1e-5;

/// Sums element contributions into the linear system of one Newton step.
#[derive(Debug)]
pub struct Assembler<'p> {
    problem: &'p Problem,
    geometry: SolidGeometry,
    /// Equation numbers.
    pub equations: Equations,
    brick_scatter: Vec<u32>,
    membrane_scatter: Vec<Vec<u32>>,
    pressure_scatter: Vec<u32>,
    contact_scatter: Vec<u32>,
    solid: SolidContribution,
    face: FaceBuffers,
    /// Shear modulus times volume^(2/3), and fibre stiffnesses times the root of their area, N.
    natural_force: f64,
}

#[derive(Debug)]
struct FaceBuffers {
    residual: Vec<f64>,
    stiffness: Vec<f64>,
    positions: Vec<Vector>,
}

impl<'p> Assembler<'p> {
    /// Prepares the scatter of every element.
    ///
    /// # Errors
    /// [`InvalidReference`] names an inverted brick.
    pub fn new(problem: &'p Problem) -> Result<(Self, Pattern), InvalidReference> {
        let mesh = &problem.mesh;
        let geometry = SolidGeometry::new(mesh)?;
        let equations = Equations::new(mesh, &problem.layout, &problem.supports);
        let pattern = Pattern::new(mesh, &equations);
        let scatter = |nodes: &[u32]| pattern.scatter(&equations.of(nodes).collect::<Vec<_>>());
        let of_surface = |surface: &Surface| surface.iter().flat_map(scatter).collect::<Vec<_>>();
        let order = mesh.order;
        let face_unknowns = 3 * order.face_nodes();
        let assembler = Self {
            problem,
            brick_scatter: (0..mesh.brick_count())
                .flat_map(|e| scatter(mesh.brick(e)))
                .collect(),
            membrane_scatter: problem
                .membranes
                .iter()
                .map(|m| of_surface(&m.surface))
                .collect(),
            pressure_scatter: problem
                .pressure
                .as_ref()
                .map(|p| of_surface(&p.surface))
                .unwrap_or_default(),
            contact_scatter: problem
                .contact
                .as_ref()
                .map(|c| of_surface(&c.surface))
                .unwrap_or_default(),
            natural_force: natural_force(problem, &geometry),
            geometry,
            equations,
            solid: SolidContribution::new(order),
            face: FaceBuffers {
                residual: vec![0.0; face_unknowns],
                stiffness: vec![0.0; face_unknowns * face_unknowns],
                positions: vec![[0.0; 3]; order.face_nodes()],
            },
        };
        Ok((assembler, pattern))
    }

    /// Buffers of a system.
    pub fn system(&self, pattern: &Pattern) -> System {
        let (order, bricks) = (self.order(), self.problem.mesh.brick_count());
        System {
            residual: vec![0.0; self.equations.count],
            condensed_residual: vec![0.0; self.equations.count],
            entries: vec![0.0; pattern.entries()],
            force_magnitude: vec![0.0; 3 * self.problem.mesh.nodes.len()],
            coupling: vec![0.0; bricks * order.pressure_modes() * 3 * order.brick_nodes()],
            pressure_residual: vec![0.0; bricks * order.pressure_modes()],
        }
    }

    fn order(&self) -> Order {
        self.problem.mesh.order
    }

    /// Residual alone.
    pub fn residual(&mut self, state: &State, loads: &Loads, system: &mut System) -> Imbalance {
        self.assemble(state, loads, system, None)
    }

    /// Residual and condensed tangent. `pending` holds increments of the held displacements that the step must make.
    pub fn tangent(
        &mut self,
        state: &State,
        loads: &Loads,
        pending: &[Vector],
        system: &mut System,
    ) -> Imbalance {
        self.assemble(state, loads, system, Some(pending))
    }

    fn assemble(
        &mut self,
        state: &State,
        loads: &Loads,
        system: &mut System,
        pending: Option<&[Vector]>,
    ) -> Imbalance {
        system.residual.fill(0.0);
        system.force_magnitude.fill(0.0);
        if pending.is_some() {
            system.condensed_residual.fill(0.0);
            system.entries.fill(0.0);
        }
        self.add_solids(state, system, pending);
        self.add_membranes(state, system, pending);
        self.add_pressure(state, loads, system, pending);
        self.add_contact(state, loads, system, pending);
        self.imbalance(system)
    }

    fn add_solids(&mut self, state: &State, system: &mut System, pending: Option<&[Vector]>) {
        let problem = self.problem;
        let (order, modes) = (self.order(), self.order().pressure_modes());
        let unknowns = 3 * order.brick_nodes();
        let packed = unknowns * (unknowns + 1) / 2;
        let mut displacement = vec![[0.0; 3]; order.brick_nodes()];
        for element in 0..problem.mesh.brick_count() {
            let nodes = problem.mesh.brick(element);
            gather(&state.displacement, nodes, &mut displacement);
            let pressure = &state.pressure[element * modes..(element + 1) * modes];
            self.solid.integrate(
                &problem.solid,
                &self.geometry,
                element,
                &displacement,
                pressure,
                pending.is_some(),
            );
            system.pressure_residual[element * modes..(element + 1) * modes]
                .copy_from_slice(&self.solid.pressure_residual);
            system.add_forces(&self.equations, nodes, &self.solid.residual);
            if let Some(pending) = pending {
                system.coupling[element * modes * unknowns..(element + 1) * modes * unknowns]
                    .copy_from_slice(&self.solid.coupling);
                self.solid.condense(&problem.solid, &self.geometry, element);
                let scatter = &self.brick_scatter[element * packed..(element + 1) * packed];
                system.add_tangent(
                    &self.equations,
                    nodes,
                    &self.solid.residual,
                    &self.solid.stiffness,
                    scatter,
                    pending,
                );
            }
        }
    }

    fn add_membranes(&mut self, state: &State, system: &mut System, pending: Option<&[Vector]>) {
        for (membrane, scatter) in self.problem.membranes.iter().zip(&self.membrane_scatter) {
            for (index, nodes) in membrane.surface.iter().enumerate() {
                self.face.clear(pending.is_some());
                gather(&state.displacement, nodes, &mut self.face.positions);
                let FaceBuffers {
                    residual,
                    stiffness,
                    positions,
                } = &mut self.face;
                membrane.integrate(
                    index,
                    positions,
                    residual,
                    pending.map(|_| stiffness.as_mut_slice()),
                );
                self.face
                    .scatter(&self.equations, nodes, index, scatter, pending, system);
            }
        }
    }

    fn add_pressure(
        &mut self,
        state: &State,
        loads: &Loads,
        system: &mut System,
        pending: Option<&[Vector]>,
    ) {
        let Some(surface) = self
            .problem
            .pressure
            .as_ref()
            .filter(|_| loads.pressure != 0.0)
        else {
            return;
        };
        for (index, nodes) in surface.surface.iter().enumerate() {
            self.face.clear(pending.is_some());
            self.face.move_to(self.problem, state, nodes);
            let FaceBuffers {
                residual,
                stiffness,
                positions,
            } = &mut self.face;
            surface.integrate(
                loads.pressure,
                positions,
                residual,
                pending.map(|_| stiffness.as_mut_slice()),
            );
            self.face.scatter(
                &self.equations,
                nodes,
                index,
                &self.pressure_scatter,
                pending,
                system,
            );
        }
    }

    fn add_contact(
        &mut self,
        state: &State,
        loads: &Loads,
        system: &mut System,
        pending: Option<&[Vector]>,
    ) {
        let (Some(surface), Some(ground)) = (&self.problem.contact, &loads.ground) else {
            return;
        };
        for (index, nodes) in surface.surface.iter().enumerate() {
            self.face.clear(pending.is_some());
            self.face.move_to(self.problem, state, nodes);
            let FaceBuffers {
                residual,
                stiffness,
                positions,
            } = &mut self.face;
            let stiffness = pending.map(|_| stiffness.as_mut_slice());
            if surface.integrate(ground, index, positions, residual, stiffness) {
                self.face.scatter(
                    &self.equations,
                    nodes,
                    index,
                    &self.contact_scatter,
                    pending,
                    system,
                );
            }
        }
    }

    fn imbalance(&self, system: &System) -> Imbalance {
        let norm = |values: &[f64]| values.iter().map(|v| v * v).sum::<f64>().sqrt();
        let ratio = |value: f64, scale: f64| if value == 0.0 { 0.0 } else { value / scale };
        let bricks = self.problem.mesh.brick_count();
        let volumes = (0..bricks)
            .map(|e| self.geometry.volume(e).powi(2))
            .sum::<f64>()
            .sqrt();
        let forces = norm(&system.force_magnitude).max(ROUND_OFF_SHARE * self.natural_force);
        Imbalance {
            force: ratio(norm(&system.residual), forces),
            volume: ratio(norm(&system.pressure_residual), volumes),
        }
    }

    /// Adds the displacement increments `du` (held ones included) and the pressures that belong to them.
    pub fn apply(&self, state: &mut State, system: &System, increments: &[Vector], factor: f64) {
        let (order, modes) = (self.order(), self.order().pressure_modes());
        let unknowns = 3 * order.brick_nodes();
        let mut local = vec![[0.0; 3]; order.brick_nodes()];
        let mut change = vec![0.0; modes];
        for element in 0..self.problem.mesh.brick_count() {
            gather(increments, self.problem.mesh.brick(element), &mut local);
            SolidContribution::pressure_increment(
                &self.problem.solid,
                &self.geometry,
                element,
                &system.coupling[element * modes * unknowns..(element + 1) * modes * unknowns],
                &system.pressure_residual[element * modes..(element + 1) * modes],
                local.as_flattened(),
                &mut change,
            );
            for (p, dp) in state.pressure[element * modes..(element + 1) * modes]
                .iter_mut()
                .zip(&change)
            {
                *p += factor * dp;
            }
        }
        for (u, du) in state.displacement.iter_mut().zip(increments) {
            for i in 0..3 {
                u[i] += factor * du[i];
            }
        }
    }

    /// Largest |J - 1| of a brick's mean.
    pub fn max_volume_change(&self, state: &State) -> f64 {
        self.volume_ratios(state)
            .map(|(mean, _)| (mean - 1.0).abs())
            .fold(0.0, f64::max)
    }

    /// Smallest J of an integration point; minus infinity when one isn't a number.
    pub fn min_volume_ratio(&self, state: &State) -> f64 {
        self.volume_ratios(state)
            .map(|(_, smallest)| {
                if smallest.is_nan() {
                    f64::NEG_INFINITY
                } else {
                    smallest
                }
            })
            .fold(f64::INFINITY, f64::min)
    }

    /// Mean and smallest J of each brick.
    fn volume_ratios(&self, state: &State) -> impl Iterator<Item = (f64, f64)> {
        let mut displacement = vec![[0.0; 3]; self.order().brick_nodes()];
        (0..self.problem.mesh.brick_count()).map(move |element| {
            gather(
                &state.displacement,
                self.problem.mesh.brick(element),
                &mut displacement,
            );
            self.geometry.volume_ratios(element, &displacement)
        })
    }
}

fn natural_force(problem: &Problem, geometry: &SolidGeometry) -> f64 {
    let volume: f64 = (0..problem.mesh.brick_count())
        .map(|e| geometry.volume(e))
        .sum();
    let fibres: f64 = problem.membranes.iter().map(Membrane::natural_force).sum();
    problem.solid.material.shear_modulus() * volume.powf(2.0 / 3.0) + fibres
}

fn gather(values: &[Vector], nodes: &[u32], local: &mut [Vector]) {
    for (target, &node) in local.iter_mut().zip(nodes) {
        *target = values[node as usize];
    }
}

impl FaceBuffers {
    fn clear(&mut self, tangent: bool) {
        self.residual.fill(0.0);
        if tangent {
            self.stiffness.fill(0.0);
        }
    }

    fn move_to(&mut self, problem: &Problem, state: &State, nodes: &[u32]) {
        for (position, &node) in self.positions.iter_mut().zip(nodes) {
            *position = state.position(&problem.mesh, node);
        }
    }

    fn scatter(
        &self,
        equations: &Equations,
        nodes: &[u32],
        index: usize,
        scatter: &[u32],
        pending: Option<&[Vector]>,
        system: &mut System,
    ) {
        let packed = self.residual.len() * (self.residual.len() + 1) / 2;
        system.add_forces(equations, nodes, &self.residual);
        if let Some(pending) = pending {
            let scatter = &scatter[index * packed..(index + 1) * packed];
            system.add_tangent(
                equations,
                nodes,
                &self.residual,
                &self.stiffness,
                scatter,
                pending,
            );
        }
    }
}
