//! Dimensions of a scene's uninflated tire, and the mesh of a level.

use fem::cell::element::Order;
use fem_client::scene::{Level, Scene};
use fem_client::solver::Readout;

use super::glued_film::Place;
use crate::mesh::tire_grid::{MeshPlan, TireShape};

/// The mesh of a level. The fine sector covers the stations and at least 18 degrees; its bricks keep their size when it
/// grows.
pub fn mesh_plan(scene: &Scene, level: Level) -> MeshPlan {
    mesh_plan_for(scene, level, &Readout::default())
}

/// The mesh of a level whose fine sector covers the films that are read, too, and as much as is asked for.
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
        .chain(readout.fine_deg)
        .fold(of_ground, f64::max)
        .clamp(SMALLEST_SECTOR, LARGEST_SECTOR);
    let plan = |order, fine: f64, coarse, meridional, meridional_growth, layers| MeshPlan {
        order,
        fine_angle: sector_deg.to_radians(),
        fine: (fine * sector_deg / SMALLEST_SECTOR).ceil() as usize,
        coarse,
        meridional,
        meridional_growth,
        layers,
    };
    match level {
        Level::Draft => plan(Order::Linear, 10.0, 5, 10, 3.0, 2),
        Level::Coarse => plan(Order::Quadratic, 5.0, 3, 8, 4.0, 2),
        Level::Standard => plan(Order::Quadratic, 8.0, 5, 12, 4.0, 3),
        Level::Reference => plan(Order::Quadratic, 10.0, 6, 18, 5.0, 4),
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
