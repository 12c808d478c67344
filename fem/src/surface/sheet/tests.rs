use super::sheet_forces::Buffers;
use super::{Elasticity, Outline, Sheet, Underlay};
use crate::cell::element::Order;
use crate::cell::mesh::{Mesh, Surface, SurfacePoint};
use crate::central_differences::{assert_upper_agrees, derivative};
use crate::tensor::{Vector, dot};

const MEMBRANE: [[f64; 3]; 3] = [[100.0, 30.0, 0.0], [30.0, 100.0, 0.0], [0.0, 0.0, 35.0]];

fn elasticity(bending: f64, glue: f64) -> Elasticity {
    Elasticity {
        membrane: MEMBRANE,
        bending: MEMBRANE.map(|row| row.map(|d| bending * d)),
        glue,
    }
}

/// Makes a face of 9 nodes over -1 to 1, mapped into space.
fn face(map: impl Fn([f64; 2]) -> Vector) -> (Mesh, Surface) {
    let order = Order::Quadratic;
    let nodes = (0..9).map(|a| map([(a % 3) as f64 - 1.0, (a / 3) as f64 - 1.0]));
    let mesh = Mesh {
        order,
        nodes: nodes.collect(),
        bricks: vec![],
    };
    let faces = (0..9).collect();
    (mesh, Surface { order, faces })
}

/// A sheet over the part from -0.8 to 0.8 and -0.6 to 0.6 of a face, turned by an angle.
fn on_face(mesh: &Mesh, surface: &Surface, turn: f64, elasticity: Elasticity) -> Sheet {
    let (sin, cos) = turn.sin_cos();
    let outline = Outline {
        half: [0.5, 0.4],
        spans: [2, 3],
        mirrors: [None, None],
    };
    let place = |[a, b]: [f64; 2]| {
        let local = [a * cos - b * sin, a * sin + b * cos];
        (SurfacePoint { face: 0, local }, [1.0; 3])
    };
    let underlay = Underlay {
        mesh,
        surface,
        place: &place,
    };
    Sheet::new(outline, elasticity, underlay, mesh.nodes.len() as u32)
}

fn bulged([a, b]: [f64; 2]) -> Vector {
    [a + 0.1 * b, b, 0.2 * a * a - 0.1 * a * b]
}

/// All positions of mesh and sheet.
fn positions(mesh: &Mesh, sheet: &Sheet) -> Vec<Vector> {
    [&mesh.nodes[..], &sheet.positions[..]].concat()
}

/// Forces on all nodes, of their displacements.
fn forces(sheet: &Sheet, displacement: &[Vector]) -> Vec<f64> {
    let mut all = vec![0.0; 3 * displacement.len()];
    for element in 0..sheet.element_count() {
        let nodes = sheet.nodes(element);
        let local: Vec<Vector> = nodes.iter().map(|&n| displacement[n as usize]).collect();
        let mut residual = vec![0.0; 3 * nodes.len()];
        let buffers = Buffers {
            residual: &mut residual,
            stiffness: None,
        };
        sheet.integrate(element, &local, None, buffers);
        for (node, force) in nodes.iter().zip(residual.chunks_exact(3)) {
            for i in 0..3 {
                all[3 * *node as usize + i] += force[i];
            }
        }
    }
    all
}

/// Stiffness of the first element and its derivative, at a displacement.
fn compare_stiffness(sheet: &Sheet, displacement: &[Vector], tolerance: f64) {
    let nodes = sheet.nodes(0);
    let local: Vec<Vector> = nodes.iter().map(|&n| displacement[n as usize]).collect();
    let unknowns = 3 * nodes.len();
    let force = |local: &[Vector]| {
        let mut residual = vec![0.0; unknowns];
        let buffers = Buffers {
            residual: &mut residual,
            stiffness: None,
        };
        sheet.integrate(0, local, None, buffers);
        residual
    };
    let mut stiffness = vec![0.0; unknowns * unknowns];
    let buffers = Buffers {
        residual: &mut vec![0.0; unknowns],
        stiffness: Some(&mut stiffness),
    };
    sheet.integrate(0, &local, None, buffers);
    assert_upper_agrees(&stiffness, &derivative(&local, 1e-5, force), tolerance);
}

