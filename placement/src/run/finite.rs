//! Guards the archive and the result against numbers that no document can hold.

use fem_client::solver::Response;

use crate::run::archive::Outcome;

/// The first part of an outcome that holds a NaN or an infinity.
pub(crate) fn not_finite(outcome: &Outcome) -> Option<&'static str> {
    match outcome {
        Ok(response) => in_response(response),
        Err(unsolved) => {
            let reached = &unsolved.reached;
            let mut loads = reached.depths_mm.iter().chain([&reached.pressure_mpa]);
            loads.any(|x| !x.is_finite()).then_some("a load reached")
        }
    }
}

/// The first part of a response that holds a NaN or an infinity.
fn in_response(response: &Response) -> Option<&'static str> {
    let section = [
        response.section.crown,
        response.section.shoulder,
        response.section.sidewall,
    ];
    let inflated = &response.inflated;
    let error = &response.error;
    let all = |lists: &[&[f64]]| lists.iter().all(|list| list.iter().all(|x| x.is_finite()));
    let checks = [
        ("the reaction", response.reaction_n.is_finite()),
        (
            "a strain or stress at a location",
            response.locations.iter().all(|location| {
                all(&[&[
                    location.theta_deg,
                    location.strain_x,
                    location.strain_y,
                    location.von_mises_mpa,
                ]])
            }),
        ),
        (
            "a strain of the section",
            section
                .iter()
                .all(|pair| all(&[&[pair.strain_x, pair.strain_y]])),
        ),
        (
            "a figure of the inflated state",
            all(&[&[
                inflated.outer_radius_mm,
                inflated.crown_stretch_x,
                inflated.crown_stretch_y,
            ]]),
        ),
        (
            "an error",
            all(&[&[error.reaction_n, error.strain_x, error.strain_y]]),
        ),
        ("the volume change", response.max_volume_change.is_finite()),
        (
            "a residual",
            response.residual_history.iter().all(|step| all(&[step])),
        ),
        (
            "a strain of the map",
            response
                .map
                .iter()
                .all(|map| all(&[&map.theta_deg, &map.phi_deg, &map.strain_x, &map.strain_y])),
        ),
        (
            "a strain of a ring",
            response
                .rings
                .iter()
                .all(|ring| all(&[&ring.theta_deg, &ring.strain_x, &ring.strain_y])),
        ),
    ];
    checks
        .into_iter()
        .find(|(_, finite)| !finite)
        .map(|(what, _)| what)
}
