//! The whole solved tire, for pictures.

use fem::cell::element::Order;
use fem::load::obstacle::HeightField;
use fem::problem::State;
use fem::solid::{MeanStress, SolidGeometry};
use fem::tensor::{Tensor, Vector};
use serde_json::json;
use sha2::{Digest, Sha256};

use crate::wheel_skins::WheelSkins;
use crate::{CellShape, DataArray, VtuGrid};
use fem_client::scene::Scene;
use fem_client::solver::StartState;
use tire::mesh::tire_grid::Extent;
use tire::model::{TireModel, extent, mesh_plan};

/// A tire's mesh with its two states.
#[derive(Debug)]
pub struct Body {
    model: TireModel,
    scene: Scene,
    inflated: State,
    equilibrium: State,
    depths_mm: Vec<f64>,
}

impl Body {
    /// The body that the embedded solver left in this state. `None` when the state isn't one of the scene's mesh: other solvers keep
    /// none.
    pub fn of(scene: &Scene, state: &StartState) -> Option<Self> {
        let plan = mesh_plan(scene, scene.model.level);
        let model = TireModel::new(scene, &plan, extent(scene));
        let [inflated, equilibrium] = [&state.inflated, &state.equilibrium]
            .map(|flat| State::from_flat(&model.problem, flat));
        Some(Self {
            inflated: inflated?,
            equilibrium: equilibrium?,
            scene: scene.clone(),
            depths_mm: state.depths_mm.clone(),
            model,
        })
    }

    /// The mesh in the undeformed state, the displacements from there to the inflated state and to the equilibrium, and mean stresses of
    /// the bricks. `version` says who solved.
    pub fn grid(&self, version: &str) -> VtuGrid {
        let mesh = &self.model.problem.mesh;
        let order = vtk_order(mesh.order);
        let bricks = (0..mesh.brick_count()).map(|element| mesh.brick(element));
        VtuGrid {
            points: mesh.nodes.clone(),
            shape: match mesh.order {
                Order::Quadratic | Order::PlaneQuadratic => CellShape::TriquadraticHexahedron,
                Order::Linear | Order::PlaneLinear => CellShape::Hexahedron,
            },
            cells: bricks
                .flat_map(|brick| order.iter().map(|&node| brick[node]))
                .collect(),
            point_data: vec![
                DataArray::vectors("displacement", "mm", &self.equilibrium.displacement),
                DataArray::vectors("displacement_inflated", "mm", &self.inflated.displacement),
            ],
            cell_data: self.stresses(),
            texts: self.texts(version),
        }
    }

    /// Both skins of the whole wheel, and the ground.
    pub fn skins(&self) -> WheelSkins {
        // Ground that presses with a force stands where the state says.
        let ground = HeightField {
            depths: self.depths_mm.clone(),
            ..self.model.ground_below(&self.scene.ground, &self.inflated)
        };
        WheelSkins::of(&self.model, [&self.inflated, &self.equilibrium], &ground)
    }

    fn stresses(&self) -> Vec<DataArray> {
        let problem = &self.model.problem;
        // What was solved on this mesh has it without an inverted brick.
        let Ok(geometry) = SolidGeometry::new(&problem.mesh) else {
            return Vec::new();
        };
        let modes = problem.mesh.order.pressure_modes();
        let pressures = self.equilibrium.pressure.chunks_exact(modes);
        let stress = |(element, pressure): (usize, &[f64])| {
            let nodes = problem.mesh.brick(element).iter();
            let displacement: Vec<Vector> = nodes
                .map(|&node| self.equilibrium.displacement[node as usize])
                .collect();
            geometry.mean_stress(&problem.solid, element, &displacement, pressure)
        };
        let stresses: Vec<MeanStress> = pressures.enumerate().map(stress).collect();
        let trace = |s: &Tensor| (s[0][0] + s[1][1] + s[2][2]) / 3.0;
        // VTK's order of a symmetric tensor.
        let six = |s: &Tensor| [s[0][0], s[1][1], s[2][2], s[0][1], s[1][2], s[0][2]];
        let cauchy = stresses.iter().flat_map(|stress| six(&stress.cauchy));
        let means = stresses.iter().map(|stress| trace(&stress.cauchy));
        let von_mises = stresses.iter().map(|stress| stress.von_mises);
        vec![
            DataArray::floats("von_mises_mpa", "MPa", 1, von_mises.collect()),
            DataArray::floats("mean_stress_mpa", "MPa", 1, means.collect()),
            DataArray::floats("cauchy_stress_mpa", "MPa", 6, cauchy.collect()),
        ]
    }

    fn texts(&self, version: &str) -> Vec<(&'static str, String)> {
        let scene = self.scene.canonical_json();
        let hash = Sha256::digest(&scene);
        let symmetry = match self.model.grid.extent {
            Extent::Full => "the whole tire",
            Extent::Half => {
                "half of the tire, y >= 0: the other half is its mirror image at the plane y = 0"
            }
            Extent::Front => {
                "half of the tire, x >= 0: the other half is its mirror image at the plane x = 0"
            }
            Extent::Quarter => {
                "a quarter of the tire, x >= 0 and y >= 0: the rest are its mirror images at the planes x = 0 and y = 0"
            }
        };
        vec![
            (
                "scene_sha256",
                hash.iter().map(|byte| format!("{byte:02x}")).collect(),
            ),
            ("version", version.to_owned()),
            ("symmetry", symmetry.to_owned()),
            ("reading", READING.to_owned()),
            (
                "units",
                json!({
                    "points": "mm", "displacement": "mm", "displacement_inflated": "mm",
                    "von_mises_mpa": "MPa", "mean_stress_mpa": "MPa", "cauchy_stress_mpa": "MPa",
                })
                .to_string(),
            ),
            ("scene", scene),
        ]
    }
}

const READING: &str = "Points are those of the undeformed tire, x in the rolling direction, y along the axle, z upward from the wheel's centre; \
    warped by displacement they are those of the equilibrium, by displacement_inflated those of the inflated tire before contact. Stresses are means \
    over a brick's volume in the equilibrium, of the rubber without cords and film; cauchy_stress_mpa is xx, yy, zz, xy, yz, xz.";

/// Returns the places of VTK's nodes of a brick among ours, which run along the first direction fastest.
fn vtk_order(order: Order) -> Vec<usize> {
    // In halves of an edge: corners; edges below, above and between; faces; the middle.
    const PLACES: [[usize; 3]; 27] = [
        [0, 0, 0],
        [2, 0, 0],
        [2, 2, 0],
        [0, 2, 0],
        [0, 0, 2],
        [2, 0, 2],
        [2, 2, 2],
        [0, 2, 2],
        [1, 0, 0],
        [2, 1, 0],
        [1, 2, 0],
        [0, 1, 0],
        [1, 0, 2],
        [2, 1, 2],
        [1, 2, 2],
        [0, 1, 2],
        [0, 0, 1],
        [2, 0, 1],
        [2, 2, 1],
        [0, 2, 1],
        [0, 1, 1],
        [2, 1, 1],
        [1, 0, 1],
        [1, 2, 1],
        [1, 1, 0],
        [1, 1, 2],
        [1, 1, 1],
    ];
    let n = order.edge_nodes();
    let step = 2 / (n - 1);
    let ours = |[i, j, k]: [usize; 3]| i + n * (j + n * k);
    let places = PLACES.iter().take(n * n * n);
    places
        .map(|place| ours(place.map(|half| half / step)))
        .collect()
}
