//! The map at the solved nodes of one input's line: what a slider over the input shows, without a solve.

use document::Format;
use documents::study::Study;
use documents::study::plan::scene_at;
use fem_client::scene::edit::number_in;
use fem_client::scene::{Level, Scene};
use fem_client::solver::{MapShape, Response};
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use sqlx::SqliteConnection;
use utoipa::ToSchema;

use crate::study_document::stored_study;
use store::StoreError;
use store::points::evaluations;
use store::queue::study_rows::StudyRow;

/// Strains and displacements over the map along the line of one input; all others are at their means.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Sections {
    /// Name of the input.
    pub input: String,
    /// Path of the scene's field.
    pub vary: String,
    /// Angles of the columns from the contact centre, degrees.
    pub theta_deg: Vec<f64>,
    /// Angles of the rows from the crown, degrees.
    pub phi_deg: Vec<f64>,
    /// Places of the map's points in the inflated state at the means, mm, rows x columns.
    pub inflated_mm: Vec<[f64; 3]>,
    /// The solved nodes, by value. A design of scattered points has the means alone.
    pub nodes: Vec<SectionNode>,
    /// Nodes that have no equilibrium, by value.
    pub failed: Vec<FailedNode>,
}

/// A solved node.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct SectionNode {
    /// Value of the input.
    pub value: f64,
    /// Place among the study's points.
    pub ordinal: usize,
    /// Whether it is the cut point, where the input is at its mean, too.
    pub cut_point: bool,
    /// Vertical force, N.
    pub reaction_n: f64,
    /// Circumferential strain, rows x columns.
    pub strain_x: Vec<f64>,
    /// Meridional strain, rows x columns.
    pub strain_y: Vec<f64>,
    /// Displacements from `inflated_mm` to the node's equilibrium, mm, rows x columns: also where the input changes the inflated state.
    pub displacement_mm: Vec<[f64; 3]>,
}

/// A node without an equilibrium.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct FailedNode {
    /// Value of the input.
    pub value: f64,
    /// Reason, a sentence.
    pub reason: String,
}

/// Part of a result that says where the sections lie.
#[derive(Debug, Deserialize)]
pub struct Sectioned {
    model: Meshed,
    cut_point: Means,
    map: Option<Places>,
}

#[derive(Debug, Deserialize)]
struct Meshed {
    level: String,
}

#[derive(Debug, Deserialize)]
struct Means {
    values: Vec<f64>,
}

#[derive(Debug, Deserialize)]
struct Places {
    theta_deg: Vec<f64>,
    phi_deg: Vec<f64>,
    shape: MapShape,
}

/// Reason why there are no sections.
#[derive(Debug, thiserror::Error)]
pub enum SectionsError {
    /// The study has no map.
    #[error("this study has no map: its document asks for no candidates.grid")]
    NoMap,
    /// No input has this name.
    #[error("input is one of {}", .names.join(", "))]
    NoInput {
        /// Names of the inputs that there are.
        names: Vec<String>,
    },
    /// A document that this version can't read.
    #[error("{cause}")]
    Unreadable {
        /// A sentence.
        cause: String,
    },
    /// The database failed.
    #[error(transparent)]
    Store(#[from] StoreError),
}

/// The sections along the line of the input of this name; of the first one without a name.
///
/// # Errors
/// See [`SectionsError`].
pub async fn of(
    connection: &mut SqliteConnection,
    row: &StudyRow,
    found: Sectioned,
    input: Option<&str>,
) -> Result<Sections, SectionsError> {
    let places = found.map.ok_or(SectionsError::NoMap)?;
    let mut study = stored_study(row).map_err(|cause| SectionsError::Unreadable { cause })?;
    study.scene.model.level = Level::named(&found.model.level).unwrap_or(study.level);
    let line = Line::of(&study, found.cut_point.values, input)?;
    let mut sections = Sections {
        input: study.inputs[line.index].name.clone(),
        vary: study.inputs[line.index].vary.clone(),
        theta_deg: places.theta_deg,
        phi_deg: places.phi_deg,
        inflated_mm: places.shape.inflated_mm,
        nodes: Vec::new(),
        failed: Vec::new(),
    };
    let points = line.points(connection, &row.id).await?;
    let keys: Vec<String> = points.iter().map(|point| point.key.clone()).collect();
    let evaluations = evaluations::find(connection, &keys).await?;
    for (point, evaluation) in points.into_iter().zip(evaluations) {
        match evaluation.map(|evaluation| evaluation.outcome) {
            Some(Ok(response)) => {
                let node = node(&point, line.mean(), response, &sections.inflated_mm);
                sections.nodes.extend(node);
            }
            Some(Err(unsolved)) => sections.failed.push(FailedNode {
                value: point.value,
                reason: unsolved.to_string(),
            }),
            None => {}
        }
    }
    // Whoever else solved a scene on the line may have read it without the map, or again.
    sections.nodes.sort_by(|a, b| a.value.total_cmp(&b.value));
    sections
        .nodes
        .dedup_by(|later, first| later.value == first.value);
    sections.failed.sort_by(|a, b| a.value.total_cmp(&b.value));
    sections
        .failed
        .dedup_by(|later, first| later.value == first.value);
    Ok(sections)
}

/// The points at which all inputs but one are at their means.
struct Line<'s> {
    study: &'s Study,
    means: Vec<f64>,
    index: usize,
}

