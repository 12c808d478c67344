//! Sensitivity of a model that others run: from the values so far to indices, and to the points that are still to be run.
//!
//! Nothing is kept between rounds: inputs, method and values say all.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::Fault;
use gsa::campaign::Campaign;
use gsa::design::DesignError;
use gsa::method::Kind;
use gsa::method::analysis::Analysis;

use crate::own_model::analysis_document::{AskedAnalysis, of_values};
use crate::own_model::fingerprint::fingerprint;
use crate::own_model::inputs_document::Inputs;
use crate::own_model::value_table::{Planned, ValueTable};

/// An analysis as far as its values go.
#[derive(Debug, Clone, PartialEq)]
pub struct OwnAnalysis<'a> {
    inputs: &'a Inputs,
    values: &'a ValueTable,
    campaign: Campaign,
    found: Option<Vec<Analysis>>,
}

impl<'a> OwnAnalysis<'a> {
    /// Tells the method the values of a file, one round of points after the other.
    ///
    /// # Errors
    /// A design that doesn't exist, and values of points that nobody planned, or planned otherwise.
    pub fn of(inputs: &'a Inputs, values: &'a ValueTable) -> Result<Self, Vec<Fault>> {
        let analysis = Self::replayed(inputs, values)?;
        analysis.check_plan().map(|()| analysis)
    }

    /// Analyses what was asked for.
    ///
    /// # Errors
    /// As [`OwnAnalysis::of`], with pointers into the document that asked.
    pub fn asked(asked: &'a AskedAnalysis) -> Result<Self, Vec<Fault>> {
        let analysis = Self::replayed(&asked.inputs, &asked.values)?;
        analysis.check_plan().map_err(of_values)?;
        Ok(analysis)
    }

    fn replayed(inputs: &'a Inputs, values: &'a ValueTable) -> Result<Self, Vec<Fault>> {
        let rows = values.leading_rows();
        let replayed = Campaign::replay(&inputs.laws, inputs.method, &rows.view());
        let (campaign, found) = replayed.map_err(|error| no_plan(&error))?;
        Ok(Self {
            inputs,
            values,
            campaign,
            found: found.map(|found| as_printed(found, values)),
        })
    }

    fn check_plan(&self) -> Result<(), Vec<Fault>> {
        self.values.check_plan(&Planned {
            inputs: &self.inputs.names,
            points: self.points(),
            fingerprint: &fingerprint_of(self.inputs)?,
        })
    }

    /// Names of the inputs.
    pub fn inputs(&self) -> &[String] {
        &self.inputs.names
    }

    /// The values so far.
    pub fn values(&self) -> &ValueTable {
        self.values
    }

    /// The points so far, run or not.
    pub fn points(&self) -> &[Vec<f64>] {
        self.campaign.points()
    }

    /// Returns the points that are still to be run, by number.
    pub fn wanted(&self) -> Vec<usize> {
        let all = 0..self.points().len();
        all.filter(|id| !self.values.has(*id)).collect()
    }

    /// Analyses of the outputs, one each; nothing while the first points lack some.
    pub fn found(&self) -> Option<&[Analysis]> {
        self.found.as_deref()
    }

    /// Advice where the indices say little, or nothing yet.
    pub fn advice(&self) -> Option<String> {
        let Some(found) = &self.found else {
            return Some(self.values.missing_words(self.points().len()));
        };
        if !found.iter().any(says_little) {
            return None;
        }
        let method = &self.inputs.method;
        match method.kind {
            Kind::Auto if !self.wanted().is_empty() => None,
            Kind::Auto => Some(format!(
                "an error is as large as the indices: auto found no further points within most_runs = {}, so raise that",
                method.most_runs
            )),
            _ => Some(format!(
                "an error is as large as the indices: {MORE_POINTS}"
            )),
        }
    }
}

/// Advice where a method with a plan of its own says little.
const MORE_POINTS: &str = "method = { kind = \"auto\" } beside the inputs asks for more points until it is within its tolerance; the values that you have serve it, too";

/// The fingerprint of what these inputs plan before there are values.
///
/// # Errors
/// A design that doesn't exist.
pub fn fingerprint_of(inputs: &Inputs) -> Result<String, Vec<Fault>> {
    let campaign = Campaign::new(&inputs.laws, inputs.method).map_err(|error| no_plan(&error))?;
    Ok(fingerprint(&inputs.names, campaign.points()))
}

fn no_plan(error: &DesignError) -> Vec<Fault> {
    vec![Fault {
        pointer: "/inputs".to_owned(),
        detail: error.to_string(),
    }]
}

/// Adds to the errors what digits that weren't printed may do.
fn as_printed(found: Vec<Analysis>, values: &ValueTable) -> Vec<Analysis> {
    let printed = found.into_iter().zip(values.half_units());
    let printed = printed.map(|(found, half_unit)| match half_unit > 0.0 {
        true => found.of_printed(half_unit),
        false => found,
    });
    printed.collect()
}

/// Whether the claimed error is as large as the largest index.
fn says_little(found: &Analysis) -> bool {
    let indices = found.first_order.iter().flatten();
    let largest = indices.copied().fold(0.0, f64::max);
    let error = found.error.total.filter(|_| found.first_order.is_some());
    error.is_some_and(|error| error >= largest)
}
