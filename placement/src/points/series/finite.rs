//! Guards the archive and the result against numbers that no document can hold.

use fem_client::solver::direction::PerDirection;
use fem_client::solver::{FilmSignal, LocationStrain, Response, Ring, Section, StrainMap};

use crate::points::archive::Outcome;

/// The first part of an outcome that holds a NaN or an infinity.
pub(crate) fn not_finite(outcome: &Outcome) -> Option<&'static str> {
    match outcome {
        Ok(response) => in_response(response),
        Err(unsolved) => {
            let reached = &unsolved.reached;
            let mut loads = reached
                .depths_mm
                .iter()
                .chain([&reached.pressure_mpa])
                .chain(&reached.load_n);
            loads.any(|x| !x.is_finite()).then_some("a load reached")
        }
    }
}

/// The first part of a response that holds a NaN or an infinity.
fn in_response(response: &Response) -> Option<&'static str> {
    let Section {
        crown,
        shoulder,
        sidewall,
    } = &response.section;
    let (inflated, error) = (&response.inflated, &response.error);
    let at_location = |location: &LocationStrain| {
        finite([&location.theta_deg, &location.von_mises_mpa]) && finite(location.strain.iter())
    };
    let over_map = |map: &StrainMap| {
        let places = map.position_mm.iter().flatten();
        finite(map.theta_deg.iter().chain(&map.phi_deg).chain(places))
            && finite(map.strain.iter().flatten())
    };
    let glued = response.film.map(|film| film.signal);
    let around = |ring: &Ring| {
        finite(&ring.theta_deg) && finite(ring.strain.iter().chain(&ring.turned).flatten())
    };
    let checks = [
        ("the reaction", response.reaction_n.is_finite()),
        ("a force", finite(response.force_n.iter().flatten())),
        ("the depth", response.depth_mm.is_finite()),
        (
            "a strain or stress at a location",
            response.locations.iter().all(at_location),
        ),
        (
            "a strain of the section",
            finite(
                [crown, shoulder, sidewall]
                    .into_iter()
                    .flat_map(PerDirection::iter),
            ),
        ),
        (
            "a figure of the inflated state",
            inflated.outer_radius_mm.is_finite() && finite(inflated.crown_stretch.iter()),
        ),
        (
            "an error",
            error.reaction_n.is_finite() && finite(error.strain.iter()),
        ),
        ("the volume change", response.max_volume_change.is_finite()),
        (
            "a residual",
            finite(response.residual_history.iter().flatten()),
        ),
        ("a strain of the map", response.map.iter().all(over_map)),
        ("a strain of a ring", response.rings.iter().all(around)),
        (
            "a strain or stress of a gauge",
            response.gauges.iter().all(|gauge| {
                finite([
                    &gauge.strain,
                    &gauge.stretch,
                    &gauge.green_lagrange,
                    &gauge.von_mises_mpa,
                ])
            }),
        ),
        (
            "a film's signal",
            response
                .films
                .iter()
                .chain(&glued)
                .all(FilmSignal::is_finite),
        ),
    ];
    checks
        .into_iter()
        .find(|(_, finite)| !finite)
        .map(|(what, _)| what)
}

fn finite<'n>(numbers: impl IntoIterator<Item = &'n f64>) -> bool {
    numbers.into_iter().all(|number| number.is_finite())
}
