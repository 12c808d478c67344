//! A boundary value problem as a CalculiX input deck.
//!
//! Nodes and elements keep their order and are numbered from 1; the ground's come after the tire's. Everything happens in one
//! step: the pressure rises in its first half, the ground in its second. CalculiX fails on most meshes when inflating and
//! pressing are steps of their own.

use std::collections::HashMap;
use std::fmt::Write;

use fem::cell::element::Order;
use fem::cell::mesh::{Mesh, Surface};
use fem::problem::Problem;

use crate::rigid_ground::RigidGround;
use fem_client::scene::{Law, Material};

/// Set of the tire's nodes.
pub(crate) const TIRE: &str = "TIRE";
/// Set of the ground's nodes.
pub(crate) const GROUND: &str = "GROUND";
/// Step time, of no unit, at which the tire is inflated and the ground starts to rise.
pub(crate) const INFLATED_TIME: f64 = 1.0;
/// Step time, of no unit, at which the ground has arrived.
pub(crate) const PRESSED_TIME: f64 = 2.0;
/// First, least and largest increment of the step time.
const INCREMENTS: [f64; 3] = [0.25, 1e-4, 0.25];
/// Largest residual force over the mean force, and largest correction over the increment's displacement, of an equilibrium.
const TOLERANCES: [f64; 2] = [1e-6, 1e-3];
/// [`TOLERANCES`] on a ground of facets: where a node lies on an edge, its normal changes from one iteration to the next, and
/// some 1e-4 of the force remains. CalculiX's own choice is five times as much.
const TOLERANCES_ON_FACETS: [f64; 2] = [1e-3, 1e-2];
/// D of a term (J - 1)^4 or (J - 1)^6 over D that isn't there, 1/MPa: for a D of 0 CalculiX takes one of its own.
const NO_VOLUMETRIC_TERM: f64 = 1e12;
/// Increments after which CalculiX gives up.
const MAX_INCREMENTS: usize = 1000;

/// Terms of Ogden's law that CalculiX takes.
pub(crate) const MAX_OGDEN_TERMS: usize = 3;

/// Parts of which a deck is written.
#[derive(Debug, Clone, Copy)]
pub struct Deck<'a> {
    /// Mesh of 8-node bricks, supports, and the surfaces under pressure and in contact.
    pub problem: &'a Problem,
    /// The rubber; its `d1_per_mpa` is positive.
    pub rubber: &'a Material,
    /// Internal pressure, MPa.
    pub pressure: f64,
    /// The ground; absent: the tire is inflated only.
    pub ground: Option<&'a RigidGround>,
}

