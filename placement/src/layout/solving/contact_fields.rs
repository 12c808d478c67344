//! Solved contacts as a response surface of every kind of film, and its error at contacts that it hasn't seen.

use std::ops::RangeInclusive;

use fem_client::solver::Response;

use crate::layout::solving::contact_scenes::{
    CheckContact, ContactScenes, OF_PAIR, PlannedAxis, Stepped,
};
use crate::layout::solving::glued::angle_residual::AngleResidual;
use crate::layout::solving::layout_fields::{CONTACT, samples};
use crate::layout::solving::mirror_parts::image;
use crate::points::archive::Outcome;
use crate::score::scaled_errors::Errors;
use documents::layouts::contact_laws::{ContactLaw, ContactQuantity};
use layouts::arrangement::FilmKind;
use layouts::field::contact_axis::{AxisNode, Change, ContactAxis, Wrench};
use layouts::field::contact_pair::ContactPair;
use layouts::field::film_field::DepthFields;
use layouts::field::hermite::{Nodes, Turn};
use layouts::field::response_surface::{DepthSignals, Given, ResponseSurface};
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
    /// Force along the ground's normal.
    force_n: f64,
    /// Force and moments in the wheel's frame; the force along the normal of an upright wheel where the solver doesn't tell.
    wrench: Wrench,
    signals: Vec<Vec<f64>>,
}

impl Read {
    fn less(&self, other: &Self) -> Change {
        let pairs = self.signals.iter().zip(&other.signals);
        let less = |(a, b): (&Vec<f64>, &Vec<f64>)| a.iter().zip(b).map(|(a, b)| a - b).collect();
        Change {
            force_n: self.force_n - other.force_n,
            wrench: std::array::from_fn(|axis| self.wrench[axis] - other.wrench[axis]),
            signals: pairs.map(less).collect(),
        }
    }
}

