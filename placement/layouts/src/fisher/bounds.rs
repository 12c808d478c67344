//! Bounds of a layout's errors at one load, from Fisher's information.
//!
//! A film at theta reads h(u) + noise, u = theta - phi, with phi the contact angle: one contact solution gives the reading for every contact angle by rotation,
//! and dh/dphi = -h'(u). With the derivatives J of all films by angle, depth and further unknowns, and S the variances of their noise, the information is
//! I = J' S^-1 J, and the diagonal of its inverse bounds the variances of any unbiased estimate from below (C. R. Rao, 1945; H. Cramer, 1946). With what is known
//! before, I plus the inverse of the prior's covariance bounds the mean error of any estimate, biased ones included (H. L. van Trees, 1968). S is diagonal, or the
//! covariance of signals that scatter together.

use crate::arrangement::Arrangement;
use crate::field::film_field::{LoadField, Noise};
use crate::fisher::information::{Blind, Information, MOST};
use crate::fisher::joint_scatter::JointScatter;

/// Standard deviation of an angle of which nothing is known: 360 / sqrt(12), degrees.
pub(crate) const PRIOR_ANGLE_DEG: f64 = 103.923_048_454_132_64;
/// Standard deviation of the depth before anything is measured, mm; of the ground's shifts, too.
pub(crate) const PRIOR_DEPTH_MM: f64 = 1.0;
/// An angle known no better than this isn't known: half a turn.
pub(crate) const BLIND_DEG: f64 = 180.0;

/// Names of the unknowns, in their order.
const UNKNOWNS: [&str; 4] = [
    "its angle",
    "its depth",
    "its shift along the wheel",
    "its shift across",
];

/// Least errors of a layout over all contact angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Bound of the contact angle, worst angle, degrees.
    pub worst_angle_deg: f64,
    /// Bound of the contact angle, root mean square over the angles, degrees.
    pub rms_angle_deg: f64,
    /// Bound of the depth, worst angle, mm.
    pub worst_depth_mm: f64,
    /// Bounds of the shifts along and across the wheel, worst angle, mm, where they are unknowns.
    pub worst_shift_mm: [Option<f64>; 2],
}

/// Information on angle, depth and further unknowns with the contact at an angle, degrees.
pub fn information(
    field: &LoadField,
    arrangement: &Arrangement,
    noise: &Noise,
    contact_deg: f64,
) -> Information {
    let unknowns = 1 + field.kinds.first().map_or(1, |kind| kind.slopes.len());
    let mut information = Information::of(unknowns);
    let mut all = Vec::with_capacity(arrangement.films.len());
    for film in &arrangement.films {
        let kind = &field.kinds[film.kind];
        let apart = film.theta_deg - contact_deg;
        let mut slopes = [0.0; MOST];
        for (slope, own) in slopes.iter_mut().zip(kind.derivatives(apart)) {
            *slope = own;
        }
        let own = noise.variance(kind.signal.at(apart), slopes[0]);
        information.add(&slopes, own + field.scatter(film.kind, apart));
        all.push(slopes);
    }
    if field.modes.count() > 0 {
        JointScatter::new(field, arrangement, noise, contact_deg).hide(&mut information, &all);
    }
    information
}

/// Least errors over all contact angles, a degree apart.
///
/// # Errors
/// What can't be told, and where the contact is then.
pub fn bounds(
    field: &LoadField,
    arrangement: &Arrangement,
    noise: &Noise,
) -> Result<Bounds, String> {
    let mut bounds = Bounds {
        worst_angle_deg: 0.0,
        rms_angle_deg: 0.0,
        worst_depth_mm: 0.0,
        worst_shift_mm: [None; 2],
    };
    let shifts = field.kinds.first().map_or(0, |kind| kind.slopes.len() - 1);
    let mut squares = 0.0;
    for contact in arrangement.degrees() {
        let information = information(field, arrangement, noise, contact);
        let [angle, depth, shift @ ..] = information
            .deviations()
            .map_err(|blind| blind_at(contact, blind))?;
        if !(angle <= BLIND_DEG && depth.is_finite()) {
            return Err(format!(
                "with the contact at {contact} degrees the films see too little of it: the angle's error is beyond half a turn"
            ));
        }
        squares += angle * angle;
        bounds.worst_angle_deg = bounds.worst_angle_deg.max(angle);
        bounds.worst_depth_mm = bounds.worst_depth_mm.max(depth);
        for (worst, shift) in bounds.worst_shift_mm.iter_mut().zip(shift).take(shifts) {
            *worst = Some(worst.map_or(shift, |worst| worst.max(shift)));
        }
    }
    bounds.rms_angle_deg = (squares / arrangement.degrees().count() as f64).sqrt();
    Ok(bounds)
}

