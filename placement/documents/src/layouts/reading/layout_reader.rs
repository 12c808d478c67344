//! Reads the layouts that a study asks for: the table `layouts`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Choice;
use document::fault::Fault;
use document::fields::{Fields, integer, number, shown};
use document::typed::field_value::Field;
use fem_client::scene::{Level, Scene};
use fem_client::solver::Position;
use serde_json::Value;

use crate::layouts::film_place_reader::{direction, entries, film, section};
use crate::layouts::layout_bounds::{
    GAIN, LONGEST_LAYOUT, MOST_ENTRIES, MOST_FILMS, MOST_FREE, MOST_LAYOUTS, MOST_LOADS,
    MOST_UNITS, PLACE, SHARE, SPACING, STRAIN, VOLTS,
};
use crate::layouts::layout_settings::{
    FreeLayout, LayoutLoads, Layouts, NoiseFloor, NoiseSettings,
};
use crate::layouts::reading::assumption_reader::assumptions;
use crate::layouts::reading::contact_reader::{check_contacts, contacts};
use crate::layouts::reading::film_size_reader::{
    StudyFilm, check_film, check_other_film, check_sizes, read_films,
};
use crate::layouts::reading::limits_reader::gluing_limits;
use crate::layouts::reading::overlap_check::check_overlaps;
use crate::layouts::reading::search_reader::{check_places, search};
use crate::layouts::reading::usual_contact::check_usual;
use crate::parts::directions::Directions;
use crate::parts::scene_number::of_scene;
use document::typed::field_value::read_name;
use document::typed::lists::distinct_list as list;

/// The layouts to score: none without the table, the common ones where it names none. Section angles and sizes are checked against the scene, where it is
/// known; films lie in the directions that the study asks for, where the table names none. `film` is the one that is glued on.
pub(crate) fn layouts(
    fields: &Fields<'_>,
    scene: Option<&Scene>,
    directions: Directions,
    film: Option<&StudyFilm>,
    faults: &mut Vec<Fault>,
) -> Option<Layouts> {
    let Some((value, pointer)) = fields.get("layouts") else {
        return Some(Layouts::none());
    };
    let mut layouts = Layouts::default();
    let known = [
        "films",
        "spacings_deg",
        "units",
        "positions",
        "section_deg",
        "directions",
        "staggered",
        "free",
        "taken",
        "forbidden_deg",
        "least_distance_mm",
        "film",
        "size_mm",
        "candidate_sizes_mm",
        "depths_mm",
        "loads_n",
        "noise_share",
        "noise_strain",
        "noise_v",
        "gain_std",
        "place_std_deg",
        "dead",
        "shear",
        "contacts",
        "assumptions",
        "level",
        "search",
    ];
    let fields = Fields::open(value, &pointer, &known, faults)?;
    let before = faults.len();
    let has = |name: &str| fields.get(name).is_some();
    // Who names layouts doesn't mean the common menu, too.
    if ["spacings_deg", "units", "free", "search"]
        .into_iter()
        .any(has)
    {
        layouts.films.clear();
    }
    if has("section_deg") {
        layouts.positions.clear();
    }
    let section =
        |value: &Value, at: &str, faults: &mut Vec<Fault>| section(value, at, scene, faults);
    entries(
        &fields,
        "films",
        &mut layouts.films,
        MOST_ENTRIES,
        faults,
        |value, at, faults| {
            integer(value, at, 1, MOST_FILMS as u64, faults).map(|films| films as usize)
        },
    );
    entries(
        &fields,
        "spacings_deg",
        &mut layouts.spacings_deg,
        MOST_ENTRIES,
        faults,
        spacing,
    );
    entries(
        &fields,
        "units",
        &mut layouts.units,
        MOST_ENTRIES,
        faults,
        |value, at, faults| integer(value, at, 1, MOST_UNITS, faults).map(|units| units as usize),
    );
    entries(
        &fields,
        "positions",
        &mut layouts.positions,
        Position::ALL.len(),
        faults,
        |value, at, faults| Position::read(value, at, &(), faults),
    );
    entries(
        &fields,
        "section_deg",
        &mut layouts.section_deg,
        MOST_ENTRIES,
        faults,
        section,
    );
    entries(
        &fields,
        "directions",
        &mut layouts.directions,
        MOST_ENTRIES,
        faults,
        set,
    );
    layouts.staggered = flag(&fields, "staggered", faults);
    layouts.dead = flag(&fields, "dead", faults);
    layouts.shear = flag(&fields, "shear", faults);
    if layouts.shear && scene.is_some_and(|scene| scene.contact.friction == 0.0) {
        let detail = "needs ground that takes the tread along: the scene's contact.friction above 0; it is 0";
        Fault::add(faults, &fields.at("shear"), detail);
    }
    if let Some(scene) = scene.filter(|_| layouts.shear) {
        check_usual(scene, &fields.at("shear"), "is", faults);
    }
    layouts.contacts = contacts(&fields, faults);
    layouts.assumptions = assumptions(&fields, faults);
    let free =
        |value: &Value, at: &str, faults: &mut Vec<Fault>| free_layout(value, at, scene, faults);
    if let Some((value, at)) = fields.get("free") {
        layouts.free = list(value, &at, MOST_FREE, faults, free).unwrap_or_default();
    }
    layouts.loads = loads(&fields, faults);
    layouts.noise = noise(&fields, faults);
    check_contacts(&layouts, &fields, scene, faults);
    if has("level") {
        layouts.level = fields.choice("level", Level::CHOICES, Level::Coarse, faults);
    }
    layouts.limits = gluing_limits(&fields, "taken", scene, faults);
    layouts.search = search(&fields, scene, faults);
    check_places(&layouts, &fields, faults);
    check_count(&layouts, directions, &pointer, faults);
    read_films(&fields, &mut layouts, film, faults);
    if let Some(scene) = scene.filter(|_| faults.len() == before) {
        check_film(&layouts, &fields, scene, faults);
        let geometry = &scene.geometry;
        check_sizes(&layouts, &fields, geometry, directions, faults);
        check_other_film(&layouts, &fields, (scene, film), faults);
        if faults.len() == before {
            check_overlaps(&layouts, &fields, geometry, directions, faults);
        }
    }
    (faults.len() == before).then_some(layouts)
}

