//! Moduli in other units, Poisson's ratios below zero, and Ogden's terms by their other convention.

use super::slip::{Slip, rounded};
use crate::scene::{Law, Material, OgdenTerm};

/// Shear moduli of rubber, MPa: from soft silicone to ebonite.
pub(super) const RUBBER: std::ops::RangeInclusive<f64> = 0.05..=50.0;
/// Units in which moduli are typed instead of MPa, in one MPa.
const UNITS: [(&str, f64); 2] = [("Pa", 1e6), ("kPa", 1e3)];

pub(super) fn slips(material: &Material) -> Vec<Slip> {
    let all = [
        modulus(&material.law),
        poisson(material),
        ogden(&material.law),
    ];
    all.into_iter().flatten().collect()
}

/// A shear modulus that no rubber has.
fn modulus(law: &Law) -> Option<Slip> {
    let modulus = law.shear_modulus_mpa();
    if RUBBER.contains(&modulus) {
        return None;
    }
    let fits = |(_, in_mpa): &(&str, f64)| RUBBER.contains(&(modulus / in_mpa));
    let meant = UNITS.iter().find(|unit| fits(unit)).map(|(unit, in_mpa)| {
        let values: Vec<String> = constants(law)
            .into_iter()
            .map(|(name, value)| format!("{name} = {}", rounded(value / in_mpa)))
            .collect();
        format!(" Typed in {unit}? In MPa that is {}.", values.join(", "))
    });
    let detail = format!(
        "the shear modulus is {} MPa, where rubber has {} to {} MPa.{}",
        rounded(modulus),
        RUBBER.start(),
        RUBBER.end(),
        meant.unwrap_or_default()
    );
    Some(Slip::of("material", detail))
}

/// The constants of a law that are stresses, with their names.
fn constants(law: &Law) -> Vec<(String, f64)> {
    let named = |constants: &[(&str, f64)]| -> Vec<(String, f64)> {
        let own = constants.iter().filter(|(_, value)| *value != 0.0);
        own.map(|(name, value)| ((*name).to_owned(), *value))
            .collect()
    };
    match law {
        Law::MooneyRivlin { c10_mpa, c01_mpa } => {
            named(&[("c10_mpa", *c10_mpa), ("c01_mpa", *c01_mpa)])
        }
        Law::NeoHookean { c10_mpa } => named(&[("c10_mpa", *c10_mpa)]),
        Law::Yeoh {
            c10_mpa,
            c20_mpa,
            c30_mpa,
        } => named(&[
            ("c10_mpa", *c10_mpa),
            ("c20_mpa", *c20_mpa),
            ("c30_mpa", *c30_mpa),
        ]),
        Law::Ogden { terms } => {
            let of = |(k, term): (usize, &OgdenTerm)| (format!("terms[{k}].mu_mpa"), term.mu_mpa);
            terms.iter().enumerate().map(of).collect()
        }
    }
}

/// A bulk modulus so low that the rubber would grow thicker where it is pulled: nu = (3 K - 2 G) / (6 K + 2 G) < 0.
fn poisson(material: &Material) -> Option<Slip> {
    let (shear, d1) = (material.law.shear_modulus_mpa(), material.d1_per_mpa);
    let bulk = 2.0 / d1;
    let ratio = (3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear);
    if d1 == 0.0 || ratio >= 0.0 {
        return None;
    }
    // Who typed the bulk modulus itself meant 2 / K.
    let meant = if d1 > shear {
        format!(
            " Typed as the bulk modulus? Then d1_per_mpa = {}.",
            rounded(2.0 / d1)
        )
    } else {
        String::new()
    };
    let detail = format!(
        "{} makes a bulk modulus of {} MPa beside a shear modulus of {} MPa: Poisson's ratio is {ratio:.2}, where rubber has 0.49 and more, as d1_per_mpa = 0.001 gives.{meant}",
        rounded(d1),
        rounded(bulk),
        rounded(shear)
    );
    Some(Slip::of("material.d1_per_mpa", detail))
}

