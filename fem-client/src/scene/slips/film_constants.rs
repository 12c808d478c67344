//! Films' constants in other units.

use super::slip::{Slip, rounded};
use crate::scene::Film;

/// Young's moduli of piezoelectric layers, MPa: from foamed polymers to ceramics.
const PIEZOELECTRIC: std::ops::RangeInclusive<f64> = 50.0..=2e5;
/// Smallest charge by force that a film is made for, pC/N.
const SMALLEST_CHARGE: f64 = 1e-3;

impl Film {
    /// Returns its unlikely values; `table` is where it stands, as in `film`.
    pub fn slips(&self, table: &str) -> Vec<Slip> {
        let all = [modulus(self, table), charge(self, table)];
        all.into_iter().flatten().collect()
    }
}

/// A modulus of the piezoelectric layer that no such material has.
fn modulus(film: &Film, table: &str) -> Option<Slip> {
    let modulus = film.layers.iter().find(|layer| layer.piezo)?.modulus_mpa;
    if PIEZOELECTRIC.contains(&modulus) {
        return None;
    }
    let from_gpa = 1e3 * modulus;
    let meant = PIEZOELECTRIC
        .contains(&from_gpa)
        .then(|| format!(" Typed in GPa? In MPa that is {}.", rounded(from_gpa)));
    let detail = format!(
        "the piezoelectric layer has {} MPa, where PVDF has some 2500 and ceramics 60 000.{}",
        rounded(modulus),
        meant.unwrap_or_default()
    );
    Some(Slip::of(&format!("{table}.modulus_mpa"), detail))
}

/// Constants of charge that are next to nothing.
fn charge(film: &Film, table: &str) -> Option<Slip> {
    let own = [film.piezo.d31_pc_per_n, film.piezo.d32_pc_per_n];
    let largest = own.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
    (largest > 0.0 && largest < SMALLEST_CHARGE).then(|| {
        let detail = format!(
            "{} pC/N makes no charge that can be read, where PVDF has 23. Typed in C/N? In pC/N that is {}.",
            rounded(own[0]),
            rounded(1e12 * own[0])
        );
        Slip::of(&format!("{table}.piezo.d31_pc_per_n"), detail)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_in_another_unit_are_told() {
        let mut film = Film::default();
        assert!(film.slips("film").is_empty());
        film.layers[0].modulus_mpa = 2.5;
        film.piezo.d31_pc_per_n = 23e-12;
        film.piezo.d32_pc_per_n = 3e-12;
        let found: Vec<String> = film.slips("film").iter().map(Slip::to_string).collect();
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found[0].ends_with("In MPa that is 2500."), "{found:?}");
        assert!(found[1].ends_with("In pC/N that is 23."), "{found:?}");
    }
}
