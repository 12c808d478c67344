//! Examples of the service's documents. A test reads each back as the type that it is an example of.

use fem_client::document::{Format, parse};
use serde_json::{Value, json};

const ID: &str = "019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6b";
const SHA256: &str = "af5570f5a1810b7af78caf4bc70a660f0df51e42baf91d4de5b2328de0e83dfc";

/// A small study, as TOML.
pub fn study_toml() -> &'static str {
    "name = \"two depths\"\nscene = { preset = \"foot-tire\" }\n\
     [[inputs]]\nname = \"P2\"\nvary = \"ground.depths_mm[1]\"\ndistribution = { kind = \"uniform\", min = 0.7, max = 1.3 }\n\
     [[inputs]]\nname = \"P3\"\nvary = \"ground.depths_mm[2]\"\ndistribution = { kind = \"uniform\", min = 0.7, max = 1.3 }\n\
     [method]\nkind = \"mdrm\"\nnodes = 3\n[accuracy]\npreset = \"draft\"\n"
}

/// The example's study as JSON.
pub fn study() -> Value {
    parse(study_toml(), Format::Toml).unwrap_or_default()
}

/// A study at work.
pub fn summary() -> Value {
    json!({
        "id": ID, "name": "two depths", "state": "running", "spec_sha256": SHA256, "points_total": 10, "points_done": 4,
        "error": null, "priority": 0, "created": "2026-11-22T01:02:03.456Z", "started": "2026-11-22T01:02:03.460Z", "finished": null, "archived": null,
    })
}

/// A study at work with its document.
pub fn detail() -> Value {
    let mut detail = summary();
    detail["document"] = study();
    detail["estimate"] = estimate();
    detail["result_sha256"] = Value::Null;
    detail["trade_measured"] = false.into();
    detail["sweep"] = Value::Null;
    detail
}

/// What it is expected to take.
pub fn estimate() -> Value {
    json!({
        "solves": {"own": 10, "coarser": 0, "effects": 0, "signals": 0, "layouts": 0, "tables": 0, "known": 0, "left": {"least": 10, "expected": 10, "most": 10}},
        "wall_s": {"least": 0.06, "expected": 0.18, "most": 0.54},
        "peak_memory_bytes": 36_000_000,
        "accuracy": {"fidelity": "draft mdrm 3", "error_true": 0.022, "error_claimed": 0.1323},
        "threads": 2, "measured_solves": 0,
        "reasons": ["this database has no solves to measure this machine by: the times are those of another machine, and off by a factor of 3"],
    })
}

/// A document's places at once.
pub fn preview() -> Value {
    let result = result();
    json!({
        "claim": "none", "level": "draft", "wall_s": 0.2, "solves": 10, "inputs": result["inputs"], "locations": result["locations"],
        "cut_point": result["cut_point"], "map": null, "left_out": ["Layouts: they take solves of their own."], "notes": result["notes"],
    })
}

/// A preview that nobody waits for any more.
pub fn superseded() -> Value {
    json!({"type": "about:blank", "title": "Conflict", "status": 409, "detail": "superseded: a newer preview was asked for", "request_id": ID})
}

/// A place in the ranking.
pub fn location() -> Value {
    json!({
        "name": "P3", "input": "P3", "rank": 1, "gsi_x_percent": 88.3, "gsi_y_percent": 73.3, "gsi_x_error_percent": 0.2, "gsi_y_error_percent": 0.4,
        "mean_gsi_x_percent": 60.7, "mean_gsi_y_percent": 59.4, "own_gsi_x_percent": 88.3, "own_gsi_y_percent": 73.3,
        "mdrm_gsi_x_percent": 85.2, "mdrm_gsi_y_percent": 73.3, "rank_x": 1, "rank_y": 1, "rank_certain": true,
    })
}

