//! A scene with a number a little less and a little more, and the derivative of its response from there.

use serde_json::{Map, Number, Value, json};

use crate::scene::Scene;
use crate::solver::derivative::Derivative;
use crate::solver::response::Response;
use crate::solver::solve_error::SolveError;
use document::fault::{Fault, entry};

/// Step to either side, relative to the number, or in its own unit where that is 0. Rounding leaves 1e-9 of a derivative, the step's square 1e-10; with a longer step more
/// contact points would open or close between the two sides.
const STEP: f64 = 1e-5;

/// Fields of a response that don't follow from its equilibrium alone, or say where something is read.
const NOT_DERIVED: [&str; 9] = [
    "angle_deg",
    "derivatives",
    "error",
    "max_volume_change",
    "model",
    "phi_deg",
    "residual_history",
    "section_deg",
    "theta_deg",
];

/// A scene with one number a little less and a little more.
#[derive(Debug, Clone, PartialEq)]
pub struct Sides {
    /// Path of the number.
    pub by: String,
    /// The scenes, the lesser number first.
    pub scenes: [Scene; 2],
    /// Half of the difference between the numbers.
    pub half_step: f64,
}

/// Difference quotient of all numbers that aren't counts; what names them stays. `None` where nothing is left.
fn difference(low: &Value, high: &Value, step: f64) -> Option<Value> {
    match (low, high) {
        (Value::Number(low), Value::Number(high)) if low.is_f64() && high.is_f64() => {
            let quotient = (high.as_f64()? - low.as_f64()?) / step;
            Number::from_f64(quotient).map(Value::Number)
        }
        (Value::Array(low), Value::Array(high)) if !low.is_empty() && low.len() == high.len() => {
            let pairs = low.iter().zip(high);
            let entries = pairs.map(|(low, high)| difference(low, high, step));
            entries.collect::<Option<Vec<_>>>().map(Value::Array)
        }
        (Value::Object(low), Value::Object(high)) => {
            let derived = low
                .iter()
                .filter(|(name, _)| !NOT_DERIVED.contains(&name.as_str()));
            let fields: Map<String, Value> = derived
                .filter_map(|(name, low)| {
                    Some((name.clone(), difference(low, high.get(name)?, step)?))
                })
                .collect();
            let numbers = fields.values().any(|value| !value.is_string());
            numbers.then_some(Value::Object(fields))
        }
        (Value::String(low), Value::String(high)) if low == high => Some(json!(low)),
        _ => None,
    }
}

impl Sides {
    /// Derivative from the responses of the two scenes.
    pub fn derivative(&self, responses: [&Response; 2]) -> Derivative {
        let [low, high] = responses.map(|response| json!(response));
        let of = match difference(&low, &high, 2.0 * self.half_step) {
            Some(Value::Object(of)) => of,
            _ => Map::new(),
        };
        Derivative {
            by: self.by.clone(),
            of,
        }
    }

    /// Changes one number of a scene both ways.
    ///
    /// # Errors
    /// Why there is no derivative by it: no such number, or none that can be a little less and a little more.
    pub fn of(scene: &Scene, by: &str) -> Result<Self, String> {
        let value = scene.number_at(by).map_err(|fault| fault.detail)?;
        let step = match value == 0.0 {
            true => STEP,
            false => STEP * value.abs(),
        };
        let values = [value - step, value + step];
        let [low, high] = values.map(|value| {
            let mut side = scene.clone();
            side.set(by, &json!(value)).map(|()| side)
        });
        match (low, high) {
            (Ok(low), Ok(high)) => Ok(Self {
                by: by.to_owned(),
                scenes: [low, high],
                half_step: 0.5 * (values[1] - values[0]),
            }),
            (Err(fault), _) | (_, Err(fault)) => Err(format!(
                "there is no derivative by {by} at {value}, which can't be a little less and a little more: it {}",
                fault.detail
            )),
        }
    }
}

