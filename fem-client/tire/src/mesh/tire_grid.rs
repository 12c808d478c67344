//! The structured mesh of a toroidal tire.
//!
//! A point of the wall has the wheel angle theta (0 at the contact centre), the section angle phi (0 at the crown) and the
//! section radius rho: with r = R_c + rho cos(phi), x = r sin(theta), y = rho sin(phi), z = -r cos(theta). Most scenes
//! need y >= 0 only, as ground and loads are constant across an upright wheel; a quarter mesh keeps x >= 0 too. Bricks run
//! along (phi, theta, rho), which is right-handed; brick numbers run fastest along rho, then phi, then theta.

use std::f64::consts::TAU;

use fem::cell::element::Order;
use fem::cell::mesh::Mesh;

use crate::mesh::grid_lines::{fitted, graded, half_circle, layers, split};

/// Fineness of a tire's mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshPlan {
    /// Element order.
    pub order: Order,
    /// Half of the finely meshed sector, rad.
    pub fine_angle: f64,
    /// Bricks along the fine half sector.
    pub fine: usize,
    /// Sector beyond the fine one whose bricks grow slowly; `None` where the far side begins at once.
    pub middle: Option<MiddleSector>,
    /// Bricks from there to the far side.
    pub coarse: usize,
    /// Bricks from crown to bead.
    pub meridional: usize,
    /// Size of the brick at the bead over that at the crown.
    pub meridional_growth: f64,
    /// Bricks through the wall.
    pub layers: usize,
}

/// A sector between the fine one and the far side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MiddleSector {
    /// Wheel angle from the contact centre at which it ends, rad.
    pub end: f64,
    /// Bricks along its half.
    pub bricks: usize,
}

impl MeshPlan {
    /// Cells between neighbouring nodes, in a quarter of the tire: a quadratic brick has eight.
    pub fn cells(&self) -> usize {
        let along = self.order.edge_nodes() - 1;
        let middle = self.middle.map_or(0, |middle| middle.bricks);
        (self.fine + middle + self.coarse) * self.meridional * self.layers * along.pow(3)
    }
}

/// Dimensions of the uninflated tire, mm and rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TireShape {
    /// Distance of the section's centre from the axle, mm.
    pub centre_radius: f64,
    /// Inner radius of the section, mm.
    pub inner: f64,
    /// Outer radius of the section, mm.
    pub outer: f64,
    /// Section angle of the bead, rad.
    pub bead_angle: f64,
    /// Section radius of the layer boundary that carries the carcass, mm; `None` without carcass.
    pub carcass: Option<f64>,
}

/// Part of the tire that is meshed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// y >= 0 and x >= 0.
    Quarter,
    /// y >= 0, all around the wheel.
    Half,
    /// x >= 0, on both sides of the middle plane: for a wheel that leans.
    Front,
    /// The whole wheel, for films that lie askew across the middle plane.
    Full,
}

impl Extent {
    /// The part that reaches all around the wheel or not, and to both sides of the middle plane or not.
    pub fn of(is_whole_along: bool, is_whole_across: bool) -> Self {
        match (is_whole_along, is_whole_across) {
            (false, false) => Self::Quarter,
            (true, false) => Self::Half,
            (false, true) => Self::Front,
            (true, true) => Self::Full,
        }
    }

    /// Whether it reaches all around the wheel.
    pub fn is_whole_along(self) -> bool {
        matches!(self, Self::Half | Self::Full)
    }

    /// Whether it lies on both sides of the middle plane.
    pub fn is_whole_across(self) -> bool {
        matches!(self, Self::Front | Self::Full)
    }

    /// Returns the smallest part that holds this one and another.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        Self::of(
            self.is_whole_along() || other.is_whole_along(),
            self.is_whole_across() || other.is_whole_across(),
        )
    }
}

/// A part of the inner surface that asks for lines of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Patch {
    /// Ends around the wheel and along the section, rad.
    pub(crate) ends: [[f64; 2]; 2],
    /// Largest bricks in it, rad.
    pub(crate) most: [f64; 2],
    /// Whether its ends are lines.
    pub(crate) is_fitted: bool,
}

