//! Answers of a film at an equilibrium.

use serde::{Deserialize, Serialize};

use crate::film::laminate::product;
use crate::scene::Film;
use crate::solver::direction::{PerDirection, StretchFields, TensionFields};
use crate::solver::value_range::Extremes;

/// Least and greatest values over the whole film, relative to its unstressed state in the undeformed tire.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FilmState {
    /// Stretch.
    #[serde(flatten, with = "StretchFields")]
    #[schema(value_type = StretchFields<Extremes>)]
    pub stretch: PerDirection<Extremes>,
    /// Tension (second Piola-Kirchhoff), N/mm.
    #[serde(flatten, with = "TensionFields")]
    #[schema(value_type = TensionFields<Extremes>)]
    pub tension_n_per_mm: PerDirection<Extremes>,
    /// Signal that the contact adds.
    #[serde(flatten)]
    pub signal: FilmSignal,
    /// Signal without the film's stiffness, following the bare wall; absent where nobody asked.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub bare: Option<FilmSignal>,
    /// Estimated discretisation errors; absent where nobody asked, or there is no coarser mesh.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub error: Option<FilmError>,
}

/// Estimated discretisation errors of a film, absolute: the change from the next coarser mesh, times Richardson's factor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FilmError {
    /// Error of the mean strain along.
    pub mean_strain_1: f64,
    /// Error of the mean strain across.
    pub mean_strain_2: f64,
    /// Error of the mean tension along, N/mm.
    pub mean_tension_1_n_per_mm: f64,
    /// Error of the mean tension across, N/mm.
    pub mean_tension_2_n_per_mm: f64,
    /// Error of the charge, nC.
    pub charge_nc: f64,
    /// Error of the open circuit's voltage, V.
    pub open_circuit_v: f64,
    /// Error of the amplifier's voltage, V.
    pub output_v: f64,
}

/// Signal that the contact adds to a film since inflation: means over its area, and what its amplifier reads of them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, utoipa::ToSchema)]
pub struct FilmSignal {
    /// Mean strain along: stretch relative to the inflated state minus one.
    pub mean_strain_1: f64,
    /// Mean strain across.
    pub mean_strain_2: f64,
    /// Mean tension along, N/mm.
    pub mean_tension_1_n_per_mm: f64,
    /// Mean tension across, N/mm.
    pub mean_tension_2_n_per_mm: f64,
    /// Change of curvature along, 1/mm, positive where the surface becomes more hollow towards the cavity.
    pub curvature_change_1_per_mm: f64,
    /// Change of curvature across, 1/mm.
    pub curvature_change_2_per_mm: f64,
    /// Charge, nC.
    pub charge_nc: f64,
    /// Capacitance of the film, pF.
    pub capacitance_pf: f64,
    /// Voltage where nothing draws charge, V.
    pub open_circuit_v: f64,
    /// Amplitude at the amplifier, for presses of its frequency, V.
    pub output_v: f64,
    /// Standard deviation of that by the amplifier's noise, the gain and the temperature, V.
    pub output_std_v: f64,
    /// Change of the charge by a rise of the cavity's pressure, nC per kPa.
    pub charge_by_pressure_nc_per_kpa: f64,
    /// Change of the charge by warming, nC per K.
    pub charge_by_warming_nc_per_k: f64,
    /// Time in which the reading of a held press falls to 1/e, s; absent where it stays.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub time_constant_s: Option<f64>,
    /// Whether the film bears that, and the amplifier shows it.
    pub state: FilmCondition,
}

/// Whether a film bears its mean tension, and its amplifier shows it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FilmCondition {
    /// An elastic film.
    Ok,
    /// Mean stress beyond yield: the signal isn't that of an elastic film.
    BeyondYield,
    /// Output beyond the amplifier's supply: what is shown is the supply.
    Saturated,
    /// Somewhere it is compressed beyond the strain at which a free film on this wall folds.
    Wrinkled,
}

