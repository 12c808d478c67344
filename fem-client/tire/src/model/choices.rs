//! Choices of a scene's model: what it has, and what it leaves out.

use fem::cell::element::Order;
use fem_client::scene::{Film, ProfileKind, Scene};
use fem_client::solver::Choice;

use super::dimensions::shape;
use super::glued_film::Place;
use super::resting_ground::{drag_steps, press_steps};
use crate::mesh::tire_grid::{Extent, TireGrid};
use crate::omission::omissions;

fn choice(what: &str, why: String) -> Choice {
    Choice {
        what: what.into(),
        why,
        effect: None,
    }
}

/// Returns what is modelled, with reasons.
pub(super) fn modelled(scene: &Scene, grid: &TireGrid) -> Vec<Choice> {
    let element = element(grid.order);
    let volume = compressibility(scene.material.d1_per_mpa);
    let mut list = vec![
        choice(
            "wall",
            format!(
                "three-dimensional, {element}: strains across and along the wheel are both asked for"
            ),
        ),
        choice(
            "rubber",
            format!("{}, {volume}", scene.material.law.title()),
        ),
        choice(
            "pressure",
            "live load with its tangent: it follows the deformed inner surface".into(),
        ),
        choice(
            "contact",
            "rigid ground, penalty on the vertical gap".into(),
        ),
    ];
    if scene.ground.leans() {
        let why = format!(
            "the wheel leans by {} degrees: depths and the gap are along the ground's normal",
            scene.ground.camber_deg
        );
        list.push(choice("camber", why));
    }
    if let Some(profile) = &scene.ground.profile {
        let what = match profile.kind {
            ProfileKind::Rough => {
                let own = profile.roughness();
                let [rms, length] = [own.rms_mm, own.correlation_mm];
                format!(
                    "ground that is rough by {rms} mm over {length} mm, seed {}",
                    own.seed
                )
            }
            round => format!(
                "{} of {} mm on the ground",
                round.as_str(),
                profile.radius_mm
            ),
        };
        let why = format!("{what}: the gap is along the ground's normal, as depths are");
        list.push(choice("profile", why));
    }
    if scene.contact.friction > 0.0 {
        let why = format!(
            "Coulomb, coefficient {}, pressed from the inflated state in {} steps: the path matters",
            scene.contact.friction,
            press_steps(scene.model.level)
        );
        list.push(choice("friction", why));
    }
    if scene.ground.is_dragged() {
        let [x, y] = scene.ground.shift_mm;
        let why = format!(
            "once it presses the ground is dragged by {x} mm along the wheel and {y} mm across it, in {} steps: the path matters",
            drag_steps(scene.model.level)
        );
        list.push(choice("shear", why));
    }
    if let Some(film) = &scene.film {
        list.push(choice("film", film_text(scene, film, grid.extent)));
    }
    if scene.carcass.is_some() {
        list.push(choice(
            "carcass",
            "two fibre families as a membrane inside the wall, slack in compression".into(),
        ));
    }
    list
}

fn film_text(scene: &Scene, film: &Film, extent: Extent) -> String {
    let layers = match film.layers.len() {
        1 => "one layer".to_owned(),
        more => format!("{more} layers"),
    };
    let glue = match &film.glue {
        None => "so that it can't slide".to_owned(),
        Some(glue) => format!(
            "with glue of {} MPa and {} mm that shears",
            glue.shear_modulus_mpa, glue.thickness_mm
        ),
    };
    let twin = match Place::of(film, &shape(scene)).has_twin(extent) {
        true => format!(
            "; its mirror image at {} degrees from the crown is there too",
            -film.phi_deg
        ),
        false => String::new(),
    };
    format!(
        "a thin shell of {layers}, {} x {} mm at {} degrees around the wheel and {} from the crown, its length at {} degrees to the circumference, glued on before \
         inflation {glue}{twin}",
        film.length_mm, film.width_mm, film.theta_deg, film.phi_deg, film.angle_deg
    )
}

fn element(order: Order) -> &'static str {
    match order {
        Order::Linear => "8-node bricks with one pressure each (Q1P0)",
        Order::Quadratic => "27-node bricks with a linear pressure each (Q2/P1)",
        Order::PlaneLinear => "4-node quadrilaterals in plane strain with one pressure each (Q1P0)",
        Order::PlaneQuadratic => {
            "9-node quadrilaterals in plane strain with a linear pressure each (Q2/P1)"
        }
    }
}

fn compressibility(d1_per_mpa: f64) -> String {
    if d1_per_mpa == 0.0 {
        "exactly incompressible, because d1_per_mpa is 0".to_string()
    } else {
        format!("bulk modulus {} MPa from d1_per_mpa", 2.0 / d1_per_mpa)
    }
}

/// Returns what is left out, with reasons; the effect is known where it is nothing.
pub(super) fn left_out(scene: &Scene, extent: Extent) -> Vec<Choice> {
    let exact = |what: &str, why: &str| Choice {
        what: what.into(),
        why: why.into(),
        effect: Some(0.0),
    };
    let mut list = Vec::new();
    if !extent.is_whole_across() {
        list.push(exact(
            "y < 0",
            "tire, ground and loads are symmetric about the wheel's middle plane: exact",
        ));
    }
    if !extent.is_whole_along() {
        list.push(exact(
            "x < 0",
            "the depths are symmetric about the contact centre: exact",
        ));
    }
    let omitted = omissions(scene).into_iter();
    list.extend(omitted.map(|omission| choice(omission.what, omission.why)));
    list
}
