//! Glued films beside the contact, solved with the tire: what their transfer misses, over the wheel angle and the depth.
//!
//! A film that is stiffer than the wall breaks the tire's symmetry: its transfer, of two loads with the film above the contact, misses what the film does to the
//! wall elsewhere. What it misses is solved at some angles and loads, and added to the transfer's signals.
//!
//! Those solves leave out friction, which makes half a tire ten times as dear, for both the films and the bare wall that they are compared with; the solves that
//! test the signals have it.

use fem_client::scene::{Film, Scene};
use fem_client::solver::Readout;

use crate::layout::solving::glued::angle_residual::AngleResidual;
use crate::layout::solving::glued::transfers::{glued, in_volts, signal};
use crate::layout::solving::layout_fields::samples;
use crate::layout::solving::layout_scenes::readout;
use crate::points::Place;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::SceneSeries;
use crate::points::archive::Outcome;
use crate::points::outcomes_of_all;
use crate::score::scaled_errors::Errors;
use crate::signals::answers::{Answer, check_transferable};
use crate::signals::measuring::answers_from_first;
use layouts::arrangement::FilmKind;
use layouts::field::hermite::Turn;
use results::FilmAnglesReport;

/// Angles from the contact, degrees, that are solved: near where a foot's contact ends, 12 to 20 degrees from its centre, a film's signal turns.
const ANGLES_DEG: [f64; 12] = [
    0.0, 3.0, 6.0, 9.0, 12.0, 15.0, 18.0, 22.0, 29.0, 45.0, 90.0, 180.0,
];

/// Tests reach to so many degrees from the contact.
pub(crate) const FARTHEST_TEST_DEG: f64 = 30.0;

/// Ground that presses the tire while films are solved around the wheel.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FilmLoad {
    /// Name in words, as "13 N".
    pub name: String,
    /// The bare tire.
    pub bare: Scene,
    /// The tire that films are glued on, which may have another mesh.
    pub tire: Scene,
}

/// A solve that only tests the signals.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FilmTest {
    /// Wheel angle from the contact to the film, degrees.
    pub angle_deg: f64,
    /// Load, N, or depth, mm: whatever the signals are asked by.
    pub pressing: f64,
    /// The tire that the film is glued on.
    pub tire: Scene,
}

/// All that films are pressed by.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FilmLoads {
    /// Mesh level of the tire with a film.
    pub level: String,
    /// Loads, increasing.
    pub loads: Vec<FilmLoad>,
    /// Number of the load that is solved first: the others start from its equilibrium.
    pub first: usize,
    /// Numbers of the two loads that give the transfer.
    pub of_transfer: Option<[usize; 2]>,
    /// Tests of each kind of film.
    pub tests: Vec<Vec<FilmTest>>,
}

/// Signals around the wheel to which what a transfer misses is added.
pub(crate) trait TurnedSignals {
    /// Adds to a kind's signals what is missing at each depth and wheel angle.
    fn add(&mut self, kind: usize, missing: &AngleResidual);

    /// Signal of a kind of film at a wheel angle, degrees, under a pressing as tests have it.
    fn signal(&self, kind: usize, angle_deg: f64, pressing: f64) -> f64;

    /// The largest signal of a kind of film.
    fn largest_signal(&self, kind: usize) -> f64;
}

/// Kinds of film that are glued on.
pub(crate) struct FilmAngles<'s> {
    film: &'s Film,
    kinds: &'s [FilmKind],
    loads: FilmLoads,
}

/// Answers of the solves.
pub(crate) struct FilmAnswers {
    /// The bare wall without friction, by load.
    pub bare: Vec<Outcome>,
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
    /// Lists the solves of these kinds under these loads.
    pub fn new(film: &'s Film, kinds: &'s [FilmKind], loads: FilmLoads) -> Self {
        Self { film, kinds, loads }
    }

    /// All scenes with what is read of them, those of a series on one mesh; none of a film that has no transfer.
    pub fn series(&self) -> Vec<SceneSeries> {
        if check_transferable(self.film).is_err() {
            return Vec::new();
        }
        let mut all = vec![SceneSeries::from_first(self.bare(), readout(self.kinds))];
        all.extend(self.film_series());
        all
    }

