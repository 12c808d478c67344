//! A study's table of responses: the films of its layouts, up to the largest load of its rig.

use fem_client::scene::Film;

use crate::layout::solving::glued::film_angles::FilmAngles;
use crate::layout::solving::study_layouts::Asked;
use crate::points::Place;
use crate::points::RunContext;
use crate::points::RunError;
use crate::points::SceneSeries;
use crate::response_table::bare_film::bare_in_volts;
use crate::response_table::differing_contacts::StudyContacts;
use crate::response_table::laid_films::LaidFilms;
use crate::response_table::table_films::film_loads;
use crate::response_table::table_scenes::TableScenes;
use crate::response_table::table_settings::TableSettings;
use crate::response_table::table_solving::{TestedTable, solve, table_series, tabulated};
use documents::rig::rig_settings::{RigSettings, TireVariant};
use documents::signals::signal_settings::SignalSettings;
use documents::study::Study;
use documents::study::plan::Plan;
use layouts::arrangement::{FilmKind, LaidFilm};
use layouts::ranking::asked_layouts::AskedLayout;
use results::RankedLayout;

/// Tables of a study, and what they are solved for.
pub struct StudyTable {
    scenes: TableScenes,
    /// Other tires that estimators are tried on.
    others: Vec<(TireVariant, TableScenes)>,
    kinds: Vec<FilmKind>,
    film: Film,
    /// Whether it is glued on with its stiffness.
    glued: bool,
    /// Quantities that contacts differ in besides angle, depth and shift; none where they are alike.
    contacts: Option<StudyContacts>,
    /// The study's layouts, whose films name the kinds by number.
    pub layouts: Vec<AskedLayout>,
}

/// Another tire with its table, or why it has none.
pub(crate) type OtherTable = (TireVariant, Result<TestedTable, String>);

