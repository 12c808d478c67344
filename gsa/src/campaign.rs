//! Ask and tell: points out, values in, until the method has what it needs.
//!
//! A campaign's points only ever grow, and are a function of inputs, method and the values told: told the same, it asks the
//! same, so that a campaign can be replayed from its values at any time. Point 0 is the cut point, all inputs at their means.
//!
//! ```
//! use gsa::campaign::Campaign;
//! use gsa::distribution::Distribution;
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
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::design::{Design, DesignError, MAX_CHECK_POINTS};
use crate::form::corrected::Frame;
use crate::judge::index_error::{ByInput, ErrorParts};
use crate::law::distribution::Distribution;
use crate::method::analysis::{self, Analysis, Status};
use crate::method::auto::{self, Step};
use crate::method::bivariate::{self, PairGrid};
use crate::method::pce::{self, Chaos};
use crate::method::saltelli;
use crate::method::scattered;
use crate::method::{Kind, Method};

/// The runs a method asks for, and what it makes of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Campaign {
    inputs: Vec<Distribution>,
    method: Method,
    rng: ChaCha8Rng,
    runs: Runs,
    /// whether the tolerance was met before the last points were asked for
    confirmed: bool,
}

/// Analyses one output.
type Answer<'a> = Box<dyn Fn(&[f64]) -> Analysis + 'a>;

/// What was planned so far.
#[derive(Debug, Clone, PartialEq)]
enum Runs {
    Lines(Design),
    Pairs(Design, Vec<PairGrid>),
    Scattered(Vec<Vec<f64>>),
}

