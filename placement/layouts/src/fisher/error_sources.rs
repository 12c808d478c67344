//! Sources of a layout's error: the noise of its readings, and inputs that change them while the estimate takes them at their means.
//!
//! An estimate by weighted least squares, near the contact: readings that are off by d move it by I^-1 J' S^-1 d, with J, S and I as in
//! [`bounds`](super::bounds); noise alone leaves I^-1. First order in all of them.

use results::ErrorSources;

use crate::arrangement::Arrangement;
use crate::field::film_field::{LoadField, Noise};
use crate::field::hermite::Turn;
use crate::fisher::bounds::{BLIND_DEG, information};
use crate::fisher::information::{Information, MOST};

/// Contacts in one period of a layout; as many where there is none.
const CONTACTS: usize = 24;

/// Root mean square errors of the contact angle over all contact angles, degrees, by noise and by each input. `shifts`: by input and kind of film, the change of
/// the signal per standard deviation of the input. `None` where the films are blind somewhere.
pub fn error_sources(
    field: &LoadField,
    arrangement: &Arrangement,
    noise: &Noise,
    shifts: &[Vec<Turn>],
) -> Option<ErrorSources> {
    let (mut of_noise, mut of_inputs) = (0.0, vec![0.0; shifts.len()]);
    for contact in arrangement.contacts(CONTACTS) {
        let information = information(field, arrangement, noise, contact);
        let deviation = information.deviations().ok()?[0];
        if deviation > BLIND_DEG {
            return None;
        }
        of_noise += deviation * deviation;
        for (square, shifts) in of_inputs.iter_mut().zip(shifts) {
            let off = off_deg(field, arrangement, noise, contact, &information, shifts)?;
            *square += off * off;
        }
    }
    let root = |square: f64| (square / CONTACTS as f64).sqrt();
    Some(ErrorSources {
        noise_deg: root(of_noise),
        inputs_deg: of_inputs.into_iter().map(root).collect(),
    })
}

/// Error of the angle by signals that are off, degrees.
fn off_deg(
    field: &LoadField,
    arrangement: &Arrangement,
    noise: &Noise,
    contact_deg: f64,
    information: &Information,
    shifts: &[Turn],
) -> Option<f64> {
    let mut right = [0.0; MOST];
    for film in &arrangement.films {
        let kind = &field.kinds[film.kind];
        let apart = film.theta_deg - contact_deg;
        let own = noise.variance(kind.signal.at(apart), kind.signal.slope(apart));
        let variance = own + kind.scatter(apart);
        let weighted = shifts[film.kind].at(apart) / variance;
        for (right, slope) in right.iter_mut().zip(kind.derivatives(apart)) {
            *right += slope * weighted;
        }
    }
    Some(information.estimate(&right).ok()?[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fisher::bounds::bounds;
    use crate::fisher::bounds::tests::{NOISE, gaussian};

    /// Signals that are off by a turn of the contact move the angle by that turn, by a change of depth not at all.
    #[test]
    fn a_turn_moves_the_angle_and_a_depth_does_not() {
        let field = gaussian(20.0).at(1.0);
        let layout = Arrangement::regular(24, &[0, 1], false);
        let turned = |by_deg: f64| -> Vec<Turn> {
            let kinds = field.kinds.iter();
            kinds
                .map(|kind| {
                    let off = (-180..180).map(|u| -by_deg * kind.signal.slope(f64::from(u)));
                    Turn::new(off.collect())
                })
                .collect()
        };
        let deeper: Vec<Turn> = field
            .kinds
            .iter()
            .map(|kind| kind.slopes[0].clone())
            .collect();
        let found = error_sources(&field, &layout, &NOISE, &[turned(0.3), deeper]);
        let found = found.expect("no contact is blind");
        let alone = bounds(&field, &layout, &NOISE)
            .expect("regular")
            .rms_angle_deg;
        // Films are dense: the bound hardly depends on where the contact is.
        assert!((found.noise_deg / alone - 1.0).abs() < 1e-3, "{found:?}");
        // Between the samples slopes of slopes are off by 1/30 of a fifth derivative: 1e-5 of them.
        assert!((found.inputs_deg[0] / 0.3 - 1.0).abs() < 1e-4, "{found:?}");
        assert!(found.inputs_deg[1] < 1e-4, "{found:?}");
    }

    // One film can't tell the angle from the depth.
    #[test]
    fn blind_layouts_have_no_sources() {
        let field = gaussian(20.0).at(1.0);
        let one = Arrangement::regular(1, &[0], false);
        assert_eq!(error_sources(&field, &one, &NOISE, &[]), None);
    }
}
