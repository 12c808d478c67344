//! Describes sweeps.

use document::Value;
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use serde_json::json;

use crate::study::study_reader::LONGEST_NAME;
use crate::study::study_schema::study_schema;
use crate::sweep::design_draft::MOST_SUBMITTED;

/// The schema of a sweep: a study, and a grid or designs.
pub fn sweep_schema(schemas: &mut Schemas) -> Value {
    schemas.define("Sweep", |schemas| {
        let mut sweep = Properties::default();
        let name = String::schema(&LONGEST_NAME, schemas);
        let doc = "Free text; the study's name when left out.";
        sweep.add("name", doc, name, None, false);
        let study = study_schema(schemas);
        sweep.add_required("study", "The study without changes.", study);
        describe_designs(&mut sweep, schemas);
        sweep.table("A study, and what its designs set otherwise: `grid` or `designs`.")
    })
}

/// The schema of further designs of a sweep.
pub fn further_designs_schema(schemas: &mut Schemas) -> Value {
    schemas.define("FurtherDesigns", |schemas| {
        let mut further = Properties::default();
        describe_designs(&mut further, schemas);
        further.table("Further designs of a sweep: `grid` or `designs`.")
    })
}

fn describe_designs(table: &mut Properties, schemas: &mut Schemas) {
    let values = json!({"type": "array", "minItems": 1, "items": {}});
    let grid = json!({"type": "object", "minProperties": 1, "additionalProperties": values});
    let doc = "Lists of values by path, as `geometry.wall_mm`: every combination is a design, the last path varying fastest.";
    table.add("grid", doc, grid, None, false);
    let design = schemas.define("Design", |schemas| {
        let mut design = Properties::default();
        let name = String::schema(&LONGEST_NAME, schemas);
        let doc = "Name of the design; what it sets when left out, as `wall_mm = 2.5`.";
        design.add("name", doc, name, None, false);
        let doc = "Values by path: `geometry.wall_mm` for the scene's fields, `method.nodes` for the study's own.";
        design.add_required("set", doc, json!({"type": "object"}));
        design.table("A design.")
    });
    let designs =
        json!({"type": "array", "minItems": 1, "maxItems": MOST_SUBMITTED, "items": design});
    table.add("designs", "Designs, one by one.", designs, None, false);
    table.exclude(&["grid", "designs"]);
}
