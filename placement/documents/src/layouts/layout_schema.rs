//! Describes the table `layouts`.

use document::fields::Range;
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use document::typed::lists::{Each, Entries};
use document::{Choice, Value};
use fem_client::scene::{DEPTH, LOAD, Level};
use fem_client::solver::Position;
use serde_json::json;

use crate::layouts::assumptions::Assumptions;
use crate::layouts::contact_laws::{
    CHECKS, CHECKS_WITHIN, ContactQuantity, Contacts, SCATTER, Scatter,
};
use crate::layouts::layout_bounds::{
    ANGLE, CAMBER, DISTANCE, DRIFT, FRICTION, GAIN, LONGEST_LAYOUT, MOST_ENTRIES, MOST_FILMS,
    MOST_FREE, MOST_LOADS, MOST_SEARCHED, MOST_SIZES, MOST_SLOTS, MOST_UNITS, NOISE_FACTOR, PLACE,
    PRESSURE_FACTOR, SHARE, SIDE, SPACING, STRAIN, VOLTS,
};
use crate::layouts::layout_settings::{Layouts, NOISE_SHARE};
use crate::parts::distribution_reader::distribution_schema;
use crate::parts::film_model::FilmModel;

/// A section angle; a scene bounds it more narrowly, a wall's thickness off the bead.
const SECTION: Range = Range::new(-180.0, 180.0, "degrees");

/// The schema of `layouts`.
pub(crate) fn layouts_schema(schemas: &mut Schemas) -> Value {
    schemas.define("Layouts", |schemas| {
        let mut layouts = Properties::default();
        describe_which(&mut layouts, schemas);
        let doc = "Films that are glued on already: part of every layout of the menu, of rings and of a search, and counted. A ring is turned until most of its films keep clear of them and of `forbidden_deg`, and goes without the others.";
        describe_limits(&mut layouts, ("taken", doc), schemas);
        describe_films(&mut layouts, schemas);
        describe_judgement(&mut layouts, schemas);
        layouts.table("Layouts to score.")
    })
}

/// Describes the fields that say which layouts there are.
fn describe_which(layouts: &mut Properties, schemas: &mut Schemas) {
    let usual = Layouts::default();
    let mut add = |name, doc, schema, default| layouts.add(name, doc, schema, default, false);
    let spacings = Vec::<f64>::schema(&Entries::distinct(MOST_ENTRIES, SPACING), schemas);
    let films = Vec::<usize>::schema(
        &Entries::distinct(MOST_ENTRIES, (1, MOST_FILMS as u64)),
        schemas,
    );
    let doc = "Numbers of films of the menu: each along every direction, and as all directions in one place or in turn. Without spacings_deg, units, free and search the common menu.";
    add("films", doc, films, usual.films.write());
    let doc = "Angles between neighbouring units, degrees; each divides 360.";
    add("spacings_deg", doc, spacings, None);
    let units = Vec::<usize>::schema(&Entries::distinct(MOST_ENTRIES, (1, MOST_UNITS)), schemas);
    let doc = "Numbers of units, beside those of the spacings.";
    add("units", doc, units, None);
    let positions = Vec::<Position>::schema(&Entries::distinct(Position::ALL.len(), ()), schemas);
    let doc = "Places of the units in the section.";
    add("positions", doc, positions, usual.positions.write());
    let doc = "Section angles beside the positions', degrees from the crown.";
    add("section_deg", doc, sections(schemas), None);
    let set = json!({"type": "array", "minItems": 1, "maxItems": 4, "uniqueItems": true, "items": direction()});
    let sets =
        json!({"type": "array", "maxItems": MOST_ENTRIES, "uniqueItems": true, "items": set});
    let doc = "Sets of directions of a unit's films; those that the study asks for when left out.";
    add("directions", doc, sets, None);
    let doc =
        "Whether units of several films are also scored with their films spread between the units.";
    add(
        "staggered",
        doc,
        bool::schema(&(), schemas),
        Some(false.into()),
    );
    let free = free_layout(schemas);
    let free = json!({"type": "array", "maxItems": MOST_FREE, "uniqueItems": true, "items": free});
    add("free", "Layouts film by film.", free, None);
    let search = search(schemas);
    add("search", "Layouts to search for.", search, None);
}

