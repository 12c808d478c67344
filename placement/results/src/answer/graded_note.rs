//! Notes that the user must know before believing the numbers, with what they do to them.

use serde::{Deserialize, Serialize};

/// Effect of a note on the answer; gravest first.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, utoipa::ToSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Grade {
    /// Warning without which a reader may glue films elsewhere.
    ChangesAnswer,
    /// A figure means something else, or is less sure, than it seems.
    BearsOnFigure,
    /// True, and without consequence.
    ForTheRecord,
}

impl Grade {
    /// Grades, gravest first.
    pub const ALL: [Self; 3] = [Self::ChangesAnswer, Self::BearsOnFigure, Self::ForTheRecord];

    /// Returns the grade in words, for people.
    pub fn words(self) -> &'static str {
        match self {
            Self::ChangesAnswer => "changes the answer",
            Self::BearsOnFigure => "bears on a figure",
            Self::ForTheRecord => "for the record",
        }
    }
}

/// The part of a result that a note is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Topic {
    /// The ranked locations.
    Place,
    /// The ranked layouts.
    Layout,
    /// The map over the inner surface.
    Map,
    /// The sensitivity indices.
    Indices,
    /// Films' signals.
    Signals,
    /// Model: what is modelled, and what is left out.
    Model,
    /// Cost of the study.
    Cost,
}

/// A note with its grade.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct GradedNote {
    /// Effect on the answer.
    pub grade: Grade,
    /// Topic of the note.
    pub about: Topic,
    /// Whole sentences.
    pub text: String,
}

impl GradedNote {
    /// A note that changes the answer.
    pub fn changing(about: Topic, text: impl Into<String>) -> Self {
        Self::of(Grade::ChangesAnswer, about, text)
    }

    /// A note that bears on a figure.
    pub fn bearing(about: Topic, text: impl Into<String>) -> Self {
        Self::of(Grade::BearsOnFigure, about, text)
    }

    /// A note for the record.
    pub fn record(about: Topic, text: impl Into<String>) -> Self {
        Self::of(Grade::ForTheRecord, about, text)
    }

    /// A note of a grade.
    pub fn of(grade: Grade, about: Topic, text: impl Into<String>) -> Self {
        let text = text.into();
        Self { grade, about, text }
    }
}
