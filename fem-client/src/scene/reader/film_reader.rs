//! Reads the film.

use serde::{Deserialize, Deserializer};
use serde_json::Value;

use super::circuit_reader::{circuit_fields, named_circuit, read_circuit};
use super::inner_table::section;
use super::shared_ranges::{LENGTH, MODULUS};
use crate::document::fault::{Fault, entry, member};
use crate::document::fields::{Fields, Number, Range, plain, shown};
use crate::film::amplifier::Amplifier;
use crate::film::piezo::Piezo;
use crate::scene::{Film, FilmLayer, Geometry, Glue};

const POISSON: Range = Range::new(0.0, 0.5, "");
/// Poled films charge either way round.
const CHARGE_PER_FORCE: Range = Range::new(-1e4, 1e4, "pC/N");
const CHARGE_PER_WARMING: Range = Range::new(-1e4, 1e4, "uC/(m2 K)");
const PERMITTIVITY: Range = Range::new(1.0, 1e6, "pF/m");
const FREQUENCY: Range = Range::new(1e-6, 1e6, "Hz");
const NOISE: Range = Range::new(0.0, 1e9, "mV");
const GAIN: Range = Range::new(0.0, 1.0, "");
const WARMING: Range = Range::new(0.0, 1e3, "K");
const HALF_TURN: Range = Range::new(-180.0, 180.0, "degrees");
/// Thickest film, in walls: it has no thickness in the model.
const THICKEST: f64 = 0.1;
const MOST_LAYERS: usize = 8;

/// Fields of a film of one layer, which stand in place of a list.
pub(crate) const OF_ONE_LAYER: [&str; 3] = ["modulus_mpa", "poisson_ratio", "thickness_mm"];

pub(crate) fn film(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Film> {
    let mut film = Film::default();
    let numbers = [
        ("length_mm", LENGTH, &mut film.length_mm),
        ("width_mm", LENGTH, &mut film.width_mm),
        ("theta_deg", HALF_TURN, &mut film.theta_deg),
        ("phi_deg", HALF_TURN, &mut film.phi_deg),
        ("angle_deg", HALF_TURN, &mut film.angle_deg),
    ];
    let known = [
        &OF_ONE_LAYER,
        &numbers.each_ref().map(|number| number.0)[..],
        &["layers", "glue", "piezo", "amplifier"],
    ]
    .concat();
    let fields = Fields::open(value, pointer, &known, faults)?;
    let read = fields.numbers(numbers, faults);
    let layers = layers(&fields, faults);
    let glue = match fields.get("glue") {
        None | Some((Value::Null, _)) => Some(None),
        Some((value, pointer)) => glue(value, &pointer, faults).map(Some),
    };
    let piezo = section(&fields, "piezo", faults, piezo);
    let amplifier = section(&fields, "amplifier", faults, amplifier);
    read?;
    (film.layers, film.glue) = (layers?, glue?);
    (film.piezo, film.amplifier) = (piezo?, amplifier?);
    Some(film)
}

/// As a scene's reader reads it.
impl<'de> Deserialize<'de> for Film {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (value, mut faults) = (Value::deserialize(deserializer)?, Vec::new());
        film(&value, "", &mut faults).ok_or_else(|| {
            let details = faults.iter().map(|fault| fault.to_string());
            serde::de::Error::custom(details.collect::<Vec<_>>().join("; "))
        })
    }
}

/// The layers of a list, or the one whose fields are the film's own.
fn layers(fields: &Fields<'_>, faults: &mut Vec<Fault>) -> Option<Vec<FilmLayer>> {
    let Some((list, pointer)) = fields.get("layers") else {
        let mut layer = FilmLayer::default();
        fields.numbers(layer_numbers(&mut layer), faults)?;
        return Some(vec![layer]);
    };
    for name in OF_ONE_LAYER
        .iter()
        .filter(|name| fields.get(name).is_some())
    {
        let detail = "is a field of a film of one layer; this one has a list of layers";
        Fault::add(faults, &fields.at(name), detail.to_owned());
    }
    let items = list.as_array().map_or(&[] as &[Value], Vec::as_slice);
    if items.is_empty() || items.len() > MOST_LAYERS {
        let detail = format!(
            "must be a list of 1 to {MOST_LAYERS} layers {{ modulus_mpa, poisson_ratio, thickness_mm, piezo }}; it is {}",
            shown(list)
        );
        Fault::add(faults, &pointer, detail);
        return None;
    }
    let read = |(i, item)| layer(item, &entry(&pointer, i), faults);
    // Every layer is read, so that every fault is found.
    let layers: Vec<Option<FilmLayer>> = items.iter().enumerate().map(read).collect();
    let layers = layers.into_iter().collect::<Option<Vec<_>>>()?;
    let piezos = layers.iter().filter(|layer| layer.piezo).count();
    if piezos != 1 {
        let detail = format!("must have one layer with piezo = true; it has {piezos}");
        Fault::add(faults, &pointer, detail);
        return None;
    }
    Some(layers)
}

