//! Scores that layouts have over contacts as they come: what films tell of them, and errors by the response surface.

use crate::field::film_field::DepthFields;
use crate::field::told_loads::TOLD_LOADS;
use crate::simulate::simulation::{Simulated, ToldError};
use results::{LayoutError, LayoutScore, ToldQuantity};

/// Error of a quantity over its deviation below which films tell something of it.
const KNOWN: f64 = 0.9;

/// Changes of simulated figures where the surface over contacts is off: of an estimate that was made from it.
pub(super) fn of_surface(
    score: &LayoutScore,
    off: &Simulated,
    (slope, force_n): (f64, f64),
) -> LayoutError {
    let change = |off: f64, own: Option<f64>| own.map(|own| (off - own).abs());
    let [off_force_n, _] = off.force_n(slope);
    LayoutError {
        simulated_rms_angle_error_deg: change(
            off.rms_angle_deg,
            score.simulated_rms_angle_error_deg,
        ),
        simulated_p95_angle_error_deg: change(
            off.p95_angle_deg,
            score.simulated_p95_angle_error_deg,
        ),
        force_error_n: change(off_force_n.hypot(force_n), score.force_error_n),
        ..LayoutError::default()
    }
}

/// Errors of what films tell of the quantities that contacts differ in.
pub(super) fn told(fields: &DepthFields, simulated: &Simulated) -> Vec<ToldQuantity> {
    let names = fields.contacts.iter().flat_map(|surface| {
        let told = surface.told().into_iter();
        let quantities = told.map(|law| surface.laws()[law].quantity);
        let quantities = quantities.map(|quantity| (quantity.as_str(), quantity.words()));
        quantities.chain(TOLD_LOADS.iter().map(|load| (load.name, load.words)))
    });
    let of = |((of, words), own): ((&str, &str), &ToldError)| ToldQuantity {
        of: of.to_owned(),
        words: words.to_owned(),
        error: own.rms,
        error_se: Some(own.rms_se),
        claim: None,
        load_n: None,
        deviation: own.deviation,
        known: own.rms < KNOWN * own.deviation,
    };
    let all = names.zip(&simulated.told);
    // A load that no contact has, as the one that side traction makes where there is none, is no question.
    all.filter(|(_, own)| own.deviation > 0.0).map(of).collect()
}
