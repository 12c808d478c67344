//! Solved contacts as a response surface of every kind of film, and its error at contacts that it hasn't seen.

use fem_client::solver::{Response, Ring};

use crate::layout::solving::contact_scenes::{ContactScenes, PlannedAxis, Stepped};
use crate::layout::solving::layout_fields::samples;
use crate::layout::solving::mirror_parts::image;
use crate::points::archive::Outcome;
use documents::layouts::contact_laws::{ContactLaw, ContactQuantity};
use layouts::arrangement::FilmKind;
use layouts::field::film_field::DepthFields;
use layouts::field::hermite::Nodes;
use layouts::field::response_surface::{
    AxisNode, ContactAxis, DepthSignals, Given, ResponseSurface,
};
use results::ContactFindings;

/// Distance from the contact within which films feel most of it, degrees.
const NEAR_DEG: i32 = 30;

/// Answers to the scenes of a surface on one mesh.
pub(crate) struct SolvedContacts<'s> {
    pub scenes: &'s ContactScenes<'s>,
    /// Kinds of film, with their volts where they are glued; the first two are those of the crown.
    pub kinds: &'s [FilmKind],
    /// The layouts' own solves, and the fields that they are.
    pub usual: &'s [Outcome],
    pub fields: &'s DepthFields,
}

/// Force and signals of a contact.
struct Read {
    force_n: f64,
    signals: Vec<Vec<f64>>,
}

impl Read {
    fn less(&self, other: &Self) -> Self {
        let pairs = self.signals.iter().zip(&other.signals);
        let less = |(a, b): (&Vec<f64>, &Vec<f64>)| a.iter().zip(b).map(|(a, b)| a - b).collect();
        Self {
            force_n: self.force_n - other.force_n,
            signals: pairs.map(less).collect(),
        }
    }
}

