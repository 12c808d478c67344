//! Designs of a sweep that an engine has solved elsewhere: commands, and programs that answer as Slurm's do. `tests/cluster` has a real one.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Output;

use super::json;
use crate::cli::draft;
use crate::program::{command, text};

/// Sweep of three designs, each a task of its own, by an engine; with a secret, and with programs of the folder before all others.
fn swept(folder: &Path, of: &[&str], engine: &[&str]) -> Output {
    let own = folder.join("bin");
    let path = std::env::var("PATH").expect("a path");
    let arguments = [
        &["sweep"],
        of,
        &["--minutes", "0.01", "--json", "-"],
        engine,
    ]
    .concat();
    let output = command(folder, &arguments)
        .env("PATH", format!("{}:{path}", own.display()))
        .env(
            "STRAINSITE_TOKEN",
            "a-secret-that-no-engine-sees-0123456789",
        )
        .output();
    output.expect("the program runs")
}

fn new(folder: &Path) -> [&str; 3] {
    [draft(folder), "--grid", "geometry.wall_mm=2.6,3,3.4"]
}

/// Makes a program of the folder.
fn program(folder: &Path, name: &str, script: &str) {
    let own = folder.join("bin");
    fs::create_dir_all(&own).expect("makes");
    let path = own.join(name);
    fs::write(&path, format!("#!/bin/sh\n{script}")).expect("writes");
    fs::set_permissions(path, fs::Permissions::from_mode(0o755)).expect("allows");
}

fn lines(folder: &Path, name: &str) -> Vec<String> {
    let text = fs::read_to_string(folder.join(name)).unwrap_or_default();
    text.lines().map(str::to_owned).collect()
}

fn has_all(output: &Output) {
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(json(&output.stdout)["sweep"]["counts"]["done"], 3);
}

#[test]
fn tasks_that_a_command_loses_are_given_again_and_what_is_left_is_solved_here() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    // It does the first task of the first round, and nothing of the others.
    let loses = r#"env > seen; echo "$COUNT: $TASKS" >> rounds; [ "$COUNT" != 3 ] || "$PROGRAM" tasks run "$FOLDER" 1"#;
    let command = ["--engine", "command", "--engine-command", loses];
    let output = swept(at, &new(at), &command);
    has_all(&output);
    assert_eq!(lines(at, "rounds"), ["3: 1 2 3", "2: 1 2", "2: 1 2"]);
    assert!(
        !lines(at, "seen")
            .iter()
            .any(|line| line.contains("a-secret"))
    );
    assert!(!at.join("strainsite.db.tasks").exists());
    let missing = swept(at, &["--resume", "latest"], &["--engine", "command"]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(text(&missing.stderr).contains("--engine-command"));
}

#[test]
fn a_study_alone_is_run_by_an_engine() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    let does = r#"echo "$TASKS" >> rounds; "$PROGRAM" tasks run "$FOLDER" 1"#;
    let run = ["run", draft(at), "--json", "-", "--engine", "command"];
    let run = [&run[..], &["--engine-command", does]].concat();
    let output = command(at, &run).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let result = json(&output.stdout);
    assert_eq!(lines(at, "rounds"), ["1"]);
    assert_eq!(result["cost"]["reused"], result["cost"]["solves"]);
    assert_eq!(result["locations"][0]["name"], "P3");
    let dry = command(at, &[&run[..], &["--dry-run"]].concat()).output();
    assert_eq!(dry.expect("the program runs").status.code(), Some(2));
}

/// Does the jobs of the array that `sbatch` was asked for, one after the other.
const DO: &str = r#"
for task in $(seq "$count"); do
    (cd "$dir" && SLURM_ARRAY_TASK_ID=$task SLURM_CPUS_ON_NODE=1 sh -c "$wrap" >/dev/null 2>&1)
done
"#;
/// Arguments of `sbatch`.
const READ: &str = r#"
while [ $# -gt 0 ]; do
    case $1 in
    --job-name=*) name=${1#*=} ;;
    --array=1-*) count=${1#--array=1-} ;;
    --wrap=*) wrap=${1#*=} ;;
    --chdir) dir=$2 ;;
    esac
    shift
done
echo "$count" >> submitted
"#;

#[test]
fn a_slurm_that_takes_one_job_at_a_time_is_given_one_at_a_time() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    let limit = r#"
if [ "$count" != 1 ]; then
    echo "sbatch: error: Batch job submission failed: Job violates accounting/QOS policy (job submit limit, user's size and/or time limits)" >&2
    exit 1
fi
echo "$name" > last
"#;
    program(at, "sbatch", &[READ, limit, DO].concat());
    program(at, "scontrol", "echo 'MaxArraySize            = 1001'");
    program(at, "scancel", r#"echo "$*" >> cancelled"#);
    // Once it doesn't answer, then it has a job twice and one that it won't start, then none.
    program(
        at,
        "squeue",
        r#"echo asked >> asked
case $(wc -l < asked) in
1) echo "squeue: error: Unable to contact slurm controller (connect failure)" >&2; exit 1 ;;
2) echo "$(cat last)|7|1|RUNNING|None"; echo "$(cat last)|9|1|PENDING|Resources"; echo "$(cat last)|7|2|PENDING|launch failed requeued held" ;;
esac"#,
    );
    let output = swept(at, &new(at), &["--engine", "slurm"]);
    has_all(&output);
    assert_eq!(lines(at, "submitted"), ["3", "2", "1", "1", "1"]);
    assert_eq!(lines(at, "cancelled"), ["9", "7_2"]);
    let said = text(&output.stderr);
    assert!(
        said.contains("connect failure") && said.contains("waiting until it answers"),
        "{said}"
    );
}

#[test]
fn what_was_submitted_when_the_program_was_killed_is_found_again() {
    let folder = tempfile::tempdir().expect("temp dir");
    let at = folder.path();
    let killing = r#"echo "$name" > last; echo "$dir" > dir; echo "$wrap" > wrap; kill -9 $PPID"#;
    program(at, "sbatch", &[READ, killing].concat());
    program(at, "scontrol", "exit 1");
    program(at, "scancel", "");
    // The job runs while it is asked for the second time.
    let queue = r#"echo asked >> asked
[ "$(wc -l < asked)" -gt 2 ] && exit
echo "$(cat last)|7|1|RUNNING|None"
[ "$(wc -l < asked)" = 2 ] || exit 0
dir=$(cat dir) wrap=$(cat wrap) count=3
"#;
    program(at, "squeue", &[queue, DO].concat());
    let killed = swept(at, &new(at), &["--engine", "slurm"]);
    assert_eq!(killed.status.code(), None, "{}", text(&killed.stderr));
    assert_eq!(lines(at, "submitted"), ["3"]);
    has_all(&swept(at, &["--resume", "latest"], &["--engine", "slurm"]));
    assert_eq!(lines(at, "submitted"), ["3"]);
}