fn bent(x: &Vector) -> Vector {
    [
        0.1 * x[0] * x[1],
        -0.05 * x[0],
        0.1 * x[0] + 0.05 * x[1] * x[1],
    ]
}

#[test]
fn stiffness_is_the_derivative_of_the_forces() {
    let (mesh, surface) = face(bulged);
    let sheet = on_face(&mesh, &surface, 0.4, elasticity(0.0, 7.0));
    let displacement: Vec<Vector> = positions(&mesh, &sheet).iter().map(bent).collect();
    // Truncation, h^2 times a third derivative, and round-off, eps f / h, with stiffnesses of order 100 over lengths of order 0.1.
    compare_stiffness(&sheet, &displacement, 1e-5);
    // Bending's second derivatives are multiplied by moments, which are zero in the reference state.
    let sheet = on_face(&mesh, &surface, 0.4, elasticity(0.01, 7.0));
    compare_stiffness(&sheet, &vec![[0.0; 3]; displacement.len()], 1e-5);
}

#[test]
fn a_rotation_of_the_whole_turns_the_forces() {
    let (mesh, surface) = face(bulged);
    let sheet = on_face(&mesh, &surface, -0.3, elasticity(0.01, 7.0));
    let at = positions(&mesh, &sheet);
    let displacement: Vec<Vector> = at.iter().map(bent).collect();
    let q = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]];
    let turn = |x: &Vector| q.map(|row| dot(&row, x));
    let turned = at.iter().zip(&displacement).map(|(x, u)| {
        let moved = turn(&[0, 1, 2].map(|i| x[i] + u[i]));
        [0, 1, 2].map(|i| moved[i] - x[i])
    });
    let turned: Vec<Vector> = turned.collect();
    let (here, there) = (forces(&sheet, &displacement), forces(&sheet, &turned));
    for (f, g) in here.chunks_exact(3).zip(there.chunks_exact(3)) {
        let expected = turn(&[f[0], f[1], f[2]]);
        for i in 0..3 {
            // The sheet follows this quadratic face exactly, so that glue has no gap that a rotation could turn. Round-off of forces of order 100.
            assert!((g[i] - expected[i]).abs() < 1e-11 * 100.0, "{f:?} {g:?}");
        }
    }
}

/// A flat face becomes a part of a cylinder of radius R about the second axis: no strain of the middle, and the curvature 1 / R.
#[test]
fn a_sheet_rolled_to_a_cylinder_has_its_curvature_and_no_strain() {
    const RADIUS: f64 = 2.0;
    let (mesh, surface) = face(|[a, b]| [a, b, 0.0]);
    let error = |spans: usize| {
        let outline = Outline {
            half: [0.8, 0.5],
            spans: [spans, 2],
            mirrors: [None, None],
        };
        let place = |local| (SurfacePoint { face: 0, local }, [1.0; 3]);
        let underlay = Underlay {
            mesh: &mesh,
            surface: &surface,
            place: &place,
        };
        let sheet = Sheet::new(outline, elasticity(1.0, 0.0), underlay, 9);
        // The control point's angle for which the rolled net is the spline closest to the cylinder isn't its own; tangents at the ends and the mean over the supports
        // make an error of the second order.
        let rolled = sheet.positions.iter().map(|x| {
            let angle = x[0] / RADIUS;
            [
                RADIUS * angle.sin() - x[0],
                0.0,
                RADIUS * (1.0 - angle.cos()),
            ]
        });
        let points = sheet.points_of(&rolled.collect::<Vec<_>>());
        let inner = |k: usize| k % (spans * 9) / 9 > 0 && k % (spans * 9) / 9 < spans - 1;
        let points: Vec<_> = points
            .into_iter()
            .enumerate()
            .filter(|(k, _)| inner(*k))
            .collect();
        let worst = |of: &dyn Fn(&super::SheetPoint) -> f64| {
            points.iter().map(|(_, p)| of(p).abs()).fold(0.0, f64::max)
        };
        assert!(worst(&|p| p.curvature[1]) < 1e-12 && worst(&|p| p.curvature[2]) < 1e-12);
        [
            worst(&|p| p.curvature[0] - 1.0 / RADIUS),
            worst(&|p| p.strain[0]),
        ]
    };
    let (coarse, fine) = (error(8), error(16));
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        // Second order: 4 times smaller on spans of half the width, up to terms of the next order.
        assert!((3.6..4.4).contains(&(coarse / fine)), "{coarse} {fine}");
    }
    assert!(fine[0] < 1e-3 && fine[1] < 1e-3, "{fine:?}");
}