impl Deck<'_> {
    /// The deck's text.
    ///
    /// # Panics
    /// When the bricks aren't 8-node bricks, or a pressure or contact face isn't one of their faces along the third direction.
    pub fn text(&self) -> String {
        let mut text = String::from("*HEADING\nstrainsite\n");
        self.body(&mut text);
        self.supports(&mut text);
        self.surfaces(&mut text);
        if let Some(ground) = self.ground {
            self.contact(&mut text, ground);
        }
        self.step(&mut text);
        text
    }

    fn body(&self, text: &mut String) {
        let mesh = &self.problem.mesh;
        assert_eq!(mesh.order, Order::Linear, "decks have 8-node bricks");
        line(text, &format!("*NODE, NSET={TIRE}"));
        nodes(text, 1, &mesh.nodes);
        line(text, "*ELEMENT, TYPE=C3D8R, ELSET=WALL");
        for element in 0..mesh.brick_count() {
            brick(text, element + 1, mesh.brick(element), 1);
        }
        line(text, "*MATERIAL, NAME=RUBBER");
        rubber(text, self.rubber);
        line(text, "*SOLID SECTION, ELSET=WALL, MATERIAL=RUBBER");
    }

    fn supports(&self, text: &mut String) {
        line(text, "*BOUNDARY");
        for (node, axes) in self.problem.supports.iter().enumerate() {
            for (axis, held) in axes.iter().enumerate() {
                if let Some(value) = held {
                    let (node, axis) = (node + 1, axis + 1);
                    line(text, &format!("{node}, {axis}, {axis}, {}", real(*value)));
                }
            }
        }
    }

    fn surfaces(&self, text: &mut String) {
        let mesh = &self.problem.mesh;
        if let Some(pressure) = &self.problem.pressure {
            for (label, elements) in sides(mesh, &pressure.surface) {
                line(text, &format!("*ELSET, ELSET=PRESSURE{label}"));
                elements.iter().for_each(|e| line(text, &e.to_string()));
            }
        }
        if let Some(contact) = &self.problem.contact {
            line(text, "*SURFACE, NAME=TREAD, TYPE=ELEMENT");
            for (label, elements) in sides(mesh, &contact.surface) {
                elements
                    .iter()
                    .for_each(|e| line(text, &format!("{e}, S{label}")));
            }
        }
    }

    fn contact(&self, text: &mut String, ground: &RigidGround) {
        let Some(contact) = &self.problem.contact else {
            return;
        };
        let (mesh, first) = (&self.problem.mesh, self.problem.mesh.nodes.len() + 1);
        line(text, &format!("*NODE, NSET={GROUND}"));
        nodes(text, first, &ground.nodes);
        line(text, "*ELEMENT, TYPE=C3D8, ELSET=RIGID");
        let element = mesh.brick_count() + 1;
        for (k, corners) in ground.bricks.iter().enumerate() {
            brick(text, element + k, corners, first);
        }
        line(text, "*MATERIAL, NAME=STEEL\n*ELASTIC\n2e5, 0.3");
        line(text, "*SOLID SECTION, ELSET=RIGID, MATERIAL=STEEL");
        line(text, "*SURFACE, NAME=ROAD, TYPE=ELEMENT\nRIGID, S2");
        let held = moving_axes(ground).start - 1;
        line(text, &format!("*BOUNDARY\n{GROUND}, 1, {held}, 0."));
        line(text, "*SURFACE INTERACTION, NAME=TOUCH");
        line(text, "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR");
        // CalculiX smooths its law with a tension far from contact, here a millionth of the shear modulus.
        let tension = 1e-6 * self.rubber.law.shear_modulus_mpa();
        let stiffness = real(contact.penalty.stiffness);
        line(text, &format!("{stiffness}, {}", real(tension)));
        line(
            text,
            "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=NODE TO SURFACE\nTREAD, ROAD",
        );
    }

    fn step(&self, text: &mut String) {
        let end = if self.ground.is_some() {
            PRESSED_TIME
        } else {
            INFLATED_TIME
        };
        let [first, least, largest] = INCREMENTS;
        line(
            text,
            &format!("*AMPLITUDE, NAME=INFLATE\n0., 0., {INFLATED_TIME}, 1., {PRESSED_TIME}, 1."),
        );
        line(
            text,
            &format!("*AMPLITUDE, NAME=RISE\n0., 0., {INFLATED_TIME}, 0., {PRESSED_TIME}, 1."),
        );
        line(text, "*TIME POINTS, NAME=STATES");
        line(text, &format!("{INFLATED_TIME}, {PRESSED_TIME}"));
        line(
            text,
            &format!("*STEP, NLGEOM, INC={MAX_INCREMENTS}\n*STATIC"),
        );
        line(text, &format!("{first}, {end}, {least}, {largest}"));
        let flat = self.ground.is_none_or(|ground| ground.bricks.len() == 1);
        let [residual, correction] = if flat {
            TOLERANCES
        } else {
            TOLERANCES_ON_FACETS
        };
        line(text, "*CONTROLS, PARAMETERS=FIELD");
        line(text, &format!("{residual}, {correction}"));
        if let Some(ground) = self.ground {
            line(text, "*BOUNDARY, AMPLITUDE=RISE");
            for axis in moving_axes(ground) {
                let way = real(ground.way[axis - 1]);
                line(text, &format!("{GROUND}, {axis}, {axis}, {way}"));
            }
        }
        if let Some(pressure) = &self.problem.pressure {
            line(text, "*DLOAD, AMPLITUDE=INFLATE");
            for (label, _) in sides(&self.problem.mesh, &pressure.surface) {
                let pressure = real(self.pressure);
                line(text, &format!("PRESSURE{label}, P{label}, {pressure}"));
            }
        }
        line(
            text,
            &format!("*NODE PRINT, NSET={TIRE}, TIME POINTS=STATES\nU"),
        );
        if self.ground.is_some() {
            line(
                text,
                &format!("*NODE PRINT, NSET={GROUND}, TIME POINTS=STATES, TOTALS=ONLY\nRF"),
            );
        }
        line(text, "*END STEP");
    }
}

