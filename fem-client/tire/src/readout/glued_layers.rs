//! Cords and film at an equilibrium.

use fem::problem::State;
use fem::surface::membrane::Membrane;
use fem::surface::surface_law::{InPlane, SurfaceLaw};
use fem_client::scene::{Film, Scene};
use fem_client::solver::{CarcassState, Extremes, FilmCondition, FilmSignal, FilmState};

use crate::model::{TireModel, cord_families, film_law};

/// Extremes over all integration points of the textile layer and both families.
pub(super) fn carcass(
    scene: &Scene,
    model: &TireModel,
    equilibrium: &State,
) -> Option<CarcassState> {
    let families = cord_families(scene.carcass.as_ref()?);
    let membrane = model.carcass()?;
    let (mut stretch, mut tension) = (Extremes::NONE, Extremes::NONE);
    for strain in strains(membrane, equilibrium) {
        for family in &families {
            stretch.include(family.stretch(&strain));
            tension.include(family.tension(&strain));
        }
    }
    Some(CarcassState {
        fibre_stretch: stretch,
        tension_n_per_mm: tension,
    })
}

/// Extremes over all integration points of the film, and what the contact adds to its means.
pub(super) fn film(
    scene: &Scene,
    model: &TireModel,
    [inflated, equilibrium]: [&State; 2],
) -> Option<FilmState> {
    let film = scene.film.as_ref()?;
    let law = film_law(film);
    let membrane = model.film()?;
    let (mut stretches, mut tensions) = ([Extremes::NONE; 2], [Extremes::NONE; 2]);
    for strain in strains(membrane, equilibrium) {
        let (tension, _) = law.tensions(&strain);
        for k in 0..2 {
            stretches[k].include(stretch(strain[k]));
            tensions[k].include(tension[k]);
        }
    }
    let area = model.multiplicity() * membrane.area();
    Some(FilmState {
        stretch: stretches.into(),
        tension_n_per_mm: tensions.into(),
        signal: Some(signal(
            film,
            area,
            means(membrane, &law, [inflated, equilibrium]),
        )),
    })
}

/// Means over a film's area.
struct Means {
    /// Strains along and across since inflation.
    strain: [f64; 2],
    /// Tensions since inflation, N/mm.
    added: InPlane,
    /// Tensions in all, N/mm.
    tension: InPlane,
}

fn means(membrane: &Membrane, law: &dyn SurfaceLaw, [inflated, equilibrium]: [&State; 2]) -> Means {
    let faces = 0..membrane.surface.face_count();
    let areas = faces.flat_map(|face| membrane.point_areas(face));
    let states = strains(membrane, inflated).zip(strains(membrane, equilibrium));
    let mut means = Means {
        strain: [0.0; 2],
        added: [0.0; 3],
        tension: [0.0; 3],
    };
    for (area, (before, now)) in areas.zip(states) {
        let share = area / membrane.area();
        let [(then, _), (tension, _)] = [&before, &now].map(|strain| law.tensions(strain));
        for k in 0..2 {
            means.strain[k] += share * (stretch(now[k]) / stretch(before[k]) - 1.0);
        }
        for k in 0..3 {
            means.added[k] += share * (tension[k] - then[k]);
            means.tension[k] += share * tension[k];
        }
    }
    means
}

/// What a film of this area, mm^2, gives.
fn signal(film: &Film, area: f64, means: Means) -> FilmSignal {
    let (piezo, thickness) = (&film.piezo, film.thickness_mm);
    let [along, across, _] = means.added;
    let charge_nc = piezo.charge_nc([along, across], area, thickness);
    let capacitance_pf = piezo.capacitance_pf(area, thickness);
    let reading = film.amplifier.reading(charge_nc, capacitance_pf);
    FilmSignal {
        mean_strain_1: means.strain[0],
        mean_strain_2: means.strain[1],
        mean_tension_1_n_per_mm: along,
        mean_tension_2_n_per_mm: across,
        charge_nc,
        capacitance_pf,
        open_circuit_v: 1e3 * charge_nc / capacitance_pf,
        output_v: reading.output_v,
        time_constant_s: reading.time_constant_s,
        state: match piezo.yields(means.tension, thickness) {
            true => FilmCondition::BeyondYield,
            false => FilmCondition::Ok,
        },
    }
}

fn stretch(green_lagrange: f64) -> f64 {
    (1.0 + 2.0 * green_lagrange).sqrt()
}

/// Strains at all integration points of a layer.
fn strains(membrane: &Membrane, state: &State) -> impl Iterator<Item = InPlane> {
    let faces = membrane.surface.iter().enumerate();
    faces.flat_map(|(face, nodes)| {
        let displacement: Vec<[f64; 3]> = nodes
            .iter()
            .map(|&node| state.displacement[node as usize])
            .collect();
        membrane.strains(face, &displacement).collect::<Vec<_>>()
    })
}
