//! Models with known indices, and their reference values.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};

use gsa::design::Design;
use gsa::law::catalogue::Kind;
use gsa::law::distribution::Distribution;
use ndarray::Array2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use serde_json::Value;

/// First-order and total indices.
#[derive(Debug, Clone)]
pub struct Indices {
    pub first_order: Vec<f64>,
    pub total: Vec<f64>,
}

/// M-DRM in extended precision, for one cut point and rule size.
#[derive(Debug, Clone)]
pub struct Reference {
    pub cut: String,
    pub nodes: usize,
    pub status: String,
    pub indices: Option<Indices>,
    pub mean: Option<f64>,
    pub variance: Option<f64>,
}

/// A closed model.
#[derive(Debug, Clone)]
pub struct Model {
    pub name: String,
    pub inputs: Vec<Distribution>,
    pub exact: Indices,
    pub references: Vec<Reference>,
    /// Points with their value, which check the formula itself.
    pub values: Vec<(Vec<f64>, f64)>,
}

impl Model {
    pub fn design(&self, cut: &str, nodes: usize, check_points: usize, seed: u64) -> Design {
        let cut: Vec<f64> = match cut {
            "mean" => self.inputs.iter().map(Distribution::mean).collect(),
            "ones" => vec![1.0; self.inputs.len()],
            "half_pi" => vec![FRAC_PI_2; self.inputs.len()],
            "quarter" => vec![0.25; self.inputs.len()],
            other => panic!("unknown cut {other}"),
        };
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        Design::with_cut(&self.inputs, nodes, &cut, check_points, &mut rng)
            .expect("the model has a design")
    }

    /// The model's values at the design's points, one output.
    pub fn run(&self, design: &Design) -> Array2<f64> {
        let values = design
            .points()
            .iter()
            .map(|x| value(&self.name, x))
            .collect();
        Array2::from_shape_vec((design.points().len(), 1), values).expect("one value per point")
    }
}

/// All models of the data file.
pub fn all() -> Vec<Model> {
    let document: Value =
        serde_json::from_str(include_str!("../../data/mdrm.json")).expect("valid JSON");
    list(&document["models"]).iter().map(model).collect()
}

fn model(entry: &Value) -> Model {
    let mut references = Vec::new();
    for (cut, sizes) in entry["cuts"].as_object().expect("cuts by name") {
        let sizes: BTreeMap<usize, &Value> = sizes
            .as_object()
            .expect("references by rule size")
            .iter()
            .map(|(nodes, reference)| (nodes.parse().expect("a size"), reference))
            .collect();
        for (nodes, reference) in sizes {
            references.push(Reference {
                cut: cut.clone(),
                nodes,
                status: text(&reference["status"]),
                indices: reference.get("first_order").map(|_| indices(reference)),
                mean: reference["mean"].as_f64(),
                variance: reference["variance"].as_f64(),
            });
        }
    }
    Model {
        name: text(&entry["name"]),
        inputs: list(&entry["inputs"]).iter().map(law).collect(),
        exact: indices(&entry["exact"]),
        references,
        values: list(&entry["values"])
            .iter()
            .map(|point| (numbers(&point["x"]), number(&point["y"])))
            .collect(),
    }
}

/// A kind, its parameters, and the two bounds of a truncated law as a list behind them.
fn law(entry: &Value) -> Distribution {
    let kind = Kind::named(&text(&entry[0])).expect("a known kind");
    let (bounds, parameters): (Vec<&Value>, Vec<&Value>) =
        list(entry)[1..].iter().partition(|value| value.is_array());
    let parameters: Vec<f64> = parameters.into_iter().map(number).collect();
    let law = kind.distribution(&parameters).expect("a valid law");
    match bounds.first().map(|bounds| numbers(bounds)).as_deref() {
        Some(&[low, high]) => law.truncated(low, high).expect("a valid truncation"),
        _ => law,
    }
}

fn indices(entry: &Value) -> Indices {
    Indices {
        first_order: numbers(&entry["first_order"]),
        total: numbers(&entry["total"]),
    }
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

fn text(value: &Value) -> String {
    value.as_str().expect("a string").to_owned()
}

/// The formula of a model.
pub fn value(name: &str, x: &[f64]) -> f64 {
    match name {
        "ishigami" => x[0].sin() * (1.0 + 0.1 * x[2].powi(4)) + 7.0 * x[1].sin().powi(2),
        "sobol_g_a" => sobol_g(x, &[0.0, 1.0, 4.5, 9.0, 99.0, 99.0, 99.0, 99.0]),
        "sobol_g_c" => sobol_g(x, &[0.5, 1.0, 2.0, 5.0, 10.0]),
        "product_5_lognormal" | "product_5_uniform" | "product_zero_means" => x.iter().product(),
        "additive_linear_normal" => {
            10.0 + x
                .iter()
                .zip(1..)
                .map(|(x, k)| x * f64::from(k))
                .sum::<f64>()
        }
        "borehole_normal_lognormal" | "borehole_uniform" => borehole(x),
        "piston" => piston(x),
        "flood_height" => (x[0] / (x[5] * x[1] * ((x[3] - x[2]) / x[4]).sqrt())).powf(0.6),
        "poly_sign_change" => x[0] + x[1] + x[2] + x[0] * x[1] * x[2],
        "h0_zero_rho_nonzero" => x.iter().map(|x| x * x).sum(),
        "nearly_constant_1e-14" => x
            .iter()
            .zip(1..)
            .map(|(x, k)| 1.0 + 1e-8 * f64::from(k) * x)
            .product(),
        "scale_huge_1e150" => 1e150 * four_factors(x),
        "scale_tiny_1e-150" => 1e-150 * four_factors(x),
        "product_50" => x
            .iter()
            .zip(1..)
            .map(|(x, k)| 1.0 + (x - 0.5) / f64::from(k))
            .product(),
        "shifted_product_plus" => {
            let slopes = [0.5, 0.3, 0.6, 0.2, 0.7];
            10.0 + x
                .iter()
                .zip(slopes)
                .map(|(x, a)| 1.0 + a * x)
                .product::<f64>()
        }
        other => panic!("unknown model {other}"),
    }
}

fn sobol_g(x: &[f64], a: &[f64]) -> f64 {
    x.iter()
        .zip(a)
        .map(|(x, a)| ((4.0 * x - 2.0).abs() + a) / (1.0 + a))
        .product()
}

fn four_factors(x: &[f64]) -> f64 {
    x[0] * (0.3 * x[1]).exp() * (1.0 + x[2] * x[2]) * (2.0 + x[3].sin())
}

/// Flow through a borehole between two aquifers.
fn borehole(x: &[f64]) -> f64 {
    let log_radii = (x[1] / x[0]).ln();
    let leakage = 2.0 * x[6] * x[2] / (log_radii * x[0] * x[0] * x[7]);
    2.0 * PI * x[2] * (x[3] - x[5]) / (log_radii * (1.0 + leakage + x[2] / x[4]))
}

/// Cycle time of a piston in a cylinder.
fn piston(x: &[f64]) -> f64 {
    let [mass, area, volume, stiffness, pressure, ambient, gas] = x else {
        panic!("the piston has seven inputs")
    };
    let force = pressure * area + 19.62 * mass - stiffness * volume / area;
    let root = (force * force + 4.0 * stiffness * pressure * volume / gas * ambient).sqrt();
    let gas_volume = area / (2.0 * stiffness) * (root - force);
    let gas_stiffness = area * area * pressure * volume * ambient / (gas * gas_volume * gas_volume);
    2.0 * PI * (mass / (stiffness + gas_stiffness)).sqrt()
}
