//! Reads recipes of estimators: TOML or JSON, every field with a default.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use estimation::recipe::{
    Activation, AnnSettings, Columns, CycleRule, FeatureSet, Features, GprSettings, Kind, Lengths,
    Loss, Models, Preprocess, Recipe, Scale, SplitKind, StartValue, Validation,
};
use fem_client::document::fault::{Fault, entry};
use fem_client::document::fields::{Fields, Range, choice, integer, number, shown};
use fem_client::document::{Format, parse};
use serde_json::Value;

const SECONDS: Range = Range::new(1e-6, 1e9, "s");
const HERTZ: Range = Range::new(1e-6, 1e6, "Hz");
const NEWTONS: Range = Range::new(1e-9, 1e9, "N");
const DEVIATIONS: Range = Range::new(1.0, 1000.0, "standard deviations");
const DECAY: Range = Range::new(0.0, 1e6, "");
/// Most names or patterns of a list.
const MOST_NAMES: usize = 4096;
const LONGEST_NAME: usize = 200;
const MOST_WINDOW: u64 = 10_000;
const MOST_LAYERS: usize = 8;
const MOST_NODES: u64 = 256;
/// Rows of a covariance that takes 200 MB.
const MOST_PROCESS_ROWS: u64 = 5000;

/// Reads a recipe's text; an empty one has all defaults.
///
/// # Errors
/// Every fault with its place.
pub fn recipe_from_text(text: &str, format: Format) -> Result<Recipe, Vec<Fault>> {
    recipe_from_value(&parse(text, format)?)
}

/// Reads a recipe's document.
///
/// # Errors
/// Every fault with its place.
pub fn recipe_from_value(document: &Value) -> Result<Recipe, Vec<Fault>> {
    let mut faults = Vec::new();
    let recipe = read(document, &mut faults);
    match recipe {
        Some(recipe) if faults.is_empty() => Ok(recipe),
        _ => Err(faults),
    }
}

fn read(document: &Value, faults: &mut Vec<Fault>) -> Option<Recipe> {
    let known = ["columns", "preprocess", "features", "models", "validation"];
    let fields = Fields::open(document, "", &known, faults)?;
    let mut recipe = Recipe::default();
    // Each table is read whatever is wrong with the others: all faults are told at once.
    if let Some((value, at)) = fields.get("columns") {
        recipe.columns = columns(value, &at, faults).unwrap_or_default();
    }
    if let Some((value, at)) = fields.get("preprocess") {
        recipe.preprocess = preprocess(value, &at, faults).unwrap_or_default();
    }
    if let Some((value, at)) = fields.get("features") {
        recipe.features = features(value, &at, faults).unwrap_or_default();
    }
    if let Some((value, at)) = fields.get("models") {
        recipe.models = models(value, &at, faults).unwrap_or_default();
    }
    if let Some((value, at)) = fields.get("validation") {
        recipe.validation = validation(value, &at, faults).unwrap_or_default();
    }
    Some(recipe)
}

