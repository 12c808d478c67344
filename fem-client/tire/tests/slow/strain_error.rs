//! Quality of the estimated strain errors: compared with the true error, which the reference level stands for (its own estimated errors are a third
//! of the standard level's).

use std::sync::atomic::AtomicBool;

use fem_client::scene::{Level, Scene};
use fem_client::solver::gauge::{Gauge, GaugeReading};
use fem_client::solver::{Readout, SolveRequest, Solved, Solver};
use tire::embedded::EmbeddedSolver;
use tire::mesh::tire_grid::Extent;
use tire::model::{TireModel, cord_families, mesh_plan};

static RUNNING: AtomicBool = AtomicBool::new(false);

/// Points over contact, its edges, the shoulder and the sidewall, x and y at each.
fn gauges() -> Vec<Gauge> {
    let crown = [0.0, 3.1, 6.3, 9.4, 12.5].map(|theta| (theta, 0.0));
    let section = [10.0, 20.0, 30.0, 45.0, 60.0, 90.0].map(|phi| (0.0, phi));
    let beside = [3.0, 8.0, 15.0].map(|theta| (theta, 22.9));
    let points = crown.into_iter().chain(section).chain(beside);
    points
        .flat_map(|(theta_deg, phi_deg)| {
            [0.0, 90.0].map(|angle_deg| Gauge {
                theta_deg,
                phi_deg,
                angle_deg,
            })
        })
        .collect()
}

fn solve(level: Level, gauges: Vec<Gauge>) -> Solved {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = level;
    let readout = Readout {
        gauges,
        ..Readout::default()
    };
    EmbeddedSolver::default()
        .solve(&SolveRequest {
            scene: &scene,
            readout: &readout,
            start: None,
            watch: &RUNNING,
        })
        .expect("an equilibrium")
}

fn readings(level: Level) -> Vec<GaugeReading> {
    solve(level, gauges()).response.gauges
}

/// Ratios of estimated to true errors of the strain since inflation, ascending.
fn effectivities(readings: &[GaugeReading], truth: &[GaugeReading]) -> Vec<f64> {
    let ratio = |(r, t): (&GaugeReading, &GaugeReading)| {
        r.error.expect("an estimate").strain / (r.strain - t.strain).abs()
    };
    let mut ratios: Vec<f64> = readings.iter().zip(truth).map(ratio).collect();
    ratios.sort_by(f64::total_cmp);
    ratios
}

#[test]
fn the_estimate_bounds_the_true_error_at_the_standard_level() {
    let truth = readings(Level::Reference);
    for (level, fewest_bounded) in [(Level::Draft, 0.7), (Level::Standard, 0.9)] {
        let found = effectivities(&readings(level), &truth);
        let bounded = found.iter().filter(|ratio| **ratio >= 1.0).count() as f64;
        let share = bounded / found.len() as f64;
        println!(
            "{}: estimated over true error from {:.2}, median {:.1}; at least one in {:.0} %",
            level.as_str(),
            found[0],
            found[found.len() / 2],
            100.0 * share
        );
        // Set after seeing the figures in the README; an estimate of recovered against raw values promises an order of
        // magnitude, not a bound.
        assert!(share >= fewest_bounded, "{}: {found:?}", level.as_str());
        assert!((1.0..20.0).contains(&found[found.len() / 2]), "{found:?}");
    }
}

