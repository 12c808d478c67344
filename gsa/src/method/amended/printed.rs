//! Printed values: what their digits leave open in an analysis.

use crate::judge::printed_digits::{self, Growth};
use crate::method::analysis::{Analysis, Form};

/// Share of the whole error from which the digits are named, and the least of such errors: half a hundredth of the variance.
const NOTABLE: f64 = 0.5;
const LEAST: f64 = 0.005;

impl Form {
    /// Growth of independent rounding errors of the values, of n inputs. A sum of sections has one at each section, and so to first order has
    /// a product; cut-HDMR of second order is sum_{i<j} h_ij - (n - 2) sum_i h_i, and of these terms n - 1 pairs and a section have input i.
    /// Whole grids and samples average.
    fn growth(self, inputs: usize) -> Growth {
        let n = inputs as f64;
        let (main, whole) = match self {
            Self::Mdrm | Self::Additive | Self::Shifted | Self::Corrected => (1.0, n),
            Self::Bivariate => {
                let sections = (n - 2.0).powi(2);
                (sections + n - 1.0, n * sections + 0.5 * n * (n - 1.0))
            }
            Self::Tensor | Self::Pce | Self::Saltelli => (1.0, 1.0),
        };
        Growth {
            main: main.sqrt(),
            whole: whole.sqrt(),
        }
    }
}

impl Analysis {
    /// Adds to the errors what values leave open that were printed to within `half_unit`, in the output's units: half a unit of their last digit.
    #[must_use]
    pub fn of_printed(mut self, half_unit: f64) -> Self {
        let several = |indices: &&Vec<f64>| indices.len() > 1;
        let Some(first_order) = self.first_order.as_ref().filter(several) else {
            return self;
        };
        // Beyond one it tells nothing more; a variance beyond double precision tells nothing at all.
        let share = (half_unit / self.variance.unwrap_or(0.0).sqrt()).min(1.0);
        let growth = self.method.growth(first_order.len());
        let errors = printed_digits::errors(first_order, share, growth);
        let added = self.error.add(&errors);
        self.error.rounding = Some(added);
        let total = self.error.total.unwrap_or(0.0);
        if added > LEAST.max(NOTABLE * total) {
            let spread = format!("{:.1e}", 2.0 * share);
            let steps = format!("{:.1e}", 2.0 * half_unit);
            self.note(&format!(
                "the values are printed in steps of {steps}, {spread} standard deviations, which is most of the error: print more digits"
            ));
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judge::index_error::{ByInput, ErrorParts};

    #[test]
    fn digits_that_are_most_of_an_error_are_named() {
        let parts = ByInput {
            decomposition: Some(vec![0.0, 0.0]),
            ..ByInput::default()
        };
        let found = Analysis {
            first_order: Some(vec![0.25, 0.5625]),
            variance: Some(4.0),
            error: ErrorParts::new(parts, 0.0),
            method: Form::Tensor,
            ..Analysis::empty(0.0)
        };
        let exact = found.clone().of_printed(0.0);
        assert_eq!((exact.error.total, exact.reason), (Some(0.0), None));
        // u/sigma = 0.1: (0.6/0.9)^2 - 0.25
        let printed = found.of_printed(0.2);
        let first = printed.error.by_input.unwrap()[0];
        assert!((first - (4.0 / 9.0 - 0.25)).abs() < 1e-15);
        assert!(
            printed
                .reason
                .unwrap()
                .contains("steps of 4.0e-1, 2.0e-1 standard deviations")
        );
    }

    #[test]
    fn sums_grow_with_their_sections_and_pairs_with_their_number() {
        let root = |x: f64| x.sqrt();
        let growth = |form: Form| (form.growth(4).main, form.growth(4).whole);
        assert_eq!(growth(Form::Additive), (1.0, 2.0));
        assert_eq!(growth(Form::Bivariate), (root(7.0), root(22.0)));
        assert_eq!(growth(Form::Tensor), (1.0, 1.0));
    }
}
