//! Solved contacts as a response surface of every kind of film, and its error at contacts that it hasn't seen.

use std::ops::RangeInclusive;

use fem_client::solver::Response;

use crate::layout::solving::contact_scenes::{ContactScenes, PlannedAxis, Stepped};
use crate::layout::solving::glued::angle_residual::AngleResidual;
use crate::layout::solving::layout_fields::{CONTACT, samples};
use crate::layout::solving::mirror_parts::image;
use crate::points::archive::Outcome;
use crate::score::scaled_errors::Errors;
use documents::layouts::contact_laws::{ContactLaw, ContactQuantity};
use layouts::arrangement::FilmKind;
use layouts::field::film_field::DepthFields;
use layouts::field::hermite::{Nodes, Turn};
use layouts::field::response_surface::{
    AxisNode, ContactAxis, DepthSignals, Given, ResponseSurface,
};
use results::ContactFindings;

/// Samples within 30 degrees of the contact: there films feel most of it.
const NEAR: RangeInclusive<usize> = CONTACT - 30..=CONTACT + 30;

/// Answers to the scenes of a surface on one mesh.
pub(crate) struct SolvedContacts<'s> {
    pub scenes: &'s ContactScenes<'s>,
    /// Kinds of film, with their volts where they are glued; the first two are those of the crown.
    pub kinds: &'s [FilmKind],
    /// Fields of the usual contact.
    pub fields: &'s DepthFields,
    /// Residuals of the transfers of films that are solved around the wheel, by kind, whatever the contact; none of others.
    pub missing: &'s [AngleResidual],
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
        let mut depths: Vec<(usize, f64)> =
            self.scenes.depths.iter().copied().enumerate().collect();
        depths.sort_by(|a, b| a.1.total_cmp(&b.1));
        let axis = |(solved, axis): (usize, PlannedAxis)| {
            let nodes = depths.iter().map(|(depth, depth_mm)| {
                let two = [0, 1].map(|step| &of_axes[solved][2 * depth + step]);
                self.nodes(&self.scenes.axes[solved], &axis, *depth_mm, two)
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
            Nodes::new(depths.iter().map(|(_, depth_mm)| *depth_mm).collect()),
            self.scenes.laws.to_vec(),
            axes.collect::<Result<_, String>>()?,
        ))
    }

    /// Nodes of an axis at a depth from the two contacts that were solved of it, or of the axis that it is the image of.
    fn nodes(
        &self,
        solved: &PlannedAxis,
        axis: &PlannedAxis,
        depth_mm: f64,
        two: [&Outcome; 2],
    ) -> Result<Vec<AxisNode>, String> {
        let usual = self.usual(depth_mm);
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
                format!("of the contacts that differ in {} at {depth_mm} mm one has no equilibrium: {unsolved}", quantity.words())
            })?;
            let value = value(axis, quantity, step, response)?;
            match axis.stepped {
                Stepped::Camber | Stepped::Shift(1) => {
                    above.push(node(value, &self.read(response, depth_mm, [false, false])?));
                    below.insert(
                        0,
                        node(-value, &self.read(response, depth_mm, [false, true])?),
                    );
                }
                Stepped::Shift(_) => {
                    above.push(node(value, &self.read(response, depth_mm, [false, false])?));
                    below.insert(
                        0,
                        node(-value, &self.read(response, depth_mm, [true, false])?),
                    );
                }
                Stepped::Station(_) | Stepped::Pressure => {
                    let is_image = solved.stepped != axis.stepped;
                    let side = if step < 0.0 { &mut below } else { &mut above };
                    side.push(node(
                        value,
                        &self.read(response, depth_mm, [is_image, false])?,
                    ));
                }
            }
        }
        below.push(middle);
        below.append(&mut above);
        Ok(below)
    }

    /// The usual contact at a depth.
    fn usual(&self, depth_mm: f64) -> Read {
        let field = self.fields.at(depth_mm);
        let signals = field.kinds.iter();
        Read {
            force_n: field.force_n,
            signals: signals.map(|kind| kind.signal.samples().to_vec()).collect(),
        }
    }

    /// A contact at a depth, or its image before and behind, or left and right.
    fn read(&self, response: &Response, depth_mm: f64, mirrors: [bool; 2]) -> Result<Read, String> {
        let rings = image(self.kinds, mirrors, &response.rings);
        let signals = rings.and_then(|rings| {
            let kinds = self.kinds.iter();
            let signals = kinds.map(|kind| samples(&rings, kind, self.kinds));
            signals.collect::<Option<_>>()
        });
        let mut signals: Vec<Vec<f64>> =
            signals.ok_or("the solver gives no strains around the wheel")?;
        for (samples, missing) in signals.iter_mut().zip(self.missing) {
            missing.add_to(depth_mm, samples);
        }
        Ok(Read {
            force_n: response.reaction_n,
            signals,
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
        let [mut near, mut all, mut near_slopes, mut slopes, mut forces] =
            std::array::from_fn(|_| Errors::default());
        for (check, outcome) in self.scenes.checks().iter().zip(solved) {
            let response = outcome.as_ref().map_err(|unsolved| {
                format!(
                    "of the contacts that all differ at once one has no equilibrium: {unsolved}"
                )
            })?;
            let found = self.read(response, check.depth_mm, [false, false])?;
            let given: Vec<Given> = check.steps.iter().copied().map(Given::Step).collect();
            let contact = surface.contact(check.depth_mm, &given);
            forces.add([found.force_n - surface.force_n(&contact)], 1.0);
            let usual = self.usual(check.depth_mm);
            let crown = usual.signals.iter().take(2).flatten();
            let full_scale = crown.fold(0.0, |largest: f64, signal| largest.max(signal.abs()));
            let crown = usual.signals.iter().take(2).flat_map(|own| slopes_of(own));
            let steepest = crown.fold(0.0, |largest: f64, slope| largest.max(slope.abs()));
            for (kind, found) in found.signals.iter().enumerate() {
                let expected = surface.signal(&contact, kind);
                all.compare(found, &expected, full_scale);
                near.compare(&found[NEAR], &expected[NEAR], full_scale);
                let [found, expected] = [found, &expected].map(|signal| slopes_of(signal));
                slopes.compare(&found, &expected, steepest);
                near_slopes.compare(&found[NEAR], &expected[NEAR], steepest);
            }
        }
        Ok(ContactFindings {
            laws: self.scenes.laws.iter().map(ContactLaw::described).collect(),
            checks: solved.len(),
            signal_error_rms: near.rms(),
            signal_error_largest: all.worst(),
            slope_error_rms: Some(near_slopes.rms()),
            slope_error_largest: Some(slopes.worst()),
            force_error_n: forces.rms(),
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

/// Slopes of a signal around the wheel over the angle at its samples, per degree.
fn slopes_of(samples: &[f64]) -> Vec<f64> {
    let turn = Turn::new(samples.to_vec());
    let angles = (-180..180).map(f64::from);
    angles.map(|angle_deg| turn.slope(angle_deg)).collect()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_those_of_a_wave_at_its_samples() {
        let angles = || (-180..180).map(|degree| f64::from(degree).to_radians());
        let wave: Vec<f64> = angles().map(f64::cos).collect();
        let per_degree = 1f64.to_radians();
        for (slope, angle) in slopes_of(&wave).into_iter().zip(angles()) {
            // Differences of fourth order leave h^4 / 30 of a wave's slope.
            assert!((slope / per_degree + angle.sin()).abs() < per_degree.powi(4));
        }
    }
}
