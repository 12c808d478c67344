//! Cases whose answer is known.

use serde_json::Value;

use crate::program::{strainsite, text};

#[test]
fn verification_compares_with_known_answers_and_shows_its_convergence() {
    let folder = tempfile::tempdir().expect("temp dir");
    let families = [
        "--only",
        "homogeneous",
        "--only",
        "cylinder",
        "--only",
        "cook",
    ];
    let arguments: Vec<&str> = ["verify", "--json", "-"]
        .into_iter()
        .chain(families)
        .collect();
    let output = strainsite(folder.path(), &arguments);
    let table = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{table}");
    let document: Value =
        serde_json::from_slice(&output.stdout).expect("one JSON document and nothing else");
    let cases = document["cases"].as_array().expect("cases");
    let named = |name: &str| {
        let case = cases
            .iter()
            .find(|case| case["name"].as_str() == Some(name));
        case.unwrap_or_else(|| panic!("no case {name:?} in {table}"))
    };
    let cylinder = named("cylinder 9.5/12.5, stretch 2, 9-node: pressure, MPa");
    assert_eq!(cylinder["expected"], 0.08944068511004151);
    for case in cases {
        assert_eq!(case["verdict"], "pass", "{case}");
        let (error, tolerance) = (case["error"].as_f64(), case["tolerance"].as_f64());
        assert!(
            error.expect("an error") <= tolerance.expect("a tolerance"),
            "{case}"
        );
        assert!(
            case["source"]
                .as_str()
                .is_some_and(|source| !source.is_empty())
        );
    }
    // Twice the degree, halfway to the next lower order at least.
    assert!(cylinder["slope"]["observed"].as_f64().expect("a slope") > 3.5);
    assert!(
        table.contains("| case ") && table.contains(" pass "),
        "{table}"
    );

    let unknown = strainsite(folder.path(), &["verify", "--only", "everything"]);
    assert_eq!(unknown.status.code(), Some(2));
}

/// Extremes, as they may be asked for, and the page that shows them.
#[test]
fn extremes_end_right_or_with_a_reason_and_the_page_shows_them_all() {
    let folder = tempfile::tempdir().expect("temp dir");
    let output = strainsite(folder.path(), &["verify", "--extremes", "--json", "-"]);
    let table = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{table}");
    let document: Value =
        serde_json::from_slice(&output.stdout).expect("one JSON document and nothing else");
    let cases = document["cases"].as_array().expect("cases");
    let page = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../docs/proof/extremes.md"
    ))
    .expect("the page");
    let rows = page.lines().filter(|line| line.starts_with("| "));
    let shown: Vec<&str> = rows
        .filter_map(|row| row.split(" | ").next()?.strip_prefix("| "))
        .map(str::trim)
        .collect();
    for case in cases {
        assert_eq!(case["verdict"], "pass", "{case}");
        assert!(
            case["computed"].is_number() && case["error"].is_number(),
            "{case}"
        );
        let name = case["name"].as_str().expect("a name");
        assert!(
            shown.contains(&name),
            "docs/proof/extremes.md lacks {name:?}"
        );
    }
    // Beside the cases the table has its head and the line below it.
    assert_eq!(
        shown.len(),
        cases.len() + 2,
        "docs/proof/extremes.md shows cases that aren't there any more"
    );
    let unknown = strainsite(folder.path(), &["verify", "--extremes", "--only", "cook"]);
    assert_eq!(unknown.status.code(), Some(2));
}
