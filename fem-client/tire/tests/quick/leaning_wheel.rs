//! The reference tire on ground below a wheel that leans.

use std::sync::atomic::AtomicBool;

use fem::newton::iteration::{LargestStep, Newton, NewtonSettings};
use fem::newton::path::{Stability, follow};
use fem::problem::{Loads, State};
use fem::tensor::cross;
use fem_client::scene::{GroundProfile, Level, ProfileKind, Scene};
use fem_client::solver::gauge::Gauge;
use fem_client::solver::{Readout, Response, SolveRequest, Solved, Solver, StartState};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::Extent;
use tire::model::{TireModel, extent, mesh_plan};

static RUNNING: AtomicBool = AtomicBool::new(false);
/// An equilibrium to 1e-8 of the forces leaves 1e-8 in a strain.
pub const STRAIN: f64 = 1e-7;
/// Tolerance of a force, relative to the reaction, for the same reason.
pub const FORCE: f64 = 1e-6;

pub fn leaning(camber_deg: f64) -> Scene {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = Level::Draft;
    scene.ground.camber_deg = camber_deg;
    scene
}

/// Strains along the section on both sides of the middle plane, from -50 to 50 degrees.
pub fn readout() -> Readout {
    let gauges = [-50.0, -20.0, 0.0, 20.0, 50.0].map(|phi_deg| Gauge {
        theta_deg: 4.0,
        phi_deg,
        angle_deg: 90.0,
    });
    Readout {
        gauges: gauges.to_vec(),
        ..Readout::default()
    }
}

pub fn answer(scene: &Scene, readout: &Readout, start: Option<&StartState>) -> Solved {
    let request = SolveRequest {
        scene,
        readout,
        start,
        watch: &RUNNING,
    };
    let solved = EmbeddedSolver::default().solve(&request);
    solved.expect("an equilibrium")
}

pub fn solve(scene: &Scene) -> Response {
    answer(scene, &readout(), None).response
}

pub fn force(response: &Response) -> [f64; 3] {
    response.force_n.expect("the embedded solver tells")
}

pub fn moment(response: &Response) -> [f64; 3] {
    response.moment_nmm.expect("the embedded solver tells")
}

pub fn across(response: &Response) -> Vec<f64> {
    response.gauges.iter().map(|gauge| gauge.strain).collect()
}

pub fn assert_close(a: &[f64], b: &[f64], tolerance: f64) {
    assert_eq!(a.len(), b.len());
    for (x, y) in a.iter().zip(b) {
        assert!((x - y).abs() < tolerance, "{a:?} {b:?}");
    }
}

/// The force is along the normal without friction, which meets the section's circle in its middle: the arm about the wheel's centre is that of the middle.
#[test]
fn the_ground_pushes_along_its_normal() {
    for camber in [-30.0f64, -5.0, 10.0, 30.0] {
        let response = solve(&leaning(camber));
        let (sin, cos) = camber.to_radians().sin_cos();
        let [x, y, z] = force(&response);
        let load = response.reaction_n;
        assert_close(&[x, y, z], &[0.0, load * sin, load * cos], 1e-12 * load);
        let [mx, my, mz] = moment(&response);
        assert_eq!([my, mz], [0.0; 2]);
        // The pressed wall isn't quite a circle.
        let arm = mx / load;
        assert!((arm / (37.5 * sin) - 1.0).abs() < 0.03, "{arm} mm");
        assert_eq!(response.model.dimension, "3d-half");
    }
}

#[test]
fn leaning_the_other_way_exchanges_the_sides() {
    let scene = |camber, depths: [f64; 5]| {
        let mut scene = leaning(camber);
        scene.ground.depths_mm = depths.to_vec();
        scene
    };
    let depths = [1.2, 1.0, 0.9, 1.1, 0.8];
    let [one, other] = [12.0, -12.0].map(|camber| solve(&scene(camber, depths)));
    assert_eq!(one.model.dimension, "3d");
    let mut mirrored = across(&other);
    mirrored.reverse();
    assert_close(&across(&one), &mirrored, STRAIN);
    assert!((mirrored[0] - mirrored[4]).abs() > 0.01, "{mirrored:?}");
    let [x, y, z] = force(&other);
    assert_close(&force(&one), &[x, -y, z], FORCE * z);
    let [x, y, z] = moment(&other);
    assert_close(&moment(&one), &[-x, y, -z], 50.0 * FORCE * one.reaction_n);
    // A positive camber presses the side at negative section angles, where the wall flattens.
    let [pressed, free] = [1, 3].map(|k| across(&one)[k]);
    assert!(pressed > free, "{pressed} {free}");
}