impl FilmCondition {
    /// All conditions with their names in documents.
    pub const NAMES: [(&'static str, Self); 4] = [
        ("ok", Self::Ok),
        ("beyond-yield", Self::BeyondYield),
        ("saturated", Self::Saturated),
        ("wrinkled", Self::Wrinkled),
    ];

    /// The name in documents.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::BeyondYield => "beyond-yield",
            Self::Saturated => "saturated",
            Self::Wrinkled => "wrinkled",
        }
    }
}

/// Means over a film's area: along its length, across, and twice in shear.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FilmMeans {
    /// Area, mm^2.
    pub area: f64,
    /// Stretches along and across since inflation, minus one.
    pub strain: [f64; 2],
    /// Green-Lagrange strain since inflation.
    pub added: [f64; 3],
    /// Green-Lagrange strain since the film was glued on.
    pub total: [f64; 3],
    /// Change of curvature since inflation, 1/mm.
    pub curvature: [f64; 3],
    /// Whether it is compressed somewhere beyond the strain at which it folds.
    pub is_wrinkled: bool,
}

impl FilmError {
    /// Multiplies the change from a coarser mesh by a factor.
    pub fn between(factor: f64, fine: &FilmSignal, coarse: &FilmSignal) -> Self {
        let of = |figure: fn(&FilmSignal) -> f64| factor * (figure(fine) - figure(coarse)).abs();
        Self {
            mean_strain_1: of(|signal| signal.mean_strain_1),
            mean_strain_2: of(|signal| signal.mean_strain_2),
            mean_tension_1_n_per_mm: of(|signal| signal.mean_tension_1_n_per_mm),
            mean_tension_2_n_per_mm: of(|signal| signal.mean_tension_2_n_per_mm),
            charge_nc: of(|signal| signal.charge_nc),
            open_circuit_v: of(|signal| signal.open_circuit_v),
            output_v: of(|signal| signal.output_v),
        }
    }
}