fn columns(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Columns> {
    let known = [
        "time",
        "signals",
        "forces",
        "cycle",
        "pause_s",
        "threshold_n",
        "block_s",
    ];
    let fields = Fields::open(value, pointer, &known, faults)?;
    let time = fields
        .get("time")
        .and_then(|(value, at)| name(value, &at, faults));
    let signals = fields
        .get("signals")
        .and_then(|(value, at)| names(value, &at, faults));
    let forces = fields
        .get("forces")
        .and_then(|(value, at)| names(value, &at, faults));
    let mut rules = Vec::new();
    if let Some((value, at)) = fields.get("cycle") {
        rules.extend(name(value, &at, faults).map(CycleRule::Column));
    }
    let mut quantity = |field: &str, range: Range, rule: fn(f64) -> CycleRule| {
        if let Some((value, at)) = fields.get(field) {
            rules.extend(number(value, &at, range, faults).map(rule));
        }
    };
    quantity("pause_s", SECONDS, CycleRule::PauseS);
    quantity("threshold_n", NEWTONS, CycleRule::ThresholdN);
    quantity("block_s", SECONDS, CycleRule::BlockS);
    if rules.len() > 1 {
        let detail = "must say in one way what a cycle is: cycle, pause_s, threshold_n or block_s";
        Fault::add(faults, pointer, detail);
    }
    Some(Columns {
        time,
        signals,
        forces,
        cycles: rules.into_iter().next().unwrap_or_default(),
    })
}

fn preprocess(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Preprocess> {
    let known = [
        "start_value",
        "turn_sign",
        "rate_hz",
        "smooth_rows",
        "outlier_z",
        "scale",
        "pause_s",
    ];
    let fields = Fields::open(value, pointer, &known, faults)?;
    let usual = Preprocess::default();
    let starts = [
        ("auto", StartValue::Auto),
        ("subtract", StartValue::Subtract),
        ("keep", StartValue::Keep),
    ];
    let scales = [
        ("standardise", Scale::Standardise),
        ("normalise", Scale::Normalise),
        ("off", Scale::Off),
    ];
    let start_value = fields.choice("start_value", &starts, usual.start_value, faults);
    let turn_sign = flag(&fields, "turn_sign", usual.turn_sign, faults);
    let smooth_rows = fields.integer(
        "smooth_rows",
        (1, MOST_WINDOW),
        usual.smooth_rows as u64,
        faults,
    );
    let scale = fields.choice("scale", &scales, usual.scale, faults);
    Some(Preprocess {
        rate_hz: optional(&fields, "rate_hz", HERTZ, faults),
        outlier_z: optional(&fields, "outlier_z", DEVIATIONS, faults),
        pause_s: optional(&fields, "pause_s", SECONDS, faults),
        start_value: start_value?,
        turn_sign,
        smooth_rows: size(smooth_rows?),
        scale: scale?,
    })
}

fn features(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Features> {
    let fields = Fields::open(value, pointer, &["sets", "window_rows"], faults)?;
    let usual = Features::default();
    let sets = FeatureSet::ALL.map(|set| (set.as_str(), set));
    let sets = distinct(&fields, "sets", &sets, usual.sets, faults);
    let window = fields.integer(
        "window_rows",
        (2, MOST_WINDOW),
        usual.window_rows as u64,
        faults,
    );
    Some(Features {
        sets: sets?,
        window_rows: size(window?),
    })
}

fn models(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Models> {
    let fields = Fields::open(value, pointer, &["kinds", "gpr", "ann", "seed"], faults)?;
    let usual = Models::default();
    let kinds = Kind::ALL.map(|kind| (kind.as_str(), kind));
    let kinds = distinct(&fields, "kinds", &kinds, usual.kinds, faults);
    let alone = |kinds: &Vec<Kind>| {
        let learnt = |kind: &Kind| !matches!(kind, Kind::Mean | Kind::Blend);
        kinds.contains(&Kind::Blend) && !kinds.iter().any(learnt)
    };
    if kinds.as_ref().is_some_and(alone) {
        let detail = "must name a model beside \"blend\", which is the median of others";
        Fault::add(faults, &format!("{pointer}/kinds"), detail);
    }
    let seed = fields.integer("seed", (0, u64::from(u32::MAX)), usual.seed, faults);
    let gpr = match fields.get("gpr") {
        Some((value, at)) => gpr(value, &at, faults),
        None => Some(usual.gpr),
    };
    let ann = match fields.get("ann") {
        Some((value, at)) => ann(value, &at, faults),
        None => Some(usual.ann),
    };
    Some(Models {
        kinds: kinds?,
        gpr: gpr?,
        ann: ann?,
        seed: seed?,
    })
}

fn gpr(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<GprSettings> {
    let fields = Fields::open(
        value,
        pointer,
        &["lengths", "line", "restarts", "search_rows", "most_rows"],
        faults,
    )?;
    let usual = GprSettings::default();
    let lengths = [("shared", Lengths::Shared), ("each", Lengths::Each)];
    let lengths = fields.choice("lengths", &lengths, usual.lengths, faults);
    let restarts = fields.integer("restarts", (1, 1000), usual.restarts as u64, faults);
    let search_rows = fields.integer(
        "search_rows",
        (20, MOST_PROCESS_ROWS),
        usual.search_rows as u64,
        faults,
    );
    let most_rows = fields.integer(
        "most_rows",
        (20, MOST_PROCESS_ROWS),
        usual.most_rows as u64,
        faults,
    );
    let line = flag(&fields, "line", usual.line, faults);
    Some(GprSettings {
        lengths: lengths?,
        line,
        restarts: size(restarts?),
        search_rows: size(search_rows?),
        most_rows: size(most_rows?),
    })
}

fn ann(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<AnnSettings> {
    let known = [
        "layers",
        "activation",
        "output",
        "loss",
        "decay",
        "iterations",
        "networks",
    ];
    let fields = Fields::open(value, pointer, &known, faults)?;
    let usual = AnnSettings::default();
    let hidden = [
        ("linear", Activation::Linear),
        ("sigmoid", Activation::Sigmoid),
        ("tanh", Activation::Tanh),
        ("relu", Activation::Relu),
        ("elu", Activation::Elu),
        ("softmax", Activation::Softmax),
    ];
    // One node's softmax is 1, whatever its sum.
    let (output, _) = hidden.split_at(hidden.len() - 1);
    let losses = [("mse", Loss::Mse), ("poisson", Loss::Poisson)];
    let layers = match fields.get("layers") {
        Some((value, at)) => list(value, &at, MOST_LAYERS, faults, |value, at, faults| {
            integer(value, at, 1, MOST_NODES, faults).map(size)
        }),
        None => Some(usual.layers),
    };
    let activation = fields.choice("activation", &hidden, usual.activation, faults);
    let output = fields.choice("output", output, usual.output, faults);
    let loss = fields.choice("loss", &losses, usual.loss, faults);
    let decay = fields.number("decay", DECAY, usual.decay, faults);
    let iterations = fields.integer("iterations", (1, 100_000), usual.iterations as u64, faults);
    let networks = fields.integer("networks", (1, 50), usual.networks as u64, faults);
    Some(AnnSettings {
        layers: layers?,
        activation: activation?,
        output: output?,
        loss: loss?,
        decay: decay?,
        iterations: size(iterations?),
        networks: size(networks?),
    })
}

fn validation(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Validation> {
    let fields = Fields::open(value, pointer, &["by", "time_constant_s"], faults)?;
    let splits = SplitKind::ALL.map(|kind| (kind.as_str(), kind));
    let by = fields
        .get("by")
        .and_then(|(value, at)| choice(value, &at, &splits, faults));
    let time_constant_s = fields.number("time_constant_s", Range::new(0.0, 1e9, "s"), 0.0, faults);
    Some(Validation {
        by,
        time_constant_s: time_constant_s?,
    })
}

fn size(count: u64) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}

fn optional(
    fields: &Fields<'_>,
    field: &str,
    range: Range,
    faults: &mut Vec<Fault>,
) -> Option<f64> {
    fields
        .get(field)
        .and_then(|(value, at)| number(value, &at, range, faults))
}

fn flag(fields: &Fields<'_>, field: &str, usual: bool, faults: &mut Vec<Fault>) -> bool {
    let Some((value, at)) = fields.get(field) else {
        return usual;
    };
    value.as_bool().unwrap_or_else(|| {
        Fault::add(
            faults,
            &at,
            format!("must be true or false; it is {}", shown(value)),
        );
        usual
    })
}

/// A column's name.
fn name(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<String> {
    let fits = |text: &&str| {
        (1..=LONGEST_NAME).contains(&text.chars().count()) && !text.contains(['\n', '\r'])
    };
    let found = value.as_str().filter(fits);
    if found.is_none() {
        let detail = format!(
            "must be a column's name of 1 to {LONGEST_NAME} characters; it is {}",
            shown(value)
        );
        Fault::add(faults, pointer, detail);
    }
    found.map(str::to_owned)
}

/// A name, or a list of names and patterns.
fn names(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Vec<String>> {
    if value.is_string() {
        return name(value, pointer, faults).map(|name| vec![name]);
    }
    list(value, pointer, MOST_NAMES, faults, name)
}

/// A list of 1 to so many entries.
fn list<T>(
    value: &Value,
    pointer: &str,
    most: usize,
    faults: &mut Vec<Fault>,
    read: impl Fn(&Value, &str, &mut Vec<Fault>) -> Option<T>,
) -> Option<Vec<T>> {
    let Some(items) = value
        .as_array()
        .filter(|items| (1..=most).contains(&items.len()))
    else {
        Fault::add(
            faults,
            pointer,
            format!(
                "must be a list of 1 to {most} entries; it is {}",
                shown(value)
            ),
        );
        return None;
    };
    let read: Vec<Option<T>> = items
        .iter()
        .enumerate()
        .map(|(at, item)| read(item, &entry(pointer, at), faults))
        .collect();
    read.into_iter().collect()
}

/// A list of named values that differ.
fn distinct<T: Copy + PartialEq>(
    fields: &Fields<'_>,
    field: &str,
    options: &[(&str, T)],
    usual: Vec<T>,
    faults: &mut Vec<Fault>,
) -> Option<Vec<T>> {
    let Some((value, at)) = fields.get(field) else {
        return Some(usual);
    };
    let found = list(value, &at, options.len(), faults, |value, at, faults| {
        choice(value, at, options, faults)
    })?;
    let twice = found
        .iter()
        .enumerate()
        .any(|(place, item)| found.iter().take(place).any(|other| other == item));
    if twice {
        Fault::add(faults, &at, "must name each entry once");
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_recipe_has_all_defaults() {
        assert_eq!(recipe_from_text("", Format::Toml), Ok(Recipe::default()));
    }

    #[test]
    fn every_field_is_read() {
        let text = r#"
            [columns]
            time = "t"
            signals = ["s*", "extra"]
            forces = "fz"
            threshold_n = 0.5
            [preprocess]
            start_value = "keep"
            turn_sign = true
            rate_hz = 200
            smooth_rows = 3
            outlier_z = 4
            scale = "normalise"
            pause_s = 0.5
            [features]
            sets = ["raw", "all"]
            window_rows = 5
            [models]
            kinds = ["gpr", "ann"]
            seed = 7
            [models.gpr]
            lengths = "each"
            line = false
            restarts = 3
            search_rows = 100
            most_rows = 200
            [models.ann]
            layers = [5]
            activation = "softmax"
            output = "elu"
            loss = "poisson"
            decay = 0.1
            iterations = 10
            networks = 2
            [validation]
            by = "time"
            time_constant_s = 0.1
        "#;
        let read = recipe_from_text(text, Format::Toml).expect("reads");
        assert_eq!(read.columns.cycles, CycleRule::ThresholdN(0.5));
        assert_eq!(read.columns.forces, Some(vec!["fz".to_owned()]));
        assert_eq!(read.preprocess.rate_hz, Some(200.0));
        assert_eq!(read.features.sets, [FeatureSet::Raw, FeatureSet::All]);
        assert_eq!(read.models.gpr.lengths, Lengths::Each);
        assert_eq!(read.models.ann.layers, [5]);
        assert_eq!(read.models.ann.activation, Activation::Softmax);
        assert_eq!(read.validation.by, Some(SplitKind::Time));
    }

    #[test]
    fn a_blend_needs_others() {
        let text = r#"{"models": {"kinds": ["mean", "blend"]}}"#;
        let faults = recipe_from_text(text, Format::Json).expect_err("a fault");
        assert_eq!(faults[0].pointer, "/models/kinds");
        assert!(recipe_from_text(&text.replace("mean", "ann"), Format::Json).is_ok());
    }

    #[test]
    fn all_faults_are_told_with_their_places() {
        let text = r#"{"columns": {"time": 1, "pause_s": 1, "block_s": 2, "signal": "s"}, "preprocess": {"rate_hz": -1, "turn_sign": 1},
            "features": {"sets": []}, "models": {"kinds": ["gpr", "gpr"], "ann": {"output": "softmax", "layers": [0]}}, "validation": {"by": "row"}}"#;
        let faults = recipe_from_text(text, Format::Json).expect_err("faults");
        let places: Vec<&str> = faults.iter().map(|fault| fault.pointer.as_str()).collect();
        for place in [
            "/columns/signal",
            "/columns/time",
            "/columns",
            "/preprocess/rate_hz",
            "/preprocess/turn_sign",
            "/features/sets",
            "/models/kinds",
            "/models/ann/output",
            "/models/ann/layers/0",
            "/validation/by",
        ] {
            assert!(places.contains(&place), "{place}: {places:?}");
        }
    }
}
