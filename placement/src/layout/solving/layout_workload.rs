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

/// Layouts that a study asks for, and the loads that they are under, from which all follows that is solved and scored for them.
pub(crate) struct LayoutWorkload<'s> {
    pub study: &'s Study,
    pub plan: &'s Plan,
    pub asked: Asked,
    /// Scenes of the loads; none where there is no load.
    pub scenes: Option<LayoutScenes>,
}

impl<'s> LayoutWorkload<'s> {
    pub(crate) fn of(study: &'s Study, plan: &'s Plan) -> Self {
        Self {
            study,
            plan,
            asked: Asked::of(study),
            scenes: LayoutScenes::of(&study.layouts, &plan.points[0]).ok(),
        }
    }

    /// The scenes of its loads, where layouts are scored.
    pub(crate) fn scored(&self) -> Option<&LayoutScenes> {
        let scenes = self.scenes.as_ref();
        scenes.filter(|_| self.study.layouts.is_asked())
    }

    /// All that is solved: the scenes of each mesh, and what is read of them.
    pub(crate) fn series(&self, solver: &dyn Solver) -> Vec<SceneSeries> {
        let Some(scenes) = self.scored() else {
            return Vec::new();
        };
        let (settings, kinds) = (&self.study.layouts, self.asked.kinds.all());
        let (level, coarser) = levels(self.study, self.plan, solver);
        let levels = std::iter::once(level).chain(coarser.map(|coarser| coarser.level));
        let mut series = Vec::new();
        for on_level in levels {
            series.push(scenes.series(on_level, kinds));
            let on = (on_level, on_level == level);
            series.extend(glued_series(settings.glued.as_ref(), scenes, kinds, on));
            if let Some(contacts) = ContactScenes::of(scenes, &settings.contacts) {
                series.extend(contacts.series(on_level, kinds));
                // The finer mesh alone is judged by contacts that the surface hasn't seen.
                if on_level == level {
                    series.extend(contacts.expected_checks(level, kinds));
                }
            }
            if settings.shear {
                series.push(SceneSeries::from_first(
                    scenes.sheared(on_level),
                    mirrored(kinds),
                ));
            }
        }
        series
    }

    /// Films of the largest layout.
    pub(crate) fn largest_layout(&self) -> usize {
        let search = self.study.layouts.search.iter();
        let searched = search.flat_map(|search| search.films.iter().copied());
        searched.fold(self.asked.most_films(), usize::max)
    }

    /// Layouts that the search is expected to look at by each criterion, and the places that films may have.
    pub(crate) fn searched(&self) -> (f64, usize) {
        let places = &self.asked.places;
        let count = places.films.len();
        let search = self.study.layouts.search.iter();
        let numbers = search.flat_map(|search| &search.films);
        let looks = numbers.map(|films| expected_looks(count, places.fixed, *films));
        (looks.sum(), count)
    }

    /// Returns how often a layout is scored at a load on a mesh: those that a search finds, and those with a film dead, are scored, too.
    pub(crate) fn scorings(&self, solver: &dyn Solver) -> usize {
        let settings = &self.study.layouts;
        let meshes = match settings.is_asked() {
            true => 1 + usize::from(levels(self.study, self.plan, solver).1.is_some()),
            false => 0,
        };
        // Contacts that differ in nothing, and in each quantity alone.
        let laws = settings.contacts.laws.len();
        let alone = if laws > 0 && meshes > 0 { 1 + laws } else { 0 };
        let meshes = meshes + usize::from(settings.dead && meshes > 0) + alone;
        self.told() * self.loads() * meshes + self.offered().div_ceil(FULL_TO_SHORT)
    }

    /// Returns how many layouts are scored in full, and told: those asked for, those kept of the menu, and those that a search finds.
    pub(crate) fn told(&self) -> usize {
        let simulated = SearchCriterion::ALL.map(SearchCriterion::simulated);
        let simulated: usize = simulated.iter().sum();
        let search = self.study.layouts.search.as_ref();
        let found = search.map_or(0, |search| search.films.len() * simulated);
        let offered = self.offered();
        self.asked.layouts.len() - offered + offered.div_ceil(OFFERED_TO_KEPT) + found
    }

    /// Layouts of the menu.
    fn offered(&self) -> usize {
        let layouts = self.asked.layouts.iter();
        layouts.filter(|layout| layout.of_menu).count()
    }

    /// Number of loads that layouts are under.
    pub(crate) fn loads(&self) -> usize {
        self.scenes.as_ref().map_or(0, |scenes| scenes.loads.len())
    }
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
