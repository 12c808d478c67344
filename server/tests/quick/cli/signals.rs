//! Signals that end a run or the service from outside.

use std::io::{BufRead, BufReader};
use std::process::{Child, ChildStdout, Command, Stdio};

use serde_json::Value;

use super::draft;
use crate::program::{spawn, stored_points, strainsite, text, wait_for_points};

fn send(signal: &str, child: &Child) {
    let sent = Command::new("kill")
        .args([signal, &child.id().to_string()])
        .status()
        .expect("kill runs");
    assert!(sent.success());
}

/// Returns what a program prints first, and the pipe, which it may go on to print to.
fn first_line(program: &mut Child) -> (BufReader<ChildStdout>, String) {
    let mut stdout = BufReader::new(program.stdout.take().expect("a pipe"));
    let mut line = String::new();
    stdout.read_line(&mut line).expect("a line");
    (stdout, line)
}

#[tokio::test]
async fn ctrl_c_keeps_what_is_solved_and_the_next_run_resumes() {
    let folder = tempfile::tempdir().expect("temp dir");
    let study = draft(folder.path());
    let run = spawn(folder.path(), &["run", study, "--threads", "1"]);
    wait_for_points(&folder.path().join("strainsite.db"), 3).await;
    send("-INT", &run);
    let output = run.wait_with_output().expect("ends");
    assert_eq!(output.status.code(), Some(1));
    assert!(
        text(&output.stderr).contains("next run of this study resumes"),
        "{}",
        text(&output.stderr)
    );
    let kept = stored_points(&folder.path().join("strainsite.db")).await;
    assert!((3..26).contains(&kept), "{kept} points");

    let resumed = strainsite(folder.path(), &["run", study, "--json", "-"]);
    assert_eq!(resumed.status.code(), Some(0), "{}", text(&resumed.stderr));
    let result: Value = serde_json::from_slice(&resumed.stdout).expect("JSON");
    assert_eq!(result["cost"]["reused"], kept);
}

#[test]
fn the_service_ends_with_0_when_it_is_asked_to_stop() {
    for signal in ["-INT", "-TERM", "-HUP"] {
        let folder = tempfile::tempdir().expect("temp dir");
        // Tests that are to outlive their terminal have SIGHUP ignored.
        let mut service = Command::new("env")
            .args([
                "--default-signal=HUP",
                env!("CARGO_BIN_EXE_strainsite"),
                "serve",
                "--addr",
                "127.0.0.1:0",
            ])
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .spawn()
            .expect("starts");
        let (_stdout, line) = first_line(&mut service);
        assert!(
            line.starts_with("listening on http://127.0.0.1:"),
            "{line:?}"
        );
        send(signal, &service);
        assert_eq!(service.wait().expect("ends").code(), Some(0), "{signal}");
        assert!(
            !folder.path().join("strainsite.db-wal").exists(),
            "the log is folded into the database"
        );
    }
}

#[test]
fn a_service_that_is_to_outlive_its_terminal_does() {
    let folder = tempfile::tempdir().expect("temp dir");
    let mut service = Command::new("sh")
        .args([
            "-c",
            "trap '' HUP; exec \"$0\" serve --addr 127.0.0.1:0",
            env!("CARGO_BIN_EXE_strainsite"),
        ])
        .current_dir(folder.path())
        .stdout(Stdio::piped())
        .spawn()
        .expect("starts");
    let (_stdout, line) = first_line(&mut service);
    send("-HUP", &service);
    let address = line.trim().strip_prefix("listening on http://");
    let heard = std::net::TcpStream::connect(address.expect("an address"));
    heard.expect("still listens");
    send("-TERM", &service);
    assert_eq!(service.wait().expect("ends").code(), Some(0));
}
