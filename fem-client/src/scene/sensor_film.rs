//! A sensor film: where it is glued, what it is made of, what it is wired to.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::fault::{Fault, member};
use document::fields::{Fields, Range, plain};
use document::typed::field_value::Field;
use document::typed::table_fields::table_value;
use document::{Table, Value};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::geometry::Geometry;
use super::shared_ranges::{LENGTH, MODULUS};
use crate::film::amplifier::Amplifier;
use crate::film::laminate::{Laminate, Layer};
use crate::film::piezo::Piezo;

const POISSON: Range = Range::new(0.0, 0.5, "");
const HALF_TURN: Range = Range::new(-180.0, 180.0, "degrees");
/// Thickest film, in walls: it has no thickness in the model.
const THICKEST: f64 = 0.1;
const MOST_LAYERS: usize = 8;

/// Fields of a film of one layer, which stand in place of a list.
pub(super) const OF_ONE_LAYER: [&str; 3] = ["modulus_mpa", "poisson_ratio", "thickness_mm"];

/// A rectangular film glued to the inner surface of the uninflated tire, its centre at a wheel and a section angle.
#[derive(Debug, Clone, PartialEq, Table)]
#[table(told = [modulus_mpa, poisson_ratio, thickness_mm, length_mm, width_mm, theta_deg, phi_deg, angle_deg, "layers", glue, piezo, amplifier])]
pub struct Film {
    /// Layers from the wall inwards, one of them piezoelectric.
    #[field(default = Vec::from([PIEZOELECTRIC]), group = film_layers)]
    pub layers: Vec<FilmLayer>,
    /// Extent along its first axis, mm.
    #[field(default = 5.0, within = LENGTH)]
    pub length_mm: f64,
    /// Extent across, mm.
    #[field(default = 5.0, within = LENGTH)]
    pub width_mm: f64,
    /// Wheel angle of its centre from the contact centre, degrees, positive in the rolling direction.
    #[field(default = 0.0, within = HALF_TURN)]
    pub theta_deg: f64,
    /// Section angle of its centre from the crown, degrees.
    #[field(default = 0.0, within = HALF_TURN)]
    pub phi_deg: f64,
    /// Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y.
    #[field(default = 0.0, within = HALF_TURN)]
    pub angle_deg: f64,
    /// Glue that holds the film; absent: it can't slide on the wall.
    #[field(nullable)]
    pub glue: Option<Glue>,
    /// Constants of the piezoelectric layer, which makes charge of its stress.
    pub piezo: Piezo,
    /// Circuit that the film is wired to.
    pub amplifier: Amplifier,
}

/// A layer of a film. The usual one is of PVDF, as piezoelectric films are made of.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
pub struct FilmLayer {
    /// Young's modulus, MPa.
    #[field(default = 2500.0, within = MODULUS)]
    pub modulus_mpa: f64,
    /// Poisson's ratio.
    #[field(default = 0.34, within = POISSON)]
    pub poisson_ratio: f64,
    /// Thickness, mm.
    #[field(default = 0.05, within = LENGTH)]
    pub thickness_mm: f64,
    /// Whether this is the layer that makes charge.
    pub piezo: bool,
}

/// The layer of a film of which nothing is said.
const PIEZOELECTRIC: FilmLayer = FilmLayer {
    modulus_mpa: 2500.0,
    poisson_ratio: 0.34,
    thickness_mm: 0.05,
    piezo: true,
};

/// A layer of glue between wall and film: it shears. The usual one is a soft transfer tape.
#[derive(Debug, Clone, Copy, PartialEq, Table)]
pub struct Glue {
    /// Shear modulus, MPa.
    #[field(default = 0.5, within = MODULUS)]
    pub shear_modulus_mpa: f64,
    /// Thickness, mm.
    #[field(default = 0.05, within = LENGTH)]
    pub thickness_mm: f64,
}

impl Film {
    /// A film of a single layer.
    pub fn of_layer(layer: FilmLayer) -> Self {
        Self {
            layers: vec![FilmLayer {
                piezo: true,
                ..layer
            }],
            ..Self::default()
        }
    }

    /// Thickness of all layers, mm.
    pub fn thickness_mm(&self) -> f64 {
        self.layers.iter().map(|layer| layer.thickness_mm).sum()
    }

    /// Returns the film's stiffness, and what its piezoelectric layer sees.
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

/// Writes a film as in a document.
impl Serialize for Film {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        table_value(self).serialize(serializer)
    }
}

/// Reads a film as a scene's reader does.
impl<'de> Deserialize<'de> for Film {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (value, mut faults) = (Value::deserialize(deserializer)?, Vec::new());
        Self::read(&value, "", &(), &mut faults).ok_or_else(|| {
            let details: Vec<String> = faults.iter().map(Fault::to_string).collect();
            serde::de::Error::custom(details.join("; "))
        })
    }
}