/// Ends around the wheel (`k` 0), also a turn before and after, as lines are numbered from the far side on; ends along the section (1) as they are.
pub(crate) fn turned(ends: [f64; 2], k: usize) -> impl Iterator<Item = [f64; 2]> {
    let turns: &[f64] = if k == 0 { &[-TAU, 0.0, TAU] } else { &[0.0] };
    turns.iter().map(move |turn| ends.map(|end| end + turn))
}

/// Grid lines of the mesh: edges of the bricks along each direction.
#[derive(Debug, Clone, PartialEq)]
pub struct TireGrid {
    /// Element order.
    pub order: Order,
    /// Part that is meshed.
    pub extent: Extent,
    /// Dimensions.
    pub shape: TireShape,
    /// Whether the last section is the first.
    pub is_closed: bool,
    /// Edges around the wheel, rad.
    pub theta: Vec<f64>,
    /// Edges from crown (or bead) to bead, rad.
    pub phi: Vec<f64>,
    /// Edges through the wall, mm.
    pub rho: Vec<f64>,
}

impl TireGrid {
    /// Lays out the grid lines.
    pub fn new(shape: TireShape, plan: &MeshPlan, extent: Extent) -> Self {
        let middle = plan.middle.map(|middle| (middle.end, middle.bricks));
        let half = half_circle((plan.fine_angle, plan.fine), middle, plan.coarse);
        let theta = match extent.is_whole_along() {
            false => half,
            true => both_sides(&half),
        };
        let side = graded(
            0.0,
            shape.bead_angle,
            plan.meridional,
            plan.meridional_growth,
        );
        let phi = match extent.is_whole_across() {
            true => both_sides(&side),
            false => side,
        };
        Self {
            order: plan.order,
            extent,
            shape,
            is_closed: extent.is_whole_along(),
            theta,
            phi,
            rho: layers(shape.inner, shape.outer, shape.carcass, plan.layers),
        }
    }

    /// Returns this grid with lines at the ends of these wheel and section angles, rad, and bricks between them no larger than that; without lines at the
    /// ends where they don't fit anything.
    pub(crate) fn around(mut self, patch: &Patch) -> Self {
        for k in 0..2 {
            for ends in turned(patch.ends[k], k) {
                let edges = [&self.theta, &self.phi][k];
                let edges = match patch.is_fitted {
                    true => fitted(edges, ends, patch.most[k]),
                    false => split(edges, ends, patch.most[k]),
                };
                *[&mut self.theta, &mut self.phi][k] = edges;
            }
        }
        self
    }

    pub(crate) fn bricks(&self) -> [usize; 3] {
        [self.phi.len() - 1, self.theta.len() - 1, self.rho.len() - 1]
    }

    /// Number of solid elements.
    pub fn brick_count(&self) -> usize {
        self.bricks().iter().product()
    }

    /// Distinct nodes along the wheel: all around, the last line is the first.
    pub fn theta_nodes(&self) -> usize {
        let lines = (self.order.edge_nodes() - 1) * self.bricks()[1];
        lines + usize::from(!self.is_closed)
    }

    /// Nodes along the section, from crown (or bead) to bead.
    pub fn phi_nodes(&self) -> usize {
        (self.order.edge_nodes() - 1) * self.bricks()[0] + 1
    }

    /// Nodes through the wall, the inner surface first.
    pub fn rho_nodes(&self) -> usize {
        (self.order.edge_nodes() - 1) * self.bricks()[2] + 1
    }

    /// Node number from node indices along phi, theta and rho.
    pub fn node(&self, [phi, theta, rho]: [usize; 3]) -> u32 {
        let theta = theta % self.theta_nodes();
        ((theta * self.phi_nodes() + phi) * self.rho_nodes() + rho) as u32
    }

