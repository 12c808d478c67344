//! Describes the study document.

use document::Value;
use document::json_schema::{Properties, Schemas};
use document::typed::field_value::Field;
use fem_client::scene::Level;
use serde_json::json;

use crate::layouts::layout_schema::layouts_schema;
use crate::parts::scene_reader::scene_schema;
use crate::rig::rig_settings::RigSettings;
use crate::signals::signal_reader::signals_schema;
use crate::study::candidate_reader::Candidates;
use crate::study::input_reader::inputs_schema;
use crate::study::method_reader::method_schema;
use crate::study::question::Question;
use crate::study::study_reader::{BUDGET, LIMITS, LONGEST_NAME, TOLERANCE};

/// The schema of a study.
pub(crate) fn study_schema(schemas: &mut Schemas) -> Value {
    schemas.define("Study", |schemas| {
        let mut study = Properties::default();
        let name = String::schema(&LONGEST_NAME, schemas);
        study.add_required("name", "Free text.", name);
        let scene = scene_schema(schemas);
        let doc = "Scene: tables, a preset's name with whatever differs from it, or a path.";
        study.add_required("scene", doc, scene);
        let inputs = inputs_schema(schemas);
        study.add_required("inputs", "Inputs that vary.", inputs);
        let tables = [
            (
                "candidates",
                "Candidate places for films.",
                Candidates::schema(&(), schemas),
            ),
            (
                "layouts",
                "Layouts to score; none when left out.",
                layouts_schema(schemas),
            ),
            (
                "question",
                "Question that the layouts answer: the best with so many films, or the fewest that keep errors within limits; none when left out.",
                Question::schema(&(), schemas),
            ),
            (
                "method",
                "Method that computes the indices.",
                method_schema(LIMITS, schemas),
            ),
            (
                "accuracy",
                "Accuracy that is asked of the answer: exactly one of the three.",
                accuracy_schema(schemas),
            ),
            (
                "signals",
                "Films' signals over loads, pressures and contact angles; none when left out.",
                signals_schema(schemas),
            ),
            (
                "rig",
                "A virtual rig that steps on the tire; none when left out.",
                RigSettings::schema(&(), schemas),
            ),
        ];
        for (name, doc, schema) in tables {
            study.add(name, doc, schema, None, false);
        }
        study.table("Study: what varies, and what is asked.")
    })
}

fn accuracy_schema(schemas: &mut Schemas) -> Value {
    schemas.define("Accuracy", |schemas| {
        let mut accuracy = Properties::default();
        let mut add = |name, doc, schema| accuracy.add(name, doc, schema, None, false);
        add(
            "preset",
            "Level of the mesh; the scene's when no accuracy is asked for.",
            Level::schema(&(), schemas),
        );
        add(
            "tolerance",
            "Largest error of any first-order index, absolute.",
            TOLERANCE.schema(),
        );
        add("budget_s", "Wall-clock time, s.", BUDGET.schema());
        let mut schema = accuracy.table("Accuracy that is asked of the answer.");
        schema["minProperties"] = json!(1);
        schema["maxProperties"] = json!(1);
        schema
    })
}
