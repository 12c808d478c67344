//! `strainsite`: ranks strain-sensor locations in a smart tire.

use std::process::ExitCode;

fn main() -> ExitCode {
    server::cli::entry::main()
}
