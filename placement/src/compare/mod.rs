//! Studies side by side: what differs, and which differences are real.
//!
//! Two studies on the same kind of mesh are off by nearly the same, so that much of the mesh's error is gone from their difference. How much is left is
//! read off the coarser mesh as for a single index: with the indices I and J of two studies on the fine and I', J' on the coarser mesh
//!
//! ```text
//! mesh error of I - J = factor |(I - J) - (I' - J')|, the largest over the inputs
//! ```
//!
//! And two studies that were checked at the same points of their inputs miss nearly the same there: the method's error of the difference is that of the differences
//! of what they miss, point by point ([`gsa::judge::misses`]). Whatever two errors have not in common is independent, so that it adds up as e^2 = e_I^2 + e_J^2: all
//! of the mesh's where a study has no coarser one. A difference beyond its error is real, any other noise.

mod comparable;
mod compared_answers;
mod difference_verdict;

use std::collections::HashSet;

use fem_client::solver::direction::{Direction, PerDirection};
use gsa::judge::misses::{Claim, Misses, error_of_difference};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

pub use comparable::Comparable;
pub use difference_verdict::Verdict;

use compared_answers::{Answers, ComparedAnswer, ComparisonAnswer, answers};
use results::location_scores::GSI;
use results::{FormMisses, Output, RankedLocation, StudyCost};

/// A study to be compared.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Identifier of the study.
    pub id: String,
    /// Name of the study, or that of the design.
    pub name: String,
    /// Settings of the design, by path.
    pub set: Option<Map<String, Value>>,
    /// State of the study: `done` and others.
    pub state: String,
    /// Answer of the study, or why there is none, a sentence.
    pub result: Result<Comparable, String>,
}

/// The table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Comparison {
    /// The study that answers best, with its layout; null unless two have a layout.
    #[serde(default)]
    pub answer: Option<ComparisonAnswer>,
    /// The study that differences are taken from; null when none of them has a result.
    pub baseline: Option<String>,
    /// The studies in the order asked for.
    pub studies: Vec<ComparedStudy>,
    /// Every location of every study that has a result, best first.
    pub rows: Vec<ComparedLocation>,
    /// Notes that the reader must know before believing the differences, whole sentences.
    pub notes: Vec<String>,
}

/// A study of those compared.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ComparedStudy {
    /// Identifier of the study.
    pub id: String,
    /// Name of the study, or that of the design.
    pub name: String,
    /// Settings of the design, by path; null for a study that belongs to no sweep.
    #[schema(value_type = Option<Object>)]
    pub set: Option<Map<String, Value>>,
    /// `queued`, `running`, `done`, `failed` or `cancelled`.
    pub state: String,
    /// Reason why there is no result.
    pub reason: Option<String>,
    /// SHA-256 of its document.
    pub spec_sha256: Option<String>,
    /// Versions of the program and the solver.
    pub version: Option<String>,
    /// Mesh level.
    pub level: Option<String>,
    /// Vertical force at the means, N.
    pub reaction_n: Option<f64>,
    /// Standard deviation of the x strain at the contact centre: the signal of a film there.
    pub std_strain_x: Option<f64>,
    /// Standard deviation of the y strain there.
    pub std_strain_y: Option<f64>,
    /// First of the ranking.
    pub best: Option<String>,
    /// Whether its errors leave no doubt about that.
    pub best_certain: Option<bool>,
    /// Layout by which it is compared; null where no layout has a score.
    #[serde(default)]
    pub answer: Option<ComparedAnswer>,
    /// Angle between the units of that layout, degrees.
    pub layout_spacing_deg: Option<f64>,
    /// Position of that layout's units.
    pub layout_position: Option<String>,
    /// Cost of the study.
    pub cost: Option<StudyCost>,
}

