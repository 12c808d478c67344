//! `strainsite gsa run`: a model that another program serves is planned for, asked, stored and analysed, whatever its server does.

use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use serde_json::json;

use super::toy_server::{Answer, Toy, both, output, reply};
use super::{answer, write_inputs};
use crate::program::service::sql;
use crate::program::{spawn, stored_runs, strainsite, text};

/// Time far beyond what any of these runs takes.
const PATIENCE: Duration = Duration::from_secs(60);

/// Runs the command with these arguments behind the server's address.
fn run(at: &Path, toy: &Toy, arguments: &[&str]) -> Output {
    let mut all = vec!["gsa", "run", "inputs.toml", "--model", &toy.url];
    all.extend(arguments);
    strainsite(at, &all)
}

fn done(output: &Output) -> &str {
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    text(&output.stdout)
}

/// Returns what a command that ends with this code says.
fn refused(output: &Output, code: i32) -> &str {
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{said}");
    said
}

/// The document of `gsa analyse`, after `gsa plan` round by round.
fn planned_and_analysed(at: &Path) -> String {
    let mut values = "id,y1,y2\n".to_owned();
    let mut plan = vec!["gsa", "plan", "inputs.toml"];
    while answer(done(&strainsite(at, &plan)), &mut values) > 0 {
        std::fs::write(at.join("told.csv"), &values).expect("writes");
        plan.truncate(3);
        plan.extend(["--values", "told.csv"]);
    }
    analysed(at, "told.csv")
}

fn analysed(at: &Path, values: &str) -> String {
    let analyse = ["gsa", "analyse", "inputs.toml", values, "--json", "-"];
    done(&strainsite(at, &analyse)).to_owned()
}

