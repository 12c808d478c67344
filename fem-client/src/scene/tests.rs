//! Scenes as documents.

use super::*;

#[test]
fn shipped_scenes_read_without_faults() {
    for (name, _) in PRESETS {
        assert!(Scene::preset(name).is_some());
    }
    assert_eq!(Scene::preset("bicycle"), None);
}

#[test]
fn the_shipped_tire_is_the_default_with_its_carcass() {
    let expected = Scene {
        carcass: Some(Carcass::default()),
        ..Scene::default()
    };
    assert_eq!(Scene::preset("foot-tire"), Some(expected));
}

#[test]
fn the_canonical_text_reads_back_as_the_same_scene() {
    let mut scene = Scene::preset("foot-tire").unwrap();
    scene.film = Some(Film::default());
    scene.ground.depths_mm[3] = 0.1 + 0.2;
    scene.contact.penalty_n_per_mm3 = Some(1.0 / 3.0);
    assert!(!scene.canonical_json().contains("shift"));
    scene.contact.friction = 0.5;
    scene.ground.shift_mm = [0.0, -0.1];
    let text = scene.canonical_json();
    assert_eq!(Scene::from_json(&text).unwrap(), scene);
    assert_eq!(Scene::from_json(&text).unwrap().canonical_json(), text);
}

/// Texts, and all that is told of each: the place of a fault, with the beginning of its sentence where that matters.
const FAULTY: &str = r##"
* colour = 1
    [geometry]
    wall_mm = -3
    bead_angle_deg = 'wide'
    [material]
    c10_mpa = 0
    [carcass]
    angle_deg = 91
    position = 1.5
    [pressure]
    internal_mpa = -0.1
    [ground]
    depths_mm = [1, -1, true]
    station_functions = 'spline'
    [contact]
    friction = -0.5
    penalty_n_per_mm3 = 0
    [model]
    level = 'fine'
    -> /colour | /geometry/wall_mm | /geometry/bead_angle_deg | /material/c10_mpa | /carcass/angle_deg | /carcass/position | /pressure/internal_mpa |
       /ground/station_functions | /ground/depths_mm/1 | /ground/depths_mm/2 | /contact/friction | /contact/penalty_n_per_mm3 | /model/level
* accuracy = { preset = 'draft' }
    colour = 1
    -> /accuracy | /colour
* geometry = { wall_mm = 12.5 } -> /geometry/wall_mm
* geometry = { wall_mm = 0.01 } -> /geometry/wall_mm
* geometry = { section_radius_mm = 34 } -> /geometry/section_radius_mm
* geometry = { kind = 'mesh', file = 'tire.inp' } -> /geometry/kind: this version models only "tire"; "mesh" isn't available yet
* ground = { station_spacing_mm = 26 } -> /ground/station_spacing_mm
* ground = { depths_mm = [13] } -> /ground/depths_mm/0
* ground = { depths_mm = [] } -> /ground/depths_mm
* ground = { stations = 4 } -> /ground/stations
* ground = { stations = 3, depths_mm = [1, 1] } -> /ground/stations
* ground = { load_n = 13, depths_mm = [1] } -> /ground/load_n
* ground = { camber_deg = 31 } -> /ground/camber_deg: must be a number from -30 to 30
* ground = { camber_deg = nan } -> /ground/camber_deg
* ground = { camber_deg = 'steep' } -> /ground/camber_deg
* ground = { load_n = nan, stations = 4 } -> /ground/load_n | /ground/stations
* ground = { shift_mm = [0.5, 0] } -> /ground/shift_mm: needs contact.friction
* contact = { friction = 0.5 }
    ground = { shift_mm = [] }
    -> /ground/shift_mm
* contact = { friction = 0.5 }
    ground = { shift_mm = [0.5] }
    -> /ground/shift_mm
* contact = { friction = 0.5 }
    ground = { shift_mm = [0.5, 0, 0] }
    -> /ground/shift_mm
* contact = { friction = 0.5 }
    ground = { shift_mm = 0.5 }
    -> /ground/shift_mm
* contact = { friction = 0.5 }
    ground = { shift_mm = 'far' }
    -> /ground/shift_mm
* contact = { friction = 0.5 }
    ground = { shift_mm = nan }
    -> /ground/shift_mm
* contact = { friction = 0.5 }
    ground = { shift_mm = [nan, 'far'] }
    -> /ground/shift_mm/0 | /ground/shift_mm/1
* contact = { friction = 0.5 }
    ground = { shift_mm = [-12.6, 13] }
    -> /ground/shift_mm/0 | /ground/shift_mm/1
* material = { model = 'neo-hookean', c01_mpa = 0.036, terms = [], colour = 1 }
    -> /material/colour | /material/c01_mpa: is no parameter of model "neo-hookean", which has c10_mpa | /material/terms
