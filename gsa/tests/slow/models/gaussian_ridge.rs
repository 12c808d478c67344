//! h = phi(T) with T = sum_i a_i x_i, all x_i standard normal and sum a_i^2 = 1: non-separable in any number of inputs.
//!
//! By Mehler's formula E\[phi(T) phi(T')\] with correlation r is sum_k r^k c_k^2, where c_k are the coefficients of phi on
//! the orthonormal Hermite polynomials; E\[h|x_i\] has r = a_i^2. So Var\[h\] = sum_{k>0} c_k^2 and
//! Var\[E\[h|x_i\]\] = sum_{k>0} a_i^{2k} c_k^2. Kinks and steps have closed forms instead of slow series.

use std::f64::consts::PI;
use std::sync::OnceLock;

use gsa::law::distribution::Distribution;

use crate::known::Known;

#[derive(Debug, Clone, Copy)]
pub enum Profile {
    Tanh,
    Bell,
    Root,
    /// |t|: E\[|T||T'|\] = (2/pi) (sqrt(1 - r^2) + r asin r)
    Kink,
    /// sign(t): E = (2/pi) asin r
    Step,
}

impl Profile {
    fn at(self, t: f64) -> f64 {
        match self {
            Self::Tanh => 5.0 + t.tanh(),
            Self::Bell => 1.0 + (-0.5 * (t - 0.7).powi(2)).exp(),
            Self::Root => (1.0 + (t + 0.5).powi(2)).sqrt(),
            Self::Kink => 0.3 + t.abs(),
            Self::Step => 2.0 + t.signum(),
        }
    }

    /// Covariance of phi(T) and phi(T') at correlation r.
    fn covariance(self, r: f64) -> f64 {
        match self {
            Self::Kink => 2.0 / PI * ((1.0 - r * r).sqrt() + r * r.asin() - 1.0),
            Self::Step => 2.0 / PI * r.asin(),
            _ => {
                let energies = self.energies();
                energies.iter().rev().fold(0.0, |sum, e| (sum + e) * r)
            }
        }
    }

    /// c_1^2, c_2^2, ..: 60 of them leave 1e-12 of these profiles.
    fn energies(self) -> &'static [f64] {
        // Hundreds of models share a profile.
        static FOUND: [OnceLock<Vec<f64>>; 5] = [const { OnceLock::new() }; 5];
        FOUND[self as usize].get_or_init(|| self.integrated())
    }

    fn integrated(self) -> Vec<f64> {
        const STEPS: i32 = 4000;
        let h = 18.0 / f64::from(STEPS);
        let mut c = vec![0.0; 61];
        // The trapezoidal rule on the whole line converges faster than any power.
        for k in -STEPS / 2..=STEPS / 2 {
            let t = f64::from(k) * h;
            let density = h * (-0.5 * t * t).exp() / (2.0 * PI).sqrt();
            let weighted = density * self.at(t);
            let (mut before, mut present) = (0.0, 1.0);
            for (k, c) in c.iter_mut().enumerate() {
                *c += weighted * present;
                let next = (t * present - (k as f64).sqrt() * before) / ((k + 1) as f64).sqrt();
                (before, present) = (present, next);
            }
        }
        c[1..].iter().map(|c| c * c).collect()
    }
}

/// The model with its exact indices; the slopes are scaled to sum a_i^2 = 1.
pub fn known(family: &'static str, profile: Profile, slopes: &[f64]) -> Known {
    let norm = slopes.iter().map(|a| a * a).sum::<f64>().sqrt();
    let slopes: Vec<f64> = slopes.iter().map(|a| a / norm).collect();
    let variance = profile.covariance(1.0);
    Known {
        family,
        inputs: vec![Distribution::normal(0.0, 1.0).expect("a valid law"); slopes.len()],
        first_order: slopes
            .iter()
            .map(|a| profile.covariance(a * a) / variance)
            .collect(),
        model: Box::new(move |x| profile.at(x.iter().zip(&slopes).map(|(x, a)| x * a).sum())),
    }
}
