//! Choice of the procedure that carries out a kind: the one place that knows them all.

use crate::design::DesignError;
use crate::law::distribution::Distribution;
use crate::method::auto::Auto;
use crate::method::bivariate::Bivariate;
use crate::method::lines::Lines;
use crate::method::pce::Pce;
use crate::method::procedure::Procedure;
use crate::method::saltelli::Saltelli;
use crate::method::tensor_grid::Tensor;
use crate::method::{Kind, Method};

/// A procedure with its first points planned.
type Begun = Result<Box<dyn Procedure>, DesignError>;

/// Facts of a procedure that are known before it begins.
struct Choice {
    is_adaptive: bool,
    default_samples: usize,
    most_first_points: fn(usize, &Method) -> usize,
    begin: fn(&[Distribution], &Method) -> Begun,
}

impl Choice {
    fn of<P: Procedure>() -> Self {
        Self {
            is_adaptive: P::is_adaptive(),
            default_samples: P::default_samples(),
            most_first_points: P::most_first_points,
            begin: |inputs, settings| Ok(Box::new(P::begin(inputs, settings)?)),
        }
    }
}

fn choice(kind: Kind) -> Choice {
    match kind {
        Kind::Mdrm => Choice::of::<Lines>(),
        Kind::Bivariate => Choice::of::<Bivariate>(),
        Kind::Tensor => Choice::of::<Tensor>(),
        Kind::Pce => Choice::of::<Pce>(),
        Kind::Saltelli => Choice::of::<Saltelli>(),
        Kind::Auto => Choice::of::<Auto>(),
    }
}

impl Kind {
    /// Whether the points asked for depend on values of earlier ones.
    pub fn is_adaptive(self) -> bool {
        choice(self).is_adaptive
    }
}

impl Method {
    /// The kind with its default settings.
    pub fn of(kind: Kind) -> Self {
        Self {
            kind,
            nodes: 5,
            check_points: 5,
            samples: choice(kind).default_samples,
            seed: 1,
            tolerance: 0.02,
            most_runs: 1000,
        }
    }

    /// Returns how many points it asks for at first of a model of so many inputs, or somewhat more: known without planning them.
    pub fn first_points(&self, inputs: usize) -> usize {
        let points = (choice(self.kind).most_first_points)(inputs, self);
        // Grids are checked on their lines and off their nodes.
        points.saturating_add(self.check_points.saturating_mul(2))
    }

    pub(crate) fn begin(&self, inputs: &[Distribution]) -> Begun {
        (choice(self.kind).begin)(inputs, self)
    }
}
