//! Whole studies through the real program on the coarsest mesh: every method is killed and resumed, and a load without an
//! equilibrium costs its point alone.

mod program;

use std::path::Path;

use program::{spawn, stored_points, strainsite, text, wait_for_points};
use serde_json::Value;

/// Two depths of the foot tire; the method is the caller's.
fn two_depths(method: &str) -> String {
    let input = |name: &str, station: usize| {
        format!(
            "[[inputs]]\nname = \"{name}\"\nvary = \"ground.depths_mm[{station}]\"\n\
             distribution = {{ kind = \"uniform\", min = 0.7, max = 1.3 }}\n"
        )
    };
    format!(
        "name = \"two depths\"\nscene = {{ preset = \"foot-tire\" }}\n{}{}\
         [layouts]\nspacings_deg = [60]\npositions = [\"crown\"]\n\
         [method]\n{method}\n[accuracy]\npreset = \"draft\"\n",
        input("P2", 1),
        input("P3", 2)
    )
}

/// Runs a study to its end; its result without what it cost and which number it has.
fn result(folder: &Path, database: &str) -> (Value, Value) {
    let run = strainsite(
        folder,
        &["run", "study.toml", "--db", database, "--json", "-"],
    );
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let mut result: Value = serde_json::from_slice(&run.stdout).expect("JSON");
    let cost = result["cost"].take();
    result["study"]["id"] = Value::Null;
    (result, cost)
}

#[tokio::test]
async fn a_study_by_any_method_is_killed_and_resumed_to_the_same_bits() {
    for (kind, more) in [
        ("auto", "tolerance = 0.005"),
        ("tensor", "nodes = 3"),
        ("bivariate", "nodes = 3"),
        ("pce", "samples = 20"),
        ("saltelli", "samples = 2"),
    ] {
        let folder = tempfile::tempdir().expect("temp dir");
        let method = format!("kind = \"{kind}\"\n{more}");
        std::fs::write(folder.path().join("study.toml"), two_depths(&method)).expect("writes");
        let (undisturbed, cost) = result(folder.path(), "undisturbed.db");
        let points = cost["solves"].as_i64().expect("a count");

        let arguments = ["run", "study.toml", "--db", "killed.db", "--threads", "1"];
        let mut run = spawn(folder.path(), &arguments);
        let database = folder.path().join("killed.db");
        wait_for_points(&database, 4).await;
        // SIGKILL, the signal that a process can't prepare for.
        run.kill().expect("kills");
        run.wait().expect("ends");
        let kept = stored_points(&database).await;
        assert!(
            (4..points).contains(&kept),
            "{kind}: killed in the middle, with {kept} of {points}"
        );
        let (resumed, cost) = result(folder.path(), "killed.db");
        assert_eq!(
            (cost["reused"].as_i64(), cost["solves"].as_i64()),
            (Some(kept), Some(points)),
            "{kind}"
        );
        assert_eq!(resumed, undisturbed, "{kind}");
        println!("{kind}: {points} points, killed after {kept}");
    }
}
