//! Worth of the figures of the paper's Table 2. The paper's study, solved: the indices that hold and M-DRM's, beside what was printed. The table of
//! `docs/proof/paper-choice/README.md`.
//!
//! `cargo run --release -p lab --example paper_table [-- LEVEL]`, standard when left out.

use documents::study::plan::PlannedStudy;
use fem_client::scene::Level;
use fem_client::solver::direction::Direction;
use lab::study_runs::{level_argument, study_on, undisturbed};
use placement::points::memory::MemoryArchive;
use placement::run::run;
use results::location_scores::{GSI, MDRM_GSI, Score};
use results::{RankedLocation, StudyResult};
use tire::embedded::EmbeddedSolver;

/// Table 2 of the paper: P1 to P5, x and y, %.
const PRINTED: [(&str, [f64; 2]); 5] = [
    ("P1", [1.4719, 0.0662]),
    ("P2", [6.1071, 9.4910]),
    ("P3", [29.9733, 32.1724]),
    ("P4", [6.6748, 10.1924]),
    ("P5", [1.5767, 0.0662]),
];
const DIRECTIONS: [(&str, Direction); 2] = [("x", Direction::X), ("y", Direction::Y)];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let level = level_argument(1, Level::Standard);
    let PlannedStudy { study, plan } = study_on("foot-tire-paper", level);
    let (solver, archive) = (EmbeddedSolver::default(), MemoryArchive::default());
    let result = run(&study, &plan, undisturbed(&solver, &archive))?;
    println!(
        "| location | x: holds | M-DRM, valid or not | the paper's Table 2 | y: holds | M-DRM, valid or not | the paper's Table 2 |"
    );
    println!("|---|---|---|---|---|---|---|");
    for (name, printed) in PRINTED {
        let place = location(&result, name);
        let cells = (0..2).map(|k| cells(place, DIRECTIONS[k].1, printed[k]));
        println!("| {name} |{}", cells.collect::<String>());
    }
    println!();
    for (column, (name, direction)) in DIRECTIONS.into_iter().enumerate() {
        let off = |score| furthest(&result, score, column, direction);
        let [mdrm, holds] = [MDRM_GSI, GSI].map(off);
        println!("{name}: {}", remark(mdrm, holds));
    }
    Ok(())
}

/// Says what M-DRM's numbers are worth beside the paper's, by how far they and those that hold are off, percentage points.
fn remark(mdrm: f64, holds: f64) -> String {
    let apart = format!(
        "M-DRM's column is within {mdrm:.1} points of the paper's Table 2, the indices that hold within {holds:.1}."
    );
    match mdrm < 5.0 && holds > 2.0 * mdrm {
        true => format!(
            "{apart} It is wrong here: the strain changes sign within the range of depths, so that M-DRM's product form is broken."
        ),
        false => apart,
    }
}

fn location<'r>(result: &'r StudyResult, name: &str) -> &'r RankedLocation {
    let mut locations = result.locations.iter();
    locations
        .find(|location| location.name == name)
        .expect("P1 to P5")
}

fn cells(place: &RankedLocation, direction: Direction, printed: f64) -> String {
    let [holds, mdrm] = [GSI, MDRM_GSI].map(|score| place.value(score, direction));
    [holds, mdrm, Some(printed)]
        .map(|value| {
            format!(
                " {} |",
                value.map_or("-".to_owned(), |it| format!("{it:.2}"))
            )
        })
        .concat()
}

/// The largest difference from the printed column, percentage points.
fn furthest(result: &StudyResult, score: &Score, column: usize, direction: Direction) -> f64 {
    let apart = PRINTED.map(|(name, printed)| {
        let index = location(result, name).value(score, direction);
        (index.expect("an index") - printed[column]).abs()
    });
    apart.into_iter().fold(0.0, f64::max)
}
