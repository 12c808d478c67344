//! The other code's cords: the corner between taut and slack is rounded off over a strain of 0.004 to either side.
//!
//! With the extension s = lambda - 1 and half the width w the tension is k (c s + (1 - c) r(s)): c the ratio of the stiffness in
//! compression to that in tension, r = (s + w)^2 / (4 w) between -w and w, 0 below and s above.

use fem::surface::membrane::Membrane;
use fem::surface::surface_law::{FibreFamily, InPlane, SurfaceLaw};
use fem::tensor::Vector;
use fem_client::scene::Carcass;
use tire::model::{TireModel, cord_families};

const HALF_WIDTH: f64 = 0.004;

#[derive(Debug)]
struct RoundedCords(FibreFamily);

impl RoundedCords {
    /// Energy, tension and stiffness at an extension.
    fn response(&self, s: f64) -> [f64; 3] {
        let (w, c) = (HALF_WIDTH, self.0.compression_ratio);
        let ramp = if s < -w {
            [0.0; 3]
        } else if s < w {
            let reach = s + w;
            [
                reach.powi(3) / (12.0 * w),
                reach.powi(2) / (4.0 * w),
                reach / (2.0 * w),
            ]
        } else {
            [0.5 * s * s + w * w / 6.0, s, 1.0]
        };
        let elastic = [0.5 * s * s, s, 1.0];
        [0, 1, 2].map(|i| self.0.stiffness * (c * elastic[i] + (1.0 - c) * ramp[i]))
    }
}

impl SurfaceLaw for RoundedCords {
    fn energy(&self, strain: &InPlane) -> f64 {
        self.response(self.0.stretch(strain) - 1.0)[0]
    }

    fn tensions(&self, strain: &InPlane) -> (InPlane, [InPlane; 3]) {
        let stretch = self.0.stretch(strain);
        let [_, tension, slope] = self.response(stretch - 1.0);
        let (sin, cos) = self.0.angle.sin_cos();
        // Derivatives of the strain along the cord, whose own derivative by the stretch is the stretch.
        let m = [cos * cos, sin * sin, cos * sin];
        let along = tension / stretch;
        let modulus = (slope - along) / (stretch * stretch);
        (
            m.map(|m| along * m),
            m.map(|row| m.map(|column| modulus * (row * column))),
        )
    }

    fn stiffness(&self) -> f64 {
        self.0.stiffness
    }
}

/// Puts the other code's cords into a model in place of ours.
pub fn round_off(model: &mut TireModel, carcass: &Carcass) {
    let laws =
        cord_families(carcass).map(|family| Box::new(RoundedCords(family)) as Box<dyn SurfaceLaw>);
    let surface = model.grid.carcass_surface().expect("it has a carcass");
    let along_wheel = |position: &Vector, _: &Vector| [-position[2], 0.0, position[0]];
    let layer = Membrane::new(&model.problem.mesh, surface, &along_wheel, laws.into());
    model.problem.membranes = vec![layer];
}
