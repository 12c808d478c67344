//! A left-out run that begins elsewhere: under a load, or as it is zeroed after lifting.

use crate::features::{StreamSettings, move_signals};
use crate::model::even_subset::even_subset;
use crate::recording::Recording;
use crate::recording::unloaded::{is_unloaded, largest_forces, liftings, reading_at};

/// Shares of a run's largest force under which it is begun.
pub(super) const LOADS: [f64; 3] = [0.25, 0.5, 1.0];
/// Rests between lifting and zero, s: those that the recordings have.
pub(super) const RESTS_S: [f64; 8] = [0.0, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0];
/// Most liftings of a run after which a rest is tried.
const MOST_LIFTINGS: usize = 4;
/// Most rows of a run that are estimated from one beginning.
const MOST_ROWS: usize = 100;

/// Place in a run at which it is begun.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Beginning {
    /// Row under a share of its largest force.
    Loaded { load: usize, force: f64 },
    /// Row so long after lifting, as the first of its zero.
    Rested { rest: usize },
    /// Row without a force, by the zero of the other runs.
    AtRest,
}

/// Run that is begun somewhere.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BegunRun {
    pub at: Beginning,
    /// Number of the fold that leaves it out.
    pub fold: usize,
    /// Rows that are estimated, among those with the force.
    pub rows: Vec<usize>,
    /// Offset of each signal there from what it is as recorded.
    pub offsets: Vec<f64>,
}

impl BegunRun {
    /// All features of a row as the run begins there, from those as recorded.
    pub fn moved(&self, mut features: Vec<f64>) -> Vec<f64> {
        move_signals(&mut features, self.offsets.iter().copied());
        features
    }
}

/// Run that its fold leaves out.
pub(super) struct LeftOutRun<'a> {
    pub run: &'a Recording,
    /// Number of the force.
    pub force: usize,
    /// Rows with the force: each in the run, and among all with the force.
    pub labelled: Vec<(usize, usize)>,
    pub settings: &'a StreamSettings,
    /// Reading that is taken off it as recorded.
    pub taken_off: Option<&'a Vec<f64>>,
    /// Zero of the runs that are learnt from.
    pub zero: Option<Vec<f64>>,
}

impl LeftOutRun<'_> {
    /// Begins it at all its places.
    pub fn begun(&self, fold: usize) -> Vec<BegunRun> {
        let loaded = self
            .loads()
            .map(|(at, row)| self.begin(fold, at, row, None));
        let zero = self.zero.as_ref();
        let rested = self.rests();
        let rested = rested
            .into_iter()
            .filter(|_| zero.is_some())
            .map(|(rest, row)| self.begin(fold, Beginning::Rested { rest }, row, zero));
        let mut begun: Vec<BegunRun> = loaded.chain(rested).collect();
        begun.extend(self.at_rest(fold));
        // A run that ends there has no rows to tell.
        begun.retain(|begun| !begun.rows.is_empty());
        begun
    }

    /// The first rows that are under a share of the largest force.
    fn loads(&self) -> impl Iterator<Item = (Beginning, usize)> {
        let most = largest_forces(self.run)[self.force];
        let forces = self.run.forces.column(self.force);
        let first = move |(load, share): (usize, f64)| {
            let mut sizes = forces.iter().map(|force| force.abs());
            let row = sizes.position(|size| size >= share * most)?;
            let force = forces[row].abs();
            Some((Beginning::Loaded { load, force }, row))
        };
        LOADS.into_iter().enumerate().filter_map(first)
    }

    /// Rows so long after a lifting, of a few liftings evenly taken.
    fn rests(&self) -> Vec<(usize, usize)> {
        let liftings = liftings(self.run);
        let time_s = &self.run.time_s;
        // Nothing presses until there is a zero.
        let more = self.settings.start_rows - 1;
        let of_rest = |(rest, rest_s): (usize, &f64)| {
            let rested = |(first, last): &(usize, usize)| {
                (*first..=*last)
                    .find(|row| time_s[*row] - time_s[*first] >= *rest_s && row + more <= *last)
            };
            let rows: Vec<usize> = liftings.iter().filter_map(rested).collect();
            let taken = even_subset(rows.len(), MOST_LIFTINGS);
            taken
                .into_iter()
                .map(move |place| (rest, rows[place]))
                .collect::<Vec<_>>()
        };
        RESTS_S.iter().enumerate().flat_map(of_rest).collect()
    }

    /// Begins it with a row whose reading is the zero. Where none is taken off, it counts by how far it is from the learnt one, if that is given.
    fn begin(&self, fold: usize, at: Beginning, row: usize, learnt: Option<&Vec<f64>>) -> BegunRun {
        // Windows that reach across the begin are short there.
        let settings = self.settings;
        let reach = settings.smooth_rows + settings.window_rows + settings.start_rows - 1;
        let time_s = &self.run.time_s;
        let settled_s = time_s[row] + settings.baseline_s.unwrap_or(0.0);
        let is_after = |(labelled, _): &&(usize, usize)| {
            *labelled > row + reach && time_s[*labelled] >= settled_s
        };
        let after: Vec<usize> = self
            .labelled
            .iter()
            .filter(is_after)
            .map(|(_, row)| *row)
            .collect();
        let taken = even_subset(after.len(), MOST_ROWS);
        BegunRun {
            at,
            fold,
            rows: taken.into_iter().map(|place| after[place]).collect(),
            offsets: self.offsets(
                self.taken_off.or(learnt),
                &reading_at(self.run, row, settings.start_rows),
            ),
        }
    }

    /// Begins it at its first row without a force, by the others' zero.
    fn at_rest(&self, fold: usize) -> Option<BegunRun> {
        let zero = self.zero.as_ref()?;
        let most = largest_forces(self.run);
        let mut labelled = self.labelled.iter();
        let (_, row) = labelled.find(|(place, _)| is_unloaded(self.run, *place, &most))?;
        Some(BegunRun {
            at: Beginning::AtRest,
            fold,
            rows: vec![*row],
            offsets: self.offsets(self.taken_off, zero),
        })
    }

    /// Offsets of signals of which this zero is taken off in place of another one; 0 where none is.
    fn offsets(&self, in_place_of: Option<&Vec<f64>>, zero: &[f64]) -> Vec<f64> {
        let sign = if self.settings.turn_sign { -1.0 } else { 1.0 };
        match in_place_of {
            Some(other) => other
                .iter()
                .zip(zero)
                .map(|(other, zero)| sign * (other - zero))
                .collect(),
            None => vec![0.0; zero.len()],
        }
    }
}