impl SolvedContacts<'_> {
    /// The surface from what was solved of each pair and axis.
    ///
    /// # Errors
    /// Which contact has no answer.
    pub fn surface(&self, solved: &[Vec<Outcome>]) -> Result<ResponseSurface, String> {
        let mut depths: Vec<(usize, f64)> =
            self.scenes.depths.iter().copied().enumerate().collect();
        depths.sort_by(|a, b| a.1.total_cmp(&b.1));
        let (of_pairs, of_axes) = solved.split_at(self.scenes.pairs().len());
        let axis = |(solved, axis): &(usize, PlannedAxis)| {
            let own = &self.scenes.axes[*solved];
            let count = own.steps().len();
            let nodes = depths.iter().map(|(depth, depth_mm)| {
                let solved_there = &of_axes[*solved][depth * count..][..count];
                self.nodes(own, axis, *depth_mm, solved_there)
            });
            Ok(ContactAxis {
                law: axis.law,
                nodes: nodes.collect::<Result<_, String>>()?,
            })
        };
        let components = self.scenes.components();
        let axes = components.iter().map(axis);
        let alone = ResponseSurface::new(
            DepthSignals {
                depths: self.fields.depths.clone(),
                forces_n: self.fields.forces_n.clone(),
                signals: self.fields.signals.clone(),
            },
            Nodes::new(depths.iter().map(|(_, depth_mm)| *depth_mm).collect()),
            self.scenes.laws.to_vec(),
            axes.collect::<Result<_, String>>()?,
        );
        let mut pairs = Vec::new();
        for (pair, solved) in self.scenes.pairs().into_iter().zip(of_pairs) {
            for axes in self.scenes.components_of(pair) {
                let nodes = depths.iter().map(|(depth, depth_mm)| {
                    self.both(&alone, (pair, axes), *depth_mm, &solved[*depth])
                });
                pairs.push(ContactPair {
                    axes,
                    steps: [OF_PAIR; 2],
                    nodes: nodes.collect::<Result<_, String>>()?,
                });
            }
        }
        Ok(alone.with_pairs(pairs))
    }

    /// Nodes of an axis at a depth from the contacts that were solved of it, or of the axis that it is the image of.
    fn nodes(
        &self,
        solved: &PlannedAxis,
        axis: &PlannedAxis,
        depth_mm: f64,
        outcomes: &[Outcome],
    ) -> Result<Vec<AxisNode>, String> {
        let quantity = self.scenes.laws[axis.law].quantity;
        let usual = self.usual(depth_mm);
        let node = |step: f64, value: f64, read: &Read| AxisNode {
            step,
            value,
            change: read.less(&usual),
        };
        let own = [solved.stepped != axis.stepped, false];
        let opposite = axis.stepped.opposite();
        let mut nodes = vec![node(0.0, quantity.usual(), &usual)];
        for (step, outcome) in solved.steps().iter().copied().zip(outcomes) {
            let response = outcome.as_ref().map_err(|unsolved| {
                format!("of the contacts that differ in {} at {depth_mm} mm one has no equilibrium: {unsolved}", quantity.words())
            })?;
            let value = value(axis, quantity, step, response)?;
            nodes.push(node(step, value, &self.read(response, depth_mm, own)?));
            if let Some(opposite) = opposite {
                let read = self.read(response, depth_mm, opposite)?;
                nodes.push(node(-step, -value, &read));
            }
        }
        nodes.sort_by(|a, b| a.step.total_cmp(&b.step));
        Ok(nodes)
    }

    /// Changes that a step of the first axis of a pair to either side makes at a depth with the second one, beside those that each makes alone; `axes` are their numbers, or
    /// those of their image before or behind the middle. The mirror turns the camber; of what it doesn't turn, the opposite step makes the opposite change.
    fn both(
        &self,
        alone: &ResponseSurface,
        (pair, axes): ([usize; 2], [usize; 2]),
        depth_mm: f64,
        outcome: &Outcome,
    ) -> Result<[Change; 2], String> {
        let [first, second] = pair.map(|axis| &self.scenes.axes[axis]);
        let response = outcome.as_ref().map_err(|unsolved| {
            let [one, other] =
                [first, second].map(|axis| self.scenes.laws[axis.law].quantity.words());
            format!("of the contacts that differ in {one} and {other} at {depth_mm} mm one has no equilibrium: {unsolved}")
        })?;
        let components = self.scenes.components();
        let of_axes = axes.map(|axis| components[axis].1.stepped);
        let is_image = of_axes != [first.stepped, second.stepped];
        let changed = |step: f64, is_mirrored: bool| {
            let mut given = vec![Given::Step(0.0); components.len()];
            given[axes[0]] = Given::Step(step);
            given[axes[1]] = Given::Step(OF_PAIR);
            let contact = alone.contact(depth_mm, &given);
            let kinds = 0..self.kinds.len();
            let expected = Read {
                force_n: alone.force_n(&contact),
                wrench: {
                    let mut wrench = alone.changed_wrench(&contact);
                    wrench[2] += self.usual(depth_mm).force_n;
                    wrench
                },
                signals: kinds.map(|kind| alone.signal(&contact, kind)).collect(),
            };
            let found = self.read(response, depth_mm, [is_image, is_mirrored])?;
            Ok::<_, String>(found.less(&expected))
        };
        let opposite = first.stepped.opposite();
        let step = match is_image && opposite == Some([true, false]) {
            true => -self.scenes.step_of_first(pair),
            false => self.scenes.step_of_first(pair),
        };
        let own = changed(step, false)?;
        let other = match opposite {
            Some([false, true]) => changed(-step, true)?,
            _ => own.opposite(),
        };
        Ok(if step < 0.0 {
            [own, other]
        } else {
            [other, own]
        })
    }

    /// The usual contact at a depth.
    fn usual(&self, depth_mm: f64) -> Read {
        let field = self.fields.at(depth_mm);
        let signals = field.kinds.iter();
        Read {
            force_n: field.force_n,
            // By both mirror planes there is no other force, and no moment.
            wrench: [0.0, 0.0, field.force_n, 0.0, 0.0, 0.0],
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
        let [aft, left] = mirrors.map(|mirrored| if mirrored { -1.0 } else { 1.0 });
        let force_n = response.force_n.unwrap_or([0.0, 0.0, response.reaction_n]);
        let [along, across, up] = force_n;
        let [about_x, about_y, about_z] = response.moment_nmm.unwrap_or_default();
        let mut signals: Vec<Vec<f64>> =
            signals.ok_or("the solver gives no strains around the wheel")?;
        for (samples, missing) in signals.iter_mut().zip(self.missing) {
            missing.add_to(depth_mm, samples);
        }
        Ok(Read {
            force_n: response.reaction_n,
            // A moment about an axis keeps its sign in a mirror that the axis is normal to.
            wrench: [
                aft * along,
                left * across,
                up,
                left * about_x,
                aft * about_y,
                aft * left * about_z,
            ],
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
        checks: &[CheckContact],
        solved: &[Outcome],
    ) -> Result<ContactFindings, String> {
        let [mut near, mut all, mut near_slopes, mut slopes, mut forces] =
            std::array::from_fn(|_| Errors::default());
        for (check, outcome) in checks.iter().zip(solved) {
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
            signal_claim: Some(near.claim(solved.len())),
            signal_error_largest: all.worst(),
            slope_error_rms: Some(near_slopes.rms()),
            slope_claim: Some(near_slopes.claim(solved.len())),
            slope_error_largest: Some(slopes.worst()),
            force_error_n: forces.rms(),
            force_claim_n: Some(forces.claim(solved.len())),
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
