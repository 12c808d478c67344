//! Volts of glued films on one mesh, from the bare wall's strains: for each kind of film two coupled equilibria give its transfer, and that its volts.

use fem_client::scene::{Film, Level, Scene};
use fem_client::solver::{FilmSignal, Readout, Response};

use crate::layout::solving::layout_fields::{CONTACT, samples};
use crate::layout::solving::layout_scenes::LayoutScenes;
use crate::points::Place;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::archive::Outcome;
use crate::signals::answers::{Answer, check_transferable, signal_of_tension, tension};
use crate::signals::measuring::answers_from_first;
use crate::signals::tension_transfer::TensionTransfer;
use layouts::arrangement::{FilmKind, FilmReads};

/// A film that is glued on wherever layouts have one.
pub(crate) struct GluedFilms<'s> {
    film: &'s Film,
    kinds: &'s [FilmKind],
    /// The bare tire at the loads of the transfer, with their numbers among the layouts' scenes; none where there is a single load.
    loads: Option<[(usize, Scene); 2]>,
}

impl<'s> GluedFilms<'s> {
    /// Lists the glued films of layouts, on the tires of a level.
    pub(crate) fn of_layouts(
        film: &'s Film,
        scenes: &LayoutScenes,
        kinds: &'s [FilmKind],
        level: Level,
    ) -> Self {
        let all = scenes.scenes(level);
        let of_load = |index: usize| (index, all[index].clone());
        let loads = scenes.of_transfer().map(|two| two.map(of_load));
        Self { film, kinds, loads }
    }

    /// The two scenes of each kind of film, with the film at the contact's centre.
    pub fn series(&self) -> impl Iterator<Item = Vec<Scene>> + '_ {
        let kinds = self.loads.iter().flat_map(|_| self.kinds);
        kinds.map(|kind| {
            let scenes = self.loads.iter().flatten();
            let glued = scenes.map(|(_, scene)| glued(scene, self.film, kind, 0.0));
            glued.collect()
        })
    }

    /// The kinds with the volts that their strains are: the bare wall's strains come from `outcomes`, in the order of the layouts' scenes. The place moves behind
    /// the points that are solved.
    ///
    /// # Errors
    /// See [`RunError`]; within, why there is no transfer.
    pub(crate) fn kinds_in_volts(
        &self,
        outcomes: &[Outcome],
        values: &[f64],
        place: &mut Place,
        context: RunContext<'_>,
    ) -> Result<Result<Vec<FilmKind>, String>, RunError> {
        let Some([(first, _), (second, _)]) = &self.loads else {
            return Ok(Err("two loads give a transfer; there is one".to_owned()));
        };
        if let Err(reason) = check_transferable(self.film) {
            return Ok(Err(reason));
        }
        let bare = [*first, *second].map(|load| &outcomes[load]);
        let mut kinds = Vec::new();
        for (kind, scenes) in self.kinds.iter().zip(self.series()) {
            let readout = Readout::default();
            let coupled = answers_from_first(&scenes, None, &readout, values, place, context)?;
            let coupled = [0, 1].map(|load| coupled.get(load));
            match in_volts(self.film, kind, self.kinds, bare, coupled) {
                Ok(kind) => kinds.push(kind),
                Err(reason) => return Ok(Err(reason)),
            }
        }
        Ok(Ok(kinds))
    }
}

/// A tire with a film of this kind glued on, so many degrees around the wheel.
pub(crate) fn glued(tire: &Scene, film: &Film, kind: &FilmKind, theta_deg: f64) -> Scene {
    Scene {
        film: Some(Film {
            theta_deg,
            phi_deg: kind.phi_deg,
            angle_deg: kind.angle_deg,
            ..film.clone()
        }),
        ..tire.clone()
    }
}

/// A kind with its volts, from what the bare wall, read for these `kinds`, and the film at the contact's centre give at two loads.
///
/// # Errors
/// Why there is no transfer.
pub(crate) fn in_volts(
    film: &Film,
    kind: &FilmKind,
    kinds: &[FilmKind],
    bare: [&Outcome; 2],
    coupled: [Option<&Answer>; 2],
) -> Result<FilmKind, String> {
    let strains = bare.map(|outcome| {
        let response = outcome.as_ref().map_err(ToString::to_string)?;
        strains(response, kind, kinds)
            .ok_or_else(|| "the solver gives no strains around the wheel".to_owned())
    });
    let tensions = coupled.map(|answer| Ok::<_, String>(tension(&signal(answer)?)));
    let ([a, b], [n, m]) = (strains, tensions);
    let transfer = TensionTransfer::of([a?, b?], [n?, m?])?;
    let volts = |strain| signal_of_tension(film, transfer.tension(strain)).open_circuit_v;
    Ok(FilmKind {
        reads: FilmReads::Volts([volts([1.0, 0.0]), volts([0.0, 1.0])]),
        ..*kind
    })
}

/// Returns what a glued film gives.
///
/// # Errors
/// Why it gives nothing.
pub(crate) fn signal(answer: Option<&Answer>) -> Result<FilmSignal, String> {
    let response = answer.ok_or("it wasn't solved")?.as_ref();
    let film = response.map_err(Clone::clone)?.film;
    let signal = film.map(|film| film.signal);
    signal.ok_or_else(|| "the solver gives no reading of a glued film".to_owned())
}

/// The bare wall's mean strains along and across a film at the contact's centre.
fn strains(response: &Response, kind: &FilmKind, kinds: &[FilmKind]) -> Option<[f64; 2]> {
    let strain = |shares| {
        let kind = FilmKind {
            reads: FilmReads::Volts(shares),
            ..*kind
        };
        Some(samples(&response.rings, &kind, kinds)?[CONTACT])
    };
    Some([strain([1.0, 0.0])?, strain([0.0, 1.0])?])
}
