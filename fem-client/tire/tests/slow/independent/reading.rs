//! The other code's readout: strains of the elements' own displacements, not recovered ones, averaged over the
//! neighbouring bricks at each node of the crown line, linear between nodes. An 8-node brick has one meridional stretch along
//! a meridian: at the crown that code takes the even parabola in the section angle through the middles of the first two.
//!
//! Its description says nothing of this, we found it by trying: see `docs/proof/independent.md`.

use fem::cell::element::{Order, brick_gradients};
use fem::cell::mesh::SurfacePoint;
use fem::problem::{Problem, State};
use fem::surface::chart::Recovery;
use fem::tensor::{Tensor, cofactor, determinant, multiply, transpose};
use tire::mesh::tire_grid::MeshPlan;
use tire::model::TireModel;

use super::pressing::{Press, Pressed};

/// Wheel angle by which both sides of a node are read, rad: far below a brick's, far above round-off.
const BESIDE: f64 = 1e-9;

/// Strains of a pressed tire since inflation, and its stress.
pub struct Reading<'p> {
    model: &'p TireModel,
    state: &'p State,
    inflated: Recovery<'p>,
    pressed: Recovery<'p>,
    /// Angle between the nodes of the crown line in the fine sector, rad.
    line: f64,
    /// Section angles of the nodes of quadratic bricks, rad: all nodes, or those of linear ones and their middles.
    meridian: Vec<f64>,
}

impl<'p> Reading<'p> {
    pub fn new(press: &'p Press<'_>, plan: &MeshPlan, solved: &'p Pressed) -> Self {
        let (model, mesh) = (press.model, &press.model.problem.mesh);
        let [inflated, pressed] = [&press.inflated, &solved.state]
            .map(|state| Recovery::new(&model.chart, mesh, |node| state.position(mesh, node)));
        Self {
            model,
            state: &solved.state,
            inflated,
            pressed,
            line: plan.fine_angle / (plan.fine * (plan.order.edge_nodes() - 1)) as f64,
            meridian: meridian(model, plan),
        }
    }

    /// Strains along x and y at a node of the crown line, averaged over both sides, rad.
    pub fn at_node(&self, theta: f64) -> [f64; 2] {
        self.average(&[theta - BESIDE, theta + BESIDE].map(|theta| [theta, 0.0]))
    }

    /// Strains along x and y above the contact centre at a section angle, rad: linear between nodes.
    pub fn at_section(&self, phi: f64) -> [f64; 2] {
        let above = self.meridian.partition_point(|node| *node < phi);
        let (low, high) = (self.meridian[above - 1], self.meridian[above]);
        let share = (phi - low) / (high - low);
        let ends = [low, high]
            .map(|phi| self.average(&[phi - BESIDE, phi + BESIDE].map(|phi| [0.0, phi])));
        [0, 1].map(|i| (1.0 - share) * ends[0][i] + share * ends[1][i])
    }

    /// Strains from the mean stretches at these wheel and section angles.
    fn average(&self, points: &[[f64; 2]]) -> [f64; 2] {
        let [before, after] = [&self.inflated, &self.pressed].map(|state| {
            let stretches = points.iter().map(|p| self.stretches(state, p[0], p[1]));
            stretches.fold([0.0; 2], |sum, s| [sum[0] + s[0], sum[1] + s[1]])
        });
        [0, 1].map(|i| after[i] / before[i] - 1.0)
    }

    /// Strains at the crown at a wheel angle within the fine sector, rad.
    pub fn at(&self, theta: f64) -> [f64; 2] {
        self.between_nodes(theta, |node| self.at_node(node))
    }

    /// Von Mises stress there, MPa.
    pub fn von_mises_at(&self, theta: f64) -> f64 {
        self.between_nodes(theta, |node| [self.von_mises_at_node(node)])[0]
    }

    /// Von Mises stress at a node of the crown line, averaged over both sides, MPa.
    pub fn von_mises_at_node(&self, theta: f64) -> f64 {
        let sides = [theta - BESIDE, theta + BESIDE].map(|theta| self.von_mises(theta));
        0.5 * (sides[0] + sides[1])
    }

