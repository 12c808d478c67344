//! Version of a CalculiX point: it stands for the sources of deck, tire and kernel, and for nothing beside them.

use std::path::Path;
use std::time::Duration;

use calculix::CalculixSolver;
use fem_client::solver::Solver;

use crate::stand_in;

#[path = "../../../sources.rs"]
#[expect(dead_code, reason = "build scripts hash below their own package")]
mod sources;

/// Folders that determine a response, seen from the package.
const SOURCES: [&str; 3] = ["src", "../tire/src", "../../fem/src"];

#[test]
fn the_version_has_the_hash_of_deck_tire_and_kernel() {
    let folder = tempfile::tempdir().expect("a folder");
    let script = "#!/bin/sh\necho 'This is Version 9.9'\n";
    let program = stand_in::install(folder.path(), script);
    let solver = CalculixSolver::new(&program, Duration::ZERO).expect("says its version");
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let hash = sources::hash_below(package, &SOURCES).expect("reads");
    let version = solver.version();
    assert!(version.contains(" 9.9 "), "{version}");
    assert!(version.ends_with(&format!("+{hash}")), "{version}");
}
