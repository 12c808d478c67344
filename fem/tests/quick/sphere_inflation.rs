//! Inflation of a neo-Hookean sphere through its limit point, against the exact solution.

use std::sync::atomic::AtomicBool;

use fem::cell::block::{Block, join};
use fem::cell::element::Order;
use fem::cell::mesh::Surface;
use fem::load::pressure::PressureSurface;
use fem::material::MooneyRivlin;
use fem::newton::iteration::{Cause, Newton};
use fem::newton::path::{Stability, follow};
use fem::newton::volume_control::{Ending, VolumeControl};
use fem::problem::{Loads, Problem, State};
use fem::solid::SolidModel;
use fem::tensor::{Vector, norm};

static RUNNING: AtomicBool = AtomicBool::new(false);
const RATIO: f64 = 2.0;
/// Share of a load step with which a failed one goes on.
const CUT_BACK: f64 = 0.25;

/// An octant between the radii 1 and `RATIO`: three patches of a cube, n x n x radial bricks each.
fn octant(n: usize, radial: usize, material: MooneyRivlin) -> Problem {
    let patch = |axis: usize| {
        Block::new(Order::Quadratic, [n, n, radial], move |s| {
            // Equal angles along the edges; tan(pi / 4) isn't exactly 1.
            let edge = |t: f64| {
                if t == 1.0 {
                    1.0
                } else {
                    (std::f64::consts::FRAC_PI_4 * t).tan()
                }
            };
            let mut x: Vector = [0.0; 3];
            x[axis] = 1.0;
            x[(axis + 1) % 3] = edge(s[0]);
            x[(axis + 2) % 3] = edge(s[1]);
            let scale = RATIO.powf(s[2]) / norm(&x);
            x.map(|c| c * scale)
        })
    };
    let blocks = [patch(0), patch(1), patch(2)];
    let (mesh, layout, numbers) = join(&blocks);
    let inner = blocks.iter().zip(&numbers).flat_map(|(block, numbers)| {
        let faces = block.side(2, false).faces;
        faces.into_iter().map(|node| numbers[node as usize])
    });
    let surface = Surface {
        order: mesh.order,
        faces: inner.collect(),
    };
    let held = |c: f64| (c == 0.0).then_some(0.0);
    Problem {
        supports: mesh.nodes.iter().map(|x| x.map(held)).collect(),
        layout,
        solid: SolidModel {
            material: Box::new(material),
            compliance: 0.0,
        },
        membranes: vec![],
        sheet: None,
        pressure: Some(PressureSurface::new(surface)),
        contact: None,
        dead_forces: vec![],
        mesh,
    }
}

/// Exact pressure over shear modulus at a stretch of the inner radius, neo-Hookean: half the difference of
/// l^-4 + 4 / l between the outer and the inner radius.
fn exact(inner: f64) -> f64 {
    let outer = (1.0 + (inner.powi(3) - 1.0) / RATIO.powi(3)).cbrt();
    let g = |l: f64| l.powi(-4) + 4.0 / l;
    0.5 * (g(outer) - g(inner))
}

#[test]
fn a_neo_hookean_sphere_passes_its_limit_point() {
    let rubber = MooneyRivlin { c10: 0.5, c01: 0.0 };
    let problem = octant(3, 3, rubber);
    let mut control = VolumeControl::new(&problem).expect("a valid mesh");
    let start = control.reference(&RUNNING).expect("nothing to do");
    assert_eq!(start.pressure, 0.0);
    // The inner surface, of quadratic faces, encloses an octant of the ball to the fourth power of 45 degrees / 2.
    let octant = std::f64::consts::PI / 6.0;
    assert!(
        (start.volume / octant - 1.0).abs() < 1e-3,
        "{}",
        start.volume
    );

    let ending = control.inflate(&start, f64::INFINITY, 30.0 * start.volume, &RUNNING);
    let Ending::LimitPoint(limit) = ending else {
        panic!("a neo-Hookean sphere has a limit point: {ending:?}");
    };
    // The maximum of `exact` to 16 digits; three quadratic bricks through the wall come to 2e-4, seen before the bound was set.
    let stretch = (limit.volume / start.volume).cbrt();
    println!("limit pressure {} at {stretch}", limit.pressure);
    assert!((limit.pressure / 0.816_423_647_955_400_1 - 1.0).abs() < 1e-3);
    assert!((stretch / 1.828_147_304_936_349_5 - 1.0).abs() < 1e-2);

    let beyond = control
        .solve(&limit, 1.5 * limit.volume, &RUNNING)
        .expect("an equilibrium of lower pressure");
    let stretch = (beyond.volume / start.volume).cbrt();
    assert!(beyond.slope < 0.0 && beyond.inertia.negative == 1);
    assert!((beyond.pressure / exact(stretch) - 1.0).abs() < 1e-3);
    // The slope is the path's own, but for the bulk modulus of the Newton step (1e5 shear moduli instead of infinity) and
    // the difference's truncation: 1e-4 together, seen before the bound was set.
    let mut pressure = |factor: f64| {
        let near = control.solve(&beyond, factor * beyond.volume, &RUNNING);
        near.expect("a near equilibrium").pressure
    };
    let h = 0.005;
    let difference = (pressure(1.0 + h) - pressure(1.0 - h)) / (2.0 * h * beyond.volume);
    assert!(
        (difference / beyond.slope - 1.0).abs() < 3e-4,
        "{difference} {}",
        beyond.slope
    );
}

