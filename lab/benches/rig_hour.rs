//! Time of an hour of twelve films at 200 Hz, from the table of the shipped study of forces on its draft mesh, which is solved first.
//!
//!   cargo bench -p lab --bench rig_hour

use std::time::Instant;

use documents::rig::gait_settings::RunLength;
use documents::study::plan::PlannedStudy;
use fem_client::scene::Level;
use lab::study_runs::{study_on, undisturbed};
use placement::points::memory::MemoryArchive;
use placement::response_table::study_table::StudyTable;
use rig::rig_run::RigRun;
use tire::embedded::EmbeddedSolver;

const HOUR_S: f64 = 3600.0;
const ROUNDS: usize = 5;
/// The paper's layout.
const FILMS: usize = 12;

fn main() {
    let PlannedStudy { study, plan } = study_on("forces", Level::Draft);
    let mut rig = study.rig.clone().expect("a rig");
    let table = StudyTable::of(&study, &rig, &plan).expect("loads");
    let (solver, archive) = (EmbeddedSolver::default(), MemoryArchive::default());
    let solved = table.solved(&plan, undisturbed(&solver, &archive));
    let tested = solved.expect("solves").expect("a table");
    let layout = table
        .layouts
        .iter()
        .find(|layout| layout.arrangement.films.len() == FILMS)
        .expect("the paper's");
    let films = table.laid(&tested, &layout.arrangement.films);
    rig.gait.length = RunLength::Seconds(HOUR_S);
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let begun = Instant::now();
            let (_, readings) = RigRun::films_alone(&films, &rig, 0);
            assert_eq!(readings.volts.ncols(), FILMS);
            begun.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    println!(
        "an hour of {FILMS} films at {} Hz: {:.2} s, median of {ROUNDS} ({:.2} to {:.2})",
        rig.film_rate_hz,
        times[ROUNDS / 2],
        times[0],
        times[ROUNDS - 1]
    );
}
