//! How faithfully a study is answered: the mesh and the method, as one value.

use fem_client::scene::Level;
use gsa::method::{Kind, Method};
use serde::{Deserialize, Serialize};

use crate::study::Study;

/// A mesh level and a method with its size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fidelity {
    /// Mesh level.
    pub level: Level,
    /// How indices are computed.
    pub kind: Kind,
    /// Gauss nodes for each input.
    pub nodes: usize,
}

/// A fidelity as it stands in documents.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct FidelityReport {
    /// Mesh level.
    pub level: String,
    /// Method.
    pub method: String,
    /// Gauss nodes for each input, at the start where the method adds some.
    pub nodes: usize,
    /// Points off the lines, at the start where the method adds some.
    pub check_points: usize,
}

/// What the ladder is made of, cheap to dear within each level. M-DRM's rungs differ in nodes, the others also see interactions.
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

    /// The same study, answered with this fidelity. Its other settings are kept, so that the same points are drawn.
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

    /// The same study with this mesh and this kind of method; what it says of its own method is kept.
    #[must_use]
    pub(crate) fn raise(self, study: &Study) -> Study {
        let method = study.method;
        let mut raised = self.apply(study);
        if method.kind == self.kind {
            raised.method = method;
        }
        raised
    }

    /// In a few words.
    pub fn label(self) -> String {
        format!(
            "{} {} {}",
            self.level.as_str(),
            self.kind.as_str(),
            self.nodes
        )
    }

    /// As it stands in documents.
    pub fn report(self, study: &Study) -> FidelityReport {
        FidelityReport {
            level: self.level.as_str().to_owned(),
            method: self.kind.as_str().to_owned(),
            nodes: self.nodes,
            check_points: self.apply(study).method.check_points,
        }
    }
}
