//! Glued films beside the contact, solved with the tire: the wheel angle as an axis of a table.
//!
//! A film that is stiffer than the wall breaks the tire's symmetry: its transfer, of two loads with the film above the contact, misses what the film does to the
//! wall elsewhere. What it misses is solved at some angles and loads, and added to the table.
//!
//! Those solves leave out friction, which makes half a tire ten times as dear, for both the films and the bare wall that they are compared with; the solves that
//! test the table have it.

use fem_client::scene::{Film, Scene};
use fem_client::solver::Readout;

use crate::layout::solving::glued_films::{glued, in_volts, signal};
use crate::layout::solving::layout_fields::samples;
use crate::layout::solving::layout_scenes::readout;
use crate::layout::solving::measuring_layouts::outcomes;
use crate::points::Place;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::SceneSeries;
use crate::points::archive::Outcome;
use crate::response_table::angle_residual::AngleResidual;
use crate::response_table::solved_table::ResponseTable;
use crate::response_table::table_scenes::{Pressing, TableScenes};
use crate::score::scaled_errors::Errors;
use crate::signals::answers::Answer;
use crate::signals::measuring::answers_from_first;
use documents::signals::series::loads_of_transfer;
use layouts::arrangement::FilmKind;
use layouts::field::hermite::Turn;
use results::FilmAnglesReport;

/// Angles from the contact, degrees, that are solved: near where a foot's contact ends, 12 to 20 degrees from its centre, a film's signal turns.
const ANGLES_DEG: [f64; 12] = [
    0.0, 3.0, 6.0, 9.0, 12.0, 15.0, 18.0, 22.0, 29.0, 45.0, 90.0, 180.0,
];
/// Number of the load that is solved first: the others start from its equilibrium.
const FIRST_LOAD: usize = 2;

/// Kinds of film that are glued on.
pub(crate) struct FilmAngles<'s> {
    film: &'s Film,
    kinds: &'s [FilmKind],
    scenes: &'s TableScenes,
}

/// Answers of the solves.
pub(crate) struct FilmAnswers {
    /// The bare wall without friction, by load.
    bare: Vec<Outcome>,
    kinds: Vec<KindAnswers>,
}

/// Answers of the solves of one kind of film.
struct KindAnswers {
    /// Answers by angle, then load.
    around: Vec<Vec<Answer>>,
    /// Answers by test.
    tested: Vec<Answer>,
}

impl<'s> FilmAngles<'s> {
    /// Lists the solves of these kinds on the tires of a table.
    pub fn new(film: &'s Film, kinds: &'s [FilmKind], scenes: &'s TableScenes) -> Self {
        Self {
            film,
            kinds,
            scenes,
        }
    }

    /// All scenes with what is read of them, those of a series on one mesh.
    pub fn series(&self) -> Vec<SceneSeries> {
        let of_kind = |(number, kind)| {
            let around = solved_deg(kind).into_iter();
            let around = around.map(|angle| self.around(kind, angle));
            let tested = self.tests(number).into_iter().map(|scene| vec![scene]);
            around.chain(tested).collect::<Vec<_>>()
        };
        let kinds = self.kinds.iter().enumerate();
        let films = kinds.flat_map(of_kind);
        let films = films.map(|scenes| SceneSeries::from_first(scenes, Readout::default()));
        std::iter::once(SceneSeries::from_first(self.bare(), readout(self.kinds)))
            .chain(films)
            .collect()
    }

    /// The bare tire without friction, the load first that the others start from.
    fn bare(&self) -> Vec<Scene> {
        let scene = |load_n: f64| self.scenes.scene(&Pressing::undragged(load_n));
        self.loads_n().map(|load_n| smooth(scene(load_n))).collect()
    }

    /// The scenes of a film at one angle, degrees.
    fn around(&self, kind: &FilmKind, angle_deg: f64) -> Vec<Scene> {
        let scene = |load_n: f64| self.scene(kind, angle_deg, load_n);
        self.loads_n().map(|load_n| smooth(scene(load_n))).collect()
    }

