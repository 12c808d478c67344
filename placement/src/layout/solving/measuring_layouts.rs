//! Solves what layouts ask for, after the study's own points, and puts layouts and what they show into its result.

use fem_client::scene::Level;
use fem_client::solver::Solver;

use crate::layout::solving::contact_fields::SolvedContacts;
use crate::layout::solving::contact_scenes::ContactScenes;
use crate::layout::solving::glued::angle_residual::AngleResidual;
use crate::layout::solving::glued::film_angles::{FilmAngles, FilmAnswers};
use crate::layout::solving::glued::layout_films::{PressedFields, film_loads};
use crate::layout::solving::glued::transfers::GluedFilms;
use crate::layout::solving::judged_layouts::Answer;
use crate::layout::solving::layout_fields::{MeshFields, mesh_fields};
use crate::layout::solving::layout_scenes::LayoutScenes;
use crate::layout::solving::layout_workload::{LayoutWorkload, levels};
use crate::layout::solving::mirror_parts::mirrored;
use crate::layout::solving::shear_fields::add_shear;
use crate::layout::solving::study_layouts::Asked;
use crate::points::Place;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::archive::Outcome;
use crate::points::{SceneSeries, outcomes_of_all};
use crate::score::map_slopes::MapSlopes;
use documents::layouts::contact_laws::Scatter;
use documents::layouts::layout_settings::GluedFilm;
use documents::study::Study;
use documents::study::plan::Plan;
use layouts::arrangement::FilmKind;
use layouts::field::film_field::DepthFields;
use layouts::field::response_surface::{Drawn, ResponseSurface};
use layouts::ranking::asked_layouts::AskedLayout;
use layouts::simulate::draws::Draws;
use results::{
    ContactFindings, FilmAnglesReport, GradedNote, LayoutFindings, LayoutScore, RankedLayout,
    StudyResult, Topic,
};

const ORDER_NOTE: &str = "Layouts are in the order of their simulated error (95th percentile at the worst load) times the root of the number of films; their \
     Cramer-Rao bounds are lower, and far lower where two places look alike.";

/// Layouts that were scored, and the finer mesh's fields that they were scored by.
pub(crate) struct ScoredLayouts {
    pub layouts: Vec<AskedLayout>,
    /// Draws of their simulated readings.
    pub draws: Draws,
    pub level: Level,
    pub scenes: LayoutScenes,
    /// Kinds of film, with their volts where they are glued.
    pub kinds: Vec<FilmKind>,
    pub fields: MeshFields,
}

/// Fills in a result's layouts, with what the inputs do to them by the map's slopes; gives what they were scored by. The points have ordinals from `first` on.
///
/// # Errors
/// See [`RunError`]; the result is unchanged then.
pub(crate) fn measure(
    first: usize,
    study: &Study,
    plan: &Plan,
    (result, slopes): (&mut StudyResult, Option<&MapSlopes>),
    context: RunContext<'_>,
) -> Result<Option<ScoredLayouts>, RunError> {
    if !study.layouts.is_asked() {
        return Ok(None);
    }
    let asked = Asked::of(study);
    let scenes = LayoutScenes::of(&study.layouts, &plan.points[0]);
    let mut solves = 0;
    let answer = match &scenes {
        Err(reason) => Err(reason.clone()),
        Ok(scenes) => {
            let (answer, points) = both_meshes(first, study, plan, &asked, scenes, context)?;
            solves = points;
            answer
        }
    };
    result.cost.layout_solves = solves;
    match answer {
        Ok(answer) => {
            let own = (result.cut_point.depth_mm, slopes);
            let judged = answer.filled(study, asked, own, context)?;
            result.note(GradedNote::bearing(Topic::Layout, ORDER_NOTE));
            result.layouts = judged.ranked;
            result.layout_findings = Some(judged.findings);
            Ok(Some(ScoredLayouts {
                layouts: judged.scored,
                draws: judged.draws,
                level: answer.level,
                scenes: answer.scenes.clone(),
                kinds: answer.kinds,
                fields: answer.fine,
            }))
        }
        Err(reason) => {
            result.layouts = without_scores(&asked, &reason);
            result.layout_findings = Some(LayoutFindings {
                unit: study.layouts.unit().to_owned(),
                size_mm: study.layouts.size_mm,
                reasons: vec![reason],
                ..LayoutFindings::default()
            });
            Ok(None)
        }
    }
}

