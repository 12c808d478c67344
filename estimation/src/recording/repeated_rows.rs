//! Rows that stand in two recordings: the same stretch of one measurement, cut and saved anew.

use ndarray::ArrayView2;

use crate::recording::Recording;

/// Rows that are looked for together. Measured anew, a signal whose noise is a thousandth of its range is as near as [`SAME`] in one of nine rows: in all of them once in 10^30.
const ROWS: usize = 32;
/// Places of a recording whose rows are looked for in another one, at most.
const PLACES: usize = 24;
/// Rows at which places are looked for, over all pairs of recordings: a second's work. Of many recordings fewer places are looked for, of very many none.
const MOST_LOOKS: usize = 50_000_000;
/// Share of a column's range by which values may differ: other printed digits.
const SAME: f64 = 2e-4;
/// Share of a column's range that it must cover in the rows that are looked for: what stands still is like all else that does.
const MOVING: f64 = 0.05;

/// Pairs of recordings that share a stretch, by their numbers, the earlier one first, each with the row where it begins.
pub fn repeated_pairs(recordings: &[Recording]) -> Vec<[(usize, usize); 2]> {
    let pairs =
        || (0..recordings.len()).flat_map(|later| (0..later).map(move |earlier| [earlier, later]));
    let rows = pairs().map(|pair| {
        pair.map(|k| recordings[k].rows())
            .into_iter()
            .max()
            .unwrap_or(0)
    });
    let places = PLACES.min(MOST_LOOKS / rows.sum::<usize>().max(1));
    if places == 0 {
        return Vec::new();
    }
    let shared = |[earlier, later]: [usize; 2]| {
        let [first, second] = repeated(&recordings[earlier], &recordings[later], places)?;
        Some([(earlier, first), (later, second)])
    };
    pairs().filter_map(shared).collect()
}

/// First rows of a stretch that both have; `None` where they share none at so many places, or nothing moves.
fn repeated(one: &Recording, other: &Recording, places: usize) -> Option<[usize; 2]> {
    let (long, short) = if one.rows() >= other.rows() {
        (one, other)
    } else {
        (other, one)
    };
    let last = short.rows().checked_sub(ROWS)?;
    let ranges = ranges(short);
    let step = last.div_ceil(places).max(1);
    let mut places = (0..=last)
        .step_by(step)
        .filter(|place| moves(short, *place, &ranges));
    let [in_short, in_long] = places.find_map(|place| {
        let mut starts = 0..=long.rows() - ROWS;
        let found = starts.find(|start| are_alike(long, *start, short, place, &ranges))?;
        Some([place, found])
    })?;
    Some(if one.rows() >= other.rows() {
        [in_long, in_short]
    } else {
        [in_short, in_long]
    })
}

/// Range of each signal.
fn ranges(run: &Recording) -> Vec<f64> {
    let of = |values: ArrayView2<'_, f64>, column: usize| {
        let known = values
            .column(column)
            .into_iter()
            .copied()
            .filter(|x| x.is_finite());
        let (low, high) = known.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        (high - low).max(0.0)
    };
    (0..run.signals.ncols())
        .map(|column| of(run.signals.view(), column))
        .collect()
}

/// Whether a signal moves in the rows from a place on.
fn moves(run: &Recording, place: usize, ranges: &[f64]) -> bool {
    let columns = run.signals.columns().into_iter().zip(ranges);
    let mut covered = columns.map(|(signal, range)| {
        let rows = (place..place + ROWS).map(|row| signal[row]);
        let (low, high) = rows.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        *range > 0.0 && high - low > MOVING * range
    });
    covered.any(|moves| moves)
}

fn are_alike(
    long: &Recording,
    in_long: usize,
    short: &Recording,
    in_short: usize,
    ranges: &[f64],
) -> bool {
    (0..ROWS).all(|row| {
        let pairs = long
            .signals
            .row(in_long + row)
            .into_iter()
            .zip(short.signals.row(in_short + row));
        let mut pairs = pairs.zip(ranges);
        pairs.all(|((a, b), range)| (a - b).abs() <= SAME * range || (a.is_nan() && b.is_nan()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array2;

    /// Two signals of presses, with noise of a hundredth of their range.
    fn run(seed: usize, rows: std::ops::Range<usize>, digits: i32) -> Recording {
        let value = |row: usize, signal: usize| {
            let noise = ((row * row * (7 + 2 * signal) + 31 * seed) as f64).sin();
            let press = (row as f64 * 0.16).sin().powi(2) * (1.0 + signal as f64);
            let unit = 10f64.powi(digits);
            ((press + 0.01 * noise) * unit).round() / unit
        };
        let from = rows.start;
        Recording {
            name: "r".to_owned(),
            time_s: rows.clone().map(|row| row as f64).collect(),
            signals: Array2::from_shape_fn((rows.len(), 2), |(row, signal)| {
                value(from + row, signal)
            }),
            forces: Array2::zeros((rows.len(), 1)),
            cycle: None,
        }
    }

    #[test]
    fn a_later_part_saved_anew_is_found_and_a_run_like_it_is_not() {
        let whole = run(1, 0..240, 5);
        let later = run(1, 80..240, 4);
        assert_eq!(repeated(&whole, &later, PLACES), Some([80, 0]));
        assert_eq!(repeated(&later, &whole, PLACES), Some([0, 80]));
        // Its end alone: row 200 of the whole is row 100 of the other, which begins with a run of its own.
        let mut joined = run(2, 0..100, 4);
        let end = run(1, 200..240, 4);
        joined.time_s = (0..140).map(f64::from).collect();
        joined.signals = ndarray::concatenate![ndarray::Axis(0), joined.signals, end.signals];
        let found = repeated(&whole, &joined, PLACES).expect("they share rows");
        assert_eq!(found[0] - 200, found[1] - 100);
        assert_eq!(repeated(&whole, &run(2, 0..240, 4), PLACES), None);
        assert_eq!(repeated(&whole, &run(1, 0..10, 4), PLACES), None);
    }

    #[test]
    fn pairs_are_named_and_very_many_recordings_are_not_looked_through() {
        let runs = [run(1, 0..240, 5), run(2, 0..240, 5), run(1, 80..240, 4)];
        assert_eq!(repeated_pairs(&runs), [[(0, 80), (2, 0)]]);
        // 5000 recordings of 40 rows are 12 million pairs.
        let many = vec![run(1, 0..40, 5); 5000];
        assert!(repeated_pairs(&many).is_empty());
    }
}
