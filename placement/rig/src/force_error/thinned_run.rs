//! A run as an estimator reads it: features of every instant of the films' clock, of which few rows are kept.
//!
//! Features look back over earlier rows, so they are made of all of them before any is left out.

use estimation::features::{FeatureStream, GROUPS, StreamSettings};
use estimation::recipe::USUAL_BASELINE_S;
use estimation::recording::PAUSE_INTERVALS;
use ndarray::{Array2, ArrayView1, Axis};

use crate::contact_response::ContactResponse;
use crate::gait::stance::Stance;
use crate::rig_run::{FilmReadings, RigRun};
use crate::seeded_draws::{SeededDraws, Stream};
use documents::rig::rig_settings::RigSettings;

/// Rows of rolling mean and variance: the paper's.
pub(crate) const WINDOW_ROWS: usize = 10;
/// Rows are kept at this rate at most, Hz: five of the quickest stance.
const MOST_HZ: f64 = 40.0;
/// Rows of all runs that are learnt from, at most.
const MOST_ROWS: f64 = 2000.0;
/// Readings of one run whose random split is judged, one after another: about the paper's shorter recording of 2131.
pub(crate) const NEIGHBOURS: usize = 2000;
/// The golden ratio's fraction: multiples of it fill every interval evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A run's rows.
#[derive(Debug, Clone, PartialEq)]
pub struct ThinnedRun {
    /// Rows x (groups of films).
    pub features: Array2<f64>,
    /// Rows x forces along, across and vertical, N.
    pub true_force_n: Array2<f64>,
    /// Forces as a force sensor reads them, N.
    pub label_n: Array2<f64>,
    /// Each row's instant, s.
    pub time_s: Vec<f64>,
    /// Each row's number among all instants.
    pub instant: Vec<usize>,
    /// Each row's stance.
    pub stance: Vec<usize>,
    /// Count of the stances among them.
    pub stances: usize,
    /// Wheel angle of each row's contact, degrees.
    pub contact_deg: Vec<f64>,
}

/// Returns the number of instants of which one is kept where so many runs are recorded.
pub(crate) fn thinning(settings: &RigSettings, runs: usize) -> usize {
    let by_rate = settings.film_rate_hz / MOST_HZ;
    let instants = settings.film_rate_hz * settings.gait.longest_s() * runs as f64;
    by_rate.max(instants / MOST_ROWS).ceil().max(1.0) as usize
}

/// Picks one instant of each block of so many. Its place in the block moves, so that rows don't meet a steady gait always at the same point of its turn.
fn kept(instants: usize, of: usize) -> Vec<usize> {
    let place = |block: usize| {
        let share = (block as f64 * GOLDEN).fract();
        block * of + (share * of as f64) as usize
    };
    (0..instants / of).map(place).collect()
}

impl ThinnedRun {
    /// Records a run and keeps one of so many instants.
    pub fn recorded<R: ContactResponse + ?Sized>(
        response: &R,
        settings: &RigSettings,
        run: u64,
        one_of: usize,
    ) -> Self {
        let (stances, films) = RigRun::films_alone(response, settings, run);
        let rows = kept(films.time_s.len(), one_of);
        let count = stances.len();
        Self::of_rows(rows, &stances, count, &films, settings, run)
    }

    /// Records a run and keeps its first instants, each beside the next.
    pub(crate) fn begin_of<R: ContactResponse + ?Sized>(
        response: &R,
        settings: &RigSettings,
        run: u64,
    ) -> Self {
        let (stances, films) = RigRun::films_alone(response, settings, run);
        let rows: Vec<usize> = (0..films.time_s.len().min(NEIGHBOURS)).collect();
        let last = rows.last().map_or(0, |row| films.stance[*row]);
        Self::of_rows(rows, &stances, last + 1, &films, settings, run)
    }

    fn of_rows(
        rows: Vec<usize>,
        stances: &[Stance],
        count: usize,
        films: &FilmReadings,
        settings: &RigSettings,
        run: u64,
    ) -> Self {
        let stance: Vec<usize> = rows.iter().map(|row| films.stance[*row]).collect();
        let contact = |number: &usize| stances.get(*number).map_or(0.0, |it| it.contact_deg);
        let true_force_n = films.true_force_n.select(Axis(0), &rows);
        let mut draws = SeededDraws::new(settings.seed, run, Stream::Force);
        let noise_n = settings.force_sensor.noise_n;
        Self {
            label_n: true_force_n.mapv(|force| force + noise_n * draws.normal()),
            true_force_n,
            time_s: rows.iter().map(|row| films.time_s[*row]).collect(),
            contact_deg: stance.iter().map(contact).collect(),
            stance,
            stances: count,
            features: features_of(films, settings, &rows),
            instant: rows,
        }
    }

