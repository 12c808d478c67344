//! The process that works: it reads an order from standard input, and writes to standard output.

use std::io::{self, Write};
use std::process::ExitCode;
use std::thread;

use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
use serde::Serialize;

use super::{ANSWER, TOLD};

/// Answers the order on standard input. The process ends when that does, because its parent has.
pub(crate) fn answer<A: Serialize>(of: impl FnOnce(&str) -> A) -> ExitCode {
    // Where memory runs out, this process is to be ended rather than the one that keeps count.
    let _ = std::fs::write("/proc/self/oom_score_adj", "1000");
    let mut order = String::new();
    match io::stdin().read_line(&mut order) {
        Ok(bytes) if bytes > 0 => {}
        _ => return ExitCode::FAILURE,
    }
    thread::spawn(|| {
        let _ = io::copy(&mut io::stdin(), &mut io::sink());
        std::process::exit(1);
    });
    match written(ANSWER, &of(&order)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(_) => ExitCode::FAILURE,
    }
}

/// Tells the parent how far the work is.
pub(crate) fn tell(progress: &impl Serialize) {
    // A parent that doesn't listen any more has ended, and so does this process.
    let _ = written(TOLD, progress);
}

fn written(word: &str, message: &impl Serialize) -> io::Result<()> {
    let line = format!("{word}{}\n", serde_json::to_string(message)?);
    let mut output = io::stdout().lock();
    output.write_all(line.as_bytes())?;
    output.flush()
}

/// Has the system refuse this process more memory than that: an allocation that is refused ends it.
pub(crate) fn limit_memory(bytes: u64) {
    let before = getrlimit(Resource::Data);
    let limit = Rlimit {
        current: Some(before.current.map_or(bytes, |earlier| earlier.min(bytes))),
        maximum: before.maximum,
    };
    // Where the system has no such limit, the parent's forecast is what there is.
    let _ = setrlimit(Resource::Data, limit);
}
