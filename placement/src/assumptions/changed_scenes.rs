//! Scenes in which an assumption is changed, and contacts as films feel them there.
//!
//! They are solved beside the scene as assumed, on the coarse mesh at most: what a change adds to signals and forces there is added to the fields of the layouts'
//! own mesh. On the foot tire at 2 mm a friction of 0.5 takes 15.4 % off the meridional strain at the crown on the coarse mesh, 15.3 % on the reference mesh and
//! 24 % on the draft; a camber of 5 degrees 4.8, 5.3 and 7.2 %.

use fem_client::scene::{Level, Scene};
use fem_client::solver::Response;

use super::changed::Changed;
use super::changed_films::expected_series;
use crate::layout::solving::layout_fields::samples;
use crate::layout::solving::layout_scenes::{LayoutScenes, readout};
use crate::layout::solving::layout_workload::LayoutWorkload;
use crate::layout::solving::measuring_layouts::ScoredLayouts;
use crate::points::SceneSeries;
use crate::points::archive::Outcome;
use layouts::arrangement::FilmKind;
use layouts::field::hermite::Turn;
use layouts::simulate::drawn_contacts::TrueContact;

/// Layouts that are compared with the one that answers.
pub(super) const OTHERS: usize = 2;

/// All that is solved for changed assumptions of a study's layouts.
pub(crate) fn assumption_series(work: &LayoutWorkload<'_>) -> Vec<SceneSeries> {
    let Some(scenes) = work.scored() else {
        return Vec::new();
    };
    let (study, kinds) = (work.study, work.asked.kinds.all());
    let changes = Changed::of_scene(&study.layouts, &work.plan.points[0]);
    let level = study.layouts.level_on(study.level);
    let mut all = series((scenes, level), &changes, kinds);
    if let Some(change) = Changed::of_films(&study.layouts) {
        all.extend(expected_series((study, &work.asked), scenes, &change));
    }
    all
}

/// Returns how often a layout is scored at a load with an assumption changed, where every layout keeps it.
pub(crate) fn changed_scorings(work: &LayoutWorkload<'_>) -> usize {
    let settings = &work.study.layouts;
    if !settings.is_asked() {
        return 0;
    }
    let of_scene = Changed::of_scene(settings, &work.plan.points[0]);
    let of_films = Changed::of_films(settings);
    let changes = Changed::of_readings(settings).len() + of_scene.len() + of_films.iter().len();
    changes * work.loads() * work.asked.layouts.len().min(1 + OTHERS)
}

/// A series for each load of layouts on a level: the scene as assumed, then each change of it; none without a change.
pub(super) fn series(
    (scenes, level): (&LayoutScenes, Level),
    changes: &[Changed],
    kinds: &[FilmKind],
) -> Vec<SceneSeries> {
    let of_load = |load| {
        let assumed = scenes.pressed_by(load, level.min(Level::Coarse));
        let changed = changes.iter().map(|change| {
            let mut scene: Scene = assumed.clone();
            change.change(&mut scene);
            scene
        });
        let all = std::iter::once(assumed.clone()).chain(changed);
        SceneSeries::from_first(all.collect(), readout(kinds))
    };
    match changes.is_empty() {
        true => Vec::new(),
        false => scenes.loads.iter().copied().map(of_load).collect(),
    }
}

/// Contacts of one change, one for each load that was reached.
///
/// # Errors
/// Why there are none, in words.
pub(super) fn contacts(
    scored: &ScoredLayouts,
    change: usize,
    solved: &[Result<Vec<Outcome>, String>],
) -> Result<Vec<TrueContact>, String> {
    let loads = scored.fields.loads.iter().enumerate();
    let reached = loads.filter_map(|(load, depth)| Some((load, *depth.as_ref().ok()?)));
    let contact = |(load, depth_mm): (usize, f64)| {
        // Of the first alone there is a reason where nothing came of it.
        let solved = solved
            .get(load)
            .or(solved.first())
            .ok_or("it wasn't solved")?;
        let solved = solved.as_ref().map_err(Clone::clone)?;
        let [assumed, changed] = [0, 1 + change].map(|point| {
            let outcome = solved.get(point).ok_or("it wasn't solved")?;
            outcome.as_ref().map_err(|unsolved| unsolved.to_string())
        });
        of_change(scored, depth_mm, [assumed?, changed?])
    };
    reached.map(contact).collect()
}

/// The contact at a depth, mm, with what the change adds.
fn of_change(
    scored: &ScoredLayouts,
    depth_mm: f64,
    [assumed, changed]: [&Response; 2],
) -> Result<TrueContact, String> {
    let field = scored.fields.fields.at(depth_mm);
    let read = |response: &Response, kind: &FilmKind| {
        let read = samples(&response.rings, kind, &scored.kinds);
        read.ok_or_else(|| "the solver gives no strains around the wheel".to_owned())
    };
    let signals = scored.kinds.iter().zip(&field.kinds).map(|(kind, own)| {
        let (changed, assumed) = (read(changed, kind)?, read(assumed, kind)?);
        let added = changed.iter().zip(&assumed).map(|(a, b)| a - b);
        let sum = own
            .signal
            .samples()
            .iter()
            .zip(added)
            .map(|(own, added)| own + added);
        Ok(Turn::new(sum.collect()))
    });
    Ok(TrueContact {
        force_n: field.force_n + changed.reaction_n - assumed.reaction_n,
        signals: signals.collect::<Result<_, String>>()?,
        values: Vec::new(),
    })
}
