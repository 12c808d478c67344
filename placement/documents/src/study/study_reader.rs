//! Reads a study from a document, with every fault at once.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Choice;
use document::fault::Fault;
use document::fields::{Fields, Range, alternatives};
use document::typed::field_value::Field;
use document::typed::table_fields::optional;
use document::{Format, parse};
use fem_client::scene::{Level, Scene};
use gsa::method::{Kind, Method};
use serde_json::Value;

use crate::layouts::layout_settings::Layouts;
use crate::layouts::reading::film_size_reader::StudyFilm;
use crate::layouts::reading::layout_reader::layouts;
use crate::parts::directions::Directions;
use crate::parts::film_model::FilmModel;
use crate::parts::scene_reader::{Resolve, scene};
use crate::rig::rig_settings::RigSettings;
use crate::signals::signal_reader::signals;
use crate::signals::signal_settings::SignalSettings;
use crate::study::candidate_reader::Candidates;
use crate::study::input_reader::read_inputs;
use crate::study::method_reader::{Limits, read_method};
use crate::study::plan::{Estimable, PlanError, PlannedStudy};
use crate::study::question::Question;
use crate::study::reading_bounds::check_readings;
use crate::study::study_fields::FIELDS;
use crate::study::{Accuracy, Study};
use document::typed::field_value::read_name;

/// Longest name of a study, characters.
pub(crate) const LONGEST_NAME: usize = 200;
/// Most strains of all maps of a study: they are held in memory twice while they are analysed, 320 MB at this bound.
const MOST_MAP_STRAINS: usize = 20_000_000;
/// Largest error of an index that may be asked for.
pub(crate) const TOLERANCE: Range = Range::new(1e-4, 1.0, "");
/// Wall-clock time that may be allowed.
pub(crate) const BUDGET: Range = Range::new(0.1, 1e6, "s");
/// Solves take seconds, so that more would be a slip.
pub(crate) const LIMITS: Limits = Limits {
    name: "Method",
    usual: Kind::Mdrm,
    nodes: 15,
    check_points: 1000,
    samples: 10_000,
    runs: 100_000,
};

impl Study {
    /// Reads a study from text. `resolve` gives the text of a scene that the study names by its path, so that this
    /// crate opens no files.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_document(
        text: &str,
        format: Format,
        resolve: Resolve<'_>,
    ) -> Result<Self, Vec<Fault>> {
        PlannedStudy::from_document(text, format, resolve).map(|planned| planned.study)
    }

    /// Reads a study from a parsed document.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_value(value: &Value, resolve: Resolve<'_>) -> Result<Self, Vec<Fault>> {
        PlannedStudy::from_value(value, resolve).map(|planned| planned.study)
    }

    /// Reads a study from its canonical text, whose plan was checked before the text was kept.
    ///
    /// # Errors
    /// Every fault of the document, in this version.
    pub fn from_canonical(text: &str) -> Result<Self, Vec<Fault>> {
        let mut value = parse(text, Format::Json)?;
        if let Some(layouts) = value.get_mut("layouts").and_then(Value::as_object_mut) {
            // Texts of versions that knew no other default say nothing of bare films.
            let film = layouts.entry("film");
            film.or_insert_with(|| FilmModel::Bare.as_str().into());
        }
        let no_files = |path: &str| Err(format!("a stored study names the file {path:?}"));
        let mut faults = Vec::new();
        let study = read(&value, &no_files, &mut faults);
        study.filter(|_| faults.is_empty()).ok_or(faults)
    }
}

impl PlannedStudy {
    /// Reads a study from text, as [`Study::from_document`] does, with the plan that it was checked by.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_document(
        text: &str,
        format: Format,
        resolve: Resolve<'_>,
    ) -> Result<Self, Vec<Fault>> {
        let value = parse(text, format)?;
        Self::from_value(&value, resolve)
    }

    /// Reads a study from a parsed document, with the plan that it was checked by.
    ///
    /// # Errors
    /// Every fault of the document.
    pub fn from_value(value: &Value, resolve: Resolve<'_>) -> Result<Self, Vec<Fault>> {
        // Ends of single inputs are checked with the inputs; their combinations only by the plan.
        planned(unplanned(value, resolve)?)
    }
}

impl Estimable {
    /// Reads a study from a parsed document, and plans it unless that takes long.
    ///
    /// # Errors
    /// Every fault of the document; of a large design not those of single points.
    pub fn from_value(value: &Value, resolve: Resolve<'_>) -> Result<Self, Vec<Fault>> {
        let study = unplanned(value, resolve)?;
        if Self::is_counted(&study) {
            return Ok(Self::Counted(study));
        }
        planned(study).map(Self::Planned)
    }
}

