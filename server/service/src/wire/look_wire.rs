//! Looks at recordings, before anything is learnt from them.

use document::fault::Fault;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

use super::estimator_wire::{RecipeDocument, RecordingDocument};

/// Recordings to look at, and how their columns are read.
#[derive(Debug, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct LookDocument {
    /// Recipe, as in `strainsite force fit`: its `columns` say what is read, its `preprocess` whether signals may be empty.
    #[schema(value_type = RecipeDocument, nullable = false, required = false)]
    pub recipe: Option<Value>,
    /// Recordings, one a run.
    #[schema(min_items = 1, max_items = 1000)]
    pub recordings: Vec<RecordingDocument>,
}

/// Look at recordings: what each column is taken for, and what stands in it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Look {
    /// Recordings that can be read, in the order in which they were given.
    pub recordings: Vec<RecordingLook>,
    /// Faults of those that can't be, as learning from them tells.
    pub faults: Vec<Fault>,
    /// Reasons for which nothing would be learnt from them, though they can be read.
    pub refusals: Vec<Fault>,
}

/// Recording that was looked at.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct RecordingLook {
    /// Name of the file.
    pub file: String,
    /// Count of its rows.
    pub rows: usize,
    /// Time of the first row, s.
    pub begin_s: f64,
    /// Time from the first row to the last, s.
    pub duration_s: f64,
    /// Rows a second; null of one row.
    pub rate_hz: Option<f64>,
    /// Intervals longer than ten typical ones.
    pub gaps: GapsLook,
    /// Cycles, by the recipe's rule.
    pub cycles: usize,
    /// Rows with at least one force.
    pub labelled: usize,
    /// Columns in the order of the file.
    pub columns: Vec<ColumnLook>,
    /// Sentences on the recording as a whole: forces that are converted, or that there are none.
    pub notes: Vec<String>,
    /// Columns over time, for plots; left out where nobody asked for them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub series: Option<RecordingSeries>,
}

/// Intervals longer than ten typical ones.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct GapsLook {
    /// Count of them.
    pub count: usize,
    /// The longest one; null where there is none.
    pub longest: Option<GapLook>,
    /// The first 20, in the order of time.
    pub first: Vec<GapLook>,
}

/// Time without a row.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct GapLook {
    /// Line in the file of the row before it.
    pub line: usize,
    /// Time of that row, s.
    pub begin_s: f64,
    /// Time to the next row, s.
    pub length_s: f64,
}

/// Part of a recording that a column is taken for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Taken {
    /// The time, or a part of it.
    Time,
    /// A force.
    Force,
    /// A signal.
    Signal,
    /// Entries that tell cycles apart.
    Cycle,
    /// No part: the column is left out.
    Nothing,
}

/// Column that was looked at. Figures of a force are in newtons, those of the time in seconds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ColumnLook {
    /// Name of the column in the file.
    pub column: String,
    /// Part that the column is taken for.
    pub taken: Taken,
    /// Name that estimates give the force; null of other columns.
    pub force: Option<String>,
    /// Newtons of one of a force's unit; null of other columns.
    pub newtons: Option<f64>,
    /// Unit of a time in words; null of other columns.
    pub time_unit: Option<String>,
    /// Rows with a number.
    pub measured: usize,
    /// Empty cells, and words for them.
    pub empty: usize,
    /// Cells with text, which are read in columns that are taken for nothing or tell cycles apart.
    pub texts: usize,
    /// Least number; null of none.
    pub least: Option<f64>,
    /// Greatest number; null of none.
    pub greatest: Option<f64>,
    /// Deviation of the noise: median size of the differences between neighbours, over sqrt(2) 0.6745.
    pub noise: Option<f64>,
    /// Median where no force acts: where each is below a twentieth of its largest.
    pub unloaded: Option<f64>,
    /// Median of the last third of the rows without a force less that of the first third; null of fewer than 30 such rows.
    pub drift: Option<f64>,
    /// Samples that stand alone: away from both neighbours by more than 20 robust deviations of the differences between neighbours.
    pub lone: LoneSamples,
    /// Sentences on what makes the column suspect.
    pub suspicions: Vec<String>,
}

/// Samples that stand alone.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct LoneSamples {
    /// Count of them.
    pub count: usize,
    /// The first 20.
    pub first: Vec<LoneSample>,
}

/// A sample that stands alone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct LoneSample {
    /// Line in the file.
    pub line: usize,
    /// Time, s.
    pub time_s: f64,
    /// Value.
    pub value: f64,
}

/// Columns of a recording over time, in bins of equal length from its first row to its last.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct RecordingSeries {
    /// Length of a bin, s.
    pub bin_s: f64,
    /// Columns with numbers, but for the time.
    pub columns: Vec<ColumnSeries>,
}

/// A column over time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct ColumnSeries {
    /// Name of the column in the file.
    pub column: String,
    /// Least number of each bin; null where there is none.
    pub least: Vec<Option<f64>>,
    /// Greatest number of each bin; null where there is none.
    pub greatest: Vec<Option<f64>>,
}
