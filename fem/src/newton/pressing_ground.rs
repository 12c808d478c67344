//! Contact with ground that presses with a force instead of standing at a height.
//!
//! Let e be the ground's vertical at the nodes of the faces that may touch, and w = x - d e the border's increments `x` relative to ground that rises by `d`.
//! Contact depends on w alone, and its forces f bear the ground's: e . f(w) = -F. With S x + f = g, the condensed equilibrium of the body,
//!
//! > d = (F + e . (g - S w)) / (e . S e),
//!
//! which leaves for w an equilibrium like that on fixed ground, of the body without its resistance to a common lift:
//!
//! > (S - S e (S e)^T / (e . S e)) w + f(w) = g - S e (F + e . g) / (e . S e).

use crate::newton::watch::Watch;
use faer::{Col, Mat, Scale};

use super::condensed_contact::CondensedContact;

/// Doublings of the ramp by which ground is raised beyond the lowest node until a contact point touches.
const RAISINGS: usize = 20;

impl CondensedContact<'_> {
    /// Increments of the border, and how far the ground rises, mm, at which it presses with `force`, N; up to the residual of [`Self::solve`].
    pub(crate) fn solve_pressing(
        self,
        rhs: &Col<f64>,
        force: f64,
        tolerance: f64,
        watch: &dyn Watch,
    ) -> (Col<f64>, f64) {
        let lift = self.lift(rhs.nrows());
        let resistance: Col<f64> = self.schur * &lift;
        let total = lift.transpose() * &resistance;
        if total <= 0.0 {
            // Nothing is near the ground, or the body gives way to it: where it would rise to isn't known.
            return (self.solve(rhs, tolerance, watch), 0.0);
        }
        let share = (force + lift.transpose() * rhs) / total;
        let schur = self.schur - outer(&resistance, 1.0 / total);
        let reduced = rhs - Scale(share) * &resistance;
        let body = self.schur;
        let free = CondensedContact {
            schur: &schur,
            focus: None,
            may_leave: false,
            ..self
        };
        let start = Scale(-free.gap(rhs.nrows())) * &lift;
        let relative = free.solve_from(start, &reduced, tolerance, watch);
        let rise = (force + lift.transpose() * (rhs - body * &relative)) / total;
        (relative + Scale(rise) * &lift, rise)
    }

    /// Returns the increments by which all nodes of the faces rise by one along the ground's z axis.
    pub(super) fn lift(&self, unknowns: usize) -> Col<f64> {
        let mut lift = Col::zeros(unknowns);
        let [_, _, up] = self.ground.axes.vectors();
        for nodes in self
            .faces
            .iter()
            .flat_map(|face| face.places.chunks_exact(3))
        {
            for (place, component) in nodes.iter().zip(up) {
                if let Some(place) = place {
                    lift[*place] = component;
                }
            }
        }
        lift
    }

    /// Returns the rise by which ground that touches nothing would touch, mm; 0 where it touches.
    fn gap(&self, unknowns: usize) -> f64 {
        let touches = |rise: f64| {
            let lowered = Scale(-rise) * self.lift(unknowns);
            self.forces(&lowered, None).norm_l2() > 0.0
        };
        if touches(0.0) {
            return 0.0;
        }
        let nodes = self.faces.iter().flat_map(|face| &face.positions);
        let lowest = nodes
            .map(|&position| self.ground.gap(position))
            .fold(f64::INFINITY, f64::min);
        let mut beyond = self.contact.penalty.ramp;
        for _ in 0..RAISINGS {
            if touches(lowest + beyond) {
                break;
            }
            beyond *= 2.0;
        }
        lowest + beyond
    }
}

/// a a^T times a factor.
fn outer(a: &Col<f64>, factor: f64) -> Mat<f64> {
    Mat::from_fn(a.nrows(), a.nrows(), |i, j| factor * a[i] * a[j])
}
