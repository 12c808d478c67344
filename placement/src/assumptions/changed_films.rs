//! Layouts with films of another model in place of the study's own, solved on the layouts' level: glued ones around the wheel.

use fem_client::scene::{Geometry, Level};

use super::changed::Changed;
use crate::layout::solving::layout_fields::MeshFields;
use crate::layout::solving::layout_scenes::LayoutScenes;
use crate::layout::solving::layout_workload::glued_series;
use crate::layout::solving::measuring_layouts::{ScoredLayouts, mesh_answer};
use crate::layout::solving::study_layouts::Asked;
use crate::points::{Place, RunContext, RunError, SceneSeries, outcomes_of_all};
use documents::layouts::layout_settings::{Layouts, farthest_section_deg};
use documents::study::Study;
use layouts::arrangement::{Arrangement, FilmKind, FilmReads, LaidFilm};
use layouts::ranking::asked_layouts::Kinds;

/// Layouts with other films, and where these are felt.
pub(super) struct OtherFilms {
    pub fields: MeshFields,
    /// The layouts in the order in which they were given.
    pub layouts: Vec<Arrangement>,
}

/// Films of some layouts, of another model.
struct Relaid {
    settings: Layouts,
    kinds: Kinds,
    layouts: Vec<Arrangement>,
}

impl Relaid {
    fn new(
        study: &Study,
        change: &Changed,
        (layouts, of): (&[&Arrangement], &[FilmKind]),
    ) -> Option<Self> {
        let Changed::Film(model) = change else {
            return None;
        };
        let settings = study.layouts.with_films(*model, study.film());
        let geometry = &study.scene.geometry;
        let reads = FilmReads::of(&settings);
        let mut kinds = Kinds::of_crown(geometry, settings.size_mm, reads);
        let mut film = |film: &LaidFilm| {
            let own = of[film.kind];
            LaidFilm {
                kind: kinds.laid(own.phi_deg, own.angle_deg),
                ..*film
            }
        };
        let mut relaid = |own: &&Arrangement| Arrangement {
            films: own.films.iter().map(&mut film).collect(),
            ..**own
        };
        let layouts = layouts.iter().map(&mut relaid).collect();
        Some(Self {
            settings,
            kinds,
            layouts,
        })
    }

    /// Whether all films fit in the section, and no two lie on each other.
    fn have_room(&self, geometry: &Geometry) -> bool {
        let farthest = farthest_section_deg(geometry);
        let mut kinds = self.kinds.all().iter();
        let fit = kinds.all(|kind| kind.extent.is_none_or(|extent| extent.fits(farthest)));
        let room = self.settings.room(geometry);
        let places = |own: &Arrangement| {
            let films = own.films.iter();
            films.map(|film| self.kinds.place(film)).collect::<Vec<_>>()
        };
        let crowded = |own: &Arrangement| room.crowded(&places(own)).is_some();
        fit && !self.layouts.iter().any(crowded)
    }

    fn series(&self, scenes: &LayoutScenes, level: Level) -> Vec<SceneSeries> {
        let kinds = self.kinds.all();
        let mut series = vec![scenes.series(level, kinds)];
        series.extend(glued_series(
            self.settings.glued.as_ref(),
            scenes,
            kinds,
            (level, false),
        ));
        series
    }
}

/// All that is expected to be solved for films of another model: those of the first layout, as it isn't known yet which one answers.
pub(super) fn expected_series(
    (study, asked): (&Study, &Asked),
    scenes: &LayoutScenes,
    change: &Changed,
) -> Vec<SceneSeries> {
    let first: Vec<&Arrangement> = asked
        .layouts
        .iter()
        .map(|own| &own.arrangement)
        .take(1)
        .collect();
    let relaid = Relaid::new(study, change, (&first, asked.kinds.all()));
    let level = study.layouts.level_on(study.level);
    relaid.map_or_else(Vec::new, |relaid| relaid.series(scenes, level))
}

/// Solves layouts with films of another model; the place moves behind the points.
///
/// # Errors
/// See [`RunError`]; within, why there are none.
pub(super) fn solved(
    (study, change): (&Study, &Changed),
    (scored, layouts): (&ScoredLayouts, &[&Arrangement]),
    means: &[f64],
    place: &mut Place,
    context: RunContext<'_>,
) -> Result<Result<OtherFilms, String>, RunError> {
    let Some(relaid) = Relaid::new(study, change, (layouts, &scored.kinds)) else {
        return Ok(Err("no film is changed".to_owned()));
    };
    if !relaid.have_room(&study.scene.geometry) {
        return Ok(Err("films of their size have no room".to_owned()));
    }
    let (scenes, level) = (&scored.scenes, scored.level);
    let all = relaid.series(scenes, level);
    place.of = place.first + all.iter().map(|series| series.scenes.len()).sum::<usize>();
    let pressed = outcomes_of_all(&all[..1], means, place, context)?.remove(0);
    let films = (relaid.kinds.all(), relaid.settings.glued.as_ref(), means);
    let answer = mesh_answer((level, false), pressed, scenes, films, place, context)?;
    Ok(answer.map(|answer| OtherFilms {
        fields: answer.fields,
        layouts: relaid.layouts,
    }))
}
