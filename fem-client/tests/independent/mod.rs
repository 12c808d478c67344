//! The reference tire as an independent code solved it, solved here on the same mesh, with its contact law and its readout.
//!
//! The other code's contact pressure is k (g + w)^2 / (4 w) from the gap g = -w to w = 0.004 mm and k g beyond: ours with a
//! ramp of 2 w and the ground raised by w. Its strains are those of the elements' own displacements, not recovered ones:
//! averaged over neighbouring bricks at each node of the crown line, linear between nodes. That readout, and the growth of its bricks towards the bead, aren't in its description: they were
//! found by trying, see `docs/convergence.md`.

use std::sync::atomic::AtomicBool;

use fem::element::Order;
use fem::newton::Newton;
use fem::path::{Stability, follow};
use fem::problem::{Loads, State};
use fem::surface::Recovery;
use fem_client::scene::Scene;
use fem_client::tire::{TireModel, cord_families, ground};
use fem_client::tire_mesh::{Extent, MeshPlan};

/// Half width of the smoothed corner of the other code's contact law, mm.
const CONTACT_HALF_WIDTH: f64 = 0.004;
/// Distance of P3, P4 and P5, mm.
const SPACING: f64 = 4.0;
/// Wheel angle by which both sides of a node are read, rad: far below a brick's, far above round-off.
const BESIDE: f64 = 1e-9;
/// Stick at any contact force.
const STICK: f64 = 1e6;

static RUNNING: AtomicBool = AtomicBool::new(false);

/// One equilibrium of the other code.
#[derive(Debug, Clone)]
pub struct Figures {
    pub case: String,
    pub plan: MeshPlan,
    pub scene: Scene,
    pub depth_mm: f64,
    pub inflated_stretch: Option<[f64; 2]>,
    pub solution: Solution,
}

impl Figures {
    /// Displacements of the mesh, held ones included.
    pub fn displacements(&self) -> usize {
        let plan = &self.plan;
        let nodes = |bricks: usize| (plan.order.edge_nodes() - 1) * bricks + 1;
        3 * nodes(plan.fine + plan.coarse) * nodes(plan.meridional) * nodes(plan.layers)
    }
}

/// What both codes answer.
#[derive(Debug, Clone, Copy)]
pub struct Solution {
    pub inflated_radius_mm: f64,
    pub reaction_n: f64,
    /// Strains at P3, P4 and P5.
    pub x: [f64; 3],
    pub y: [f64; 3],
}

/// Ours, with what the other code didn't print.
#[derive(Debug, Clone, Copy)]
pub struct Ours {
    pub solution: Solution,
    pub inflated_stretch: [f64; 2],
    /// Smallest stretch of a cord; infinite without carcass.
    pub least_cord_stretch: f64,
}

/// All equilibria of the other code, those of one case together.
pub fn figures() -> Vec<Figures> {
    let lines = include_str!("figures.csv").lines();
    let rows = lines.filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|row| figures_of(&row.split(',').collect::<Vec<_>>()))
        .collect()
}

fn figures_of(fields: &[&str]) -> Figures {
    let number = |k: usize| fields[k].parse::<f64>().expect("the table holds numbers");
    let count = |k: usize| fields[k].parse().expect("the table holds counts");
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.material.d1_per_mpa = 2.0 / 360.0;
    scene.pressure.internal_mpa = number(6);
    match number(7) {
        0.0 => scene.carcass = None,
        stiffness => {
            let carcass = scene.carcass.as_mut().expect("the preset has a carcass");
            carcass.stiffness_n_per_mm = stiffness;
        }
    }
    scene.contact.penalty_n_per_mm3 = Some(number(8));
    scene.contact.friction = STICK * number(13);
    let plan = MeshPlan {
        order: match fields[1] {
            "1" => Order::Linear,
            _ => Order::Quadratic,
        },
        fine_angle: 22f64.to_radians(),
        fine: count(2),
        coarse: count(3),
        meridional: count(4),
        meridional_growth: 2.0,
        layers: count(5),
    };
    Figures {
        case: fields[0].into(),
        plan,
        scene,
        depth_mm: number(12),
        inflated_stretch: (!fields[10].is_empty()).then(|| [number(10), number(11)]),
        solution: Solution {
            inflated_radius_mm: number(9),
            reaction_n: number(14),
            x: [15, 16, 17].map(number),
            y: [18, 19, 20].map(number),
        },
    }
}