#[test]
fn the_front_answers_for_the_whole_tire() {
    let front = solve(&leaning(12.0));
    let mut scene = leaning(12.0);
    // A femtometre asks for the whole tire and changes nothing else.
    scene.ground.depths_mm[4] += 1e-12;
    let whole = solve(&scene);
    let extents = [&front, &whole].map(|response| response.model.dimension.as_str());
    assert_eq!(extents, ["3d-half", "3d"]);
    assert_close(&across(&front), &across(&whole), STRAIN);
    assert_close(&force(&front), &force(&whole), FORCE * front.reaction_n);
    assert_close(
        &moment(&front),
        &moment(&whole),
        50.0 * FORCE * front.reaction_n,
    );
}

#[test]
fn a_wheel_that_hardly_leans_stands_upright() {
    let (upright, hardly) = (solve(&leaning(0.0)), solve(&leaning(1e-5)));
    assert_eq!(upright.model.dimension, "3d-quarter");
    // 2e-7 rad times strains that change by 0.3 in a radian, and the touching point between nodes.
    assert_close(&across(&upright), &across(&hardly), STRAIN);
    assert!((hardly.reaction_n / upright.reaction_n - 1.0).abs() < FORCE);
}

#[test]
fn ground_that_presses_with_a_force_does_so_along_its_normal() {
    let mut scene = leaning(15.0);
    scene.ground.depths_mm.clear();
    scene.ground.load_n = Some(13.0);
    let by_force = solve(&scene);
    assert!((by_force.reaction_n / 13.0 - 1.0).abs() < FORCE);
    scene.ground = scene.ground.at_depths(vec![by_force.depth_mm; 5]);
    let by_depth = solve(&scene);
    assert_close(&across(&by_force), &across(&by_depth), 1e-6);
    assert!((by_depth.reaction_n / 13.0 - 1.0).abs() < FORCE);
}

/// The starts are an upright wheel, of which a quarter is meshed, and one that leans.
#[test]
fn a_start_elsewhere_leads_to_the_same_place() {
    let mut scene = leaning(8.0);
    let cold = solve(&scene);
    for camber in [0.0, -4.0] {
        let start = answer(&leaning(camber), &readout(), None).state;
        let warm = answer(&scene, &readout(), Some(&start));
        assert_close(&across(&warm.response), &across(&cold), STRAIN);
    }
    // Another wall than the start's, which serves as a guess.
    let start = answer(&leaning(0.0), &readout(), None).state;
    scene.geometry.wall_mm *= 1.01;
    let warm = answer(&scene, &readout(), Some(&start)).response;
    assert_close(&across(&warm), &across(&solve(&scene)), STRAIN);
}

/// Solves by one solver from one start at the same depths: no camber answers for another one.
#[test]
fn every_camber_has_an_answer_of_its_own() {
    let solver = EmbeddedSolver::default();
    let solve_with = |scene: &Scene, start: Option<&StartState>| {
        let request = SolveRequest {
            scene,
            readout: &readout(),
            start,
            watch: &RUNNING,
        };
        solver.solve(&request).expect("an equilibrium")
    };
    let start = solve_with(&leaning(0.0), None).state;
    for camber in [3.0, 9.0, -9.0, 3.0] {
        let scene = leaning(camber);
        let warm = solve_with(&scene, Some(&start)).response;
        assert_close(&across(&warm), &across(&solve(&scene)), STRAIN);
    }
}

