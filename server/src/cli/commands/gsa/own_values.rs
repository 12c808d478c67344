//! Inputs and values as files have them, and their analysis.

use std::path::Path;

use documents::own_model::inputs_document::Inputs;
use documents::own_model::own_analysis::OwnAnalysis;
use documents::own_model::value_table::ValueTable;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::warn;
use crate::cli::terminal::paint::{WARNING, painted};
use crate::cli::terminal::progress::clock;
use service::study_document::text_files::read_text;
use service::study_document::{format_of, read_file};

/// Most bytes of a file of values: a million runs, which are the most, of 25 outputs with all their digits.
const MOST_VALUE_BYTES: usize = 1 << 29;

/// Reads inputs and method.
pub(super) fn read_inputs(path: &Path) -> Result<Inputs, Failure> {
    let text = read_file(path).map_err(Failure::Input)?;
    Inputs::from_document(&text, format_of(path)).map_err(Failure::Input)
}

/// Reads a file of values; names in a warning what it takes for an output though it is named as an input.
pub(super) fn read_values(path: &Path, inputs: &Inputs) -> Result<ValueTable, Failure> {
    let text = read_text(path, MOST_VALUE_BYTES).map_err(Failure::input)?;
    let table = ValueTable::of_model(&text, &inputs.names).map_err(Failure::Input)?;
    let is_input = |name: &&String| inputs.names.contains(name);
    for name in table.outputs().iter().filter(is_input) {
        warn(&format!(
            "{}: column {name:?} is taken for an output, as the file has no other: give it a name that no input has\n",
            painted(WARNING, "named as an input")
        ));
    }
    Ok(table)
}

/// The analysis as far as the values go.
pub(super) fn analysed<'a>(
    inputs: &'a Inputs,
    values: &'a ValueTable,
) -> Result<OwnAnalysis<'a>, Failure> {
    let waiting = clock("planning and analysing");
    let analysis = OwnAnalysis::of(inputs, values);
    waiting.finish_and_clear();
    analysis.map_err(Failure::Input)
}
