//! Responses to indices per output: the strains at P1, P2, ... and those of the dense map, in one analysis.

use crate::points::archive::Outcome;
use crate::score::analyst::{Analyst, Stopped};
use crate::score::quantity::over_map;
use documents::study::Study;
use results::{CoarserIndices, FormMisses, IndexError, IndexMap, MapLayer, Output};
use std::sync::atomic::AtomicBool;

use fem_client::solver::direction::{Direction, PerDirection};
use fem_client::solver::{Coarser, Response, StrainMap};
use gsa::campaign::Campaign;
use gsa::method::analysis::{Analysis, Status};

/// Reason why an index has no error of the mesh.
pub(crate) const NO_MESH_ERROR: &str = "no coarser mesh gave indices to compare with";

/// Indices of every output of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Scores {
    /// Scores at P1, P2, ...
    pub at_locations: Vec<PerDirection<Scored>>,
    /// Indices over the dense map, when the responses have one.
    pub map: Option<IndexMap>,
}

/// An output with what only the ranking needs of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Scored {
    /// Indices of the output.
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

/// Outcomes of the points on a coarser mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Coarse {
    /// Level of the mesh, and what its indices say of the finer one's error.
    pub coarser: Coarser,
    /// Outcomes, where it answered at the cut point.
    pub outcomes: Option<Vec<Outcome>>,
}

/// Error of the first-order indices of one output by the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
enum MeshError {
    /// No error: there is no mesh.
    Exact,
    /// Unknown error: there is a mesh, and no other to compare with.
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

/// Scores the outcomes at the points of a campaign, in its order; `cut` is the response of its first point. The coarser
/// mesh, where there is one, shows the error of the mesh.
///
/// # Errors
/// When `stop` is set meanwhile.
///
/// # Panics
/// If there is not one outcome for each point, or the responses differ in their readout.
pub fn score(
    study: &Study,
    campaign: &Campaign,
    cut: &Response,
    outcomes: &[Outcome],
    coarse: Option<&Coarse>,
    stop: &AtomicBool,
) -> Result<Scores, Stopped> {
    let analyst = Analyst::new(study, campaign);
    let mut analyses = analysed(&analyst, cut, outcomes, coarse, stop)?.into_iter();
    let mut next = || analyses.next().expect("an analysis of each reading");
    let mut scored = |name: &str| PerDirection::of(|direction| scored(name, direction, &next()));
    let names = cut.locations.iter().map(|location| &location.name);
    let at_locations = names.map(|name| scored(name)).collect();
    let over_map: Vec<Analysed> = analyses.collect();
    let inputs = campaign.inputs().len();
    let map = cut.map.as_ref();
    Ok(Scores {
        at_locations,
        map: map.and_then(|map| index_map(map, inputs, &over_map)),
    })
}

fn analysed(
    analyst: &Analyst<'_>,
    cut: &Response,
    outcomes: &[Outcome],
    coarse: Option<&Coarse>,
    stop: &AtomicBool,
) -> Result<Vec<Analysed>, Stopped> {
    let unseen = match cut.model.elements {
        0 => MeshError::Exact,
        _ => MeshError::Unknown,
    };
    let found = analyst.analyses(outcomes, stop)?;
    let witness = coarse.and_then(|coarse| Some((coarse.coarser, coarse.outcomes.as_ref()?)));
    let Some((coarser, outcomes)) = witness else {
        let unseen = found.into_iter().map(|analysis| Analysed {
            analysis,
            mesh: unseen,
            coarser: None,
        });
        return Ok(unseen.collect());
    };
    let coarse = analyst.analyses(outcomes, stop)?;
    let differences: Vec<Option<f64>> = found
        .iter()
        .zip(&coarse)
        .map(|(fine, coarse)| largest_difference(fine, coarse))
        .collect();
    let differences = of_places(&differences, cut.locations.len());
    let pairs = found.into_iter().zip(coarse).zip(differences);
    let with_mesh = pairs.map(|((analysis, coarse), difference)| {
        let error = difference.map(|difference| (coarser.of_largest * difference).min(1.0));
        Analysed {
            mesh: error.map_or(unseen, MeshError::Within),
            coarser: coarse.first_order.map(|first_order| CoarserIndices {
                first_order,
                factor: coarser.factor,
            }),
            analysis,
        }
    });
    Ok(with_mesh.collect())
}

/// The largest difference of a strain's first-order indices between two meshes; `None` where one of them has no indices.
fn largest_difference(fine: &Analysis, coarse: &Analysis) -> Option<f64> {
    let indices = fine.first_order.as_ref()?.iter();
    let pairs = indices.zip(coarse.first_order.as_ref()?);
    Some(pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max))
}

