//! Dimensions of a scene's uninflated tire, and the mesh of a level.

use fem::cell::element::Order;
use fem_client::scene::{Level, Scene};
use fem_client::solver::Readout;

use super::glued_film::Place;
use crate::mesh::tire_grid::{MeshPlan, MiddleSector, TireShape};

/// Size of the last brick of the middle sector over that of the fine sector's.
const MIDDLE_GROWTH: f64 = 2.5;

/// The mesh of a level. The fine sector covers the stations and at least 18 degrees; its bricks keep their size when it
/// grows.
pub fn mesh_plan(scene: &Scene, level: Level) -> MeshPlan {
    mesh_plan_for(scene, level, &Readout::default())
}

/// The mesh of a level whose fine sector covers the films that are read, too, and whose bricks grow slowly in a sector as wide as the readout asks for.
pub fn mesh_plan_for(scene: &Scene, level: Level, readout: &Readout) -> MeshPlan {
    const SMALLEST_SECTOR: f64 = 18.0;
    const LARGEST_SECTOR: f64 = 80.0;
    let ground = &scene.ground;
    let half_width = 0.5 * ground.stations as f64 * ground.station_spacing_mm;
    let of_ground = (half_width / scene.geometry.outer_radius_mm).to_degrees();
    let shape = shape(scene);
    let of_films = readout
        .films
        .iter()
        .map(|film| Place::of(film, &shape).farthest().to_degrees());
    let sector_deg = of_films
        .fold(of_ground, f64::max)
        .clamp(SMALLEST_SECTOR, LARGEST_SECTOR);
    let plan = |order, fine: f64, coarse, meridional, meridional_growth, layers| MeshPlan {
        order,
        fine_angle: sector_deg.to_radians(),
        fine: (fine * sector_deg / SMALLEST_SECTOR).ceil() as usize,
        middle: readout
            .fine_deg
            .map(|end_deg| end_deg.min(LARGEST_SECTOR))
            .filter(|end_deg| *end_deg > sector_deg)
            .map(|end_deg| middle(sector_deg, end_deg, SMALLEST_SECTOR / fine)),
        coarse,
        meridional,
        meridional_growth,
        layers,
    };
    match level {
        Level::Draft => plan(Order::Linear, 10.0, 5, 10, 3.0, 2),
        Level::Coarse => plan(Order::Quadratic, 8.0, 4, 8, 8.0, 2),
        Level::Standard => plan(Order::Quadratic, 10.0, 5, 12, 8.0, 3),
        Level::Reference => plan(Order::Quadratic, 14.0, 6, 16, 8.0, 4),
    }
}

/// The sector between two angles whose bricks grow from `size` to [`MIDDLE_GROWTH`] times that, all in degrees.
fn middle(from: f64, to: f64, size: f64) -> MiddleSector {
    // The mean of sizes that grow geometrically, of many bricks.
    let mean = size * (MIDDLE_GROWTH - 1.0) / MIDDLE_GROWTH.ln();
    MiddleSector {
        end: to.to_radians(),
        bricks: ((to - from) / mean).ceil() as usize,
    }
}

/// Dimensions of the uninflated tire of a scene, mm and rad.
pub fn shape(scene: &Scene) -> TireShape {
    let geometry = &scene.geometry;
    let inner = geometry.section_radius_mm - geometry.wall_mm;
    TireShape {
        centre_radius: geometry.outer_radius_mm - geometry.section_radius_mm,
        inner,
        outer: geometry.section_radius_mm,
        bead_angle: geometry.bead_angle_deg.to_radians(),
        carcass: scene
            .carcass
            .as_ref()
            .map(|carcass| inner + carcass.position * geometry.wall_mm),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_tires_meshes_have_the_cells_that_the_contract_says() {
        for level in Level::ALL {
            let cells = mesh_plan(&Scene::default(), level).cells();
            assert_eq!(cells, level.cells_of_reference_tire(), "{level:?}");
        }
    }
}
