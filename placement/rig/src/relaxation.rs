//! Relaxation: how much more the rubber bears at first than when it is pressed slowly.
//!
//! Linear viscoelasticity with Prony branches: F(t) = F_slow(t) + sum_i g_i H_i(t), where H_i is F_slow through a high-pass of time constant tau_i. A step of
//! the slow force thus begins at 1 + sum g_i and falls to 1. Depths are prescribed, so strains don't relax.
//!
//! This is done for the vertical force; the others follow by the same factor, which keeps them in the disc of friction. A foot that is lifted faster than the
//! rubber recovers leaves the ground early: the force never pulls.

use crate::electronics::high_pass::HighPass;
use documents::rig::rig_settings::Branch;

/// The branches at one instant after another.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Relaxation {
    branches: Vec<BranchNow>,
    slow_n: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct BranchNow {
    share: f64,
    filter: HighPass,
    passed_n: f64,
}

impl Relaxation {
    /// A tire at rest, to be asked at even intervals, s.
    pub fn new(branches: &[Branch], interval_s: f64) -> Self {
        let at_rest = |branch: &Branch| BranchNow {
            share: branch.share,
            filter: HighPass::new(Some(branch.time_s), interval_s),
            passed_n: 0.0,
        };
        Self {
            branches: branches.iter().map(at_rest).collect(),
            slow_n: 0.0,
        }
    }

    /// The force over the slow one at the next instant, whose slow vertical force is given, N. Exact for slow forces that are linear between instants.
    pub fn factor(&mut self, slow_n: f64) -> f64 {
        let rise_n = slow_n - self.slow_n;
        self.slow_n = slow_n;
        let mut excess_n = 0.0;
        for branch in &mut self.branches {
            branch.passed_n = branch.filter.next(branch.passed_n, rise_n);
            excess_n += branch.share * branch.passed_n;
        }
        if slow_n > 0.0 {
            (1.0 + excess_n / slow_n).max(0.0)
        } else {
            1.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BRANCH: Branch = Branch {
        share: 0.1,
        time_s: 0.3,
    };

    #[test]
    fn a_step_begins_high_and_falls_to_the_slow_force() {
        let interval_s = 1e-4;
        let mut tire = Relaxation::new(&[BRANCH], interval_s);
        for k in 1..20_000 {
            let found = tire.factor(20.0);
            let after = interval_s * f64::from(k) / BRANCH.time_s;
            // The step is a ramp over the first interval h, which comes h/2 late to first order: h / (2 tau) of the excess, and (h / tau)^2 / 6 beyond.
            let late = interval_s / BRANCH.time_s;
            let expected = 1.0 + BRANCH.share * (-after).exp() * (1.0 + late / 2.0);
            let bound = BRANCH.share * late * late;
            assert!((found - expected).abs() < bound, "{k} {found} {expected}");
        }
    }

    #[test]
    fn branches_add_up_and_none_is_no_relaxation() {
        let both = [
            BRANCH,
            Branch {
                share: 0.3,
                time_s: 2.0,
            },
        ];
        let excess = |branches: &[Branch]| {
            let mut tire = Relaxation::new(branches, 0.005);
            [5.0, 12.0, 9.0].map(|slow| tire.factor(slow) - 1.0)
        };
        let (a, b, together) = (excess(&both[..1]), excess(&both[1..]), excess(&both));
        for k in 0..3 {
            assert!((together[k] - a[k] - b[k]).abs() < 1e-14);
        }
        assert_eq!(excess(&[]), [0.0; 3]);
    }

    #[test]
    fn the_ground_never_pulls() {
        let mut tire = Relaxation::new(&[BRANCH], 0.005);
        let stance = (0..=100).map(|k| (std::f64::consts::PI * f64::from(k) / 100.0).sin());
        let factors: Vec<f64> = stance.map(|slow| tire.factor(20.0 * slow)).collect();
        assert!(factors[1] > 1.0);
        assert!(factors.iter().all(|factor| *factor >= 0.0));
        // Just before lift-off the rubber hasn't recovered.
        assert_eq!(factors[99], 0.0);
    }
}
