//! A bare film as a kind of film whose signal is in volts.

use fem_client::film::laminate::product;
use fem_client::scene::Film;
use layouts::arrangement::{FilmKind, FilmReads};

use crate::signals::answers::signal_of_tension;

/// The kind of film whose signal is the volts of a film that follows the wall and resists nothing, open circuit.
pub(crate) fn bare_in_volts(kind: &FilmKind, film: &Film) -> FilmKind {
    let volts = |strain: [f64; 3]| {
        let [along, across, _] = product(&film.laminate().membrane, &strain);
        signal_of_tension(film, [along, across]).open_circuit_v
    };
    FilmKind {
        reads: FilmReads::Volts([volts([1.0, 0.0, 0.0]), volts([0.0, 1.0, 0.0])]),
        ..*kind
    }
}

#[cfg(test)]
mod tests {
    use documents::signals::signal_settings::SignalSettings;
    use fem_client::scene::{FilmLayer, Geometry, Scene};

    use super::*;

    #[test]
    fn a_uniform_strain_charges_a_film_as_plane_stress_says() {
        let film = SignalSettings::on(&Scene::default()).film;
        let kind = bare_in_volts(
            &FilmKind::sized(&Geometry::default(), Some([5.0, 5.0]), 0.0, 0.0),
            &film,
        );
        let FilmReads::Volts([along, across]) = kind.reads else {
            panic!("volts");
        };
        let FilmLayer {
            modulus_mpa,
            poisson_ratio,
            thickness_mm,
            ..
        } = film.layers[0];
        let stiffness = modulus_mpa / (1.0 - poisson_ratio * poisson_ratio);
        let area = film.length_mm * film.width_mm;
        let capacitance_pf = film.piezo.capacitance_pf(area, thickness_mm);
        for (volts, stress) in [
            (along, [1.0, poisson_ratio]),
            (across, [poisson_ratio, 1.0]),
        ] {
            let charge = film
                .piezo
                .charge_nc(stress.map(|share| share * stiffness), area);
            assert!((1e-3 * volts * capacitance_pf / charge - 1.0).abs() < 1e-12);
        }
    }
}
