//! Learns an estimator: every candidate of every force judged, the best learnt from all rows, on all cores.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Instant;

use document::fault::Fault;
use estimation::estimator::{
    Estimator, FORMAT, FeatureRanges, ForceModel, Stream, VERSION, interval_factor,
};
use estimation::fit_report::{
    FitCost, ForceReport, Ranking, RecordingFigures, Report, Tried, promise,
};
use estimation::model::contract::FitError;
use estimation::recipe::{FeatureSet, Kind, Recipe, SplitKind};
use estimation::recording::Recording;
use estimation::recording::named_columns::NamedColumns;
use estimation::recording::suspect_signals::suspect_signals;
use estimation::rows::{LabelledRows, Runs, Start};
use estimation::split::strictest;
use estimation::validation::{
    ANOTHER_SESSION, BegunRuns, Candidate, Judged, LearntModel, Said, Splits, Tested, blend,
    candidates, judge, rolled, rolled_r2,
};
use placement::points::worker_threads::in_parallel;
use serde::{Deserialize, Serialize};
use store::content::sha256;

use crate::forces::look::suspect_note::suspect_note;
use crate::forces::recorded_texts::{NamedText, read_runs};
use crate::wire::estimator_wire::{FitProgress, FitStage, LeftOutRows};

/// Fit of an estimator.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// The model.
    pub estimator: Estimator,
    /// Report of what was found.
    pub report: Report,
    /// Predictions of the chosen models for rows that they hadn't learnt from, one list a force.
    pub left_out: Vec<LeftOutRows>,
}

/// Reason why there is no fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FitFailure {
    /// The recipe or the recordings are wrong.
    Input(Vec<Fault>),
    /// Another reason, a sentence.
    Other(String),
}

/// Work of a fit: on how many threads, and who is told.
#[derive(Clone, Copy)]
pub struct Work<'a> {
    /// Threads.
    pub threads: usize,
    /// Is told how far it is.
    pub told: &'a (dyn Fn(FitProgress) + Sync),
}

/// Learns from recordings.
///
/// # Errors
/// See [`FitFailure`]; all faults of recipe and recordings are told at once.
pub fn fit(recipe: &Recipe, files: &[NamedText], work: Work<'_>) -> Result<Fit, FitFailure> {
    let begun = Instant::now();
    let runs = read_runs(recipe, files).map_err(FitFailure::Input)?;
    let start = start(recipe, &runs, work);
    let rows = rows_of_forces(recipe, &runs, start);
    let splits: Vec<Splits> = rows
        .iter()
        .map(|rows| Splits::new(rows, recipe, runs.interval_s.1))
        .collect();
    let (rankings, failures) = judged(recipe, &rows, &splits, work)?;
    let elsewhere = begun_runs(recipe, (&runs, start), &rows, &splits);
    let judged = Rankings {
        rows: &rows,
        splits: &splits,
        rankings: &rankings,
        begun: &elsewhere,
    };
    let (models, tried) = learnt(recipe, judged, work)?;
    let settings = runs.stream_settings(recipe, start);
    let features = runs.features(&settings, start);
    let by = splits.first().map_or(SplitKind::Cycle, |splits| splits.by);
    let estimator = Estimator {
        format: FORMAT.to_owned(),
        version: VERSION,
        columns: runs.names.clone(),
        stream: Stream::new(&runs, recipe, start),
        zero: runs.zero(),
        interval_s: runs.interval_s,
        ranges: runs.ranges(&features),
        feature_ranges: FeatureRanges::of(&models, &runs, &features),
        relations: runs.relations(),
        promise: by,
        recipe: recipe.clone(),
        forces: models,
    };
    let named = || runs.names.forces.iter().zip(&rankings);
    let reports: Vec<ForceReport> = named()
        .zip(&tried)
        .filter_map(|((force, ranking), tried)| ranking.report(force, tried))
        .collect();
    let mut notes: Vec<String> = named()
        .flat_map(|(force, ranking)| ranking.notes(force))
        .collect();
    let failed =
        |(force, failure): &(usize, String)| format!("{}: {failure}", runs.names.forces[*force]);
    notes.extend(failures.iter().map(failed));
    let treated = recipe.preprocess.suspect_rows;
    notes.extend(suspect_note(&runs, files, treated));
    notes.extend(more_notes(&runs, start, recipe));
    let report = Report {
        recordings: figures_of(&runs, files),
        forces: reports,
        promise: promise(by),
        notes,
        cost: FitCost {
            candidates: rankings.iter().map(|ranking| ranking.judged.len()).sum(),
            wall_s: begun.elapsed().as_secs_f64(),
        },
    };
    let left_out = named()
        .zip(&rows)
        .map(|((force, ranking), rows)| left_out_rows(force, ranking, rows));
    Ok(Fit {
        left_out: left_out.collect(),
        estimator,
        report,
    })
}

