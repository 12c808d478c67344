//! Nodal forces and stiffness of a sheet and its glue.

use super::glued_sheet::{Element, Point, Sheet};
use super::sheet_state::Kinematics;
use crate::surface::surface_law::InPlane;
use crate::tensor::Vector;

/// Buffers to which an element's forces and stiffness are added.
pub(crate) struct Buffers<'b> {
    /// Nodal forces, N.
    pub(crate) residual: &'b mut [f64],
    /// Stiffness, N/mm, all of it by rows; absent where forces alone are asked for.
    pub(crate) stiffness: Option<&'b mut [f64]>,
}

impl Sheet {
    /// Number of elements.
    pub(crate) fn element_count(&self) -> usize {
        self.elements.len()
    }

    /// Nodes of an element.
    pub(crate) fn nodes(&self, element: usize) -> &[u32] {
        &self.elements[element].nodes
    }

    /// Adds an element's nodal forces and stiffness. `before` are the displacements at which the last tangent was taken, if there was one.
    ///
    /// With them the tension that stiffens the tangent geometrically is the one that the last step foresaw, S - D (g_A . g_B) / 2 with the step's gradient g, not the
    /// one after it: to a stiff sheet the square of a rotation looks like a huge stretch (mixed integration points, D. Magisano, L. Leonetti, G. Garcea, Comput.
    /// Methods Appl. Mech. Engrg 313 (2017) 792). The equilibrium is the same, the way there shorter.
    pub(crate) fn integrate(
        &self,
        element: usize,
        displacement: &[Vector],
        before: Option<&[Vector]>,
        mut buffers: Buffers<'_>,
    ) {
        let element = &self.elements[element];
        let controls = &displacement[..element.controls];
        for point in &element.points {
            let kinematics = point.kinematics(controls);
            self.add_membrane(point, &kinematics, controls, before, &mut buffers, element);
            self.add_bending(point, &kinematics, &mut buffers, element);
            self.add_glue(point, displacement, &mut buffers, element);
        }
    }

    fn add_membrane(
        &self,
        point: &Point,
        kinematics: &Kinematics,
        controls: &[Vector],
        before: Option<&[Vector]>,
        buffers: &mut Buffers<'_>,
        element: &Element,
    ) {
        let moduli = &self.elasticity.membrane;
        let tensions = times(moduli, &kinematics.strain);
        // Rows of the strains' derivatives: 11, 22, 12 doubled.
        let x = &kinematics.tangents;
        let rows = rows(element.controls, |k, i| {
            let [d1, d2] = [point.first[k][0][i], point.first[k][1][i]];
            [d1 * x[0][i], d2 * x[1][i], d1 * x[1][i] + d2 * x[0][i]]
        });
        add(point.area, &rows, moduli, &tensions, buffers, element);
        let Some(stiffness) = buffers.stiffness.as_deref_mut() else {
            return;
        };
        let foreseen = match before {
            Some(before) => foreseen(point, moduli, &kinematics.strain, controls, before),
            None => tensions,
        };
        let (size, [s11, s22, s12]) = (3 * element.nodes.len(), foreseen);
        for k in 0..element.controls {
            for l in 0..element.controls {
                for i in 0..3 {
                    let ([a1, a2], [b1, b2]) =
                        (point.first[k].map(|d| d[i]), point.first[l].map(|d| d[i]));
                    let term = s11 * a1 * b1 + s22 * a2 * b2 + s12 * (a1 * b2 + a2 * b1);
                    stiffness[(3 * k + i) * size + 3 * l + i] += point.area * term;
                }
            }
        }
    }

    fn add_bending(
        &self,
        point: &Point,
        kinematics: &Kinematics,
        buffers: &mut Buffers<'_>,
        element: &Element,
    ) {
        let moduli = &self.elasticity.bending;
        let moments = times(moduli, &kinematics.curvature);
        let (n, gamma) = (&kinematics.normal, &kinematics.christoffel);
        let rows = rows(element.controls, |k, i| {
            let [d1, d2] = [point.first[k][0][i], point.first[k][1][i]];
            let row =
                |c: usize| (point.second[k][c][i] - gamma[c][0] * d1 - gamma[c][1] * d2) * n[i];
            [row(0), row(1), 2.0 * row(2)]
        });
        add(point.area, &rows, moduli, &moments, buffers, element);
    }

    fn add_glue(
        &self,
        point: &Point,
        displacement: &[Vector],
        buffers: &mut Buffers<'_>,
        element: &Element,
    ) {
        let spring = point.area * self.elasticity.glue;
        let size = 3 * element.nodes.len();
        for i in 0..3 {
            let own = point.values.iter().enumerate().map(|(k, v)| (k, v[i]));
            let under = point.under.iter().map(|(place, v)| (*place, -v[i]));
            let terms: Vec<(usize, f64)> = own.chain(under).collect();
            let gap: f64 = terms.iter().map(|&(k, v)| v * displacement[k][i]).sum();
            for &(k, v) in &terms {
                buffers.residual[3 * k + i] += spring * v * gap;
            }
            if let Some(stiffness) = buffers.stiffness.as_deref_mut() {
                for &(k, v) in &terms {
                    for &(l, w) in &terms {
                        stiffness[(3 * k + i) * size + 3 * l + i] += spring * v * w;
                    }
                }
            }
        }
    }
}

/// Derivatives of three strains or curvatures by the displacements of the control points.
fn rows(controls: usize, row: impl Fn(usize, usize) -> InPlane) -> Vec<InPlane> {
    (0..3 * controls).map(|m| row(m / 3, m % 3)).collect()
}

/// Adds forces r . s and the material's part of the stiffness r . D r.
fn add(
    area: f64,
    rows: &[InPlane],
    moduli: &[InPlane; 3],
    stresses: &InPlane,
    buffers: &mut Buffers<'_>,
    element: &Element,
) {
    for (force, row) in buffers.residual.iter_mut().zip(rows) {
        *force += area * (0..3).map(|c| row[c] * stresses[c]).sum::<f64>();
    }
    let Some(stiffness) = buffers.stiffness.as_deref_mut() else {
        return;
    };
    let size = 3 * element.nodes.len();
    for (m, row) in rows.iter().enumerate() {
        let stress = times(moduli, row).map(|s| area * s);
        for (value, column) in stiffness[m * size..].iter_mut().zip(rows) {
            *value += stress[0] * column[0] + stress[1] * column[1] + stress[2] * column[2];
        }
    }
}

/// Tensions that the last linearisation foresaw of this state.
fn foreseen(
    point: &Point,
    moduli: &[InPlane; 3],
    strain: &InPlane,
    controls: &[Vector],
    before: &[Vector],
) -> InPlane {
    let mut step = [[0.0; 3]; 2];
    for (k, (now, then)) in controls.iter().zip(before).enumerate() {
        for i in 0..3 {
            for (step, d) in step.iter_mut().zip(&point.first[k]) {
                step[i] += d[i] * (now[i] - then[i]);
            }
        }
    }
    let product = |a: usize, b: usize| (0..3).map(|i| step[a][i] * step[b][i]).sum::<f64>();
    let linear = [
        strain[0] - 0.5 * product(0, 0),
        strain[1] - 0.5 * product(1, 1),
        strain[2] - product(0, 1),
    ];
    times(moduli, &linear)
}

fn times(moduli: &[InPlane; 3], strain: &InPlane) -> InPlane {
    moduli.map(|row| (0..3).map(|c| row[c] * strain[c]).sum())
}
