//! Findings of a study's layouts together.

use documents::parts::film_place::FilmPlace;
use serde::{Deserialize, Serialize};

use crate::answer::AssumptionFindings;
use crate::film::FilmAnglesReport;

/// Findings of a study's layouts together: loads, knees, fronts, kinds of film.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LayoutFindings {
    /// Mesh level of the fields, which is fine to 60 degrees from the contact.
    pub level: String,
    /// Unit of films' signals: `strain`, or `V` of glued ones. Noise, weakest signals, candidates' signals and rings are in it.
    pub unit: String,
    /// Length and width of the layouts' films, mm; absent of points.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub size_mm: Option<[f64; 2]>,
    /// Coarser level that shows their errors.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub coarser_level: Option<String>,
    /// The loads at which layouts are scored.
    pub loads: Vec<LayoutLoad>,
    /// Contacts as they come, where the document has their laws.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub contacts: Option<ContactFindings>,
    /// Films that are glued on and solved with the tire around the wheel: how far their signals are off, and would be by a transfer alone.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub films: Option<FilmAnglesReport>,
    /// Assumptions of the layout that answers, changed one at a time; absent where no layout answers.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub assumptions: Option<AssumptionFindings>,
    /// Menu of layouts, where the document names none.
    #[serde(default)]
    pub menu: MenuFindings,
    /// Layouts that no other beats with as few films, least films first.
    pub front: Vec<FrontLayout>,
    /// Kendall's tau between the order by simulated errors and that by the bound's worst error times the root of the number of films.
    pub tau_of_bound: Option<f64>,
    /// Searches, and what they looked at.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub searches: Vec<LayoutSearch>,
    /// Kinds of film, ranked by several criteria.
    pub candidates: Vec<CandidateFilm>,
    /// Films' signals around the wheel.
    pub rings: Vec<StrainRing>,
    /// Reasons why something is missing, whole sentences.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub reasons: Vec<String>,
}

/// Response surface of contacts as they come, and how far it is off at contacts that it hasn't seen.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ContactFindings {
    /// Quantities with what their laws reach from and to, in words.
    pub laws: Vec<String>,
    /// Contacts of all quantities at once by which it was judged.
    pub checks: usize,
    /// Root mean square error of the signals there within 30 degrees of the contact, over the crown's largest at that depth.
    pub signal_error_rms: f64,
    /// Claim that 95 % of the errors of signals at other such contacts are within this, over the crown's largest: Student's t for so few contacts. None of a study before claims.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub signal_claim: Option<f64>,
    /// Largest error of a signal there, over the crown's largest.
    pub signal_error_largest: f64,
    /// Root mean square error of the signals' slopes over the contact's angle there, over the crown's steepest; none of a study that didn't judge them.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub slope_error_rms: Option<f64>,
    /// Claim for such slopes.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub slope_claim: Option<f64>,
    /// Largest error of such a slope.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub slope_error_largest: Option<f64>,
    /// Root mean square error of the vertical force there, N.
    pub force_error_n: f64,
    /// Claim for the force, N.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub force_claim_n: Option<f64>,
    /// Quantities whose laws reach beyond what could be solved, in words: what is drawn ends there.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub short: Vec<String>,
}

/// Layouts that were tried, and those of the menu that aren't in the list.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct MenuFindings {
    /// Count of those that weren't simulated: their bounds show that others with as few films are better.
    pub screened: usize,
    /// Count of those whose films have no room.
    pub without_room: usize,
    /// Sentence that says what was tried.
    pub sentence: String,
}

/// A load at which layouts are scored.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LayoutLoad {
    /// Height of the ground above the inflated outer radius, mm.
    pub depth_mm: Option<f64>,
    /// Vertical force, N.
    pub load_n: Option<f64>,
    /// Derivative of the force by the depth, N/mm.
    pub force_slope_n_per_mm: Option<f64>,
    /// Shear findings by dragging the ground, where forces along and across the wheel are unknown, too.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub shear: Option<LoadShear>,
    /// Knees: the number of units from which on each section angle and set of films is dense enough.
    pub knees: Vec<Knee>,
    /// Reason why there are no scores.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub reason: Option<String>,
}

/// Findings by dragging the ground a little at a load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LoadShear {
    /// Forces along the wheel and across it by the shifts that way, N/mm.
    pub slopes_n_per_mm: [f64; 2],
    /// Force from which the ground slides: the coefficient of friction times the load, N.
    pub sliding_n: f64,
}

/// Knee: the number of units from which on more of them bring no more than their number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Knee {
    /// Section angle from the crown, degrees.
    pub section_deg: f64,
    /// Directions of the films of each unit.
    pub films: Vec<String>,
    /// The number of units; null where even the most that were tried aren't enough.
    pub units: Option<usize>,
    /// Worst bound times the root of the number of units of a dense ring, degrees.
    pub dense_deg: f64,
    /// Ratio of the worst bound times the root of the number of units every 60 degrees to that of a dense ring; null where they are blind.
    pub of_60_deg: Option<f64>,
}

/// A layout that no other beats with as few films.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FrontLayout {
    /// Count of its films.
    pub film_count: usize,
    /// Simulated 95th percentile of the angle's error at its worst load, degrees.
    pub simulated_p95_angle_error_deg: f64,
    /// Index in the list of layouts, from 0.
    pub index: usize,
}

/// Search for layouts, and what it looked at.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct LayoutSearch {
    /// Films of the layouts.
    pub films: usize,
    /// Places that a film may have.
    pub places: usize,
    /// `exhaustive`, or `greedy and exchange`.
    pub method: String,
    /// Criterion of the search: `bound`, or `interval errors`, which count contacts that are mistaken for others, too.
    pub criterion: String,
    /// Layouts whose criterion was computed.
    pub looked_at: usize,
    /// Bound of the angle with a flat prior of the best one, root mean square over angles and loads, degrees; null where no layout of so many films was found that has
    /// room.
    pub bayes_angle_error_deg: Option<f64>,
    /// Films of the best layout.
    pub best: Vec<FilmPlace>,
}

/// A kind of film: where in the section, along which direction, how large.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct CandidateFilm {
    /// Section angle from the crown, degrees.
    pub section_deg: f64,
    /// Direction of its length.
    pub direction: String,
    /// Length of the film, mm; null of a point.
    pub length_mm: Option<f64>,
    /// Width of the film, mm; null of a point.
    pub width_mm: Option<f64>,
    /// Largest signal around the wheel, over all loads.
    pub signal: f64,
    /// Root of the mean information on the contact angle over the turn and the loads, 1/degree, at the noise of the layouts.
    pub angle_information: f64,
    /// Root of the mean information on the depth, 1/mm.
    pub depth_information: f64,
    /// Error of the information on the angle by the coarser mesh.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub angle_information_error: Option<f64>,
}

/// Signals around the wheel at one load, of one kind of film: strains, or volts of glued films.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct StrainRing {
    /// Section angle from the crown, degrees.
    pub section_deg: f64,
    /// Direction.
    pub direction: String,
    /// Depth of the load, mm.
    pub depth_mm: f64,
    /// Strains from -180 to 179 degrees from the contact.
    pub strain: Vec<f64>,
    /// Derivative by the depth, 1/mm.
    pub by_depth: Vec<f64>,
    /// Largest error of the signal by the coarser mesh.
    pub strain_error: Option<f64>,
    /// Largest error of the derivative by the coarser mesh, 1/mm.
    pub by_depth_error: Option<f64>,
}
