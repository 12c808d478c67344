//! Figures of layouts that answers go by: errors of angle and force with their claims.

use documents::study::question::Question;
use results::RankedLayout;

/// Figure of a layout that is known only to within a claim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Figure {
    pub value: f64,
    /// Claimed error; none where there is no coarser mesh.
    pub claim: Option<f64>,
}

/// The angle's error, degrees; `None` of a layout without a score.
pub(super) fn angle(layout: &RankedLayout) -> Option<Figure> {
    let error = layout.score.error.as_ref();
    Some(Figure {
        value: layout.score.simulated_p95_angle_error_deg?,
        claim: error.and_then(|error| error.simulated_p95_angle_error_deg),
    })
}

/// The force's error at the load where it is largest, N.
pub(super) fn force(layout: &RankedLayout) -> Option<Figure> {
    let at_loads = layout.loads.iter().filter_map(|load| {
        let error = load.score.error.as_ref();
        Some(Figure {
            value: load.score.force_error_n?,
            claim: error.and_then(|error| error.force_error_n),
        })
    });
    at_loads.max_by(|a, b| a.value.total_cmp(&b.value))
}

/// Returns what layouts are compared by: the angle's error; where limits are asked, the largest error over its limit.
pub(super) fn compared(layout: &RankedLayout, question: &Question) -> Option<Figure> {
    if !question.has_limits() {
        return angle(layout);
    }
    let over = |figure: Option<Figure>, limit: Option<f64>| {
        let (figure, limit) = (figure, limit?);
        figure.map(|figure| Figure {
            value: figure.value / limit,
            claim: figure.claim.map(|claim| claim / limit),
        })
    };
    let shares = [
        over(angle(layout), question.angle_deg),
        over(force(layout), question.force_n),
    ];
    let shares = shares.into_iter().flatten();
    shares.max_by(|a, b| a.value.total_cmp(&b.value))
}
