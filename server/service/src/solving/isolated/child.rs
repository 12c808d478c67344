//! The process that solves: it reads an order from standard input and writes the answer to standard output.

use std::io::{self, Write};
use std::process::ExitCode;
use std::sync::atomic::AtomicBool;
use std::thread;

use fem_client::solver::{SolveError, SolveRequest, Solved, Solver};
use placement::points::usage::cpu_s;

use super::messages::{Answer, Order};

/// The program's only argument when it is started for this. It is no command of its users.
pub const ARGUMENT: &str = "solve-apart";

/// Answers the order on standard input. The process ends when that does, because its parent has.
pub fn answer(solver: &dyn Solver) -> ExitCode {
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
    let outcome = solved(solver, &order);
    let answer = serde_json::to_string(&Answer::of(outcome, cpu_s()));
    let told = answer.map_err(io::Error::other).and_then(|answer| {
        let mut output = io::stdout().lock();
        output.write_all(answer.as_bytes())?;
        output.flush()
    });
    match told {
        Ok(()) => ExitCode::SUCCESS,
        Err(_) => ExitCode::FAILURE,
    }
}

fn solved(solver: &dyn Solver, order: &str) -> Result<Solved, SolveError> {
    let order: Order = serde_json::from_str(order).map_err(|error| SolveError::Broken {
        detail: format!("its order can't be read: {error}"),
    })?;
    let (scene, readout, start) = order.parts()?;
    solver.solve(&SolveRequest {
        scene: &scene,
        readout: &readout,
        start: start.as_ref(),
        // The parent ends the process instead.
        watch: &AtomicBool::new(false),
    })
}