impl SolvedContacts<'_> {
    /// The surface from what was solved of each axis.
    ///
    /// # Errors
    /// Which contact has no answer.
    pub fn surface(&self, of_axes: &[Vec<Outcome>]) -> Result<ResponseSurface, String> {
        let mut depths: Vec<usize> = (0..self.scenes.depths.len()).collect();
        depths.sort_by(|a, b| self.depth_mm(*a).total_cmp(&self.depth_mm(*b)));
        let places = depths.iter().map(|depth| self.depth_mm(*depth)).collect();
        let axis = |(solved, axis): (usize, PlannedAxis)| {
            let nodes = depths.iter().map(|depth| {
                let two = [0, 1].map(|step| &of_axes[solved][2 * depth + step]);
                self.nodes(&self.scenes.axes[solved], &axis, *depth, two)
            });
            Ok(ContactAxis {
                law: axis.law,
                nodes: nodes.collect::<Result<_, String>>()?,
            })
        };
        let axes = self.scenes.components().into_iter().map(axis);
        Ok(ResponseSurface::new(
            DepthSignals {
                depths: self.fields.depths.clone(),
                forces_n: self.fields.forces_n.clone(),
                signals: self.fields.signals.clone(),
            },
            Nodes::new(places),
            self.scenes.laws.to_vec(),
            axes.collect::<Result<_, String>>()?,
        ))
    }

    fn depth_mm(&self, depth: usize) -> f64 {
        self.scenes.depths[depth].0
    }

    /// Nodes of an axis at a depth from the two contacts that were solved of it, or of the axis that it is the image of.
    fn nodes(
        &self,
        solved: &PlannedAxis,
        axis: &PlannedAxis,
        depth: usize,
        two: [&Outcome; 2],
    ) -> Result<Vec<AxisNode>, String> {
        let usual = self.usual(depth)?;
        let node = |value: f64, read: &Read| {
            let change = read.less(&usual);
            AxisNode {
                value,
                force_n: change.force_n,
                signals: change.signals,
            }
        };
        let quantity = self.scenes.laws[axis.law].quantity;
        let middle = node(quantity.usual(), &usual);
        let mut below = Vec::new();
        let mut above = Vec::new();
        for (step, outcome) in axis.steps().into_iter().zip(two) {
            let response = outcome.as_ref().map_err(|unsolved| {
                let depth = self.depth_mm(depth);
                format!("of the contacts that differ in {} at {depth} mm one has no equilibrium: {unsolved}", quantity.words())
            })?;
            let value = value(axis, quantity, step, response)?;
            match axis.stepped {
                Stepped::Camber | Stepped::Shift(1) => {
                    above.push(node(value, &self.read(response, [false, false])?));
                    below.insert(0, node(-value, &self.read(response, [false, true])?));
                }
                Stepped::Shift(_) => {
                    above.push(node(value, &self.read(response, [false, false])?));
                    below.insert(0, node(-value, &self.read(response, [true, false])?));
                }
                Stepped::Station(_) | Stepped::Pressure => {
                    let is_image = solved.stepped != axis.stepped;
                    let side = if step < 0.0 { &mut below } else { &mut above };
                    side.push(node(value, &self.read(response, [is_image, false])?));
                }
            }
        }
        below.push(middle);
        below.append(&mut above);
        Ok(below)
    }

    /// The usual contact at a depth.
    fn usual(&self, depth: usize) -> Result<Read, String> {
        let (_, solved) = self.scenes.depths[depth];
        let response = self.usual[solved].as_ref();
        let response = response.map_err(|unsolved| unsolved.to_string())?;
        self.of(&response.rings, response)
    }

    /// A contact, or its image before and behind, or left and right.
    fn read(&self, response: &Response, mirrors: [bool; 2]) -> Result<Read, String> {
        let rings = image(self.kinds, mirrors, &response.rings);
        self.of(&rings.ok_or_else(without_rings)?, response)
    }

    fn of(&self, rings: &[Ring], response: &Response) -> Result<Read, String> {
        let kinds = self.kinds.iter();
        let signals = kinds.map(|kind| samples(rings, kind, self.kinds));
        Ok(Read {
            force_n: response.reaction_n,
            signals: signals.collect::<Option<_>>().ok_or_else(without_rings)?,
        })
    }

    /// Errors of the surface at contacts of all quantities at once, which it hasn't seen.
    ///
    /// # Errors
    /// Which has no answer.
    pub fn findings(
        &self,
        surface: &ResponseSurface,
        solved: &[Outcome],
    ) -> Result<ContactFindings, String> {
        let (mut near, mut most, mut forces) = (Vec::new(), 0.0f64, Vec::new());
        for (check, outcome) in self.scenes.checks().iter().zip(solved) {
            let response = outcome.as_ref().map_err(|unsolved| {
                format!(
                    "of the contacts that all differ at once one has no equilibrium: {unsolved}"
                )
            })?;
            let found = self.read(response, [false, false])?;
            let given: Vec<Given> = check.steps.iter().copied().map(Given::Step).collect();
            let contact = surface.contact(self.depth_mm(check.depth), &given);
            forces.push(found.force_n - surface.force_n(&contact));
            let usual = self.usual(check.depth)?;
            let crown = usual.signals.iter().take(2).flatten();
            let full_scale = crown.fold(0.0, |largest: f64, signal| largest.max(signal.abs()));
            for (kind, found) in found.signals.iter().enumerate() {
                let pairs = found.iter().zip(surface.signal(&contact, kind));
                let off = pairs.map(|(found, surface)| (found - surface) / full_scale);
                for (off, degree) in off.zip(-180i32..180) {
                    most = most.max(off.abs());
                    near.extend((degree.abs() <= NEAR_DEG).then_some(off));
                }
            }
        }
        Ok(ContactFindings {
            laws: self.scenes.laws.iter().map(ContactLaw::described).collect(),
            checks: solved.len(),
            signal_error_rms: root_mean_square(&near),
            signal_error_largest: most,
            force_error_n: root_mean_square(&forces),
            short: self.short(surface),
        })
    }

    /// Quantities whose laws reach beyond what was solved, in words.
    fn short(&self, surface: &ResponseSurface) -> Vec<String> {
        let mut short = Vec::new();
        for (axis, (_, planned)) in self.scenes.components().iter().enumerate() {
            let quantity = self.scenes.laws[planned.law].quantity;
            let usual = quantity.usual();
            let reached = surface.reached(axis).map(|ends| {
                let [low, high] = ends.map(|end| (end - usual).abs());
                low.min(high)
            });
            let least = reached.fold(f64::INFINITY, f64::min);
            if least < planned.reach * (1.0 - 1e-9) {
                short.push(format!(
                    "{} to {least:.2} of {:.2}",
                    quantity.words(),
                    planned.reach
                ));
            }
        }
        short
    }
}

fn without_rings() -> String {
    "the solver gives no strains around the wheel".to_owned()
}

fn root_mean_square(errors: &[f64]) -> f64 {
    let squares = errors.iter().map(|error| error * error).sum::<f64>();
    (squares / errors.len().max(1) as f64).sqrt()
}

/// Value of a quantity at a step: of a traction what the ground pulls with.
fn value(
    axis: &PlannedAxis,
    quantity: ContactQuantity,
    step: f64,
    response: &Response,
) -> Result<f64, String> {
    match axis.stepped {
        Stepped::Shift(way) => {
            let force = response.force_n.ok_or("the solver gives no force")?;
            Ok(force[way] / response.reaction_n)
        }
        _ => Ok(quantity.usual() + step * axis.reach),
    }
}
