//! Reads what films layouts have: glued or bare, how large, and whether they fit where they are laid.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Choice;
use document::fault::{Fault, entry, member};
use document::fields::{Fields, number, shown};
use fem_client::scene::{Film, Geometry, Scene};
use serde_json::Value;

use crate::layouts::film_extent::FilmExtent;
use crate::layouts::layout_bounds::{MOST_SIZES, SIDE};
use crate::layouts::layout_settings::{GluedFilm, Layouts, direction_name, farthest_section_deg};
use crate::parts::directions::Directions;
use crate::parts::film_model::FilmModel;
use document::typed::lists::distinct_list as list;

/// The film of a study: that of its signals or its scene, else the common one.
pub(crate) struct StudyFilm {
    pub film: Film,
    /// Whether the document has one.
    pub is_named: bool,
}

/// Reads how films are modelled and their sizes into their places, where they are given. `film` is the one that is glued on; it isn't known where the scene or the
/// signals have faults.
pub(crate) fn read_films(
    fields: &Fields<'_>,
    layouts: &mut Layouts,
    film: Option<&StudyFilm>,
    faults: &mut Vec<Fault>,
) {
    layouts.size_mm = fields
        .get("size_mm")
        .and_then(|(value, at)| size(value, &at, faults));
    let usual = usual_model(fields, layouts, film);
    match fields.choice("film", FilmModel::CHOICES, usual, faults) {
        Some(FilmModel::Bare) if fields.get("noise_v").is_some() => {
            let detail = "is of glued films, film = \"coupled\" or \"transfer\"; bare ones have noise_strain or noise_share";
            Fault::add(faults, &fields.at("noise_v"), detail);
        }
        None | Some(FilmModel::Bare) => {}
        Some(model) => {
            let film = film.map(|of_study| &of_study.film);
            glue(film, model == FilmModel::Coupled, fields, layouts, faults);
        }
    }
    if let Some((value, at)) = fields.get("candidate_sizes_mm") {
        layouts.candidate_sizes_mm = list(value, &at, MOST_SIZES, faults, size).unwrap_or_default();
    }
}

/// Model of films where none is named: those of a study that has a film are glued on, unless the table says what only bare ones have.
fn usual_model(fields: &Fields<'_>, layouts: &Layouts, film: Option<&StudyFilm>) -> FilmModel {
    let Some(StudyFilm {
        film,
        is_named: true,
    }) = film
    else {
        return FilmModel::Bare;
    };
    let has = |name: &str| fields.get(name).is_some();
    let own_size = [film.length_mm, film.width_mm];
    let is_bare = has("noise_strain")
        || has("candidate_sizes_mm")
        || layouts.size_mm.is_some_and(|size| size != own_size);
    match is_bare || !layouts.is_asked() {
        true => FilmModel::Bare,
        false => FilmModel::Coupled,
    }
}

/// Has layouts of this film, whose size it is.
fn glue(
    film: Option<&Film>,
    is_coupled: bool,
    fields: &Fields<'_>,
    layouts: &mut Layouts,
    faults: &mut Vec<Fault>,
) {
    let of_bare_films = [
        (
            "noise_strain",
            "is of bare films; glued ones have noise_v, in volts, or noise_share",
        ),
        (
            "candidate_sizes_mm",
            "is of bare films: a glued film of another size has another transfer",
        ),
    ];
    for (name, detail) in of_bare_films {
        if fields.get(name).is_some() {
            Fault::add(faults, &fields.at(name), detail);
        }
    }
    let Some(film) = film else {
        return;
    };
    let [length, width] = [film.length_mm, film.width_mm];
    if layouts.size_mm.is_some_and(|size| size != [length, width]) {
        let detail = format!(
            "must be that of the glued film, {length} x {width} mm, which signals.film or the scene's film says; leave it out"
        );
        Fault::add(faults, &fields.at("size_mm"), detail);
    }
    layouts.size_mm = Some([length, width]);
    layouts.glued = Some(GluedFilm {
        film: film.clone(),
        is_coupled,
    });
}

/// Whether a glued film is one that this tire's scene can have.
pub(crate) fn check_film(
    layouts: &Layouts,
    fields: &Fields<'_>,
    scene: &Scene,
    faults: &mut Vec<Fault>,
) {
    let glued = Scene {
        film: layouts.glued.as_ref().map(|glued| glued.film.clone()),
        ..scene.clone()
    };
    let Err(found) = Scene::from_json(&glued.canonical_json()) else {
        return;
    };
    if let Some(fault) = found
        .iter()
        .find(|fault| fault.pointer.starts_with("/film"))
    {
        let detail = format!("the film doesn't fit: {}", fault.detail);
        Fault::add(faults, &fields.at("film"), detail);
    }
}

/// Whether the film of a changed assumption is one that this tire's scene can have; which layouts have room for it shows when they are known.
pub(crate) fn check_other_film(
    layouts: &Layouts,
    fields: &Fields<'_>,
    (scene, film): (&Scene, Option<&StudyFilm>),
    faults: &mut Vec<Fault>,
) {
    let (Some(model), Some(of_study)) = (layouts.assumptions.film, film) else {
        return;
    };
    let mut found = Vec::new();
    let other = layouts.with_films(model, of_study.film.clone());
    check_film(&other, fields, scene, &mut found);
    if let Some(fault) = found.first() {
        let at = member(&fields.at("assumptions"), "film");
        Fault::add(faults, &at, &fault.detail);
    }
}

