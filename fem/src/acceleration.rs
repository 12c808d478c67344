//! Anderson acceleration of a fixed-point iteration (D. G. Anderson, J. ACM 12 (1965) 547; type II).
//!
//! Steps made with a kept tangent shrink by some factor a step. From the changes of the last few steps the next is
//! corrected such that, were the iteration linear, the smallest residual step in their span would remain.

/// Steps that are remembered.
const DEPTH: usize = 3;
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

    /// Corrects a raw step in place. Only the first `measured` components are minimised; all are corrected.
    pub(crate) fn correct(&mut self, step: &mut [f64], measured: usize) {
        if self.started {
            self.remember(step);
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

    fn remember(&mut self, step: &[f64]) {
        let mut change = if self.changes.len() == DEPTH {
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

    /// Least-squares weights of the changes, by elimination on their normal equations, newest first.
    fn weights(&self, measured: usize) -> Vec<f64> {
        let n = self.changes.len();
        let dot = |a: &[f64], b: &[f64]| -> f64 {
            a[..measured].iter().zip(&b[..measured]).map(|(a, b)| a * b).sum()
        };
        let mut weights = vec![0.0; n];
        // Modified Gram-Schmidt from the newest change to the oldest.
        let mut basis: Vec<Vec<f64>> = Vec::with_capacity(n);
        let mut used = Vec::with_capacity(n);
        let mut triangle: Vec<Vec<f64>> = Vec::with_capacity(n);
        let mut rest = self.raw[..measured].to_vec();
        let mut projections = Vec::with_capacity(n);
        for index in (0..n).rev() {
            let mut vector = self.changes[index].step[..measured].to_vec();
            let size = dot(&vector, &vector);
            let column: Vec<f64> = basis
                .iter()
                .map(|q| {
                    let share = dot(q, &vector);
                    vector.iter_mut().zip(q).for_each(|(v, q)| *v -= share * q);
                    share
                })
                .collect();
            let left = dot(&vector, &vector);
            if !(left > DEPENDENT * size) {
                continue;
            }
            let length = left.sqrt();
            vector.iter_mut().for_each(|v| *v /= length);
            let projection = dot(&vector, &rest);
            rest.iter_mut()
                .zip(&vector)
                .for_each(|(r, q)| *r -= projection * q);
            projections.push(projection);
            triangle.push(column.into_iter().chain([length]).collect());
            basis.push(vector);
            used.push(index);
        }
        for k in (0..used.len()).rev() {
            let mut value = projections[k];
            for later in k + 1..used.len() {
                value -= triangle[later][k] * weights[used[later]];
            }
            weights[used[k]] = value / triangle[k][k];
        }
        weights
    }
}
