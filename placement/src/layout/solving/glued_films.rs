//! What glued films make of the bare wall's strains, on one mesh: for each kind of film two coupled equilibria give its transfer, and that its volts.

use fem_client::scene::{Film, Level, Scene};
use fem_client::solver::{Readout, Response};

use crate::layout::arrangement::{FilmKind, FilmReads};
use crate::layout::solving::layout_fields::{CONTACT, samples};
use crate::layout::solving::layout_scenes::LayoutScenes;
use crate::run::archive::Outcome;
use crate::run::{Place, RunContext, RunError};
use crate::signals::answers::{Answer, check_transferable, signal_of_tension, tension};
use crate::signals::measuring::answers_from_first;
use crate::signals::tension_transfer::TensionTransfer;

/// A film that is glued on wherever layouts have one.
pub(crate) struct GluedFilms<'s> {
    film: &'s Film,
    kinds: &'s [FilmKind],
    /// The bare tire at the loads of the transfer, with their numbers among the layouts' scenes; none where there is a single load.
    loads: Option<[(usize, Scene); 2]>,
}

impl<'s> GluedFilms<'s> {
    /// Those of these kinds, on the bare tire at two loads, with their numbers among its outcomes.
    pub fn new(film: &'s Film, kinds: &'s [FilmKind], loads: Option<[(usize, Scene); 2]>) -> Self {
        Self { film, kinds, loads }
    }

    /// Those of layouts, on the tires of a level.
    pub fn of_layouts(
        film: &'s Film,
        scenes: &LayoutScenes,
        kinds: &'s [FilmKind],
        level: Level,
    ) -> Self {
        let all = scenes.scenes(level);
        let of_load = |index: usize| (index, all[index].clone());
        let loads = scenes.of_transfer().map(|two| two.map(of_load));
        Self::new(film, kinds, loads)
    }

    /// The two scenes of each kind of film, with the film at the contact's centre.
    pub fn series(&self) -> impl Iterator<Item = Vec<Scene>> + '_ {
        let kinds = self.loads.iter().flat_map(|_| self.kinds);
        kinds.map(|kind| {
            let scenes = self.loads.iter().flatten();
            scenes.map(|(_, scene)| self.glued(scene, kind)).collect()
        })
    }

    fn glued(&self, scene: &Scene, kind: &FilmKind) -> Scene {
        Scene {
            film: Some(Film {
                theta_deg: 0.0,
                phi_deg: kind.phi_deg,
                angle_deg: kind.angle_deg,
                ..self.film.clone()
            }),
            ..scene.clone()
        }
    }

    /// The kinds with the volts that their strains are: the bare wall's strains come from `outcomes`, in the order of the layouts' scenes. The place moves behind
    /// the points that are solved.
    ///
    /// # Errors
    /// See [`RunError`]; within, why there is no transfer.
    pub fn kinds_in_volts(
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
            match self.in_volts(kind, bare, &coupled) {
                Ok(kind) => kinds.push(kind),
                Err(reason) => return Ok(Err(reason)),
            }
        }
        Ok(Ok(kinds))
    }

    /// A kind with its volts, from what the bare wall and the film give at both loads.
    fn in_volts(
        &self,
        kind: &FilmKind,
        bare: [&Outcome; 2],
        coupled: &[Answer],
    ) -> Result<FilmKind, String> {
        let strains = bare.map(|outcome| {
            let response = outcome.as_ref().map_err(ToString::to_string)?;
            self.strains(response, kind)
                .ok_or_else(|| "the solver gives no strains around the wheel".to_owned())
        });
        let tensions = [0, 1].map(|load| {
            let answer = coupled.get(load).ok_or("it wasn't solved")?;
            let film = answer.as_ref().map_err(Clone::clone)?.film;
            let signal = film.and_then(|film| film.signal);
            let signal = signal.ok_or("the solver gives no reading of a glued film")?;
            Ok::<_, String>(tension(&signal))
        });
        let ([a, b], [n, m]) = (strains, tensions);
        let transfer = TensionTransfer::of([a?, b?], [n?, m?])?;
        let volts = |strain| signal_of_tension(self.film, transfer.tension(strain)).open_circuit_v;
        Ok(FilmKind {
            reads: FilmReads::Volts([volts([1.0, 0.0]), volts([0.0, 1.0])]),
            ..*kind
        })
    }

    /// The bare wall's mean strains along and across a film at the contact's centre.
    fn strains(&self, response: &Response, kind: &FilmKind) -> Option<[f64; 2]> {
        let strain = |shares| {
            let kind = FilmKind {
                reads: FilmReads::Volts(shares),
                ..*kind
            };
            Some(samples(&response.rings, &kind, self.kinds)?[CONTACT])
        };
        Some([strain([1.0, 0.0])?, strain([0.0, 1.0])?])
    }
}
