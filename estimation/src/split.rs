//! Splits into rows that are learnt from and rows that are tested.
//!
//! Rows are those of all runs in a row, as [`Place`]s. Each split is a list of folds; together they test what they can, each row at most once.

use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::recipe::SplitKind;

/// Place of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Number of its run.
    pub run: usize,
    /// Number of the row in the run.
    pub row: usize,
    /// Number of its cycle, no two runs sharing one.
    pub cycle: usize,
    /// s
    pub time_s: f64,
}

/// Rows by their numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Fold {
    /// Learnt from.
    pub train: Vec<usize>,
    /// Rows that are tested.
    pub test: Vec<usize>,
}

/// Gap between rows that are learnt from and rows that are tested.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Rows of a run on either side of a left-out cycle that aren't learnt from: those whose windows reach across.
    pub rows: usize,
    /// Time before what is tested by time, s.
    pub time_s: f64,
}

/// Share of the rows that the random split tests: the paper's.
pub(crate) const RANDOM_SHARE: f64 = 0.2;
/// Most folds of left-out cycles and runs.
pub(crate) const MOST_FOLDS: usize = 5;
/// Parts of each run in time: the first is learnt from alone.
pub(crate) const TIME_PARTS: usize = 4;
/// Groups of cycles by their frequency.
pub(crate) const FREQUENCIES: usize = 3;
/// Groups whose median frequencies differ by less than this factor are one frequency.
const LEAST_SPREAD: f64 = 1.2;
/// Fewer rows are learnt nothing from.
const FEWEST_ROWS: usize = 10;

/// The folds of a split.
///
/// # Errors
/// A sentence that says why these rows can't be split so.
pub fn folds(kind: SplitKind, places: &[Place], gap: Gap, seed: u64) -> Result<Vec<Fold>, String> {
    let found = match kind {
        SplitKind::Random => random(places.len(), seed),
        SplitKind::Cycle => cycles(places, gap)?,
        SplitKind::Run => runs(places)?,
        SplitKind::Time => times(places, gap),
        SplitKind::Frequency => frequencies(places, gap)?,
    };
    let usable = |fold: &Fold| fold.train.len() >= FEWEST_ROWS && !fold.test.is_empty();
    let found: Vec<Fold> = found.into_iter().filter(usable).collect();
    if found.is_empty() {
        return Err(format!(
            "fewer than {FEWEST_ROWS} rows are left to learn from"
        ));
    }
    Ok(found)
}

/// The strictest split that rows allow: runs, or cycles of one run.
pub fn strictest(places: &[Place]) -> SplitKind {
    let first = places.first().map(|place| place.run);
    if places.iter().any(|place| Some(place.run) != first) {
        SplitKind::Run
    } else {
        SplitKind::Cycle
    }
}

fn random(rows: usize, seed: u64) -> Vec<Fold> {
    let mut order: Vec<usize> = (0..rows).collect();
    order.shuffle(&mut ChaCha8Rng::seed_from_u64(seed));
    let tested = (rows as f64 * RANDOM_SHARE).round() as usize;
    let (test, train) = order.split_at(tested);
    let sorted = |part: &[usize]| {
        let mut part = part.to_vec();
        part.sort_unstable();
        part
    };
    vec![Fold {
        train: sorted(train),
        test: sorted(test),
    }]
}

/// Folds that leave out groups of rows; `group` numbers each row's.
fn leave_out(places: &[Place], group: &[usize], gap_rows: usize) -> Vec<Fold> {
    let groups = group.iter().copied().max().map_or(0, |most| most + 1);
    let fold = |left_out: usize| {
        let test: Vec<usize> = (0..places.len())
            .filter(|row| group[*row] == left_out)
            .collect();
        let mut near = vec![false; places.len()];
        let tested: Vec<bool> = group.iter().map(|other| *other == left_out).collect();
        mark_near(places, &tested, gap_rows, &mut near);
        Fold {
            train: (0..places.len()).filter(|row| !near[*row]).collect(),
            test,
        }
    };
    (0..groups).map(fold).collect()
}