/// A study whose plan is not too large to be made.
fn unplanned(value: &Value, resolve: Resolve<'_>) -> Result<Study, Vec<Fault>> {
    let mut faults = Vec::new();
    let study = read(value, resolve, &mut faults)
        .filter(|study| faults.is_empty() && are_few_enough(study, &mut faults));
    study.ok_or(faults)
}

fn read(value: &Value, resolve: Resolve<'_>, faults: &mut Vec<Fault>) -> Option<Study> {
    let fields = Fields::open(value, "", &FIELDS, faults)?;
    let name = read_name(&fields, "name", LONGEST_NAME, faults);
    let scene = scene(&fields, resolve, faults);
    let usual = Candidates::default;
    let candidates = optional(
        &fields,
        "candidates",
        false,
        usual,
        faults,
        |value, at, faults| Candidates::read(value, at, &(), faults),
    );
    let directions = candidates
        .as_ref()
        .map_or(Directions::Both, |candidates| candidates.directions);
    // Layouts of glued films have the film of the signals. Faults stay in the order of the document's tables.
    let mut of_signals = Vec::new();
    let signals = signals(&fields, scene.as_ref(), resolve, &mut of_signals);
    let film = film_of(signals.as_ref(), scene.as_ref());
    let mut layouts = layouts(&fields, scene.as_ref(), directions, film.as_ref(), faults);
    let question = question(&fields, layouts.as_mut(), faults);
    let method = read_method(&fields, LIMITS, faults);
    let accuracy = accuracy(&fields, scene.as_ref(), faults);
    let nodes = method
        .as_ref()
        .map_or(Method::of(Kind::Mdrm).nodes, |method| method.nodes);
    let inputs = read_inputs(&fields, scene.as_ref(), nodes, faults);
    faults.append(&mut of_signals);
    let before = faults.len();
    let rig = optional(
        &fields,
        "rig",
        false,
        || None,
        faults,
        |value, at, faults| {
            let read = RigSettings::read(value, at, &(), faults);
            read.filter(|_| faults.len() == before).map(Some)
        },
    );
    if fields.get("rig").is_some() && scene.as_ref().is_some_and(|scene| scene.ground.leans()) {
        let detail =
            "is about an upright wheel: the scene's ground.camber_deg must be left out, or the rig";
        Fault::add(faults, "/rig", detail);
    }
    let has_profile = |scene: &Scene| scene.ground.profile.is_some();
    for table in ["rig", "signals"] {
        if fields.get(table).is_some() && scene.as_ref().is_some_and(has_profile) {
            let detail =
                "presses plane ground: the scene's ground.profile must be left out, or this table";
            Fault::add(faults, &format!("/{table}"), detail);
        }
    }
    let (mut scene, (accuracy, level)) = (scene?, accuracy?);
    scene.model.level = level;
    let (mut signals, rig) = (signals?, rig?);
    for tire in signals.iter_mut().flat_map(|signals| &mut signals.tires) {
        tire.scene.model.level = level;
    }
    let Candidates {
        directions, grid, ..
    } = candidates?;
    Some(Study {
        name: name?,
        scene,
        inputs: inputs?,
        directions,
        grid,
        layouts: layouts?,
        question: question?,
        method: method?,
        level,
        accuracy,
        signals,
        rig,
    })
}

/// Reads what is asked of layouts. The number of films that there are is on the menu, and who asks without layouts means the common ones.
fn question(
    fields: &Fields<'_>,
    layouts: Option<&mut Layouts>,
    faults: &mut Vec<Fault>,
) -> Option<Question> {
    let asked = optional(
        fields,
        "question",
        false,
        Question::default,
        faults,
        |value, at, faults| Question::read(value, at, &(), faults),
    )?;
    if asked.is_empty() {
        return Some(asked);
    }
    if asked.cost.is_some() && asked.cost_of(1, 0).is_none() {
        let detail = "needs film_cost or channel_cost, by which layouts are dear";
        Fault::add(faults, &format!("{}/cost", fields.at("question")), detail);
    }
    if let Some(layouts) = layouts {
        if fields.get("layouts").is_none() {
            *layouts = Layouts::default();
        }
        if !layouts.is_asked() {
            let detail = "is answered by layouts, and the study asks for none: leave [layouts] out for the common menu, or name some";
            Fault::add(faults, &fields.at("question"), detail);
        }
        let most = asked.most_films(layouts.limits.taken.len());
        if most == Some(0) {
            let detail = "is less than one film costs";
            Fault::add(faults, &format!("{}/cost", fields.at("question")), detail);
        }
        let wanted = most.filter(|films| *films > 0 && !layouts.films.is_empty());
        if let Some(films) = wanted.filter(|films| !layouts.films.contains(films)) {
            layouts.films.push(films);
            layouts.films.sort_unstable();
        }
    }
    Some(asked)
}