* material = { c20_mpa = 1 } -> /material/c20_mpa
* material = { model = 'ogden', c10_mpa = 1 } -> /material/c10_mpa
* material = { model = 'gent', j_m = 1 } -> /material/model: must be "mooney-rivlin", "neo-hookean", "yeoh" or "ogden"; it is "gent"
* material = { model = 'ogden', terms = [] } -> /material/terms
* material = { model = 'ogden', terms = 1 } -> /material/terms
* material = { model = 'ogden', terms = { mu_mpa = 1, alpha = 2 } } -> /material/terms
* material = { model = 'ogden', terms = [{ alpha = 0 }, { mu_mpa = 1, alpha = 31, beta = 2 }, 3] }
    -> /material/terms/0/mu_mpa | /material/terms/0/alpha | /material/terms/1/beta | /material/terms/1/alpha | /material/terms/2
* material = { model = 'ogden', terms = [{ mu_mpa = 0.3, alpha = 2 }, { mu_mpa = -0.3, alpha = -2 }] } -> /material/terms: the rubber is unstable
* material = { model = 'yeoh', c10_mpa = -0.1 } -> /material/c10_mpa
* [film]
    modulus_mpa = 0
    piezo = { d31_pc_per_n = nan, permittivity_pf_per_m = -1 }
    amplifier = { kind = 'voltage', cable_pf = -1, feedback_nf = 1 }
    -> /film/modulus_mpa | /film/piezo/d31_pc_per_n | /film/piezo/permittivity_pf_per_m | /film/amplifier/feedback_nf | /film/amplifier/cable_pf
* film = { amplifier = { kind = 'tube' } } -> /film/amplifier/kind
* film = { piezo = 3 } -> /film/piezo
* film = { thickness_mm = 0.31, length_mm = 296, width_mm = 40 } -> /film/thickness_mm | /film/width_mm | /film/length_mm
* film = { modulus_mpa = 0, poisson_ratio = 0.6, angle = 1 } -> /film/angle | /film/modulus_mpa | /film/poisson_ratio
# 2 mm of 9.5 mm radius are left to the bead: 12 degrees.
* film = { phi_deg = 108 } -> /film/width_mm
* film = { phi_deg = -108, angle_deg = 90, width_mm = 3 } -> /film/length_mm
* film = { phi_deg = 120 } -> /film/phi_deg
* film = { theta_deg = 181, phi_deg = nan, angle_deg = 'x' } -> /film/theta_deg | /film/phi_deg | /film/angle_deg
* film = { layers = 3 } -> /film/layers
* film = { layers = [] } -> /film/layers
* film = { layers = [3] } -> /film/layers/0
* film = { layers = [{ thickness_mm = 0.028 }] } -> /film/layers
* film = { layers = [{ piezo = true }, { piezo = true }] } -> /film/layers
* film = { layers = [{ piezo = 1 }] } -> /film/layers/0/piezo
* film = { layers = [{ piezo = true, thickness_mm = -1 }] } -> /film/layers/0/thickness_mm
* film = { layers = [{ piezo = true, thickness_mm = 0.4 }] } -> /film/thickness_mm
* film = { layers = [{ piezo = true }], modulus_mpa = 100 } -> /film/modulus_mpa
* film = { glue = { thickness_mm = 0 } } -> /film/glue/thickness_mm
"##;

#[test]
fn every_fault_is_told_at_its_place() {
    for row in FAULTY.split("\n* ").skip(1) {
        let (text, expected) = row.split_once("->").expect("a row");
        let expected = expected.lines().filter(|line| !line.starts_with('#'));
        let expected: String = expected.collect();
        let expected: Vec<&str> = expected.split(" | ").map(str::trim).collect();
        let faults = Scene::from_toml(text).expect_err(text);
        let told: Vec<String> = faults.iter().map(ToString::to_string).collect();
        let is_told = |(told, expected): (&String, &&str)| {
            let rest = told.strip_prefix(expected);
            rest.is_some_and(|rest| expected.contains(": ") || rest.starts_with(": "))
        };
        let all = told.len() == expected.len() && told.iter().zip(&expected).all(is_told);
        assert!(all, "{text}\nexpected {expected:#?}\ntold {told:#?}");
    }
}

#[test]
fn an_empty_document_is_the_default() {
    assert_eq!(Scene::from_toml("").unwrap(), Scene::default());
    assert_eq!(Scene::from_json("{}").unwrap(), Scene::default());
}

#[test]
fn an_empty_carcass_table_has_the_reference_values() {
    assert_eq!(
        Scene::from_toml("[carcass]").unwrap().carcass,
        Some(Carcass::default())
    );
    assert_eq!(
        Scene::from_json("{\"carcass\": null}").unwrap().carcass,
        None
    );
}

#[test]
fn a_load_stands_in_place_of_depths() {
    let read = |ground: &str| Scene::from_toml(&format!("[ground]\n{ground}"));
    let loaded = read("load_n = 13").unwrap().ground;
    assert_eq!((loaded.load_n, loaded.stations), (Some(13.0), 5));
    assert!(loaded.depths_mm.is_empty());
    assert_eq!(read("load_n = 0\nstations = 3").unwrap().ground.stations, 3);
}