fn flag(fields: &Fields<'_>, name: &str, faults: &mut Vec<Fault>) -> bool {
    let Some((value, pointer)) = fields.get(name) else {
        return false;
    };
    value.as_bool().unwrap_or_else(|| {
        Fault::add(
            faults,
            &pointer,
            format!("must be true or false; it is {}", shown(value)),
        );
        false
    })
}

fn spacing(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<f64> {
    let spacing = number(value, pointer, SPACING, faults)?;
    let units = 360.0 / spacing;
    // A spacing such as 51.428571428571 for sevenths of a turn is meant to divide it.
    if (units - units.round()).abs() > 1e-9 * units {
        let detail = format!("must divide 360 degrees into whole units; {spacing} gives {units}");
        Fault::add(faults, pointer, detail);
        return None;
    }
    Some(360.0 / units.round())
}

fn set(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Vec<f64>> {
    let directions = list(value, pointer, 4, faults, direction)?;
    if directions.is_empty() {
        Fault::add(faults, pointer, "must name a direction; it is empty");
        return None;
    }
    Some(directions)
}

fn free_layout(
    value: &Value,
    pointer: &str,
    scene: Option<&Scene>,
    faults: &mut Vec<Fault>,
) -> Option<FreeLayout> {
    let fields = Fields::open(value, pointer, &["name", "films"], faults)?;
    let name = read_name(&fields, "name", LONGEST_LAYOUT, faults);
    let (value, at) = fields.required("films", "a list of films", faults)?;
    let films = list(value, &at, MOST_FILMS, faults, |value, at, faults| {
        film(value, at, scene, faults)
    })?;
    if films.is_empty() {
        Fault::add(faults, &at, "must list a film; it is empty");
        return None;
    }
    Some(FreeLayout { name: name?, films })
}

fn loads(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> LayoutLoads {
    let read = |name: &str, path: &str, faults: &mut Vec<Fault>| -> Option<Vec<f64>> {
        let (value, pointer) = fields.get(name)?;
        let of_scene =
            |value: &Value, at: &str, faults: &mut Vec<Fault>| positive(path, value, at, faults);
        let items = list(value, &pointer, MOST_LOADS, faults, of_scene)?;
        if items.is_empty() {
            Fault::add(
                faults,
                &pointer,
                format!("must have 1 to {MOST_LOADS} entries; it is empty"),
            );
        }
        Some(items)
    };
    let depths = read("depths_mm", "ground.depths_mm[0]", faults);
    let forces = read("loads_n", "ground.load_n", faults);
    if fields.get("depths_mm").is_some() && fields.get("loads_n").is_some() {
        let detail = "and depths_mm are two ways to say the same: give one of them";
        Fault::add(faults, &fields.at("loads_n"), detail);
    }
    match (depths, forces) {
        (Some(depths), _) => LayoutLoads::Depths(depths),
        (None, Some(forces)) => LayoutLoads::Forces(forces),
        (None, None) => LayoutLoads::Mean,
    }
}

/// A number as a scene reads the field at this path, above zero.
fn positive(path: &str, value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<f64> {
    let read = of_scene(path, value, pointer, faults)?;
    if read <= 0.0 {
        Fault::add(
            faults,
            pointer,
            format!("must be above 0: nothing is felt of an unpressed tire; it is {read}"),
        );
        return None;
    }
    Some(read)
}

fn noise(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> NoiseSettings {
    let mut noise = NoiseSettings::default();
    let share = fields
        .get("noise_share")
        .map(|(value, at)| number(value, &at, SHARE, faults));
    let strain = fields
        .get("noise_strain")
        .map(|(value, at)| number(value, &at, STRAIN, faults));
    let volts = fields
        .get("noise_v")
        .map(|(value, at)| number(value, &at, VOLTS, faults));
    for (name, given) in [("noise_strain", strain), ("noise_v", volts)] {
        if given.is_some() && share.is_some() {
            let detail = "and noise_share are two ways to say the same: give one of them";
            Fault::add(faults, &fields.at(name), detail);
        }
    }
    match (share.flatten(), strain.flatten(), volts.flatten()) {
        (Some(share), ..) => noise.floor = NoiseFloor::Share(share),
        (_, Some(strain), _) => noise.floor = NoiseFloor::Strain(strain),
        (.., Some(volts)) => noise.floor = NoiseFloor::Volts(volts),
        _ => {}
    }
    let numbers = [
        ("gain_std", GAIN, &mut noise.gain_std),
        ("place_std_deg", PLACE, &mut noise.place_std_deg),
    ];
    // Faults are in the list; the numbers stay as they are then.
    let _ = fields.numbers(numbers, faults);
    noise
}

fn check_count(layouts: &Layouts, directions: Directions, pointer: &str, faults: &mut Vec<Fault>) {
    let count = layouts.rings(directions).len();
    if count > MOST_LAYOUTS {
        let detail = format!(
            "numbers of films or units, section angles and sets of directions make {count} layouts; a study scores at most {MOST_LAYOUTS}"
        );
        Fault::add(faults, pointer, detail);
    }
}