/// Marks what is tested and what lies within so many rows of it in the same run.
fn mark_near(places: &[Place], tested: &[bool], gap_rows: usize, near: &mut [bool]) {
    let within = |a: &Place, b: &Place| a.run == b.run && a.row.abs_diff(b.row) <= gap_rows;
    let mut last: Option<Place> = None;
    for row in 0..places.len() {
        last = if tested[row] { Some(places[row]) } else { last };
        near[row] |= last.is_some_and(|last| within(&last, &places[row]));
    }
    let mut next: Option<Place> = None;
    for row in (0..places.len()).rev() {
        next = if tested[row] { Some(places[row]) } else { next };
        near[row] |= next.is_some_and(|next| within(&next, &places[row]));
    }
}

/// A number from 0 for each distinct number, in their order.
fn ranks(numbers: impl Iterator<Item = usize> + Clone) -> Vec<usize> {
    let mut distinct: Vec<usize> = numbers.clone().collect();
    distinct.sort_unstable();
    distinct.dedup();
    numbers
        .map(|number| distinct.partition_point(|other| *other < number))
        .collect()
}

fn cycles(places: &[Place], gap: Gap) -> Result<Vec<Fold>, String> {
    let cycle = ranks(places.iter().map(|place| place.cycle));
    let count = cycle.iter().max().map_or(0, |most| most + 1);
    if count < 2 {
        return Err("there is one cycle: nothing can be left out".to_owned());
    }
    let group: Vec<usize> = cycle
        .iter()
        .map(|cycle| cycle % count.min(MOST_FOLDS))
        .collect();
    Ok(leave_out(places, &group, gap.rows))
}

fn runs(places: &[Place]) -> Result<Vec<Fold>, String> {
    let run = ranks(places.iter().map(|place| place.run));
    let count = run.iter().max().map_or(0, |most| most + 1);
    if count < 2 {
        return Err("there is one run: another recording is needed to leave one out".to_owned());
    }
    let group: Vec<usize> = run.iter().map(|run| run % count.min(MOST_FOLDS)).collect();
    Ok(leave_out(places, &group, 0))
}

/// Rolling origin within each run: parts 2 to 4 are tested on what was earlier in their runs.
fn times(places: &[Place], gap: Gap) -> Vec<Fold> {
    let mut span: std::collections::BTreeMap<usize, (f64, f64)> = std::collections::BTreeMap::new();
    for place in places {
        let (low, high) = span
            .entry(place.run)
            .or_insert((place.time_s, place.time_s));
        *low = low.min(place.time_s);
        *high = high.max(place.time_s);
    }
    let border = |place: &Place, part: usize| {
        let (low, high) = span[&place.run];
        low + (high - low) * part as f64 / TIME_PARTS as f64
    };
    let fold = |part: usize| Fold {
        train: (0..places.len())
            .filter(|row| places[*row].time_s < border(&places[*row], part) - gap.time_s)
            .collect(),
        test: (0..places.len())
            .filter(|row| {
                let place = &places[*row];
                let before_next = part + 1 == TIME_PARTS || place.time_s < border(place, part + 1);
                place.time_s >= border(place, part) && before_next
            })
            .collect(),
    };
    (1..TIME_PARTS).map(fold).collect()
}

