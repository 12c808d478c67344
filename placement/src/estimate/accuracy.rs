//! The accuracy that a mesh and a method had where it was measured.

use fem_client::scene::Level;
use gsa::method::Kind;

use crate::fidelity::Fidelity;
use crate::result::ExpectedAccuracy;

/// True and claimed errors of `docs/trade.md`: largest over the ten indices by which the paper's study ranks, five nodes.
const MEASURED: [(Level, Kind, f64, f64); 9] = [
    (Level::Draft, Kind::Mdrm, 0.0220, 0.1323),
    (Level::Draft, Kind::Bivariate, 0.0248, 0.0192),
    (Level::Draft, Kind::Auto, 0.0236, 0.0064),
    (Level::Coarse, Kind::Mdrm, 0.0078, 0.1976),
    (Level::Coarse, Kind::Auto, 0.0022, 0.0601),
    (Level::Standard, Kind::Mdrm, 0.0038, 0.1604),
    (Level::Standard, Kind::Bivariate, 0.0041, 0.0257),
    (Level::Standard, Kind::Auto, 0.0051, 0.0205),
    (Level::Reference, Kind::Mdrm, 0.0015, 0.1139),
];

/// What to expect of a mesh and a method.
pub(crate) fn expected_accuracy(fidelity: Fidelity) -> ExpectedAccuracy {
    let measured = MEASURED
        .iter()
        .find(|(level, kind, ..)| (*level, *kind) == (fidelity.level, fidelity.kind));
    ExpectedAccuracy {
        fidelity: fidelity.label(),
        error_true: measured.map(|(_, _, error, _)| *error),
        error_claimed: measured.map(|(_, _, _, claimed)| *claimed),
        reason: measured.is_none().then(|| {
            "the accuracy of this mesh with this method wasn't measured on the paper's study"
                .to_owned()
        }),
    }
}
