//! Outputs of a model that was run: their names, and their values as a file has them.

use std::fmt::Write as _;

use documents::own_model::csv_cell;
use documents::own_model::inputs_document::Inputs;

use crate::cli::terminal::exit::Failure;
use crate::umbridge::asked_model::AskedModel;
use crate::umbridge::stored_runs::Runs;

/// Beginnings of names that nobody gave, of which the first that no input's name has is taken.
const STEMS: [&str; 3] = ["y", "out", "output_"];
/// Longest name of an output, characters.
const LONGEST_NAME: usize = 100;

/// Names of the outputs, each another one.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Names(Vec<String>);

/// Reads names between commas.
pub(crate) fn names_list(text: &str) -> Result<Names, String> {
    let names: Vec<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
    let is_wrong = |(at, name): (usize, &String)| {
        let is_twin = names.iter().take(at).any(|other| other == name);
        is_twin
            || name.is_empty()
            || name.chars().count() > LONGEST_NAME
            || name.chars().any(char::is_control)
    };
    match names.iter().enumerate().any(is_wrong) {
        true => Err(format!(
            "names of 1 to {LONGEST_NAME} characters, each another one, with commas between them"
        )),
        false => Ok(Names(names)),
    }
}

impl Names {
    /// Names of a model's outputs, one each and none that an input has.
    pub(crate) fn of(&self, model: &AskedModel, inputs: &Inputs) -> Result<Self, Failure> {
        let outputs: usize = model.output_sizes().iter().sum();
        if self.0.len() != outputs {
            return Err(Failure::input(format!(
                "--outputs has {} names, and the model answers with {outputs} numbers (outputSizes {:?})",
                self.0.len(),
                model.output_sizes()
            )));
        }
        match self.0.iter().find(|name| inputs.names.contains(name)) {
            Some(name) => Err(Failure::input(format!(
                "--outputs: {name:?} is the name of an input"
            ))),
            None => Ok(self.clone()),
        }
    }

    /// Names of outputs that nobody named: `y`, or `y1`, `y2`, and `y2_1` of the first number of several in the second of several vectors.
    pub(crate) fn usual(model: &AskedModel, inputs: &Inputs) -> Result<Self, Failure> {
        let names = STEMS.map(|stem| numbered(stem, model.output_sizes()));
        let free = |names: &Vec<String>| !names.iter().any(|name| inputs.names.contains(name));
        let names = names.into_iter().find(free);
        names.map(Self).ok_or_else(|| {
            Failure::input(
                "inputs have the names that outputs would be given: name the outputs by --outputs",
            )
        })
    }
}

fn numbered(stem: &str, sizes: &[usize]) -> Vec<String> {
    let in_vector = |(vector, size): (usize, &usize)| -> Vec<String> {
        let name = |at: usize| match (sizes.len(), *size) {
            (1, 1) => stem.to_owned(),
            (1, _) => format!("{stem}{}", at + 1),
            (_, 1) => format!("{stem}{}", vector + 1),
            _ => format!("{stem}{}_{}", vector + 1, at + 1),
        };
        (0..*size).map(name).collect()
    };
    sizes.iter().enumerate().flat_map(in_vector).collect()
}

/// Runs as a file of values, with all digits, `nan` where a run failed.
pub(super) fn values_csv(names: &Names, runs: &Runs) -> String {
    let id = "id".to_owned();
    let mut text = csv_cell::line(std::iter::once(&id).chain(&names.0));
    for (id, outcome) in runs {
        // Writing to a string never fails.
        let _ = write!(text, "{id}");
        for output in 0..names.0.len() {
            let value = outcome.as_ref().ok().and_then(|values| values.get(output));
            // 17 digits: fewer would be taken for rounded ones.
            let _ = match value {
                Some(value) => write!(text, ",{value:.16e}"),
                None => write!(text, ",nan"),
            };
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use documents::own_model::value_table::ValueTable;

    #[test]
    fn numbers_have_names_by_their_vectors() {
        assert_eq!(numbered("y", &[1]), ["y"]);
        assert_eq!(numbered("y", &[3]), ["y1", "y2", "y3"]);
        assert_eq!(numbered("y", &[1, 2, 0]), ["y1", "y2_1", "y2_2"]);
        assert_eq!(
            names_list("a, b c").map(|names| names.0),
            Ok(vec!["a".to_owned(), "b c".to_owned()])
        );
        for text in ["", "a,", "a,a", "a\u{1b}", &"x".repeat(101)] {
            assert!(names_list(text).is_err(), "{text}");
        }
    }

    #[test]
    fn values_read_back_to_the_bit() {
        let values = [0.1 + 0.2, -0.0, 5e-324, f64::MAX, 1.0];
        let mut runs: Runs = values
            .into_iter()
            .map(|value| Ok(vec![value]))
            .enumerate()
            .collect();
        runs.insert(5, Err("diverged".to_owned()));
        let text = values_csv(&Names(vec!["=a,\"b\"".to_owned()]), &runs);
        let table = ValueTable::of_model(&text, &["a".to_owned()]).expect("reads");
        assert_eq!(table.outputs(), ["=a,\"b\""]);
        let found = table.leading_rows();
        for (at, value) in values.into_iter().enumerate() {
            assert_eq!(found[[at, 0]].to_bits(), value.to_bits());
        }
        assert!(found[[5, 0]].is_nan());
        assert_eq!(table.half_units(), [0.0]);
    }
}
