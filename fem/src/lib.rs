//! Nonlinear finite elements.
