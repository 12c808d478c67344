//! Chooses the command, runs it, and chooses the exit code.

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

use crate::cli::commands::solve::umbridge;
use crate::cli::commands::sweep::task_commands;
use crate::cli::commands::{
    compare, db, documents, export, force, gsa, library, run, serve, shell, solve, sweep, trade,
    verify,
};
use crate::cli::settings;
use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::help_examples;
use crate::cli::terminal::output::{JsonTarget, warn};
use crate::telemetry;
use service::forces::fit_process::{self, learn_for_parent};
use service::solving::isolated::child;
use service::solving::solver_choice::solve_for_parent;
use service::work::analysis_process::{self, analyse_for_parent};

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
    #[command(after_help = help_examples::SERVE)]
    Serve(serve::Serve),
    /// Run one study without the service
    #[command(after_help = help_examples::RUN)]
    Run(run::Run),
    /// Solve one equilibrium of a scene
    #[command(after_help = help_examples::SOLVE)]
    Solve(solve::Solve),
    /// Serve a study as a model that other programs evaluate, by UM-Bridge's protocol
    #[command(after_help = help_examples::UMBRIDGE)]
    Umbridge(umbridge::Umbridge),
    /// Analyse a model of your own: print the points to run, then read their outputs back; or have a server run them
    #[command(after_help = help_examples::GSA)]
    Gsa(gsa::Gsa),
    /// Learn forces from recorded signals, and estimate them
    #[command(after_help = help_examples::FORCE)]
    Force(force::Force),
    /// Measure how much accuracy a second buys
    #[command(after_help = help_examples::TRADE)]
    Trade(trade::Trade),
    /// Run one study over a grid of designs, and compare them
    #[command(after_help = help_examples::SWEEP)]
    Sweep(sweep::Sweep),
    /// Have designs of a sweep solved by other machines: write them as tasks, run one, take in what came of them
    Tasks(task_commands::Tasks),
    /// Compare studies, or the designs of a sweep: what differs, and which differences are real
    #[command(after_help = help_examples::COMPARE)]
    Compare(compare::Compare),
    /// List the studies and scenes that ship, whose names stand for files
    #[command(after_help = help_examples::PRESETS)]
    Presets(library::Presets),
    /// List the studies of a database, newest first
    #[command(after_help = help_examples::LIST)]
    List(library::List),
    /// Show a study: its ranked table, or how far it is
    #[command(after_help = help_examples::SHOW)]
    Show(library::Show),
    /// Write a study's answer as a file: a table, the map, or the whole result
    #[command(after_help = help_examples::EXPORT)]
    Export(export::Export),
    /// Look after the database file
    #[command(after_help = help_examples::DB)]
    Db(db::Db),
    /// Check a study or scene file without running it
    #[command(after_help = help_examples::VALIDATE)]
    Validate(documents::Validate),
    /// Print the JSON Schema of a document, for editors and checkers
    #[command(after_help = help_examples::SCHEMA)]
    Schema(documents::Schema),
    /// Solve problems whose answer is known, and compare
    #[command(after_help = help_examples::VERIFY)]
    Verify(verify::Verify),
    /// Print completions for a shell
    #[command(after_help = help_examples::COMPLETIONS)]
    Completions(shell::Completions),
    /// Print the manual page, or write those of all commands into a folder
    #[command(after_help = help_examples::MAN)]
    Man(shell::Manual),
}

/// Runs the program: the one place that prints failures and chooses the exit code.
pub fn main() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    if arguments == [child::ARGUMENT] {
        return solve_for_parent();
    }
    if arguments == [fit_process::ARGUMENT] {
        return learn_for_parent();
    }
    if arguments == [analysis_process::ARGUMENT] {
        return analyse_for_parent();
    }
    let command = match settings::parse::<Cli>() {
        Ok(cli) => cli.command,
        Err(faults) => return ended(Err(Failure::Input(faults)), None),
    };
    match &command {
        Command::Serve(command) => command.start_log(),
        _ => telemetry::start(),
    }
    let json = command.json();
    if let Err(refused) = command.files().check() {
        // Nothing may be written to a place that was just refused.
        return ended(Err(refused), json.filter(|to| *to == JsonTarget::Stdout));
    }
    ended(command.execute(), json)
}