/// Terms that are stable by W = sum of mu / alpha (..), where each mu has its exponent's sign, and have a negative weight here, where W is the sum of
/// 2 mu / alpha^2 (..).
fn ogden(law: &Law) -> Option<Slip> {
    let Law::Ogden { terms } = law else {
        return None;
    };
    let negative = terms.iter().position(|term| term.mu_mpa < 0.0)?;
    if terms.iter().any(|term| term.mu_mpa * term.alpha <= 0.0) {
        return None;
    }
    let halved = terms
        .iter()
        .map(|term| rounded(0.5 * term.mu_mpa * term.alpha));
    let detail = format!(
        "mu_mpa = {} is negative: that softens the rubber. In tables of W = sum of mu/alpha (..), as Ogden's own is, each mu has its exponent's sign. Of those, mu alpha / 2 stands here: mu_mpa = {}.",
        rounded(terms.get(negative)?.mu_mpa),
        halved.collect::<Vec<_>>().join(", ")
    );
    Some(Slip::of(&format!("material.terms[{negative}]"), detail))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(law: Law, d1_per_mpa: f64) -> Vec<String> {
        let material = Material { law, d1_per_mpa };
        slips(&material).iter().map(Slip::to_string).collect()
    }

    fn paper_s(in_mpa: f64) -> Law {
        Law::MooneyRivlin {
            c10_mpa: 0.144 * in_mpa,
            c01_mpa: 0.036 * in_mpa,
        }
    }

    #[test]
    fn moduli_in_another_unit_are_told_with_the_value_in_mpa() {
        for (unit, in_mpa) in UNITS {
            let [slip] = &of(paper_s(in_mpa), 0.0)[..] else {
                panic!("one slip");
            };
            let meant =
                format!("Typed in {unit}? In MPa that is c10_mpa = 0.144, c01_mpa = 0.036.");
            assert!(slip.ends_with(&meant), "{slip}");
        }
        let soft = of(paper_s(1e-6), 0.0);
        assert_eq!(
            soft,
            ["material: the shear modulus is 3.6e-7 MPa, where rubber has 0.05 to 50 MPa."]
        );
    }

    /// K = 2/20 = 0.1 MPa and G = 0.36 MPa: (0.3 - 0.72) / (0.6 + 0.72) = -0.318. A bulk modulus of 20 MPa is d1 = 0.1.
    #[test]
    fn a_poisson_ratio_below_zero_is_told() {
        let [slip] = &of(paper_s(1.0), 20.0)[..] else {
            panic!("one slip");
        };
        assert!(
            slip.contains("bulk modulus of 0.1 MPa") && slip.contains("-0.32"),
            "{slip}"
        );
        assert!(slip.ends_with("Then d1_per_mpa = 0.1."), "{slip}");
        // Zero where 3 K = 2 G: d1 = 3 / G.
        let limit = 3.0 / 0.36;
        assert!(of(paper_s(1.0), 0.999 * limit).is_empty());
        assert_eq!(of(paper_s(1.0), 1.001 * limit).len(), 1);
    }

    /// Treloar's rubber as R. W. Ogden fitted it, Proc. R. Soc. Lond. A 326 (1972) 565, in MPa.
    #[test]
    fn ogden_s_own_convention_is_told_by_its_negative_weight() {
        let terms = |weights: [f64; 3]| Law::Ogden {
            terms: weights
                .into_iter()
                .zip([1.3, 5.0, -2.0])
                .map(|(mu_mpa, alpha)| OgdenTerm { mu_mpa, alpha })
                .collect(),
        };
        let [slip] = &of(terms([0.63, 0.0012, -0.01]), 0.0)[..] else {
            panic!("one slip");
        };
        assert!(slip.starts_with("material.terms[2]: "), "{slip}");
        assert!(slip.ends_with("mu_mpa = 0.4095, 0.003, 0.01."), "{slip}");
        assert!(of(terms([0.4095, 0.003, 0.01]), 0.0).is_empty());
        // A weight that softens by either convention.
        assert!(of(terms([0.63, -0.0012, 0.01]), 0.0).is_empty());
    }
}