/// Returns for each strain the larger difference of both at its place, in the order of the readings: those at the locations alternate, the map has a layer after the other.
/// A single index, or all of a strain, may agree on two meshes by chance.
fn of_places(differences: &[Option<f64>], locations: usize) -> Vec<Option<f64>> {
    let ends = Direction::ALL.len() * locations;
    let cells = (differences.len() - ends) / Direction::ALL.len();
    let other = |k: usize| match k {
        _ if k < ends => k ^ 1,
        _ if k < ends + cells => k + cells,
        _ => k - cells,
    };
    let of_place = |(k, own): (usize, &Option<f64>)| {
        own.map(|own| own.max(differences[other(k)].unwrap_or(0.0)))
    };
    differences.iter().enumerate().map(of_place).collect()
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

/// The map of indices; `None` where the solver doesn't tell where its points lie.
fn index_map(map: &StrainMap, inputs: usize, analyses: &[Analysed]) -> Option<IndexMap> {
    let mut rest = analyses;
    let layer = |direction| {
        let strain = &over_map(map)[direction];
        let (own, others) = rest.split_at(strain.len());
        rest = others;
        layer(direction, strain, own, inputs)
    };
    Some(IndexMap {
        theta_deg: map.theta_deg.clone(),
        phi_deg: map.phi_deg.clone(),
        layers: Direction::ALL.map(layer).to_vec(),
        shape: map.shape.clone()?,
    })
}

fn layer(direction: Direction, strain: &[f64], analyses: &[Analysed], inputs: usize) -> MapLayer {
    let over_all = |of: fn(&Analysis) -> &Option<Vec<f64>>, input: usize| {
        analyses
            .iter()
            .map(|output| Some(to_map_digits(of(&output.analysis).as_ref()?[input])))
            .collect()
    };
    let first_order = |input| over_all(|analysis| &analysis.first_order, input);
    let total = |input| over_all(|analysis| &analysis.total, input);
    let errors: Vec<Option<Vec<f64>>> = analyses.iter().map(total_by_input).collect();
    let error = |input: usize| {
        errors
            .iter()
            .map(|errors| Some(to_map_digits(errors.as_ref()?[input])))
            .collect()
    };
    let deviation = |output: &Analysed| std(&output.analysis).map(to_map_digits);
    MapLayer {
        direction,
        strain: strain.iter().copied().map(to_map_digits).collect(),
        std: analyses.iter().map(deviation).collect(),
        first_order: (0..inputs).map(first_order).collect(),
        total: (0..inputs).map(total).collect(),
        error: errors
            .iter()
            .map(|errors| errors.as_deref().map(|all| to_map_digits(largest(all))))
            .collect(),
        first_order_error: (0..inputs).map(error).collect(),
        status: analyses
            .iter()
            .map(|output| output.analysis.status)
            .collect(),
    }
}

/// Significant digits of a map's numbers, whose errors begin at the second: all seventeen would take twice the room, most of a result's.
const MAP_DIGITS: i32 = 7;

/// A number of a map, rounded to the digits that are kept.
fn to_map_digits(number: f64) -> f64 {
    let exponent = number.abs().log10().floor();
    if !exponent.is_finite() {
        return number;
    }
    // Powers of ten up to the 22nd are exact, so that the quotient is the number that the digits are read as.
    let scale = 10.0_f64.powi((MAP_DIGITS - 1 - exponent as i32).clamp(0, 22));
    (number * scale).round() / scale
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_keeps_seven_digits() {
        let told = [
            0.032_790_498_795_318_28,
            -7.227_826_438_257_298e-5,
            1.0 / 3.0,
            1.0,
            -0.0,
        ];
        let texts = told.map(|number| to_map_digits(number).to_string());
        assert_eq!(
            texts,
            ["0.0327905", "-0.00007227826", "0.3333333", "1", "-0"]
        );
        // Beyond any strain or share: less than 5e-23 is nothing, and whole numbers stay.
        assert_eq!(
            [1e-300, 12_345_678.9].map(to_map_digits),
            [0.0, 12_345_679.0]
        );
        assert!(to_map_digits(f64::NAN).is_nan());
    }

    #[test]
    fn a_place_has_the_larger_difference_of_its_two_strains() {
        // Two locations (x, y, x, y), then three cells of x and the same of y.
        let own = [1.0, 2.0, 4.0, 3.0, 1.0, 5.0, 2.0, 3.0, 4.0, 1.0].map(Some);
        let of_place = [2.0, 2.0, 4.0, 4.0, 3.0, 5.0, 2.0, 3.0, 5.0, 2.0].map(Some);
        assert_eq!(of_places(&own, 2), of_place);
        // A strain without indices has no error, and makes none.
        assert_eq!(of_places(&[None, Some(1.0)], 1), [None, Some(1.0)]);
    }
}