fn rows_of_forces(recipe: &Recipe, runs: &Runs, start: Start) -> Vec<LabelledRows> {
    let features = runs.features(&runs.stream_settings(recipe, start), start);
    (0..runs.names.forces.len())
        .map(|force| runs.of_force(force, &features))
        .collect()
}

/// Reading that is taken off: as the recipe says, or as left-out runs say of lines and processes on raw signals.
fn start(recipe: &Recipe, runs: &Runs, work: Work<'_>) -> Start {
    if let Some(start) = runs.start(recipe) {
        return start;
    }
    let tried: Vec<(Start, Vec<LabelledRows>)> = [Start::First, Start::Kept]
        .map(|start| (start, rows_of_forces(recipe, runs, start)))
        .into();
    let kinds = [Kind::Ridge, Kind::Gpr].map(|kind| Candidate {
        kind,
        features: FeatureSet::Raw,
    });
    let pieces: Vec<(usize, usize, Candidate)> = (0..tried.len())
        .flat_map(|way| {
            (0..runs.names.forces.len()).flat_map(move |force| kinds.map(|kind| (way, force, kind)))
        })
        .collect();
    let errors = told_in_parallel(FitStage::StartValue, pieces.len(), work, |piece| {
        let (way, force, candidate) = pieces[piece];
        let rows = &tried[way].1[force];
        let splits = Splits::new(rows, recipe, runs.interval_s.1);
        let judged = judge(candidate, rows, &splits, recipe, false).ok()?;
        judged
            .on(splits.by)
            .map(|figures| figures.choosing().rmse / figures.choosing().mean_rmse)
    });
    // The better of the two models, summed over forces.
    let of_way = |way: usize| -> f64 {
        let least = |force: usize| {
            let here = pieces
                .iter()
                .zip(&errors)
                .filter(|((w, f, _), _)| *w == way && *f == force);
            here.filter_map(|(_, error)| *error)
                .fold(f64::INFINITY, f64::min)
        };
        (0..runs.names.forces.len()).map(least).sum()
    };
    match of_way(0) <= of_way(1) {
        true => Start::First,
        false => Start::Kept,
    }
}

/// A force by its number, and why a candidate of it couldn't be learnt.
type Failures = Vec<(usize, String)>;

/// All candidates of all forces.
fn judged(
    recipe: &Recipe,
    rows: &[LabelledRows],
    splits: &[Splits],
    work: Work<'_>,
) -> Result<(Vec<Ranking>, Failures), FitFailure> {
    let all = candidates(recipe);
    // Networks and large sets take longest: first, so that no core waits for the last of them.
    let mut pieces: Vec<(usize, Candidate)> = all
        .iter()
        .flat_map(|candidate| (0..rows.len()).map(move |force| (force, *candidate)))
        .collect();
    pieces.reverse();
    let judged = told_in_parallel(FitStage::Judging, pieces.len(), work, |piece| {
        let (force, candidate) = pieces[piece];
        judge(candidate, &rows[force], &splits[force], recipe, true)
    });
    let mut of_forces: Vec<Vec<Judged>> = vec![Vec::new(); rows.len()];
    let mut failures = Vec::new();
    for ((force, candidate), judged) in pieces.iter().zip(judged) {
        match judged {
            Ok(judged) => of_forces[*force].push(judged),
            Err(reason) => {
                let (kind, features) = (candidate.kind.as_str(), candidate.features.as_str());
                failures.push((
                    *force,
                    format!("{kind} on {features} features couldn't be judged: {reason}"),
                ));
            }
        }
    }
    if of_forces.iter().any(Vec::is_empty) {
        let faults = failures.into_iter().map(|(_, detail)| Fault {
            pointer: "/validation/by".to_owned(),
            detail,
        });
        return Err(FitFailure::Input(faults.take(1).collect()));
    }
    let rankings = of_forces.into_iter().zip(rows).zip(splits);
    let rankings = rankings.map(|((mut judged, rows), splits)| {
        judged.extend(blend(&judged, splits.by, rows, recipe));
        Ranking::new(judged, splits.by)
    });
    Ok((rankings.collect(), failures))
}

