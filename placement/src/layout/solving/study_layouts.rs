//! Layouts, kinds of film and places of the search, as a study's document asks for them.

use documents::layouts::layout_settings::farthest_section_deg;
use documents::study::Study;
use layouts::arrangement::FilmReads;
use layouts::ranking::asked_layouts::{AskedLayout, Kinds, asked_layouts, search_films};
use layouts::search::search_films::SearchFilms;

/// Layouts, kinds of film and places of the search, as a document asks for them.
#[derive(Clone)]
pub(crate) struct Asked {
    pub kinds: Kinds,
    pub layouts: Vec<AskedLayout>,
    /// Layouts of the menu whose films have no room.
    pub without_room: usize,
    pub candidates: Vec<usize>,
    pub places: SearchFilms,
}

impl Asked {
    pub fn of(study: &Study) -> Self {
        let geometry = &study.scene.geometry;
        let mut kinds = Kinds::of_crown(
            geometry,
            study.layouts.size_mm,
            FilmReads::of(&study.layouts),
        );
        let (layouts, without_room) = asked_layouts(&study.layouts, study.directions, &mut kinds);
        let search = study.layouts.search.as_ref();
        let places = search.map_or_else(SearchFilms::none, |search| {
            search_films(search, &study.layouts.search_limits(), &mut kinds)
        });
        let farthest = farthest_section_deg(geometry);
        Self {
            candidates: kinds.candidates(farthest, &study.layouts.candidate_sizes_mm),
            kinds,
            layouts,
            without_room,
            places,
        }
    }

    /// Films of its largest layout.
    pub fn most_films(&self) -> usize {
        let films = self.layouts.iter();
        let films = films.map(|layout| layout.arrangement.films.len());
        films.max().unwrap_or(0)
    }
}