impl Campaign {
    /// # Errors
    /// A design that does not exist, or one beyond [`MAX_CHECK_POINTS`].
    pub fn new(inputs: &[Distribution], method: Method) -> Result<Self, DesignError> {
        let mut rng = ChaCha8Rng::seed_from_u64(method.seed);
        let runs = first_runs(inputs, &method, &mut rng)?;
        Ok(Self {
            inputs: inputs.to_vec(),
            method,
            rng,
            runs,
            confirmed: false,
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

    /// All points so far, in the inputs' units.
    pub fn points(&self) -> &[Vec<f64>] {
        match &self.runs {
            Runs::Lines(design) | Runs::Pairs(design, _) => design.points(),
            Runs::Scattered(points) => points,
        }
    }

    /// The lines through the cut point, for methods that have them.
    pub fn design(&self) -> Option<&Design> {
        match &self.runs {
            Runs::Lines(design) | Runs::Pairs(design, _) => Some(design),
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
        let analyses = self.analyse(values)?;
        if let (Kind::Auto, Runs::Lines(design)) = (self.method.kind, &mut self.runs) {
            match auto::next_step(design, &analyses, &self.method, &mut self.confirmed) {
                None => {}
                Some(Step::Check(count)) => {
                    design.add_checks(count, &mut self.rng)?;
                }
                Some(Step::Refine(inputs)) => {
                    for (input, nodes) in inputs {
                        // A law may have no rule of so many nodes: its line then stays as it is.
                        let _ = design.refine(input, nodes);
                    }
                }
            }
        }
        Ok(analyses)
    }

    /// The laws of the inputs.
    pub fn inputs(&self) -> &[Distribution] {
        &self.inputs
    }

    /// What follows from the values at all points, without asking for more.
    ///
    /// # Errors
    /// Polynomials of a law that do not exist.
    ///
    /// # Panics
    /// If the number of rows is not the number of points.
    pub fn analyse(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        let (rows, points) = (values.nrows(), self.points().len());
        assert!(rows == points, "{rows} rows of values for {points} points");
        if let (Kind::Mdrm, Runs::Lines(design)) = (self.method.kind, &self.runs) {
            return Ok(analysis::analyse(design, values));
        }
        let each: Answer<'_> = match &self.runs {
            Runs::Lines(design) => {
                let frame = Frame::new(design);
                let tolerance = match self.method.kind {
                    Kind::Tensor => None,
                    _ => Some(self.method.tolerance),
                };
                Box::new(move |values| auto::analyse(design, &frame, values, tolerance))
            }
            Runs::Pairs(design, grids) => {
                let frame = Frame::new(design);
                Box::new(move |values| bivariate::answer(design, &frame, grids, values))
            }
            Runs::Scattered(_) if self.method.kind == Kind::Saltelli => {
                let inputs = self.inputs.len();
                Box::new(move |values| scattered::saltelli(inputs, values))
            }
            Runs::Scattered(points) => {
                let chaos = Chaos::new(&self.inputs, points)
                    .map_err(|(input, source)| DesignError::Rule { input, source })?;
                Box::new(move |values| scattered::pce(&chaos, values))
            }
        };
        let by_output = values.t().as_standard_layout().into_owned();
        let slices = by_output.rows().into_iter();
        Ok(slices
            .map(|row| each(row.as_slice().expect("standard layout")))
            .map(|analysis| self.without_verdict(analysis))
            .map(|analysis| self.of_one_input(analysis))
            .collect())
    }

    /// The same for outputs by the thousand that the campaign wasn't asked to serve. The adaptive method then gives the best form on
    /// its lines, in milliseconds: its check points show that form's error, and aren't used to correct it.
    ///
    /// # Errors
    /// As [`Campaign::analyse`].
    ///
    /// # Panics
    /// As [`Campaign::analyse`].
    pub fn survey(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        match (self.method.kind, &self.runs) {
            (Kind::Auto, Runs::Lines(design)) => Ok(analysis::analyse(design, values)),
            _ => self.analyse(values),
        }
    }

    /// A method that doesn't rest on the product form isn't broken with it.
    fn without_verdict(&self, analysis: Analysis) -> Analysis {
        let indexed = analysis.first_order.is_some();
        match (self.method.kind, analysis.status) {
            (Kind::Tensor | Kind::Bivariate, Status::ProductFormBroken) if indexed => Analysis {
                status: Status::Ok,
                ..analysis
            },
            _ => analysis,
        }
    }
}

impl Campaign {
    /// A single input has all of the variance, whatever a method's sums say.
    fn of_one_input(&self, analysis: Analysis) -> Analysis {
        if self.inputs.len() > 1 || analysis.first_order.is_none() {
            return analysis;
        }
        let none = Some(vec![0.0]);
        let parts = ByInput {
            quadrature: analysis.error.quadrature.and(none.clone()),
            decomposition: analysis.error.decomposition.and(none.clone()),
            sampling: analysis.error.sampling.and(none),
            ..ByInput::default()
        };
        Analysis {
            first_order: Some(vec![1.0]),
            total: Some(vec![1.0]),
            error: ErrorParts::new(parts, analysis.error.floor),
            ..analysis
        }
    }
}

fn first_runs(
    inputs: &[Distribution],
    method: &Method,
    rng: &mut ChaCha8Rng,
) -> Result<Runs, DesignError> {
    let lines =
        |checks: usize, rng: &mut ChaCha8Rng| Design::new(inputs, method.nodes, checks, rng);
    if inputs.is_empty() {
        return Err(DesignError::NoInputs);
    }
    let too_many = |asked: usize| Err(DesignError::TooManyCheckPoints { asked });
    Ok(match method.kind {
        Kind::Mdrm => Runs::Lines(lines(method.check_points, rng)?),
        Kind::Auto => Runs::Lines(lines(method.check_points, rng)?.refined_on_demand()),
        Kind::Tensor => {
            let mut design = lines(0, rng)?;
            let all = design.off_axis_len();
            if all > MAX_CHECK_POINTS {
                return too_many(all);
            }
            design.add_checks(all, rng)?;
            design.add_probes(method.check_points, rng);
            Runs::Lines(design)
        }
        Kind::Bivariate => {
            let pairs = inputs.len().saturating_mul(inputs.len() - 1) / 2;
            let asked = pairs.saturating_mul(method.nodes * method.nodes);
            if asked > MAX_CHECK_POINTS {
                return too_many(asked);
            }
            let mut design = lines(method.check_points, rng)?;
            let grids = bivariate::add_pairs(&mut design);
            design.add_probes(method.check_points, rng);
            Runs::Pairs(design, grids)
        }
        Kind::Pce if method.samples > MAX_CHECK_POINTS => return too_many(method.samples),
        Kind::Pce => {
            // Whether the laws have the polynomials is known now, not after the runs.
            Chaos::new(inputs, &[])
                .map_err(|(input, source)| DesignError::Rule { input, source })?;
            Runs::Scattered(pce::points(inputs, method.samples, method.seed))
        }
        Kind::Saltelli => {
            let asked = method.samples.saturating_mul(inputs.len() + 2);
            if asked > 10 * MAX_CHECK_POINTS {
                return too_many(asked);
            }
            Runs::Scattered(saltelli::points(inputs, method.samples, method.seed))
        }
    })
}