/// The runs that are left out of each force, begun elsewhere.
fn begun_runs(
    recipe: &Recipe,
    (runs, start): (&Runs, Start),
    rows: &[LabelledRows],
    splits: &[Splits],
) -> Vec<BegunRuns> {
    let of_force = |(force, (rows, splits)): (usize, (&LabelledRows, &Splits))| {
        BegunRuns::new((runs, force, start), rows, splits.of_runs(), recipe)
    };
    let forces = rows.iter().zip(splits).enumerate();
    forces.map(of_force).collect()
}

/// All that was judged, force by force.
#[derive(Clone, Copy)]
struct Rankings<'a> {
    rows: &'a [LabelledRows],
    splits: &'a [Splits],
    rankings: &'a [Ranking],
    begun: &'a [BegunRuns],
}

/// Piece of the work on a model that was chosen.
enum Piece {
    Model(Result<Box<LearntModel>, FitError>),
    Chance(Option<Tested>),
    Begun(Option<Said>),
}

/// Members of a force, and what they said.
#[derive(Default)]
struct Members {
    models: Vec<LearntModel>,
    rolled: Vec<Tested>,
    begun: Vec<Said>,
}

/// The chosen models, learnt from all rows; what chance would do, and what runs that begin elsewhere do to them.
fn learnt(
    recipe: &Recipe,
    judged: Rankings<'_>,
    work: Work<'_>,
) -> Result<(Vec<ForceModel>, Vec<Tried>), FitFailure> {
    let chosen = |(force, ranking): (usize, &Ranking)| {
        let members = ranking.chosen().map(|chosen| chosen.members.clone());
        let members = members.unwrap_or_default().into_iter();
        members
            .map(move |member| (force, member))
            .collect::<Vec<_>>()
    };
    let members: Vec<(usize, Candidate)> = judged
        .rankings
        .iter()
        .enumerate()
        .flat_map(chosen)
        .collect();
    // Of each member three pieces, so that no core waits for all of them.
    let pieces = 3 * members.len();
    let made = told_in_parallel(FitStage::Learning, pieces, work, |piece| {
        let (force, member) = members[piece / 3];
        let (rows, splits) = (&judged.rows[force], &judged.splits[force]);
        match piece % 3 {
            0 => Piece::Model(LearntModel::whole(member, rows, recipe).map(Box::new)),
            1 => Piece::Chance(rolled(member, rows, splits, recipe)),
            _ => {
                let said = judged.begun[force].said(member, rows, splits.of_runs(), recipe);
                Piece::Begun(said.ok())
            }
        }
    });
    let mut of_forces: Vec<Members> = judged.rows.iter().map(|_| Members::default()).collect();
    for ((force, _), piece) in members.iter().flat_map(|member| [member; 3]).zip(made) {
        let of_force = &mut of_forces[*force];
        match piece {
            Piece::Model(model) => {
                let model = model.map_err(|error| FitFailure::Other(error.to_string()))?;
                of_force.models.push(*model);
            }
            Piece::Chance(rolled) => of_force.rolled.extend(rolled),
            Piece::Begun(said) => of_force.begun.extend(said),
        }
    }
    let forces = of_forces.into_iter().enumerate();
    Ok(forces
        .filter_map(|(force, members)| learnt_force(judged, force, members))
        .unzip())
}

/// The model of a force and what was tried with it: told of all its members, or of none.
fn learnt_force(
    judged: Rankings<'_>,
    force: usize,
    members: Members,
) -> Option<(ForceModel, Tried)> {
    let Members {
        models,
        rolled,
        begun,
    } = members;
    let (rows, by) = (&judged.rows[force], judged.splits[force].by);
    let all = models.len();
    let begun = (begun.len() == all).then_some(begun);
    let runs = &judged.begun[force];
    let tried = Tried {
        rolled_r2: rolled_r2(&rolled).filter(|_| rolled.len() == all),
        begun: begun.as_ref().and_then(|said| runs.errors(rows, said)),
    };
    let mut model = ForceModel::of(models, judged.rankings[force].chosen()?, by, rows);
    model.loaded_above_n = Some(runs.loaded_above(&begun.unwrap_or_default()));
    Some((model, tried))
}

/// Most signals that a note names.
const MOST_NAMED: usize = 12;

/// Says which columns were read as what.
fn columns_read(names: &NamedColumns) -> String {
    let listed = |names: &[String]| {
        let shown: Vec<String> = names
            .iter()
            .take(MOST_NAMED)
            .map(|name| name.escape_debug().to_string())
            .collect();
        match names.len().saturating_sub(MOST_NAMED) {
            0 => shown.join(", "),
            more => format!("{} and {more} more", shown.join(", ")),
        }
    };
    let unit = names
        .time_unit
        .map(|unit| format!(" ({}, read as seconds)", unit.in_words()))
        .unwrap_or_default();
    let time = format!("{}{unit}", names.time.escape_debug());
    let (signals, forces) = (listed(&names.signals), listed(&names.forces));
    let cycle = names
        .cycle
        .iter()
        .map(|name| format!("; {} tells cycles apart", name.escape_debug()));
    format!(
        "columns: time {time}, forces {forces}, {} signals {signals}{}",
        names.signals.len(),
        cycle.collect::<String>()
    )
}

