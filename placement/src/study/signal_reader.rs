//! Reads what a study asks of films' signals: the table `signals`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use fem_client::document::fault::{Fault, entry, member};
use fem_client::document::fields::{Fields, Range, choice, number, shown};
use fem_client::scene::{Film, Scene};
use fem_client::solver::direction::Direction;
use serde_json::{Map, Value};

use crate::result::FilmModel;
use crate::signals::signal_settings::{FurtherTire, OWN_TIRE, OwnLoads, PLACED, SignalSettings};
use crate::study::POSITIONS;
use crate::study::candidate_reader::list;
use crate::study::input_reader::read_name;
use crate::study::scene_reader::{Resolve, scene};

/// Most loads, pressures or contact angles.
const MOST_VALUES: usize = 64;
const MOST_TIRES: usize = 16;
const LONGEST_TIRE: usize = 40;
const CONTACT: Range = Range::new(-180.0, 180.0, "degrees");

/// The signals; Some(None) where the study asks for none. Without a scene, whose faults are known already, the film isn't read.
pub(crate) fn signals(
    fields: &Fields<'_>,
    own: Option<&Scene>,
    resolve: Resolve<'_>,
    faults: &mut Vec<Fault>,
) -> Option<Option<SignalSettings>> {
    let Some((value, pointer)) = fields.get("signals") else {
        return Some(None);
    };
    let known = [
        "loads_n",
        "pressures_mpa",
        "at_load_n",
        "contact_load_n",
        "contact_deg",
        "positions",
        "directions",
        "films",
        "film",
        "tires",
    ];
    let fields = Fields::open(value, &pointer, &known, faults)?;
    let before = faults.len();
    let mut read = own.map_or_else(|| SignalSettings::on(&Scene::default()), SignalSettings::on);
    values(&fields, "loads_n", &mut read.loads_n, faults, load);
    values(
        &fields,
        "pressures_mpa",
        &mut read.pressures_mpa,
        faults,
        pressure,
    );
    for (name, place) in [
        ("at_load_n", &mut read.at_load_n),
        ("contact_load_n", &mut read.contact_load_n),
    ] {
        if let Some((value, at)) = fields.get(name) {
            *place = load(value, &at, faults).unwrap_or(*place);
        }
    }
    values(
        &fields,
        "contact_deg",
        &mut read.contact_deg,
        faults,
        |value, at, faults| number(value, at, CONTACT, faults),
    );
    values(
        &fields,
        "positions",
        &mut read.positions,
        faults,
        |value, at, faults| choice(value, at, &POSITIONS, faults),
    );
    let directions = Direction::ALL.map(|direction| (direction.as_str(), direction));
    values(
        &fields,
        "directions",
        &mut read.directions,
        faults,
        |value, at, faults| choice(value, at, &directions, faults),
    );
    let films = FilmModel::ALL.map(|film| (film.as_str(), film));
    values(
        &fields,
        "films",
        &mut read.films,
        faults,
        |value, at, faults| choice(value, at, &films, faults),
    );
    if let Some((value, at)) = fields.get("tires") {
        let tire = |value: &Value, at: &str, faults: &mut Vec<Fault>| {
            further_tire(value, at, resolve, faults)
        };
        read.tires = list(value, &at, MOST_TIRES, faults, tire).unwrap_or_default();
        check_names(&read.tires, &at, faults);
    }
    if let Some(own) = own {
        read.film = film(&fields, &pointer, own, read.film, faults)?;
        if faults.len() == before {
            check_places(&read, own, &pointer, faults);
        }
    }
    (faults.len() == before).then_some(Some(read))
}

/// Reads a list of 1 to [`MOST_VALUES`] entries that differ into its place, where it is given.
fn values<T: PartialEq>(
    fields: &Fields<'_>,
    name: &str,
    place: &mut Vec<T>,
    faults: &mut Vec<Fault>,
    read: impl Fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) {
    let Some((value, pointer)) = fields.get(name) else {
        return;
    };
    match list(value, &pointer, MOST_VALUES, faults, read) {
        Some(items) if items.is_empty() => {
            let detail = format!("must have 1 to {MOST_VALUES} entries; it is empty");
            Fault::add(faults, &pointer, detail);
        }
        Some(items) => *place = items,
        None => {}
    }
}