/// A start of one part of the tire is never taken for another part's, whatever the number of its unknowns.
#[test]
fn states_of_another_part_are_told_by_what_holds_them() {
    let scene = leaning(10.0);
    // As many nodes along the half circle as across both sides: linear bricks, 2 P + 1 and 2 P.
    let plan = tire::mesh::tire_grid::MeshPlan {
        coarse: 21 - mesh_plan(&scene, Level::Draft).fine,
        meridional: 10,
        ..mesh_plan(&scene, Level::Draft)
    };
    let [half, front] =
        [Extent::Half, Extent::Front].map(|extent| TireModel::new(&scene, &plan, extent));
    let mut newton = Newton::new(&half.problem).expect("a valid mesh");
    let mut state = State::reference(&half.problem);
    let inflated = Loads {
        pressure: scene.pressure.internal_mpa,
        ..Loads::default()
    };
    let ignored = Stability::Ignored;
    follow(
        &mut newton,
        &mut state,
        &Loads::default(),
        &inflated,
        ignored,
        &RUNNING,
    )
    .expect("an equilibrium");
    let flat = state.to_flat();
    assert_eq!(flat.len(), State::reference(&front.problem).to_flat().len());
    assert!(half.fit(&flat).is_some() && front.fit(&flat).is_none());
}

/// The bead holds what the ground does: force and moment come from all of the body's stresses there, from contact pressures and friction here. The pressure
/// itself has neither, as the beads are circles.
#[test]
fn the_bead_holds_force_and_moment_of_the_ground() {
    let sphere = GroundProfile {
        kind: ProfileKind::Sphere,
        radius_mm: 12.0,
        place_mm: [2.0, -1.0],
        direction_deg: 90.0,
        ..GroundProfile::default()
    };
    let rough = GroundProfile {
        kind: ProfileKind::Rough,
        ..sphere.clone()
    };
    for (friction, profile) in [
        (0.0, None),
        (0.5, None),
        (0.5, Some(sphere)),
        (0.5, Some(rough)),
    ] {
        let mut scene = leaning(11.0);
        scene.ground.profile = profile;
        scene.ground.depths_mm = vec![1.2, 1.0, 0.9, 1.1, 0.8];
        scene.contact.friction = friction;
        if friction > 0.0 {
            scene.ground.shift_mm = [0.3, 0.2];
        }
        let model = TireModel::new(&scene, &mesh_plan(&scene, Level::Draft), Extent::Full);
        let mut newton = Newton::new(&model.problem).expect("a valid mesh");
        newton.settings = NewtonSettings {
            tolerance: 1e-13,
            ..NewtonSettings::default()
        };
        let mut state = State::reference(&model.problem);
        let mut reach = |start: &Loads, target: &Loads, steps: f64| {
            newton.settings.largest_load_step = LargestStep::Even(1.0 / steps);
            let ignored = Stability::Ignored;
            follow(&mut newton, &mut state, start, target, ignored, &RUNNING)
                .expect("an equilibrium");
            state.clone()
        };
        let inflated = Loads {
            pressure: scene.pressure.internal_mpa,
            ..Loads::default()
        };
        let state = reach(&Loads::default(), &inflated, 1.0);
        let loads = Loads {
            ground: Some(model.ground_below(&scene.ground, &state)),
            ..inflated.clone()
        };
        let undragged = loads.with_shift([0.0; 2]);
        reach(&inflated, &undragged, 4.0);
        let state = reach(&undragged, &loads, 4.0);
        let position = |node| state.position(&model.problem.mesh, node);
        let (contact, ground) = (model.problem.contact.as_ref(), loads.ground.as_ref());
        let (contact, ground) = (contact.expect("a tread"), ground.expect("set above"));
        let pressing = contact.resultant(ground, position).wrench;
        let rubbing = contact.friction_wrench(ground, &state.anchors, position);
        let mut sums = [[0.0; 3]; 2];
        for i in 0..3 {
            sums[0][i] = pressing.force[i] + rubbing.force[i];
            sums[1][i] = pressing.moment[i] + rubbing.moment[i];
        }
        let largest = sums.map(|sum| sum.iter().fold(0.0, |most: f64, part| most.max(part.abs())));
        assert!(largest[0] > 3.0 && largest[1] > 10.0, "{sums:?}");
        for (node, held) in newton.reactions(&state, &loads).iter().enumerate() {
            let turning = cross(&position(node as u32), held);
            for i in 0..3 {
                sums[0][i] += held[i];
                sums[1][i] += turning[i];
            }
        }
        for (sum, largest) in sums.iter().zip(largest) {
            for part in sum {
                assert!(part.abs() < 1e-10 * largest, "{sums:?} of {largest}");
            }
        }
    }
}

