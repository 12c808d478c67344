//! Reads what CalculiX printed.

use fem::tensor::Vector;

use super::deck::{GROUND, TIRE};

/// CalculiX's output isn't what its deck asked for.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum BadOutput {
    /// A state is lacking.
    #[error("CalculiX printed no {what} at step time {time}")]
    Missing {
        /// Text that was looked for.
        what: &'static str,
        /// The step time.
        time: String,
    },
    /// A line can't be read.
    #[error("CalculiX printed a line that isn't understood: {line:?}")]
    Line {
        /// The line.
        line: String,
    },
}

/// Displacements of all nodes of the tire at a step time, mm.
///
/// # Errors
/// [`BadOutput`] when one is lacking or isn't a finite number.
pub fn displacements(dat: &str, time: f64, nodes: usize) -> Result<Vec<Vector>, BadOutput> {
    let missing = || missing("displacements", time);
    let mut lines = block(dat, "displacements", TIRE, time).ok_or_else(missing)?;
    (1..=nodes)
        .map(|node| {
            let line = lines.next().ok_or_else(missing)?;
            let (number, values) = line.trim_start().split_once(' ').ok_or_else(|| bad(line))?;
            if number.parse() != Ok(node) {
                return Err(bad(line));
            }
            vector(values).ok_or_else(|| bad(line))
        })
        .collect()
}

/// Force of the ground on the tire at a step time, N.
///
/// # Errors
/// [`BadOutput`] when it is lacking or isn't a finite number.
pub fn reaction(dat: &str, time: f64) -> Result<Vector, BadOutput> {
    let mut lines =
        block(dat, "total force", GROUND, time).ok_or_else(|| missing("force", time))?;
    let line = lines.next().ok_or_else(|| missing("force", time))?;
    vector(line).ok_or_else(|| bad(line))
}

/// Relative residuals of the iterations, one list per attempt of an increment.
///
/// # Errors
/// [`BadOutput`] when a line isn't understood.
pub fn residuals(cvg: &str) -> Result<Vec<Vec<f64>>, BadOutput> {
    let mut history: Vec<Vec<f64>> = Vec::new();
    for line in table(cvg) {
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let (Some(&"1"), Some(percent)) = (words.get(3), words.get(5)) else {
            let (Some(attempt), Some(percent)) = (history.last_mut(), words.get(5)) else {
                return Err(bad(line));
            };
            attempt.push(share(percent).ok_or_else(|| bad(line))?);
            continue;
        };
        history.push(vec![share(percent).ok_or_else(|| bad(line))?]);
    }
    Ok(history)
}

/// Step time, of no unit, of the last increment that converged; 0 when none did.
///
/// # Errors
/// [`BadOutput`] when a line isn't understood.
pub fn reached(sta: &str) -> Result<f64, BadOutput> {
    let mut reached = 0.0;
    for line in table(sta) {
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let (Some(attempt), Some(time)) = (words.get(2), words.get(5)) else {
            return Err(bad(line));
        };
        // An attempt that failed is marked U.
        if !attempt.ends_with('U') {
            reached = finite(time).ok_or_else(|| bad(line))?;
        }
    }
    Ok(reached)
}

fn share(percent: &str) -> Option<f64> {
    finite(percent).map(|percent| percent / 100.0)
}

/// Lines after the header of a table.
fn table(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter(|line| {
        line.trim_start()
            .starts_with(|first: char| first.is_ascii_digit())
    })
}

/// Lines below the title of a quantity of a set at a step time.
fn block<'t>(
    dat: &'t str,
    quantity: &str,
    set: &str,
    time: f64,
) -> Option<impl Iterator<Item = &'t str>> {
    // Titles have seven digits.
    const PRECISION: f64 = 1e-6;
    let mut lines = dat.lines().filter(|line| !line.trim().is_empty());
    let set = format!("set {set} ");
    lines.find(|line| {
        let stamp = line.rsplit_once("time").and_then(|(_, t)| finite(t.trim()));
        line.trim_start().starts_with(quantity)
            && line.contains(&set)
            && stamp.is_some_and(|t| (t - time).abs() <= PRECISION * time)
    })?;
    Some(lines)
}

