//! Solves changed scenes, after the layouts' own, and puts what they and other errors of readings do to the answer's layout into a study's result.

use super::changed::Changed;
use super::changed_errors::Compared;
use super::changed_scenes::{OTHERS, contacts, series};
use crate::answer::{Figures, contenders};
use crate::layout::solving::judged_layouts::noise;
use crate::layout::solving::measuring_layouts::ScoredLayouts;
use crate::points::worker_threads::in_parallel;
use crate::points::{Place, RunContext, RunError, outcomes_of_all};
use documents::study::Study;
use documents::study::plan::Plan;
use layouts::arrangement::Arrangement;
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
    let solved = match of_scene.is_empty() {
        true => Vec::new(),
        false => {
            let mut place = Place {
                first,
                of: first + all.iter().map(|series| series.scenes.len()).sum::<usize>(),
            };
            let solved = outcomes_of_all(&all, &plan.values()[0], &mut place, context)?;
            result.cost.layout_solves += place.first - first;
            solved
        }
    };
    let mut unchanged = Vec::new();
    let mut changes = of_readings(study);
    for (number, change) in of_scene.into_iter().enumerate() {
        match contacts(scored, number, &solved) {
            Ok(contacts) => changes.push((change, Some(contacts))),
            Err(reason) => unchanged.push(format!("{}: {reason}", change.name())),
        }
    }
    let found = in_parallel(changes.len(), context.threads, context.stop, |k| {
        let (change, contacts) = &changes[k];
        compared.changed(change, contacts.as_deref())
    });
    let mut found: Vec<AssumptionChange> = found.ok_or(RunError::Stopped)?;
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
        ("friction", asked.friction, "friction"),
    ];
    let missing = all
        .into_iter()
        .filter(|(_, value, law)| value.is_none() && !has_law(law));
    missing.map(|(name, ..)| name.to_owned()).collect()
}