/// A stored point on a line.
struct LinePoint {
    ordinal: usize,
    key: String,
    value: f64,
}

impl<'s> Line<'s> {
    fn of(study: &'s Study, means: Vec<f64>, name: Option<&str>) -> Result<Self, SectionsError> {
        let is_asked = |input: &documents::study::Input| name.is_none_or(|name| input.name == name);
        let index = study.inputs.iter().position(is_asked);
        let index = index.filter(|_| means.len() == study.inputs.len());
        let names = || {
            study
                .inputs
                .iter()
                .map(|input| input.name.clone())
                .collect()
        };
        Ok(Self {
            index: index.ok_or_else(|| SectionsError::NoInput { names: names() })?,
            study,
            means,
        })
    }

    fn mean(&self) -> f64 {
        self.means[self.index]
    }

    /// Reads the points of a study, in the order of its plan.
    async fn points(
        &self,
        connection: &mut SqliteConnection,
        id: &str,
    ) -> Result<Vec<LinePoint>, StoreError> {
        let parts = evaluations::parts_of::<IgnoredAny>(connection, id).await?;
        let point = |(ordinal, key, evaluation): (usize, String, evaluations::Evaluation<_>)| {
            let value = self.value_of(&evaluation.scene)?;
            Some(LinePoint {
                ordinal,
                key,
                value,
            })
        };
        Ok(parts.into_iter().filter_map(point).collect())
    }

    /// The input's value in a stored scene; `None` where that isn't on the line: another mesh's, or what else a study solves.
    fn value_of(&self, scene: &str) -> Option<f64> {
        let document: Value = serde_json::from_str(scene).ok()?;
        let inputs = self.study.inputs.iter();
        let values: Option<Vec<f64>> = inputs
            .map(|input| number_in(&document, &input.vary))
            .collect();
        let values = values?;
        let others = values.iter().zip(&self.means).enumerate();
        let is_near = others
            .into_iter()
            .all(|(k, (value, mean))| k == self.index || value == mean);
        let expected = scene_at(self.study, &values).ok().filter(|_| is_near)?;
        let stored = Scene::from_text(scene, Format::Json).ok()?;
        (stored == expected).then_some(values[self.index])
    }
}

/// A point's map; `None` where it was read without.
fn node(
    point: &LinePoint,
    mean: f64,
    response: Response,
    inflated_mm: &[[f64; 3]],
) -> Option<SectionNode> {
    let map = response.map?;
    let displacement_mm = match map.shape {
        Some(shape) => shape.displacement_mm,
        None => displacements(&map.position_mm?, inflated_mm),
    };
    Some(SectionNode {
        value: point.value,
        ordinal: point.ordinal,
        cut_point: point.value == mean,
        reaction_n: response.reaction_n,
        strain_x: map.strain.x,
        strain_y: map.strain.y,
        displacement_mm,
    })
}

/// Differences of positions, which are kept to a picometre.
fn displacements(position_mm: &[f64], inflated_mm: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let to_picometre = |length_mm: f64| (length_mm * 1e9).round() / 1e9;
    let (positions, _) = position_mm.as_chunks::<3>();
    let pairs = positions.iter().zip(inflated_mm);
    pairs
        .map(|(end, start)| [0, 1, 2].map(|i| to_picometre(end[i] - start[i])))
        .collect()
}
