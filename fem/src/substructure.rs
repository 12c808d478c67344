//! A part of a body taken as linear about one equilibrium: condensed for the rest of the body, and recovered from it.
//!
//! The part's tangent and its residual are eliminated onto the nodes that it shares with the rest, where a [`Superelement`]
//! stands for it. Once the rest is in equilibrium, one substitution gives the part's own displacements and pressures
//! (J. S. Przemieniecki, AIAA J. 1 (1963) 138, here about a deformed state).

use std::sync::Arc;

use faer::Mat;

use crate::assembly::Assembler;
use crate::linear::{LinearError, Workspace};
use crate::problem::{Loads, Problem, State};
use crate::setup::{Setup, SetupError};
use crate::sparsity::NONE;
use crate::superelement::Superelement;
use crate::system::Entries;
use crate::tangent::Tangent;
use crate::tensor::Vector;

/// A part of a body, linear about a state.
#[derive(Debug)]
pub struct Substructure {
    state: State,
    /// Nodes shared with the rest of the body.
    shared: Vec<u32>,
    tangent: Tangent,
    /// Condensed residual with a minus sign, by equations, the interior eliminated, N.
    reduced: Vec<f64>,
    volumes: Vec<f64>,
    /// Skew part of the tangent at the shared nodes, N/mm.
    skew: Mat<f64>,
}

/// Why a part can't be condensed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CondensationError {
    /// It can't be set up.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// Its tangent is singular or doesn't fit in memory.
    #[error(transparent)]
    Linear(#[from] LinearError),
    /// It is unstable although all shared nodes are held.
    #[error("the part is unstable where its shared nodes are held")]
    Unstable,
}

impl Substructure {
    /// Condenses a part, without contact, onto its `shared` nodes.
    ///
    /// # Errors
    /// [`CondensationError`].
    pub fn new(
        problem: &Problem,
        state: State,
        loads: &Loads,
        shared: Vec<u32>,
    ) -> Result<Self, CondensationError> {
        let setup = Arc::new(Setup::with_nodes_last(problem, &shared)?);
        let mut workspace = Workspace::new(&setup.symbolic)?;
        let mut assembler = Assembler::new(problem, setup.clone());
        let mut residuals = assembler.residuals();
        assembler.residual(&state, loads, &[], &mut residuals);
        let mut tangent = Tangent::new(setup.clone(), assembler.coupling_len())?;
        let mut entries = Entries::new(&setup);
        let still = vec![[0.0; 3]; problem.mesh.nodes.len()];
        assembler.tangent(&state, loads, &still, &mut entries, &mut tangent.coupling);
        tangent.factorise(&mut entries, &mut workspace)?;
        if !tangent.interior_inertia().is_positive() {
            return Err(CondensationError::Unstable);
        }
        let mut reduced = residuals.forces;
        assembler.add_condensed_volumes(&tangent.coupling, &residuals.volumes, &mut reduced);
        for value in &mut reduced {
            *value = -*value;
        }
        tangent.eliminate(&mut reduced, &mut workspace);
        Ok(Self {
            skew: skew_tangent(problem, &state, loads, &shared),
            state,
            shared,
            tangent,
            reduced,
            volumes: residuals.volumes,
        })
    }

    /// What the rest of the body feels, whose own numbers of the shared nodes are given in the same order.
    ///
    /// # Panics
    /// When there are more or fewer nodes than are shared.
    pub fn superelement(&self, nodes: Vec<u32>) -> Superelement {
        let unknowns = self.unknowns();
        let schur = self.tangent.schur();
        let mut stiffness = self.skew.clone();
        for (row, i) in unknowns.iter().enumerate() {
            for (column, j) in unknowns.iter().enumerate() {
                match (i, j) {
                    (Some(i), Some(j)) => stiffness[(row, column)] += schur[(*i, *j)],
                    _ => stiffness[(row, column)] = 0.0,
                }
            }
        }
        let interior = self.tangent.setup.equations.interior;
        let force = |place: &Option<usize>| place.map_or(0.0, |k| -self.reduced[interior + k]);
        let forces = unknowns.iter().map(force).collect();
        Superelement::new(nodes, self.shared_displacement(), forces, stiffness)
    }

    /// The part's state when its shared nodes have these displacements, mm.
    pub fn recover(&self, problem: &Problem, shared: &[Vector]) -> State {
        let setup = &self.tangent.setup;
        let mut solution = self.reduced.clone();
        let change = shared.iter().zip(self.shared_displacement());
        let change = change.flat_map(|(now, before)| [0, 1, 2].map(|i| now[i] - before[i]));
        for (place, change) in self.unknowns().iter().zip(change) {
            if let Some(place) = place {
                solution[setup.equations.interior + place] = change;
            }
        }
        let mut workspace = Workspace::for_substitutions();
        self.tangent.complete(&mut solution, &mut workspace);
        let of_node = |equations: &[u32; 3]| {
            equations.map(|equation| match equation {
                NONE => 0.0,
                equation => solution[equation as usize],
            })
        };
        let increments: Vec<Vector> = setup.equations.of_node.iter().map(of_node).collect();
        let mut pressures = vec![0.0; self.state.pressure.len()];
        Assembler::new(problem, setup.clone()).pressure_increments(
            &self.tangent.coupling,
            &self.volumes,
            &increments,
            &mut pressures,
        );
        let mut state = self.state.clone();
        state.add(1.0, &increments, &pressures);
        state
    }

    /// Places of the shared nodes' displacements in the border; `None` where one is held.
    fn unknowns(&self) -> Vec<Option<usize>> {
        let setup = &self.tangent.setup;
        let equations = setup.equations.of(&self.shared);
        equations
            .map(|equation| setup.in_border(equation))
            .collect()
    }

    fn shared_displacement(&self) -> Vec<Vector> {
        let displacement = &self.state.displacement;
        self.shared
            .iter()
            .map(|&n| displacement[n as usize])
            .collect()
    }
}

/// The skew tangent of live pressure at the shared nodes: a whole body has none, a part has it along its cut edge.
fn skew_tangent(problem: &Problem, state: &State, loads: &Loads, shared: &[u32]) -> Mat<f64> {
    let mut skew = Mat::zeros(3 * shared.len(), 3 * shared.len());
    let Some(surface) = &problem.pressure else {
        return skew;
    };
    let mut place = vec![None; problem.mesh.nodes.len()];
    for (k, &node) in shared.iter().enumerate() {
        place[node as usize] = Some(k);
    }
    for nodes in surface.surface.iter() {
        let places: Vec<Option<usize>> = nodes.iter().map(|&n| place[n as usize]).collect();
        if places.iter().all(Option::is_none) {
            continue;
        }
        let current: Vec<Vector> = nodes
            .iter()
            .map(|&n| state.position(&problem.mesh, n))
            .collect();
        let n = 3 * nodes.len();
        let mut block = vec![0.0; n * n];
        surface.add_skew_tangent(loads.pressure, &current, &mut block);
        let unknown = |k: usize| places[k / 3].map(|place| 3 * place + k % 3);
        for row in 0..n {
            for column in row + 1..n {
                if let (Some(i), Some(j)) = (unknown(row), unknown(column)) {
                    skew[(i, j)] += block[row * n + column];
                    skew[(j, i)] -= block[row * n + column];
                }
            }
        }
    }
    skew
}