fn layer_numbers(layer: &mut FilmLayer) -> [Number<'_>; 3] {
    [
        ("modulus_mpa", MODULUS, &mut layer.modulus_mpa),
        ("poisson_ratio", POISSON, &mut layer.poisson_ratio),
        ("thickness_mm", LENGTH, &mut layer.thickness_mm),
    ]
}

fn layer(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<FilmLayer> {
    let mut layer = FilmLayer::default();
    let fields = Fields::open(
        value,
        pointer,
        &[&OF_ONE_LAYER[..], &["piezo"]].concat(),
        faults,
    )?;
    let numbers = fields.numbers(layer_numbers(&mut layer), faults);
    let piezo = match fields.get("piezo") {
        None => Some(false),
        Some((Value::Bool(piezo), _)) => Some(*piezo),
        Some((other, pointer)) => {
            let detail = format!("must be true or false; it is {}", shown(other));
            Fault::add(faults, &pointer, detail);
            None
        }
    };
    numbers?;
    layer.piezo = piezo?;
    Some(layer)
}

fn glue(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Glue> {
    let mut glue = Glue::default();
    let numbers = [
        ("shear_modulus_mpa", MODULUS, &mut glue.shear_modulus_mpa),
        ("thickness_mm", LENGTH, &mut glue.thickness_mm),
    ];
    Fields::of_numbers(value, pointer, &[], numbers, faults)?;
    Some(glue)
}

fn piezo(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Piezo> {
    let mut piezo = Piezo::default();
    let numbers = [
        ("d31_pc_per_n", CHARGE_PER_FORCE, &mut piezo.d31_pc_per_n),
        ("d32_pc_per_n", CHARGE_PER_FORCE, &mut piezo.d32_pc_per_n),
        ("d33_pc_per_n", CHARGE_PER_FORCE, &mut piezo.d33_pc_per_n),
        (
            "pyro_uc_per_m2_k",
            CHARGE_PER_WARMING,
            &mut piezo.pyro_uc_per_m2_k,
        ),
        (
            "permittivity_pf_per_m",
            PERMITTIVITY,
            &mut piezo.permittivity_pf_per_m,
        ),
        ("yield_mpa", MODULUS, &mut piezo.yield_mpa),
    ];
    Fields::of_numbers(value, pointer, &[], numbers, faults)?;
    Some(piezo)
}

fn amplifier(value: &Value, pointer: &str, faults: &mut Vec<Fault>) -> Option<Amplifier> {
    let mut amplifier = Amplifier::default();
    let circuit = named_circuit(value, amplifier.circuit);
    let known = [
        circuit_fields(circuit),
        &["press_hz", "noise_mv", "gain_std", "temperature_k"],
    ]
    .concat();
    let fields = Fields::open(value, pointer, &known, faults)?;
    let press = fields.numbers(
        [
            ("press_hz", FREQUENCY, &mut amplifier.press_hz),
            ("noise_mv", NOISE, &mut amplifier.noise_mv),
            ("gain_std", GAIN, &mut amplifier.gain_std),
            ("temperature_k", WARMING, &mut amplifier.temperature_k),
        ],
        faults,
    );
    let circuit = read_circuit(&fields, circuit, faults);
    press?;
    amplifier.circuit = circuit?;
    Some(amplifier)
}

/// The film is thin, and it ends on the inner surface, between the beads.
pub(super) fn check_film_on(
    geometry: &Geometry,
    film: &Film,
    pointer: &str,
    faults: &mut Vec<Fault>,
) {
    let (thickness, thickest) = (film.thickness_mm(), THICKEST * geometry.wall_mm);
    if thickness > thickest {
        let at = match film.layers.len() {
            1 => member(pointer, "thickness_mm"),
            _ => member(pointer, "layers"),
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
        Fault::add(faults, &member(pointer, "phi_deg"), detail);
    } else if half_across > section * (bead - phi.abs()) {
        let detail = format!(
            "the film runs onto the bead: its middle leaves {} mm on each side along the section; it takes {}",
            plain(section * (bead - phi.abs())),
            plain(half_across)
        );
        Fault::add(faults, &member(pointer, across), detail);
    }
    if 2.0 * half_around > around {
        let detail = format!(
            "must be at most {} mm, the inner circumference there; it takes {}",
            plain(around),
            plain(2.0 * half_around)
        );
        Fault::add(faults, &member(pointer, along), detail);
    }
}

#[cfg(test)]
mod tests {
    use crate::film::amplifier::Circuit;
    use crate::scene::{Film, Scene};

    #[test]
    fn an_empty_film_table_is_the_default_film_and_none_is_no_film() {
        let read = |text| Scene::from_toml(text).expect("reads").film;
        assert_eq!(read("[film]"), Some(Film::default()));
        assert_eq!(read(""), None);
    }

    #[test]
    fn a_film_s_tables_have_defaults_of_their_kind_and_every_fault_has_its_place() {
        let film = |text: &str| Scene::from_toml(text).map(|scene| scene.film.expect("a film"));
        let charge = film("[film.amplifier]\nkind = \"charge\"\nfeedback_nf = 2").expect("reads");
        let expected = Circuit::Charge {
            feedback_nf: 2.0,
            feedback_mohm: 1000.0,
        };
        assert_eq!(charge.amplifier.circuit, expected);
        let scene = Scene {
            film: Some(charge),
            ..Scene::default()
        };
        assert_eq!(Scene::from_json(&scene.canonical_json()), Ok(scene));
        let pointers = |text: &str| -> Vec<String> {
            let faults = film(text).expect_err(text);
            faults.into_iter().map(|fault| fault.pointer).collect()
        };
        assert_eq!(
            pointers(
                "[film]\nmodulus_mpa = 0\n[film.piezo]\nd31_pc_per_n = nan\npermittivity_pf_per_m = -1\n[film.amplifier]\nkind = \"voltage\"\ncable_pf = -1\nfeedback_nf = 1"
            ),
            [
                "/film/modulus_mpa",
                "/film/piezo/d31_pc_per_n",
                "/film/piezo/permittivity_pf_per_m",
                "/film/amplifier/feedback_nf",
                "/film/amplifier/cable_pf"
            ]
        );
        assert_eq!(
            pointers("[film.amplifier]\nkind = \"tube\""),
            ["/film/amplifier/kind"]
        );
        assert_eq!(pointers("[film]\npiezo = 3"), ["/film/piezo"]);
    }

    fn pointers(text: &str) -> Vec<String> {
        let faults = Scene::from_toml(text).expect_err(text);
        faults.into_iter().map(|fault| fault.pointer).collect()
    }

    #[test]
    fn a_film_fits_on_the_inner_surface_and_is_thin() {
        assert_eq!(
            pointers("[film]\nthickness_mm = 0.31\nlength_mm = 296\nwidth_mm = 40"),
            ["/film/thickness_mm", "/film/width_mm", "/film/length_mm"]
        );
        assert_eq!(
            pointers("[film]\nmodulus_mpa = 0\npoisson_ratio = 0.6\nangle = 1"),
            ["/film/angle", "/film/modulus_mpa", "/film/poisson_ratio"]
        );
        // 2 mm of 9.5 mm radius are left to the bead: 12 degrees.
        assert_eq!(pointers("[film]\nphi_deg = 108"), ["/film/width_mm"]);
        assert_eq!(
            pointers("[film]\nphi_deg = -108\nangle_deg = 90\nwidth_mm = 3"),
            ["/film/length_mm"]
        );
        assert_eq!(pointers("[film]\nphi_deg = 120"), ["/film/phi_deg"]);
        assert_eq!(
            pointers("[film]\ntheta_deg = 181\nphi_deg = nan\nangle_deg = \"x\""),
            ["/film/theta_deg", "/film/phi_deg", "/film/angle_deg"]
        );
        assert!(Scene::from_toml("[film]\nphi_deg = 108\nwidth_mm = 3").is_ok());
    }

    #[test]
    fn layers_are_a_list_with_one_that_makes_charge() {
        let of = |layers: &str| format!("[film]\nlayers = [{layers}]");
        let polyester = "{ modulus_mpa = 3500, thickness_mm = 0.125 }";
        let pvdf = "{ thickness_mm = 0.028, piezo = true }";
        let scene = Scene::from_toml(&of(&format!("{polyester}, {pvdf}"))).expect("reads");
        let film = scene.film.clone().expect("a film");
        assert_eq!((film.thickness_mm(), film.layers[1].piezo), (0.153, true));
        assert_eq!(Scene::from_json(&scene.canonical_json()), Ok(scene));
        // A list of one is the film of one layer.
        assert_eq!(
            Scene::from_toml(&of(pvdf)),
            Scene::from_toml("[film]\nthickness_mm = 0.028")
        );
        for (bad, at) in [
            (of(polyester), "/film/layers"),
            (of(&format!("{pvdf}, {pvdf}")), "/film/layers"),
            (of(""), "/film/layers"),
            (of("{ piezo = 1 }"), "/film/layers/0/piezo"),
            (
                of("{ piezo = true, thickness_mm = -1 }"),
                "/film/layers/0/thickness_mm",
            ),
            (of("3"), "/film/layers/0"),
            (of(pvdf) + "\nmodulus_mpa = 100", "/film/modulus_mpa"),
            ("[film]\nlayers = 3".to_owned(), "/film/layers"),
            (
                "[film.glue]\nthickness_mm = 0".to_owned(),
                "/film/glue/thickness_mm",
            ),
            (
                of("{ piezo = true, thickness_mm = 0.4 }"),
                "/film/thickness_mm",
            ),
        ] {
            assert_eq!(pointers(&bad), [at], "{bad}");
        }
    }
}