/// Describes the fields of their films.
fn describe_films(layouts: &mut Properties, schemas: &mut Schemas) {
    let mut add = |name, doc, schema, default| layouts.add(name, doc, schema, default, false);
    let models = FilmModel::CHOICES.iter().map(|choice| choice.0);
    let films = json!({"type": "string", "enum": models.collect::<Vec<_>>()});
    let doc = "Model of the films: `bare`; or glued on with their stiffness and read in volts: `coupled`, solved with the tire around the wheel, or `transfer`, by two coupled solves of a film above the contact. `coupled` when left out of a study whose scene or signals have a film glued on.";
    add("film", doc, films, None);
    let size = <[f64; 2]>::schema(&Each::of("", SIDE), schemas);
    let doc = "Length and width of all films, mm; points when left out, the glued film's where it is glued on.";
    add("size_mm", doc, size.clone(), None);
    let sizes =
        json!({"type": "array", "maxItems": MOST_SIZES, "uniqueItems": true, "items": size});
    let doc = "Further lengths and widths that the candidates have, mm.";
    add("candidate_sizes_mm", doc, sizes, None);
}

/// Describes the fields by which they are judged.
fn describe_judgement(layouts: &mut Properties, schemas: &mut Schemas) {
    let mut add = |name, doc, schema, default| layouts.add(name, doc, schema, default, false);
    let above_zero = |range: Range| {
        let mut each = range.schema();
        each["exclusiveMinimum"] = 0.into();
        json!({"type": "array", "minItems": 1, "maxItems": MOST_LOADS, "uniqueItems": true, "items": each})
    };
    let doc = "Depths at which layouts are scored, mm; the mean one when left out.";
    add("depths_mm", doc, above_zero(DEPTH), None);
    let doc = "Forces in place of depths, N.";
    add("loads_n", doc, above_zero(LOAD), None);
    let doc = "Noise of a film over the crown's largest signal.";
    add("noise_share", doc, SHARE.schema(), Some(NOISE_SHARE.into()));
    let doc = "Noise of a bare film, strain.";
    add("noise_strain", doc, STRAIN.schema(), None);
    add("noise_v", "Noise of a glued film, V.", VOLTS.schema(), None);
    let doc = "Standard deviation of a film's gain, relative.";
    add("gain_std", doc, GAIN.schema(), Some(0.0.into()));
    let doc = "Standard deviation of a film's place around the wheel, degrees.";
    add("place_std_deg", doc, PLACE.schema(), Some(0.0.into()));
    let doc = "Whether every layout is also scored without the film whose loss costs most.";
    add("dead", doc, bool::schema(&(), schemas), Some(false.into()));
    let doc = "Whether forces along the wheel and across it are unknown, too: takes ground with friction, and a solve of the whole tire for every load and mesh.";
    add("shear", doc, bool::schema(&(), schemas), Some(false.into()));
    let doc = "Laws of what a contact is beside its angle and depth, which an estimate doesn't know: simulated errors are over contacts as they come. Takes `depths_mm`.";
    add("contacts", doc, contacts(schemas), None);
    let doc = "What the answer's figures rest on, changed one at a time.";
    add("assumptions", doc, assumptions(schemas), None);
    let doc =
        "Mesh level of the layouts' own solves; the study's, the standard at most, when left out.";
    add("level", doc, Level::schema(&(), schemas), None);
    layouts.exclude(&["depths_mm", "loads_n"]);
    layouts.exclude(&["noise_share", "noise_strain"]);
    layouts.exclude(&["noise_share", "noise_v"]);
}

fn contacts(schemas: &mut Schemas) -> Value {
    schemas.define("LayoutContacts", |schemas| {
        let mut laws = Properties::default();
        for quantity in ContactQuantity::ALL {
            let law = distribution_schema(schemas);
            laws.add(quantity.as_str(), quantity.doc(), law, None, false);
        }
        let doc = "Scatter of films over these contacts, as an estimate takes it: known of all films together, so that what contacts differ in is estimated, too, or averaged over, as noise of each film.";
        let usual = Contacts::default();
        let scatter = Scatter::schema(&(), schemas);
        laws.add(SCATTER, doc, scatter, Some(usual.scatter.as_str().into()), false);
        let doc = "Number of contacts that are solved to judge the response surface, and left out of it. Each is a whole tire with friction; 30 tell its largest error.";
        let checks = u64::schema(&CHECKS_WITHIN, schemas);
        laws.add(CHECKS, doc, checks, Some(usual.checks.into()), false);
        laws.table("Laws of contacts; what has none is as in the scene.")
    })
}

