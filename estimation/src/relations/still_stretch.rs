//! Stretches in which signals stand still while others move.

/// Count of the rows in which each signal has stood still, one after another.
#[derive(Debug, Clone)]
pub(super) struct StillStretch {
    last: Option<Vec<f64>>,
    counts: Vec<usize>,
}

impl StillStretch {
    pub(super) fn new(signals: usize) -> Self {
        Self {
            last: None,
            counts: vec![0; signals],
        }
    }

    /// The next row. One in which nothing moves is none: a rig at rest, or a logger that says the same again.
    pub(super) fn push(&mut self, signals: &[f64]) -> &[usize] {
        if let Some(last) = &self.last
            && last.iter().zip(signals).any(|(before, now)| before != now)
        {
            for ((count, before), now) in self.counts.iter_mut().zip(last).zip(signals) {
                *count = if before == now { *count + 1 } else { 0 };
            }
        }
        self.last = Some(signals.to_vec());
        &self.counts
    }

    /// Change of each signal to the next row; none before the second.
    pub(super) fn steps<'s>(&'s self, signals: &'s [f64]) -> impl Iterator<Item = f64> + 's {
        let last = self.last.iter().flatten();
        last.zip(signals).map(|(before, now)| now - before)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_stands_still_while_others_move_is_counted() {
        let mut stretch = StillStretch::new(2);
        assert_eq!(stretch.push(&[0.0, 5.0]), [0, 0]);
        assert_eq!(stretch.push(&[1.0, 5.0]), [0, 1]);
        assert_eq!(stretch.push(&[1.0, 5.0]), [0, 1]);
        assert_eq!(stretch.steps(&[3.0, 4.0]).collect::<Vec<_>>(), [2.0, -1.0]);
        assert_eq!(stretch.push(&[3.0, 5.0]), [0, 2]);
        assert_eq!(stretch.push(&[3.0, 4.0]), [1, 0]);
    }
}
