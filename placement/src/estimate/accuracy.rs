//! The accuracy that a mesh and a method had where it was measured.

use fem_client::scene::Level;
use gsa::method::Kind;

use crate::ladder::fidelity::Fidelity;
use results::ExpectedAccuracy;

/// True and claimed errors of `docs/use/trade.md`: largest over the ten indices by which the paper's study ranks, five nodes.
const MEASURED: [(Level, Kind, f64, Option<f64>); 9] = [
    (Level::Draft, Kind::Mdrm, 0.0220, None),
    (Level::Draft, Kind::Bivariate, 0.0248, None),
    (Level::Draft, Kind::Auto, 0.0241, None),
    (Level::Coarse, Kind::Mdrm, 0.0078, Some(0.2858)),
    (Level::Coarse, Kind::Auto, 0.0025, Some(0.0593)),
    (Level::Standard, Kind::Mdrm, 0.0038, Some(0.0921)),
    (Level::Standard, Kind::Bivariate, 0.0041, Some(0.0163)),
    (Level::Standard, Kind::Auto, 0.0052, Some(0.0167)),
    (Level::Reference, Kind::Mdrm, 0.0015, Some(0.1197)),
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
