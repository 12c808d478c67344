//! Whether a study looks the same from both ends of the contact: what its points then tell of their mirror images.
//!
//! The ground's mirror image has the same strains in the opposite order, x and y with their signs. So where stations that lie as far before
//! the contact centre as behind it are pressed in alike, by inputs of one law, every point tells the strains of another one too.

use fem_client::solver::Response;
use fem_client::solver::direction::Direction;
use gsa::campaign::Campaign;
use gsa::symmetric::Symmetric;
use ndarray::Array2;

use crate::score::quantity::{STRAIN_TOLERANCE, over_map};
use crate::score::readings::range;
use documents::study::{Input, Study};

/// Share of what a strain ranges over by which it may differ from its mirror image's: meshes and printed files of other programs.
const DIFFERENCE: f64 = 1e-3;

/// A study that is its own mirror image, as far as its document says.
pub(crate) struct Mirror {
    symmetric: Symmetric,
}

impl Mirror {
    /// Finds the mirror images; `None` where stations or their inputs differ before and behind the centre, or the ground is dragged along the wheel.
    pub(crate) fn of(study: &Study, campaign: &Campaign) -> Option<Self> {
        let along = study.scene.ground.shift_mm[0];
        let varies_along = |input: &Input| input.vary == "ground.shift_mm[0]";
        if along != 0.0 || study.inputs.iter().any(varies_along) {
            return None;
        }
        let symmetric = campaign.symmetric(&mirrored_inputs(study)?)?;
        Some(Self { symmetric })
    }

    /// Returns the symmetry of values whose points show it: a row per point, a column per output of `mirrored_columns`.
    pub(crate) fn shown_by(&self, values: &Array2<f64>, columns: &[usize]) -> Option<&Symmetric> {
        let agrees = |column: usize, image: usize| {
            let most = STRAIN_TOLERANCE.max(DIFFERENCE * range(values.column(column)));
            // A point without a number says nothing.
            let differs = |(k, l)| (values[(k, column)] - values[(l, image)]).abs() > most;
            !self.symmetric.pairs().any(differs)
        };
        let mut pairs = columns.iter().enumerate();
        let all =
            columns.len() == values.ncols() && pairs.all(|(column, &image)| agrees(column, image));
        all.then_some(&self.symmetric)
    }
}

/// Returns for each input which one varies the station on the other side; others are their own.
fn mirrored_inputs(study: &Study) -> Option<Vec<usize>> {
    let ground = &study.scene.ground;
    let depth = |station: usize| ground.depths_mm.get(station);
    let of_station = |station| {
        study
            .inputs
            .iter()
            .position(|i| i.station() == Some(station))
    };
    let mut exchange: Vec<usize> = (0..study.inputs.len()).collect();
    for station in 0..ground.stations {
        let other = ground.stations - 1 - station;
        match (of_station(station), of_station(other)) {
            (Some(input), Some(image)) => exchange[input] = image,
            (None, None) if depth(station) == depth(other) => {}
            _ => return None,
        }
    }
    Some(exchange)
}

/// Returns for each output which one lies on the other side: locations first, then the map. `None` where the map isn't centred.
pub(crate) fn mirrored_columns(cut: &Response) -> Option<Vec<usize>> {
    let (locations, directions) = (cut.locations.len(), Direction::ALL.len());
    let of_locations = (0..locations)
        .flat_map(|at| (0..directions).map(move |d| (locations - 1 - at) * directions + d));
    let mut columns: Vec<usize> = of_locations.collect();
    if let Some(map) = &cut.map {
        let theta = &map.theta_deg;
        let mut ends = theta.iter().zip(theta.iter().rev());
        // They are multiples of a step, which round.
        if !ends.all(|(left, right)| (left + right).abs() <= 1e-9) {
            return None;
        }
        for layer in over_map(map).iter() {
            let from = columns.len();
            let at = |k: usize| from + k - k % theta.len() + theta.len() - 1 - k % theta.len();
            columns.extend((0..layer.len()).map(at));
        }
    }
    Some(columns)
}