#[test]
fn indices_are_those_of_plan_and_analyse_and_nothing_is_asked_for_twice() {
    for method in ["kind = \"mdrm\"", "kind = \"auto\""] {
        let folder = tempfile::tempdir().expect("temp dir");
        let (at, toy) = (folder.path(), Toy::start());
        write_inputs(at, method);
        let expected = planned_and_analysed(at);
        let arguments = ["--at-once", "8", "--json", "-", "-o", "values.csv"];
        assert_eq!(done(&run(at, &toy, &arguments)), expected);
        assert_eq!(analysed(at, "values.csv"), expected);
        let asked = toy.asked();
        assert!(
            asked.len() > 10 && asked.iter().all(|count| *count == 1),
            "{asked:?}"
        );

        let again = run(at, &toy, &["--json", "-"]);
        assert_eq!(done(&again), expected);
        let known = format!("{0} runs, {0} of them known before", asked.len());
        assert!(
            text(&again.stderr).contains(&known),
            "{}",
            text(&again.stderr)
        );
        assert_eq!(toy.count(), 0);
        // Other settings are another model, and those in another order aren't.
        for (config, more) in [
            (r#"{"a": 1, "b": 2}"#, asked.len()),
            (r#"{"b": 2, "a": 1}"#, 0),
        ] {
            done(&run(at, &toy, &["--config", config, "--at-once", "4"]));
            assert_eq!(toy.asked().len(), more, "{config}");
        }
        // Another document has some points in common.
        write_inputs(at, "kind = \"mdrm\"\nnodes = 9");
        done(&run(at, &toy, &["--at-once", "4"]));
        let points = text(&strainsite(at, &["gsa", "plan", "inputs.toml"]).stdout)
            .lines()
            .count()
            - 1;
        let more = toy.asked().len();
        assert!((1..points).contains(&more), "{more} of {points}");
    }
}

/// Alters an output of a database's first run.
#[tokio::main(flavor = "current_thread")]
async fn damage(database: &Path) {
    let change = "update model_runs set outputs = '[1.0,2.0]' where rowid = 1";
    let changed = sqlx::query(change).execute(&mut sql(database).await).await;
    assert_eq!(changed.expect("changes").rows_affected(), 1);
}

#[test]
fn outputs_are_told_by_name_and_points_go_with_a_merge() {
    let folder = tempfile::tempdir().expect("temp dir");
    let (at, toy) = (folder.path(), Toy::start());
    write_inputs(at, "kind = \"mdrm\"");
    let named = run(at, &toy, &["--outputs", "height, width", "--db", "one.db"]);
    let said = done(&named);
    assert!(
        said.starts_with("height: ") && said.contains("\nwidth: "),
        "{said}"
    );
    let asked = toy.asked().len();
    let merge = ["db", "merge", "one.db", "--db", "all.db"];
    let merged = strainsite(at, &merge);
    assert!(
        done(&merged).contains(&format!("one.db: {asked} runs of models\n")),
        "{}",
        done(&merged)
    );
    done(&run(at, &toy, &["--db", "all.db"]));
    assert_eq!(toy.count(), 0);
    let checked = strainsite(at, &["db", "check", "--db", "all.db"]);
    assert!(
        done(&checked).contains(&format!(" {asked} model runs")),
        "{}",
        done(&checked)
    );

    damage(&at.join("all.db"));
    let checked = strainsite(at, &["db", "check", "--db", "all.db"]);
    assert_eq!(checked.status.code(), Some(1));
    assert!(
        text(&checked.stdout).contains("table model_runs is damaged"),
        "{}",
        text(&checked.stdout)
    );
}

#[test]
fn a_merge_takes_what_failed_here_and_refuses_other_outputs() {
    let folder = tempfile::tempdir().expect("temp dir");
    let (at, toy) = (folder.path(), Toy::start());
    write_inputs(at, "kind = \"mdrm\"");
    done(&run(at, &toy, &["--db", "one.db"]));
    let asked = toy.asked().len();
    toy.answer(|_, _| reply(400, r#"{"error": {"type": "No", "message": "no"}}"#));
    done(&run(at, &toy, &["--db", "failed.db"]));
    let merged = strainsite(at, &["db", "merge", "one.db", "--db", "failed.db"]);
    assert!(
        done(&merged).contains(&format!("one.db: {asked} runs of models\n")),
        "{}",
        done(&merged)
    );
    toy.answer(|_, _| output(&json!([[1], [2]])));
    done(&run(at, &toy, &["--db", "other.db"]));
    let merged = strainsite(at, &["db", "merge", "other.db", "--db", "one.db"]);
    assert_eq!(merged.status.code(), Some(1));
    assert!(
        text(&merged.stdout).contains("is known here with other outputs"),
        "{}",
        text(&merged.stdout)
    );
}

#[test]
fn a_killed_run_goes_on_with_what_it_lacks() {
    const AT_ONCE: usize = 4;
    let folder = tempfile::tempdir().expect("temp dir");
    let (at, toy) = (folder.path(), Toy::start());
    write_inputs(at, "kind = \"saltelli\"\nsamples = 64");
    let undisturbed = run(
        at,
        &toy,
        &["--at-once", "50", "--db", "other.db", "--json", "-"],
    );
    let expected = done(&undisturbed).to_owned();
    let points = toy.asked().len();
    let slow = |x: &[f64], _| -> Answer {
        let (status, body, _) = both(x);
        (status, body, Duration::from_millis(2))
    };
    toy.answer(slow);
    let mut arguments = vec![
        "gsa",
        "run",
        "inputs.toml",
        "--model",
        &toy.url,
        "--json",
        "-",
    ];
    arguments.extend(["--at-once", "4"]);
    for kills in 1..=2 {
        let mut killed = spawn(at, &arguments);
        let begun = Instant::now();
        while toy.count() < kills * points / 3 {
            assert!(begun.elapsed() < PATIENCE, "nothing is asked for");
            std::thread::sleep(Duration::from_millis(1));
        }
        killed.kill().expect("kills");
        killed.wait().expect("ends");
    }
    let rest = strainsite(at, &arguments);
    assert_eq!(done(&rest), expected);
    let asked = toy.asked();
    assert_eq!(asked.len(), points);
    let twice: usize = asked.iter().map(|count| count - 1).sum();
    assert!(twice <= 2 * AT_ONCE, "{twice} were asked for twice");
    done(&strainsite(at, &["db", "check"]));
}

#[test]
fn a_run_that_fails_is_nan_with_its_reason_and_asked_for_again_on_request() {
    let folder = tempfile::tempdir().expect("temp dir");
    let (at, toy) = (folder.path(), Toy::start());
    write_inputs(at, "kind = \"mdrm\"\nnodes = 7");
    let long = format!("{{\"output\": [[1], [{}2]]}}", " ".repeat(1 << 21));
    let answers = [
        reply(
            400,
            r#"{"error": {"type": "Bad", "message": "no such\u001b[31m wing"}}"#,
        ),
        reply(
            500,
            "500 Internal Server Error\n\nServer got itself in trouble",
        ),
        output(&json!([[1, 2], [3]])),
        reply(200, r#"{"output": [[nan], [1.0]] }"#),
        reply(200, r#"{"output": [[-Infinity], [1.0]]}"#),
        output(&json!([["1"], [2]])),
        reply(200, "{}"),
        reply(200, &long),
    ];
    let reasons = [
        "Bad: no such\\u{1b}[31m wing",
        "HTTP 500: 500 Internal Server Error Server got itself in trouble",
        "its output has the sizes [2, 1], not [1, 1]",
        "number 1 of its output isn't finite",
        "number 1 of its output isn't finite",
        "number 1 of its output isn't finite",
        "its answer has no output, a list of lists",
        "its answer has more than",
    ];
    for (number, (wrong, reason)) in answers.into_iter().zip(reasons).enumerate() {
        let database = format!("{number}.db");
        // One point of the first input's line.
        let fails = |x: &[f64]| x[0] > 2.9;
        toy.answer(move |x, _| if fails(x) { wrong.clone() } else { both(x) });
        let arguments = [
            "--at-once",
            "9",
            "--db",
            &database,
            "--json",
            "-",
            "-o",
            "values.csv",
        ];
        let failed = run(at, &toy, &arguments);
        let expected = done(&failed).to_owned();
        let said = text(&failed.stderr);
        assert!(said.contains("1 failed") && said.contains(reason), "{said}");
        assert_eq!(analysed(at, "values.csv"), expected);
        let values = std::fs::read_to_string(at.join("values.csv")).expect("reads");
        assert_eq!(values.matches("nan,nan").count(), 1, "{values}");
        let mut asked = toy.asked();
        asked.sort_unstable();
        assert_eq!(asked.pop(), Some(2), "{reason}");
        assert!(asked.iter().all(|count| *count == 1));

        assert_eq!(done(&run(at, &toy, &arguments)), expected);
        assert_eq!(toy.count(), 0);
        toy.answer(|x, _| both(x));
        let mended = run(at, &toy, &["--again", "--db", &database]);
        assert!(
            !text(&mended.stderr).contains("failed"),
            "{}",
            text(&mended.stderr)
        );
        assert_eq!((done(&mended).is_empty(), toy.asked()), (false, vec![1]));
        done(&strainsite(at, &["db", "check", "--db", &database]));
    }
}

#[test]
fn a_model_that_has_other_outputs_than_before_is_refused() {
    let folder = tempfile::tempdir().expect("temp dir");
    let (at, toy) = (folder.path(), Toy::start());
    write_inputs(at, "kind = \"mdrm\"");
    done(&run(at, &toy, &[]));
    toy.resize(vec![3]);
    let said = run(at, &toy, &[]);
    assert!(
        refused(&said, 2).contains("answered with 2 numbers before, and has 3 now"),
        "{}",
        text(&said.stderr)
    );
}

#[test]
fn one_that_fails_once_counts_as_run() {
    let folder = tempfile::tempdir().expect("temp dir");
    let (at, toy) = (folder.path(), Toy::start());
    write_inputs(at, "kind = \"mdrm\"");
    toy.answer(|x, before| if before == 0 { reply(500, "") } else { both(x) });
    let found = run(at, &toy, &["--at-once", "3", "--json", "-"]);
    assert_eq!(done(&found), planned_and_analysed(at));
    assert!(
        !text(&found.stderr).contains("failed"),
        "{}",
        text(&found.stderr)
    );
}

#[test]
fn a_server_that_is_away_is_waited_for_and_nothing_is_lost_when_it_stays_away() {
    let folder = tempfile::tempdir().expect("temp dir");
    let (at, toy) = (folder.path(), Toy::start());
    write_inputs(at, "kind = \"mdrm\"");
    let expected = planned_and_analysed(at);
    for (number, away) in [
        reply(503, ""),
        reply(429, "slowly"),
        reply(502, "<html>"),
        reply(200, "<html>"),
    ]
    .into_iter()
    .enumerate()
    {
        let database = format!("{number}.db");
        let first = away.clone();
        toy.answer(move |x, before| {
            if before == 0 && x[0] > 0.0 {
                first.clone()
            } else {
                both(x)
            }
        });
        let arguments = ["--at-once", "3", "--json", "-", "--db", &database];
        let waited = run(at, &toy, &arguments);
        assert_eq!(done(&waited), expected);
        assert!(
            text(&waited.stderr).contains("asking again for 60 s"),
            "{}",
            text(&waited.stderr)
        );
        let points = toy.asked().len();

        let database = format!("{number}-stays.db");
        let arguments = [
            "--at-once",
            "3",
            "--json",
            "-",
            "--db",
            &database,
            "--patience-s",
            "0",
        ];
        let stays = away.clone();
        toy.answer(move |x, _| if x[1] > 0.0 { stays.clone() } else { both(x) });
        let ended = run(at, &toy, &arguments);
        let said = refused(&ended, 1);
        assert!(
            said.contains("all answers so far are stored: the same command goes on"),
            "{said}"
        );
        let before = toy.asked().len();
        toy.answer(|x, _| both(x));
        assert_eq!(done(&run(at, &toy, &arguments)), expected);
        let after = toy.asked().len();
        assert!(
            before > 1 && after < points && before + after >= points,
            "{before} {after} {points}"
        );
    }
}

#[test]
fn what_is_in_flight_when_the_server_goes_away_is_waited_for() {
    let folder = tempfile::tempdir().expect("temp dir");
    let (at, toy) = (folder.path(), Toy::start());
    write_inputs(at, "kind = \"mdrm\"");
    let slow = |x: &[f64]| x[0] > 2.0;
    toy.answer(move |x, _| match both(x) {
        _ if x[1] > 0.0 => reply(503, ""),
        (status, body, _) if slow(x) => (status, body, Duration::from_millis(300)),
        at_once => at_once,
    });
    let arguments = ["--at-once", "20", "--patience-s", "0"];
    let ended = run(at, &toy, &arguments);
    let said = refused(&ended, 1);
    assert!(
        said.contains("nothing more is asked for, ") && said.contains(" in flight are waited for"),
        "{said}"
    );
    toy.answer(move |x, _| {
        assert!(!slow(x) || x[1] > 0.0, "is stored");
        both(x)
    });
    done(&run(at, &toy, &arguments));
}

#[test]
fn a_run_that_takes_too_long_is_none() {
    let folder = tempfile::tempdir().expect("temp dir");
    let (at, toy) = (folder.path(), Toy::start());
    write_inputs(at, "kind = \"mdrm\"");
    toy.answer(|x, _| {
        let (status, body, _) = both(x);
        (
            status,
            body,
            if x[0] > 2.0 { PATIENCE } else { Duration::ZERO },
        )
    });
    let ended = run(
        at,
        &toy,
        &["--at-once", "4", "--timeout-s", "1", "--patience-s", "0"],
    );
    assert!(
        refused(&ended, 1).contains("/Evaluate: no answer within 1 s"),
        "{}",
        text(&ended.stderr)
    );
}

#[test]
fn signals_end_it_at_once_and_it_goes_on_afterwards() {
    for signal in ["-INT", "-TERM"] {
        let folder = tempfile::tempdir().expect("temp dir");
        let (at, toy) = (folder.path(), Toy::start());
        write_inputs(at, "kind = \"mdrm\"");
        toy.answer(|x, _| {
            let (status, body, _) = both(x);
            (
                status,
                body,
                if x[2] > 2.0 { PATIENCE } else { Duration::ZERO },
            )
        });
        let run_it = [
            "gsa",
            "run",
            "inputs.toml",
            "--model",
            &toy.url,
            "--at-once",
            "20",
        ];
        let run = spawn(at, &run_it);
        let begun = Instant::now();
        while stored_runs(&at.join("strainsite.db")) == 0 {
            assert!(begun.elapsed() < PATIENCE, "nothing is stored");
            std::thread::sleep(Duration::from_millis(2));
        }
        let begun = Instant::now();
        let sent = Command::new("kill")
            .args([signal, &run.id().to_string()])
            .status();
        assert!(sent.expect("kill runs").success());
        let ended = run.wait_with_output().expect("ends");
        assert!(
            begun.elapsed() < Duration::from_secs(5),
            "{:?}",
            begun.elapsed()
        );
        assert!(
            refused(&ended, 1).contains("stopped on request; all answers so far"),
            "{}",
            text(&ended.stderr)
        );
        toy.answer(|x, _| both(x));
        let asked = toy.asked().len();
        done(&strainsite(at, &run_it));
        assert!(toy.asked().len() < asked);
    }
}

#[test]
fn what_does_not_fit_is_refused_before_anything_is_asked() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    write_inputs(at, "kind = \"mdrm\"");
    let toy = Toy::start();
    let several = Toy::with(vec!["wing", "tail"], vec![3], vec![2]);
    let wide = Toy::with(vec!["wide"], vec![2, 5], vec![1]);
    let silent = Toy::with(vec!["silent"], vec![3], vec![0]);
    let none = Toy::with(vec![], vec![3], vec![1]);
    for (server, arguments, expected) in [
        (
            &several,
            &[][..],
            "several models: choose one by --name: wing, tail",
        ),
        (
            &several,
            &["--name", "fin"],
            "no model \"fin\", but wing, tail",
        ),
        (
            &wide,
            &[],
            "takes 7 numbers (inputSizes [2, 5]), and the document has 3 inputs",
        ),
        (&silent, &[], "answers with 0 numbers"),
        (&none, &[], "the server has no model"),
        (
            &toy,
            &["--outputs", "a"],
            "--outputs has 1 names, and the model answers with 2 numbers (outputSizes [1, 1])",
        ),
        (&toy, &["--outputs", "y,b, mm"], "has 3 names"),
        (&toy, &["--outputs", "y,a"], "\"a\" is the name of an input"),
        (&toy, &["--outputs", "y,y"], "each another one"),
        (&toy, &["--config", "[1]"], "not a JSON object"),
        (&toy, &["--at-once", "0"], "1..=1000"),
        (&toy, &["--timeout-s", "0"], "1 to 1e6"),
        (&toy, &["--json", "inputs.toml"], "an input of this command"),
    ] {
        let said = run(at, server, arguments);
        assert!(
            refused(&said, 2).contains(expected),
            "{}",
            text(&said.stderr)
        );
        assert_eq!(server.count(), 0);
        assert!(!at.join("strainsite.db").exists());
    }
    several.answer(|x, _| output(&json!([[x[0], x[1]]])));
    let named = run(at, &several, &["--name", "tail"]);
    assert!(
        done(&named).contains("y1: ") && done(&named).contains("y2: "),
        "{}",
        done(&named)
    );
}

#[test]
fn where_no_server_is_that_is_said() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    write_inputs(at, "kind = \"mdrm\"");
    let free = std::net::TcpListener::bind("127.0.0.1:0").expect("a port");
    let url = format!("http://{}", free.local_addr().expect("an address"));
    drop(free);
    let ask = |url: &str, patience: &str| {
        let begun = Instant::now();
        let ended = strainsite(
            at,
            &[
                "gsa",
                "run",
                "inputs.toml",
                "--model",
                url,
                "--patience-s",
                patience,
            ],
        );
        (ended, begun.elapsed())
    };
    for patience in ["0", "0.5"] {
        let (ended, time) = ask(&url, patience);
        assert!(
            refused(&ended, 1).contains("/Info: Connection refused"),
            "{}",
            text(&ended.stderr)
        );
        assert!(time < Duration::from_secs(10), "{time:?}");
    }
    for (url, words) in [
        ("https://127.0.0.1:1", "tunnel"),
        ("127.0.0.1:1", "http://HOST:PORT"),
    ] {
        assert!(refused(&ask(url, "0").0, 2).contains(words));
    }
    // A server of another kind.
    let toy = Toy::start();
    let (ended, _) = ask(&format!("{}/elsewhere", toy.url), "0");
    assert!(
        refused(&ended, 1).contains("no answer of UM-Bridge's protocol, but HTTP 404"),
        "{}",
        text(&ended.stderr)
    );
}
