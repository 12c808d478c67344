//! Do the claimed errors of differences between designs cover the true ones, and how much less are they than those of the indices? Six designs
//! on the coarse and the standard mesh against the same on the reference mesh, by the same method, so that what differs is the mesh; and on the coarse
//! mesh against all 3125 combinations of the nodes on that mesh, so that what differs is the method. The tables of `docs/proof/claims.md`.
//!
//! `cargo run --release -p lab --example differences`, three minutes on two cores; with `-- method`, ten.

use std::sync::atomic::AtomicBool;

use document::{Format, parse};
use documents::study::plan::Plan;
use documents::study::{Study, presets};
use documents::sweep::{Design, MOST_DESIGNS, Sweep};
use estimation::error_metrics::order_statistics::upper_median;
use fem_client::solver::direction::PerDirection;
use lab::all_cores::cores;
use placement::compare::{
    Comparable, ComparedIndex, ComparedLocation, Comparison, Entry, Verdict, compare,
};
use placement::ladder::climb::answer;
use placement::points::RunContext;
use placement::points::memory::MemoryArchive;
use results::StudyResult;
use results::location_scores::{Figure, LocationScores};
use serde_json::{Value, json};
use tire::embedded::EmbeddedSolver;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "| level | differences | largest true error | claims that cover it | median claimed | as if independent | called real | of these of the wrong sign |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    if std::env::args().any(|argument| argument == "method") {
        return of_method();
    }
    let grid = json!({"geometry.wall_mm": [2.5, 3, 3.5], "pressure.internal_mpa": [0.15, 0.2]});
    let truth = designs("reference", &own_method(1), &grid, |_| ())?;
    for level in ["coarse", "standard"] {
        let found = designs(level, &own_method(1), &grid, |_| ())?;
        println!(
            "| {level} | {} |",
            row(&compare(&found, None), &compare(&truth, None))
        );
    }
    Ok(())
}

/// Three designs on one mesh, four draws of the check points; the mesh's part of the errors is left out.
fn of_method() -> Result<(), Box<dyn std::error::Error>> {
    let grid = json!({"geometry.wall_mm": [2.5, 3, 3.5]});
    let tensor = json!({"kind": "tensor", "nodes": 5});
    let truth = designs("coarse", &tensor, &grid, |_| ())?;
    let truth = compare(&truth, None);
    for seed in 1..=4 {
        let found = designs("coarse", &own_method(seed), &grid, leave_mesh_out)?;
        println!("| seed {seed} | {} |", row(&compare(&found, None), &truth));
    }
    Ok(())
}

fn own_method(seed: u64) -> Value {
    json!({"kind": "mdrm", "nodes": 5, "check_points": 5, "seed": seed})
}

/// Leaves the mesh's error out, as if the mesh were exact.
fn leave_mesh_out(result: &mut StudyResult) {
    let centre = result.outputs.len() / 4 * 2;
    let outputs = result.outputs[centre..]
        .iter()
        .map(|output| output.error.mesh);
    let of_mesh: Vec<f64> = outputs
        .take(2)
        .map(|mesh| 100.0 * mesh.unwrap_or(0.0))
        .collect();
    let of_mesh = PerDirection {
        x: of_mesh[0],
        y: of_mesh[1],
    };
    for location in &mut result.locations {
        let with_mesh = location.scores.clone();
        location.scores = LocationScores::of(|score, direction| {
            let figure = with_mesh.of_score(score)[direction];
            let without = |error: f64| (error - of_mesh[direction]).max(0.0);
            Figure {
                error: figure.error.map(without),
                ..figure
            }
        });
    }
    for output in &mut result.outputs {
        output.error.mesh = Some(0.0);
        if let (Some(coarser), Some(own)) = (&mut output.coarser, &output.first_order) {
            coarser.first_order.clone_from(own);
        }
    }
}