/// The error of a solve without a derivative by one of the paths asked for.
pub fn refused(path: usize, detail: String) -> SolveError {
    SolveError::Refused {
        faults: vec![fault(path, detail)],
    }
}

fn fault(path: usize, detail: String) -> Fault {
    Fault {
        pointer: entry("/derivatives", path),
        detail,
    }
}

/// Every path by which a scene's response has no derivative, and a scene that has none by anything.
pub fn faults(paths: &[String], scene: &Scene) -> Vec<Fault> {
    let sides = paths.iter().enumerate();
    let unknown = sides.filter_map(|(i, by)| Some(fault(i, Sides::of(scene, by).err()?)));
    let mut faults: Vec<Fault> = unknown.collect();
    if !paths.is_empty() && scene.contact.friction > 0.0 {
        let detail = "has no derivatives with friction, because the equilibrium depends on the way there: set contact.friction to 0, or difference two solves";
        Fault::add(&mut faults, "/contact/friction", detail.to_owned());
    }
    faults
}

/// The fault of asking a solver for derivatives that has none.
pub fn none_of(paths: &[String]) -> Vec<Fault> {
    let fault = |_: &String| Fault {
        pointer: "/derivatives".to_owned(),
        detail: "aren't what this solver knows: leave them out, or use the embedded one".to_owned(),
    };
    paths.first().map(fault).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_differenced_and_names_stay() {
        let low = json!({"reaction_n": 1.0, "newton_iterations": 3, "residual_history": [[1.0], [0.5, 0.1]],
            "locations": [{"name": "P1", "theta_deg": 5.0, "strain_x": 0.25, "error": {"strain_x": 1.0}}],
            "gauges": [{"theta_deg": 0.0, "phi_deg": 5.0, "angle_deg": 90.0, "strain": 0.5}]});
        let high = json!({"reaction_n": 2.0, "newton_iterations": 4, "residual_history": [[1.0]],
            "locations": [{"name": "P1", "theta_deg": 5.5, "strain_x": 0.5, "error": {"strain_x": 2.0}}],
            "gauges": [{"theta_deg": 0.0, "phi_deg": 5.0, "angle_deg": 90.0, "strain": 1.0}]});
        let expected = json!({"reaction_n": 2.0, "locations": [{"name": "P1", "strain_x": 0.5}],
            "gauges": [{"strain": 1.0}]});
        assert_eq!(difference(&low, &high, 0.5), Some(expected));
    }

    #[test]
    fn a_number_is_changed_both_ways() {
        let scene = Scene::default();
        let sides = Sides::of(&scene, "ground.depths_mm[2]").expect("a depth");
        let depth = scene.ground.depths_mm[2];
        assert!((sides.half_step / (STEP * depth) - 1.0).abs() < 1e-9);
        let [low, high] = &sides.scenes;
        assert!(low.ground.depths_mm[2] < depth && depth < high.ground.depths_mm[2]);
        assert_eq!(low.ground.depths_mm[1], high.ground.depths_mm[1]);
    }

    #[test]
    fn every_path_without_a_derivative_is_a_fault() {
        let mut scene = Scene::default();
        scene.ground.depths_mm[0] = 0.0;
        scene.contact.friction = 0.5;
        let paths = [
            "ground.depths_mm[0]",
            "ground.stations",
            "no.such",
            "geometry.wall_mm",
        ];
        let found = faults(&paths.map(str::to_owned), &scene);
        let pointers: Vec<&str> = found.iter().map(|fault| fault.pointer.as_str()).collect();
        assert_eq!(
            pointers,
            [
                "/derivatives/0",
                "/derivatives/1",
                "/derivatives/2",
                "/contact/friction"
            ]
        );
        assert!(
            found[0].detail.contains("a little less"),
            "{}",
            found[0].detail
        );
        assert_eq!(faults(&[], &scene), []);
    }
}
