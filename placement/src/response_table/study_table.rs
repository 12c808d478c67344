//! A study's table of responses: the films of its layouts, up to the largest load of its rig.

use fem_client::scene::{Film, Level, Scene};
use fem_client::solver::Readout;

use crate::layout::arrangement::{FilmKind, LaidFilm};
use crate::layout::ranking::asked_layouts::AskedLayout;
use crate::layout::solving::study_layouts::Asked;
use crate::response_table::laid_films::{LaidFilms, bare_in_volts};
use crate::response_table::table_scenes::TableScenes;
use crate::response_table::table_settings::TableSettings;
use crate::response_table::table_solving::{TestedTable, solve, table_series};
use crate::result::RankedLayout;
use crate::rig::rig_settings::RigSettings;
use crate::run::{Place, RunContext, RunError};
use crate::signals::signal_settings::SignalSettings;
use crate::study::Study;
use crate::study::plan::Plan;

/// What a table is solved for.
pub struct StudyTable {
    scenes: TableScenes,
    kinds: Vec<FilmKind>,
    film: Film,
    /// The study's layouts, whose films name the kinds by number.
    pub layouts: Vec<AskedLayout>,
}

impl StudyTable {
    /// Of a study with a rig.
    ///
    /// # Errors
    /// Why there is no table.
    pub fn of(study: &Study, rig: &RigSettings, plan: &Plan) -> Result<Self, String> {
        if study.layouts.glued.is_some() {
            return Err(
                "A rig reads films that follow the wall: layouts.film must be \"bare\".".to_owned(),
            );
        }
        let film = film_of(study);
        let asked = Asked::of(study);
        let (mut kinds, mut layouts) = (Vec::new(), asked.layouts);
        for laid in layouts
            .iter_mut()
            .flat_map(|layout| &mut layout.arrangement.films)
        {
            let kind = bare_in_volts(&asked.kinds.all()[laid.kind], &film);
            laid.kind = kinds
                .iter()
                .position(|known| *known == kind)
                .unwrap_or_else(|| {
                    kinds.push(kind);
                    kinds.len() - 1
                });
        }
        if layouts.is_empty() {
            return Err("A rig needs layouts: layouts asks for none.".to_owned());
        }
        let means = &plan.points[0];
        let settings = TableSettings::new(
            rig.gait.load_n[1],
            means.geometry.section_radius_mm,
            means.contact.friction,
            study.level.min(Level::Coarse),
        );
        let scenes = TableScenes::new(means, settings);
        scenes.check()?;
        Ok(Self {
            scenes,
            kinds,
            film,
            layouts,
        })
    }

    /// All that is solved for a study's rig, and what is read of it; nothing without a table.
    pub(crate) fn series_of(study: &Study, plan: &Plan) -> Vec<(Vec<Scene>, Readout)> {
        let table = study.rig.as_ref().map(|rig| Self::of(study, rig, plan));
        let series = table.and_then(Result::ok);
        series.iter().flat_map(Self::series).collect()
    }

    /// All that is solved, and what is read of it.
    pub(crate) fn series(&self) -> impl Iterator<Item = (Vec<Scene>, Readout)> {
        let series = table_series(&self.scenes, &self.kinds).into_iter();
        series.filter(|(scenes, _)| !scenes.is_empty())
    }

    /// The layout that a row of the result is of; none of those that a search found.
    pub fn asked(&self, ranked: &RankedLayout) -> Option<&AskedLayout> {
        self.layouts
            .iter()
            .find(|layout| ranked.is_same(&layout.label))
    }

    /// How many solves that takes.
    pub fn solves(&self) -> usize {
        self.series().map(|(scenes, _)| scenes.len()).sum()
    }

    /// Loads and shifts.
    pub fn settings(&self) -> &TableSettings {
        self.scenes.settings()
    }

    /// Solves what the archive lacks.
    ///
    /// # Errors
    /// See [`RunError`]; within, why there is no table.
    pub fn solved(
        &self,
        plan: &Plan,
        context: RunContext<'_>,
    ) -> Result<Result<TestedTable, String>, RunError> {
        self.solved_from(0, plan, context)
    }

    /// The same with points that have ordinals from `first` on.
    pub(crate) fn solved_from(
        &self,
        first: usize,
        plan: &Plan,
        context: RunContext<'_>,
    ) -> Result<Result<TestedTable, String>, RunError> {
        let mut place = Place {
            first,
            of: first + self.solves(),
        };
        solve(
            &self.scenes,
            &self.kinds,
            &plan.values()[0],
            &mut place,
            context,
        )
    }

    /// The films of a layout, as a rig asks for them.
    pub fn laid<'t>(&self, tested: &'t TestedTable, films: &[LaidFilm]) -> LaidFilms<'t> {
        LaidFilms::new(&tested.table, &self.film, films)
    }
}

/// The film of the signals; where the study asks for none that of the scene, or a common one; of the layouts' size.
fn film_of(study: &Study) -> Film {
    let film = match &study.signals {
        Some(signals) => signals.film.clone(),
        None => SignalSettings::on(&study.scene).film,
    };
    let [length_mm, width_mm] = study
        .layouts
        .size_mm
        .unwrap_or([film.length_mm, film.width_mm]);
    Film {
        length_mm,
        width_mm,
        ..film
    }
}