    /// Loads, N, in the order of the solves.
    fn loads_n(&self) -> impl Iterator<Item = f64> {
        let mut loads = self.scenes.settings().film_loads_n();
        loads.swap(0, FIRST_LOAD);
        loads.into_iter()
    }

    /// The scenes that test a kind of film.
    fn tests(&self, number: usize) -> Vec<Scene> {
        let tested = self.scenes.tested_films(number).into_iter();
        let kind = &self.kinds[number];
        tested
            .map(|(angle_deg, load_n)| self.scene(kind, angle_deg, load_n))
            .collect()
    }

    fn scene(&self, kind: &FilmKind, angle_deg: f64, load_n: f64) -> Scene {
        glued(&self.scenes.film_scene(load_n), self.film, kind, angle_deg)
    }

    /// Solves what the archive lacks; the place moves behind the points.
    ///
    /// # Errors
    /// See [`RunError`]; within, why the bare wall wasn't solved.
    pub fn solve(
        &self,
        means: &[f64],
        place: &mut Place,
        context: RunContext<'_>,
    ) -> Result<Result<FilmAnswers, String>, RunError> {
        let readout = readout(self.kinds);
        let mut bare = match outcomes(&self.bare(), &readout, means, place, context)? {
            Ok(bare) => bare,
            Err(reason) => return Ok(Err(reason)),
        };
        bare.swap(0, FIRST_LOAD);
        let readout = Readout::default();
        let mut solved = |scenes: &[Scene], least| {
            answers_from_first(scenes, least, &readout, means, place, context)
        };
        let mut kinds = Vec::new();
        for (number, kind) in self.kinds.iter().enumerate() {
            let mut around = Vec::new();
            for angle in solved_deg(kind) {
                // The least load stands where the first one was.
                let mut answers = solved(&self.around(kind, angle), Some(FIRST_LOAD))?;
                answers.swap(0, FIRST_LOAD);
                around.push(answers);
            }
            let mut tested = Vec::new();
            for scene in self.tests(number) {
                tested.extend(solved(&[scene], None)?);
            }
            kinds.push(KindAnswers { around, tested });
        }
        Ok(Ok(FilmAnswers { bare, kinds }))
    }

    /// The kinds with the volts that the bare wall's strains are by their transfer.
    ///
    /// # Errors
    /// Why there is no transfer.
    pub fn in_volts(&self, answers: &FilmAnswers) -> Result<Vec<FilmKind>, String> {
        let loads = self.scenes.settings().film_loads_n();
        let two = loads_of_transfer(&loads).ok_or("two loads give a transfer; there is one")?;
        let two = two.map(|load_n| loads.iter().position(|other| *other == load_n));
        let [Some(first), Some(second)] = two else {
            return Err("a load of the transfer isn't solved".to_owned());
        };
        let bare = [&answers.bare[first], &answers.bare[second]];
        let of_kind = |(kind, answers): (&FilmKind, &KindAnswers)| {
            let coupled = [first, second].map(|load| answers.around[0].get(load));
            in_volts(self.film, kind, self.kinds, bare, coupled)
        };
        self.kinds.iter().zip(&answers.kinds).map(of_kind).collect()
    }

