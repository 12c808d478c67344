//! `strainsite completions` and `strainsite man`: what a shell and its users want to know of this program.

use std::path::PathBuf;

use clap::{Args, Command};
use clap_complete::Shell;
use clap_mangen::Man;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::print;
use crate::cli::terminal::output_place::write;

/// Print completions for a shell
#[derive(Debug, Args)]
pub(crate) struct Completions {
    /// The shell
    shell: Shell,
}

impl Completions {
    /// Prints them: to be sourced, or put where the shell looks for them.
    pub fn execute(&self, mut program: Command) -> Result<(), Failure> {
        let (name, mut script) = (program.get_name().to_owned(), Vec::new());
        clap_complete::generate(self.shell, &mut program, name, &mut script);
        print(&String::from_utf8(script).map_err(Failure::other)?)
    }
}

/// Print the manual page, or write those of all commands into a folder
#[derive(Debug, Args)]
pub(crate) struct Manual {
    /// Folder for strainsite.1, strainsite-run.1 and so on
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Manual {
    /// Returns the files that it writes.
    pub fn files(&self) -> Files {
        Files::default().filling(self.out.as_deref(), &[])
    }

    /// Prints the page, in roff, or writes them all.
    pub fn execute(&self, mut program: Command) -> Result<(), Failure> {
        program.build();
        let Some(folder) = &self.out else {
            return print(&page(&program)?);
        };
        std::fs::create_dir_all(folder).map_err(|error| {
            Failure::Other(format!("{} can't be made: {error}", folder.display()))
        })?;
        pages(&program)?
            .into_iter()
            .try_for_each(|(name, text)| write(&folder.join(name), text.as_bytes()))
    }
}

/// The program's page and those of its commands, with their files' names.
pub(crate) fn pages(program: &Command) -> Result<Vec<(String, String)>, Failure> {
    let name = |command: &Command| {
        let name = command.get_display_name().unwrap_or(command.get_name());
        format!("{name}.1")
    };
    let mut pages = vec![(name(program), page(program)?)];
    let commands = program.get_subcommands();
    for command in commands.filter(|command| command.get_name() != "help") {
        pages.extend(self::pages(command)?);
    }
    Ok(pages)
}

fn page(command: &Command) -> Result<String, Failure> {
    let mut page = Vec::new();
    Man::new(command.clone())
        .render(&mut page)
        .map_err(Failure::other)?;
    String::from_utf8(page).map_err(Failure::other)
}