#[test]
fn a_shift_is_two_ways_within_the_section_on_ground_with_friction() {
    let read = |shift: &str| format!("[ground]\nshift_mm = {shift}\n[contact]\nfriction = 0.5");
    let dragged = Scene::from_toml(&read("[0.5, -12.5]")).unwrap().ground;
    assert_eq!(dragged.shift_mm, [0.5, -12.5]);
    // Nowhere is where all ground was before.
    let still = Scene::from_toml("[ground]\nshift_mm = [0, -0.0]").unwrap();
    assert_eq!(still, Scene::default());
    assert_eq!(still.canonical_json(), Scene::default().canonical_json());
}

#[test]
fn an_upright_wheel_is_the_one_that_was_there_before_wheels_could_lean() {
    let read = |camber: &str| Scene::from_toml(&format!("[ground]\ncamber_deg = {camber}"));
    for camber in ["0", "-0.0"] {
        let upright = read(camber).unwrap();
        assert_eq!(upright, Scene::default());
        assert_eq!(upright.canonical_json(), Scene::default().canonical_json());
    }
    let ground = read("-12.5").unwrap().ground;
    assert!(ground.camber_deg == -12.5 && !ground.is_alike_across() && ground.is_symmetric());
}

#[test]
fn stations_follow_the_depths() {
    assert_eq!(
        Scene::from_toml("[ground]\ndepths_mm = [1, 2, 3]")
            .unwrap()
            .ground
            .stations,
        3
    );
    assert_eq!(
        Scene::from_toml("[ground]\nstations = 7.0")
            .unwrap()
            .ground
            .depths_mm,
        vec![1.0; 7]
    );
}

#[test]
fn wrong_types_never_pass() {
    let names = [
        "geometry", "material", "carcass", "film", "pressure", "ground", "contact", "model",
    ];
    for (name, bad) in names
        .iter()
        .flat_map(|name| ["1", "\"x\"", "[]", "[[]]", "true"].map(|bad| (name, bad)))
    {
        let faults = Scene::from_toml(&format!("{name} = {bad}")).expect_err(bad);
        assert_eq!(faults.len(), 1, "{faults:?}");
        assert_eq!(faults[0].pointer, format!("/{name}"));
    }
}

fn on_ground(ground: &str) -> Result<Scene, String> {
    Scene::from_toml(&format!("ground = {{ {ground} }}")).map_err(|faults| {
        let told = faults
            .iter()
            .map(|fault| format!("{}: {}", fault.pointer, fault.detail));
        told.collect::<Vec<_>>().join("; ")
    })
}

#[test]
fn a_profile_is_read_and_written_and_a_plane_leaves_no_trace() {
    let scene = on_ground("profile = { kind = \"edge\", radius_mm = 4, place_mm = [1, 0] }");
    let scene = scene.expect("reads");
    let profile = scene.ground.profile.clone().expect("given");
    assert_eq!(profile.kind, ProfileKind::Edge);
    assert_eq!(
        (profile.radius_mm, profile.place_mm, profile.direction_deg),
        (4.0, [1.0, 0.0], 90.0)
    );
    let again = Scene::from_json(&scene.canonical_json()).expect("reads what it wrote");
    assert_eq!(again, scene);
    for kind in ["sphere", "cylinder", "edge", "rough"] {
        let scene = on_ground(&format!("profile = {{ kind = \"{kind}\" }}")).expect("reads");
        assert_eq!(Scene::from_json(&scene.canonical_json()), Ok(scene));
    }
    assert!(!Scene::default().canonical_json().contains("profile"));
}

#[test]
fn rough_ground_says_all_of_its_roughness() {
    let scene = on_ground("profile = { kind = \"rough\", rms_mm = 0.25 }").expect("reads");
    let profile = scene.ground.profile.clone().expect("given");
    let own = profile.roughness();
    assert_eq!((own.rms_mm, own.correlation_mm, own.seed), (0.25, 5.0, 1));
    assert!(scene.canonical_json().contains("\"correlation_mm\":5"));
    let mut varied = scene.clone();
    let seed = "ground.profile.seed";
    varied.set(seed, &7.into()).expect("a seed");
    assert_eq!(varied.number_at(seed), Ok(7.0));
    let round = on_ground("profile = { kind = \"sphere\" }").expect("reads");
    assert!(!round.canonical_json().contains("rms_mm"));
}

#[test]
fn what_cannot_be_is_named() {
    for (ground, expected) in [
        ("profile = { kind = \"cone\" }", "/ground/profile/kind: "),
        ("profile = { radius_mm = 0 }", "/ground/profile/radius_mm: "),
        (
            "load_n = 13, profile = { radius_mm = 5 }",
            "/ground/load_n: presses flat ground",
        ),
        (
            "profile = { kind = \"edge\", seed = 3 }",
            "/ground/profile/seed: belongs to kind \"rough\"",
        ),
        (
            "profile = { kind = \"rough\", rms_mm = 2 }",
            "/ground/profile/rms_mm: must be at most a third of correlation_mm (5 mm); it is 2",
        ),
        (
            "profile = { kind = \"rough\", correlation_mm = 1 }",
            "/ground/profile/correlation_mm: must be at least 1.5 mm, half of the wall",
        ),
    ] {
        let found = on_ground(ground).expect_err(expected);
        assert!(found.contains(expected), "{found}");
    }
}
