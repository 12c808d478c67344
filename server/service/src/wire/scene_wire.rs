//! Answer of a scene that was solved once, for whoever reads it: HTTP and `strainsite solve --json`.

use fem_client::scene::Scene;
use fem_client::solver::{Response, Solved};
use serde::Serialize;
use serde_json::{Map, Value};
use store::StoreError;
use store::content::encode;
use utoipa::ToSchema;

/// A scene and what is read of it: its schema is that of the document.
#[derive(Debug, ToSchema)]
pub struct SceneQuestionDocument;

/// Equilibrium of a scene.
///
/// Strains are stretches relative to the inflated state minus one, on the inner surface; x circumferential, y meridional.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct SolvedScene {
    /// Status: `converged`.
    pub status: String,
    /// The equilibrium.
    #[serde(flatten)]
    #[schema(value_type = Response)]
    pub response: Map<String, Value>,
    /// Time of the solve, s.
    pub wall_s: f64,
    /// Values that are unlikely in the scene or at its film's amplifier, whole sentences.
    pub unlikely: Vec<String>,
}

/// Parts of a response that a single scene isn't asked for.
const NOT_ASKED: [&str; 2] = ["map", "rings"];

impl SolvedScene {
    /// The answer of a solved scene.
    ///
    /// # Errors
    /// [`StoreError::NotFinite`].
    pub fn of(scene: &Scene, solved: &Solved) -> Result<Self, StoreError> {
        let what = "the response";
        let text = encode(what, &solved.response)?;
        let mut response: Map<String, Value> =
            serde_json::from_str(&text).map_err(|_| StoreError::NotFinite { what })?;
        response.retain(|name, _| !NOT_ASKED.contains(&name.as_str()));
        Ok(Self {
            status: "converged".to_owned(),
            response,
            wall_s: solved.cost.wall_s,
            unlikely: unlikely(scene, &solved.response),
        })
    }
}

/// Returns what is unlikely in a scene, and in what its film's amplifier would show.
fn unlikely(scene: &Scene, response: &Response) -> Vec<String> {
    let values = scene.slips().into_iter().map(|slip| slip.to_string());
    let films = scene.film.iter().zip(&response.film);
    let outputs =
        films.filter_map(|(film, found)| film.amplifier.unlikely_output(found.signal.output_v));
    let outputs = outputs.map(|output| format!("film.amplifier: {output}"));
    values.chain(outputs).collect()
}