/// A layout.
pub fn layout() -> Value {
    json!({
        "rank": 1, "spacing_deg": 60.0, "units": 6, "position": "crown", "films": ["x", "y"],
        "rank_certain": false, "film_count": 12,
        "score": {
            "weakest_signal": 0.002, "worst_angle_error_deg": 22.0, "rms_angle_error_deg": 4.9, "worst_depth_error_mm": 0.67, "bayes_angle_error_deg": 4.5,
            "simulated_rms_angle_error_deg": 31.0, "simulated_rms_angle_error_deg_se": 2.8, "simulated_p95_angle_error_deg": 65.0,
            "simulated_p95_angle_error_deg_se": 9.0, "lost_share": 0.22, "simulated_rms_depth_error_mm": 0.26, "force_error_n": 4.6,
            "alike": {"angle_deg": 27.5, "other_angle_deg": 332.0, "other_depth_mm": 1.1, "sigmas": 0.4}, "noise_strain": 0.0017,
            "error": {"worst_angle_error_deg": 3.6, "rms_angle_error_deg": 0.2, "worst_depth_error_mm": 0.1, "simulated_rms_angle_error_deg": 6.0,
                      "simulated_p95_angle_error_deg": 18.0},
        },
        "loads": [],
    })
}

/// Kinds of film by several criteria.
pub fn candidates() -> Value {
    json!({
        "candidates": [{"section_deg": 0.0, "direction": "y", "length_mm": null, "width_mm": null, "signal": 0.14, "angle_information": 1.1, "angle_information_error": 0.05,
                        "depth_information": 13.0, "effective_independence": 0.9, "pivot_rank": 1, "centre_std": 0.03}],
        "agreement": [{"first": "angle information", "second": "variance at the centre", "tau": 0.33}],
    })
}

/// What layouts show together.
pub fn layout_findings() -> Value {
    let of_candidates = candidates();
    json!({
        "level": "standard", "unit": "strain", "coarser_level": "coarse",
        "loads": [{"depth_mm": 1.0, "load_n": 13.1, "force_slope_n_per_mm": 17.6,
                   "knees": [{"section_deg": 0.0, "films": ["x", "y"], "units": 24, "dense_deg": 0.75, "of_60_deg": 72.0}]}],
        "front": [{"film_count": 12, "simulated_p95_angle_error_deg": 65.0, "index": 0}], "tau_of_bound": 0.8,
        "candidates": of_candidates["candidates"], "agreement": of_candidates["agreement"], "rings": [],
    })
}

/// A film's signals: a reading, and what its curve shows.
pub fn signals() -> Value {
    let film = json!({"tire": "own", "film": "coupled", "position": "crown", "direction": "x"});
    let of_film = |more: Value| {
        let mut row = film.clone();
        for (name, value) in more.as_object().into_iter().flatten() {
            row[name] = value.clone();
        }
        row
    };
    json!({
        "rows": [of_film(json!({
            "over": "load", "load_n": 13.0, "pressure_mpa": 0.2, "contact_deg": 0.0, "depth_mm": 0.99, "strain": 0.00028,
            "tension_1_n_per_mm": 0.071, "charge_nc": 1.86, "open_circuit_v": 18.98, "output_v": 18.98, "output_std_v": 0.01, "state": "ok",
            "error": {"strain": 0.0003, "charge_nc": 0.4, "open_circuit_v": 4.1, "output_v": 4.1},
        }))],
        "curves": [of_film(json!({"over": "load", "slope": 0.61, "monotone": "up", "monotone_certain": false, "linear_r2": 0.93}))],
        "pairs": [{"tire": "own", "film": "bare", "direction": "y", "contact_deg": [0.0, 30.0], "values": [0.0, 41.0], "monotone": "up", "linear_r2": null}],
        "widths": [{"tire": "own", "load_n": 13.0, "depth_mm": 0.99, "amplitude_mpa": 0.11, "width_deg": 6.1, "offset_mpa": 0.03, "r2": 0.998}],
        "claims": [of_film(json!({"claim": "voltage rises with load", "holds": "uncertain", "detail": "from 15 to 20 N the change is within its error"}))],
    })
}

fn strain() -> Value {
    json!({"name": "P3", "theta_deg": 0.0, "strain_x": 0.0202, "strain_y": 0.0846, "von_mises_mpa": 0.147})
}

/// A solved point.
pub fn evaluation() -> Value {
    json!({
        "ordinal": 0, "key": SHA256, "level": "draft", "values": [1.0, 1.0], "reaction_n": 13.39, "locations": [strain()], "newton_iterations": 14,
        "wall_s": 0.07,
    })
}

