//! What a study analyses of a response: the strain at the locations, over the map and around the rings.
//!
//! Whatever else a film tells is read here, and nowhere else.

use fem_client::solver::direction::PerDirection;
use fem_client::solver::{Response, Ring, StrainMap};

/// What it is called.
pub(crate) const QUANTITY: &str = "strain";

/// At P1, P2, ...
pub(crate) fn at_locations(response: &Response) -> impl Iterator<Item = PerDirection<f64>> + '_ {
    response.locations.iter().map(|location| location.strain)
}

/// Over the dense map, rows x columns.
pub(crate) fn over_map(map: &StrainMap) -> &PerDirection<Vec<f64>> {
    &map.strain
}

/// Around the wheel, a sample each degree.
pub(crate) fn around(ring: &Ring) -> &PerDirection<Vec<f64>> {
    &ring.strain
}
