//! Integration points between a sheet and the surface under it.

use super::control_net::{Control, Outline};
use crate::cell::element::face_shape;
use crate::cell::mesh::{Mesh, Surface, SurfacePoint};
use crate::cell::quadrature::rectangle;
use crate::surface::surface_law::InPlane;
use crate::tensor::{Vector, cross, dot, norm};

/// Gauss points along each side of a span.
const POINTS: usize = 3;

/// Stiffness of a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elasticity {
    /// Tensions by strains, N/mm.
    pub membrane: [InPlane; 3],
    /// Moments by changes of curvature, N mm.
    pub bending: [InPlane; 3],
    /// Stiffness of the springs to the surface, N/mm^3.
    pub glue: f64,
}

/// The surface under a sheet.
#[derive(Clone, Copy)]
pub struct Underlay<'u> {
    /// The mesh that it belongs to.
    pub mesh: &'u Mesh,
    /// Faces of the surface.
    pub surface: &'u Surface,
    /// The point of the surface under a point (s1, s2) of the sheet, mm, and the signs of its displacements: -1 for the one across a symmetry plane beyond which the
    /// point is the mirror image of the one meant.
    pub place: &'u dyn Fn([f64; 2]) -> (SurfacePoint, Vector),
}

/// A sheet, ready to be integrated.
#[derive(Debug)]
pub struct Sheet {
    /// Stiffness of the sheet.
    pub elasticity: Elasticity,
    /// Outline and control points of the sheet.
    pub outline: Outline,
    /// Reference positions of its own control points, mm.
    pub positions: Vec<Vector>,
    pub(super) elements: Vec<Element>,
    /// Number of its first control point among the nodes of the mesh.
    pub(super) first_node: u32,
}

/// A span of the sheet with what lies under it.
#[derive(Debug)]
pub(super) struct Element {
    /// Own control points, then nodes of the surface.
    pub(super) nodes: Vec<u32>,
    /// Number of nodes that are control points.
    pub(super) controls: usize,
    pub(super) points: Vec<Point>,
}

/// An integration point. Functions are those of the element's own control points, each with the signs of their displacements.
#[derive(Debug)]
pub(super) struct Point {
    /// Reference area, mm^2.
    pub(super) area: f64,
    /// Values: control point, displacement.
    pub(super) values: Vec<Vector>,
    /// Derivatives along the reference axes, 1/mm: control point, axis, displacement.
    pub(super) first: Vec<[Vector; 2]>,
    /// Second derivatives 11, 22, 12, 1/mm^2: control point, component, displacement.
    pub(super) second: Vec<[Vector; 3]>,
    /// Orthonormal reference axes.
    pub(super) axes: [Vector; 2],
    /// Second derivatives of the reference position, 1/mm.
    pub(super) bend: [Vector; 3],
    /// Functions of the surface's nodes: place among the element's nodes, value by displacement.
    pub(super) under: Vec<(usize, Vector)>,
}

impl Sheet {
    /// Lays a sheet on a surface; its control points are the nodes from `first_node` on, in the order of `positions`.
    pub fn new(
        outline: Outline,
        elasticity: Elasticity,
        underlay: Underlay<'_>,
        first_node: u32,
    ) -> Self {
        let seats: Vec<Vec<Seat>> = outline
            .spans()
            .map(|span| seats(&outline, span, underlay))
            .collect();
        let positions = fitted(&outline, &seats, |seat| seat.position);
        let elements = seats.iter();
        let elements = elements.map(|seats| element(&outline, seats, &positions, first_node));
        Self {
            elasticity,
            outline,
            elements: elements.collect(),
            positions,
            first_node,
        }
    }

    /// Reference area of the whole sheet, mirror images included, mm^2.
    pub fn area(&self) -> f64 {
        let points = self.elements.iter().flat_map(|element| &element.points);
        self.outline.copies() * points.map(|point| point.area).sum::<f64>()
    }

    /// Stiffness times the root of the area: the force at a strain of order one, N.
    pub(crate) fn natural_force(&self) -> f64 {
        self.elasticity.membrane[0][0] * self.area().sqrt()
    }

