//! The reference tire as an independent code solved it, solved here on the same mesh, with its contact law and its readout.
//!
//! That code reads raw strains at nodes, and its bricks grow towards the bead: neither is in its description, both were found
//! by trying, see `docs/proof/independent.md`.

// Each target that includes this module uses a part of it.
#![allow(dead_code)]

use fem::cell::element::Order;
use fem_client::scene::Scene;
use tire::mesh::tire_grid::{Extent, MeshPlan};

mod cord_layer;

pub mod pressing;

pub mod reading;

pub mod largest;

pub mod finest;

pub mod five_depths;

use pressing::Press;
use reading::Reading;

/// Distance of P3, P4 and P5, mm.
const SPACING: f64 = 4.0;
/// Stick at any contact force.
const STICK: f64 = 1e6;

/// An equilibrium of the other code.
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

/// Figures that both codes answer.
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
    let mut scene = pressing::reference();
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
        middle: None,
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
    let model = pressing::model(scene, plan, Extent::Quarter);
    let mut press = Press::new(scene, &model);
    let mut answer = |figures: &Figures| {
        let depths = vec![figures.depth_mm; scene.ground.stations];
        let pressed = press.press(&depths, None);
        let reading = Reading::new(&press, plan, &pressed);
        let inflated_radius_mm = model.crown_radius(&press.inflated);
        let strains = [0.0, 1.0, 2.0].map(|k| reading.at(k * SPACING / inflated_radius_mm));
        Ours {
            solution: Solution {
                inflated_radius_mm,
                reaction_n: reading::reaction(&model, &pressed),
                x: strains.map(|strain| strain[0]),
                y: strains.map(|strain| strain[1]),
            },
            inflated_stretch: reading.inflated_stretch(),
            least_cord_stretch: largest::cord_stretches(&model, scene, &pressed.state).min,
        }
    };
    case.iter().map(&mut answer).collect()
}