/// A point of a study, as its stream tells it.
pub fn event() -> Value {
    let data = json!({"kind": "point-solved", "time": "2026-11-22T01:02:03.456Z", "ordinal": 3, "done": 4, "of": 10, "wall_s": 0.07, "newton_iterations": 5});
    json!({"id": "17", "event": "point-solved", "data": data.to_string()})
}

/// A layer of a map of one point.
pub fn map() -> Value {
    json!({
        "direction": "x", "input": "P3", "theta_deg": [0.0], "phi_deg": [0.0], "first_order": [0.883], "total": null, "std": [0.0109], "strain": [0.0202],
        "error": [0.002], "status": ["ok"],
    })
}

/// An answer in a sentence.
fn answer() -> Value {
    let tied = "Rank 2 can't be told from it: by the angle's error times the root of the number of films, which the order goes by, it has 45.2 +- 7.1 \
                and rank 2, 12 units of x and y at the shoulder, every 30 degrees, 57 +- 32.";
    json!({
        "sentence": "Glue films of x and y at the crown, 12 units every 30 degrees: in 95 of 100 contacts they know the contact angle to 9.2 +- 1.4 degrees \
                     at the worst load.",
        "verdict": "tied", "reason": tied,
        "place": {"names": ["P3"], "direction": "x", "index": 0.729, "error": 0.029, "verdict": "certain",
                  "reason": "Ranked by the indices of its own depth for both strains, added up, P3 has 128.2 +- 9.7 % and P2 and P4 33.6 +- 6.3 %, \
                             which is more than the errors can explain.",
                  "sentence": "P3 tells most: the depth below P3 makes 72.9 +- 2.9 % of the variance of the x strain at the contact centre."},
        "layout": {"rank": 1, "words": "12 units of x and y at the crown, every 30 degrees", "units": 12, "film_count": 24, "angle_error_deg": 9.23,
                   "error_deg": 1.45, "tied_with": [2], "verdict": "tied", "reason": tied},
        "left_out": {"what": "friction", "why": "contact.friction is 0; its effect is that of 0.5", "effect": 0.063,
                     "sentence": "The model leaves out friction, which would change a strain by 6.3 %."},
        "surer": {"sentence": "The reference mesh would leave some 55 % of the mesh's claimed error in the indices, and the layouts as they are: 1.7 times the \
                               work of this study, about 33 s here.",
                  "level": "reference", "times": 1.7, "expected_s": 32.9},
    })
}

/// A result, with one of each of its lists.
pub fn result() -> Value {
    json!({
        "study": {"id": ID, "name": "two depths", "spec_sha256": SHA256, "version": "strainsite 0.1.0"},
        "answer": answer(),
        "model": {"dimension": "3d-half", "level": "draft", "elements": 600, "dofs": 2610,
                  "modelled": [{"what": "contact", "why": "rigid ground, penalty on the vertical gap"}], "left_out": []},
        "inputs": [{"name": "P3", "vary": "ground.depths_mm[2]", "distribution": {"kind": "uniform", "min": 0.7, "max": 1.3}}],
        "outputs": [{"location": "P3", "direction": "x", "mean": 0.0201, "std": 0.0109, "first_order": [0.883], "total": [0.883],
                     "method": "mdrm", "status": "ok",
                     "error": {"mesh": null, "quadrature": 1e-5, "decomposition": 0.001, "total": 0.00101, "reason": "a draft doesn't know its mesh's error"}}],
        "locations": [location()], "layouts": [layout()], "map": null,
        "notes": ["The errors of the indices leave out the mesh."],
        "graded_notes": [{"grade": "bears-on-figure", "about": "indices", "text": "The errors of the indices leave out the mesh."}], "failed_points": [],
        "cut_point": {"values": [1.0], "reaction_n": 13.39, "inflated_outer_radius_mm": 50.39, "locations": [strain()], "residual_history": [[0.6, 0.003, 2e-9]]},
        "cost": {"solves": 10, "reused": 0, "newton_iterations": 40, "wall_s": 0.2, "cpu_s": 0.3, "peak_memory_bytes": 36_000_000,
                 "factorisation_share": 0.2, "assembly_share": 0.3, "other_share": 0.5},
        "estimate": estimate(),
    })
}

/// The first rows of a table.
pub fn csv() -> &'static str {
    "rank,name,input,gsi_x_percent,gsi_y_percent\n1,P3,P3,72.86,55.33\n"
}

