//! Films' signals on the command line.

use crate::program::{strainsite, text};
use serde_json::Value;

const STUDY: &str = "name = \"films\"\nscene = { preset = \"foot-tire\" }\n\
    [[inputs]]\nname = \"P3\"\nvary = \"ground.depths_mm[2]\"\ndistribution = { kind = \"uniform\", min = 0.7, max = 1.3 }\n\
    [layouts]\nspacings_deg = []\n\
    [method]\nkind = \"mdrm\"\nnodes = 3\ncheck_points = 0\n[accuracy]\npreset = \"draft\"\n\
    [signals]\nloads_n = [5, 10]\npressures_mpa = [0.2]\ncontact_deg = [0, 10]\npositions = [\"crown\"]\ndirections = [\"y\"]\nfilms = [\"bare\"]\n";

#[test]
fn signals_are_told_in_a_table_written_and_drawn() {
    let folder = tempfile::tempdir().expect("temp dir");
    std::fs::write(folder.path().join("films.toml"), STUDY).expect("writes");
    let dry = strainsite(folder.path(), &["run", "films.toml", "--dry-run"]);
    assert!(
        text(&dry.stdout).contains("3 for films' signals"),
        "{}",
        text(&dry.stdout)
    );
    let ran = strainsite(folder.path(), &["run", "films.toml", "--out", "answer"]);
    let said = text(&ran.stdout);
    assert_eq!(ran.status.code(), Some(0), "{said}{}", text(&ran.stderr));
    assert!(
        said.contains("does the voltage rise with the load"),
        "{said}"
    );
    assert!(said.contains("crown      y"), "{said}");
    assert!(said.contains("3 for films' signals"), "{said}");
    let read = |name: &str| {
        let file = folder.path().join("answer").join(name);
        std::fs::read_to_string(file).expect("is there")
    };
    assert_eq!(read("signals.csv").lines().count(), 1 + 2 + 1 + 2);
    assert!(read("figure-4.svg").contains("contact angle, degrees"));
    assert!(read("figure-5.svg").contains("pressure, MPa"));
    let result: Value = serde_json::from_str(&read("result.json")).expect("JSON");
    let id = result["study"]["id"].as_str().expect("an identifier");
    let shown = strainsite(folder.path(), &["show", id]);
    assert!(text(&shown.stdout).contains("does the voltage rise with the load"));
}
