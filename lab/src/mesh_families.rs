//! Families of ever finer meshes of the reference tire.

use fem::cell::element::Order;
use tire::mesh::tire_grid::MeshPlan;

/// Both element families with their names.
pub const ORDERS: [(&str, Order); 2] = [("Q1P0", Order::Linear), ("Q2/P1", Order::Quadratic)];

/// Refinements of a family.
pub const REFINEMENTS: [usize; 5] = [1, 2, 3, 4, 5];

/// The meshes of a family: brick edges are `1 / refinement` of the coarsest mesh's in all directions and everywhere, and
/// the carcass always lies in the middle of the layers.
pub fn plan(order: Order, refinement: usize) -> MeshPlan {
    let [fine, coarse, meridional] = match order {
        Order::Linear | Order::PlaneLinear => [6, 4, 8],
        Order::Quadratic | Order::PlaneQuadratic => [3, 2, 4],
    };
    MeshPlan {
        order,
        fine_angle: 18f64.to_radians(),
        fine: fine * refinement,
        middle: None,
        coarse: coarse * refinement,
        meridional: meridional * refinement,
        meridional_growth: 6.0,
        layers: 2 * refinement,
    }
}
