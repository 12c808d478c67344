//! Quantity that a study analyses of a response: the strain at the locations, over the map and around the rings.
//!
//! Whatever else a film tells is read here, and nowhere else.

use fem_client::solver::direction::PerDirection;
use fem_client::solver::{Response, Ring, StrainMap};

/// Strain that Newton's tolerance leaves open, absolute: solves that are nearer to each other are repeated, not told apart. Forces are balanced to
/// 1e-8 of theirs, and a strain follows the pressed depths, of the order of the forces' own share. Seen on the foot tire: stations moved by 1e-8 mm
/// move no strain at all, where 4e-10 would be right; by 1e-7 mm some of them do, by 1e-6 mm (2e-8 to 4e-8) all, to 1 %.
pub(crate) const STRAIN_TOLERANCE: f64 = 1e-8;

/// Name of the quantity.
pub(crate) const QUANTITY: &str = "strain";

/// Returns what a response leaves open in each of them: nothing where there is no mesh, and so nothing to iterate.
pub(crate) fn tolerance(response: &Response) -> f64 {
    match response.model.elements {
        0 => 0.0,
        _ => STRAIN_TOLERANCE,
    }
}

/// Returns the strains at P1, P2, ...
pub(crate) fn at_locations(response: &Response) -> impl Iterator<Item = PerDirection<f64>> + '_ {
    response.locations.iter().map(|location| location.strain)
}

/// Returns the strains over the dense map, rows x columns.
pub(crate) fn over_map(map: &StrainMap) -> &PerDirection<Vec<f64>> {
    &map.strain
}

/// Returns the strains around the wheel, a sample each degree.
pub(crate) fn around(ring: &Ring) -> &PerDirection<Vec<f64>> {
    &ring.strain
}
