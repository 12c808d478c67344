//! A tire for tests, in closed form: films evenly around the wheel, each with a bump of charge as the contact passes.
//!
//! Fz = k d^1.5; forces along and across are stiffnesses times shifts, and slide at a share of Fz. A film's charge is a Gaussian of its angle to the contact,
//! as large as the depth, and skewed by the shift along the wheel.

use crate::contact_response::{Contact, ContactResponse, DrawnFor, StanceResponse, TurnableFilms};

const VERTICAL_N: f64 = 11.0;
const SHEAR_N_PER_MM: [f64; 2] = [6.0, 4.0];
const FRICTION: f64 = 0.8;
const WIDTH_DEG: f64 = 22.0;
const PEAK_NC_PER_MM: f64 = 1.0;

/// Films evenly around a wheel.
#[derive(Clone)]
pub(crate) struct BumpResponse {
    /// Wheel angles of the films, degrees.
    angles_deg: Vec<f64>,
    full_scale_nc: Vec<f64>,
    capacitance_pf: Vec<f64>,
    warming_nc_per_k: Vec<f64>,
    differing: Vec<DrawnFor>,
}

/// Stance with the contact at one angle.
pub(crate) struct BumpStance {
    /// Bump of each film and its slope at the contact's angle.
    bumps: Vec<[f64; 2]>,
    /// Vertical force over that of the usual contact.
    stiffness: f64,
}

impl BumpResponse {
    pub(crate) fn new(films: usize) -> Self {
        let angle = |film: usize| 360.0 * film as f64 / films as f64;
        Self {
            angles_deg: (0..films).map(angle).collect(),
            full_scale_nc: vec![2.0; films],
            capacitance_pf: vec![980.0; films],
            warming_nc_per_k: vec![7.5; films],
            differing: Vec::new(),
        }
    }

    /// Returns the same films on a tire whose stiffness differs by a factor of 0.5 to 1.5, as often as these say.
    pub(crate) fn of_many(self, differing: &[DrawnFor]) -> Self {
        Self {
            differing: differing.to_vec(),
            ..self
        }
    }

    pub(crate) fn stance(&self, contact_deg: f64) -> BumpStance {
        let bump = |angle_deg: &f64| {
            let turn = angle_deg - contact_deg;
            let away = (turn - 360.0 * (turn / 360.0).round()) / WIDTH_DEG;
            let height = (-0.5 * away * away).exp();
            [height, away * height]
        };
        BumpStance {
            bumps: self.angles_deg.iter().map(bump).collect(),
            stiffness: 1.0,
        }
    }
}

impl ContactResponse for BumpResponse {
    fn films(&self) -> usize {
        self.full_scale_nc.len()
    }

    fn full_scale_nc(&self) -> &[f64] {
        &self.full_scale_nc
    }

    fn capacitance_pf(&self) -> &[f64] {
        &self.capacitance_pf
    }

    fn warming_nc_per_k(&self) -> &[f64] {
        &self.warming_nc_per_k
    }

    fn depth_of_load_mm(&self, load_n: f64) -> f64 {
        (load_n / VERTICAL_N).powf(2.0 / 3.0)
    }

    fn sticking_shift_mm(&self, depth_mm: f64) -> [f64; 2] {
        SHEAR_N_PER_MM.map(|stiffness| FRICTION * vertical(depth_mm) / stiffness)
    }

    fn differing(&self) -> &[DrawnFor] {
        &self.differing
    }

    fn at_angle(&self, contact_deg: f64, shares: &[f64]) -> Box<dyn StanceResponse + '_> {
        let stiffness = shares.iter().map(|share| 0.5 + share).product();
        Box::new(BumpStance {
            stiffness,
            ..self.stance(contact_deg)
        })
    }
}

impl TurnableFilms for BumpResponse {
    fn turned(&self, by_deg: &[f64]) -> Self {
        let mut turned = self.clone();
        for (angle, by) in turned.angles_deg.iter_mut().zip(by_deg) {
            *angle += by;
        }
        turned
    }

    fn alike(&self) -> Self {
        Self {
            differing: Vec::new(),
            ..self.clone()
        }
    }
}

impl StanceResponse for BumpStance {
    fn answer(&self, contact: &Contact, charges_nc: &mut [f64]) -> [f64; 3] {
        let [along, across] = contact.shift_mm;
        for (charge, [height, slope]) in charges_nc.iter_mut().zip(&self.bumps) {
            *charge = PEAK_NC_PER_MM * (contact.depth_mm * height + along * slope);
        }
        let [kx, ky] = SHEAR_N_PER_MM;
        let vertical = self.stiffness * vertical(contact.depth_mm);
        [kx * along, ky * across, vertical]
    }
}

fn vertical(depth_mm: f64) -> f64 {
    VERTICAL_N * depth_mm * depth_mm.sqrt()
}