    /// The scenes with a film: of each kind those around the wheel, angle by angle, then its tests.
    fn film_series(&self) -> Vec<SceneSeries> {
        let of_kind = |(kind, tests): (&FilmKind, &Vec<FilmTest>)| {
            let around = solved_deg(kind).into_iter();
            let around = around.map(|angle| self.around(kind, angle));
            let tested = tests.iter();
            let tested =
                tested.map(|test| vec![glued(&test.tire, self.film, kind, test.angle_deg)]);
            around.chain(tested).collect::<Vec<_>>()
        };
        let kinds = self.kinds.iter().zip(&self.loads.tests);
        kinds
            .flat_map(of_kind)
            .map(|scenes| SceneSeries::from_first(scenes, Readout::default()))
            .collect()
    }

    /// The bare tire without friction.
    fn bare(&self) -> Vec<Scene> {
        let loads = self.loads.loads.iter();
        self.first_first(loads.map(|load| smooth(load.bare.clone())))
    }

    /// The scenes of a film at one angle, degrees.
    fn around(&self, kind: &FilmKind, angle_deg: f64) -> Vec<Scene> {
        let loads = self.loads.loads.iter();
        self.first_first(loads.map(|load| smooth(glued(&load.tire, self.film, kind, angle_deg))))
    }

    /// Puts what is solved first where the least load was; the same again puts it back.
    fn first_first<T>(&self, by_load: impl IntoIterator<Item = T>) -> Vec<T> {
        let mut ordered: Vec<T> = by_load.into_iter().collect();
        ordered.swap(0, self.loads.first);
        ordered
    }

    /// Solves what the archive lacks; the place moves behind the points.
    ///
    /// # Errors
    /// See [`RunError`]; within, why there are no answers.
    pub fn solve(
        &self,
        means: &[f64],
        place: &mut Place,
        context: RunContext<'_>,
    ) -> Result<Result<FilmAnswers, String>, RunError> {
        if let Err(reason) = check_transferable(self.film) {
            return Ok(Err(reason));
        }
        let all = self.series();
        let mut solved = outcomes_of_all(&all, means, place, context)?.into_iter();
        let bare = match solved.next() {
            Some(Ok(bare)) => self.first_first(bare),
            Some(Err(reason)) => return Ok(Err(reason)),
            None => return Ok(Err("no load was solved".to_owned())),
        };
        let mut by_series = Vec::new();
        for (series, outcomes) in all.iter().skip(1).zip(solved) {
            by_series.push(match outcomes {
                Ok(outcomes) => outcomes.into_iter().map(answer).collect(),
                Err(_) => self.begun_at_least(series, means, place, context)?,
            });
        }
        let mut by_series = by_series.into_iter();
        let mut kinds = Vec::new();
        for (kind, tests) in self.kinds.iter().zip(&self.loads.tests) {
            let around = by_series.by_ref().take(solved_deg(kind).len());
            let around = around.map(|answers| self.first_first(answers)).collect();
            let tested = by_series.by_ref().take(tests.len()).flatten().collect();
            kinds.push(KindAnswers { around, tested });
        }
        Ok(Ok(FilmAnswers { bare, kinds }))
    }

    /// Solves a series anew whose first load has no equilibrium: the least one, which stands in its place, may have one.
    fn begun_at_least(
        &self,
        series: &SceneSeries,
        means: &[f64],
        place: &mut Place,
        context: RunContext<'_>,
    ) -> Result<Vec<Answer>, RunError> {
        let least = self.loads.first.min(series.scenes.len() - 1);
        let mut scenes = series.scenes.clone();
        scenes.swap(0, least);
        place.of += scenes.len();
        let mut answers =
            answers_from_first(&scenes, None, &series.readout, means, place, context)?;
        answers.swap(0, least);
        Ok(answers)
    }

    /// The kinds with the volts that the bare wall's strains are by their transfer.
    ///
    /// # Errors
    /// Why there is no transfer.
    pub fn in_volts(&self, answers: &FilmAnswers) -> Result<Vec<FilmKind>, String> {
        let two = self.loads.of_transfer;
        let [first, second] = two.ok_or("two loads give a transfer; there is one")?;
        let bare = [&answers.bare[first], &answers.bare[second]];
        let of_kind = |(kind, answers): (&FilmKind, &KindAnswers)| {
            let coupled = [first, second].map(|load| answers.around[0].get(load));
            in_volts(self.film, kind, self.kinds, bare, coupled)
        };
        self.kinds.iter().zip(&answers.kinds).map(of_kind).collect()
    }

