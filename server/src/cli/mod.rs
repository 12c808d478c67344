//! The command line: one file per command.
//!
//! Data goes to standard output, talk to standard error. Exit codes: 0 done, 2 the input is wrong, 3 the physics has
//! no answer, 1 anything else.

mod compare;
mod db;
mod estimate;
mod export;
mod failure;
mod gsa;
mod library;
mod output;
mod progress;
mod run;
mod serve;
mod settings;
mod signals;
mod solve;
mod sweep;
mod table;
mod trade;
mod validate;
mod verify;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::telemetry;
pub use failure::Failure;
use output::JsonTarget;

/// Ranks strain-sensor locations in a smart tire
#[derive(Debug, Parser)]
#[command(name = "strainsite", version, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Start the service and the dashboard
    Serve(serve::Serve),
    /// Run one study without the service
    Run(run::Run),
    /// Solve one equilibrium of a scene
    Solve(solve::Solve),
    /// Analyse a model of your own: print the points to run, then read their outputs back
    Gsa(gsa::Gsa),
    /// Measure how much accuracy a second buys
    Trade(trade::Trade),
    /// Run one study over a grid of designs, and compare them
    Sweep(sweep::Sweep),
    /// Compare studies, or the designs of a sweep: what differs, and which differences are real
    Compare(compare::Compare),
    /// List the studies of a database, newest first
    List(library::List),
    /// Show a study: its ranked table, or how far it is
    Show(library::Show),
    /// Write a study's answer as a file: a table, the map, or the whole result
    Export(export::Export),
    /// Look after the database file
    Db(db::Db),
    /// Check a study or scene file without running it
    Validate(validate::Validate),
    /// Solve problems whose answer is known, and compare
    Verify(verify::Verify),
}

/// Runs the program: the one place that prints failures and chooses the exit code.
pub fn main() -> ExitCode {
    let command = match settings::parse::<Cli>() {
        Ok(cli) => cli.command,
        Err(faults) => return ended(Err(Failure::Input(faults)), None),
    };
    match &command {
        Command::Serve(command) => command.start_log(),
        _ => telemetry::start(),
    }
    let (done, json) = match command {
        Command::Serve(command) => (command.execute(), None),
        Command::Run(command) => (command.execute(), command.json),
        Command::Solve(command) => (command.execute(), command.json),
        Command::Gsa(command) => (command.execute(), command.json()),
        Command::Trade(command) => (command.execute(), command.json),
        Command::Sweep(command) => (command.execute(), command.json),
        Command::Compare(command) => (command.execute(), command.json),
        Command::List(command) => (command.execute(), command.json),
        Command::Show(command) => (command.execute(), command.json),
        Command::Export(command) => (command.execute(), None),
        Command::Db(command) => (command.execute(), None),
        Command::Validate(command) => (command.execute(), None),
        // Its document holds the failed cases already.
        Command::Verify(command) => (command.execute(), None),
    };
    ended(done, json)
}

fn ended(done: Result<(), Failure>, json: Option<JsonTarget>) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprint!("{failure}");
            if let Some(target) = json.filter(|_| !matches!(failure, Failure::Partial(_)))
                && let Err(error) = target.write(&failure.document())
            {
                eprintln!("{error}");
            }
            ExitCode::from(failure.code())
        }
    }
}