fn assumptions(schemas: &mut Schemas) -> Value {
    schemas.define("LayoutAssumptions", |schemas| {
        let usual = Assumptions::default();
        let mut table = Properties::default();
        let mut add = |name, doc, range: Range, usual: Option<f64>| {
            table.add(name, doc, range.schema(), usual.map(Value::from), false);
        };
        let doc = "Noise over the layouts' own.";
        add("noise_factor", doc, NOISE_FACTOR, Some(usual.noise_factor));
        let doc = "Standard deviation of a drift beside the noise, over the crown's largest signal.";
        add("drift_share", doc, DRIFT, Some(usual.drift_share));
        let doc = "Standard deviation of a film's gain, relative.";
        add("gain_std", doc, GAIN, Some(usual.gain_std));
        let doc = "Standard deviation of a film's place around the wheel, degrees.";
        add("place_std_deg", doc, PLACE, Some(usual.place_std_deg));
        let doc = "Internal pressure over the scene's, unknown to an estimate; not changed when left out.";
        add("pressure_factor", doc, PRESSURE_FACTOR, None);
        let doc = "Inclination of the wheel, degrees, unknown to an estimate; not changed when left out.";
        add("camber_deg", doc, CAMBER, None);
        let doc = "Friction of the ground, unknown to an estimate; not changed when left out.";
        add("friction", doc, FRICTION, None);
        let doc = "Model of the films in place of the layouts' own, which an estimate knows; not changed when left out. Glued ones are solved around the wheel.";
        table.add("film", doc, FilmModel::schema(&(), schemas), None, false);
        table.table("Values to which what the answer's figures rest on is changed, one at a time.")
    })
}

/// A name, or an angle to the circumference, degrees.
fn direction() -> Value {
    json!({"anyOf": [{"type": "string", "enum": ["x", "y"]}, ANGLE.schema()]})
}

fn sections(schemas: &mut Schemas) -> Value {
    Vec::<f64>::schema(&Entries::distinct(MOST_ENTRIES, SECTION), schemas)
}

fn film_place(schemas: &mut Schemas) -> Value {
    schemas.define("FilmPlace", |_| {
        let mut film = Properties::default();
        let mut add =
            |name, doc, range: Range| film.add(name, doc, range.schema(), Some(0.0.into()), false);
        add("theta_deg", "Wheel angle, degrees.", ANGLE);
        add("phi_deg", "Section angle from the crown, degrees.", SECTION);
        let doc = "Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.";
        add("angle_deg", doc, ANGLE);
        film.table("Place of a film.")
    })
}

fn free_layout(schemas: &mut Schemas) -> Value {
    let film = film_place(schemas);
    schemas.define("FreeLayout", |schemas| {
        let mut layout = Properties::default();
        let name = String::schema(&LONGEST_LAYOUT, schemas);
        layout.add_required("name", "Name of the layout.", name);
        let films = json!({"type": "array", "minItems": 1, "maxItems": MOST_FILMS, "uniqueItems": true, "items": film});
        layout.add_required("films", "Films, one by one.", films);
        layout.table("A layout film by film.")
    })
}

/// Describes limits to where films can be glued; those that are glued on already have this name and description.
fn describe_limits(table: &mut Properties, (taken, doc): (&str, &str), schemas: &mut Schemas) {
    let place = film_place(schemas);
    let films =
        json!({"type": "array", "maxItems": MOST_ENTRIES, "uniqueItems": true, "items": place});
    table.add(taken, doc, films, None, false);
    let sector = <[f64; 2]>::schema(&Each::of("", ANGLE), schemas);
    let sectors =
        json!({"type": "array", "maxItems": MOST_ENTRIES, "uniqueItems": true, "items": sector});
    let doc = "Sectors of the wheel where no film lies, as a valve's or a seam's: from one angle to another in the rolling direction, degrees.";
    table.add("forbidden_deg", doc, sectors, None, false);
    let doc = "Least distance between the middles of two films on the inner surface, mm.";
    let least = DISTANCE.schema();
    table.add("least_distance_mm", doc, least, Some(0.0.into()), false);
}

fn search(schemas: &mut Schemas) -> Value {
    schemas.define("LayoutSearch", |schemas| {
        let mut search = Properties::default();
        let mut films = Vec::<usize>::schema(&Entries::distinct(MOST_ENTRIES, (1, MOST_SEARCHED)), schemas);
        films["minItems"] = 1.into();
        search.add_required("films", "Numbers of films.", films);
        let slots = usize::schema(&(3, MOST_SLOTS), schemas);
        search.add("slots", "Places around the wheel.", slots, Some(24.into()), false);
        let mut sections = sections(schemas);
        sections["minItems"] = 1.into();
        let doc = "Section angles, degrees from the crown.";
        search.add("section_deg", doc, sections, Some(json!([0.0])), false);
        let directions = json!({"type": "array", "minItems": 1, "maxItems": MOST_ENTRIES, "uniqueItems": true, "items": direction()});
        let doc = "Directions of the films.";
        search.add("directions", doc, directions, Some(json!(["x", "y"])), false);
        let doc = "Films that are glued on already, besides those that are `taken` for all layouts: part of every layout, and counted in `films`.";
        describe_limits(&mut search, ("fixed", doc), schemas);
        search.table("The best of all layouts of so many films. Films that overlap, by their `size_mm`, are none.")
    })
}