fn more_notes(runs: &Runs, start: Start, recipe: &Recipe) -> Vec<String> {
    let mut notes = suspect_signals(&runs.runs, &runs.names);
    notes.push(columns_read(&runs.names));
    notes.extend(runs.names.conversions());
    notes.push(match (start, recipe.preprocess.start_rows) {
        (Start::First, 1) => "the first reading of each run is taken off its signals".to_owned(),
        (Start::First, rows) => format!("the median of the first {rows} readings of each run is taken off its signals"),
        (Start::Kept, _) => "the first reading of each run is kept".to_owned(),
        (Start::Unloaded, _) => "each run's median without a force is taken off its signals; of a recording that is estimated the first reading is, unless force apply --start says what".to_owned(),
    });
    if start == Start::First && !runs.begin_unloaded(recipe.preprocess.start_rows) {
        notes.push(
            "a run begins with a force: its first reading isn't what the signals are without one"
                .to_owned(),
        );
    }
    let strictest = strictest_of(runs);
    if strictest == SplitKind::Cycle {
        notes.push(format!(
            "one run: its left-out cycles are tested with signals moved by {} % of their ranges, as another session may read them",
            100.0 * ANOTHER_SESSION
        ));
    }
    if let Some(by) = recipe.validation.by
        && by != strictest
        && by != SplitKind::Time
        && by != SplitKind::Frequency
    {
        notes.push(format!(
            "models are chosen by {}, though {} could be left out",
            by.as_str(),
            plural(strictest)
        ));
    }
    notes
}

fn strictest_of(runs: &Runs) -> SplitKind {
    strictest(runs.places())
}

fn plural(kind: SplitKind) -> &'static str {
    if kind == SplitKind::Run {
        "whole runs"
    } else {
        "whole cycles"
    }
}

/// Returns the figures of each recording, as a report tells.
pub fn figures_of(runs: &Runs, files: &[NamedText]) -> Vec<RecordingFigures> {
    let each = runs.runs.iter().zip(files).enumerate();
    each.map(|(run, (recording, file))| figures(runs, run, recording, file))
        .collect()
}

fn figures(runs: &Runs, run: usize, recording: &Recording, file: &NamedText) -> RecordingFigures {
    RecordingFigures {
        file: file.name.clone(),
        rows: recording.rows(),
        labelled: recording.labelled(),
        cycles: runs.cycles_of(run),
        rate_hz: recording.interval_s().map(f64::recip),
        sha256: sha256(&[file.text.as_bytes()]),
    }
}

fn left_out_rows(force: &str, ranking: &Ranking, rows: &LabelledRows) -> LeftOutRows {
    let mut found = LeftOutRows {
        force: force.to_owned(),
        run: Vec::new(),
        time_s: Vec::new(),
        truth_n: Vec::new(),
        estimate_n: Vec::new(),
        low_n: Vec::new(),
        high_n: Vec::new(),
    };
    let mut said = ranking
        .chosen()
        .map_or(Vec::new(), |chosen| chosen.left_out(ranking.by).to_vec());
    said.sort_by_key(|row| row.row);
    let chosen = ranking.chosen();
    let factor = chosen.map_or(0.0, |chosen| interval_factor(chosen, ranking.by));
    for row in said {
        let half = factor * row.deviation;
        found.run.push(rows.places[row.row].run);
        found.time_s.push(rows.places[row.row].time_s);
        found.truth_n.push(row.truth);
        found.estimate_n.push(row.mean);
        found.low_n.push(row.mean - half);
        found.high_n.push(row.mean + half);
    }
    found
}

/// Computes `of` of each number below `count`, on all threads.
fn told_in_parallel<T: Send>(
    stage: FitStage,
    count: usize,
    work: Work<'_>,
    of: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    let tell = |done| {
        (work.told)(FitProgress {
            stage,
            done,
            of: count,
        });
    };
    tell(0);
    let done = AtomicUsize::new(0);
    let told = |piece| {
        let made = of(piece);
        tell(done.fetch_add(1, Ordering::Relaxed) + 1);
        made
    };
    let go_on = AtomicBool::new(false);
    in_parallel(count, work.threads, &go_on, told).expect("nobody stops it: its process is ended")
}