impl FilmSignal {
    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let Self {
            mean_strain_1,
            mean_strain_2,
            mean_tension_1_n_per_mm,
            mean_tension_2_n_per_mm,
            curvature_change_1_per_mm,
            curvature_change_2_per_mm,
            charge_nc,
            capacitance_pf,
            open_circuit_v,
            output_v,
            output_std_v,
            charge_by_pressure_nc_per_kpa,
            charge_by_warming_nc_per_k,
            time_constant_s,
            state: _,
        } = *self;
        let strained = [mean_strain_1, mean_strain_2];
        let pulled = [mean_tension_1_n_per_mm, mean_tension_2_n_per_mm];
        let bent = [curvature_change_1_per_mm, curvature_change_2_per_mm];
        let read = [
            charge_nc,
            capacitance_pf,
            open_circuit_v,
            output_v,
            output_std_v,
            charge_by_pressure_nc_per_kpa,
            charge_by_warming_nc_per_k,
        ];
        let mechanical = strained.into_iter().chain(pulled).chain(bent);
        let mut all = mechanical.chain(read).chain(time_constant_s);
        all.all(f64::is_finite)
    }

    /// Returns what this film gives with these means.
    pub fn of(film: &Film, means: &FilmMeans) -> Self {
        let (laminate, piezo) = (film.laminate(), &film.piezo);
        let tension = product(&laminate.membrane, &means.added);
        let stress = laminate.piezo_stress(&means.added, &means.curvature);
        let charge_nc = piezo.charge_nc([stress[0], stress[1]], means.area);
        let capacitance_pf = piezo.capacitance_pf(means.area, laminate.piezo.thickness);
        let reading = film.amplifier.reading(charge_nc, capacitance_pf);
        let warming = piezo.charge_by_warming_nc_per_k(means.area);
        let whole = laminate.piezo_stress(&means.total, &means.curvature);
        Self {
            mean_strain_1: means.strain[0],
            mean_strain_2: means.strain[1],
            mean_tension_1_n_per_mm: tension[0],
            mean_tension_2_n_per_mm: tension[1],
            curvature_change_1_per_mm: means.curvature[0],
            curvature_change_2_per_mm: means.curvature[1],
            charge_nc,
            capacitance_pf,
            open_circuit_v: 1e3 * charge_nc / capacitance_pf,
            output_v: reading.output_v,
            output_std_v: film
                .amplifier
                .reading_std_v(charge_nc, capacitance_pf, warming),
            charge_by_pressure_nc_per_kpa: piezo.charge_by_pressure_nc_per_kpa(means.area),
            charge_by_warming_nc_per_k: warming,
            time_constant_s: reading.time_constant_s,
            state: match () {
                () if piezo.yields(whole) => FilmCondition::BeyondYield,
                () if film.amplifier.saturates(reading.output_v) => FilmCondition::Saturated,
                () if means.is_wrinkled => FilmCondition::Wrinkled,
                () => FilmCondition::Ok,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::FilmLayer;

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-10 * b.abs(), "{a} {b}");
    }

    /// 28 um of PVDF on 125 um of polyester, flattened by 0.061 / mm across: 0.067 mm above the neutral plane the film is stretched by 4100 microstrain.
    #[test]
    fn a_laminate_on_a_flattened_wall_is_read_by_its_bending() {
        let layer = |thickness_mm, modulus_mpa, piezo| FilmLayer {
            thickness_mm,
            modulus_mpa,
            piezo,
            ..FilmLayer::default()
        };
        let [pvdf, polyester] = [layer(0.028, 2500.0, true), layer(0.125, 2500.0, false)];
        let means = FilmMeans {
            area: 25.0,
            curvature: [0.0, -0.061, 0.0],
            ..FilmMeans::default()
        };
        let of = |layers| {
            let film = Film {
                layers,
                ..Film::default()
            };
            FilmSignal::of(&film, &means)
        };
        let (inside, outside) = (of(vec![polyester, pvdf]), of(vec![pvdf, polyester]));
        // Equal moduli: the neutral plane is the middle, 0.0765 mm; the piezo layer's middle lies 0.0625 mm from it.
        let strain: f64 = 0.0625 * 0.061;
        let modulus = 2500.0 / (1.0 - 0.34 * 0.34);
        close(
            inside.charge_nc,
            1e-3 * (23.0 * 0.34 + 3.0) * modulus * strain * 25.0,
        );
        close(outside.charge_nc, -inside.charge_nc);
        close(inside.capacitance_pf, 110.0 * 0.025 / 0.028);
        close(
            inside.open_circuit_v,
            1e3 * inside.charge_nc / inside.capacitance_pf,
        );
        assert_eq!(inside.mean_tension_2_n_per_mm, 0.0);
    }

    #[test]
    fn every_condition_has_the_name_that_documents_have() {
        for (name, condition) in FilmCondition::NAMES {
            assert_eq!(condition.as_str(), name);
            assert_eq!(serde_json::json!(condition), name);
        }
    }

    /// A single layer's charge without bending is (d31 N1 + d32 N2) area / thickness.
    #[test]
    fn a_single_layer_is_read_by_its_tension() {
        let means = FilmMeans {
            area: 25.0,
            added: [2.8e-4, 1.8e-3, 0.0],
            total: [3e-4, 2e-3, 1e-5],
            ..FilmMeans::default()
        };
        let film = Film::default();
        let signal = FilmSignal::of(&film, &means);
        let [n1, n2] = [
            signal.mean_tension_1_n_per_mm,
            signal.mean_tension_2_n_per_mm,
        ];
        close(
            n1,
            2500.0 * 0.05 / (1.0 - 0.34 * 0.34) * (2.8e-4 + 0.34 * 1.8e-3),
        );
        close(
            signal.charge_nc,
            1e-3 * (23.0 * n1 + 3.0 * n2) * 25.0 / 0.05,
        );
        assert_eq!(signal.state, FilmCondition::Ok);
        for (share, state) in [(1.01, FilmCondition::Ok), (0.99, FilmCondition::Saturated)] {
            let mut film = film.clone();
            film.amplifier.supply_v = Some(share * signal.output_v.abs());
            assert_eq!(FilmSignal::of(&film, &means).state, state);
        }
        let stretched = FilmMeans {
            total: [0.0, 0.02, 0.0],
            ..means
        };
        assert_eq!(
            FilmSignal::of(&film, &stretched).state,
            FilmCondition::BeyondYield
        );
    }
}
