//! The figures that a location is judged by: one table, from which they are computed, written, read back and described.
//!
//! All are first-order indices of the location's own input, the depth of the station below it, in percent. A further score is one more
//! entry of [`SCORES`].

use fem_client::solver::direction::{Direction, PerDirection};

/// A figure of a location for each direction.
pub struct Score {
    /// First part of its fields' names.
    pub name: &'static str,
    /// Last part of its fields' names; for people `%` stands for `percent`.
    pub unit: &'static str,
    /// Description of the score in documents.
    pub what: PerDirection<&'static str>,
    /// Whether it comes with an error.
    pub has_error: bool,
    /// Sentence that follows `By the x strain` in the note about another fair way to rank, where it is one.
    pub other_order: Option<&'static str>,
    /// Function that computes its value.
    pub compute: fn(&OwnIndices<'_>) -> Figure,
}

/// All scores, in their order in documents.
pub const SCORES: &[&Score] = &[GSI, MEAN_GSI, OWN_GSI, MDRM_GSI];

/// Score by which locations are ranked.
pub const GSI: &Score = &Score {
    name: "gsi",
    unit: "percent",
    what: PerDirection {
        x: "100 times the first-order index of this location's own depth for the x strain at the centre.",
        y: "100 times the first-order index of this location's own depth for the y strain at the centre.",
    },
    has_error: true,
    other_order: None,
    compute: |own| Figure {
        value: own.at_centre().index,
        error: own.at_centre().error,
    },
};

/// Score over all locations.
pub const MEAN_GSI: &Score = &Score {
    name: "mean_gsi",
    unit: "percent",
    what: PerDirection {
        x: "Mean over the x strains at all locations.",
        y: "Mean over the y strains at all locations.",
    },
    has_error: false,
    other_order: Some(", averaged over all locations,"),
    compute: |own| {
        let known: Vec<f64> = own.everywhere.iter().filter_map(|own| own.index).collect();
        // From both ends at once: the mirror image's sum is the same to the bit.
        let pairs = || known.iter().zip(known.iter().rev());
        let mean = || pairs().map(|(a, b)| a + b).sum::<f64>() / (2 * known.len()) as f64;
        Figure::exact((!known.is_empty()).then(mean))
    },
};

/// Score at the location itself.
pub const OWN_GSI: &Score = &Score {
    name: "own_gsi",
    unit: "percent",
    what: PerDirection {
        x: "For the x strain at this location itself.",
        y: "For the y strain at this location itself.",
    },
    has_error: false,
    other_order: Some(" at each location itself"),
    compute: |own| Figure::exact(own.everywhere[own.location].index),
};

/// The paper's way.
pub const MDRM_GSI: &Score = &Score {
    name: "mdrm_gsi",
    unit: "percent",
    what: PerDirection {
        x: "Index by M-DRM for `gsi_x_percent`, valid or not: the paper's Table 2 as the paper computed it.",
        y: "Index by M-DRM for `gsi_y_percent`, valid or not: the paper's Table 2 as the paper computed it.",
    },
    has_error: false,
    other_order: None,
    compute: |own| Figure::exact(own.at_centre().mdrm_index),
};

impl Score {
    /// The name of its field in documents.
    pub fn field(&self, direction: Direction) -> String {
        format!("{}_{direction}_{}", self.name, self.unit)
    }

    /// The name of its error's field, where it has one.
    pub(crate) fn error_field(&self, direction: Direction) -> Option<String> {
        let field = || format!("{}_{direction}_error_{}", self.name, self.unit);
        self.has_error.then(field)
    }

    /// Returns what its error is, as documents describe it.
    pub(crate) fn what_of_error(&self, direction: Direction) -> String {
        format!("Error of `{}`, percentage points.", self.field(direction))
    }
}

/// A score's value with its error, where they are known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Figure {
    /// Value in the score's unit.
    pub value: Option<f64>,
    /// Error in the score's unit.
    pub error: Option<f64>,
}

impl Figure {
    fn exact(value: Option<f64>) -> Self {
        Self { value, error: None }
    }
}

/// Index of a location's own input by an output, percent.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OwnIndex {
    /// First-order index.
    pub index: Option<f64>,
    /// Error of the index.
    pub error: Option<f64>,
    /// Index by M-DRM, valid or not.
    pub mdrm_index: Option<f64>,
}

/// Indices of which a score is computed: one direction's outputs on one location's own input.
#[derive(Debug, Clone, Copy)]
pub struct OwnIndices<'o> {
    /// Indices by the outputs at P1, P2, ...
    pub everywhere: &'o [OwnIndex],
    /// Number of the location's own among them.
    pub location: usize,
}

impl OwnIndices<'_> {
    fn at_centre(&self) -> OwnIndex {
        self.everywhere[self.everywhere.len() / 2]
    }
}

/// The scores of a location, in the order of [`SCORES`].
#[derive(Debug, Clone, PartialEq)]
pub struct LocationScores(Vec<PerDirection<Figure>>);

impl LocationScores {
    /// Asks a function for each score and direction.
    pub fn of(figure: impl Fn(&Score, Direction) -> Figure) -> Self {
        let figures = |score: &&Score| PerDirection::of(|direction| figure(score, direction));
        Self(SCORES.iter().map(figures).collect())
    }

    /// A score's figures.
    pub fn of_score(&self, score: &Score) -> &PerDirection<Figure> {
        let place = SCORES.iter().position(|known| known.name == score.name);
        &self.0[place.expect("every score is in the table")]
    }

    /// The fields that they are in documents, in order.
    pub fn fields(&self) -> impl Iterator<Item = (String, Option<f64>)> + '_ {
        SCORES.iter().zip(&self.0).flat_map(|(score, figures)| {
            let value = |direction| (score.field(direction), figures[direction].value);
            let error = |direction| Some((score.error_field(direction)?, figures[direction].error));
            let errors = Direction::ALL.into_iter().filter_map(error);
            Direction::ALL.map(value).into_iter().chain(errors)
        })
    }
}