fn blind_at(contact_deg: f64, Blind(blind): Blind) -> String {
    let names: Vec<&str> = UNKNOWNS
        .iter()
        .zip(blind)
        .filter(|(_, blind)| *blind)
        .map(|(name, _)| *name)
        .collect();
    let told = match names.as_slice() {
        [one] => format!("tell nothing of {one}"),
        [first, second] => format!("can't tell {first} from {second}"),
        more => format!("can't tell {} from each other", more.join(", ")),
    };
    format!("with the contact at {contact_deg} degrees the films {told}")
}

/// Bound of the angle's error with nothing but the prior known before, root mean square over the contact angles, degrees: finite for any layout.
pub(crate) fn bayes_angle_deg(
    field: &LoadField,
    arrangement: &Arrangement,
    noise: &Noise,
) -> Option<f64> {
    let prior = [
        PRIOR_ANGLE_DEG,
        PRIOR_DEPTH_MM,
        PRIOR_DEPTH_MM,
        PRIOR_DEPTH_MM,
    ];
    let mut squares = 0.0;
    for contact in arrangement.degrees() {
        let information = information(field, arrangement, noise, contact).with_prior(&prior);
        squares += information.deviations().ok()?[0].powi(2);
    }
    Some((squares / arrangement.degrees().count() as f64).sqrt())
}