    /// Adds to the transfers' signals, those of `kinds`, what they miss, and says how far the signals are off then; depths, mm, are those of the loads.
    ///
    /// # Errors
    /// Why an angle has no signal.
    pub fn put(
        &self,
        answers: &FilmAnswers,
        (kinds, depths_mm): (&[FilmKind], &[f64]),
        signals: &mut impl TurnedSignals,
    ) -> Result<(Vec<AngleResidual>, FilmAnglesReport), String> {
        // Loads that the bare tire doesn't bear have no signals to add to.
        let solved: Vec<usize> = (0..answers.bare.len())
            .filter(|load| answers.bare[*load].is_ok())
            .collect();
        let depths_mm: Vec<f64> = solved.iter().map(|load| depths_mm[*load]).collect();
        let increase = depths_mm.windows(2).all(|pair| pair[0] < pair[1]);
        if !increase || depths_mm.first().is_none_or(|depth| *depth <= 0.0) {
            return Err("a larger load has no larger depth".to_owned());
        }
        let (mut of_transfer, mut of_all) = (Errors::default(), Some(Errors::default()));
        let mut residuals = Vec::new();
        for (number, (kind, of_kind)) in kinds.iter().zip(&answers.kinds).enumerate() {
            let around = self.missing(kind, kinds, (&solved, &answers.bare), of_kind)?;
            let before = self.test(number, &of_kind.tested, signals);
            let residual = AngleResidual::new(&solved_deg(kind), &depths_mm, &around);
            signals.add(number, &residual);
            residuals.push(residual);
            let after = self.test(number, &of_kind.tested, signals);
            let full_scale = signals.largest_signal(number);
            let before = before.into_iter().flatten();
            of_transfer.add(around.into_iter().flatten().chain(before), full_scale);
            of_all = of_all.zip(after).map(|(mut errors, after)| {
                errors.add(after, full_scale);
                errors
            });
        }
        let of_all = of_all.filter(|errors| errors.count() > 0);
        let loads_n = answers.bare.iter().flatten();
        let report = FilmAnglesReport {
            level: self.loads.level.clone(),
            angles_deg: ANGLES_DEG.to_vec(),
            loads_n: loads_n.map(|response| response.reaction_n).collect(),
            tested: of_all.as_ref().map_or(0, Errors::count),
            signal_rms: of_all.as_ref().map(Errors::rms),
            signal_worst: of_all.as_ref().map(Errors::worst),
            transfer_worst: of_transfer.worst(),
        };
        Ok((residuals, report))
    }

    /// Volts that a kind's transfer misses, by angle and load, of these loads.
    fn missing(
        &self,
        kind: &FilmKind,
        kinds: &[FilmKind],
        (loads, bare): (&[usize], &[Outcome]),
        answers: &KindAnswers,
    ) -> Result<Vec<Vec<f64>>, String> {
        let bare = loads.iter().map(|load| (*load, &bare[*load]));
        let bare = bare.map(|(load, bare)| Ok((load, transferred(kind, kinds, bare)?)));
        let bare: Vec<(usize, Turn)> = bare.collect::<Result<_, String>>()?;
        let at_angle = |(angle, around): (f64, &Vec<Answer>)| {
            let missing = bare.iter().map(|(load, bare)| {
                let volts = volts(&around[*load]).map_err(|reason| {
                    format!(
                        "a glued film {angle} degrees from a contact of {}: {reason}",
                        self.loads.loads[*load].name
                    )
                })?;
                Ok(volts - bare.at(angle))
            });
            missing.collect()
        };
        let around = solved_deg(kind).into_iter().zip(&answers.around);
        around.map(at_angle).collect()
    }

    /// Returns what signals lack of the volts of a kind of film, at the solves that test it; None where one of them has no equilibrium.
    fn test(
        &self,
        number: usize,
        answers: &[Answer],
        signals: &impl TurnedSignals,
    ) -> Option<Vec<f64>> {
        let missing = |(answer, test): (&Answer, &FilmTest)| {
            let expected = signals.signal(number, test.angle_deg, test.pressing);
            Some(volts(answer).ok()? - expected)
        };
        let tested = answers.iter().zip(&self.loads.tests[number]);
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

fn answer(outcome: Outcome) -> Answer {
    outcome.map_err(|unsolved| unsolved.to_string())
}

/// Volts of a glued film.
fn volts(answer: &Answer) -> Result<f64, String> {
    Ok(signal(Some(answer))?.open_circuit_v)
}