/// Length and width, mm.
fn size(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<[f64; 2]> {
    let Some([length, width]) = value.as_array().map(Vec::as_slice) else {
        let detail = format!("must be a length and a width in mm; it is {}", shown(value));
        Fault::add(faults, pointer, detail);
        return None;
    };
    let length = number(length, &entry(pointer, 0), SIDE, faults);
    let width = number(width, &entry(pointer, 1), SIDE, faults);
    Some([length?, width?])
}

/// A film that layouts lay: where in the section, along which direction, and who says so.
struct Laid {
    pointer: String,
    phi_deg: f64,
    angle_deg: f64,
}

/// Whether films of that size fit wherever they are laid, and further sizes at least somewhere. A place is named once, with the first direction that doesn't fit.
pub(crate) fn check_sizes(
    layouts: &Layouts,
    fields: &Fields<'_>,
    geometry: &Geometry,
    directions: Directions,
    faults: &mut Vec<Fault>,
) {
    let farthest = farthest_section_deg(geometry);
    if let Some(size) = layouts.size_mm {
        let mut named: Vec<String> = Vec::new();
        for laid in laid(layouts, fields, directions) {
            let extent = FilmExtent::on(geometry, size, laid.phi_deg, laid.angle_deg);
            if !extent.fits(farthest) && !named.contains(&laid.pointer) {
                Fault::add(faults, &laid.pointer, misfit(&extent, &laid, farthest));
                named.push(laid.pointer);
            }
        }
    }
    for (i, size) in layouts.candidate_sizes_mm.iter().enumerate() {
        let fits = |angle| FilmExtent::on(geometry, *size, 0.0, angle).fits(farthest);
        if ![0.0, 90.0].into_iter().any(fits) {
            let detail = format!(
                "fits nowhere on this tire: at the crown a film may cover {farthest:.1} degrees of the section to each side, a wall's thickness off the bead"
            );
            Fault::add(faults, &entry(&fields.at("candidate_sizes_mm"), i), detail);
        }
    }
}

fn misfit(extent: &FilmExtent, laid: &Laid, farthest: f64) -> String {
    let [length, width] = extent.size_mm();
    let film = format!(
        "a film of {length} x {width} mm along {} at {} degrees",
        direction_name(laid.angle_deg),
        laid.phi_deg
    );
    if extent.farthest_deg() > farthest {
        format!(
            "{film} reaches to {:.1} degrees from the crown; the farthest are {farthest:.1}, a wall's thickness off the bead",
            extent.farthest_deg()
        )
    } else {
        format!("{film} reaches around the whole wheel")
    }
}

/// Every film that layouts and the search lay.
fn laid(layouts: &Layouts, fields: &Fields<'_>, directions: Directions) -> Vec<Laid> {
    let mut all = Vec::new();
    // What a list doesn't say is the fault of what gives the size.
    let size = match fields.get("size_mm") {
        Some((_, size)) => size,
        None => fields.at("film"),
    };
    let list_of = |name: &str, i: usize| match fields.get(name) {
        Some((_, list)) => entry(&list, i),
        None => size.clone(),
    };
    if layouts.glued.is_some() {
        // The crown's signals set the noise.
        all.extend(in_directions(&size, 0.0, vec![0.0, 90.0]));
    }
    if !layouts.unit_counts().is_empty() {
        let positions = layouts
            .positions
            .iter()
            .map(|position| position.angle_deg());
        let positions = positions
            .enumerate()
            .map(|(i, phi)| (list_of("positions", i), phi));
        let sections = layouts.section_deg.iter().enumerate();
        let sections = sections.map(|(i, phi)| (list_of("section_deg", i), *phi));
        for (pointer, phi_deg) in positions.chain(sections) {
            all.extend(in_directions(
                &pointer,
                phi_deg,
                layouts.sets(directions).concat(),
            ));
        }
    }
    for (i, layout) in layouts.free.iter().enumerate() {
        let films = member(&list_of("free", i), "films");
        all.extend(layout.films.iter().enumerate().map(|(j, film)| Laid {
            pointer: entry(&films, j),
            phi_deg: film.phi_deg,
            angle_deg: film.angle_deg,
        }));
    }
    if let Some(search) = &layouts.search {
        let table = fields.at("search");
        for (i, phi_deg) in search.section_deg.iter().enumerate() {
            let given = fields
                .get("search")
                .is_some_and(|(search, _)| search.get("section_deg").is_some());
            let pointer = match given {
                true => entry(&member(&table, "section_deg"), i),
                false => table.clone(),
            };
            all.extend(in_directions(&pointer, *phi_deg, search.directions.clone()));
        }
    }
    all
}

fn in_directions(pointer: &str, phi_deg: f64, directions: Vec<f64>) -> impl Iterator<Item = Laid> {
    directions.into_iter().map(move |angle_deg| Laid {
        pointer: pointer.to_owned(),
        phi_deg,
        angle_deg,
    })
}
