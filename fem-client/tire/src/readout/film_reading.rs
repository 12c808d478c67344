//! Signals of films at an equilibrium: of the glued one, and of those that would follow the bare wall.

use fem::problem::State;
use fem::surface::sheet::{Sheet, SheetPoint};
use fem_client::scene::{Film, Scene};
use fem_client::solver::{Extremes, FilmMeans, FilmSignal, FilmState};

use crate::model::{Place, TireModel, following_film};

/// Returns what the glued film gives, and the extremes over its integration points.
pub(super) fn glued(scene: &Scene, model: &TireModel, states: [&State; 2]) -> Option<FilmState> {
    let film = scene.film.as_ref()?;
    let sheet = model.film()?;
    let turned = Turned::of(film, model);
    let points = states.map(|state| sheet.points(&state.displacement));
    let laminate = film.laminate();
    let (mut stretches, mut tensions) = ([Extremes::NONE; 2], [Extremes::NONE; 2]);
    for point in &points[1] {
        let strain = turned.strain(&point.strain);
        let tension = fem_client::film::laminate::product(&laminate.membrane, &strain);
        for k in 0..2 {
            stretches[k].include(stretch(strain[k]));
            tensions[k].include(tension[k]);
        }
    }
    let folds = folding_strain(scene, film);
    Some(FilmState {
        stretch: stretches.into(),
        tension_n_per_mm: tensions.into(),
        signal: FilmSignal::of(film, &means(sheet, turned, &points, Some(folds))),
        bare: None,
        error: None,
    })
}

/// Returns what a film without stiffness gives.
pub(super) fn following(film: &Film, model: &TireModel, states: [&State; 2]) -> FilmSignal {
    let sheet = following_film(film, &model.grid, &model.problem.mesh);
    let points = states.map(|state| sheet.points_of(&sheet.following(&state.displacement)));
    FilmSignal::of(film, &means(&sheet, Turned::of(film, model), &points, None))
}

/// Whether a film's length is the second side of its sheet.
#[derive(Clone, Copy)]
struct Turned(bool);

impl Turned {
    fn of(film: &Film, model: &TireModel) -> Self {
        Self(Place::of(film, &model.grid.shape).is_crosswise)
    }

    /// Turns a strain to components along the film's length, across, and in shear.
    fn strain(self, [a, b, c]: &[f64; 3]) -> [f64; 3] {
        if self.0 { [*b, *a, -c] } else { [*a, *b, *c] }
    }
}

fn means(
    sheet: &Sheet,
    turned: Turned,
    [before, now]: &[Vec<SheetPoint>; 2],
    folds: Option<f64>,
) -> FilmMeans {
    let meshed: f64 = now.iter().map(|point| point.area).sum();
    let mut means = FilmMeans {
        area: sheet.area(),
        ..FilmMeans::default()
    };
    for (before, now) in before.iter().zip(now) {
        let share = now.area / meshed;
        let [then, strain] = [before, now].map(|point| turned.strain(&point.strain));
        let [was, is] = [before, now].map(|point| turned.strain(&point.curvature));
        for k in 0..2 {
            means.strain[k] += share * (stretch(strain[k]) / stretch(then[k]) - 1.0);
        }
        for k in 0..3 {
            means.added[k] += share * (strain[k] - then[k]);
            means.total[k] += share * strain[k];
            means.curvature[k] += share * (is[k] - was[k]);
        }
        means.is_wrinkled |= folds.is_some_and(|folds| least_principal(&strain) < -folds);
    }
    means
}

fn stretch(green_lagrange: f64) -> f64 {
    (1.0 + 2.0 * green_lagrange).sqrt()
}

fn least_principal([e1, e2, e12]: &[f64; 3]) -> f64 {
    0.5 * (e1 + e2) - (0.5 * (e1 - e2)).hypot(0.5 * e12)
}

/// Compression at which a stiff film on a thick soft wall folds: (3 Es / Ef)^(2/3) / 4 with moduli in plane strain (X. Chen and J. W. Hutchinson, J. Appl. Mech. 71
/// (2004) 597).
fn folding_strain(scene: &Scene, film: &Film) -> f64 {
    // Incompressible: E = 3 mu, and 4 mu in plane strain.
    let wall = 4.0 * scene.material.law.shear_modulus_mpa();
    let thickness = film.thickness_mm();
    // The film's modulus is that of a single layer with its stiffness in bending.
    let modulus = 12.0 * film.laminate().bending[0][0] / thickness.powi(3);
    (3.0 * wall / modulus).powf(2.0 / 3.0) / 4.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pvdf_film_folds_at_a_third_of_a_percent() {
        let mut scene = Scene::default();
        let film = Film::default();
        // 4 x 0.36 MPa under 2500 / (1 - 0.34^2) MPa.
        let exact = (3.0 * 1.44 / (2500.0 / (1.0 - 0.34_f64.powi(2)))).powf(2.0 / 3.0) / 4.0;
        scene.film = Some(film.clone());
        assert!((folding_strain(&scene, &film) / exact - 1.0).abs() < 1e-12);
        assert!((0.0033..0.0034).contains(&exact), "{exact}");
    }

    #[test]
    fn the_least_principal_strain_of_pure_shear_is_its_negative() {
        assert_eq!(least_principal(&[0.0, 0.0, 0.02]), -0.01);
        assert_eq!(least_principal(&[0.01, -0.02, 0.0]), -0.02);
    }
}