    fn between_nodes<const N: usize>(
        &self,
        theta: f64,
        at_node: impl Fn(f64) -> [f64; N],
    ) -> [f64; N] {
        let place = theta / self.line;
        let below = place.floor();
        let share = place - below;
        let (low, high) = (
            at_node(below * self.line),
            at_node((below + 1.0) * self.line),
        );
        std::array::from_fn(|i| (1.0 - share) * low[i] + share * high[i])
    }

    /// Stretches along x and y of the inflated crown.
    pub fn inflated_stretch(&self) -> [f64; 2] {
        self.stretches(&self.inflated, 0.0, 0.0)
    }

    /// Stretches along x and y of a state at a point within a brick, rad.
    fn stretches(&self, state: &Recovery<'_>, theta: f64, phi: f64) -> [f64; 2] {
        let grid = &self.model.grid;
        let raw = state.raw_at(grid.inner_point(theta, phi));
        if phi != 0.0 || grid.order != Order::Linear {
            return [raw.s1, raw.s2];
        }
        let [near, far] = [1, 3].map(|middle| {
            let phi = self.meridian[middle];
            let stretch = state.raw_at(grid.inner_point(theta, phi)).s2;
            (phi * phi, stretch)
        });
        let slope = (far.1 - near.1) / (far.0 - near.0);
        [raw.s1, near.1 - slope * near.0]
    }

    /// Von Mises stress of the brick at a point of the crown's inner surface, from its own deformation gradient.
    fn von_mises(&self, theta: f64) -> f64 {
        let (problem, grid) = (&self.model.problem, &self.model.grid);
        let point = grid.inner_point(theta, 0.0);
        let layers = grid.brick_count() / self.model.chart.surface.face_count();
        let local = [point.local[0], point.local[1], -1.0];
        let f = deformation_gradient(problem, self.state, point.face * layers, local);
        let stress = multiply(&problem.solid.material.stress(&f), &transpose(&f));
        // The isochoric law's Kirchhoff stress has no mean part.
        let squares: f64 = stress.iter().flatten().map(|s| s * s).sum();
        (1.5 * squares).sqrt() / determinant(&f)
    }
}

fn meridian(model: &TireModel, plan: &MeshPlan) -> Vec<f64> {
    let angle = |face, local| {
        let point = SurfacePoint {
            face,
            local: [local, 0.0],
        };
        model.chart.position(point)[1] / model.grid.shape.inner
    };
    let ends = (0..plan.meridional).flat_map(|face| [angle(face, -1.0), angle(face, 0.0)]);
    ends.chain([model.grid.shape.bead_angle]).collect()
}

/// Deformation gradient of a brick at a point of its own coordinates.
pub fn deformation_gradient(
    problem: &Problem,
    state: &State,
    brick: usize,
    local: [f64; 3],
) -> Tensor {
    let mesh = &problem.mesh;
    let gradients = brick_gradients(mesh.order, local);
    let nodes = &mesh.bricks[brick * gradients.len()..][..gradients.len()];
    let mut maps = [[[0.0; 3]; 3]; 2];
    for (&node, gradient) in nodes.iter().zip(&gradients) {
        let positions = [mesh.nodes[node as usize], state.position(mesh, node)];
        for (map, position) in maps.iter_mut().zip(positions) {
            for i in 0..3 {
                for j in 0..3 {
                    map[i][j] += position[i] * gradient[j];
                }
            }
        }
    }
    let [reference, current] = maps;
    let volume = determinant(&reference);
    let inverse = transpose(&cofactor(&reference)).map(|row| row.map(|c| c / volume));
    multiply(&current, &inverse)
}

/// Vertical force on the whole tire, N.
pub fn reaction(model: &TireModel, pressed: &Pressed) -> f64 {
    let mesh = &model.problem.mesh;
    let contact = model.problem.contact.as_ref().expect("a tire has a tread");
    let field = pressed.loads.ground.as_ref().expect("it is pressed");
    let resultant = contact.resultant(field, |node| pressed.state.position(mesh, node));
    model.multiplicity() * resultant.load
}
