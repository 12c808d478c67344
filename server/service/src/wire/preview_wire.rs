//! Preview of a document: what it would find, roughly and at once.

use results::{Answer, CutPoint, IndexMap, InputReport, RankedLocation};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

/// A study's places and layouts on the draft mesh. It claims nothing: no error is known.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Preview {
    /// Claim of the preview: `none`.
    pub claim: String,
    /// Mesh level: `draft`.
    pub level: String,
    /// Time from the request to the answer, s.
    pub wall_s: f64,
    /// Points that were solved.
    pub solves: usize,
    /// Parts that the study would have beside, whole sentences.
    pub left_out: Vec<String>,
    /// Inputs that varied.
    pub inputs: Vec<InputReport>,
    /// The answer, with the layout and its films; its verdict is unknown. Null where nothing has an index.
    #[serde(default)]
    pub answer: Option<Answer>,
    /// Ranked locations.
    pub locations: Vec<RankedLocation>,
    /// The response at the means.
    pub cut_point: CutPoint,
    /// A map of 31 x 11 places at most; null where the document asks for none.
    pub map: Option<IndexMap>,
    /// Notes that the user must know before believing the numbers, whole sentences.
    pub notes: Vec<String>,
}