/// A list of layers, or the fields of the only one.
mod film_layers {
    use document::Map;
    use document::json_schema::{Properties, Schemas};
    use document::typed::lists::Entries;

    use super::*;

    const LIST: &str = "layers";
    const WITHIN: Entries<()> = Entries::of(
        1,
        MOST_LAYERS,
        "layers { modulus_mpa, poisson_ratio, thickness_mm, piezo }",
        (),
    );

    pub fn read_fields(
        fields: &Fields<'_>,
        _: Vec<FilmLayer>,
        faults: &mut Vec<Fault>,
    ) -> Option<Vec<FilmLayer>> {
        let Some((list, at)) = fields.get(LIST) else {
            let (own, at) = fields.some(&OF_ONE_LAYER);
            let only = FilmLayer::read(&own, &at, &(), faults)?;
            return Some(vec![FilmLayer {
                piezo: true,
                ..only
            }]);
        };
        for name in OF_ONE_LAYER
            .iter()
            .filter(|name| fields.get(name).is_some())
        {
            let detail = "is a field of a film of one layer; this one has a list of layers";
            Fault::add(faults, &fields.at(name), detail);
        }
        let layers: Vec<FilmLayer> = Vec::read(list, &at, &WITHIN, faults)?;
        let piezos = layers.iter().filter(|layer| layer.piezo).count();
        if piezos != 1 {
            let detail = format!("must have one layer with piezo = true; it has {piezos}");
            Fault::add(faults, &at, detail);
            return None;
        }
        Some(layers)
    }

    /// A film of one layer has the layer's fields as its own.
    pub fn write_fields(layers: &[FilmLayer], table: &mut Map) {
        match layers {
            [only] => {
                only.write_fields(table);
                table.shift_remove("piezo");
            }
            layers => {
                let list = layers.iter().filter_map(Field::write).collect();
                table.insert(LIST.to_owned(), list);
            }
        }
    }

    pub fn describe(_: &[FilmLayer], properties: &mut Properties, schemas: &mut Schemas) {
        let mut only = Properties::default();
        FilmLayer::describe(&mut only, schemas);
        properties.add_all(only, &["piezo"]);
        let doc = "Layers from the wall inwards, in place of the fields of one.";
        let schema = Vec::<FilmLayer>::schema(&WITHIN, schemas);
        properties.add(LIST, doc, schema, None, false);
        for name in OF_ONE_LAYER {
            properties.exclude(&[LIST, name]);
        }
    }
}

/// The film is thin, and it ends on the inner surface, between the beads.
pub(super) fn check_on(
    geometry: &Geometry,
    film: &Option<Film>,
    scene: &Fields<'_>,
    faults: &mut Vec<Fault>,
) {
    let Some(film) = film else {
        return;
    };
    let at = scene.at("film");
    let (thickness, thickest) = (film.thickness_mm(), THICKEST * geometry.wall_mm);
    if thickness > thickest {
        let at = match film.layers.len() {
            1 => member(&at, "thickness_mm"),
            _ => member(&at, "layers"),
        };
        let detail = format!(
            "must be at most {} mm thick, a tenth of the wall; it is {}",
            plain(thickest),
            plain(thickness)
        );
        Fault::add(faults, &at, detail);
    }
    let section = geometry.section_radius_mm - geometry.wall_mm;
    let centre = geometry.outer_radius_mm - geometry.section_radius_mm;
    let (phi, bead) = (
        film.phi_deg.to_radians(),
        geometry.bead_angle_deg.to_radians(),
    );
    let around = std::f64::consts::TAU * (centre + section * phi.cos());
    let [half_around, half_across] = film.half_extent_mm();
    // Along which of its sides it runs off.
    let (along, across) = match film.angle_deg.to_radians().sin().abs() < 0.5_f64.sqrt() {
        true => ("length_mm", "width_mm"),
        false => ("width_mm", "length_mm"),
    };
    if phi.abs() >= bead {
        let detail = format!(
            "must lie between the beads, which are clamped at {} degrees; it is {}",
            plain(geometry.bead_angle_deg),
            plain(film.phi_deg)
        );
        Fault::add(faults, &member(&at, "phi_deg"), detail);
    } else if half_across > section * (bead - phi.abs()) {
        let detail = format!(
            "the film runs onto the bead: its middle leaves {} mm on each side along the section; it takes {}",
            plain(section * (bead - phi.abs())),
            plain(half_across)
        );
        Fault::add(faults, &member(&at, across), detail);
    }
    if 2.0 * half_around > around {
        let detail = format!(
            "must be at most {} mm, the inner circumference there; it takes {}",
            plain(around),
            plain(2.0 * half_around)
        );
        Fault::add(faults, &member(&at, along), detail);
    }
}