    /// Displacements of the control points, mm, with which the sheet follows those of the surface as closely as it can (least squares over its area): what a
    /// sheet without stiffness does.
    pub fn following(&self, displacement: &[Vector]) -> Vec<Vector> {
        let spans = self.outline.spans().zip(&self.elements);
        let seats: Vec<Vec<Seat>> = spans
            .map(|(span, element)| {
                let points = rule().zip(&element.points);
                let seat = |((t, weight), point): (([f64; 2], f64), &Point)| Seat {
                    span,
                    t,
                    weight,
                    position: point.under_value(element, displacement),
                    under: Vec::new(),
                };
                points.map(seat).collect()
            })
            .collect();
        fitted(&self.outline, &seats, |seat| seat.position)
    }
}

impl Point {
    /// A field of the surface at this point.
    pub(super) fn under_value(&self, element: &Element, field: &[Vector]) -> Vector {
        let mut value = [0.0; 3];
        for (local, weight) in &self.under {
            for i in 0..3 {
                value[i] += weight[i] * field[element.nodes[*local] as usize][i];
            }
        }
        value
    }
}

/// A Gauss point of a span and the surface under it.
struct Seat {
    span: [usize; 2],
    /// Shares of the span.
    t: [f64; 2],
    weight: f64,
    /// Position of the surface, or another field there.
    position: Vector,
    /// Nodes of the surface with their values by displacement.
    under: Vec<(u32, Vector)>,
}

/// Gauss points of a span, as shares of it, with weights that sum to one.
fn rule() -> impl Iterator<Item = ([f64; 2], f64)> {
    let points = rectangle([POINTS; 2]).into_iter();
    points.map(|(x, weight)| (x.map(|x| 0.5 * (1.0 + x)), 0.25 * weight))
}

fn seats(outline: &Outline, span: [usize; 2], underlay: Underlay<'_>) -> Vec<Seat> {
    let area = outline.width(0) * outline.width(1);
    rule()
        .map(|(t, weight)| {
            let (point, signs) = (underlay.place)(outline.at(span, t));
            let (values, _) = face_shape(underlay.surface.order, point.local);
            let values = values.iter().map(|value| signs.map(|sign| sign * value));
            let nodes = underlay.surface.face(point.face).iter().copied();
            let under: Vec<(u32, Vector)> = nodes.zip(values).collect();
            let position = [0, 1, 2].map(|i| {
                let at = |node: u32| underlay.mesh.nodes[node as usize][i];
                under.iter().map(|(node, value)| value[i] * at(*node)).sum()
            });
            Seat {
                span,
                t,
                weight: weight * area,
                position,
                under,
            }
        })
        .collect()
}

/// Control values whose spline is closest to a field at the seats (least squares).
fn fitted(outline: &Outline, seats: &[Vec<Seat>], field: impl Fn(&Seat) -> Vector) -> Vec<Vector> {
    let n = outline.node_count();
    let mut fitted = vec![[0.0; 3]; n];
    // Mirror images have their own sign in each component, so that each has its own equations.
    for i in 0..3 {
        let mut normal = vec![vec![0.0; n]; n];
        let mut rhs = vec![[0.0; 1]; n];
        for seat in seats.iter().flatten() {
            let [along, across] = outline.bases(seat.span, seat.t);
            let value = field(seat)[i];
            let controls = outline.controls(seat.span);
            let row: Vec<(usize, f64)> = controls
                .iter()
                .enumerate()
                .map(|(a, (node, sign))| {
                    (*node, sign[i] * along.values[a % 3] * across.values[a / 3])
                })
                .collect();
            for &(a, left) in &row {
                rhs[a][0] += seat.weight * left * value;
                for &(b, right) in &row {
                    normal[a][b] += seat.weight * left * right;
                }
            }
        }
        crate::surface::small_system::solve_spd(&mut normal, &mut rhs);
        for (fitted, value) in fitted.iter_mut().zip(rhs) {
            fitted[i] = value[0];
        }
    }
    fitted
}

/// The element of a span.
fn element(outline: &Outline, seats: &[Seat], positions: &[Vector], first_node: u32) -> Element {
    let controls = outline.controls(seats[0].span);
    let mut own: Vec<usize> = controls.iter().map(|control| control.0).collect();
    own.sort_unstable();
    own.dedup();
    let mut under: Vec<u32> = seats.iter().flat_map(|s| &s.under).map(|u| u.0).collect();
    under.sort_unstable();
    under.dedup();
    let points = seats.iter().map(|seat| {
        let under = seat.under.iter().map(|&(node, value)| {
            let place = under.partition_point(|&other| other < node);
            (own.len() + place, value)
        });
        let under = under.collect();
        Functions::of(outline, seat, &controls, &own).point(seat.weight, positions, &own, under)
    });
    let points = points.collect();
    let nodes = own
        .iter()
        .map(|&a| first_node + a as u32)
        .chain(under.iter().copied());
    Element {
        nodes: nodes.collect(),
        controls: own.len(),
        points,
    }
}

