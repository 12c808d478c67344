//! Candidates: a model with a set of features.

use crate::recipe::{FeatureSet, Kind, Recipe};

/// A model with a feature set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Candidate {
    /// The model.
    pub kind: Kind,
    /// Features that it is given.
    pub features: FeatureSet,
}

/// All candidates of a recipe that are learnt, the training mean first: a blend is made of them.
pub fn candidates(recipe: &Recipe) -> Vec<Candidate> {
    let mean = Candidate {
        kind: Kind::Mean,
        features: FeatureSet::Raw,
    };
    let kinds = recipe
        .models
        .kinds
        .iter()
        .filter(|kind| !matches!(kind, Kind::Mean | Kind::Blend));
    let with_sets = kinds.flat_map(|kind| {
        recipe.features.sets.iter().map(|features| Candidate {
            kind: *kind,
            features: *features,
        })
    });
    std::iter::once(mean).chain(with_sets).collect()
}