#[test]
fn gauges_at_the_locations_read_what_the_locations_say() {
    let theta = solve(Level::Draft, Vec::new()).response.locations[3].theta_deg;
    let gauge = |theta_deg, phi_deg, angle_deg| Gauge {
        theta_deg,
        phi_deg,
        angle_deg,
    };
    let response = solve(
        Level::Draft,
        vec![
            gauge(theta, 0.0, 0.0),
            gauge(theta, 0.0, 90.0),
            gauge(7.0, 25.0, 30.0),
            gauge(-7.0, 25.0, -30.0),
            gauge(7.0, -25.0, -30.0),
            gauge(-7.0 + 360.0, -25.0, 30.0 - 180.0),
        ],
    )
    .response;
    let (location, readings) = (&response.locations[3], &response.gauges);
    // Round-off of stretches of order one.
    let same = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} for {b}");
    same(readings[0].strain, location.strain.x);
    same(readings[1].strain, location.strain.y);
    let error = location.error.expect("an estimate");
    same(
        readings[0].error.expect("an estimate").strain,
        error.strain.x,
    );
    same(
        readings[1].error.expect("an estimate").strain,
        error.strain.y,
    );
    same(readings[0].von_mises_mpa, location.von_mises_mpa);
    assert!(error.strain.x > 0.0 && error.strain.y > 0.0 && error.von_mises_mpa > 0.0);
    for reading in readings {
        same(
            reading.green_lagrange,
            0.5 * (reading.stretch.powi(2) - 1.0),
        );
    }
    // Beyond symmetry planes the mirror image of the line has the same strain; other lines don't.
    for mirrored in &readings[3..] {
        same(mirrored.strain, readings[2].strain);
    }
    let other = solve(Level::Draft, vec![gauge(7.0, 25.0, -30.0)]).response;
    assert!((other.gauges[0].strain - readings[2].strain).abs() > 1e-4);
}

#[test]
fn the_carcass_of_the_inflated_tire_carries_what_netting_theory_says() {
    let mut scene = Scene::preset("foot-tire").expect("the preset ships");
    scene.model.level = Level::Draft;
    scene.ground.depths_mm = vec![0.0; 5];
    let solved = EmbeddedSolver::default()
        .solve(&SolveRequest {
            scene: &scene,
            readout: &Readout::default(),
            start: None,
            watch: &RUNNING,
        })
        .expect("an equilibrium");
    let carcass = solved.response.carcass.expect("the preset has a carcass");
    let (stretch, tension) = (carcass.fibre_stretch, carcass.tension_n_per_mm);
    // The least and greatest tension are those of the least and greatest stretch: 100 N/mm, all in tension.
    assert!(stretch.min > 1.0 && stretch.max < 1.05, "{stretch:?}");
    assert!((stretch.max - 1.0 - tension.max / 100.0).abs() < 1e-12);
    assert!((stretch.min - 1.0 - tension.min / 100.0).abs() < 1e-12);

    let plan = mesh_plan(&scene, Level::Draft);
    let model = TireModel::new(&scene, &plan, Extent::Quarter);
    let state = model
        .fit(&solved.state.inflated)
        .expect("the state of this mesh");
    let membrane = model.carcass().expect("a carcass");
    let crown = model.grid.inner_point(std::f64::consts::PI, 0.0).face;
    let nodes = membrane.surface.face(crown).iter();
    let displacement: Vec<[f64; 3]> = nodes.map(|&n| state.displacement[n as usize]).collect();
    let family = cord_families(scene.carcass.as_ref().expect("a carcass"))[0];
    let tensions = membrane.strains(crown, &displacement);
    let mean = tensions.map(|strain| family.tension(&strain)).sum::<f64>() / 4.0;
    // Equilibrium of a toroidal membrane of section radius a: the meridional force at the crown, at the distance R + a from
    // the axle, is p a (2 R + a) / (2 (R + a)), and two families at 55 degrees carry T = force / (2 sin^2 55) each, where
    // nothing else carries. The pressure acts on the inner radius.
    let (a, big_r) = (9.5, 37.5);
    let force = 0.2 * a * (2.0 * big_r + a) / (2.0 * (big_r + a));
    let netting = force / (2.0 * 55f64.to_radians().sin().powi(2));
    println!(
        "tension at the crown {mean:.3} N/mm, netting theory {netting:.3}; over all {tension:?}"
    );
    // The rubber takes the wall of 3 mm times mu (4 * 0.022 + 2 * 0.010), 7 % of the force. The rest is bending of a wall
    // that is no membrane; the bound of 20 % was set after seeing 12 %.
    assert!(
        (0.8 * netting..netting).contains(&mean),
        "{mean} for {netting}"
    );
}
