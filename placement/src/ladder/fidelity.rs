//! Fidelity of an answer: the mesh and the method, as one value.

use fem_client::scene::Level;
use gsa::method::{Kind, Method};
use results::FidelityReport;

use documents::study::Study;

/// A mesh level and a method with its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fidelity {
    /// Mesh level.
    pub level: Level,
    /// Kind of method that computes the indices.
    pub kind: Kind,
    /// Gauss nodes for each input.
    pub nodes: usize,
}

/// Rungs of the ladder, cheap to dear within each level. M-DRM's rungs differ in nodes, the others also see interactions.
const LADDER: [(Level, Kind, usize); 14] = [
    (Level::Draft, Kind::Mdrm, 3),
    (Level::Draft, Kind::Mdrm, 5),
    (Level::Draft, Kind::Mdrm, 9),
    (Level::Draft, Kind::Bivariate, 5),
    (Level::Draft, Kind::Auto, 5),
    (Level::Coarse, Kind::Mdrm, 3),
    (Level::Coarse, Kind::Mdrm, 5),
    (Level::Coarse, Kind::Auto, 5),
    (Level::Standard, Kind::Mdrm, 3),
    (Level::Standard, Kind::Mdrm, 5),
    (Level::Standard, Kind::Mdrm, 9),
    (Level::Standard, Kind::Bivariate, 5),
    (Level::Standard, Kind::Auto, 5),
    (Level::Reference, Kind::Mdrm, 5),
];

impl Fidelity {
    /// The rungs of the ladder.
    pub fn ladder() -> impl Iterator<Item = Self> {
        LADDER
            .into_iter()
            .map(|(level, kind, nodes)| Self { level, kind, nodes })
    }

    /// The study's own.
    pub fn of(study: &Study) -> Self {
        Self {
            level: study.level,
            kind: study.method.kind,
            nodes: study.method.nodes,
        }
    }

    /// Returns the study, answered with this fidelity. Its other settings are kept, so that the same points are drawn.
    #[must_use]
    pub fn apply(self, study: &Study) -> Study {
        let mut study = study.clone();
        study.level = self.level;
        study.scene.model.level = self.level;
        study.method = Method {
            nodes: self.nodes,
            seed: study.method.seed,
            ..Method::of(self.kind)
        };
        study
    }

    /// Returns the study with this mesh and this kind of method; what it says of its own method is kept.
    #[must_use]
    pub(crate) fn raise(self, study: &Study) -> Study {
        let method = study.method;
        let mut raised = self.apply(study);
        if method.kind == self.kind {
            raised.method = method;
        }
        raised
    }

    /// Describes it in a few words.
    pub fn label(self) -> String {
        format!(
            "{} {} {}",
            self.level.as_str(),
            self.kind.as_str(),
            self.nodes
        )
    }

    /// Describes it as it stands in documents.
    pub fn report(self, study: &Study) -> FidelityReport {
        FidelityReport {
            level: self.level.as_str().to_owned(),
            method: self.kind.as_str().to_owned(),
            nodes: self.nodes,
            check_points: self.apply(study).method.check_points,
        }
    }
}