/// Solves both meshes, or says why there is nothing; and how many points that took.
pub(crate) fn both_meshes<'s>(
    first: usize,
    study: &Study,
    plan: &Plan,
    asked: &Asked,
    scenes: &'s LayoutScenes,
    context: RunContext<'_>,
) -> Result<(Result<Answer<'s>, String>, usize), RunError> {
    let mut place = Place {
        first,
        of: first + count(study, plan, context.solver),
    };
    let (level, coarser) = levels(study, plan, context.solver);
    let meshes: Vec<Level> = std::iter::once(level)
        .chain(coarser.map(|coarser| coarser.level))
        .collect();
    let on_mesh = |level: &Level| scenes.series(*level, asked.kinds.all());
    let loads: Vec<SceneSeries> = meshes.iter().map(on_mesh).collect();
    let means = &plan.values()[0];
    let pressed = outcomes_of_all(&loads, means, &mut place, context)?;
    let mut answers = Vec::new();
    for (mesh, pressed) in meshes.into_iter().zip(pressed) {
        // The finer mesh alone is tested.
        answers.push(mesh_answer(
            (mesh, answers.is_empty()),
            pressed,
            scenes,
            (asked.kinds.all(), study.layouts.glued.as_ref(), means),
            &mut place,
            context,
        )?);
    }
    if study.layouts.shear && answers[0].is_ok() {
        drag(&mut answers, scenes, asked, means, &mut place, context)?;
    }
    let contacts = ContactScenes::of(scenes, &study.layouts.contacts);
    let judged = match contacts.filter(|_| answers[0].is_ok()) {
        Some(contacts) => {
            let contacts = (&contacts, study.layouts.contacts.scatter);
            differ(&mut answers, contacts, asked, means, &mut place, context)?
        }
        None => None,
    };
    let fine = answers.remove(0);
    let coarse = coarser.and_then(|coarser| Some((answers.pop()?.ok()?.fields, coarser)));
    let answer = fine.map(|fine| Answer {
        level,
        scenes,
        kinds: fine.kinds,
        fine: fine.fields,
        coarse,
        contacts: judged,
        films: fine.films,
    });
    Ok((answer, place.first - first))
}

/// Counts the points that are solved for layouts.
fn count(study: &Study, plan: &Plan, solver: &dyn Solver) -> usize {
    let series = LayoutWorkload::of(study, plan).series(solver).into_iter();
    series.map(|series| series.scenes.len()).sum()
}

/// Answer of one mesh.
pub(crate) struct MeshAnswer {
    level: Level,
    /// Kinds of film, with their volts where they are glued.
    kinds: Vec<FilmKind>,
    pub fields: MeshFields,
    /// Residuals of the transfers of films that are solved around the wheel, by kind; none of others.
    missing: Vec<AngleResidual>,
    films: Option<FilmAnglesReport>,
}

/// Answer of one mesh whose loads were solved; films glued on are solved now, and the place moves behind their points. Without the first load there is nothing to
/// start from: that costs the layouts, not the study.
///
/// # Errors
/// See [`RunError`]; within, why there is none.
pub(crate) fn mesh_answer(
    (level, tested): (Level, bool),
    pressed: Result<Vec<Outcome>, String>,
    scenes: &LayoutScenes,
    (bare, glued, means): (&[FilmKind], Option<&GluedFilm>, &[f64]),
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Result<MeshAnswer, String>, RunError> {
    let pressed = match pressed {
        Ok(pressed) => pressed,
        Err(reason) => return Ok(Err(format!("Layouts have no scores: {reason}"))),
    };
    let of_kinds = |kinds: Vec<FilmKind>| {
        let fields = mesh_fields(scenes, &kinds, &pressed)?;
        Ok(MeshAnswer {
            level,
            kinds,
            fields,
            missing: Vec::new(),
            films: None,
        })
    };
    let unscored = |reason: String| {
        format!(
            "Layouts of glued films have no scores, which layouts.film = \"bare\" has: {reason}."
        )
    };
    Ok(match glued {
        None => of_kinds(bare.to_vec()),
        Some(glued) if glued.is_coupled => {
            let loads = film_loads(scenes, bare.len(), level, tested);
            let films = FilmAngles::new(&glued.film, bare, loads);
            let solved = films.solve(means, place, context)?.map_err(unscored);
            solved.and_then(|solved| {
                let mut answer = of_kinds(films.in_volts(&solved).map_err(unscored)?)?;
                answer
                    .add_missing(scenes, &films, &solved)
                    .map_err(unscored)?;
                Ok(answer)
            })
        }
        Some(glued) => {
            let films = GluedFilms::of_layouts(&glued.film, scenes, bare, level);
            let kinds = films.kinds_in_volts(&pressed, means, place, context)?;
            kinds.map_err(unscored).and_then(of_kinds)
        }
    })
}

impl MeshAnswer {
    /// Returns its answers to the scenes of a surface.
    fn solved<'s>(&'s self, scenes: &'s ContactScenes<'s>) -> SolvedContacts<'s> {
        SolvedContacts {
            scenes,
            kinds: &self.kinds,
            fields: &self.fields.fields,
            missing: &self.missing,
        }
    }

    /// Adds to its fields what films were solved around the wheel for.
    fn add_missing(
        &mut self,
        scenes: &LayoutScenes,
        films: &FilmAngles<'_>,
        solved: &FilmAnswers,
    ) -> Result<(), String> {
        let mut signals = PressedFields {
            fields: &mut self.fields.fields,
            scenes,
        };
        let depths = signals.depths_mm();
        let (missing, report) = films.put(solved, (&self.kinds, &depths), &mut signals)?;
        self.missing = missing;
        self.films = Some(report);
        self.fields.crown = self.fields.crown_signal()?;
        Ok(())
    }
}