/// A location in one of the studies.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ComparedLocation {
    /// The study.
    pub study: String,
    /// P1, P2, ...
    pub location: String,
    /// 1 is best.
    pub rank: usize,
    /// Whether the errors leave no doubt about this rank.
    pub rank_certain: bool,
    /// Places lost since the baseline, negative when gained, where equal locations share the place of the first of them; null there, and where
    /// it hasn't the location.
    pub rank_change: Option<i64>,
    /// Whether a change of the place is `real` (both places are certain), `noise` or `unknown`; null without one.
    pub rank_verdict: Option<Verdict>,
    /// First-order index of the location's own depth for the x strain at the contact centre.
    pub x: ComparedIndex,
    /// First-order index of the location's own depth for the y strain at the contact centre.
    pub y: ComparedIndex,
}

impl ComparedLocation {
    /// The index of a direction.
    pub fn in_direction(&self, direction: Direction) -> &ComparedIndex {
        match direction {
            Direction::X => &self.x,
            Direction::Y => &self.y,
        }
    }
}

/// An index beside the baseline's.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, utoipa::ToSchema)]
pub struct ComparedIndex {
    /// The index, percent.
    pub gsi_percent: Option<f64>,
    /// Error of the index, percentage points.
    pub error_percent: Option<f64>,
    /// The index minus the baseline's, percentage points; null in the baseline.
    pub difference_percent: Option<f64>,
    /// Error of the difference, percentage points: less than both errors together, where both meshes err alike.
    pub difference_error_percent: Option<f64>,
    /// Whether the difference is beyond its error.
    pub verdict: Option<Verdict>,
}

/// Most studies or designs that an answer tells or a table prints: more are nothing that anybody reads.
pub const MOST_TOLD: usize = 1000;

impl Comparison {
    /// Leaves out all but the best of more studies than these, and the baseline: the best by their answers, or the first where none has a layout.
    pub fn best(mut self, most: usize) -> Self {
        let all = self.studies.len();
        if all <= most {
            return self;
        }
        let rank = |study: &ComparedStudy| study.answer.as_ref().map_or(usize::MAX, |a| a.rank);
        let mut order: Vec<&ComparedStudy> = self.studies.iter().collect();
        order.sort_by_key(|study| rank(study));
        let told = order.into_iter().take(most).map(|study| study.id.clone());
        let told: HashSet<String> = told.chain(self.baseline.clone()).collect();
        self.studies.retain(|study| told.contains(&study.id));
        self.rows.retain(|row| told.contains(&row.study));
        self.notes.push(format!(
            "the best {most} of {all} studies are told, and the baseline; a file of the comparison (--format csv, or export over HTTP) has them all"
        ));
        self
    }
}

/// Compares studies with the one of this identifier, or with the first that has a result.
pub fn compare(entries: &[Entry], baseline: Option<&str>) -> Comparison {
    let answered = |entry: &&Entry| entry.result.is_ok();
    let wanted = |entry: &&Entry| baseline.is_none_or(|id| entry.id == id);
    let base = entries.iter().filter(wanted).find(answered);
    let base_result = base.and_then(|base| base.result.as_ref().ok());
    let mut rows = Vec::new();
    for entry in entries {
        let Ok(result) = &entry.result else {
            continue;
        };
        let other = base_result.filter(|_| base.is_some_and(|base| base.id != entry.id));
        let locations = result.locations.iter();
        rows.extend(locations.map(|location| row(&entry.id, result, location, other)));
    }
    let found: Vec<Option<&Comparable>> = entries
        .iter()
        .map(|entry| entry.result.as_ref().ok())
        .collect();
    let names: Vec<&str> = entries.iter().map(|entry| entry.name.as_str()).collect();
    let number = base.and_then(|base| entries.iter().position(|entry| entry.id == base.id));
    let answers = answers(&found, &names, number);
    let mut notes = notes(entries, base_result);
    notes.extend(note_on_questions(&answers));
    let of_studies = answers.of_studies.into_iter();
    let studies = entries.iter().zip(of_studies);
    Comparison {
        answer: answers.best,
        baseline: base.map(|base| base.id.clone()),
        studies: studies
            .map(|(entry, answer)| column(entry, answer))
            .collect(),
        notes,
        rows,
    }
}