    /// Angles of a node line: the brick edges and, for order 2, their midpoints.
    pub fn line(&self, edges: &[f64], index: usize) -> f64 {
        let e = self.order.edge_nodes() - 1;
        let (brick, within) = (index / e, index % e);
        if within == 0 {
            edges[brick]
        } else {
            0.5 * (edges[brick] + edges[brick + 1])
        }
    }

    /// Bricks with their nodes (mm), and the logical position of each brick, in bricks.
    pub fn mesh(&self) -> (Mesh, Vec<[f64; 3]>) {
        let mut nodes =
            Vec::with_capacity(self.theta_nodes() * self.phi_nodes() * self.rho_nodes());
        for theta in 0..self.theta_nodes() {
            for phi in 0..self.phi_nodes() {
                for rho in 0..self.rho_nodes() {
                    nodes.push(self.shape.position(
                        self.line(&self.theta, theta),
                        self.line(&self.phi, phi),
                        self.line(&self.rho, rho),
                    ));
                }
            }
        }
        let [nphi, ntheta, nrho] = self.bricks();
        let e = self.order.edge_nodes();
        let (mut bricks, mut layout) = (Vec::new(), Vec::new());
        for theta in 0..ntheta {
            for phi in 0..nphi {
                for rho in 0..nrho {
                    layout.push([phi as f64, theta as f64, rho as f64]);
                    for k in 0..e {
                        for j in 0..e {
                            for i in 0..e {
                                let at = |brick: usize, local: usize| brick * (e - 1) + local;
                                bricks.push(self.node([at(phi, i), at(theta, j), at(rho, k)]));
                            }
                        }
                    }
                }
            }
        }
        (
            Mesh {
                order: self.order,
                nodes,
                bricks,
            },
            layout,
        )
    }

    /// Nodes of the section on this line along the wheel.
    pub(crate) fn section(&self, theta: usize) -> impl Iterator<Item = u32> {
        let (phi, rho) = (self.phi_nodes(), self.rho_nodes());
        (0..phi * rho).map(move |k| self.node([k / rho, theta, k % rho]))
    }

    /// Node at the outer crown of the contact centre.
    pub fn lowest_node(&self) -> u32 {
        let [crown, centre] = [&self.phi, &self.theta].map(|edges| self.zero(edges));
        self.node([crown, centre, self.rho_nodes() - 1])
    }

    /// Nodes of the outer surface above the contact centre, from crown (or bead) to bead: as many for each brick as its edge has, its last the next one's first.
    pub(crate) fn outer_section(&self) -> Vec<u32> {
        let centre = self.zero(&self.theta);
        let lines = 0..self.phi_nodes();
        lines
            .map(|phi| self.node([phi, centre, self.rho_nodes() - 1]))
            .collect()
    }

    /// Number of the node line at angle 0.
    fn zero(&self, edges: &[f64]) -> usize {
        let edge = edges.iter().position(|&angle| angle == 0.0).unwrap_or(0);
        edge * (self.order.edge_nodes() - 1)
    }

    /// Node of the inner surface on these grid lines.
    pub(crate) fn inner_node(&self, phi: usize, theta: usize) -> u32 {
        self.node([phi, theta, 0])
    }

    /// Nodes on the bead, and on the planes of symmetry y = 0 and x = 0 that bound the mesh.
    pub(crate) fn held_nodes(&self) -> HeldNodes {
        let (last_phi, last_theta) = (self.phi_nodes() - 1, self.theta_nodes() - 1);
        let mut held = HeldNodes::default();
        for theta in 0..=last_theta {
            for rho in 0..self.rho_nodes() {
                held.bead.push(self.node([last_phi, theta, rho]));
                let first = self.node([0, theta, rho]);
                match self.extent.is_whole_across() {
                    true => held.bead.push(first),
                    false => held.middle_plane.push(first),
                }
            }
        }
        let sections = [
            (0, self.theta[0]),
            (last_theta, self.theta[self.theta.len() - 1]),
        ];
        let in_plane = |angle: f64| angle == 0.0 || angle == std::f64::consts::PI;
        for (theta, _) in sections.into_iter().filter(|(_, angle)| in_plane(*angle)) {
            if !self.extent.is_whole_along() {
                held.cross_plane.extend(self.section(theta));
            }
        }
        held
    }
}