/// The beginning of a Parquet file.
pub fn parquet() -> &'static str {
    "PAR1"
}

/// The beginning of a map's file.
pub fn vtu() -> &'static str {
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
}

/// The beginning of a glTF file.
pub fn glb() -> &'static str {
    "glTF"
}

/// The header of a surface, after its length.
pub fn surface() -> &'static str {
    "{\"study\":\"019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6b\",\"level\":\"draft\",\"rows\":21,\"columns\":30,\"phi_deg\":[-120.0],\"theta_deg\":[-180.0],\"ground\":{\"x_mm\":[-50.0],\"z_mm\":[-49.0]},\"arrays\":[{\"name\":\"inner_inflated_mm\",\"unit\":\"mm\",\"components\":3,\"offset\":0,\"count\":630}]}"
}

/// A map of one place along an input.
pub fn sections() -> Value {
    json!({
        "input": "P3", "vary": "ground.depths_mm[2]", "theta_deg": [0.0], "phi_deg": [0.0], "inflated_mm": [[0.0, 0.0, -47.4]],
        "nodes": [{"value": 1.0, "ordinal": 0, "cut_point": true, "reaction_n": 13.39, "strain_x": [0.0202], "strain_y": [0.087], "displacement_mm": [[0.0, 0.0, 0.93]]}],
        "failed": [{"value": 1.3, "reason": "limit-point: the tire buckles at a depth of 1.2 mm"}],
    })
}

/// Strains around the wheel at four places.
pub fn rings() -> Value {
    json!({"unit": "strain", "rings": [{
        "section_deg": 0.0, "load": {"depth_mm": 1.0, "load_n": 13.4}, "theta_deg": [-180.0, -90.0, 0.0, 90.0], "strain_x": [0.0, 0.001, 0.02, 0.001], "strain_y": null,
        "slope_x_per_mm": [0.0, 0.001, 0.015, 0.001], "slope_y_per_mm": null,
    }]})
}

/// A layout that somebody moves by hand.
pub fn hand_layouts() -> Value {
    json!({"layouts": [{"name": "mine", "films": [
        {"theta_deg": 0.0, "phi_deg": 0.0, "angle_deg": 90.0}, {"theta_deg": 40.0, "phi_deg": 0.0, "angle_deg": 0.0},
    ]}], "simulated": true})
}

/// The same as TOML.
pub fn hand_layouts_toml() -> &'static str {
    "simulated = true\n[[layouts]]\nname = \"mine\"\nfilms = [{ theta_deg = 0, phi_deg = 0, angle_deg = 90 }, { theta_deg = 40, phi_deg = 0, angle_deg = 0 }]\n"
}

/// Its scores.
pub fn scored_layouts() -> Value {
    let mut layout = layout();
    layout["name"] = "mine".into();
    layout["spacing_deg"] = Value::Null;
    layout["units"] = 2.into();
    layout["film_count"] = 2.into();
    layout["places"] = hand_layouts()["layouts"][0]["films"].take();
    json!({"layouts": [layout]})
}

/// What films read, at four places.
pub fn film_fields() -> Value {
    json!({
        "unit": "strain", "size_mm": null, "noise": {"floor": 0.0017, "gain_std": 0.0, "place_std_deg": 0.0},
        "kinds": [{"phi_deg": 0.0, "angle_deg": 0.0}],
        "loads": [{"depth_mm": 1.0, "load_n": 13.4, "force_slope_n_per_mm": 17.2, "signals": [[0.0, 0.001, 0.02, 0.001]], "slopes_per_mm": [[0.0, 0.001, 0.015, 0.001]]}],
    })
}

/// A study without layouts.
pub fn no_layouts() -> Value {
    json!({
        "type": "about:blank", "title": "Conflict", "status": 409, "request_id": ID,
        "detail": "the study asked for no layouts, so that nothing around the wheel is stored: add \"layouts\" to its document and run it again",
    })
}

/// A trade of one rung.
pub fn trade() -> Value {
    let rung = json!({
        "label": "draft mdrm 3", "fidelity": {"level": "draft", "method": "mdrm", "nodes": 3, "check_points": 5}, "wall_s": 0.2, "cpu_s": 0.24,
        "solves": 16, "error_true": 0.0235, "error_claimed": 0.1051, "covered": 1.0, "ranking_agrees": true, "pareto": true, "indices": [],
    });
    json!({"study": "two depths", "spec_sha256": SHA256, "reference": rung, "rungs": [rung]})
}