fn vector(text: &str) -> Option<Vector> {
    let mut values = text.split_ascii_whitespace().map(finite);
    let vector = [values.next()??, values.next()??, values.next()??];
    values.next().is_none().then_some(vector)
}

fn finite(text: &str) -> Option<f64> {
    text.parse().ok().filter(|value: &f64| value.is_finite())
}

fn missing(what: &'static str, time: f64) -> BadOutput {
    BadOutput::Missing {
        what,
        time: time.to_string(),
    }
}

fn bad(line: &str) -> BadOutput {
    BadOutput::Line {
        line: line.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Printed values of version 2.20.
    const DAT: &str = "
 displacements (vx,vy,vz) for set TIRE and time  0.1000000E+01

         1  0.000000E+00  0.000000E+00 -1.443498E+00
         2  1.000000E-02  0.000000E+00 -1.291920E+00

 total force (fx,fy,fz) for set GROUND and time  0.1000000E+01

        0.000000E+00  0.000000E+00  0.000000E+00

 displacements (vx,vy,vz) for set TIRE and time  0.2000000E+01

         1  0.000000E+00  0.000000E+00  3.108801E-01
         2  2.000000E-02  0.000000E+00         NaN

 total force (fx,fy,fz) for set GROUND and time  0.2000000E+01

        4.135903E-25  2.535484E-17  1.197538E+01
";

    #[test]
    fn states_are_found_by_their_time() {
        let inflated = displacements(DAT, 1.0, 2).unwrap();
        assert_eq!(inflated, [[0.0, 0.0, -1.443498], [0.01, 0.0, -1.29192]]);
        assert_eq!(reaction(DAT, 2.0).unwrap()[2], 11.97538);
        assert_eq!(displacements(DAT, 2.0, 1).unwrap()[0][2], 0.3108801);
    }

    #[test]
    fn nothing_but_finite_numbers_in_order_is_read() {
        for (time, nodes) in [(2.0, 2), (1.0, 3), (1.5, 1)] {
            assert!(displacements(DAT, time, nodes).is_err(), "{time} {nodes}");
        }
        assert!(displacements(&DAT.replace("   2  1.0", "   3  1.0"), 1.0, 2).is_err());
        assert!(reaction(&DAT.replace("1.197538E+01", "Infinity"), 2.0).is_err());
        let cut = DAT.split("1.0000000E+01").next().unwrap();
        assert!(displacements(&cut[..cut.len() / 8], 1.0, 2).is_err());
    }

    #[test]
    fn iterations_are_grouped_by_attempt() {
        let cvg = "SUMMARY OF C0NVERGENCE INFORMATION
  STEP   INC  ATT   ITER     CONT.   RESID.        CORR.      RESID.      CORR.
                              (#)     (%)           (%)        (%)         (%)
     1     1     1     1        0  0.1277E+04  0.1000E+03  0.0000E+00  0.0000E+00
     1     1     1     2        0  0.8000E-01  0.8554E+00  0.0000E+00  0.0000E+00
     1     2     1     1        0  0.2000E+00  0.1760E+01  0.0000E+00  0.0000E+00
";
        let history = residuals(cvg).unwrap();
        assert_eq!(history, [vec![12.77, 0.0008], vec![0.002]]);
        assert!(residuals(&cvg.replace("0.2000E+00", "NaN")).is_err());
        assert!(residuals("     1     1     1     2\n").is_err());
    }

    #[test]
    fn the_reached_time_is_the_last_converged_one() {
        let sta = "SUMMARY OF JOB INFORMATION
  STEP      INC     ATT  ITRS     TOT TIME     STEP TIME      INC TIME
     1          1     1     2  0.100000E+00  0.100000E+00  0.100000E+00
     1         19     1     7  0.452075E+00  0.452075E+00  0.148315E-02
     1         19     2U    5  0.600000E+00  0.600000E+00  0.370789E-03
";
        assert_eq!(reached(sta).unwrap(), 0.452075);
        assert_eq!(reached("").unwrap(), 0.0);
    }
}