/// A sheet without stiffness takes on a displacement of the surface that its splines have, exactly.
#[test]
fn a_following_sheet_has_the_surface_s_strain() {
    let (mesh, surface) = face(|[a, b]| [a, b, 0.0]);
    let sheet = on_face(&mesh, &surface, 0.7, elasticity(0.0, 1.0));
    let stretch = |x: &Vector| [0.02 * x[0], -0.01 * x[1], 0.0];
    let displacement: Vec<Vector> = mesh.nodes.iter().map(stretch).collect();
    let following = sheet.following(&displacement);
    let (sin, cos) = 0.7_f64.sin_cos();
    let [e1, e2] = [0.02 + 0.5 * 0.02 * 0.02, -0.01 + 0.5 * 0.01 * 0.01];
    for point in sheet.points_of(&following) {
        let along = cos * cos * e1 + sin * sin * e2;
        assert!((point.strain[0] - along).abs() < 1e-13, "{point:?}");
        assert!((point.strain[1] - (e1 + e2 - along)).abs() < 1e-13);
        assert!(point.curvature.iter().all(|k| k.abs() < 1e-12));
    }
    assert!((sheet.area() - 0.8).abs() < 1e-14);
}

/// The half on one side of a symmetry plane says what the whole sheet says.
#[test]
fn a_mirrored_half_is_the_whole() {
    let (mesh, surface) = face(|[a, b]| [a, b, 0.1 * a * a]);
    let of = |mirrors| {
        let outline = Outline {
            half: [0.8, 0.5],
            spans: [4, 2],
            mirrors,
        };
        let place = |local| (SurfacePoint { face: 0, local }, [1.0; 3]);
        let underlay = Underlay {
            mesh: &mesh,
            surface: &surface,
            place: &place,
        };
        Sheet::new(outline, elasticity(0.1, 3.0), underlay, 9)
    };
    let (whole, half) = (of([None; 2]), of([Some(0), None]));
    assert!((whole.area() - half.area()).abs() < 1e-14);
    assert_eq!(half.positions.len(), whole.positions.len() / 2);
    let symmetric = |x: &Vector| {
        [
            0.1 * x[0] * (1.0 + x[1]),
            0.05 * x[0] * x[0],
            0.1 * x[0] * x[0],
        ]
    };
    let displace =
        |sheet: &Sheet| -> Vec<Vector> { positions(&mesh, sheet).iter().map(symmetric).collect() };
    let (all, some) = (
        whole.points(&displace(&whole)),
        half.points(&displace(&half)),
    );
    for point in &some {
        let twin = all.iter().any(|other| {
            let close = |a: &[f64; 3], b: &[f64; 3]| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-12);
            close(&other.strain, &point.strain) && close(&other.curvature, &point.curvature)
        });
        assert!(twin, "{point:?}");
    }
}
