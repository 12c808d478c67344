//! `strainsite force apply`.

use std::io::{self, BufRead, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use estimation::estimator::Estimator;
use estimation::recording::recording_fault::RecordingFault;
use service::forces::applying::{
    EstimatedLines, Estimates, Zero, apply, estimates_header, measured_zero,
};
use service::forces::model_file::{MOST_MODEL_BYTES, read_model};
use service::forces::recorded_texts::{MOST_RECORDING_BYTES, add};
use service::forces::streamed_lines::{StreamedLines, stream_header};
use service::study_document::text_files::{read_any_text, read_text};

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::files::Files;
use crate::cli::terminal::output::{print, warn};
use crate::cli::terminal::output_place::{write, write_to};

/// Longest line of a recording, bytes.
const LONGEST_LINE: usize = 1 << 20;
/// Name of the stream in messages.
const STDIN: &str = "standard input";

#[derive(Debug, Args)]
pub(crate) struct Apply {
    /// Model of `force fit`
    model: PathBuf,
    /// Recording, CSV; `-` reads rows from standard input and answers each at once, with its state
    run: PathBuf,
    /// Zero of the signals: `first` for the first row's, `model` for what they were where no force acted, or a recording without load
    #[arg(long, value_name = "first|model|RUN")]
    start: Option<PathBuf>,
    /// End a stream at its first imperfect row, as a file is refused for one
    #[arg(long)]
    strict: bool,
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
            .reading(self.start_file())
            .writing(self.output.as_deref())
    }

    /// The recording whose zero counts.
    fn start_file(&self) -> Option<&Path> {
        let start = self.start.as_deref()?;
        (start != Path::new("first") && start != Path::new("model")).then_some(start)
    }

    /// The zero that is asked for.
    fn zero(&self, estimator: &Estimator) -> Result<Zero, Failure> {
        if let Some(file) = self.start_file() {
            let text = read_any_text(file, MOST_RECORDING_BYTES).map_err(Failure::input)?;
            let name = file.display().to_string();
            let zero = measured_zero(estimator, &name, &text).map_err(refused)?;
            return Ok(Zero::Known(zero));
        }
        match self.start.as_deref() {
            None => Ok(Zero::AsLearnt),
            Some(start) if start == Path::new("first") => Ok(Zero::First),
            Some(_) => match &estimator.zero {
                Some(zero) => Ok(Zero::Known(zero.clone())),
                None => Err(Failure::input(format!(
                    "--start model: {} knows no zero, as no run that it learnt from was unloaded, or an earlier version learnt it",
                    self.model.display()
                ))),
            },
        }
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
        let zero = self.zero(&estimator)?;
        let stream = |out: &mut dyn Write| {
            let (rows, mut out) = (io::stdin().lock(), out);
            match self.strict {
                true => strictly_streamed(&estimator, &zero, rows, &mut out),
                false => streamed(&estimator, &zero, rows, &mut out),
            }
        };
        match (self.is_streamed(), &self.output) {
            (true, None) => stream(&mut io::stdout().lock()),
            (true, Some(path)) => {
                let mut out = Vec::new();
                stream(&mut out)?;
                write(path, &out)
            }
            (false, _) => {
                let text =
                    read_any_text(&self.run, MOST_RECORDING_BYTES).map_err(Failure::input)?;
                let Estimates { csv, begins_loaded } =
                    apply(&estimator, &self.run.display().to_string(), &text, &zero)
                        .map_err(refused)?;
                warn_of(begins_loaded);
                match &self.output {
                    Some(path) => write(path, csv.as_bytes()),
                    None => print(&csv),
                }
            }
        }
    }
}

fn warn_of(begins_loaded: Option<String>) {
    if let Some(begins_loaded) = begins_loaded {
        warn(&format!("{begins_loaded} (--start)\n"));
    }
}

fn refused(found: Vec<RecordingFault>) -> Failure {
    let mut faults = Vec::new();
    add(&mut faults, found);
    Failure::Input(faults)
}

/// Answers each row as soon as its line is whole, whatever it is like, and says at the end how many had which state.
fn streamed(
    estimator: &Estimator,
    zero: &Zero,
    mut rows: impl BufRead,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let header = next_line(&mut rows)?.unwrap_or_default();
    let header = String::from_utf8_lossy(&header);
    let mut lines = StreamedLines::new(estimator, STDIN, &header, zero).map_err(refused)?;
    write_to(&mut *out, stream_header(estimator).as_bytes()).map_err(Failure::other)?;
    while let Some(line) = next_line(&mut rows)? {
        let answer = lines.push(&String::from_utf8_lossy(&line));
        write_to(&mut *out, answer.as_bytes()).map_err(Failure::other)?;
    }
    let counts = lines.counts().iter();
    let counts: Vec<String> = counts
        .map(|(state, count)| format!("{count} {}", state.as_str()))
        .collect();
    warn(&format!("rows: {}\n", counts.join(", ")));
    Ok(())
}

/// Answers each row as soon as its line is whole. Ends with the first fault: what comes after it may depend on it.
fn strictly_streamed(
    estimator: &Estimator,
    zero: &Zero,
    mut rows: impl BufRead,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let mut line = || -> Result<Option<String>, Failure> {
        let Some(bytes) = next_line(&mut rows)? else {
            return Ok(None);
        };
        if bytes.len() >= LONGEST_LINE {
            return Err(Failure::input(format!(
                "{STDIN}: a line has {LONGEST_LINE} bytes or more"
            )));
        }
        let text = String::from_utf8(bytes);
        text.map(Some)
            .map_err(|_| Failure::input(format!("{STDIN}: it is not UTF-8 text")))
    };
    let header = line()?.unwrap_or_default();
    let mut lines = EstimatedLines::new(estimator, STDIN, &header, zero).map_err(refused)?;
    write_to(&mut *out, estimates_header(estimator).as_bytes()).map_err(Failure::other)?;
    while let Some(line) = line()? {
        let estimates = lines.push(&line).map_err(refused)?;
        write_to(&mut *out, estimates.as_bytes()).map_err(Failure::other)?;
    }
    warn_of(lines.begins_loaded());
    Ok(())
}

/// Reads the next line without its end, of a longer one [`LONGEST_LINE`] bytes; none where there is no more.
fn next_line(rows: &mut impl BufRead) -> Result<Option<Vec<u8>>, Failure> {
    let mut line = Vec::new();
    let mut is_there = false;
    loop {
        let part = rows.fill_buf().map_err(Failure::other)?;
        if part.is_empty() {
            return Ok(is_there.then_some(line));
        }
        is_there = true;
        let end = part.iter().position(|byte| *byte == b'\n');
        let whole = &part[..end.unwrap_or(part.len())];
        let room = LONGEST_LINE.saturating_sub(line.len());
        line.extend(&whole[..whole.len().min(room)]);
        let read = end.map_or(part.len(), |end| end + 1);
        rows.consume(read);
        if end.is_some() {
            while line.last() == Some(&b'\r') {
                line.pop();
            }
            return Ok(Some(line));
        }
    }
}