fn note_on_questions(answers: &Answers) -> Option<String> {
    answers.questions_differ.then(|| {
        "the studies ask different questions: they are compared by the error of the angle with as many films as the baseline's answer has".to_owned()
    })
}

fn column(entry: &Entry, answer: Option<ComparedAnswer>) -> ComparedStudy {
    let result = entry.result.as_ref().ok();
    let best = result.and_then(|result| result.locations.first());
    let layout = result
        .zip(answer.as_ref())
        .and_then(|(result, answer)| result.layout_of_rank(answer.layout_rank));
    let signal = PerDirection::of(|direction| result?.centre[direction].as_ref()?.std);
    ComparedStudy {
        id: entry.id.clone(),
        name: entry.name.clone(),
        set: entry.set.clone(),
        state: entry.state.clone(),
        reason: entry.result.as_ref().err().cloned(),
        spec_sha256: result.map(|result| result.study.spec_sha256.clone()),
        version: result.map(|result| result.study.version.clone()),
        level: result.map(|result| result.level.clone()),
        reaction_n: result.map(|result| result.reaction_n),
        std_strain_x: signal.x,
        std_strain_y: signal.y,
        best: best.map(|best| best.name.clone()),
        best_certain: best.map(|best| best.rank_certain),
        answer,
        layout_spacing_deg: layout.and_then(|layout| layout.spacing_deg),
        layout_position: layout.map(|layout| layout.position.clone()),
        cost: result.map(|result| result.cost.clone()),
    }
}

fn row(
    id: &str,
    result: &Comparable,
    location: &RankedLocation,
    base: Option<&Comparable>,
) -> ComparedLocation {
    let same = |other: &&RankedLocation| other.name == location.name;
    let other = base.and_then(|base| base.locations.iter().find(same));
    let change = other.map(|other| places(location.rank) - places(other.rank));
    let certain = other.is_some_and(|other| location.rank_certain && other.rank_certain);
    let known = other.is_some_and(|other| other.knows_error() && location.knows_error());
    let index = PerDirection::of(|direction| {
        let against = base.zip(other);
        let against = against.map(|(base, other)| Index::of(base, other, direction));
        Index::of(result, location, direction).beside(against)
    });
    ComparedLocation {
        study: id.to_owned(),
        location: location.name.clone(),
        rank: location.rank,
        rank_certain: location.rank_certain,
        rank_change: change,
        rank_verdict: change.filter(|change| *change != 0).map(|_| match known {
            _ if certain => Verdict::Real,
            true => Verdict::Noise,
            false => Verdict::Unknown,
        }),
        x: index.x,
        y: index.y,
    }
}

fn places(rank: usize) -> i64 {
    i64::try_from(rank).unwrap_or(i64::MAX)
}

/// An index of a location.
#[derive(Debug, Clone, Copy)]
struct Index<'r> {
    percent: Option<f64>,
    /// Percentage points.
    error: Option<f64>,
    /// Number of the input that it is of.
    input: Option<usize>,
    /// The strain that it is of.
    output: Option<&'r Output>,
}

impl<'r> Index<'r> {
    fn of(result: &'r Comparable, location: &RankedLocation, direction: Direction) -> Self {
        let name = location.input.as_ref();
        Self {
            percent: location.value(GSI, direction),
            error: location.error(GSI, direction),
            input: name.and_then(|name| result.inputs.iter().position(|i| i.name == *name)),
            output: result.centre[direction].as_ref(),
        }
    }

    /// Compares it with another study's.
    fn beside(self, other: Option<Self>) -> ComparedIndex {
        let alone = ComparedIndex {
            gsi_percent: self.percent,
            error_percent: self.error,
            ..ComparedIndex::default()
        };
        let difference = other.and_then(|other| Some((other, self.percent? - other.percent?)));
        let Some((other, difference)) = difference else {
            return alone;
        };
        let error = self.error_of_difference(other);
        ComparedIndex {
            difference_percent: Some(difference),
            difference_error_percent: error,
            verdict: Some(Verdict::of(difference, error)),
            ..alone
        }
    }

