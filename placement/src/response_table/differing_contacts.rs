//! Quantities that contacts differ in besides angle, depth and shift, as a rig draws them: the response surface of the study's layouts, beside the table.
//!
//! Tractions are left to the table, which knows them together and as far as the rig drags.

use fem_client::scene::{Level, Scene};

use crate::layout::solving::contact_fields::SolvedContacts;
use crate::layout::solving::contact_scenes::ContactScenes;
use crate::layout::solving::layout_fields::mesh_fields;
use crate::layout::solving::layout_scenes::LayoutScenes;
use crate::points::{Place, RunContext, RunError, outcomes_of_all};
use documents::layouts::contact_laws::Contacts;
use documents::study::Study;
use layouts::arrangement::FilmKind;
use layouts::field::hermite::{Nodes, Turn, summed};
use layouts::field::response_surface::{Drawn, ResponseSurface};
use rig::contact_response::DrawnFor;

/// Quantities that a study's contacts differ in, to be solved.
pub(crate) struct StudyContacts {
    scenes: LayoutScenes,
    contacts: Contacts,
    level: Level,
    /// Kinds of film that the layouts' solves are read for.
    kinds: Vec<FilmKind>,
    /// Number of each of a table's kinds among them.
    of_table: Vec<usize>,
}

impl StudyContacts {
    /// Quantities that a study's contacts differ in; none where they are alike, or differ in their traction alone.
    ///
    /// # Errors
    /// Why its layouts have no loads.
    pub fn of(
        study: &Study,
        means: &Scene,
        kinds: &[FilmKind],
        of_table: Vec<usize>,
    ) -> Result<Option<Self>, String> {
        let contacts = &study.layouts.contacts;
        if !contacts
            .laws
            .iter()
            .any(|law| DrawnFor::of(law.quantity).is_some())
        {
            return Ok(None);
        }
        Ok(Some(Self {
            scenes: LayoutScenes::of(&study.layouts, means)?,
            contacts: contacts.clone(),
            level: study.layouts.level_on(study.level),
            kinds: kinds.to_vec(),
            of_table,
        }))
    }

    /// Takes them from the layouts' solves, which the archive has; `kinds` are those of the table, in volts.
    ///
    /// # Errors
    /// See [`RunError`]; within, which contact has no answer.
    pub fn solved(
        &self,
        kinds: &[FilmKind],
        means: &[f64],
        place: &mut Place,
        context: RunContext<'_>,
    ) -> Result<Result<DifferingContacts, String>, RunError> {
        let Some(contacts) = ContactScenes::of(&self.scenes, &self.contacts) else {
            return Ok(Err("contacts differ in nothing".to_owned()));
        };
        let mut series = vec![self.scenes.series(self.level, &self.kinds)];
        series.extend(contacts.series(self.level, &self.kinds));
        place.of = place.first
            + series
                .iter()
                .map(|series| series.scenes.len())
                .sum::<usize>();
        let solved = outcomes_of_all(&series, means, place, context)?;
        let solved: Result<Vec<_>, String> = solved.into_iter().collect();
        Ok(solved.and_then(|mut solved| {
            let pressed = solved.remove(0);
            let mut in_volts = self.kinds.clone();
            for (number, kind) in self.of_table.iter().zip(kinds) {
                in_volts[*number] = *kind;
            }
            let fields = mesh_fields(&self.scenes, &in_volts, &pressed)?.fields;
            let own = SolvedContacts {
                scenes: &contacts,
                kinds: &in_volts,
                fields: &fields,
                // What a transfer misses is the same with and without a change.
                missing: &[],
            };
            Ok(DifferingContacts::new(
                own.surface(&solved)?.of_kinds(&self.of_table),
            ))
        }))
    }
}

/// Quantities that contacts differ in, as a table's kinds of film feel them.
#[derive(Debug, Clone, PartialEq)]
pub struct DifferingContacts {
    surface: ResponseSurface,
    /// Numbers of the surface's axes that are drawn.
    axes: Vec<usize>,
    drawn: Vec<DrawnFor>,
}

impl DifferingContacts {
    fn new(surface: ResponseSurface) -> Self {
        let quantity = |law: usize| surface.laws()[law].quantity;
        let all = surface.laws_of_axes().enumerate();
        let drawn = all.filter_map(|(axis, law)| Some((axis, DrawnFor::of(quantity(law))?)));
        let (axes, drawn) = drawn.unzip();
        Self {
            surface,
            axes,
            drawn,
        }
    }

    /// Spans for which each quantity is drawn.
    pub(super) fn drawn(&self) -> &[DrawnFor] {
        &self.drawn
    }

    /// Changes of one stance's contact, with the quantities at these shares of their laws, of films of these kinds so many degrees from it.
    pub(super) fn of_stance(&self, shares: &[f64], films: &[(usize, f64)]) -> StanceChanges {
        let mut of_axes = vec![0.0; self.surface.laws_of_axes().count()];
        for (axis, share) in self.axes.iter().zip(shares) {
            of_axes[*axis] = *share;
        }
        let all = self.surface.drawn(&of_axes, Drawn::All);
        let mut given = self.surface.drawn(&of_axes, Drawn::Nothing);
        for axis in &self.axes {
            given[*axis] = all[*axis];
        }
        let mut changes = StanceChanges {
            depths: self.surface.depths().clone(),
            signals: vec![Vec::new(); films.len()],
            forces_n: Vec::new(),
        };
        for depth_mm in self.surface.depths().places() {
            let contact = self.surface.contact(*depth_mm, &given);
            let [along, across, up, ..] = self.surface.changed_wrench(&contact);
            changes.forces_n.push([along, across, up]);
            let mut turns: Vec<(usize, Turn)> = Vec::new();
            for (signals, (kind, apart_deg)) in changes.signals.iter_mut().zip(films) {
                if turns.iter().all(|(known, _)| known != kind) {
                    let signal = self.surface.changed_signal(&contact, *kind);
                    turns.push((*kind, Turn::new(signal)));
                }
                let own = turns.iter().find(|(known, _)| known == kind);
                signals.push(own.map_or(0.0, |(_, turn)| turn.at(*apart_deg)));
            }
        }
        changes
    }
}

