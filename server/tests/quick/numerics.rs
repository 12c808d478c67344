//! Numerics of another machine: keys differ exactly where numbers do.

use std::path::Path;

use serde_json::Value;

use crate::program::{command, text};

/// Has the C library compute elementary functions as on a processor without these instructions.
pub(crate) const OTHER: &str = "glibc.cpu.hwcaps=-FMA,-AVX2,-AVX,-FMA4";

/// The shipped study on the draft mesh, without layouts, whose loads are solved as all points are, with these tunables of the C library.
fn result(folder: &Path, database: &str, tunables: &str) -> Value {
    let arguments = [
        "run",
        "foot-tire",
        "--set",
        "accuracy.preset=draft",
        "--set",
        "layouts.spacings_deg=[]",
        "--db",
        database,
        "--json",
        "-",
    ];
    let run = command(folder, &arguments)
        .env("GLIBC_TUNABLES", tunables)
        .output()
        .expect("the program runs");
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    serde_json::from_slice(&run.stdout).expect("JSON")
}

pub(crate) fn has_the_instructions() -> bool {
    let processor = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    processor.contains(" avx2 ") && processor.contains(" fma ")
}

#[test]
fn points_of_another_processor_are_not_taken_for_this_one_s() {
    if !has_the_instructions() {
        return eprintln!("skipped: this processor has no AVX2 to leave out");
    }
    let folder = tempfile::tempdir().expect("temp dir");
    let own = result(folder.path(), "own.db", "");
    let other = result(folder.path(), "other.db", OTHER);
    // Where the C library's functions come out the same, so do all numbers, and the points may be shared.
    let same = other["cut_point"] == own["cut_point"] && other["outputs"] == own["outputs"];
    let version = &other["study"]["version"];
    assert_eq!(version == &own["study"]["version"], same, "{version}");
    for (tunables, known) in [("", true), (OTHER, same)] {
        let again = result(folder.path(), "own.db", tunables);
        let reused = match known {
            true => again["cost"]["solves"].clone(),
            false => Value::from(0),
        };
        assert_eq!(again["cost"]["reused"], reused, "{tunables}");
    }
}