impl StudyTable {
    /// Plans the tables of a study with a rig.
    ///
    /// # Errors
    /// Why there is no table.
    pub fn of(study: &Study, rig: &RigSettings, plan: &Plan) -> Result<Self, String> {
        let (film, glued) = (film_of(study), study.layouts.glued.is_some());
        let asked = Asked::of(study);
        let (mut kinds, mut layouts) = (Vec::new(), asked.layouts);
        let mut of_table = Vec::new();
        for laid in layouts
            .iter_mut()
            .flat_map(|layout| &mut layout.arrangement.films)
        {
            let number = laid.kind;
            let kind = asked.kinds.all()[number];
            let kind = match glued {
                true => kind,
                false => bare_in_volts(&kind, &film),
            };
            laid.kind = kinds
                .iter()
                .position(|known| *known == kind)
                .unwrap_or_else(|| {
                    kinds.push(kind);
                    of_table.push(number);
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
            study.level,
        );
        let scenes = TableScenes::new(means, settings);
        scenes.check()?;
        let others = rig.other_tires.iter();
        let others = others.map(|tire| (*tire, scenes.untested(tire)));
        let others: Vec<(TireVariant, TableScenes)> = others.collect();
        for (tire, scenes) in &others {
            let named = |reason| format!("{}: {reason}", tire.described());
            scenes.check().map_err(named)?;
        }
        let contacts = StudyContacts::of(study, means, asked.kinds.all(), of_table)?;
        Ok(Self {
            scenes,
            others,
            contacts,
            kinds,
            film,
            glued,
            layouts,
        })
    }

    /// All that is solved for a study's rig, and what is read of it; nothing without a table.
    pub(crate) fn series_of(study: &Study, plan: &Plan) -> Vec<SceneSeries> {
        let table = study.rig.as_ref().map(|rig| Self::of(study, rig, plan));
        let series = table.and_then(Result::ok);
        series.iter().flat_map(Self::series).collect()
    }

    /// All that is solved, and what is read of it.
    pub(crate) fn series(&self) -> Vec<SceneSeries> {
        let others = self.others.iter().map(|(_, scenes)| scenes);
        let tires = std::iter::once(&self.scenes).chain(others);
        tires.flat_map(|scenes| self.series_on(scenes)).collect()
    }

    fn series_on(&self, scenes: &TableScenes) -> Vec<SceneSeries> {
        let mut series = Vec::from(table_series(scenes, &self.kinds));
        series.extend(self.glued_films(scenes).iter().flat_map(FilmAngles::series));
        series.retain(|series| !series.scenes.is_empty());
        series
    }

    /// The films as they are glued on; none where they follow the wall.
    fn glued_films(&self, scenes: &TableScenes) -> Option<FilmAngles<'_>> {
        let loads = || film_loads(scenes, self.kinds.len());
        self.glued
            .then(|| FilmAngles::new(&self.film, &self.kinds, loads()))
    }

    /// The layout that a row of the result is of; none of those that a search found.
    pub fn asked(&self, ranked: &RankedLayout) -> Option<&AskedLayout> {
        self.layouts
            .iter()
            .find(|layout| ranked.is_same(&layout.label))
    }

    /// Counts the solves of the table itself, those that test it included.
    pub(crate) fn own_solves(&self) -> usize {
        let own = self.series_on(&self.scenes);
        own.iter().map(|series| series.scenes.len()).sum()
    }

    /// Counts the solves of that and of the other tires' tables.
    pub fn solves(&self) -> usize {
        self.series().iter().map(|series| series.scenes.len()).sum()
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

    /// Solves the tables with points that have ordinals from `first` on.
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
        let (kinds, mut tested) = match self.table_on(&self.scenes, plan, &mut place, context)? {
            Ok(found) => found,
            Err(reason) => return Ok(Err(reason)),
        };
        if let Some(contacts) = &self.contacts {
            let mut place = Place {
                first: place.of,
                ..place
            };
            let means = &plan.values()[0];
            match contacts.solved(&kinds, means, &mut place, context)? {
                Ok(differing) => tested.differing = Some(differing),
                Err(reason) => return Ok(Err(reason)),
            }
        }
        Ok(Ok(tested))
    }

    /// The tables of the other tires, solved after the own one's, and in what they differ from it.
    ///
    /// # Errors
    /// See [`RunError`]; within, why there is no table.
    pub(crate) fn others_solved_from(
        &self,
        first: usize,
        plan: &Plan,
        context: RunContext<'_>,
    ) -> Result<Vec<OtherTable>, RunError> {
        let mut place = Place {
            first: first + self.own_solves(),
            of: first + self.solves(),
        };
        let mut tables = Vec::new();
        for (tire, scenes) in &self.others {
            let table = self.table_on(scenes, plan, &mut place, context)?;
            tables.push((*tire, table.map(|(_, tested)| tested)));
        }
        Ok(tables)
    }

    /// Kinds of film, in volts, and their table.
    fn table_on(
        &self,
        scenes: &TableScenes,
        plan: &Plan,
        place: &mut Place,
        context: RunContext<'_>,
    ) -> Result<Result<(Vec<FilmKind>, TestedTable), String>, RunError> {
        let means = &plan.values()[0];
        let solved = match solve(scenes, &self.kinds, means, place, context)? {
            Ok(solved) => solved,
            Err(reason) => return Ok(Err(reason)),
        };
        let Some(films) = self.glued_films(scenes) else {
            let kinds = self.kinds.clone();
            return Ok(tabulated(scenes, &kinds, &solved).map(|tested| (kinds, tested)));
        };
        let answers = films.solve(means, place, context)?;
        Ok(answers.and_then(|answers| {
            let kinds = films.in_volts(&answers)?;
            let mut tested = tabulated(scenes, &kinds, &solved)?;
            let loads = scenes.settings().film_loads_n();
            let depth = |load_n: &f64| tested.table.depth_of_load_mm(*load_n);
            let depths: Vec<f64> = loads.iter().map(depth).collect();
            let (_, report) = films.put(&answers, (&kinds, &depths), &mut tested.table)?;
            tested.films = Some(report);
            Ok((kinds, tested))
        }))
    }

    /// The films of a layout, as a rig asks for them.
    pub fn laid<'t>(&self, tested: &'t TestedTable, films: &[LaidFilm]) -> LaidFilms<'t> {
        LaidFilms::new(&tested.table, &self.film, films).under(tested.differing.as_ref())
    }
}

/// The layouts' glued film, or that of the signals; where the study asks for none that of the scene, or a common one; of the layouts' size.
fn film_of(study: &Study) -> Film {
    let film = match (&study.layouts.glued, &study.signals) {
        (Some(glued), _) => return glued.film.clone(),
        (None, Some(signals)) => signals.film.clone(),
        (None, None) => SignalSettings::on(&study.scene).film,
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
