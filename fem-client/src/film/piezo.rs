//! Charge of a stressed piezoelectric film, and its capacitance.
//!
//! The film lies in plane stress, polarised through its thickness. Its charge is the integral of d31 S1 + d32 S2 over its area, S the stresses along and across
//! its length (IEEE Std 176-1987, the direct effect at zero field). Default constants: Measurement Specialties, Piezo Film Sensors Technical Manual, but for d32,
//! which the manual lacks: 1 to 3 pC/N is reported for films stretched in one direction.

use document::Table;
use document::fields::Range;

/// Poled films charge either way round.
const CHARGE_PER_FORCE: Range = Range::new(-1e4, 1e4, "pC/N");
const CHARGE_PER_WARMING: Range = Range::new(-1e4, 1e4, "uC/(m2 K)");
const PERMITTIVITY: Range = Range::new(1.0, 1e6, "pF/m");
const STRESS: Range = Range::new(1e-6, 1e6, "MPa");

/// Constants of a piezoelectric polymer. The usual ones are of poly(vinylidene fluoride), stretched in one direction.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
#[table(told = [d31_pc_per_n, d32_pc_per_n, d33_pc_per_n, pyro_uc_per_m2_k, permittivity_pf_per_m, yield_mpa])]
pub struct Piezo {
    /// Charge by stress along the length, in which it was stretched, pC/N.
    #[field(default = 23.0, within = CHARGE_PER_FORCE)]
    pub d31_pc_per_n: f64,
    /// Charge by stress across, pC/N.
    #[field(default = 3.0, within = CHARGE_PER_FORCE)]
    pub d32_pc_per_n: f64,
    /// Charge by stress through the thickness, pC/N.
    #[field(default = -33.0, within = CHARGE_PER_FORCE)]
    pub d33_pc_per_n: f64,
    /// Permittivity, pF/m.
    #[field(default = 110.0, within = PERMITTIVITY)]
    pub permittivity_pf_per_m: f64,
    /// Charge by area and warming, uC/(m2 K).
    #[field(default = 30.0, within = CHARGE_PER_WARMING)]
    pub pyro_uc_per_m2_k: f64,
    /// Stress at which it yields, MPa.
    #[field(default = 45.0, within = STRESS)]
    pub yield_mpa: f64,
}

impl Piezo {
    /// Charge of a film of this area, mm^2, with these mean stresses along and across its length, MPa; nC.
    pub fn charge_nc(&self, stress: [f64; 2], area: f64) -> f64 {
        1e-3 * (self.d31_pc_per_n * stress[0] + self.d32_pc_per_n * stress[1]) * area
    }

    /// Charge by which a rise of the cavity's pressure changes that, nC/kPa.
    pub(crate) fn charge_by_pressure_nc_per_kpa(&self, area: f64) -> f64 {
        // 1 kPa is 1e-3 MPa of compression through the thickness.
        -1e-6 * self.d33_pc_per_n * area
    }

    /// Charge by which warming changes that, nC/K.
    pub fn charge_by_warming_nc_per_k(&self, area: f64) -> f64 {
        // 1 uC/m^2 is 1e-3 nC/mm^2.
        1e-3 * self.pyro_uc_per_m2_k * area
    }

    /// Capacitance, pF, of this area (mm^2) and thickness (mm).
    pub fn capacitance_pf(&self, area: f64, thickness: f64) -> f64 {
        1e-3 * self.permittivity_pf_per_m * area / thickness
    }

    /// Whether it yields under these stresses along, across and in shear, MPa, by von Mises' criterion.
    pub(crate) fn yields(&self, [s1, s2, s12]: [f64; 3]) -> bool {
        let squared = s1 * s1 - s1 * s2 + s2 * s2 + 3.0 * s12 * s12;
        squared.sqrt() > self.yield_mpa
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILM: (f64, f64) = (300.0, 0.028);

    #[test]
    fn a_film_of_the_manual_has_its_capacitance_and_charge() {
        let (area, thickness) = FILM;
        let piezo = Piezo::default();
        // 380 pF/cm^2 at 28 um, printed with 106 to 113 pF/m.
        let per_cm2 = piezo.capacitance_pf(100.0, thickness);
        assert!((per_cm2 - 392.857_142_857_142_9).abs() < 1e-10);
        // 1 MPa along, 2 MPa across: 23 + 6 pC/N on 300 mm^2.
        let charge = piezo.charge_nc([1.0, 2.0], area);
        assert!((charge - 8.7).abs() < 1e-10 * 8.7, "{charge}");
        // A kelvin on 250 mm^2 gives 7.5 nC, 1 kPa 33 pC/N x 1e3 Pa x 250 mm^2.
        assert!((piezo.charge_by_warming_nc_per_k(250.0) / 7.5 - 1.0).abs() < 1e-10);
        assert!((piezo.charge_by_pressure_nc_per_kpa(250.0) / 8.25e-3 - 1.0).abs() < 1e-10);
    }

    #[test]
    fn the_open_circuit_voltage_of_a_tension_does_not_depend_on_the_thickness() {
        let piezo = Piezo::default();
        let volts = |thickness| {
            1e3 * piezo.charge_nc([0.07 / thickness, 0.15 / thickness], 25.0)
                / piezo.capacitance_pf(25.0, thickness)
        };
        // (d31 N1 + d32 N2) / permittivity.
        let expected = (23.0 * 0.07 + 3.0 * 0.15) / 0.110;
        for thickness in [0.009, 0.028, 0.11] {
            assert!((volts(thickness) / expected - 1.0).abs() < 1e-10);
        }
    }

    #[test]
    fn a_film_yields_by_von_mises() {
        let piezo = Piezo::default();
        let at = |factor: f64, tension: [f64; 3]| piezo.yields(tension.map(|t| factor * 45.0 * t));
        let shear = 1.0 / 3.0_f64.sqrt();
        for tension in [
            [1.0, 0.0, 0.0],
            [0.0, -1.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 0.0, shear],
        ] {
            assert!(!at(0.999, tension) && at(1.001, tension), "{tension:?}");
        }
    }
}
