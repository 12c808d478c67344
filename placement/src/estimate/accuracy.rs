//! The accuracy that a mesh and a method had where it was measured.

use fem_client::scene::Level;
use gsa::method::Kind;

use crate::ladder::fidelity::Fidelity;
use results::ExpectedAccuracy;

/// True and claimed errors of `docs/use/trade.md`: largest over the ten indices by which the paper's study ranks, five nodes.
const MEASURED: [(Level, Kind, f64, Option<f64>); 9] = [
    (Level::Draft, Kind::Mdrm, 0.0219, None),
    (Level::Draft, Kind::Bivariate, 0.0274, None),
    (Level::Draft, Kind::Auto, 0.0251, None),
    (Level::Coarse, Kind::Mdrm, 0.0067, Some(0.0887)),
    (Level::Coarse, Kind::Auto, 0.0067, Some(0.0492)),
    (Level::Standard, Kind::Mdrm, 0.0031, Some(0.0571)),
    (Level::Standard, Kind::Bivariate, 0.0041, Some(0.0089)),
    (Level::Standard, Kind::Auto, 0.0037, Some(0.0112)),
    (Level::Reference, Kind::Mdrm, 0.0010, Some(0.1230)),
];

/// Returns the accuracy to expect of a mesh and a method.
pub(crate) fn expected_accuracy(fidelity: Fidelity) -> ExpectedAccuracy {
    let measured = MEASURED
        .iter()
        .find(|(level, kind, ..)| (*level, *kind) == (fidelity.level, fidelity.kind));
    ExpectedAccuracy {
        fidelity: fidelity.label(),
        error_true: measured.map(|(_, _, error, _)| *error),
        error_claimed: measured.and_then(|(_, _, _, claimed)| *claimed),
        reason: measured.is_none().then(|| {
            "the accuracy of this mesh with this method wasn't measured on the paper's study"
                .to_owned()
        }),
    }
}
