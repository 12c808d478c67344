//! Campaigns of models with a symmetry: each run tells the values at its mirror image too.
//!
//! Where inputs of equal laws can be exchanged and output j then answers what output p(j) answered before, a value at a point is also
//! known at the point's mirror image. So the check points count twice, at no cost, and an index of output j has one index of output p(j)
//! as its mirror image, equal to the bit with its error. The campaign asks for the points that it always asks for.
//!
//! ```
//! use gsa::campaign::Campaign;
//! use gsa::law::distribution::Distribution;
//! use gsa::method::{Kind, Method};
//! use ndarray::Array2;
//!
//! let inputs = vec![Distribution::uniform(0.7, 1.3)?; 3];
//! // Seen from either end: two outputs that are each other's mirror image, and one that is its own.
//! let left = |x: &[f64]| x[0] + 0.3 * x[0] * x[1] + 0.1 * x[2];
//! let model = |x: &[f64]| [left(x), x[0] * x[1] * x[2], left(&[x[2], x[1], x[0]])];
//! let campaign = Campaign::new(&inputs, Method::of(Kind::Mdrm))?;
//! let values: Vec<f64> = campaign.points().iter().flat_map(|x| model(x)).collect();
//! let values = Array2::from_shape_vec((values.len() / 3, 3), values)?;
//!
//! let exchange = [2, 1, 0];
//! let symmetric = campaign.symmetric(&exchange).ok_or("the inputs have different laws")?;
//! let found = symmetric.analyse(&values.view(), &exchange)?;
//! let errors = |output: usize| found[output].error.by_input.clone().unwrap_or_default();
//! assert_eq!(errors(0), [errors(2)[2], errors(2)[1], errors(2)[0]]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use ndarray::{Array2, ArrayView2};

use crate::campaign::Campaign;
use crate::design::DesignError;
use crate::exchange::mean;
use crate::method::analysis::Analysis;
use crate::method::procedure::{Procedure, Runs};

/// Campaign's runs of a model with a symmetry.
#[derive(Debug, Clone)]
pub struct Symmetric {
    inputs: Vec<usize>,
    /// Procedure with the mirror images among its points.
    procedure: Box<dyn Procedure>,
    /// Number of each point's mirror image, where there is one.
    images: Vec<Option<usize>>,
    /// Number of points that are run.
    to_run: usize,
}

impl Campaign {
    /// The campaign of a model in which input i can be exchanged with input `inputs[i]`, all at once; `None` where their laws differ, a
    /// line has been refined without its mirror image, or this is no exchange.
    pub fn symmetric(&self, inputs: &[usize]) -> Option<Symmetric> {
        let laws = self.inputs();
        let same = |(i, &j): (usize, &usize)| inputs.get(j) == Some(&i) && laws[i] == laws[j];
        if inputs.len() != laws.len() || !inputs.iter().enumerate().all(same) {
            return None;
        }
        let (procedure, images) = match self.procedure().runs() {
            Runs::Lines(design) => {
                let (whole, images) = design.with_images(inputs)?;
                (self.procedure().on(whole)?, images)
            }
            Runs::Scattered(points) => (self.procedure().boxed(), vec![None; points.len()]),
        };
        Some(Symmetric {
            inputs: inputs.to_vec(),
            procedure,
            images,
            to_run: self.points().len(),
        })
    }
}

impl Symmetric {
    /// Points that are run and each other's mirror image, or their own: where a model shows whether it has the symmetry.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let images = self.images.iter().take(self.to_run).enumerate();
        let pairs = images.filter_map(|(point, image)| Some((point, (*image)?)));
        pairs.filter(|(point, image)| point <= image && *image < self.to_run)
    }

    /// Analyses as [`Campaign::analyse`] does; output j and output `outputs[j]` are each other's mirror image.
    ///
    /// # Errors
    /// As [`Campaign::analyse`].
    ///
    /// # Panics
    /// If the number of rows is not the number of the campaign's points, or that of columns not the number of outputs.
    pub fn analyse(
        &self,
        values: &ArrayView2<f64>,
        outputs: &[usize],
    ) -> Result<Vec<Analysis>, DesignError> {
        let whole = self.with_images(values, outputs);
        let found = self.procedure.analyse(&whole.view())?;
        Ok(self.shared(found, &whole, outputs))
    }

    /// Surveys as [`Campaign::survey`] does, likewise.
    ///
    /// # Errors
    /// As [`Campaign::analyse`].
    ///
    /// # Panics
    /// As [`Symmetric::analyse`].
    pub fn survey(
        &self,
        values: &ArrayView2<f64>,
        outputs: &[usize],
    ) -> Result<Vec<Analysis>, DesignError> {
        let whole = self.with_images(values, outputs);
        let found = self.procedure.survey(&whole.view())?;
        Ok(self.shared(found, &whole, outputs))
    }

    /// The values at all points: those that are known twice are the mean of both, which differ by rounding or a solver's tolerance.
    fn with_images(&self, values: &ArrayView2<f64>, outputs: &[usize]) -> Array2<f64> {
        let (rows, columns) = values.dim();
        assert!(
            rows == self.to_run && columns == outputs.len(),
            "{rows} rows and {columns} columns of values for {} points and {} outputs",
            self.to_run,
            outputs.len()
        );
        Array2::from_shape_fn((self.images.len(), columns), |(point, output)| {
            let image = self.images[point].filter(|image| *image < rows);
            let own = (point < rows).then(|| values[(point, output)]);
            let other = image.map(|image| values[(image, outputs[output])]);
            match (own, other) {
                (Some(own), Some(other)) if own.is_finite() && other.is_finite() => {
                    mean(own, other)
                }
                (Some(own), Some(other)) if !own.is_finite() => other,
                (own, other) => own.or(other).unwrap_or(f64::NAN),
            }
        })
    }

    /// Gives mirror images one analysis.
    fn shared(
        &self,
        found: Vec<Analysis>,
        whole: &Array2<f64>,
        outputs: &[usize],
    ) -> Vec<Analysis> {
        let found = self.procedure.runs().judged(found, &whole.view());
        let pairs = found.iter().zip(outputs);
        pairs
            .map(|(own, &image)| own.mean_with(&found[image].mirrored(&self.inputs)))
            .collect()
    }
}