/// The lines from 0 on with their mirror images.
fn both_sides(edges: &[f64]) -> Vec<f64> {
    let mirrored = edges.iter().skip(1).rev().map(|edge| -edge);
    mirrored.chain(edges.iter().copied()).collect()
}

/// Nodes with supports.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct HeldNodes {
    /// Clamped nodes.
    pub bead: Vec<u32>,
    /// Nodes in the plane y = 0.
    pub middle_plane: Vec<u32>,
    /// Nodes in the plane x = 0.
    pub cross_plane: Vec<u32>,
}

impl TireShape {
    /// Position of a material point in the uninflated tire, mm.
    pub fn position(&self, theta: f64, phi: f64, rho: f64) -> [f64; 3] {
        let r = self.centre_radius + rho * phi.cos();
        [r * theta.sin(), rho * phi.sin(), -r * theta.cos()]
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) const SHAPE: TireShape = TireShape {
        centre_radius: 37.5,
        inner: 9.5,
        outer: 12.5,
        bead_angle: 2.0943951023931953,
        carcass: Some(11.0),
    };

    pub(crate) fn plan(order: Order) -> MeshPlan {
        MeshPlan {
            order,
            fine_angle: 0.4,
            fine: 6,
            middle: None,
            coarse: 6,
            meridional: 6,
            meridional_growth: 2.0,
            layers: 2,
        }
    }

    #[test]
    fn every_brick_is_right_handed_and_the_volume_is_the_torus() {
        // Half of the wall by Pappus: area of the section times the path of its centroid.
        let section = 0.5 * SHAPE.bead_angle * (12.5f64.powi(2) - 9.5f64.powi(2));
        let moment = (12.5f64.powi(3) - 9.5f64.powi(3)) / 3.0 * SHAPE.bead_angle.sin();
        let exact = TAU * (37.5 * section + moment);
        let error = |extent, refinement: usize| {
            let coarse = plan(Order::Quadratic);
            let plan = MeshPlan {
                fine: refinement * coarse.fine,
                coarse: refinement * coarse.coarse,
                meridional: refinement * coarse.meridional,
                ..coarse
            };
            let (mesh, _) = TireGrid::new(SHAPE, &plan, extent).mesh();
            let geometry = fem::solid::SolidGeometry::new(&mesh).unwrap();
            let volume: f64 = (0..mesh.brick_count()).map(|e| geometry.volume(e)).sum();
            let share = if extent == Extent::Half { 1.0 } else { 0.5 };
            (volume / (share * exact) - 1.0).abs()
        };
        for extent in [Extent::Half, Extent::Quarter] {
            // Quadratic arcs approach the circle with the fourth power of their angle: 16 times closer where bricks are
            // halved. The largest brick of the graded sector only shrinks from 1.086 to 0.628 rad, which alone is 8.9
            // times; all together 11.9 was seen, and the bound below pins that observation.
            let (coarse, fine) = (error(extent, 1), error(extent, 2));
            assert!(
                coarse < 2e-3 && coarse / fine > 11.5,
                "{extent:?}: {coarse:e}, {fine:e}"
            );
        }
    }

    #[test]
    fn grid_lines_end_where_they_should() {
        let grid = TireGrid::new(SHAPE, &plan(Order::Linear), Extent::Half);
        assert_eq!(grid.theta.first(), Some(&-std::f64::consts::PI));
        assert_eq!(grid.theta.last(), Some(&std::f64::consts::PI));
        assert!(grid.theta.windows(2).all(|w| w[1] > w[0]));
        assert!(grid.rho.contains(&11.0));
        let centre = grid.lowest_node();
        let (mesh, _) = grid.mesh();
        let [x, y, z] = mesh.nodes[centre as usize];
        assert!(x == 0.0 && y == 0.0 && (z + 50.0).abs() < 1e-13);
    }
}