/// Leaves out the slow, the middling and the fast cycles.
fn frequencies(places: &[Place], gap: Gap) -> Result<Vec<Fold>, String> {
    let cycle = ranks(places.iter().map(|place| place.cycle));
    let count = cycle.iter().max().map_or(0, |most| most + 1);
    if count < 2 * FREQUENCIES {
        let least = 2 * FREQUENCIES;
        return Err(format!(
            "{count} cycles are too few to tell slow from fast ones; {least} would do"
        ));
    }
    let mut span = vec![(f64::INFINITY, f64::NEG_INFINITY); count];
    for (place, cycle) in places.iter().zip(&cycle) {
        span[*cycle].0 = span[*cycle].0.min(place.time_s);
        span[*cycle].1 = span[*cycle].1.max(place.time_s);
    }
    let mut order: Vec<usize> = (0..count).collect();
    let length = |cycle: &usize| span[*cycle].1 - span[*cycle].0;
    order.sort_by(|a, b| length(a).total_cmp(&length(b)).then(a.cmp(b)));
    let middle = |number: usize| length(&order[(2 * number + 1) * count / (2 * FREQUENCIES)]);
    if (1..FREQUENCIES).any(|number| middle(number) < LEAST_SPREAD * middle(number - 1)) {
        return Err("the cycles have one frequency".to_owned());
    }
    let mut of_cycle = vec![0; count];
    for (place, cycle) in order.iter().enumerate() {
        of_cycle[*cycle] = place * FREQUENCIES / count;
    }
    let group: Vec<usize> = cycle.iter().map(|cycle| of_cycle[*cycle]).collect();
    Ok(leave_out(places, &group, gap.rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    const GAP: Gap = Gap {
        rows: 2,
        time_s: 0.5,
    };

    /// Two runs of 60 rows at 10 Hz, cycles of 10 rows, or of 4, 12 and 44 rows.
    fn places(even: bool) -> Vec<Place> {
        let of_row = |row: usize| match row {
            _ if even => row / 10,
            ..4 => 0,
            4..16 => 1,
            _ => 2,
        };
        let place = |(run, row): (usize, usize)| Place {
            run,
            row,
            cycle: 100 * run + of_row(row),
            time_s: row as f64 * 0.1,
        };
        (0..2)
            .flat_map(|run| (0..60).map(move |row| (run, row)))
            .map(place)
            .collect()
    }

    #[test]
    fn nothing_is_learnt_and_tested() {
        for kind in SplitKind::ALL {
            let places = places(kind != SplitKind::Frequency);
            let found = folds(kind, &places, GAP, 1).expect("folds");
            let mut tested = vec![0; places.len()];
            for fold in &found {
                assert!(
                    fold.train.iter().all(|row| !fold.test.contains(row)),
                    "{kind:?}"
                );
                fold.test.iter().for_each(|row| tested[*row] += 1);
            }
            assert!(tested.iter().all(|times| *times <= 1), "{kind:?}");
            let all = tested.iter().sum::<usize>();
            let expected = match kind {
                SplitKind::Random => 24,
                SplitKind::Time => 90,
                _ => 120,
            };
            assert_eq!(all, expected, "{kind:?}");
        }
    }

    #[test]
    fn what_is_left_out_is_left_out_whole() {
        let places = places(true);
        for fold in folds(SplitKind::Run, &places, GAP, 1).expect("folds") {
            let run = places[fold.test[0]].run;
            assert!(fold.test.iter().all(|row| places[*row].run == run));
            assert_eq!((fold.train.len(), fold.test.len()), (60, 60));
        }
        for fold in folds(SplitKind::Cycle, &places, GAP, 1).expect("folds") {
            for (learnt, tested) in fold
                .train
                .iter()
                .flat_map(|a| fold.test.iter().map(move |b| (a, b)))
            {
                let (a, b) = (&places[*learnt], &places[*tested]);
                assert!(a.cycle != b.cycle && (a.run != b.run || a.row.abs_diff(b.row) > 2));
            }
        }
        for fold in folds(SplitKind::Time, &places, GAP, 1).expect("folds") {
            let first = fold
                .test
                .iter()
                .map(|row| places[*row].time_s)
                .fold(f64::INFINITY, f64::min);
            assert!(
                fold.train
                    .iter()
                    .all(|row| places[*row].time_s < first - 0.4)
            );
        }
        let slow = folds(SplitKind::Frequency, &self::places(false), GAP, 1).expect("folds");
        let lengths: Vec<usize> = slow.iter().map(|fold| fold.test.len()).collect();
        assert_eq!(lengths, [8, 24, 88]);
    }

    #[test]
    fn what_cannot_be_split_says_why() {
        let one: Vec<Place> = places(true).into_iter().take(60).collect();
        assert!(
            folds(SplitKind::Run, &one, GAP, 1)
                .expect_err("one run")
                .contains("one run")
        );
        assert_eq!(strictest(&one), SplitKind::Cycle);
        assert_eq!(strictest(&places(true)), SplitKind::Run);
        let even = folds(SplitKind::Frequency, &places(true), GAP, 1).expect_err("even");
        assert!(even.contains("one frequency"));
        let cycle: Vec<Place> = one.into_iter().take(10).collect();
        assert!(folds(SplitKind::Cycle, &cycle, GAP, 1).is_err());
    }
}