/// Adds what the ground does that is dragged, on all meshes that have fields; the place moves behind its points.
fn drag(
    answers: &mut [Result<MeshAnswer, String>],
    scenes: &LayoutScenes,
    asked: &Asked,
    means: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<(), RunError> {
    let readout = mirrored(asked.kinds.all());
    let sheared = |answer: &MeshAnswer| {
        SceneSeries::from_first(scenes.sheared(answer.level), readout.clone())
    };
    let sheared: Vec<SceneSeries> = answers.iter().flatten().map(sheared).collect();
    let dragged = outcomes_of_all(&sheared, means, place, context)?;
    for (answer, dragged) in answers.iter_mut().flatten().zip(dragged) {
        add_shear(&mut answer.fields, scenes, &answer.kinds, dragged);
    }
    Ok(())
}

/// Adds the response surface over contacts as they come, on all meshes that have fields, and says how far the finer one's is off; the place moves behind its
/// points. A mesh without it has no fields any more: its scores would be those of other contacts.
fn differ(
    answers: &mut [Result<MeshAnswer, String>],
    (contacts, scatter): (&ContactScenes<'_>, Scatter),
    asked: &Asked,
    means: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Option<ContactFindings>, RunError> {
    let kinds = asked.kinds.all();
    let on_mesh = |answer: &MeshAnswer| contacts.series(answer.level, kinds);
    let series: Vec<SceneSeries> = answers.iter().flatten().flat_map(on_mesh).collect();
    let mut solved = outcomes_of_all(&series, means, place, context)?.into_iter();
    let mut findings = None;
    for (mesh, slot) in answers.iter_mut().enumerate() {
        let Ok(answer) = slot else {
            continue;
        };
        let count = contacts.axes.len() + contacts.pairs().len();
        let own: Vec<_> = solved.by_ref().take(count).collect();
        let own: Result<Vec<_>, String> = own.into_iter().collect();
        match own.and_then(|own| answer.solved(contacts).surface(&own)) {
            Ok(surface) => {
                if mesh == 0 {
                    findings = judged(answer, contacts, &surface, (kinds, means), place, context)?;
                }
                let found = findings.as_ref().filter(|_| mesh == 0);
                let surface_error = found.map(|found| answer.fields.surface_error(found));
                answer.fields.fields = DepthFields {
                    surface_error,
                    ..DepthFields::over_contacts(surface, Drawn::All, scatter == Scatter::Together)
                };
            }
            Err(reason) => {
                *slot = Err(format!("Layouts have no scores: {reason}."));
                // Of the next mesh nothing may have been solved.
                break;
            }
        }
    }
    Ok(findings)
}

/// Errors of a mesh's surface at contacts that it hasn't seen, which are solved now: it tells how far the ground is dragged for their tractions.
fn judged(
    answer: &mut MeshAnswer,
    contacts: &ContactScenes<'_>,
    surface: &ResponseSurface,
    (kinds, means): (&[FilmKind], &[f64]),
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Option<ContactFindings>, RunError> {
    let checks = contacts.checks(|depth_mm, axis, value| surface.step(depth_mm, axis, value));
    let series = contacts.check_series(&checks, answer.level, kinds);
    let solved = outcomes_of_all(&series, means, place, context)?;
    let solved: Result<Vec<Vec<Outcome>>, String> = solved.into_iter().collect();
    let own = answer.solved(contacts);
    match solved.and_then(|solved| own.findings(surface, &checks, &solved.concat())) {
        Ok(found) => Ok(Some(found)),
        Err(reason) => {
            let reason = format!("The surface over contacts has no error: {reason}.");
            answer.fields.reasons.push(reason);
            Ok(None)
        }
    }
}

fn without_scores(asked: &Asked, reason: &str) -> Vec<RankedLayout> {
    let unscored = |(row, layout): (usize, &AskedLayout)| RankedLayout {
        rank: row + 1,
        rank_certain: Some(false),
        score: LayoutScore {
            reason: Some(reason.to_owned()),
            ..LayoutScore::default()
        },
        ..layout.label.clone()
    };
    asked.layouts.iter().enumerate().map(unscored).collect()
}
