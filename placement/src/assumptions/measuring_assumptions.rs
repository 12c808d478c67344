//! Solves changed scenes, after the layouts' own, and puts what they and other errors of readings do to the answer's layout into a study's result.

use super::changed::Changed;
use super::changed_errors::Compared;
use super::changed_films::solved;
use super::changed_scenes::{OTHERS, contacts, series};
use crate::answer::{Figures, contenders};
use crate::layout::solving::judged_layouts::noise;
use crate::layout::solving::measuring_layouts::ScoredLayouts;
use crate::points::worker_threads::in_parallel;
use crate::points::{Place, RunContext, RunError, outcomes_of_all};
use documents::study::Study;
use documents::study::plan::Plan;
use layouts::arrangement::Arrangement;
use layouts::field::film_field::Noise;
use layouts::simulate::drawn_contacts::TrueContact;
use results::{AssumptionChange, AssumptionFindings, RankedLayout, StudyResult};

/// Fills in what the figures of the layout that answers rest on. The points have ordinals from `first` on.
///
/// # Errors
/// See [`RunError`]; the result is unchanged then.
pub(crate) fn measure(
    first: usize,
    study: &Study,
    plan: &Plan,
    (result, scored): (&mut StudyResult, &ScoredLayouts),
    context: RunContext<'_>,
) -> Result<(), RunError> {
    let arrangement_of = |ranked: &RankedLayout| -> Option<(usize, &Arrangement)> {
        let mut scored = scored.layouts.iter();
        let own = scored.find(|layout| layout.label.is_same(ranked))?;
        Some((ranked.rank, &own.arrangement))
    };
    let contenders = contenders(study, result, OTHERS);
    let Some((&answers, assumed)) = contenders.first().map(|own| (own, Figures::of(own))) else {
        return Ok(());
    };
    let (Some(angle), Some(force)) = (assumed.angle, assumed.force) else {
        return Ok(());
    };
    let rank = answers.rank;
    let compared = Compared {
        fields: &scored.fields,
        noise: noise(&study.layouts, &scored.fields),
        draws: &scored.draws,
        layouts: contenders.into_iter().filter_map(arrangement_of).collect(),
        assumed,
        question: study.question,
    };
    let of_scene = Changed::of_scene(&study.layouts, &plan.points[0]);
    let all = series((&scored.scenes, scored.level), &of_scene, &scored.kinds);
    let means = &plan.values()[0];
    let mut place = Place {
        first,
        of: first + all.iter().map(|series| series.scenes.len()).sum::<usize>(),
    };
    let scenes = outcomes_of_all(&all, means, &mut place, context)?;
    let mut unchanged = Vec::new();
    let mut changes = of_readings(study);
    for (number, change) in of_scene.into_iter().enumerate() {
        match contacts(scored, number, &scenes) {
            Ok(contacts) => changes.push((change, Some(contacts))),
            Err(reason) => unchanged.push(format!("{}: {reason}", change.name())),
        }
    }
    let found = in_parallel(changes.len(), context.threads, context.stop, |k| {
        let (change, contacts) = &changes[k];
        compared.changed(change, contacts.as_deref())
    });
    let mut found: Vec<AssumptionChange> = found.ok_or(RunError::Stopped)?;
    if let Some(change) = Changed::of_films(&study.layouts) {
        let changed = (study, scored, &change);
        match with_films(&compared, changed, means, &mut place, context)? {
            Ok(change) => found.push(change),
            Err(reason) => unchanged.push(format!("{}: {reason}", change.name())),
        }
    }
    result.cost.layout_solves += place.first - first;
    found.sort_by(|a, b| b.times.total_cmp(&a.times));
    unchanged.extend(not_asked(study));
    if let Some(findings) = &mut result.layout_findings {
        findings.assumptions = Some(AssumptionFindings {
            rank,
            angle_error_deg: angle.value,
            force_error_n: force.value,
            changes: found,
            unchanged,
        });
    }
    Ok(())
}

/// Errors with films of another model, whose noise is the same share of what the crown feels.
fn with_films(
    compared: &Compared<'_>,
    (study, scored, change): (&Study, &ScoredLayouts, &Changed),
    means: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Result<AssumptionChange, String>, RunError> {
    let layouts: Vec<&Arrangement> = compared.layouts.iter().map(|(_, own)| *own).collect();
    let other = solved((study, change), (scored, &layouts), means, place, context)?;
    Ok(other.map(|other| {
        let ranks = compared.layouts.iter().map(|(rank, _)| *rank);
        let own = compared.noise;
        let relaid = Compared {
            fields: &other.fields,
            noise: Noise {
                floor: own.floor / compared.fields.crown * other.fields.crown,
                ..own
            },
            layouts: ranks.zip(&other.layouts).collect(),
            ..*compared
        };
        relaid.changed(change, None)
    }))
}

fn of_readings(study: &Study) -> Vec<(Changed, Option<Vec<TrueContact>>)> {
    let changes = Changed::of_readings(&study.layouts).into_iter();
    changes.map(|change| (change, None)).collect()
}

/// Assumptions of the scene that the document names no value of, and no law.
fn not_asked(study: &Study) -> Vec<String> {
    let asked = &study.layouts.assumptions;
    let has_law = |name: &str| {
        let mut laws = study.layouts.contacts.laws.iter();
        laws.any(|law| law.quantity.as_str() == name)
    };
    let all = [
        ("pressure", asked.pressure_factor, "pressure_factor"),
        ("camber", asked.camber_deg, "camber_deg"),
        ("friction", asked.friction, "friction_factor"),
    ];
    let missing = all
        .into_iter()
        .filter(|(_, value, law)| value.is_none() && !has_law(law));
    let film = asked.film.is_none().then_some("film");
    let missing = missing.map(|(name, ..)| name).chain(film);
    missing.map(str::to_owned).collect()
}