/// Signal of the film that sees most, at the contact angle where that is least.
pub fn weakest_signal(field: &LoadField, arrangement: &Arrangement) -> f64 {
    let strongest = |contact: f64| {
        let signals = arrangement.films.iter().map(|film| {
            field.kinds[film.kind]
                .signal
                .at(film.theta_deg - contact)
                .abs()
        });
        signals.fold(0.0, f64::max)
    };
    arrangement
        .degrees()
        .map(strongest)
        .fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::field::film_field::{DepthFields, KindField};
    use crate::field::hermite::{Nodes, Turn};
    use crate::field::scatter_modes::ScatterModes;

    pub(crate) const NOISE: Noise = Noise {
        floor: 0.02,
        in_volts: false,
        gain_std: 0.0,
        place_std_deg: 0.0,
    };

    /// A Gaussian contact, h = d exp(-u^2 / 2 s^2) in the first kind of film, its derivative over s in the second, at depths of 0.5 to 1.5.
    pub(crate) fn gaussian(width_deg: f64) -> DepthFields {
        let depths = [0.5, 0.9, 1.0, 1.1, 1.5];
        let bell = |u: i32| (-0.5 * (f64::from(u) / width_deg).powi(2)).exp();
        let slope = |u: i32| -f64::from(u) / width_deg * bell(u);
        let over = |profile: &dyn Fn(i32) -> f64| -> Vec<Vec<f64>> {
            depths
                .iter()
                .map(|d| (-180..180).map(|u| d * profile(u)).collect())
                .collect()
        };
        DepthFields {
            depths: Nodes::new(depths.to_vec()),
            forces_n: depths.iter().map(|d| 13.0 * d).collect(),
            signals: vec![over(&bell), over(&slope)],
            sheared: Vec::new(),
            contacts: None,
            spread: None,
            together: None,
            surface_error: None,
        }
    }

    #[test]
    fn dense_films_reach_the_closed_form_of_the_bound() {
        // Spacing D much below the width s: sum h'^2 -> integral / D, and the bound is (noise/d) sqrt(2 s D / sqrt(pi)).
        let (width, units) = (20.0, 72);
        let expected = NOISE.floor * (2.0 * width * 5.0 / std::f64::consts::PI.sqrt()).sqrt();
        let field = gaussian(width).at(1.0);
        let found =
            bounds(&field, &Arrangement::regular(units, &[0], false), &NOISE).expect("dense");
        // Slopes are off by 1/30 of a fifth derivative: 1e-5 of them; the sum over films differs from the integral by exp(-(pi s / D)^2).
        for angle in [found.worst_angle_deg, found.rms_angle_deg] {
            assert!(
                (angle / expected - 1.0).abs() < 1e-5,
                "{angle} for {expected}"
            );
        }
    }

    #[test]
    fn information_agrees_with_finite_differences() {
        let fields = gaussian(9.0);
        let arrangement = Arrangement::regular(5, &[0, 1], true);
        let (contact, depth) = (17.3, 1.0);
        let reading = |contact: f64, depth: f64| -> Vec<f64> {
            let field = fields.at(depth);
            arrangement
                .films
                .iter()
                .map(|film| field.kinds[film.kind].signal.at(film.theta_deg - contact))
                .collect()
        };
        // Forces of a parabola-like step: truncation h^2, round-off eps / h.
        let h = 1e-6;
        let difference = |a: Vec<f64>, b: Vec<f64>| -> Vec<f64> {
            a.iter().zip(b).map(|(a, b)| (a - b) / (2.0 * h)).collect()
        };
        let by_angle = difference(reading(contact + h, depth), reading(contact - h, depth));
        let by_depth = difference(reading(contact, depth + h), reading(contact, depth - h));
        let found = information(&fields.at(depth), &arrangement, &NOISE, contact);
        let sum = |a: &[f64], b: &[f64]| {
            a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / (NOISE.floor * NOISE.floor)
        };
        for (i, j, expected) in [
            (0, 0, sum(&by_angle, &by_angle)),
            (0, 1, sum(&by_angle, &by_depth)),
            (1, 1, sum(&by_depth, &by_depth)),
        ] {
            let scale = (found.entry(i, i) * found.entry(j, j)).sqrt();
            assert!(
                (found.entry(i, j) - expected).abs() < 1e-6 * scale,
                "{i} {j}"
            );
        }
    }

    #[test]
    fn a_contact_between_distant_films_goes_unseen_but_for_the_prior() {
        let field = gaussian(5.0).at(1.0);
        let two = Arrangement::regular(2, &[0], false);
        let reason = bounds(&field, &two, &NOISE).expect_err("two narrow films");
        assert!(reason.contains("degrees"), "{reason}");
        // Midway the nearest film is 90 degrees off: exp(-162).
        assert!(weakest_signal(&field, &two) < 1e-60);
        let bayes = bayes_angle_deg(&field, &two, &NOISE).expect("finite");
        assert!((80.0..PRIOR_ANGLE_DEG).contains(&bayes), "{bayes}");
    }

    #[test]
    fn coincident_films_count_twice_and_tell_no_more() {
        let field = gaussian(20.0).at(1.0);
        let one = Arrangement::regular(12, &[0], false);
        let twice = Arrangement::regular(12, &[0, 0], false);
        let [one, twice] =
            [one, twice].map(|arrangement| bounds(&field, &arrangement, &NOISE).expect("regular"));
        assert!((one.worst_angle_deg / twice.worst_angle_deg - 2f64.sqrt()).abs() < 1e-12);
        let single = Arrangement::free(vec![crate::arrangement::LaidFilm {
            theta_deg: 0.0,
            kind: 0,
        }]);
        let reason = bounds(&field, &single, &NOISE).expect_err("one film");
        assert!(
            reason.contains("can't tell its angle from its depth")
                || reason.contains("nothing of its angle"),
            "{reason}"
        );
    }

    #[test]
    fn gains_and_places_add_their_variances() {
        let noise = Noise {
            floor: 3.0,
            gain_std: 0.1,
            place_std_deg: 2.0,
            ..NOISE
        };
        assert!((noise.variance(-40.0, 6.0) - (9.0 + 16.0 + 144.0)).abs() < 1e-12);
        assert!(NOISE.is_plain() && !noise.is_plain());
    }

    #[test]
    fn no_signal_at_all_gives_a_reason() {
        let nothing = || Turn::new(vec![0.0; 360]);
        let field = LoadField {
            depth_mm: 1.0,
            force_n: 0.0,
            force_slope: 0.0,
            kinds: vec![KindField {
                signal: nothing(),
                slopes: vec![nothing()],
                spread: None,
            }],
            modes: ScatterModes::default(),
        };
        let silent = Noise {
            floor: 0.0,
            ..NOISE
        };
        assert!(bounds(&field, &Arrangement::regular(6, &[0], false), &silent).is_err());
    }
}