    /// Adds to a table of the transfers' volts, those of `kinds`, what they miss, and says how far it is off then.
    ///
    /// # Errors
    /// Why an angle has no signal.
    pub fn put(
        &self,
        answers: &FilmAnswers,
        kinds: &[FilmKind],
        table: &mut ResponseTable,
    ) -> Result<FilmAnglesReport, String> {
        let loads = self.scenes.settings().film_loads_n();
        let depths: Vec<f64> = loads.iter().map(|n| table.depth_of_load_mm(*n)).collect();
        let (mut of_transfer, mut of_table) = (Errors::default(), Some(Errors::default()));
        for (number, (kind, of_kind)) in kinds.iter().zip(&answers.kinds).enumerate() {
            let solved_deg = solved_deg(kind);
            let bare = answers.bare.iter();
            let bare = bare.map(|outcome| transferred(kind, kinds, outcome));
            let bare: Vec<Turn> = bare.collect::<Result<_, _>>()?;
            let missing = |(angle, around): (&f64, &Vec<Answer>)| {
                let loads = around.iter().zip(bare.iter().zip(&loads));
                let missing = loads.map(|(answer, (bare, load_n))| {
                    Ok(volts(answer, *angle, *load_n)? - bare.at(*angle))
                });
                missing.collect::<Result<Vec<f64>, String>>()
            };
            let around = solved_deg.iter().zip(&of_kind.around).map(missing);
            let around: Vec<Vec<f64>> = around.collect::<Result<_, _>>()?;
            let before = self.test(number, &of_kind.tested, table);
            let residual = AngleResidual::new(&solved_deg, &depths, &around);
            table.add_undragged(number, |depth, angle| residual.at(depth, angle));
            let after = self.test(number, &of_kind.tested, table);
            let full_scale = table.largest_signal(number);
            let before = before.into_iter().flatten();
            of_transfer.add(around.into_iter().flatten().chain(before), full_scale);
            of_table = of_table.zip(after).map(|(mut errors, after)| {
                errors.add(after, full_scale);
                errors
            });
        }
        let of_table = of_table.filter(|errors| errors.count() > 0);
        Ok(FilmAnglesReport {
            level: self.scenes.settings().film_level.as_str().to_owned(),
            angles_deg: ANGLES_DEG.to_vec(),
            loads_n: loads,
            tested: of_table.as_ref().map_or(0, Errors::count),
            signal_rms: of_table.as_ref().map(Errors::rms),
            signal_worst: of_table.as_ref().map(Errors::worst),
            transfer_worst: of_transfer.worst(),
        })
    }

    /// Returns what a table lacks of the volts of a kind of film, at the solves that test it; None where one of them has no equilibrium.
    fn test(&self, number: usize, answers: &[Answer], table: &ResponseTable) -> Option<Vec<f64>> {
        let missing = |(answer, (angle, load_n)): (&Answer, (f64, f64))| {
            let weights = table.weights(table.depth_of_load_mm(load_n), [0.0; 2]);
            let film = table.film_nodes(std::iter::once((number, angle)));
            Some(volts(answer, angle, load_n).ok()? - film.signal(0, &weights))
        };
        let tested = answers.iter().zip(self.scenes.tested_films(number));
        tested.map(missing).collect()
    }
}

/// A tire on ground without friction.
fn smooth(mut scene: Scene) -> Scene {
    scene.contact.friction = 0.0;
    scene
}

/// The volts of a kind of film around the wheel, by its transfer.
fn transferred(kind: &FilmKind, kinds: &[FilmKind], outcome: &Outcome) -> Result<Turn, String> {
    let response = outcome.as_ref().map_err(ToString::to_string)?;
    let samples = samples(&response.rings, kind, kinds);
    Ok(Turn::new(
        samples.ok_or("the solver gives no strains around the wheel")?,
    ))
}

/// Angles at which a kind of film is solved, degrees: one that lies along the wheel or across it reads the same on both sides of the contact.
fn solved_deg(kind: &FilmKind) -> Vec<f64> {
    let two_sides = kind.angle_deg % 90.0 != 0.0;
    let images = ANGLES_DEG.iter().filter(|_| two_sides).map(|angle| -angle);
    let images = images.filter(|angle| *angle < 0.0 && *angle > -180.0);
    ANGLES_DEG.into_iter().chain(images).collect()
}

/// Volts of a glued film at an angle, degrees, under a load, N.
fn volts(answer: &Answer, angle_deg: f64, load_n: f64) -> Result<f64, String> {
    let signal = signal(Some(answer)).map_err(|reason| {
        format!("a glued film {angle_deg} degrees from a contact of {load_n} N: {reason}")
    })?;
    Ok(signal.open_circuit_v)
}
