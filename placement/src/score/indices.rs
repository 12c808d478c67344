//! Responses to indices per output: the strains at P1, P2, ... and those of the dense map, in one analysis.

use fem_client::solver::direction::{Direction, PerDirection};
use fem_client::solver::{Coarser, Response, StrainMap};
use gsa::campaign::Campaign;
use gsa::method::analysis::{Analysis, Status};
use ndarray::{Array2, Axis};

use crate::result::{CoarserIndices, FormMisses, IndexError, IndexMap, MapLayer, Output};
use crate::run::archive::Outcome;
use crate::score::quantity::{at_locations, over_map};
use crate::study::directions::Directions;

/// Why an index has no error of the mesh.
pub const NO_MESH_ERROR: &str = "no coarser mesh gave indices to compare with";

/// Indices of every output of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Scores {
    /// At P1, P2, ...
    pub at_locations: Vec<PerDirection<Scored>>,
    /// Indices over the dense map, when the responses have one.
    pub map: Option<IndexMap>,
}

/// An output with what only the ranking needs of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Scored {
    /// Its indices.
    pub output: Output,
    /// M-DRM's indices, wherever they exist, whether they hold or not.
    pub mdrm_first_order: Option<Vec<f64>>,
    /// Error of each first-order index.
    pub index_errors: Option<Vec<f64>>,
}

impl Scores {
    /// The outputs at the locations: P1 x, P1 y, P2 x, ...
    pub fn outputs(&self) -> impl Iterator<Item = &Output> {
        let scored = self.at_locations.iter().flat_map(PerDirection::iter);
        scored.map(|scored| &scored.output)
    }
}

/// Those of them that the ranking rests on, and that an adaptive method serves: the locations', in the directions asked for.
pub fn ranked_values(outcomes: &[Outcome], directions: Directions) -> Array2<f64> {
    let [ranked, _] = location_columns(outcomes, directions);
    values(outcomes).select(Axis(1), &ranked)
}

/// The locations' columns among all: those that the ranking rests on, and the others.
fn location_columns(outcomes: &[Outcome], directions: Directions) -> [Vec<usize>; 2] {
    let first = outcomes.iter().flatten().next();
    let locations = first.into_iter().flat_map(at_locations);
    let columns = locations.flat_map(|_| Direction::ALL).enumerate();
    let (ranked, others): (Vec<_>, Vec<_>) =
        columns.partition(|(_, direction)| directions.include(*direction));
    [ranked, others].map(|columns| columns.into_iter().map(|(column, _)| column).collect())
}

/// The same points on a coarser mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Coarse {
    /// Which mesh, and what its indices say of the finer one's error.
    pub coarser: Coarser,
    /// What it answered, where it did at the cut point.
    pub outcomes: Option<Vec<Outcome>>,
}

/// What the mesh does to the first-order indices of one output.
#[derive(Debug, Clone, Copy, PartialEq)]
enum MeshError {
    /// There is no mesh.
    Exact,
    /// There is one, and no other to compare with.
    Unknown,
    /// No index is off by more, as far as another mesh shows.
    Within(f64),
}

impl MeshError {
    fn known(self) -> Option<f64> {
        match self {
            Self::Within(error) => Some(error),
            Self::Exact | Self::Unknown => None,
        }
    }
}

/// The analysis of one output, and what the mesh does to it.
struct Analysed {
    analysis: Analysis,
    mesh: MeshError,
    coarser: Option<CoarserIndices>,
}

/// The outputs of all points, a row each: locations first, then the map. A point without an equilibrium has a row of NaN.
///
/// # Panics
/// If the responses differ in their readout.
pub fn values(outcomes: &[Outcome]) -> Array2<f64> {
    let columns = outcomes
        .iter()
        .flatten()
        .next()
        .map_or(0, |first| readings(first).len());
    let row = |outcome: &Outcome| match outcome {
        Ok(response) => readings(response),
        Err(_) => vec![f64::NAN; columns],
    };
    let rows: Vec<Vec<f64>> = outcomes.iter().map(row).collect();
    let values = Array2::from_shape_vec((rows.len(), columns), rows.concat());
    values.expect("every response has the same readout")
}

