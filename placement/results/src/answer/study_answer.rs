//! The answer of a study in one sentence, how sure it is, and why.

use documents::parts::film_model::FilmModel;
use serde::{Deserialize, Serialize};

use super::assumption_findings::RestsOn;
use super::certainty_word::Certainty;
use super::film_sheet::SheetFilm;
use super::trade_answer::TradeAnswer;

/// Answer of a study: where the films go, how sure that is, and what could overturn it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Answer {
    /// The answer: the best layout and what it knows; where no layouts are asked for the best place, or the input that matters more than the depth below it.
    pub sentence: String,
    /// The answer in few characters, as lists of studies show it: `12 y films, 10.7 degrees`; null in results of earlier versions.
    #[serde(default)]
    pub brief: Option<String>,
    /// The weaker of the verdicts on layout and place, where several places are ranked; without layouts that on what the sentence tells.
    pub verdict: Certainty,
    /// Reason why it isn't surer, or why it is certain, with the figures that decide; whole sentences.
    pub reason: String,
    /// The best place; null where no location has an index.
    pub place: Option<PlaceAnswer>,
    /// The layout that answers the question, or the knee of the trade; null where none is asked for, or none has a score.
    pub layout: Option<LayoutAnswer>,
    /// The trade of films against errors; null where no layout has a score.
    #[serde(default)]
    pub trade: Option<TradeAnswer>,
    /// Films of the answer's layout, one by one, as they are glued.
    #[serde(default)]
    pub films: Vec<SheetFilm>,
    /// Assumptions that its layout's figures rest on most; null where no layout answers.
    #[serde(default)]
    pub rests_on: Option<RestsOn>,
    /// Inputs that matter, of all there are; null where the strain at the contact centre has no index.
    #[serde(default)]
    pub inputs: Option<InputsAnswer>,
    /// The film that gives most, where films' signals are read.
    #[serde(default)]
    pub signals: Option<SignalsAnswer>,
    /// Part that the model leaves out and that changes strains most; null where no effect is known.
    pub left_out: Option<LeftOut>,
    /// Price of a surer answer; null at the top of the ladder. Not part of the result's hash.
    pub surer: Option<Surer>,
}

/// Inputs in the order in which they matter for the strain at the contact centre.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct InputsAnswer {
    /// The inputs that matter most, in a sentence.
    pub sentence: String,
    /// Certainty that the first matters most.
    #[serde(default)]
    pub verdict: Certainty,
    /// Reason for the verdict, with the figures that decide.
    #[serde(default)]
    pub reason: String,
    /// Location at the contact centre.
    pub location: String,
    /// Direction of the strain: the one that varies more, of those asked for.
    pub direction: String,
    /// Share of each input, the greatest first.
    pub shares: Vec<InputShare>,
    /// Inputs that matter for what else the study is about: a film's volts, the layout's error of the angle.
    #[serde(default)]
    pub beside: Vec<InputsBeside>,
}

/// Inputs in the order in which they matter for another quantity than a strain, to first order in all of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct InputsBeside {
    /// Name of the quantity.
    pub quantity: String,
    /// The inputs that matter most, in a sentence.
    pub sentence: String,
    /// Standard deviation of the quantity by all of them together, in its unit.
    pub std: f64,
    /// Unit of the quantity: `V`, `degrees`.
    pub unit: String,
    /// Share of each input, the greatest first; of a layout's error also that of `noise`.
    pub shares: Vec<InputShare>,
}

/// The film that gives most, at the largest load on the study's own tire.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct SignalsAnswer {
    /// The film in a sentence, with the next.
    pub sentence: String,
    /// Certainty that none of those read gives more.
    pub verdict: Certainty,
    /// Reason for the verdict, with the figures that decide.
    pub reason: String,
    /// Model of the film: the most detailed of those that are read.
    pub film: FilmModel,
    /// Position of the film in the section.
    pub position: String,
    /// Direction of its length: `x` or `y`.
    pub direction: String,
    /// Vertical force of the ground, N.
    pub load_n: f64,
    /// Voltage where nothing draws charge, V.
    pub open_circuit_v: f64,
    /// Claimed error of that, V; null without a coarser mesh.
    pub error_v: Option<f64>,
}

/// Share of an input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct InputShare {
    /// Name of the input.
    pub input: String,
    /// First-order index, 0 to 1.
    pub index: f64,
    /// Claimed error of the index; null where it isn't known.
    pub error: Option<f64>,
}

/// The location that ranks first.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct PlaceAnswer {
    /// All that share the first rank or, where the verdict is tied, can't be told from the first.
    pub names: Vec<String>,
    /// Direction of the strain, of those asked for, whose index is larger there.
    pub direction: String,
    /// First-order index of the location's own depth for that strain at the contact centre, 0 to 1.
    pub index: f64,
    /// Claimed error of the score; null where it isn't known.
    pub error: Option<f64>,
    /// Certainty of the first rank, by what locations are ranked by.
    pub verdict: Certainty,
    /// Reason for the verdict, with the figures that decide.
    pub reason: String,
    /// The place in a sentence.
    pub sentence: String,
}

/// The layout that answers the question; where none is asked, the knee of the trade.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LayoutAnswer {
    /// Rank in `layouts`.
    pub rank: usize,
    /// Description of the layout, as in `12 films along y at the crown, one every 30 degrees`.
    pub words: String,
    /// Count of its units; of a layout without units of its films.
    pub units: usize,
    /// All its films.
    pub film_count: usize,
    /// 95 of 100 simulated contacts are estimated better than this at the worst load, degrees.
    pub angle_error_deg: f64,
    /// Claimed error of that, degrees; null where there is no coarser mesh.
    pub error_deg: Option<f64>,
    /// Ranks of layouts that the errors can't tell from it.
    pub tied_with: Vec<usize>,
    /// Certainty that no layout that was tried answers better with as few films; where limits are asked, that it meets them and fewer films don't.
    pub verdict: Certainty,
    /// Reason for the verdict, with the figures that decide; where forces along and across are unknown, too, also what tells them from the angle.
    pub reason: String,
}

/// Part that the model leaves out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LeftOut {
    /// Name of the part, as in `model.left_out`.
    pub what: String,
    /// Reason for leaving it out, as in `model.left_out`.
    pub why: String,
    /// Largest change of a strain at P1, P2, ... over the largest strain of its direction.
    pub effect: f64,
    /// Sentence that says what it would do.
    pub sentence: String,
}

/// Price of a surer answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Surer {
    /// Sentence that says what the next level would do, and how long it would take.
    pub sentence: String,
    /// Mesh level to ask for.
    pub level: String,
    /// Work over that of this study with nothing solved before, by the law of solve times; null of solvers without one.
    pub times: Option<f64>,
    /// Expected wall-clock time with what the database has, s; null where it can't be told.
    pub expected_s: Option<f64>,
}
