//! Signals that are no sensors: the reference itself, what somebody has estimated from it, moments that were measured with it, counters.

use ndarray::ArrayView1;

use crate::recording::Recording;
use crate::recording::named_columns::NamedColumns;

/// Share of a force's variance that a straight line of the reference itself leaves: a thousandth of its deviation, squared. No sensor is so good.
const REFERENCE: f64 = 1e-6;
/// Fewer rows tell nothing.
const FEWEST_ROWS: usize = 20;

/// A sentence about each signal that is hardly a sensor's.
pub fn suspect_signals(runs: &[Recording], names: &NamedColumns) -> Vec<String> {
    let numbered = names.signals.iter().enumerate();
    numbered
        .filter_map(|(signal, name)| suspicion(runs, names, signal, name))
        .collect()
}

/// A sentence about the signal of this number and name, if it is hardly a sensor's.
pub fn suspicion(
    runs: &[Recording],
    names: &NamedColumns,
    signal: usize,
    name: &str,
) -> Option<String> {
    let shown = name.escape_debug();
    let leave_out = format!("leave it out by not_signals = [{name:?}]");
    let mut forces = names.forces.iter().enumerate();
    let of_force =
        forces.find(|(force, _)| rest(runs, signal, *force).is_some_and(|rest| rest < REFERENCE));
    if let Some((_, force)) = of_force {
        return Some(format!(
            "signal {shown} is {} but for a straight line: the reference itself, which isn't there later. Errors here mean nothing with it; {leave_out}",
            force.escape_debug()
        ));
    }
    if runs.iter().all(|run| counts(run.signals.column(signal))) {
        return Some(format!(
            "signal {shown} rises by the same in every row, as a counter or a clock does; {leave_out}"
        ));
    }
    if runs.iter().all(|run| counts_up(run.signals.column(signal))) {
        return Some(format!(
            "signal {shown} is whole and never falls, as a number of cycles does: if it is one, say cycle = {name:?} under [columns]; else {leave_out}"
        ));
    }
    let lower = name.to_lowercase();
    let words: Vec<&str> = lower
        .split(|letter: char| !letter.is_alphanumeric())
        .collect();
    let has = |known: &[&str]| words.iter().any(|word| known.contains(word));
    if ["pred", "estimat"].iter().any(|part| lower.contains(part)) {
        return Some(format!(
            "signal {shown} looks like somebody's estimate; {leave_out}"
        ));
    }
    let moments = ["tx", "ty", "tz", "mx", "my", "mz", "nm", "torque", "moment"];
    has(&moments).then(|| {
        format!("signal {shown} looks like a moment of the reference, which isn't there later; {leave_out}")
    })
}

/// Share of a force's variance that a straight line of a signal leaves, over all rows with both; `None` where too few are, or either stands still.
fn rest(runs: &[Recording], signal: usize, force: usize) -> Option<f64> {
    let rows = runs.iter().flat_map(|run| {
        let forces = run.forces.column(force).to_vec();
        run.signals.column(signal).to_vec().into_iter().zip(forces)
    });
    let rows: Vec<(f64, f64)> = rows
        .filter(|(x, f)| x.is_finite() && f.is_finite())
        .collect();
    if rows.len() < FEWEST_ROWS {
        return None;
    }
    let count = rows.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| rows.iter().map(of).sum::<f64>() / count;
    let (x, f) = (mean(|row| row.0), mean(|row| row.1));
    let [mut xx, mut ff, mut xf] = [0.0; 3];
    for row in &rows {
        let (dx, df) = (row.0 - x, row.1 - f);
        xx += dx * dx;
        ff += df * df;
        xf += dx * df;
    }
    (xx > 0.0 && ff > 0.0).then(|| 1.0 - xf * xf / (xx * ff))
}

/// Whether a signal rises by the same in every row.
fn counts(signal: ArrayView1<'_, f64>) -> bool {
    let (Some(first), Some(second)) = (signal.first(), signal.get(1)) else {
        return false;
    };
    let step = second - first;
    let mut pairs = signal.iter().zip(signal.iter().skip(1));
    step > 0.0 && pairs.all(|(a, b)| (b - a - step).abs() <= 1e-6 * step)
}

/// Whether a signal has whole numbers alone, which never fall and do rise: over presses that end no sensor's does.
fn counts_up(signal: ArrayView1<'_, f64>) -> bool {
    let whole = signal.iter().all(|value| value.fract() == 0.0);
    let mut pairs = signal.iter().zip(signal.iter().skip(1));
    let rises = signal.first() < signal.last() && pairs.all(|(a, b)| a <= b);
    signal.len() >= FEWEST_ROWS && whole && rises
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array2;

    #[test]
    fn what_is_no_sensor_is_named() {
        let names = [
            "good",
            "loadcell_mv",
            "index",
            "fz_pred",
            "tx_nm",
            "press",
            "adc",
        ];
        let value = |row: usize, signal: usize| {
            let force = (row as f64 * 0.3).sin();
            let noise = ((row * row * 7) as f64).sin();
            match signal {
                0 => force + 0.002 * noise,
                // Printed with four digits.
                1 => ((2.0 * force + 0.3) * 1e4).round() / 1e4,
                2 => row as f64,
                5 => (row / 21) as f64,
                // Whole numbers that fall, too.
                6 => (20.0 * force).round(),
                _ => 0.5 * force + 0.1 * noise,
            }
        };
        let run = Recording {
            name: "r".to_owned(),
            time_s: (0..100).map(f64::from).collect(),
            signals: Array2::from_shape_fn((100, 7), |(row, signal)| value(row, signal)),
            forces: Array2::from_shape_fn((100, 1), |(row, _)| (row as f64 * 0.3).sin()),
            cycle: None,
        };
        let columns = NamedColumns {
            time: "t".to_owned(),
            signals: names.iter().map(|name| (*name).to_owned()).collect(),
            forces: vec!["fz_n".to_owned()],
            cycle: None,
            time_unit: None,
            converted: Vec::new(),
        };
        let told = suspect_signals(&[run], &columns);
        assert_eq!(told.len(), 5, "{told:?}");
        for (told, part) in told.iter().zip([
            "loadcell_mv is fz_n but",
            "index rises by",
            "fz_pred looks like somebody's",
            "tx_nm looks like a moment",
            "press is whole and never falls",
        ]) {
            assert!(told.contains(part), "{told}");
        }
    }
}
