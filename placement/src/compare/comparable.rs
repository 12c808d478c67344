//! Part of a result that a comparison reads.

use fem_client::solver::direction::{Direction, PerDirection};
use serde::{Deserialize, Serialize};

use results::{
    InputReport, LayoutAnswer, Output, RankedLayout, RankedLocation, StudyCost, StudyIdentity,
    StudyResult, TradeAnswer,
};

/// Part of a result that a comparison reads: of a result's document a tenth, so that thousands have room in memory.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Comparable {
    pub(super) study: StudyIdentity,
    /// Mesh level.
    pub(super) level: String,
    /// Vertical force at the means, N.
    pub(super) reaction_n: f64,
    pub(super) inputs: Vec<VariedInput>,
    /// Strain at the contact centre, by which locations are ranked.
    pub(super) centre: PerDirection<Option<Output>>,
    pub(super) locations: Vec<RankedLocation>,
    pub(super) answer: Option<AnswerPart>,
    /// Layouts of the answer's trade.
    layouts: Vec<LayoutPart>,
    pub(super) cost: StudyCost,
}

/// Input as it was understood, without its distribution.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct VariedInput {
    pub(super) name: String,
    /// Path of the scene's field.
    pub(super) vary: String,
}

/// Layout and trade of an answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct AnswerPart {
    pub(super) layout: Option<LayoutAnswer>,
    #[serde(default)]
    pub(super) trade: Option<TradeAnswer>,
}

/// Places of a ranked layout.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct LayoutPart {
    rank: usize,
    pub(super) spacing_deg: Option<f64>,
    pub(super) position: String,
}

impl Comparable {
    /// The part of a result.
    pub fn of(result: &StudyResult) -> Self {
        let answer = result.answer.as_ref();
        let trade = answer.and_then(|answer| answer.trade.as_ref());
        let rows = trade.map_or(&[][..], |trade| &trade.rows);
        let is_compared = |layout: &&RankedLayout| rows.iter().any(|row| row.rank == layout.rank);
        Self {
            study: result.study.clone(),
            level: result.model.level.clone(),
            reaction_n: result.cut_point.reaction_n,
            inputs: result.inputs.iter().map(VariedInput::of).collect(),
            centre: PerDirection::of(|direction| centre(result, direction).cloned()),
            locations: result.locations.clone(),
            answer: answer.map(|answer| AnswerPart {
                layout: answer.layout.clone(),
                trade: answer.trade.clone(),
            }),
            layouts: result
                .layouts
                .iter()
                .filter(is_compared)
                .map(LayoutPart::of)
                .collect(),
            cost: result.cost.clone(),
        }
    }

    /// The first layout of a rank.
    pub(super) fn layout_of_rank(&self, rank: usize) -> Option<&LayoutPart> {
        self.layouts.iter().find(|layout| layout.rank == rank)
    }
}

impl VariedInput {
    fn of(input: &InputReport) -> Self {
        Self {
            name: input.name.clone(),
            vary: input.vary.clone(),
        }
    }
}

impl LayoutPart {
    fn of(layout: &RankedLayout) -> Self {
        Self {
            rank: layout.rank,
            spacing_deg: layout.spacing_deg,
            position: layout.position.clone(),
        }
    }
}

/// The strain at the middle location in a direction.
fn centre(result: &StudyResult, direction: Direction) -> Option<&Output> {
    let of_direction = || {
        let outputs = result.outputs.iter();
        outputs.filter(move |output| output.direction == direction)
    };
    of_direction().nth(of_direction().count() / 2)
}