/// Force of the ground across a wheel that leans by 10 degrees with friction, N, pressed in such steps.
fn force_across(press: LargestStep) -> f64 {
    let mut scene = leaning(10.0);
    scene.contact.friction = 0.5;
    let model = TireModel::new(&scene, &mesh_plan(&scene, Level::Draft), extent(&scene));
    let mut newton = Newton::new(&model.problem).expect("a valid mesh");
    newton.settings = EmbeddedSolver::settings();
    let mut state = State::reference(&model.problem);
    let mut reach = |start: &Loads, target: &Loads, step: LargestStep| {
        newton.settings.largest_load_step = step;
        let ignored = Stability::Ignored;
        follow(&mut newton, &mut state, start, target, ignored, &RUNNING).expect("an equilibrium");
        state.clone()
    };
    let inflated = Loads {
        pressure: scene.pressure.internal_mpa,
        ..Loads::default()
    };
    let free = reach(&Loads::default(), &inflated, LargestStep::Even(1.0));
    let ground = model.ground_below(&scene.ground, &free);
    let loads = Loads {
        ground: Some(ground.clone()),
        ..inflated.clone()
    };
    let state = reach(&inflated, &loads, press);
    let position = |node| state.position(&model.problem.mesh, node);
    let contact = model.problem.contact.as_ref().expect("a tread");
    let pressing = contact.resultant(&ground, position).wrench;
    let rubbing = contact.friction_wrench(&ground, &state.anchors, position);
    pressing.force[1] + rubbing.force[1]
}

#[test]
fn steps_in_which_contact_grows_evenly_leave_less_than_twice_as_many_equal_ones() {
    let limit = force_across(LargestStep::OfRoot(1.0 / 64.0));
    let off = |press| force_across(press) - limit;
    let [own, equal] = [
        off(LargestStep::OfRoot(1.0 / 8.0)),
        off(LargestStep::Even(1.0 / 16.0)),
    ];
    println!("{limit} N, off by {own} and {equal} N");
    assert!(own.abs() < 0.5 * equal.abs(), "{own} {equal} of {limit} N");
    // The error falls with the step: sixteen leave half of what eight do, the limit itself an eighth.
    let half = off(LargestStep::OfRoot(1.0 / 16.0));
    assert!(half.abs() < 0.6 * own.abs(), "{half} {own}");
}

#[test]
fn a_derivative_by_the_camber_is_the_limit_of_differences() {
    let by = "ground.camber_deg";
    for camber in [0.0, 6.0] {
        let mut readout = readout();
        readout.derivatives = vec![by.to_owned()];
        let scene = leaning(camber);
        let found = answer(&scene, &readout, None).response.derivatives;
        let of = |path: &[&str]| {
            let start = serde_json::Value::Object(found[0].of.clone());
            path.iter().fold(start, |value, name| value[name].clone())
        };
        let step = 0.01;
        let sides = [-step, step].map(|step| solve(&leaning(camber + step)));
        let difference = |read: &dyn Fn(&Response) -> f64| {
            let [low, high] = sides.each_ref().map(read);
            (high - low) / (2.0 * step)
        };
        for (k, gauge) in found[0].of["gauges"]
            .as_array()
            .expect("a list")
            .iter()
            .enumerate()
        {
            let expected = difference(&|response| response.gauges[k].strain);
            let own = gauge["strain"].as_f64().expect("a number");
            // Equilibria to 1e-8 over the step, and its square.
            assert!((own - expected).abs() < 2e-6, "{k}: {own} {expected}");
        }
        let expected = difference(&|response| force(response)[1]);
        let own = of(&["force_n"])[1].as_f64().expect("a number");
        assert!((own - expected).abs() < 1e-5 * 13.0, "{own} {expected}");
    }
}

/// Depths from the first touch to deep contact, on ground that meets the wall far from the crown.
#[test]
fn extremes_have_an_equilibrium() {
    for camber in [-30.0, 30.0] {
        let mut loads = Vec::new();
        for depth in [1e-6, 0.1, 3.0] {
            let mut scene = leaning(camber);
            scene.ground.depths_mm = vec![depth; 5];
            let response = solve(&scene);
            assert!((response.depth_mm - depth).abs() < 1e-12);
            loads.push(response.reaction_n);
        }
        assert!(loads[0] >= 0.0 && loads[0] < 1e-3, "{loads:?}");
        assert!(loads[1] > loads[0] && loads[2] > 30.0, "{loads:?}");
    }
}
