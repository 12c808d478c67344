//! The trade of films against errors.

use documents::study::question::Question;
use serde::{Deserialize, Serialize};

/// Trade of films against errors: the best layout of each number of films, and which of them answers the question.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct TradeAnswer {
    /// Question of the document; empty where none is asked.
    pub question: Question,
    /// Best layout of each number of films, fewest first: that with the least error of the angle, or the one that comes closest to the limits asked for.
    pub rows: Vec<TradeRow>,
    /// Row that answers, from 0: the question's, or the knee where none is asked; null where no layout meets the question.
    pub picked: Option<usize>,
    /// Knee, a row from 0: from there on twice the films don't halve the error; null where every layout loses the contact.
    pub knee: Option<usize>,
    /// Layouts that were tried: named in the document, found by its search, or on its menu.
    pub tried: usize,
    /// Layouts of the menu that weren't simulated, as their bounds show that others with as few films are better.
    pub screened: usize,
    /// Layouts of the menu whose films have no room.
    pub without_room: usize,
    /// Most films that the question allows, by their number and their cost; null where it has no limit.
    #[serde(default)]
    pub most_films: Option<usize>,
    /// Sentence that says what was tried.
    pub menu: String,
}

/// Best layout of a number of films.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct TradeRow {
    /// Number of films.
    pub film_count: usize,
    /// Rank of the layout in `layouts`.
    pub rank: usize,
    /// Index of the layout in the list of layouts, from 0: mirror images share a rank.
    pub index: usize,
    /// Description of the layout, as in `12 films along y at the crown, one every 30 degrees`.
    pub words: String,
    /// Simulated 95th percentile of the angle's error at its worst load, degrees.
    pub angle_error_deg: f64,
    /// Claimed error of that, degrees; null where there is no coarser mesh.
    pub angle_claim_deg: Option<f64>,
    /// Root mean square error of the vertical force at the load where that is largest, N.
    pub force_error_n: Option<f64>,
    /// Claimed error of that, N; null where there is no coarser mesh.
    pub force_claim_n: Option<f64>,
    /// Cost of the films that aren't glued on already, and of a channel for each; null where the question tells no costs.
    #[serde(default)]
    pub cost: Option<f64>,
    /// Whether it meets every limit that is asked for; null where none is.
    pub meets: Option<bool>,
    /// Whether fewer films do worse.
    pub is_front: bool,
}