/// Changes that a stance's contact makes of films and forces, over the depth.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct StanceChanges {
    depths: Nodes,
    /// Changes of the signals by film and depth, V.
    signals: Vec<Vec<f64>>,
    /// Changes of the force along, across and vertical by depth, N.
    forces_n: Vec<[f64; 3]>,
}

impl StanceChanges {
    /// Changes at a depth, mm, of the first so many films, V, and of the force, N. Below the least solved depth they go with the depth, above the largest they are those there.
    pub fn at(&self, depth_mm: f64, films: usize) -> (impl Iterator<Item = f64> + '_, [f64; 3]) {
        let [least_mm, _] = self.depths.ends();
        let [shares, _] = self.depths.shares(depth_mm);
        let part = (depth_mm / least_mm).clamp(0.0, 1.0);
        let force_n =
            [0, 1, 2].map(|axis| part * summed(&shares, |node| self.forces_n[node][axis]));
        let signals = self.signals.iter().take(films);
        let signals = signals.map(move |own| part * summed(&shares, |node| own[node]));
        (signals, force_n)
    }
}

#[cfg(test)]
mod tests {
    use gsa::law::distribution::Distribution;
    use layouts::field::contact_axis::{AxisNode, Change, ContactAxis};
    use layouts::field::hermite::DEGREES;
    use layouts::field::response_surface::DepthSignals;

    use super::*;
    use documents::layouts::contact_laws::ContactLaw;
    use documents::layouts::contact_laws::ContactQuantity;

    /// Signals that grow with the depth and the square of a camber, and with a traction; forces that lean with the wheel.
    fn differing() -> DifferingContacts {
        let depths = [1.0, 2.0];
        let law = |quantity, reach: f64| ContactLaw {
            quantity,
            law: Distribution::uniform(-reach, reach).expect("a law"),
        };
        let axis = |law: usize, reach: f64, change: fn(f64, f64) -> (f64, f64)| {
            let node = |depth: f64, step: f64| {
                let (volts, across_n) = change(depth, step);
                AxisNode {
                    step,
                    value: step * reach,
                    change: Change {
                        force_n: 0.0,
                        wrench: [0.0, across_n, 0.0, 0.0, 0.0, 0.0],
                        signals: vec![vec![volts; DEGREES]; 2],
                    },
                }
            };
            ContactAxis {
                law,
                nodes: depths
                    .map(|depth| [-1.0, 0.0, 1.0].map(|step| node(depth, step)).to_vec())
                    .to_vec(),
            }
        };
        let usual = DepthSignals {
            depths: Nodes::new(depths.to_vec()),
            forces_n: vec![10.0, 30.0],
            signals: vec![vec![vec![0.0; DEGREES]; 2]; 2],
        };
        let laws = vec![
            law(ContactQuantity::Camber, 10.0),
            law(ContactQuantity::Traction, 0.2),
        ];
        let axes = vec![
            axis(0, 10.0, |depth, step| {
                (depth * step * step, -2.0 * depth * step)
            }),
            axis(1, 0.2, |_, step| (5.0 * step, 0.0)),
        ];
        DifferingContacts::new(ResponseSurface::new(
            usual,
            Nodes::new(depths.to_vec()),
            laws,
            axes,
        ))
    }

    #[test]
    fn a_camber_is_drawn_and_a_traction_is_left_to_the_table() {
        let differing = differing();
        assert_eq!(differing.drawn(), [DrawnFor::Stance]);
        // Three quarters of what is drawn of -10 to 10 degrees, but for a thousandth at either end.
        let step = 0.5 * 0.998;
        let changes = differing.of_stance(&[0.75], &[(0, 12.0), (1, -70.0)]);
        // In proportion to the depth below the least solved one, those of the largest above it.
        for (depth_mm, part) in [(1.0, 1.0), (2.0, 2.0), (0.3, 0.3), (0.0, 0.0), (9.0, 2.0)] {
            let (volts, force_n) = changes.at(depth_mm, 2);
            for volts in volts {
                assert!(
                    (volts - part * step * step).abs() < 1e-9,
                    "{depth_mm} {volts}"
                );
            }
            assert!(
                (force_n[1] + 2.0 * part * step).abs() < 1e-9,
                "{depth_mm} {force_n:?}"
            );
        }
        let (mut usual, force_n) = {
            let changes = differing.of_stance(&[0.5], &[(0, 12.0)]);
            let (volts, force_n) = changes.at(1.0, 1);
            (volts.collect::<Vec<_>>(), force_n)
        };
        assert!(usual.pop().is_some_and(|volts| volts.abs() < 1e-12) && force_n[1].abs() < 1e-12);
    }
}
