//! The shipped study of forces on a closed form in the place of its tire: films for tests.

use documents::layouts::layout_settings::Layouts;
use documents::rig::rig_settings::RigSettings;
use documents::study::plan::PlannedStudy;
use fem_client::closed_form::ClosedFormSolver;
use fem_client::scene::Level;
use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use placement::points::memory::MemoryArchive;
use placement::response_table::laid_films::LaidFilms;
use placement::response_table::study_table::StudyTable;

use crate::study_runs::{study_on, undisturbed};

/// The closed form, which presses to depths, with the depths of its own loads: 13 N at 1 mm, with the power of 1.3.
struct PressedByLoad;

impl Solver for PressedByLoad {
    fn version(&self) -> String {
        "pressed by load".to_owned()
    }

    fn solve(&self, request: &SolveRequest<'_>) -> Result<Solved, SolveError> {
        let mut scene = request.scene.clone();
        if let Some(load_n) = scene.ground.load_n.take() {
            scene.ground.stations = 1;
            scene.ground.depths_mm = vec![(load_n / 13.0).powf(1.0 / 1.3)];
        }
        ClosedFormSolver::new().solve(&SolveRequest {
            scene: &scene,
            ..*request
        })
    }
}

/// Tests so many y-films around the crown, on ground without friction, and their rig. A film feels contacts up to 9 degrees off or so.
pub(crate) fn with_films(films: usize, test: impl FnOnce(&LaidFilms<'_>, &RigSettings)) {
    let mut study = study_on("forces", Level::Draft).study;
    study.scene.contact.friction = 0.0;
    study.layouts = Layouts {
        units: vec![films],
        directions: vec![vec![90.0]],
        ..study.layouts
    };
    let PlannedStudy { study, plan } = PlannedStudy::new(study).expect("a plan");
    let rig = RigSettings::default();
    let table = StudyTable::of(&study, &rig, &plan).expect("loads");
    let archive = MemoryArchive::default();
    let solved = table.solved(&plan, undisturbed(&PressedByLoad, &archive));
    let tested = solved.expect("solves").expect("a table");
    let films = &table.layouts[0].arrangement.films;
    test(&table.laid(&tested, films), &rig);
}