fn load(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<f64> {
    of_scene("ground.load_n", value, pointer, faults)
}

fn pressure(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<f64> {
    of_scene("pressure.internal_mpa", value, pointer, faults)
}

/// Reads a number as a scene reads the field at this path.
pub(crate) fn of_scene(
    path: &str,
    value: &Value,
    pointer: &str,
    faults: &mut Vec<Fault>,
) -> Option<f64> {
    let mut scene = Scene::default();
    let read = scene.set(path, value).and_then(|()| scene.number_at(path));
    read.inspect_err(|fault| Fault::add(faults, pointer, fault.detail.clone()))
        .ok()
}

fn further_tire(
    value: &Value,
    pointer: &str,
    resolve: Resolve<'_>,
    faults: &mut Vec<Fault>,
) -> Option<FurtherTire> {
    let known = [
        "name",
        "scene",
        "loads_n",
        "pressures_mpa",
        "at_load_n",
        "contact_load_n",
    ];
    let fields = Fields::open(value, pointer, &known, faults)?;
    let name = read_name(&fields, "name", LONGEST_TIRE, faults);
    let scene = scene(&fields, resolve, faults);
    let mut own_values = |name, read: ReadNumber| {
        let (mut list, given) = (Vec::new(), fields.get(name).is_some());
        values(&fields, name, &mut list, faults, read);
        given.then_some(list)
    };
    let loads_n = own_values("loads_n", load);
    let pressures_mpa = own_values("pressures_mpa", pressure);
    let mut own_load = |name| {
        let (value, at) = fields.get(name)?;
        load(value, &at, faults)
    };
    let (at_load_n, contact_load_n) = (own_load("at_load_n"), own_load("contact_load_n"));
    Some(FurtherTire {
        name: name?,
        scene: scene?,
        own: OwnLoads {
            loads_n,
            pressures_mpa,
            at_load_n,
            contact_load_n,
        },
    })
}

type ReadNumber = fn(&Value, &str, &mut Vec<Fault>) -> Option<f64>;

fn check_names(tires: &[FurtherTire], pointer: &str, faults: &mut Vec<Fault>) {
    for (i, tire) in tires.iter().enumerate() {
        let at = || member(&entry(pointer, i), "name");
        if tire.name == OWN_TIRE {
            let detail = format!("is the study's own tire, which is called \"{OWN_TIRE}\"");
            Fault::add(faults, &at(), detail);
        }
        if tires.iter().take(i).any(|other| other.name == tire.name) {
            Fault::add(faults, &at(), "is another tire's name");
        }
    }
}

/// The film's table, read as that of the scene with which it begins: at the crown, along the circumference.
fn film(
    fields: &Fields<'_>,
    signals: &str,
    own: &Scene,
    default: Film,
    faults: &mut Vec<Fault>,
) -> Option<Film> {
    let Some((value, pointer)) = fields.get("film") else {
        return Some(default);
    };
    let Value::Object(table) = value else {
        let detail = format!("must be a table as a scene's film; it is {}", shown(value));
        Fault::add(faults, &pointer, detail);
        return None;
    };
    let mut table = table.clone();
    for name in PLACED {
        if table.shift_remove(name).is_some() {
            let detail = "is for signals to say, which places the film by positions, directions and contact_deg";
            Fault::add(faults, &member(&pointer, name), detail);
        }
    }
    with_film(own, Value::Object(table), signals, faults)?.film
}

/// A scene with this film in place of its own.
fn with_film(scene: &Scene, film: Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Scene> {
    let mut bare = scene.clone();
    bare.film = None;
    let overrides = Map::from_iter([("film".to_owned(), film)]);
    bare.overlaid(&overrides, pointer, faults)
}

/// Whether the film fits at every position of every tire.
fn check_places(settings: &SignalSettings, own: &Scene, pointer: &str, faults: &mut Vec<Fault>) {
    let tires = settings.tires.iter().enumerate();
    let further = tires.map(|(i, tire)| (Some(i), &tire.scene));
    for (tire, scene) in std::iter::once((None, own)).chain(further) {
        for (i, position) in settings.positions.iter().enumerate() {
            for direction in &settings.directions {
                let film = settings.placed(*position, *direction, 0.0);
                let mut found = Vec::new();
                with_film(scene, serde_json::json!(film), "", &mut found);
                let Some(fault) = found.first() else {
                    continue;
                };
                let at = match (tire, fault.pointer.as_str()) {
                    (Some(tire), _) => member(&entry(&member(pointer, "tires"), tire), "scene"),
                    (None, "/film/phi_deg") => entry(&member(pointer, "positions"), i),
                    (None, of_film) => format!("{pointer}{of_film}"),
                };
                if faults.iter().all(|fault| fault.pointer != at) {
                    let detail = format!("the film doesn't fit there: {}", fault.detail);
                    Fault::add(faults, &at, detail);
                }
            }
        }
    }
}
