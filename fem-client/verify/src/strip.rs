//! A stiff strip glued on a soft half plane that is stretched: what a film much stiffer than its wall is pulled with.
//!
//! An inextensible strip of width 2a on a half plane strained by e has the tension N(x) = E e / (2 (1 - nu^2)) (a^2 - x^2)^(1/2), whatever it is made of
//! (the shear under it is that of a rigid punch that rubs: N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity, section 115).

use std::f64::consts::PI;
use std::sync::atomic::AtomicBool;

use fem::cell::block::Block;
use fem::cell::element::Order;
use fem::cell::mesh::Surface;
use fem::problem::{Loads, Problem, State};
use fem::surface::membrane::Membrane;
use fem::surface::surface_law::{FibreFamily, SurfaceLaw};

use crate::body::{RUBBER, SHEAR_MODULUS, free_block, hold_coordinate_planes, load, rubber};
use crate::family::Unsolved;
use crate::known_case::Case;
use crate::mesh_refinement::graded;

/// Half of the strip's width, mm.
const HALF: f64 = 1.0;
/// Width and depth of the block that stands for the half plane, mm: what it changes falls with the square of 1 / 40.
const FAR: f64 = 40.0;
/// Strain of the half plane. The formula is linear in it.
const STRAIN: f64 = 1e-3;
/// E / (1 - nu^2) of an incompressible body, MPa.
const MODULUS: f64 = 4.0 * SHEAR_MODULUS;
/// Modulus times thickness of the strip over that of as much of the half plane as it is wide.
const STIFFER: f64 = 1e4;
/// Grading towards the strip's edge, where the shear grows as the root of the distance falls.
const GRADING: f64 = 2.0;
/// Grading away from it: the first cells on both sides of the edge are alike.
const OUTWARDS: f64 = 3.5;
/// Relative: twice the block's finite size, the strain and the strip's give.
const TOLERANCE: f64 = 2.0 * (HALF * HALF / (FAR * FAR) + STRAIN + 1.0 / STIFFER);
const SOURCE: &str = "pi E a e / (8 (1 - nu^2)), for an inextensible strip on a half plane";

/// Half of the block, with `cells` under the strip and as many beside and below it.
fn glued(cells: usize) -> Problem {
    let far = FAR - HALF;
    let block = Block::new(Order::PlaneQuadratic, [2 * cells, 1, 2 * cells], |s| {
        let x = match 2.0 * s[0] {
            under if under <= 1.0 => HALF * (1.0 - graded(1.0 - under, cells, GRADING)),
            beside => HALF + far * graded(beside - 1.0, cells, OUTWARDS),
        };
        [
            x,
            0.0,
            FAR * (1.0 - graded(1.0 - s[2], 2 * cells, OUTWARDS)),
        ]
    });
    let top = block.side(2, true);
    let mut problem = free_block(block, rubber(RUBBER, 0.0));
    hold_coordinate_planes(&mut problem);
    for (support, x) in problem.supports.iter_mut().zip(&problem.mesh.nodes) {
        if x[0] == FAR {
            support[0] = Some(STRAIN * FAR);
        }
    }
    let under = |face: &&[u32]| {
        face.iter()
            .all(|&node| problem.mesh.nodes[node as usize][0] <= HALF)
    };
    let faces = top.iter().filter(under).flatten().copied().collect();
    let surface = Surface { faces, ..top };
    let film: Box<dyn SurfaceLaw> = Box::new(FibreFamily {
        angle: 0.0,
        stiffness: STIFFER * MODULUS * HALF,
        compression_ratio: 1.0,
    });
    let strip = Membrane::new(&problem.mesh, surface, &|_, _| [1.0, 0.0, 0.0], vec![film]);
    problem.membranes.push(strip);
    problem
}

/// Mean tension of the strip, N/mm.
fn mean_tension(cells: usize, stop: &AtomicBool) -> Result<f64, Unsolved> {
    let problem = glued(cells);
    let loads = Loads {
        support_factor: 1.0,
        ..Loads::default()
    };
    let (_, state) = load(&problem, &loads, stop)?;
    let strip = &problem.membranes[0];
    let strain = (0..strip.surface.face_count()).map(|face| of_face(strip, face, &state));
    Ok(STIFFER * MODULUS * HALF * strain.sum::<f64>() / strip.area())
}

/// Integral of the strain along the strip over one face, mm^2.
fn of_face(strip: &Membrane, face: usize, state: &State) -> f64 {
    let nodes = strip.surface.face(face).iter();
    let displacement: Vec<[f64; 3]> = nodes
        .map(|&node| state.displacement[node as usize])
        .collect();
    let strains = strip.strains(face, &displacement);
    strains
        .zip(strip.point_areas(face))
        .map(|(strain, area)| strain[0] * area)
        .sum()
}

/// Rate at which the mean tension, as stationary as the energy, converges with the cells: twice the half power of the singularity, times the grading.
const RATE: f64 = GRADING;

/// The strip's mean tension on the finest of three meshes.
pub(super) fn cases(stop: &AtomicBool) -> Result<Vec<Case>, Unsolved> {
    let expected = PI * MODULUS * HALF * STRAIN / 8.0;
    let [coarse, middle, fine] = [4, 8, 16].map(|cells| mean_tension(cells, stop));
    let [coarse, middle, fine] = [coarse?, middle?, fine?];
    let slope = ((coarse - middle) / (middle - fine)).abs().log2();
    let case = Case::relative(
        "stiff strip on a stretched half plane: mean tension, N/mm",
        fine,
        expected,
    );
    Ok(vec![case.slope(slope, RATE).within(TOLERANCE, SOURCE)])
}