    /// Returns the run with a film that shows nothing: all its features are 0.
    pub(crate) fn with_dead_film(&self, film: usize) -> Self {
        let mut dead = self.clone();
        let films = dead.features.ncols() / GROUPS;
        for group in 0..GROUPS {
            dead.features.column_mut(group * films + film).fill(0.0);
        }
        dead
    }

    /// Whether the ground is touched at a row.
    pub fn touches(&self, row: usize) -> bool {
        self.true_force_n.row(row).iter().any(|force| *force != 0.0)
    }
}

/// Features of some instants, made of all of them. First readings are kept: a circuit begins without a charge, so they are noise.
fn features_of(films: &FilmReadings, settings: &RigSettings, rows: &[usize]) -> Array2<f64> {
    let mut stream = FeatureStream::new(StreamSettings {
        subtract_start: false,
        start_rows: 1,
        turn_sign: false,
        smooth_rows: 1,
        window_rows: WINDOW_ROWS,
        baseline_s: Some(USUAL_BASELINE_S),
        pause_s: PAUSE_INTERVALS / settings.film_rate_hz,
    });
    let mut found = Array2::zeros((rows.len(), GROUPS * films.volts.ncols()));
    let mut kept = 0;
    for (instant, time_s) in films.time_s.iter().enumerate() {
        let here = stream.push(*time_s, None, &films.volts.row(instant).to_vec());
        if rows.get(kept) == Some(&instant) {
            found.row_mut(kept).assign(&ArrayView1::from(&here));
            kept += 1;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bump_response::BumpResponse;
    use documents::rig::gait_settings::{Frequency, RunLength};

    fn short() -> RigSettings {
        let mut settings = RigSettings::default();
        settings.gait.length = RunLength::Seconds(3.0);
        settings.runs = 2;
        settings
    }

    #[test]
    fn few_rows_are_kept_of_long_runs_and_forty_hertz_of_short_ones() {
        assert_eq!(thinning(&short(), 2), 5);
        // 4 x 60 s x 200 Hz are 48 000 instants.
        assert_eq!(thinning(&RigSettings::default(), 4), 24);
    }

    #[test]
    fn rows_of_a_steady_gait_meet_all_of_its_turn() {
        // A turn of 100 instants, one of 25 kept: at even distances four places of the turn would be met.
        let mut places: Vec<usize> = kept(12_000, 25).iter().map(|row| row % 100).collect();
        places.sort_unstable();
        places.dedup();
        assert!(places.len() > 90, "{}", places.len());
        let rows = kept(103, 10);
        let in_blocks = rows
            .iter()
            .enumerate()
            .all(|(block, row)| row / 10 == block);
        assert!(rows.len() == 10 && in_blocks, "{rows:?}");
    }

    #[test]
    fn kept_rows_have_the_features_of_the_whole_stream() {
        let tire = BumpResponse::new(3);
        let (all, few) = (1, 7);
        let [all, few] = [all, few].map(|of| ThinnedRun::recorded(&tire, &short(), 0, of));
        assert_eq!(all.instant, (0..600).collect::<Vec<_>>());
        assert_eq!(all.features.select(Axis(0), &few.instant), few.features);
        assert_eq!(few.features.ncols(), 3 * GROUPS);
        let begin = ThinnedRun::begin_of(&tire, &short(), 0);
        assert_eq!(begin, all);
    }

    #[test]
    fn half_of_each_turn_touches_the_ground() {
        let all = ThinnedRun::recorded(&BumpResponse::new(3), &short(), 0, 1);
        let rows = all.time_s.len();
        let touching = (0..rows).filter(|row| all.touches(*row)).count();
        let share = touching as f64 / rows as f64;
        assert!((share - 0.5).abs() < 0.1, "{share}");
    }

    #[test]
    fn a_dead_film_is_one_whose_volts_are_zero() {
        let mut settings = short();
        settings.gait.frequency = Frequency::Fixed { hz: 2.0 };
        let (_, mut films) = RigRun::films_alone(&BumpResponse::new(3), &settings, 0);
        films.volts.column_mut(1).fill(0.0);
        let all: Vec<usize> = (0..films.time_s.len()).collect();
        let expected = features_of(&films, &settings, &all);
        let found = ThinnedRun::recorded(&BumpResponse::new(3), &settings, 0, 1).with_dead_film(1);
        assert_eq!(found.features, expected);
    }
}