#[test]
fn a_mooney_rivlin_sphere_of_the_same_size_has_none() {
    // C01 / C10 = 0.25 is beyond the ratio 0.2145 up to which a thin sphere has a limit point.
    let rubber = MooneyRivlin {
        c10: 0.144,
        c01: 0.036,
    };
    let problem = octant(1, 2, rubber);
    let mut control = VolumeControl::new(&problem).expect("a valid mesh");
    let start = control.reference(&RUNNING).expect("nothing to do");
    let ending = control.inflate(&start, f64::INFINITY, 27.0 * start.volume, &RUNNING);
    assert!(matches!(ending, Ending::Outgrown(_)), "{ending:?}");
}

#[test]
fn a_path_ends_at_the_pressure_asked_for() {
    let rubber = MooneyRivlin { c10: 0.5, c01: 0.0 };
    let problem = octant(1, 2, rubber);
    let mut control = VolumeControl::new(&problem).expect("a valid mesh");
    let start = control.reference(&RUNNING).expect("nothing to do");
    let ending = control.inflate(&start, 0.6, 27.0 * start.volume, &RUNNING);
    let Ending::Reached(near) = ending else {
        panic!("0.6 MPa is below the limit pressure: {ending:?}");
    };
    // one step of the path changes the pressure by at most a third
    assert!(
        (near.pressure / 0.6 - 1.0).abs() < 0.17,
        "{}",
        near.pressure
    );
    assert!(near.slope > 0.0 && near.inertia.is_positive());
}

/// Load steps have no way round the limit point: they come as near as their smallest step, and refuse what lies beyond.
#[test]
fn load_steps_end_at_the_limit_pressure() {
    let problem = octant(1, 2, MooneyRivlin { c10: 0.5, c01: 0.0 });
    let mut control = VolumeControl::new(&problem).expect("a valid mesh");
    let start = control.reference(&RUNNING).expect("nothing to do");
    let ending = control.inflate(&start, f64::INFINITY, 27.0 * start.volume, &RUNNING);
    let Ending::LimitPoint(limit) = ending else {
        panic!("a neo-Hookean sphere has a limit point: {ending:?}");
    };
    let target = Loads {
        pressure: 1.5,
        ..Loads::default()
    };
    let mut newton = Newton::new(&problem).expect("a valid mesh");
    let mut state = State::reference(&problem);
    let start = Loads::default();
    let path = follow(
        &mut newton,
        &mut state,
        &start,
        &target,
        Stability::Required,
        &RUNNING,
    );
    let failure = path.expect_err("no equilibrium beyond");
    println!(
        "reached {} of {}: {:?}",
        failure.loads.pressure, limit.pressure, failure.cause
    );
    // A failed step of twice the smallest one is not cut again, and a quarter of it may go by.
    let near = 2.0 / CUT_BACK * newton.settings.smallest_load_step * target.pressure;
    assert!(failure.loads.pressure < limit.pressure);
    assert!(failure.loads.pressure > limit.pressure - near, "{near}");
    // What is left is the equilibrium there, on the stable branch.
    let there = control
        .at(state, failure.loads.pressure, &RUNNING)
        .expect("an equilibrium");
    assert!((there.pressure / failure.loads.pressure - 1.0).abs() < 1e-8);
    assert!(there.volume < limit.volume && there.inertia.is_positive());
}

#[test]
fn a_stopped_path_ends_at_its_last_equilibrium() {
    let problem = octant(1, 2, MooneyRivlin { c10: 0.5, c01: 0.0 });
    let mut control = VolumeControl::new(&problem).expect("a valid mesh");
    let start = control.reference(&RUNNING).expect("nothing to do");
    let stopped = AtomicBool::new(true);
    let ending = control.inflate(&start, 0.6, 27.0 * start.volume, &stopped);
    let Ending::Lost { last, failure } = ending else {
        panic!("told to stop: {ending:?}");
    };
    assert_eq!((last, failure.cause), (start, Cause::Stopped));
}
