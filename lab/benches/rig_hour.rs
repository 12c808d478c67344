//! How long an hour of twelve films at 200 Hz takes, from the table of the shipped study of forces on its draft mesh, which is solved first.
//!
//!   cargo bench -p lab --bench rig_hour

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use fem_client::document::Format;
use fem_client::scene::Level;
use placement::response_table::study_table::StudyTable;
use placement::rig::gait::gait_settings::RunLength;
use placement::rig::rig_run::RigRun;
use placement::run::RunContext;
use placement::run::memory::MemoryArchive;
use placement::study::plan::PlannedStudy;
use placement::study::presets;
use tire::embedded::EmbeddedSolver;

const HOUR_S: f64 = 3600.0;
const ROUNDS: usize = 5;
/// The paper's layout.
const FILMS: usize = 12;

fn main() {
    let no_files = |path: &str| Err(path.to_owned());
    let (_, text) = presets()
        .into_iter()
        .find(|(name, _)| *name == "forces")
        .expect("it ships");
    let mut study =
        placement::study::Study::from_document(text, Format::Toml, &no_files).expect("a study");
    study.level = Level::Draft;
    study.scene.model.level = Level::Draft;
    let planned = PlannedStudy::new(study).expect("a plan");
    let mut rig = planned.study.rig.clone().expect("a rig");
    let table = StudyTable::of(&planned.study, &rig, &planned.plan).expect("loads");
    let context = RunContext {
        solver: &EmbeddedSolver::default(),
        archive: &MemoryArchive::default(),
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        stop: &AtomicBool::new(false),
        pause: None,
        observer: &|_| {},
    };
    let tested = table
        .solved(&planned.plan, context)
        .expect("solves")
        .expect("a table");
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
