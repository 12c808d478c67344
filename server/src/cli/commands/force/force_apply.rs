//! `strainsite force apply`.

use std::io::{self, BufRead, Read, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use estimation::estimator::Estimator;
use estimation::recording::recording_fault::RecordingFault;
use service::forces::applying::{EstimatedLines, apply, estimates_header};
use service::forces::model_file::{MOST_MODEL_BYTES, read_model};
use service::forces::recorded_texts::{MOST_RECORDING_BYTES, add};
use service::study_document::text_files::read_text;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::print;
use crate::cli::terminal::output_place::{write, write_to};

/// Longest line of a recording, bytes.
const LONGEST_LINE: u64 = 1 << 20;

#[derive(Debug, Args)]
pub(crate) struct Apply {
    /// Model of `force fit`
    model: PathBuf,
    /// Recording, CSV; `-` reads rows from standard input and answers each at once
    run: PathBuf,
    /// Write the estimates here instead of to standard output
    #[arg(short, long)]
    output: Option<PathBuf>,
}

impl Apply {
    /// Returns the files that it reads and writes.
    pub fn files(&self) -> Files {
        let run = (!self.is_streamed()).then_some(&self.run);
        Files::default()
            .reading([&self.model])
            .reading(run)
            .writing(self.output.as_deref())
    }

    fn is_streamed(&self) -> bool {
        self.run == Path::new("-")
    }

    /// Estimates, and writes `time_s`, each force with its interval, `outside`.
    pub fn execute(&self) -> Result<(), Failure> {
        let text = read_text(&self.model, MOST_MODEL_BYTES).map_err(Failure::input)?;
        let named = |mut faults: Vec<document::fault::Fault>| {
            for fault in &mut faults {
                fault.detail = format!("{}: {}", self.model.display(), fault.detail);
            }
            Failure::Input(faults)
        };
        let estimator = read_model(&text).map_err(named)?;
        drop(text);
        match (self.is_streamed(), &self.output) {
            (true, None) => streamed(&estimator, io::stdin().lock(), &mut io::stdout().lock()),
            (true, Some(path)) => {
                let mut out = Vec::new();
                streamed(&estimator, io::stdin().lock(), &mut out)?;
                write(path, &out)
            }
            (false, _) => {
                let text = read_text(&self.run, MOST_RECORDING_BYTES).map_err(Failure::input)?;
                let estimates =
                    apply(&estimator, &self.run.display().to_string(), &text).map_err(refused)?;
                match &self.output {
                    Some(path) => write(path, estimates.as_bytes()),
                    None => print(&estimates),
                }
            }
        }
    }
}

fn refused(found: Vec<RecordingFault>) -> Failure {
    let mut faults = Vec::new();
    add(&mut faults, found);
    Failure::Input(faults)
}

/// Answers each row as soon as its line is whole. Ends with the first fault: what comes after it may depend on it.
fn streamed(
    estimator: &Estimator,
    mut rows: impl BufRead,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let mut line = String::new();
    if !next_line(&mut rows, &mut line)? {
        line.clear();
    }
    let mut lines = EstimatedLines::new(estimator, "standard input", &line).map_err(refused)?;
    write_to(&mut *out, estimates_header(estimator).as_bytes()).map_err(Failure::other)?;
    while next_line(&mut rows, &mut line)? {
        let estimates = lines.push(&line).map_err(refused)?;
        write_to(&mut *out, estimates.as_bytes()).map_err(Failure::other)?;
    }
    Ok(())
}

/// Reads the next line without its end; false where there is none.
fn next_line(rows: &mut impl BufRead, line: &mut String) -> Result<bool, Failure> {
    let mut bytes = Vec::new();
    rows.take(LONGEST_LINE)
        .read_until(b'\n', &mut bytes)
        .map_err(Failure::other)?;
    if bytes.len() as u64 == LONGEST_LINE {
        return Err(Failure::input(format!(
            "standard input: a line has {LONGEST_LINE} bytes or more"
        )));
    }
    let text = String::from_utf8(bytes)
        .map_err(|_| Failure::input("standard input: it is not UTF-8 text"))?;
    line.clear();
    line.push_str(text.trim_end_matches(['\n', '\r']));
    Ok(!text.is_empty())
}
