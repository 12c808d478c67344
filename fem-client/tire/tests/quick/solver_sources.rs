//! Version of the solver: it stands for the sources of `fem` and `tire`, and for nothing beside them.

use std::fs;
use std::io;
use std::path::Path;

use fem_client::solver::Solver;
use tire::embedded::EmbeddedSolver;

#[path = "../../../sources.rs"]
#[expect(dead_code, reason = "build scripts hash below their own package")]
mod sources;

/// Folders that determine a response, seen from the package.
const SOURCES: [&str; 2] = ["src", "../../fem/src"];
/// Folders whose sources are copied, seen from the repository.
const COPIED: [&str; 5] = [
    "fem/src",
    "fem-client/tire/src",
    "fem-client/calculix/src",
    "fem-client/verify/src",
    "fem-client/vtu/src",
];

/// The digits in a solver's version.
fn hash_in(version: &str) -> &str {
    version.rsplit_once('+').expect("a hash at its end").1
}

fn copy(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let target = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            copy(&entry.path(), &target)?;
        } else {
            fs::copy(entry.path(), target)?;
        }
    }
    Ok(())
}

/// The hash in a copy of the sources in which a file has a comment more.
fn hash_after_a_comment_in(file: &str) -> String {
    let repository = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let copied = tempfile::tempdir().expect("a folder");
    for folder in COPIED {
        copy(&repository.join(folder), &copied.path().join(folder)).expect("copies");
    }
    let path = copied.path().join(file);
    let text = fs::read_to_string(&path).expect("the file is there");
    fs::write(&path, text + "// A comment.\n").expect("writes");
    let package = copied.path().join("fem-client/tire");
    sources::hash_below(&package, &SOURCES).expect("reads")
}

#[test]
fn the_version_has_the_hash_of_the_kernel_s_and_the_tire_s_sources() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let hash = sources::hash_below(package, &SOURCES).expect("reads");
    assert_eq!(hash_in(&EmbeddedSolver::default().version()), hash);
}

#[test]
fn a_comment_beside_the_solver_leaves_its_version() {
    let version = EmbeddedSolver::default().version();
    for file in [
        "fem-client/calculix/src/lib.rs",
        "fem-client/verify/src/lib.rs",
        "fem-client/vtu/src/lib.rs",
    ] {
        assert_eq!(hash_after_a_comment_in(file), hash_in(&version), "{file}");
    }
}

#[test]
fn a_comment_in_the_solver_changes_its_version() {
    let version = EmbeddedSolver::default().version();
    for file in [
        "fem/src/newton/iteration.rs",
        "fem-client/tire/src/mesh/mod.rs",
    ] {
        assert_ne!(hash_after_a_comment_in(file), hash_in(&version), "{file}");
    }
}
