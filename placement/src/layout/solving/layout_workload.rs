//! Workload of a study's layouts: the scenes of each mesh, and how often a layout is scored.

use fem_client::scene::Level;
use fem_client::solver::{Coarser, Readout, Solver};

use crate::layout::solving::contact_scenes::ContactScenes;
use crate::layout::solving::glued::film_angles::FilmAngles;
use crate::layout::solving::glued::layout_films::film_loads;
use crate::layout::solving::glued::transfers::GluedFilms;
use crate::layout::solving::judged_layouts::FULL_TO_SHORT;
use crate::layout::solving::layout_scenes::LayoutScenes;
use crate::layout::solving::mirror_parts::mirrored;
use crate::layout::solving::study_layouts::Asked;
use crate::points::SceneSeries;
use crate::signals::answers::check_transferable;
use documents::layouts::layout_settings::GluedFilm;
use documents::study::Study;
use documents::study::plan::Plan;
use layouts::arrangement::FilmKind;
use layouts::search::layout_search::expected_looks;
use layouts::search::search_criterion::SearchCriterion;

/// Layouts of a menu for each that is simulated in full: 37 of 150 on the foot tire.
const OFFERED_TO_KEPT: usize = 4;

/// The level of a study's layouts, and the coarser one that shows its error.
pub(crate) fn levels(study: &Study, plan: &Plan, solver: &dyn Solver) -> (Level, Option<Coarser>) {
    let mut scene = plan.points[0].clone();
    scene.model.level = study.layouts.level_on(study.level);
    (scene.model.level, solver.coarser(&scene))
}

/// All that is solved for a study's layouts: the scenes of each mesh, and what is read of them.
pub(crate) fn layout_series(study: &Study, plan: &Plan, solver: &dyn Solver) -> Vec<SceneSeries> {
    if !study.layouts.is_asked() {
        return Vec::new();
    }
    let Ok(scenes) = LayoutScenes::of(&study.layouts, &plan.points[0]) else {
        return Vec::new();
    };
    let asked = Asked::of(study);
    let kinds = asked.kinds.all();
    let (level, coarser) = levels(study, plan, solver);
    let levels = std::iter::once(level).chain(coarser.map(|coarser| coarser.level));
    let mut series = Vec::new();
    for on_level in levels {
        series.push(scenes.series(on_level, kinds));
        let glued = study.layouts.glued.as_ref();
        let on = (on_level, on_level == level);
        series.extend(glued_series(glued, &scenes, kinds, on));
        if let Some(contacts) = ContactScenes::of(&scenes, &study.layouts.contacts) {
            series.extend(contacts.series(on_level, kinds));
            // The finer mesh alone is judged by contacts that the surface hasn't seen.
            if on_level == level {
                series.extend(contacts.expected_checks(level, kinds));
            }
        }
        if study.layouts.shear {
            series.push(SceneSeries::from_first(
                scenes.sheared(on_level),
                mirrored(kinds),
            ));
        }
    }
    series
}

/// All that is solved with films glued on, on a level, `tested` by other films or not; nothing of a film that has no transfer.
pub(crate) fn glued_series(
    glued: Option<&GluedFilm>,
    scenes: &LayoutScenes,
    kinds: &[FilmKind],
    (level, tested): (Level, bool),
) -> Vec<SceneSeries> {
    let Some(GluedFilm { film, is_coupled }) =
        glued.filter(|glued| check_transferable(&glued.film).is_ok())
    else {
        return Vec::new();
    };
    if *is_coupled {
        let loads = film_loads(scenes, kinds.len(), level, tested);
        return FilmAngles::new(film, kinds, loads).series();
    }
    let films = GluedFilms::of_layouts(film, scenes, kinds, level);
    let from_first = |scenes| SceneSeries::from_first(scenes, Readout::default());
    films.series().map(from_first).collect()
}

/// Films of the largest layout.
pub(crate) fn largest_layout(study: &Study) -> usize {
    let asked = Asked::of(study).most_films();
    let searched = study
        .layouts
        .search
        .iter()
        .flat_map(|search| search.films.iter().copied());
    searched.fold(asked, usize::max)
}

/// Layouts that a study's search is expected to look at by each criterion, and the places that films may have.
pub(crate) fn searched(study: &Study) -> (f64, usize) {
    let places = Asked::of(study).places;
    let count = places.films.len();
    let numbers = study.layouts.search.iter().flat_map(|search| &search.films);
    let looks = numbers.map(|films| expected_looks(count, places.fixed, *films));
    (looks.sum(), count)
}

/// Returns how often a layout is scored at a load on a mesh: those that a search finds, and those with a film dead, are scored, too.
pub(crate) fn scorings(study: &Study, plan: &Plan, solver: &dyn Solver) -> usize {
    let meshes = match study.layouts.is_asked() {
        true => 1 + usize::from(levels(study, plan, solver).1.is_some()),
        false => 0,
    };
    let loads =
        LayoutScenes::of(&study.layouts, &plan.points[0]).map_or(0, |scenes| scenes.loads.len());
    let simulated = SearchCriterion::ALL.map(SearchCriterion::simulated);
    let simulated: usize = simulated.iter().sum();
    let found = study
        .layouts
        .search
        .as_ref()
        .map_or(0, |search| search.films.len() * simulated);
    let layouts = Asked::of(study).layouts;
    let offered = layouts.iter().filter(|layout| layout.of_menu).count();
    let layouts = layouts.len() - offered + offered.div_ceil(OFFERED_TO_KEPT) + found;
    let glimpses = offered.div_ceil(FULL_TO_SHORT);
    // Contacts that differ in nothing, and in each quantity alone.
    let laws = study.layouts.contacts.laws.len();
    let alone = if laws > 0 && meshes > 0 { 1 + laws } else { 0 };
    layouts * loads * (meshes + usize::from(study.layouts.dead && meshes > 0) + alone) + glimpses
}