/// Scores the outcomes at the points of a campaign, in its order; `cut` is the response of its first point. The coarser
/// mesh, where there is one, shows the error of the mesh.
///
/// # Panics
/// If there is not one outcome for each point, or the responses differ in their readout.
pub fn score(
    campaign: &Campaign,
    directions: Directions,
    cut: &Response,
    outcomes: &[Outcome],
    coarse: Option<&Coarse>,
) -> Scores {
    let unseen = match cut.model.elements {
        0 => MeshError::Exact,
        _ => MeshError::Unknown,
    };
    let mut analyses = analysed(campaign, directions, outcomes, coarse, unseen).into_iter();
    let mut next = || analyses.next().expect("an analysis of each reading");
    let mut scored = |name: &str| PerDirection::of(|direction| scored(name, direction, &next()));
    let names = cut.locations.iter().map(|location| &location.name);
    let at_locations = names.map(|name| scored(name)).collect();
    let over_map: Vec<Analysed> = analyses.collect();
    let inputs = campaign.inputs().len();
    Scores {
        at_locations,
        map: cut
            .map
            .as_ref()
            .map(|map| index_map(map, inputs, &over_map)),
    }
}

fn analysed(
    campaign: &Campaign,
    directions: Directions,
    outcomes: &[Outcome],
    coarse: Option<&Coarse>,
    unseen: MeshError,
) -> Vec<Analysed> {
    let analyse = |outcomes: &[Outcome]| {
        assert_eq!(
            outcomes.len(),
            campaign.points().len(),
            "one outcome for each point"
        );
        let values = values(outcomes);
        let [ranked, others] = location_columns(outcomes, directions);
        let of_locations = ranked.len() + others.len();
        let has_rules = "a campaign that asked for points has the rules to analyse them";
        let served = campaign.analyse(&values.select(Axis(1), &ranked).view());
        let beside = campaign.survey(&values.select(Axis(1), &others).view());
        let mapped = campaign.survey(&values.view().split_at(Axis(1), of_locations).1);
        let served = ranked.into_iter().zip(served.expect(has_rules));
        let beside = others.into_iter().zip(beside.expect(has_rules));
        let mut at_locations: Vec<(usize, Analysis)> = served.chain(beside).collect();
        at_locations.sort_by_key(|(column, _)| *column);
        let at_locations = at_locations.into_iter().map(|(_, analysis)| analysis);
        at_locations.chain(mapped.expect(has_rules)).collect()
    };
    let found: Vec<Analysis> = analyse(outcomes);
    let witness =
        coarse.and_then(|coarse| Some((coarse.coarser.factor, coarse.outcomes.as_ref()?)));
    let Some((factor, outcomes)) = witness else {
        let unseen = found.into_iter().map(|analysis| Analysed {
            analysis,
            mesh: unseen,
            coarser: None,
        });
        return unseen.collect();
    };
    let coarse = analyse(outcomes);
    let pairs = found.into_iter().zip(&coarse);
    pairs
        .map(|(analysis, coarse)| {
            let error = mesh_error(&analysis, coarse, factor);
            let first_order = coarse.first_order.clone();
            Analysed {
                mesh: error.map_or(unseen, MeshError::Within),
                coarser: first_order.map(|first_order| CoarserIndices {
                    first_order,
                    factor,
                }),
                analysis,
            }
        })
        .collect()
}

/// Mesh error of the first-order indices of one strain: their largest difference from the coarser mesh's, times what that says of the
/// finer one. The largest, because a single index may agree on two meshes by chance: one in five did on the coarse level, and
/// was off by up to seventeen times its own difference.
fn mesh_error(fine: &Analysis, coarse: &Analysis, factor: f64) -> Option<f64> {
    let indices = fine.first_order.iter().flatten();
    let pairs = indices.zip(coarse.first_order.as_ref()?);
    let differences = pairs.map(|(a, b)| factor * (a - b).abs());
    Some(differences.fold(0.0, f64::max).min(1.0))
}