/// Every design of the grid, which are compared with the first; of each result so much is changed.
fn designs(
    level: &str,
    method: &Value,
    grid: &Value,
    change: fn(&mut StudyResult),
) -> Result<Vec<Entry>, Box<dyn std::error::Error>> {
    let (_, text) = presets()[0];
    let mut study = parse(text, Format::Toml).map_err(|faults| format!("{faults:?}"))?;
    study["candidates"] = json!({"points": "P1-P5"});
    study["layouts"] = json!({"spacings_deg": []});
    study["accuracy"] = json!({"preset": level});
    study["method"] = method.clone();
    let document = json!({"study": study, "grid": grid});
    let sweep = Sweep::from_value(&document, MOST_DESIGNS, &|path| Err(path.to_owned()))
        .map_err(|faults| format!("{faults:?}"))?;
    let entry = |design| entry(design, change);
    sweep.designs.iter().map(entry).collect()
}

fn entry(
    design: &Design,
    change: fn(&mut StudyResult),
) -> Result<Entry, Box<dyn std::error::Error>> {
    let mut result = solved(&design.study)?;
    change(&mut result);
    Ok(Entry {
        id: design.name.clone(),
        name: design.name.clone(),
        set: None,
        state: "done".to_owned(),
        result: Ok(Comparable::of(&result)),
    })
}

fn solved(study: &Study) -> Result<StudyResult, Box<dyn std::error::Error>> {
    let context = RunContext {
        solver: &EmbeddedSolver::default(),
        archive: &MemoryArchive::default(),
        threads: cores(),
        stop: &AtomicBool::new(false),
        pause: None,
        observer: &|_| (),
    };
    Ok(answer(study, &Plan::new(study)?, context)?)
}

/// Each index beside the same one of another table.
fn pairs<'c>(
    own: &'c Comparison,
    other: &'c Comparison,
    study: fn(&'c Comparison, &'c str) -> Option<&'c str>,
) -> Vec<(&'c ComparedIndex, &'c ComparedIndex)> {
    let twin = |row: &'c ComparedLocation| {
        let id = study(other, &row.study)?;
        let mut rows = other.rows.iter();
        rows.find(|twin| twin.study == id && twin.location == row.location)
    };
    let found = own.rows.iter().filter_map(|row| Some((row, twin(row)?)));
    found
        .flat_map(|(row, twin)| [(&row.x, &twin.x), (&row.y, &twin.y)])
        .collect()
}

/// Figures in percentage points.
fn row(own: &Comparison, truth: &Comparison) -> String {
    let with_truth = pairs(own, truth, |_, study| Some(study));
    let with_baseline = pairs(own, own, |own, _| own.baseline.as_deref());
    let (mut errors, mut claims, mut apart) = (Vec::new(), Vec::new(), Vec::new());
    let (mut held, mut real, mut wrong) = (0, 0, 0);
    for ((found, truth), (_, base)) in with_truth.into_iter().zip(with_baseline) {
        let (Some(difference), Some(claimed), Some(true_difference)) = (
            found.difference_percent,
            found.difference_error_percent,
            truth.difference_percent,
        ) else {
            continue;
        };
        let is_real = found.verdict == Some(Verdict::Real);
        let error = (difference - true_difference).abs();
        held += usize::from(error <= claimed);
        real += usize::from(is_real);
        wrong += usize::from(is_real && difference * true_difference < 0.0);
        apart.extend(
            found
                .error_percent
                .zip(base.error_percent)
                .map(|(a, b)| a.hypot(b)),
        );
        errors.push(error);
        claims.push(claimed);
    }
    format!(
        "{} | {:.2} | {held} | {:.2} | {:.2} | {real} | {wrong}",
        errors.len(),
        errors.iter().copied().fold(0.0, f64::max),
        upper_median(claims).unwrap_or(f64::NAN),
        upper_median(apart).unwrap_or(f64::NAN),
    )
}