impl Command {
    fn execute(&self) -> Result<(), Failure> {
        match self {
            Self::Serve(command) => command.execute(),
            Self::Run(command) => command.execute(),
            Self::Solve(command) => command.execute(),
            Self::Umbridge(command) => command.execute(),
            Self::Gsa(command) => command.execute(),
            Self::Force(command) => command.execute(),
            Self::Trade(command) => command.execute(),
            Self::Sweep(command) => command.execute(),
            Self::Tasks(command) => command.execute(),
            Self::Compare(command) => command.execute(),
            Self::Presets(command) => command.execute(),
            Self::List(command) => command.execute(),
            Self::Show(command) => command.execute(),
            Self::Export(command) => command.execute(),
            Self::Db(command) => command.execute(),
            Self::Validate(command) => command.execute(),
            Self::Schema(command) => command.execute(),
            Self::Verify(command) => command.execute(),
            Self::Completions(command) => command.execute(Cli::command()),
            Self::Man(command) => command.execute(Cli::command()),
        }
    }

    /// Returns where a failure is told beside standard error.
    fn json(&self) -> Option<JsonTarget> {
        match self {
            Self::Run(command) => command.json.clone(),
            Self::Solve(command) => command.json.clone(),
            Self::Gsa(command) => command.json(),
            Self::Force(command) => command.json(),
            Self::Trade(command) => command.json.clone(),
            Self::Sweep(command) => command.json.clone(),
            Self::Tasks(command) => command.json(),
            Self::Compare(command) => command.json.clone(),
            Self::Presets(command) => command.json.clone(),
            Self::List(command) => command.json.clone(),
            Self::Show(command) => command.json.clone(),
            // The document of verify holds the failed cases already.
            Self::Serve(_)
            | Self::Umbridge(_)
            | Self::Export(_)
            | Self::Db(_)
            | Self::Validate(_)
            | Self::Schema(_)
            | Self::Verify(_)
            | Self::Completions(_)
            | Self::Man(_) => None,
        }
    }

    fn files(&self) -> Files {
        match self {
            Self::Run(command) => command.files(),
            Self::Solve(command) => command.files(),
            Self::Umbridge(command) => command.files(),
            Self::Gsa(command) => command.files(),
            Self::Force(command) => command.files(),
            Self::Trade(command) => command.files(),
            Self::Sweep(command) => command.files(),
            Self::Tasks(command) => command.files(),
            Self::Compare(command) => command.files(),
            Self::Presets(command) => command.files(),
            Self::List(command) => command.files(),
            Self::Show(command) => command.files(),
            Self::Export(command) => command.files(),
            Self::Db(command) => command.files(),
            Self::Verify(command) => command.files(),
            Self::Man(command) => command.files(),
            Self::Serve(_) | Self::Validate(_) | Self::Schema(_) | Self::Completions(_) => {
                Files::default()
            }
        }
    }
}

fn ended(done: Result<(), Failure>, json: Option<JsonTarget>) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            warn(&failure.painted());
            if let Some(target) =
                json.filter(|_| !matches!(failure, Failure::Partial(_) | Failure::Told(_)))
                && let Err(error) = target.write(&failure.document())
            {
                warn(&error.painted());
            }
            ExitCode::from(failure.code())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The arguments of a line as a shell splits it: at spaces outside of single quotes.
    fn arguments(line: &str) -> Vec<String> {
        let parts = line.split('\'').enumerate();
        let words = parts.flat_map(|(index, part)| match index % 2 {
            0 => part.split_whitespace().map(str::to_owned).collect(),
            _ => vec![part.to_owned()],
        });
        words.collect()
    }

    fn check(command: &clap::Command, path: &str) {
        let help = command.get_after_help().map(ToString::to_string);
        let leaf = command.get_subcommands().next().is_none();
        let lines: Vec<String> = help
            .iter()
            .flat_map(|help| help.lines().skip(1))
            .map(|line| line.trim().to_owned())
            .collect();
        // What db does is shown for all of its tasks together.
        assert!(
            !lines.is_empty() || !leaf || path.starts_with("strainsite db"),
            "{path} has no examples"
        );
        for line in lines {
            assert!(line.starts_with(path), "{line}");
            if let Err(error) = Cli::try_parse_from(arguments(&line)) {
                panic!("{line}: {error}");
            }
        }
        for below in command.get_subcommands() {
            check(below, &format!("{path} {}", below.get_name()));
        }
    }

    #[test]
    fn every_example_of_the_help_is_a_command_line() {
        check(&Cli::command(), "strainsite");
    }

    #[test]
    fn every_command_has_its_page() {
        let mut program = Cli::command();
        program.build();
        let pages = shell::pages(&program).expect("pages");
        let text = |name: &str| {
            let page = pages.iter().find(|(file, _)| file == name);
            &page.unwrap_or_else(|| panic!("{name} is missing")).1
        };
        assert!(text("strainsite.1").contains(".TH strainsite 1"));
        assert!(text("strainsite-sweep.1").contains("\\-\\-grid"));
        assert!(text("strainsite-gsa-plan.1").contains("Examples:"));
        assert!(text("strainsite-db-check.1").contains("hash"));
    }
}
