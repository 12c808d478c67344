//! The reference tire on ground with a sphere, a cylinder or an edge.

use fem_client::scene::{GroundProfile, Level, ProfileKind, Scene};
use fem_client::solver::Response;

use crate::leaning_wheel::{FORCE, STRAIN, across, assert_close, force, leaning, moment, solve};

fn on(kind: ProfileKind, radius_mm: f64, place_mm: [f64; 2], direction_deg: f64) -> Scene {
    let mut scene = leaning(0.0);
    scene.ground.profile = Some(GroundProfile {
        kind,
        radius_mm,
        place_mm,
        direction_deg,
        ..GroundProfile::default()
    });
    scene
}

fn sphere(radius_mm: f64, place_mm: [f64; 2]) -> Scene {
    on(ProfileKind::Sphere, radius_mm, place_mm, 90.0)
}

fn along(response: &Response) -> Vec<[f64; 2]> {
    let of = |own: &fem_client::solver::LocationStrain| [own.strain.x, own.strain.y];
    response.locations.iter().map(of).collect()
}

fn rough(rms_mm: f64, correlation_mm: f64, seed: u64) -> Scene {
    let mut scene = on(ProfileKind::Rough, 1.0, [0.0; 2], 0.0);
    let profile = scene.ground.profile.as_mut().expect("given above");
    profile.rms_mm = Some(rms_mm);
    profile.correlation_mm = Some(correlation_mm);
    profile.seed = Some(seed);
    scene
}

#[test]
fn a_sphere_of_a_large_radius_is_a_plane_to_first_order_in_its_curvature() {
    let plane = solve(&leaning(0.0));
    let off = |radius_mm: f64| {
        let found = solve(&sphere(radius_mm, [0.0; 2]));
        assert_eq!(found.model.dimension, "3d-quarter");
        let pairs = across(&found).into_iter().zip(across(&plane));
        let strain = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        [strain, (found.reaction_n - plane.reaction_n).abs()]
    };
    let [near, far] = [1e5, 1e6].map(off);
    // The equilibria leave 1e-8 of strains and forces.
    assert!(far[0] < 1e-4 && far[1] < 0.01, "{far:?}");
    for (near, far) in near.into_iter().zip(far) {
        assert!((near / far / 10.0 - 1.0).abs() < 0.05, "{near} {far}");
    }
}

/// Ten times as high changes strains and forces ten times as much but for the second order, and turned over the other way.
#[test]
fn rough_ground_changes_the_answer_in_proportion_to_its_height() {
    let mut plane = leaning(0.0);
    plane.ground.camber_deg = 1e-12;
    plane.ground.depths_mm[4] += 1e-12;
    let plane = solve(&plane);
    let off = |rms_mm: f64| {
        let found = solve(&rough(rms_mm, 6.0, 2));
        assert_eq!(found.model.dimension, "3d");
        let pairs = across(&found).into_iter().zip(across(&plane));
        let force = force(&found).into_iter().zip(force(&plane));
        let strains: Vec<f64> = pairs.map(|(a, b)| a - b).collect();
        (strains, force.map(|(a, b)| a - b).collect::<Vec<f64>>())
    };
    let (near, far) = (off(1e-4), off(1e-3));
    let largest = |values: &[f64]| {
        values
            .iter()
            .fold(0.0, |most: f64, own| most.max(own.abs()))
    };
    for (near, far) in [(&near.0, &far.0), (&near.1, &far.1)] {
        let scale = largest(far);
        assert!(scale > 1e-5);
        for (near, far) in near.iter().zip(far) {
            assert!(
                (10.0 * near - far).abs() < 0.05 * scale,
                "{near} {far} {scale}"
            );
        }
    }
}

