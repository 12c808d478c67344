//! A sensor film: where it is glued, what it is made of, what it is wired to.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::film::amplifier::Amplifier;
use crate::film::laminate::{Laminate, Layer};
use crate::film::piezo::Piezo;

/// A rectangular film glued to the inner surface of the uninflated tire, its centre at a wheel and a section angle.
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    /// Its layers from the wall inwards, one of them piezoelectric.
    pub layers: Vec<FilmLayer>,
    /// Extent along its first axis, mm.
    pub length_mm: f64,
    /// Extent across, mm.
    pub width_mm: f64,
    /// Wheel angle of its centre from the contact centre, degrees, positive in the rolling direction.
    pub theta_deg: f64,
    /// Section angle of its centre from the crown, degrees.
    pub phi_deg: f64,
    /// Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
    pub angle_deg: f64,
    /// What holds it; absent: it can't slide on the wall.
    pub glue: Option<Glue>,
    /// What makes charge of its stress.
    pub piezo: Piezo,
    /// What it is wired to.
    pub amplifier: Amplifier,
}

/// One layer of a film.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmLayer {
    /// Young's modulus, MPa.
    pub modulus_mpa: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Thickness, mm.
    pub thickness_mm: f64,
    /// Whether this is the layer that makes charge.
    pub piezo: bool,
}

/// A layer of glue between wall and film: it shears.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Glue {
    /// Shear modulus, MPa.
    pub shear_modulus_mpa: f64,
    /// Thickness, mm.
    pub thickness_mm: f64,
}

impl Default for FilmLayer {
    /// PVDF, as piezoelectric films are made of.
    fn default() -> Self {
        Self {
            modulus_mpa: 2500.0,
            poisson_ratio: 0.34,
            thickness_mm: 0.05,
            piezo: true,
        }
    }
}

impl Default for Glue {
    /// A soft transfer tape.
    fn default() -> Self {
        Self {
            shear_modulus_mpa: 0.5,
            thickness_mm: 0.05,
        }
    }
}

impl Default for Film {
    fn default() -> Self {
        Self {
            layers: vec![FilmLayer::default()],
            length_mm: 5.0,
            width_mm: 5.0,
            theta_deg: 0.0,
            phi_deg: 0.0,
            angle_deg: 0.0,
            glue: None,
            piezo: Piezo::default(),
            amplifier: Amplifier::default(),
        }
    }
}

impl Film {
    /// A film of a single layer.
    pub fn of_layer(layer: FilmLayer) -> Self {
        Self {
            layers: vec![layer],
            ..Self::default()
        }
    }

    /// Thickness of all layers, mm.
    pub fn thickness_mm(&self) -> f64 {
        self.layers.iter().map(|layer| layer.thickness_mm).sum()
    }

    /// Its stiffness, and what its piezoelectric layer sees.
    pub fn laminate(&self) -> Laminate {
        let layer = |layer: &FilmLayer| Layer {
            modulus: layer.modulus_mpa,
            poisson_ratio: layer.poisson_ratio,
            thickness: layer.thickness_mm,
        };
        let layers: Vec<Layer> = self.layers.iter().map(layer).collect();
        let piezo = self.layers.iter().position(|layer| layer.piezo);
        Laminate::new(&layers, piezo.unwrap_or(0))
    }

    /// Whether it is unchanged where before and behind the contact centre are exchanged.
    pub fn is_own_mirror_image(&self) -> bool {
        self.theta_deg == 0.0 && self.angle_deg % 90.0 == 0.0
    }

    /// Half of its extent along the circumference and along the section, mm.
    pub fn half_extent_mm(&self) -> [f64; 2] {
        let (sin, cos) = self.angle_deg.to_radians().sin_cos();
        let half = [0.5 * self.length_mm, 0.5 * self.width_mm];
        [
            half[0] * cos.abs() + half[1] * sin.abs(),
            half[0] * sin.abs() + half[1] * cos.abs(),
        ]
    }
}

/// A film of one layer has the layer's fields as its own, others a list of layers.
impl Serialize for Film {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        match self.layers.as_slice() {
            [only] => {
                map.serialize_entry("modulus_mpa", &only.modulus_mpa)?;
                map.serialize_entry("poisson_ratio", &only.poisson_ratio)?;
                map.serialize_entry("thickness_mm", &only.thickness_mm)?;
            }
            layers => map.serialize_entry("layers", layers)?,
        }
        map.serialize_entry("length_mm", &self.length_mm)?;
        map.serialize_entry("width_mm", &self.width_mm)?;
        map.serialize_entry("theta_deg", &self.theta_deg)?;
        map.serialize_entry("phi_deg", &self.phi_deg)?;
        map.serialize_entry("angle_deg", &self.angle_deg)?;
        if let Some(glue) = &self.glue {
            map.serialize_entry("glue", glue)?;
        }
        map.serialize_entry("piezo", &self.piezo)?;
        map.serialize_entry("amplifier", &self.amplifier)?;
        map.end()
    }
}