fn line(text: &mut String, content: &str) {
    text.push_str(content);
    text.push('\n');
}

fn nodes(text: &mut String, first: usize, positions: &[[f64; 3]]) {
    for (k, position) in positions.iter().enumerate() {
        let [x, y, z] = position.map(real);
        line(text, &format!("{}, {x}, {y}, {z}", first + k));
    }
}

/// A number that fits into the 20 characters of a deck's field.
fn real(value: f64) -> String {
    format!("{value:.12e}")
}

/// Our corners are lexicographic, CalculiX's run around the lower face, then around the upper one.
fn brick(text: &mut String, number: usize, corners: &[u32], first: usize) {
    text.push_str(&number.to_string());
    for corner in [0, 1, 3, 2, 4, 5, 7, 6] {
        let _ = write!(text, ", {}", first + corners[corner] as usize);
    }
    text.push('\n');
}

/// The law, then its constants and one D per term, eight to a line.
fn rubber(text: &mut String, material: &Material) {
    let (name, constants, terms) = match &material.law {
        Law::NeoHookean { c10_mpa } => ("NEO HOOKE".to_owned(), vec![*c10_mpa], 1),
        Law::MooneyRivlin { c10_mpa, c01_mpa } => {
            ("MOONEY-RIVLIN".to_owned(), vec![*c10_mpa, *c01_mpa], 1)
        }
        Law::Yeoh {
            c10_mpa,
            c20_mpa,
            c30_mpa,
        } => ("YEOH".to_owned(), vec![*c10_mpa, *c20_mpa, *c30_mpa], 3),
        Law::Ogden { terms } => {
            let constants = terms.iter().flat_map(|term| [term.mu_mpa, term.alpha]);
            (
                format!("OGDEN, N={}", terms.len()),
                constants.collect(),
                terms.len(),
            )
        }
    };
    line(text, &format!("*HYPERELASTIC, {name}"));
    let compressibilities = (0..terms).map(|term| {
        if term == 0 {
            material.d1_per_mpa
        } else {
            NO_VOLUMETRIC_TERM
        }
    });
    let numbers: Vec<String> = constants
        .into_iter()
        .chain(compressibilities)
        .map(real)
        .collect();
    numbers
        .chunks(8)
        .for_each(|chunk| line(text, &chunk.join(", ")));
}

/// Elements of a surface by the label of their face: 1 the lower, 2 the upper along the third direction.
fn sides(mesh: &Mesh, surface: &Surface) -> Vec<(usize, Vec<usize>)> {
    let mut owners = HashMap::new();
    for element in 0..mesh.brick_count() {
        let (lower, upper) = mesh.brick(element).split_at(4);
        owners.insert(lower, (1, element + 1));
        // A face between two layers is on no boundary, and whose it is doesn't matter.
        owners.insert(upper, (2, element + 1));
    }
    let owned: Vec<(usize, usize)> = surface
        .iter()
        .map(|face| {
            *owners
                .get(face)
                .expect("a face of a brick, along its third direction")
        })
        .collect();
    [1, 2]
        .into_iter()
        .map(|label| {
            let elements = owned.iter().filter(|(side, _)| *side == label).map(|o| o.1);
            (label, elements.collect::<Vec<_>>())
        })
        .filter(|(_, elements)| !elements.is_empty())
        .collect()
}

