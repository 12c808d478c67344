//! Means and variances of films' signals over contacts, each film for its own.

use gsa::design::sobol::Sobol;

use crate::field::hermite::DEGREES;
use crate::field::response_surface::{Contact, DepthSignals, Drawn, ResponseSurface};

/// Contacts by which means and variances are summed.
const CONTACTS: u32 = 64;

impl ResponseSurface {
    /// Signals and forces over contacts of which this is drawn: their means, and the variances of the signals by kind and depth.
    pub fn over_contacts(&self, drawn: Drawn) -> (DepthSignals, Vec<Vec<Vec<f64>>>) {
        let mut means = self.usual().clone();
        let mut spread = means.signals.clone();
        let points = Sobol::new(self.axes().len());
        let shares: Vec<Vec<f64>> = (0..CONTACTS).map(|k| points.point(k, 0)).collect();
        for (node, depth) in self.usual().depths.places().iter().enumerate() {
            let contacts: Vec<Contact> = shares
                .iter()
                .map(|shares| self.contact(*depth, &self.drawn(shares, drawn)))
                .collect();
            means.forces_n[node] = moments(contacts.iter().map(|own| self.force_n(own)))[0];
            for (kind, spread) in spread.iter_mut().enumerate() {
                let signals: Vec<Vec<f64>> = contacts
                    .iter()
                    .map(|contact| self.signal(contact, kind))
                    .collect();
                for degree in 0..DEGREES {
                    let [mean, variance] = moments(signals.iter().map(|signal| signal[degree]));
                    means.signals[kind][node][degree] = mean;
                    spread[node][degree] = variance;
                }
            }
        }
        (means, spread)
    }
}

/// Mean and variance of some numbers.
fn moments(numbers: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    let count = f64::from(CONTACTS);
    let mean = numbers.clone().sum::<f64>() / count;
    let squares = numbers.map(|number| (number - mean) * (number - mean));
    [mean, squares.sum::<f64>() / count]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::contact_axis::ContactAxis;
    use crate::field::response_surface::tests::{BY_PRESSURE, bells, surface};

    #[test]
    fn variances_over_contacts_are_those_of_the_laws() {
        let of = |axis: usize| {
            let all = surface();
            let alone = ContactAxis {
                law: 0,
                ..all.axes()[axis].clone()
            };
            let (usual, depths) = (all.usual().clone(), all.depths().clone());
            ResponseSurface::new(usual, depths, vec![all.laws()[axis].clone()], vec![alone])
        };
        let (means, spread) = of(0).over_contacts(Drawn::All);
        let [contact, opposite] = [180, 0].map(|degree| spread[0][1][degree]);
        // Of an even law between -r and r the variance is r^2 / 3; 64 points of a net, and what isn't drawn, leave 1 %.
        let expected = (BY_PRESSURE * 0.1).powi(2) / 3.0;
        assert!((means.signals[0][1][180] - 1.0).abs() < 1e-3);
        assert!((contact / expected - 1.0).abs() < 0.02, "{contact}");
        assert!(opposite < 1e-30);
        // A force that is symmetric about the usual one is that one in the mean.
        assert!((means.forces_n[1] - 13.0).abs() < 0.02);
        let (usual, nothing) = of(0).over_contacts(Drawn::Nothing);
        let off = |(found, flat): (&f64, f64)| (found - flat).abs();
        let flat = bells(1.0).swap_remove(0);
        assert!(
            usual.signals[0][1]
                .iter()
                .zip(flat)
                .map(off)
                .all(|off| off < 1e-14)
        );
        // The mean of 64 equal numbers is off by 64 roundings at most.
        let rounding = (64.0 * f64::EPSILON).powi(2);
        assert!(
            nothing
                .iter()
                .flatten()
                .flatten()
                .all(|variance| *variance < rounding)
        );
    }
}