/// A shipped document.
pub fn preset() -> Value {
    json!({"name": "two-depths", "title": "two depths", "document": study(), "comment": "A small study."})
}

/// Something that isn't there.
pub fn absent() -> Value {
    json!({"type": "about:blank", "title": "Not Found", "status": 404, "detail": "there is no study \"x\"", "request_id": ID})
}

/// A study that goes with its sweep alone.
pub fn design() -> Value {
    json!({"type": "about:blank", "title": "Conflict", "status": 409, "detail": "the study is a design of the sweep x: remove that, DELETE /v1/sweeps/x?purge", "request_id": ID})
}

/// Somebody without the token.
pub fn locked() -> Value {
    json!({"type": "about:blank", "title": "Unauthorized", "status": 401, "detail": "this service asks for its token", "request_id": ID})
}

/// More than a service takes on.
pub fn crowded() -> Value {
    json!({
        "type": "about:blank", "title": "Too Many Requests", "status": 429,
        "detail": "at most 20000 studies may wait: send it again when some are done", "request_id": ID,
    })
}

/// A service that can't work.
pub fn unready() -> Value {
    json!({
        "type": "about:blank", "title": "Service Unavailable", "status": 503, "detail": "the database does not answer; the service's log says why",
        "request_id": ID,
    })
}

/// A document with a fault.
pub fn faults() -> Value {
    json!({
        "type": "about:blank", "title": "Unprocessable Entity", "status": 422, "detail": "the document has one fault",
        "errors": [{"pointer": "/method/nodes", "detail": "must be a whole number from 1 to 65; it is 0"}], "request_id": ID,
    })
}

#[cfg(test)]
mod tests {
    use placement::ladder::trade::Trade;
    use placement::layout::by_hand::film_fields::FilmFields;
    use placement::result::{Estimate, Signals, StudyResult};
    use placement::study::Study;
    use serde::de::DeserializeOwned;

    use super::super::preview_wire::Preview;
    use super::super::study_wire as wire;
    use super::*;
    use crate::views::point_views::EvaluationView;
    use crate::views::rings::Rings;
    use crate::views::sections::Sections;
    use crate::wire::layout_wire::{HandLayoutsDocument, ScoredLayouts};
    use placement::study::presets;

    fn reads<T: DeserializeOwned>(example: Value) {
        serde_json::from_value::<T>(example.clone())
            .unwrap_or_else(|error| panic!("{}: {error}: {example}", std::any::type_name::<T>()));
    }

    #[test]
    fn examples_are_of_their_types() {
        reads::<wire::StudySummary>(summary());
        reads::<wire::StudyDetail>(detail());
        reads::<EvaluationView>(evaluation());
        reads::<wire::StreamEvent>(event());
        reads::<wire::MapView>(map());
        reads::<wire::Preset>(preset());
        reads::<wire::StudyDocument>(study());
        reads::<Estimate>(estimate());
        reads::<Preview>(preview());
        reads::<Rings>(rings());
        reads::<HandLayoutsDocument>(hand_layouts());
        reads::<ScoredLayouts>(scored_layouts());
        reads::<FilmFields>(film_fields());
        reads::<Sections>(sections());
        reads::<StudyResult>(result());
        reads::<Trade>(trade());
        reads::<Signals>(signals());
    }

    /// A canonical document has every field: the description knows them all.
    #[test]
    fn shipped_studies_are_of_the_described_type() {
        let refuse = |path: &str| Err(path.to_owned());
        for (name, text) in presets() {
            let study = Study::from_document(text, Format::Toml, &refuse).expect(name);
            let canonical: Value = serde_json::from_str(&study.canonical()).expect("JSON");
            reads::<wire::StudyDocument>(canonical);
        }
    }

    #[test]
    fn the_example_study_is_valid() {
        let refuse = |path: &str| Err(path.to_owned());
        for (text, format) in [
            (study_toml().to_owned(), Format::Toml),
            (study().to_string(), Format::Json),
        ] {
            Study::from_document(&text, format, &refuse).expect("a valid study");
        }
    }
}