/// The film of the signals; where the study asks for none, that of the scene, or a common one.
fn film_of(signals: Option<&Option<SignalSettings>>, scene: Option<&Scene>) -> Option<StudyFilm> {
    match signals? {
        Some(signals) => Some(StudyFilm {
            film: signals.film.clone(),
            is_named: signals.has_glued(),
        }),
        None => scene.map(|scene| StudyFilm {
            film: SignalSettings::on(scene).film,
            is_named: scene.film.is_some(),
        }),
    }
}

/// Whether the plan is small enough to be made at all. The other methods bound their designs by themselves.
fn are_few_enough(study: &Study, faults: &mut Vec<Fault>) -> bool {
    let (samples, inputs) = (study.method.samples, study.inputs.len());
    let solves = samples.saturating_mul(inputs + 2) as u64;
    if study.method.kind != Kind::Saltelli || solves <= LIMITS.runs {
        return true;
    }
    let detail = format!(
        "{samples} base points of {inputs} inputs are {solves} solves; a study has at most {}",
        LIMITS.runs
    );
    Fault::add(faults, "/method/samples", detail);
    false
}

fn planned(study: Study) -> Result<PlannedStudy, Vec<Fault>> {
    let planned = PlannedStudy::new(study).map_err(|error| {
        let detail = match error {
            PlanError::Design(error) => error.to_string(),
            error @ PlanError::Point { .. } => {
                format!("the inputs together leave the ranges of the scene: {error}")
            }
        };
        let mut faults = Vec::new();
        Fault::add(&mut faults, "/inputs", detail);
        faults
    })?;
    let mut faults = Vec::new();
    check_map(&planned.study, planned.plan.points.len(), &mut faults);
    check_readings(&planned.study, &mut faults);
    if faults.is_empty() {
        Ok(planned)
    } else {
        Err(faults)
    }
}

fn check_map(study: &Study, points: usize, faults: &mut Vec<Fault>) {
    let cells = study
        .grid
        .map_or(0, |grid| grid.circumferential * grid.meridional);
    let strains = 2 * cells * points;
    if strains > MOST_MAP_STRAINS {
        let detail = format!(
            "this map has {strains} strains over the study's {points} points; at most {MOST_MAP_STRAINS} are kept"
        );
        Fault::add(faults, "/candidates/grid", detail);
    }
}

/// Reads what is asked of the answer, and the mesh level: the preset's, or the scene's own when the study doesn't ask. Where a tolerance is asked
/// for, the way begins at the first level that knows its own error, and at the draft for a budget.
fn accuracy(
    fields: &Fields<'_>,
    scene: Option<&Scene>,
    faults: &mut Vec<Fault>,
) -> Option<(Accuracy, Level)> {
    let default = scene.map_or(Level::Standard, |scene| scene.model.level);
    let Some((value, pointer)) = fields.get("accuracy") else {
        return Some((Accuracy::Preset, default));
    };
    let known = ["preset", "tolerance", "budget_s"];
    let fields = Fields::open(value, &pointer, &known, faults)?;
    let given = known.iter().filter(|name| fields.get(name).is_some());
    if given.count() != 1 {
        let presets = alternatives(Level::ALL.map(Level::as_str));
        let detail = format!(
            "must hold exactly one of {}; preset is {presets}",
            known.join(", ")
        );
        Fault::add(faults, &pointer, detail);
        return None;
    }
    if fields.get("tolerance").is_some() {
        let tolerance = fields.number("tolerance", TOLERANCE, 0.0, faults)?;
        return Some((Accuracy::Tolerance(tolerance), Level::Coarse));
    }
    if fields.get("budget_s").is_some() {
        let seconds = fields.number("budget_s", BUDGET, 0.0, faults)?;
        return Some((Accuracy::Budget(seconds), Level::Draft));
    }
    let level = fields.choice("preset", Level::CHOICES, default, faults)?;
    Some((Accuracy::Preset, level))
}