/// Axes, numbered from 1, along which the ground rises: below an upright wheel the last alone.
fn moving_axes(ground: &RigidGround) -> std::ops::Range<usize> {
    match ground.way[1] == 0.0 {
        true => 3..4,
        false => 2..4,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fem_client::scene::{OgdenTerm, Scene};
    use tire::mesh::tire_grid::{Extent, MeshPlan};
    use tire::model::{TireModel, ground};

    const PLAN: MeshPlan = MeshPlan {
        order: Order::Linear,
        fine_angle: 0.4,
        fine: 2,
        middle: None,
        coarse: 2,
        meridional: 3,
        meridional_growth: 2.0,
        layers: 2,
    };

    fn text(scene: &Scene) -> String {
        let model = TireModel::new(scene, &PLAN, Extent::Quarter);
        let ground = RigidGround::new(&ground(&scene.ground, 50.0), 75.0, -51.0);
        Deck {
            problem: &model.problem,
            rubber: &scene.material,
            pressure: 0.1,
            ground: Some(&ground),
        }
        .text()
    }

    fn scene() -> Scene {
        let mut scene = Scene::default();
        scene.material.d1_per_mpa = 1.0 / 18.0;
        scene
    }

    /// Data lines below a keyword, up to the next one.
    fn data<'t>(deck: &'t str, keyword: &str) -> Vec<&'t str> {
        let lines = deck.lines().skip_while(|line| *line != keyword).skip(1);
        lines.take_while(|line| !line.starts_with('*')).collect()
    }

    #[test]
    fn fields_and_lines_are_as_short_as_calculix_wants_them() {
        let deck = text(&scene());
        for line in deck.lines() {
            assert!(line.len() <= 132, "{line}");
            if !line.starts_with('*') {
                let fields: Vec<&str> = line.split(',').map(str::trim).collect();
                assert!(
                    fields.len() <= 16 && fields.iter().all(|f| f.len() <= 20),
                    "{line}"
                );
            }
        }
    }

    #[test]
    fn inner_faces_carry_the_pressure_and_outer_ones_touch_the_road() {
        let deck = text(&scene());
        // 4 x 3 bricks in each of two layers, the inner layer's numbers are odd.
        let inner: Vec<String> = (0..12).map(|k| (2 * k + 1).to_string()).collect();
        assert_eq!(data(&deck, "*ELSET, ELSET=PRESSURE1"), inner);
        assert_eq!(
            data(&deck, "*DLOAD, AMPLITUDE=INFLATE"),
            ["PRESSURE1, P1, 1.000000000000e-1"]
        );
        let tread = data(&deck, "*SURFACE, NAME=TREAD, TYPE=ELEMENT");
        assert_eq!(tread[0], "2, S2");
        assert!(tread.iter().all(|line| line.ends_with(", S2")));
    }

    #[test]
    fn nodes_supports_and_ground_are_all_there() {
        let scene = scene();
        let deck = text(&scene);
        let model = TireModel::new(&scene, &PLAN, Extent::Quarter);
        let nodes = data(&deck, "*NODE, NSET=TIRE");
        assert_eq!(nodes.len(), model.problem.mesh.nodes.len());
        let held = model.problem.supports.iter().flatten().flatten().count();
        assert_eq!(data(&deck, "*BOUNDARY").len(), held);
        // The first brick's corners around its lower, then its upper face: numbers run along rho (3), then phi (4).
        assert_eq!(
            data(&deck, "*ELEMENT, TYPE=C3D8R, ELSET=WALL")[0],
            "1, 1, 4, 16, 13, 2, 5, 17, 14"
        );
        // Five depths of 1 mm below 50 mm, parked at -51 mm.
        let rise = data(&deck, "*BOUNDARY, AMPLITUDE=RISE");
        assert_eq!(rise, ["GROUND, 3, 3, 2.000000000000e0"]);
    }

    #[test]
    fn laws_have_their_constants_and_one_compressibility() {
        let rubber = |law| {
            let mut text = String::new();
            let material = Material {
                law,
                d1_per_mpa: 0.5,
            };
            rubber(&mut text, &material);
            text
        };
        let numbers = |values: &[f64]| {
            let texts: Vec<String> = values.iter().copied().map(real).collect();
            texts.join(", ")
        };
        let expected = format!(
            "*HYPERELASTIC, MOONEY-RIVLIN\n{}\n",
            numbers(&[0.144, 0.036, 0.5])
        );
        assert_eq!(
            rubber(Law::of_name("mooney-rivlin").expect("a law")),
            expected
        );
        let expected = format!(
            "*HYPERELASTIC, YEOH\n{}\n",
            numbers(&[0.18, 0.0, 0.0, 0.5, NO_VOLUMETRIC_TERM, NO_VOLUMETRIC_TERM])
        );
        assert_eq!(rubber(Law::of_name("yeoh").expect("a law")), expected);
        let term = |mu_mpa, alpha| OgdenTerm { mu_mpa, alpha };
        let terms = vec![term(0.1, 1.5), term(0.2, 4.0), term(-0.1, -2.0)];
        let expected = format!(
            "*HYPERELASTIC, OGDEN, N=3\n{}\n{}\n",
            numbers(&[0.1, 1.5, 0.2, 4.0, -0.1, -2.0, 0.5, NO_VOLUMETRIC_TERM]),
            numbers(&[NO_VOLUMETRIC_TERM])
        );
        assert_eq!(rubber(Law::Ogden { terms }), expected);
    }
}
