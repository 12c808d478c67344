//! Anderson acceleration of a fixed-point iteration (D. G. Anderson, J. ACM 12 (1965) 547; type II).
//!
//! Steps made with a kept tangent shrink by some factor a step. From the changes of the last few steps the next is
//! corrected such that, were the iteration linear, the smallest residual step in their span would remain.

/// Smallest pivot of the normal equations relative to its diagonal; a more dependent change is dropped.
const DEPENDENT: f64 = 1e-10;

/// Memory of the steps made with one tangent.
#[derive(Debug, Default)]
pub(crate) struct Acceleration {
    /// Change of the raw step, and of the unknowns, over each of the last iterations; newest last.
    changes: Vec<Change>,
    spare: Vec<Change>,
    raw: Vec<f64>,
    taken: Vec<f64>,
    started: bool,
}

#[derive(Debug, Default)]
struct Change {
    step: Vec<f64>,
    unknowns: Vec<f64>,
}

impl Acceleration {
    /// Forgets everything: the next step is another iteration's first.
    pub(crate) fn reset(&mut self) {
        self.spare.append(&mut self.changes);
        self.started = false;
    }

    /// Corrects a raw step in place, from the changes over the last `depth` steps. Only the first `measured` components are
    /// minimised; all are corrected.
    pub(crate) fn correct(&mut self, step: &mut [f64], measured: usize, depth: usize) {
        if depth == 0 {
            return;
        }
        if self.started {
            self.remember(step, depth);
        }
        self.raw.clear();
        self.raw.extend_from_slice(step);
        for (weight, change) in self.weights(measured).into_iter().zip(&self.changes) {
            let parts = change.step.iter().zip(&change.unknowns);
            for (value, (df, dx)) in step.iter_mut().zip(parts) {
                *value -= weight * (df + dx);
            }
        }
        self.taken.clear();
        self.taken.extend_from_slice(step);
        self.started = true;
    }

    fn remember(&mut self, step: &[f64], depth: usize) {
        let mut change = if self.changes.len() >= depth {
            self.changes.remove(0)
        } else {
            self.spare.pop().unwrap_or_default()
        };
        change.step.clear();
        change
            .step
            .extend(step.iter().zip(&self.raw).map(|(new, old)| new - old));
        std::mem::swap(&mut change.unknowns, &mut self.taken);
        self.changes.push(change);
    }

    /// Weights of the changes whose sum comes nearest to the raw step; 0 for a change that others hold already.
    fn weights(&self, measured: usize) -> Vec<f64> {
        let mut rest = self.raw[..measured].to_vec();
        let mut rows: Vec<Row> = Vec::with_capacity(self.changes.len());
        // Modified Gram-Schmidt, the newest change first: it is the nearest to what comes.
        for (index, change) in self.changes.iter().enumerate().rev() {
            let mut vector = change.step[..measured].to_vec();
            let size = dot(&vector, &vector);
            let shares = rows
                .iter()
                .map(|row| remove(&row.unit, &mut vector))
                .collect();
            let left = dot(&vector, &vector);
            if left > DEPENDENT * size {
                let length = left.sqrt();
                vector.iter_mut().for_each(|v| *v /= length);
                let projection = remove(&vector, &mut rest);
                rows.push(Row {
                    index,
                    unit: vector,
                    shares,
                    length,
                    projection,
                });
            }
        }
        let mut weights = vec![0.0; self.changes.len()];
        for (k, row) in rows.iter().enumerate().rev() {
            let later = rows[k + 1..].iter();
            let known: f64 = later
                .map(|other| other.shares[k] * weights[other.index])
                .sum();
            weights[row.index] = (row.projection - known) / row.length;
        }
        weights
    }
}

/// A change in the orthonormal basis of those before it.
struct Row {
    index: usize,
    unit: Vec<f64>,
    /// Components along the earlier units.
    shares: Vec<f64>,
    /// Component along its own.
    length: f64,
    /// Component of the raw step along its own.
    projection: f64,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Takes the part along `unit` out of a vector and returns its length.
fn remove(unit: &[f64], vector: &mut [f64]) -> f64 {
    let share = dot(unit, vector);
    vector
        .iter_mut()
        .zip(unit)
        .for_each(|(v, q)| *v -= share * q);
    share
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x <- x + f(x) with f(x) = (M - 1) x has the fixed point 0; with as many changes as dimensions the correction is
    /// exact, whatever the spectral radius.
    #[test]
    fn a_linear_iteration_ends_after_as_many_changes_as_it_has_dimensions() {
        let matrix = [[0.9, 0.2, 0.0], [-0.1, -1.3, 0.4], [0.0, 0.3, 0.5]];
        let mut x = [1.0, -2.0, 0.7];
        let mut acceleration = Acceleration::default();
        for _ in 0..=3 {
            let mut step = [0, 1, 2].map(|i| dot(&matrix[i], &x) - x[i]);
            acceleration.correct(&mut step, 3, 3);
            x = [0, 1, 2].map(|i| x[i] + step[i]);
        }
        // Three projections of numbers of order one, each rounded, over a determinant of 0.1.
        assert!(x.iter().all(|x| x.abs() < 1e-13), "{x:?}");
    }

    #[test]
    fn without_depth_a_step_stays_as_it_is() {
        let mut acceleration = Acceleration::default();
        for size in [1.0, 0.5, 0.25] {
            let mut step = [size, 2.0 * size];
            acceleration.correct(&mut step, 2, 0);
            assert_eq!(step, [size, 2.0 * size]);
        }
    }

    #[test]
    fn repeated_changes_are_dropped() {
        let mut acceleration = Acceleration::default();
        for size in [1.0, 0.5, 0.25, 0.125] {
            let mut step = [size, 2.0 * size];
            acceleration.correct(&mut step, 2, 3);
            assert!(step.iter().all(|s| s.is_finite()));
        }
    }
}
