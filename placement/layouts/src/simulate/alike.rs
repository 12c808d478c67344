//! The two contacts of a layout that look most alike.

use crate::arrangement::Arrangement;
use crate::field::film_field::{DepthFields, LoadField, Noise};
use crate::simulate::simulation::LOST_DEG;
use results::AlikeContacts;

/// Contacts in one period, and depths of the study, that are compared.
const CONTACTS: usize = 24;
const DEPTHS: usize = 16;
/// Distance of the angles with which they are compared, degrees.
const STEP_DEG: usize = 2;

/// The contact at this depth, and any other more than 20 degrees from it, whose readings are nearest, in standard deviations of the first one's noise.
pub fn alike(
    fields: &DepthFields,
    depth_mm: f64,
    arrangement: &Arrangement,
    noise: &Noise,
) -> Option<AlikeContacts> {
    let own = fields.at(depth_mm);
    let others = fields.evenly(DEPTHS);
    let angles: Vec<f64> = (0..360).step_by(STEP_DEG).map(f64::from).collect();
    let readings_of = |field: &LoadField| -> Vec<Vec<f64>> {
        angles
            .iter()
            .map(|angle| readings(field, arrangement, *angle))
            .collect()
    };
    let readings_of_others: Vec<Vec<Vec<f64>>> = others.iter().map(readings_of).collect();
    let mut nearest: Option<AlikeContacts> = None;
    for contact in arrangement.contacts(CONTACTS) {
        let (mean, variance) = with_variance(&own, arrangement, noise, contact);
        for (other, by_angle) in others.iter().zip(&readings_of_others) {
            for (angle, reading) in angles.iter().zip(by_angle) {
                let apart = (angle - contact).rem_euclid(360.0);
                if apart.min(360.0 - apart) <= LOST_DEG {
                    continue;
                }
                let squares = mean
                    .iter()
                    .zip(reading)
                    .zip(&variance)
                    .map(|((a, b), s)| (a - b) * (a - b) / s);
                let sigmas = squares.sum::<f64>().sqrt();
                if sigmas.is_finite() && nearest.is_none_or(|nearest| sigmas < nearest.sigmas) {
                    nearest = Some(AlikeContacts {
                        angle_deg: contact,
                        other_angle_deg: *angle,
                        other_depth_mm: other.depth_mm,
                        sigmas,
                    });
                }
            }
        }
    }
    nearest
}

fn readings(field: &LoadField, arrangement: &Arrangement, contact_deg: f64) -> Vec<f64> {
    let films = arrangement.films.iter();
    films
        .map(|film| {
            field.kinds[film.kind]
                .signal
                .at(film.theta_deg - contact_deg)
        })
        .collect()
}

fn with_variance(
    field: &LoadField,
    arrangement: &Arrangement,
    noise: &Noise,
    contact_deg: f64,
) -> (Vec<f64>, Vec<f64>) {
    let both = arrangement.films.iter().map(|film| {
        let (signal, apart) = (&field.kinds[film.kind].signal, film.theta_deg - contact_deg);
        let reading = signal.at(apart);
        let own = noise.variance(reading, signal.slope(apart));
        (reading, own + field.kinds[film.kind].scatter(apart))
    });
    both.unzip()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fisher::bounds::tests::{NOISE, gaussian};

    #[test]
    fn places_that_no_film_sees_are_alike_and_others_are_not() {
        let fields = gaussian(8.0);
        let blind =
            alike(&fields, 1.0, &Arrangement::regular(3, &[0], false), &NOISE).expect("a pair");
        // Midway between films 60 degrees off: nothing is read of either.
        assert!(blind.sigmas < 1e-6, "{blind:?}");
        let dense = alike(
            &fields,
            1.0,
            &Arrangement::regular(24, &[0, 1], false),
            &NOISE,
        )
        .expect("a pair");
        // Readings of 1 over noise of 0.02 in a few films each.
        assert!(dense.sigmas > 30.0, "{dense:?}");
    }
}