/// Functions of the own control points of a span and their derivatives by s1 and s2: control point, then displacement.
struct Functions {
    values: Vec<Vector>,
    first: Vec<[Vector; 2]>,
    second: Vec<[Vector; 3]>,
}

impl Functions {
    fn of(outline: &Outline, seat: &Seat, controls: &[Control; 9], own: &[usize]) -> Self {
        let [along, across] = outline.bases(seat.span, seat.t);
        let mut functions = Self {
            values: vec![[0.0; 3]; own.len()],
            first: vec![[[0.0; 3]; 2]; own.len()],
            second: vec![[[0.0; 3]; 3]; own.len()],
        };
        for (a, (node, sign)) in controls.iter().enumerate() {
            let k = own.partition_point(|other| other < node);
            let (i, j) = (a % 3, a / 3);
            for (axis, sign) in sign.iter().enumerate() {
                functions.values[k][axis] += sign * along.values[i] * across.values[j];
                functions.first[k][0][axis] += sign * along.first[i] * across.values[j];
                functions.first[k][1][axis] += sign * along.values[i] * across.first[j];
                functions.second[k][0][axis] += sign * along.second[i] * across.values[j];
                functions.second[k][1][axis] += sign * along.values[i] * across.second[j];
                functions.second[k][2][axis] += sign * along.first[i] * across.first[j];
            }
        }
        functions
    }

    /// The integration point, with derivatives along orthonormal axes; the first runs along s1.
    fn point(
        self,
        weight: f64,
        positions: &[Vector],
        own: &[usize],
        under: Vec<(usize, Vector)>,
    ) -> Point {
        let at: Vec<Vector> = own.iter().map(|&a| positions[a]).collect();
        let t1 = weighted(&at, |k| &self.first[k][0]);
        let t2 = weighted(&at, |k| &self.first[k][1]);
        let normal = cross(&t1, &t2);
        let area = norm(&normal);
        let normal = normal.map(|n| n / area);
        let length = norm(&t1);
        let first = t1.map(|t| t / length);
        let axes = [first, cross(&normal, &first)];
        // Derivatives along the axes by those along s: the dual tangents' components.
        let duals = [cross(&t2, &normal), cross(&normal, &t1)].map(|t| t.map(|c| c / area));
        let turn = axes.map(|axis| [dot(&duals[0], &axis), dot(&duals[1], &axis)]);
        let first: Vec<[Vector; 2]> = self.first.iter().map(|d| turned(&turn, d)).collect();
        let second: Vec<[Vector; 3]> = self.second.iter().map(|d| turned_twice(&turn, d)).collect();
        Point {
            area: weight * area,
            bend: [0, 1, 2].map(|c| weighted(&at, |k| &second[k][c])),
            values: self.values,
            first,
            second,
            axes,
            under,
        }
    }
}

/// Sum over control points, component by component.
pub(super) fn weighted<'f>(values: &[Vector], function: impl Fn(usize) -> &'f Vector) -> Vector {
    let mut sum = [0.0; 3];
    for (k, value) in values.iter().enumerate() {
        let weight = function(k);
        for i in 0..3 {
            sum[i] += weight[i] * value[i];
        }
    }
    sum
}

fn turned(turn: &[[f64; 2]; 2], d: &[Vector; 2]) -> [Vector; 2] {
    turn.map(|[a, b]| [0, 1, 2].map(|i| a * d[0][i] + b * d[1][i]))
}

/// Components 11, 22, 12.
fn turned_twice(turn: &[[f64; 2]; 2], d: &[Vector; 3]) -> [Vector; 3] {
    [(0, 0), (1, 1), (0, 1)].map(|(a, b)| {
        let ([a1, a2], [b1, b2]) = (turn[a], turn[b]);
        [0, 1, 2].map(|i| a1 * b1 * d[0][i] + a2 * b2 * d[1][i] + (a1 * b2 + a2 * b1) * d[2][i])
    })
}
