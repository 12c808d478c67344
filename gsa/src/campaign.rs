//! Ask and tell: points out, values in, until the method has what it needs.
//!
//! A campaign's points only ever grow, and are a function of inputs, method and the values told, so that a campaign can be
//! replayed from its values at any time. Point 0 is the cut point, all inputs at their means.
//!
//! ```
//! use gsa::campaign::Campaign;
//! use gsa::law::distribution::Distribution;
//! use gsa::method::{Kind, Method};
//! use ndarray::Array2;
//!
//! let inputs = vec![Distribution::uniform(-1.0, 1.0)?; 3];
//! let model = |x: &[f64]| x[0] + x[1] * x[1] + 2.0 * x[0] * x[2];
//! let mut campaign = Campaign::new(&inputs, Method::of(Kind::Auto))?;
//! let found = loop {
//!     let values: Vec<f64> = campaign.points().iter().map(|x| model(x)).collect();
//!     let values = Array2::from_shape_vec((values.len(), 1), values)?;
//!     let found = campaign.tell(&values.view())?;
//!     if campaign.points().len() == values.nrows() {
//!         break found;
//!     }
//! };
//! // Var = 1/3 + 4/45 + 4/9
//! let first_order = found[0].first_order.as_ref().ok_or("no indices")?;
//! assert!((first_order[0] - (1.0 / 3.0) / (1.0 / 3.0 + 4.0 / 45.0 + 4.0 / 9.0)).abs() < 0.02);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use ndarray::{ArrayView2, Axis, Slice};

use crate::design::{Design, DesignError};
use crate::law::distribution::Distribution;
use crate::method::Method;
use crate::method::analysis::Analysis;
use crate::method::procedure::{Procedure, Runs};

/// The runs a method asks for, and what it makes of them.
#[derive(Debug, Clone)]
pub struct Campaign {
    inputs: Vec<Distribution>,
    method: Method,
    procedure: Box<dyn Procedure>,
}

impl PartialEq for Campaign {
    fn eq(&self, other: &Self) -> bool {
        self.inputs == other.inputs
            && self.method == other.method
            && self.procedure.equals(&*other.procedure)
    }
}

impl Campaign {
    /// # Errors
    /// A design that does not exist, or one beyond [`MAX_CHECK_POINTS`](crate::design::MAX_CHECK_POINTS).
    pub fn new(inputs: &[Distribution], method: Method) -> Result<Self, DesignError> {
        if inputs.is_empty() {
            return Err(DesignError::NoInputs);
        }
        Ok(Self {
            inputs: inputs.to_vec(),
            method,
            procedure: method.begin(inputs)?,
        })
    }

    /// The campaign that asked for the points behind these values, one row each in the points' order; rows that it would
    /// ask for next are among its points, and more rows than it asks for are ignored.
    ///
    /// # Errors
    /// As [`Campaign::new`].
    pub fn replay(
        inputs: &[Distribution],
        method: Method,
        values: &ArrayView2<f64>,
    ) -> Result<(Self, Option<Vec<Analysis>>), DesignError> {
        let mut campaign = Self::new(inputs, method)?;
        let mut found = None;
        loop {
            let asked = campaign.points().len();
            if values.nrows() < asked {
                return Ok((campaign, found));
            }
            found = Some(campaign.tell(&values.slice_axis(Axis(0), Slice::from(..asked)))?);
            if campaign.points().len() == asked {
                return Ok((campaign, found));
            }
        }
    }

    /// The laws of the inputs.
    pub fn inputs(&self) -> &[Distribution] {
        &self.inputs
    }

    pub(crate) fn procedure(&self) -> &dyn Procedure {
        &*self.procedure
    }

    /// All points so far, in the inputs' units.
    pub fn points(&self) -> &[Vec<f64>] {
        match self.procedure.runs() {
            Runs::Lines(design) => design.points(),
            Runs::Scattered(points) => points,
        }
    }

    /// The lines through the cut point, for methods that have them.
    pub fn design(&self) -> Option<&Design> {
        match self.procedure.runs() {
            Runs::Lines(design) => Some(design),
            Runs::Scattered(_) => None,
        }
    }

    /// Takes the values at all points, one row each and a column per output, NaN for a run that failed, and gives what
    /// follows from them. If that isn't good enough yet, there are more points afterwards.
    ///
    /// # Errors
    /// As [`Campaign::analyse`].
    ///
    /// # Panics
    /// If the number of rows is not the number of points.
    pub fn tell(&mut self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        self.check_rows(values);
        let analyses = self.procedure.analyse(values)?;
        // Failed runs are judged on the runs that were made, and don't ask for more: those would fail there, too.
        let judged = self.procedure.runs().judged(analyses.clone(), values);
        self.procedure.extend(&analyses)?;
        Ok(judged)
    }

    /// Returns what follows from the values at all points, without asking for more.
    ///
    /// # Errors
    /// Polynomials of a law that do not exist.
    ///
    /// # Panics
    /// If the number of rows is not the number of points.
    pub fn analyse(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        self.check_rows(values);
        let analyses = self.procedure.analyse(values)?;
        Ok(self.procedure.runs().judged(analyses, values))
    }

    /// Analyses as [`Campaign::analyse`] does, for outputs by the thousand that the campaign wasn't asked to serve. The adaptive method then gives
    /// the best form on its lines, in milliseconds: its check points show that form's error, and aren't used to correct it. Polynomial chaos fits the
    /// same few terms to all of them.
    ///
    /// # Errors
    /// As [`Campaign::analyse`].
    ///
    /// # Panics
    /// As [`Campaign::analyse`].
    pub fn survey(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        self.check_rows(values);
        let analyses = self.procedure.survey(values)?;
        Ok(self.procedure.runs().judged(analyses, values))
    }

    fn check_rows(&self, values: &ArrayView2<f64>) {
        let (rows, points) = (values.nrows(), self.points().len());
        assert!(rows == points, "{rows} rows of values for {points} points");
    }
}
