//! Cycles of a run: presses, strokes, stances. They are what is left out whole, and what the bootstrap draws.

use crate::align::pieces;
use crate::recipe::CycleRule;
use crate::recording::Recording;

/// A contact that begins above the threshold ends below this share of it, so that noise at the threshold makes no cycles.
const END_SHARE: f64 = 0.5;
/// Pieces of a run where nothing says what a cycle is.
const TENTHS: f64 = 10.0;

/// The number of each row's cycle, from 0.
pub fn cycles(recording: &Recording, rule: &CycleRule) -> Vec<usize> {
    let first = recording.time_s.first().copied().unwrap_or(0.0);
    match rule {
        CycleRule::Column(_) => recording
            .cycle
            .clone()
            .unwrap_or_else(|| vec![0; recording.rows()]),
        CycleRule::PauseS(pause_s) => {
            let found = pieces(&recording.time_s, *pause_s);
            let numbered = found.into_iter().enumerate();
            numbered
                .flat_map(|(number, piece)| piece.map(move |_| number))
                .collect()
        }
        CycleRule::ThresholdN(threshold) => by_threshold(recording, *threshold),
        CycleRule::BlockS(block_s) => blocks(&recording.time_s, first, *block_s),
        CycleRule::Tenths => {
            let last = recording.time_s.last().copied().unwrap_or(first);
            // The last row belongs to the last tenth.
            let block_s = (last - first) * (1.0 + 1e-9) / TENTHS;
            blocks(&recording.time_s, first, block_s)
        }
    }
}

/// Later blocks count as this one, 2^52: numbers of cycles are added over runs.
const LAST_BLOCK: f64 = 4_503_599_627_370_496.0;

fn blocks(time_s: &[f64], first: f64, block_s: f64) -> Vec<usize> {
    let block = |t: &f64| ((t - first) / block_s).floor().min(LAST_BLOCK);
    time_s
        .iter()
        .map(|t| if block_s > 0.0 { block(t) as usize } else { 0 })
        .collect()
}

fn by_threshold(recording: &Recording, threshold: f64) -> Vec<usize> {
    let (mut number, mut pressed) = (0, false);
    let total = |row: ndarray::ArrayView1<'_, f64>| {
        let known = row.iter().filter(|force| force.is_finite());
        known.map(|force| force * force).sum::<f64>().sqrt()
    };
    recording
        .forces
        .rows()
        .into_iter()
        .map(|row| {
            if row.iter().all(|force| !force.is_finite()) {
                return number;
            }
            let force = total(row);
            if pressed {
                pressed = force >= END_SHARE * threshold;
            } else if force >= threshold {
                pressed = true;
                number += 1;
            }
            number
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array2;

    fn recording(time_s: &[f64], forces: &[f64]) -> Recording {
        Recording {
            name: "r".to_owned(),
            time_s: time_s.to_vec(),
            signals: Array2::zeros((time_s.len(), 1)),
            forces: Array2::from_shape_vec((forces.len(), 1), forces.to_vec()).expect("a column"),
            cycle: None,
        }
    }

    #[test]
    fn each_rule_finds_its_cycles() {
        let time_s = [0.0, 1.0, 2.0, 5.0, 6.0, 7.0];
        let forces = [0.0, 4.0, 2.9, 1.0, 3.5, f64::NAN];
        let run = recording(&time_s, &forces);
        assert_eq!(cycles(&run, &CycleRule::PauseS(2.0)), [0, 0, 0, 1, 1, 1]);
        assert_eq!(cycles(&run, &CycleRule::BlockS(2.0)), [0, 0, 1, 2, 3, 3]);
        assert_eq!(
            cycles(&run, &CycleRule::ThresholdN(3.0)),
            [0, 1, 1, 1, 2, 2]
        );
        assert_eq!(cycles(&run, &CycleRule::Tenths), [0, 1, 2, 7, 8, 9]);
        let long = recording(&[0.0, 1e70], &[0.0, 1.0]);
        assert_eq!(cycles(&long, &CycleRule::BlockS(0.1)), [0, 1 << 52]);
    }
}