/// Solves the equilibria of one case: they differ in depth alone.
pub fn solve(case: &[Figures]) -> Vec<Ours> {
    let Figures { scene, plan, .. } = &case[0];
    let mut model = TireModel::new(scene, plan, Extent::Quarter);
    if let Some(contact) = &mut model.problem.contact {
        contact.penalty.ramp = 2.0 * CONTACT_HALF_WIDTH;
    }
    let mut newton = Newton::new(&model.problem).expect("a valid mesh");
    let mut inflated = State::reference(&model.problem);
    let unloaded = Loads::default();
    let inflation = Loads {
        pressure: scene.pressure.internal_mpa,
        ..Loads::default()
    };
    let required = Stability::Required;
    follow(
        &mut newton,
        &mut inflated,
        &unloaded,
        &inflation,
        required,
        &RUNNING,
    )
    .expect("it holds");
    let press = |figures: &Figures| {
        let mut scene = scene.clone();
        let depth = figures.depth_mm + CONTACT_HALF_WIDTH;
        scene.ground.depths_mm = vec![depth; scene.ground.stations];
        let pressing = Loads {
            ground: Some(ground(&scene.ground, model.crown_radius(&inflated))),
            ..inflation.clone()
        };
        let mut state = inflated.clone();
        let ignored = Stability::Ignored;
        follow(
            &mut newton,
            &mut state,
            &inflation,
            &pressing,
            ignored,
            &RUNNING,
        )
        .expect("an equilibrium");
        read(&model, scene, plan, [&inflated, &state], &pressing)
    };
    case.iter().map(press).collect()
}

/// Reads an equilibrium as the other code does; `states` are the inflated and the pressed one.
fn read(
    model: &TireModel,
    scene: Scene,
    plan: &MeshPlan,
    states: [&State; 2],
    loads: &Loads,
) -> Ours {
    let mesh = &model.problem.mesh;
    let [inflated, pressed] =
        states.map(|state| Recovery::new(&model.chart, mesh, |node| state.position(mesh, node)));
    // Strains at a wheel angle that belongs to a node, averaged over both sides.
    let at_node = |theta: f64| {
        let sides = [theta - BESIDE, theta + BESIDE].map(|theta| {
            let point = model.grid.inner_point(theta, 0.0);
            let (before, after) = (inflated.raw_at(point), pressed.raw_at(point));
            [after.s1 / before.s1 - 1.0, after.s2 / before.s2 - 1.0]
        });
        [0, 1].map(|i| 0.5 * (sides[0][i] + sides[1][i]))
    };
    let line = plan.fine_angle / (plan.fine * (plan.order.edge_nodes() - 1)) as f64;
    let radius = model.crown_radius(states[0]);
    let strains = [0.0, 1.0, 2.0].map(|k| {
        let place = k * SPACING / radius / line;
        let (below, share) = (place.floor(), place.fract());
        let (low, high) = (at_node(below * line), at_node((below + 1.0) * line));
        [0, 1].map(|i| (1.0 - share) * low[i] + share * high[i])
    });
    let contact = model.problem.contact.as_ref().expect("a tire has a tread");
    let field = loads.ground.as_ref().expect("it is pressed");
    let force = contact
        .resultant(field, |node| states[1].position(mesh, node))
        .force[2];
    let crown = inflated.raw_at(model.grid.inner_point(0.0, 0.0));
    Ours {
        solution: Solution {
            inflated_radius_mm: radius,
            reaction_n: model.multiplicity() * force,
            x: strains.map(|strain| strain[0]),
            y: strains.map(|strain| strain[1]),
        },
        inflated_stretch: [crown.s1, crown.s2],
        least_cord_stretch: least_cord_stretch(model, &scene, states[1]),
    }
}

fn least_cord_stretch(model: &TireModel, scene: &Scene, state: &State) -> f64 {
    let mut least = f64::INFINITY;
    if let (Some(carcass), Some(layer)) = (&scene.carcass, model.carcass()) {
        for (face, nodes) in layer.surface.iter().enumerate() {
            let displacement = nodes.iter().map(|&node| state.displacement[node as usize]);
            let displacement: Vec<[f64; 3]> = displacement.collect();
            for strain in layer.strains(face, &displacement) {
                for family in cord_families(carcass) {
                    least = least.min(family.stretch(&strain));
                }
            }
        }
    }
    least
}
