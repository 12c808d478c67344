//! Contract of the methods: their points, more of them once there are values, and what follows from the values.

use std::any::Any;
use std::fmt::Debug;

use ndarray::{ArrayView1, ArrayView2};

use crate::design::{Design, DesignError};
use crate::law::distribution::Distribution;
use crate::method::Method;
use crate::method::analysis::Analysis;

/// Runs as they were planned.
pub(crate) enum Runs<'a> {
    /// runs on lines through the cut point, and whatever else is in their design
    Lines(&'a Design),
    /// anywhere, in the inputs' units
    Scattered(&'a [Vec<f64>]),
}

impl Runs<'_> {
    /// Adds to each output's errors what it may do where its runs failed.
    pub(crate) fn judged(
        &self,
        analyses: Vec<Analysis>,
        values: &ArrayView2<f64>,
    ) -> Vec<Analysis> {
        let of_output = |(analysis, column): (Analysis, ArrayView1<f64>)| {
            analysis.with_failed(self, &column.to_vec())
        };
        let columns = values.columns().into_iter();
        analyses.into_iter().zip(columns).map(of_output).collect()
    }
}

/// A method at work: what it has planned so far, and how it analyses outputs. Its points only grow, and are a function of inputs,
/// settings and the values told.
pub(crate) trait Procedure: Any + Debug + Send + Sync + Boxed {
    /// Plans the first points, of which point 0 is the cut point. There is at least one input.
    fn begin(inputs: &[Distribution], settings: &Method) -> Result<Self, DesignError>
    where
        Self: Sized;

    /// Returns how many points [`Procedure::begin`] plans beside check points, or somewhat more, saturating.
    fn most_first_points(inputs: usize, settings: &Method) -> usize
    where
        Self: Sized;

    /// Whether the points asked for depend on values of earlier ones.
    fn is_adaptive() -> bool
    where
        Self: Sized,
    {
        false
    }

    /// Samples where nobody says how many.
    fn default_samples() -> usize
    where
        Self: Sized,
    {
        200
    }

    /// All runs so far.
    fn runs(&self) -> Runs<'_>;

    /// Returns the procedure on a design that has further points behind its own; `None` for methods without lines.
    fn on(&self, _design: Design) -> Option<Box<dyn Procedure>> {
        None
    }

    /// Adds the points that it needs beyond those analysed, if any.
    fn extend(&mut self, _analyses: &[Analysis]) -> Result<(), DesignError> {
        Ok(())
    }

    /// Analyses every output: a row per point, a column per output.
    fn analyse(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError>;

    /// Analyses outputs by the thousand that the points weren't chosen for.
    fn survey(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        self.analyse(values)
    }
}

/// Copies and compares procedures of unknown type.
pub(crate) trait Boxed {
    fn boxed(&self) -> Box<dyn Procedure>;
    fn equals(&self, other: &dyn Procedure) -> bool;
}

impl<P: Procedure + Clone + PartialEq> Boxed for P {
    fn boxed(&self) -> Box<dyn Procedure> {
        Box::new(self.clone())
    }

    fn equals(&self, other: &dyn Procedure) -> bool {
        let other: &dyn Any = other;
        other.downcast_ref() == Some(self)
    }
}

impl Clone for Box<dyn Procedure> {
    fn clone(&self) -> Self {
        (**self).boxed()
    }
}
