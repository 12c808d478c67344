//! Global sensitivity analysis for models too expensive to run often.
//!
//! Which uncertain input X_i moves an output Y = h(X_1, .., X_n), and by how much? The answer is Sobol's indices: the
//! share S_i of Var\[Y\] that X_i causes alone, and the share S_Ti it takes part in. The inputs are independent.
//!
//! This crate never calls a model. A [`design::Design`] lists the runs to make; whoever owns the model makes them, in
//! any order and anywhere; [`method::lines::analyse`] turns their values into indices with an error. So runs can be queued,
//! stored and resumed, and one set of runs serves thousands of outputs.
//!
//! The default method is multiplicative dimension reduction (Zhang and Pandey 2014): the output as a product of its sections
//! along the axes through a cut point, each integrated by a Gauss rule. Five inputs at five nodes take 21 runs. Extra
//! runs off the axes check the product, measure its error, and hand over to another form where it fails.
//! [`campaign::Campaign`] puts all methods behind one contract, among them one that climbs by itself until a tolerance is met.
//!
//! | symbol | meaning |
//! |---|---|
//! | n, N | number of inputs, nodes of each Gauss rule |
//! | x_j, w_j | nodes and weights (probabilities) of a rule |
//! | c, h0 | cut point, value there |
//! | h_i | section: the output along axis i through c |
//! | rho_i, v_i | mean and variance of section i |
//! | S_i, S_Ti | first-order and total index of input i |
//!
//! Folders in reading order; the page of each lists its modules:
//!
//! - [`law`]: the laws of the inputs and their Gauss rules
//! - [`design`]: the runs to make
//! - [`judge`]: errors of indices, and whether a place in a ranking is certain
//! - `form`: surrogates of an output on its lines
//! - [`method`]: the ways from runs to indices
//! - [`campaign`]: the way in; [`symmetric`]: the same for a model with a symmetry
//!
//! ```
//! use gsa::method::analysis::Status;
//! use gsa::method::lines::analyse;
//! use gsa::design::Design;
//! use gsa::law::distribution::Distribution;
//! use ndarray::Array2;
//! use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
//!
//! let inputs = [Distribution::normal(2.0, 0.2)?, Distribution::uniform(1.0, 3.0)?];
//! let design = Design::new(&inputs, 5, 4, &mut ChaCha8Rng::seed_from_u64(1))?;
//!
//! // The runs, here of y = x1 x2^2: one row per point, one column per output.
//! let model = |x: &Vec<f64>| x[0] * x[1] * x[1];
//! let values: Vec<f64> = design.points().iter().map(model).collect();
//! let values = Array2::from_shape_vec((values.len(), 1), values)?;
//!
//! let found = &analyse(&design, &values.view())[0];
//! assert_eq!(found.status, Status::Ok);
//! // E[y] = 2 (4 + 1/3)
//! assert!((found.mean.unwrap_or(0.0) - 26.0 / 3.0).abs() < 1e-13);
//! // q1 = (0.2/2)^2 = 0.01 and q2 = E[x2^4]/E[x2^2]^2 - 1 = (121/5)/(169/9) - 1 = 0.2888, so x2 dominates.
//! let q: [f64; 2] = [0.01, 121.0 * 9.0 / (5.0 * 169.0) - 1.0];
//! let whole = (1.0 + q[0]) * (1.0 + q[1]) - 1.0;
//! for (s, q) in found.first_order.iter().flatten().zip(q) {
//!     assert!((s - q / whole).abs() < 1e-13);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod campaign;
pub mod design;
mod exchange;
mod form;
pub mod judge;
pub mod law;
pub mod method;
pub mod symmetric;