    /// Error of the difference from another study's, percentage points; `None` where one of their errors isn't known.
    fn error_of_difference(self, other: Self) -> Option<f64> {
        let (own, theirs) = (self.claim()?, other.claim()?);
        let meshes = self.output.zip(other.output);
        let Some(mesh) = meshes.and_then(|(output, other)| shared_mesh_error(output, other)) else {
            return self.error.zip(other.error).map(|(a, b)| a.hypot(b));
        };
        let method = match (self.input, other.input) {
            (Some(input), Some(same)) if input == same => {
                error_of_difference(input, own.claim(), theirs.claim())
            }
            _ => own.error.hypot(theirs.error),
        };
        Some(100.0 * (mesh + method).min(1.0))
    }

    /// The method's part of the error.
    fn claim(self) -> Option<MethodClaim> {
        let (error, output) = (self.error? / 100.0, self.output?);
        Some(MethodClaim {
            error: (error - output.error.mesh.unwrap_or(0.0)).max(0.0),
            misses: output.misses.as_ref().map(FormMisses::misses),
        })
    }
}

/// Claim of a method's error, absolute.
struct MethodClaim {
    error: f64,
    misses: Option<Misses>,
}

impl MethodClaim {
    fn claim(&self) -> Claim<'_> {
        Claim {
            error: self.error,
            misses: self.misses.as_ref(),
        }
    }
}

/// Returns the error that the meshes leave of the difference between two studies' indices of a strain, absolute; `None` where a coarser mesh is
/// missing, or the studies vary different inputs.
fn shared_mesh_error(ours: &Output, theirs: &Output) -> Option<f64> {
    let (fine, coarse) = (ours.first_order.as_ref()?, ours.coarser.as_ref()?);
    let (other_fine, other_coarse) = (theirs.first_order.as_ref()?, theirs.coarser.as_ref()?);
    if fine.len() != other_fine.len() {
        return None;
    }
    let factor = coarse.factor.max(other_coarse.factor);
    let on_fine = fine.iter().zip(other_fine).map(|(i, j)| i - j);
    let coarse_pairs = coarse.first_order.iter().zip(&other_coarse.first_order);
    let on_coarse = coarse_pairs.map(|(i, j)| i - j);
    let left = on_fine.zip(on_coarse).map(|(a, b)| factor * (a - b).abs());
    Some(left.fold(0.0, f64::max).min(1.0))
}

fn notes(entries: &[Entry], base: Option<&Comparable>) -> Vec<String> {
    let mut notes = Vec::new();
    let results = || {
        entries
            .iter()
            .filter_map(|entry| entry.result.as_ref().ok())
    };
    let Some(base) = base else {
        let nobody = if results().next().is_some() {
            "the baseline has no result, so that there are no differences from it"
        } else {
            "no study has a result: the reasons stand beside them"
        };
        return vec![nobody.to_owned()];
    };
    let differ = |part: fn(&Comparable) -> &str| results().any(|r| part(r) != part(base));
    if differ(|result| &result.level) {
        notes.push(
            "the studies are on meshes of different levels: a part of their differences is the meshes'".to_owned(),
        );
    }
    if differ(|result| &result.study.version) {
        notes.push(
            "the studies are of different versions of the program, which the differences may come from".to_owned(),
        );
    }
    let vary = |result: &Comparable| {
        let inputs = result.inputs.iter();
        inputs.map(|input| input.vary.clone()).collect::<Vec<_>>()
    };
    if results().any(|result| vary(result) != vary(base)) {
        notes.push(
            "the studies vary different inputs: an index is a share of what these inputs do together".to_owned(),
        );
    }
    if results().any(|result| result.locations.iter().any(|l| !l.knows_error())) {
        notes.push(
            "of a draft no error is known, so that nothing can be said of its differences: accuracy.preset = \"coarse\" is the cheapest mesh that knows its own".to_owned(),
        );
    }
    notes
}

#[cfg(test)]
mod tests;
