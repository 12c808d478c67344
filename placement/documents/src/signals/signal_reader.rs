//! Reads what a study asks of films' signals: the table `signals`.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Table;
use document::fault::{Fault, entry, member};
use document::fields::{Fields, Range, choice, number, shown};
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use document::typed::table_fields::table_value;
use fem_client::scene::{Film, LOAD, PRESSURE, Scene};
use fem_client::solver::Position;
use fem_client::solver::direction::Direction;
use serde_json::{Map, Value, json};

use crate::parts::film_model::FilmModel;
use crate::parts::scene_number::of_scene;
use crate::parts::scene_reader::{Resolve, scene, scene_schema};
use crate::signals::signal_settings::{FurtherTire, OWN_TIRE, OwnLoads, PLACED, SignalSettings};
use document::typed::field_value::read_name;
use document::typed::lists::distinct_list as list;

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
        |value, at, faults| Position::read(value, at, &(), faults),
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

/// The schema of `signals`.
pub(crate) fn signals_schema(schemas: &mut Schemas) -> Value {
    schemas.define("Signals", |schemas| {
        let usual = SignalSettings::on(&Scene::default());
        let mut signals = Properties::default();
        let own = [
            usual.loads_n.write(),
            usual.pressures_mpa.write(),
            usual.at_load_n.write(),
            usual.contact_load_n.write(),
        ];
        describe_loads(&mut signals, own, schemas);
        let mut add = |name, doc, schema, default| signals.add(name, doc, schema, default, false);
        let doc = "Wheel angles from a film to the contact, degrees.";
        let angles = several(f64::schema(&CONTACT, schemas));
        add("contact_deg", doc, angles, usual.contact_deg.write());
        let positions = several(Position::schema(&(), schemas));
        add(
            "positions",
            "Places of the films in the section.",
            positions,
            usual.positions.write(),
        );
        let directions = several(Direction::schema(&(), schemas));
        let doc = "Directions along which the films' length lies.";
        add("directions", doc, directions, usual.directions.write());
        let films = several(FilmModel::schema(&(), schemas));
        add("films", "Models of the films.", films, usual.films.write());
        let film = unplaced_film(schemas);
        let doc = "The film, as a scene's; the scene's own, or a thin one, when left out.";
        add("film", doc, film, None);
        let tires = further_tire_schema(schemas);
        let tires = json!({"type": "array", "maxItems": MOST_TIRES, "items": tires});
        add(
            "tires",
            "Further tires beside the study's own.",
            tires,
            None,
        );
        signals.table("Films' signals over loads, pressures and contact angles.")
    })
}

/// Loads and pressures, with their defaults.
fn describe_loads(
    table: &mut Properties,
    [loads, pressures, at_load, contact_load]: [Option<Value>; 4],
    schemas: &mut Schemas,
) {
    let mut add = |name, doc, schema, default| table.add(name, doc, schema, default, false);
    let load = f64::schema(&LOAD, schemas);
    let doc = "Loads at the tire's own pressure, N.";
    add("loads_n", doc, several(load.clone()), loads);
    let doc = "Internal pressures, MPa.";
    add("pressures_mpa", doc, several(PRESSURE.schema()), pressures);
    add(
        "at_load_n",
        "Load of the pressures, N.",
        load.clone(),
        at_load,
    );
    add(
        "contact_load_n",
        "Load of the contact angles, N.",
        load,
        contact_load,
    );
}

fn several(items: Value) -> Value {
    json!({"type": "array", "minItems": 1, "maxItems": MOST_VALUES, "uniqueItems": true, "items": items})
}

fn unplaced_film(schemas: &mut Schemas) -> Value {
    schemas.define("UnplacedFilm", |schemas| {
        let (mut film, mut all) = (Properties::default(), Properties::default());
        Film::describe(&mut all, schemas);
        film.add_all(all, &PLACED);
        film.table("A film without its place, which the signals say.")
    })
}

fn further_tire_schema(schemas: &mut Schemas) -> Value {
    schemas.define("FurtherTire", |schemas| {
        let mut tire = Properties::default();
        let name = String::schema(&LONGEST_TIRE, schemas);
        tire.add_required("name", "Name, like no other's.", name);
        let scene = scene_schema(schemas);
        tire.add_required("scene", "The tire.", scene);
        describe_loads(&mut tire, [const { None }; 4], schemas);
        tire.table("A tire beside the study's own, with loads and pressures where it bears others.")
    })
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
                with_film(scene, table_value(&film), "", &mut found);
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
