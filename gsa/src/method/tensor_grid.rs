//! `tensor`: the whole grid of all inputs' nodes, and points off the nodes that see whether these resolve the model.

use ndarray::ArrayView2;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::design::{Design, DesignError, MAX_CHECK_POINTS};
use crate::form::corrected::Frame;
use crate::law::distribution::Distribution;
use crate::method::Method;
use crate::method::analysis::{Analysis, each_output};
use crate::method::correction;
use crate::method::procedure::{Procedure, Runs};

/// A design whose check points fill the grid.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tensor {
    design: Design,
}

impl Procedure for Tensor {
    fn begin(inputs: &[Distribution], settings: &Method) -> Result<Self, DesignError> {
        let mut rng = ChaCha8Rng::seed_from_u64(settings.seed);
        let mut design = Design::new(inputs, settings.nodes, 0, &mut rng)?;
        let all = design.off_axis_len();
        if all > MAX_CHECK_POINTS {
            return Err(DesignError::TooManyCheckPoints { asked: all });
        }
        design.add_checks(all, &mut rng)?;
        design.add_probes(settings.check_points, &mut rng);
        Ok(Self { design })
    }

    fn most_first_points(inputs: usize, settings: &Method) -> usize {
        let power = u32::try_from(inputs).unwrap_or(u32::MAX);
        let grid = settings.nodes.saturating_pow(power);
        Design::most_line_points(inputs, settings.nodes).saturating_add(grid)
    }

    fn runs(&self) -> Runs<'_> {
        Runs::Lines(&self.design)
    }

    fn on(&self, design: Design) -> Option<Box<dyn Procedure>> {
        Some(Box::new(Self { design }))
    }

    fn analyse(&self, values: &ArrayView2<f64>) -> Result<Vec<Analysis>, DesignError> {
        let frame = Frame::new(&self.design);
        Ok(each_output(values, |values| {
            let analysis = correction::best(&self.design, &frame, values, None);
            analysis.without_verdict().of_one_input()
        }))
    }
}