#[test]
fn mirrored_places_have_mirrored_answers() {
    let [one, behind, beside] =
        [[3.0, 2.0], [-3.0, 2.0], [3.0, -2.0]].map(|place| solve(&sphere(8.0, place)));
    assert_eq!(one.model.dimension, "3d");
    let mut of_behind = along(&behind);
    of_behind.reverse();
    let flat = |strains: &[[f64; 2]]| strains.concat();
    assert_close(&flat(&along(&one)), &flat(&of_behind), STRAIN);
    assert!((one.locations[0].strain.y - one.locations[4].strain.y).abs() > 1e-3);
    let mut of_beside = across(&beside);
    of_beside.reverse();
    assert_close(&across(&one), &of_beside, STRAIN);
    let ([x, y, z], load) = (force(&one), one.reaction_n);
    assert_close(&force(&behind), &[-x, y, z], FORCE * load);
    assert_close(&force(&beside), &[x, -y, z], FORCE * load);
    let [mx, my, mz] = moment(&one);
    assert_close(&moment(&behind), &[mx, -my, -mz], 50.0 * FORCE * load);
    // What lies ahead and to the left pushes back and to the right.
    assert!(x < -0.01 * load && y < -0.01 * load, "{x} {y} {load}");
}

/// A femtometre at one station and a camber of as little ask for the whole tire and change nothing else.
#[test]
fn parts_of_the_tire_answer_for_all_of_it() {
    let edge = |direction| on(ProfileKind::Edge, 6.0, [1.0, 0.0], direction);
    let cylinder = |direction| on(ProfileKind::Cylinder, 6.0, [0.0; 2], direction);
    for (scene, part) in [
        (sphere(8.0, [0.0; 2]), "3d-quarter"),
        (cylinder(90.0), "3d-quarter"),
        (cylinder(0.0), "3d-quarter"),
        (cylinder(30.0), "3d"),
        (edge(90.0), "3d-half"),
        (edge(180.0), "3d-half"),
        (sphere(8.0, [0.0, 2.0]), "3d-half"),
    ] {
        let found = solve(&scene);
        assert_eq!(found.model.dimension, part, "{:?}", scene.ground.profile);
        let mut whole = scene.clone();
        whole.ground.depths_mm[4] += 1e-12;
        whole.ground.camber_deg = 1e-12;
        let whole = solve(&whole);
        assert_eq!(whole.model.dimension, "3d");
        assert_close(&across(&found), &across(&whole), STRAIN);
        assert_close(&force(&found), &force(&whole), FORCE * found.reaction_n);
    }
}

/// An edge across the wheel whose high side is ahead (90 degrees: it falls off to the left, which is behind) is climbed: it pushes back. Turned about it is the
/// mirror image.
#[test]
fn an_edge_that_is_climbed_pushes_back() {
    let edge = |place: f64, direction| on(ProfileKind::Edge, 6.0, [place, 0.0], direction);
    let [climbed, left] = [edge(2.0, 90.0), edge(-2.0, 270.0)].map(|scene| solve(&scene));
    let [x, y, z] = force(&climbed);
    assert!(x < -0.01 * z && y.abs() < 1e-12 * z, "{x} {y} {z}");
    assert_close(&force(&left), &[-x, y, z], FORCE * z);
}

/// A narrow obstacle bears less than flat ground at the same depth, a wider one more; first touch to deep contact.
#[test]
fn extremes_have_an_equilibrium() {
    for depth in [0.02, 0.3, 3.0] {
        let mut last = 0.0;
        for radius in [0.5, 5.0, 50.0, 5e3] {
            let mut scene = sphere(radius, [0.0; 2]);
            scene.model.level = Level::Draft;
            scene.ground = scene.ground.at_depths(vec![depth; 5]);
            let load = solve(&scene).reaction_n;
            assert!(load >= last && load.is_finite(), "{depth} {radius} {load}");
            last = load;
        }
        assert!(last > 0.0);
    }
    for (rms, correlation, depth) in [(0.3, 1.5, 0.0), (0.1, 1.5, 1.0), (1.2, 5.0, 1.0)] {
        bears(rms, correlation, depth);
    }
}

/// Deeper it takes half a minute: `make prove` runs this.
#[test]
#[ignore = "takes half a minute"]
fn high_crests_that_are_pressed_in_far_have_one_too() {
    bears(1.2, 5.0, 2.0);
}

/// Rough ground on the draft mesh, pressed in so far, has an equilibrium.
fn bears(rms: f64, correlation: f64, depth: f64) {
    let mut scene = rough(rms, correlation, 5);
    scene.model.level = Level::Draft;
    scene.ground = scene.ground.at_depths(vec![depth; 5]);
    let load = solve(&scene).reaction_n;
    assert!(load >= 0.0 && load.is_finite(), "{rms} {depth} {load}");
}