/// Error of each first-order index, the mesh's included; none where that is unknown.
fn total_by_input(Analysed { analysis, mesh, .. }: &Analysed) -> Option<Vec<f64>> {
    analysis.first_order.as_ref()?;
    let of_mesh = match mesh {
        MeshError::Exact => 0.0,
        MeshError::Unknown => return None,
        MeshError::Within(error) => *error,
    };
    let errors = analysis.error.by_input.as_ref()?.iter();
    Some(errors.map(|error| (error + of_mesh).min(1.0)).collect())
}

fn largest(errors: &[f64]) -> f64 {
    errors.iter().copied().fold(0.0, f64::max)
}

/// What is read of one point: locations first, then the map's x layer and y layer.
fn readings(response: &Response) -> Vec<f64> {
    let map = response.map.iter().flat_map(|map| over_map(map).iter());
    at_locations(response)
        .flatten()
        .chain(map.flatten().copied())
        .collect()
}

fn std(analysis: &Analysis) -> Option<f64> {
    analysis.variance.map(f64::sqrt)
}

fn scored(location: &str, direction: Direction, analysed: &Analysed) -> Scored {
    Scored {
        output: output(location, direction, analysed),
        mdrm_first_order: analysed.analysis.mdrm_first_order.clone(),
        index_errors: total_by_input(analysed),
    }
}

fn output(location: &str, direction: Direction, analysed: &Analysed) -> Output {
    let analysis = &analysed.analysis;
    let broken = analysis.status == Status::ProductFormBroken;
    Output {
        location: location.to_owned(),
        direction,
        mean: analysis.mean,
        std: std(analysis),
        first_order: analysis.first_order.clone(),
        total: analysis.total.clone(),
        method: analysis.method,
        status: analysis.status,
        reason: analysis.reason.clone(),
        mdrm_first_order: analysis.mdrm_first_order.clone().filter(|_| broken),
        error: index_error(analysed),
        coarser: analysed.coarser.clone(),
        misses: analysis.misses.as_ref().and_then(FormMisses::of),
    }
}

fn index_error(analysed: &Analysed) -> IndexError {
    let (analysis, mesh) = (&analysed.analysis, analysed.mesh.known());
    let missing = |part: Option<f64>, why: &str| part.is_none().then(|| why.to_owned());
    let reasons = [
        missing(mesh, NO_MESH_ERROR),
        missing(
            analysis.error.quadrature,
            "the rule has too few nodes to show its own error",
        ),
        missing(
            analysis.error.decomposition,
            "there are no check points to show the error of the decomposition",
        ),
    ];
    let indexed = analysis.first_order.is_some();
    IndexError {
        mesh: mesh.filter(|_| indexed),
        quadrature: analysis.error.quadrature.filter(|_| indexed),
        decomposition: analysis.error.decomposition.filter(|_| indexed),
        total: total_by_input(analysed).as_deref().map(largest),
        reason: if indexed {
            let reasons: Vec<String> = reasons.into_iter().flatten().collect();
            (!reasons.is_empty()).then(|| reasons.join("; "))
        } else {
            Some("there are no indices to have an error".to_owned())
        },
    }
}

fn index_map(map: &StrainMap, inputs: usize, analyses: &[Analysed]) -> IndexMap {
    let mut rest = analyses;
    let layer = |direction| {
        let strain = &over_map(map)[direction];
        let (own, others) = rest.split_at(strain.len());
        rest = others;
        layer(direction, strain, own, inputs)
    };
    IndexMap {
        theta_deg: map.theta_deg.clone(),
        phi_deg: map.phi_deg.clone(),
        layers: Direction::ALL.map(layer).to_vec(),
        shape: map.shape.clone(),
    }
}

fn layer(direction: Direction, strain: &[f64], analyses: &[Analysed], inputs: usize) -> MapLayer {
    let index = |input: usize| {
        analyses
            .iter()
            .map(move |output| Some(output.analysis.first_order.as_ref()?[input]))
            .collect()
    };
    MapLayer {
        direction,
        strain: strain.to_vec(),
        std: analyses
            .iter()
            .map(|output| std(&output.analysis))
            .collect(),
        first_order: (0..inputs).map(index).collect(),
        error: analyses
            .iter()
            .map(|analysed| total_by_input(analysed).as_deref().map(largest))
            .collect(),
        status: analyses
            .iter()
            .map(|output| output.analysis.status)
            .collect(),
    }
}
