//! Stretches of a surface, recovered where a film would sit.
//!
//! A stretch follows from the displacements of the surface itself: with the surface in a chart (s1, s2) of orthogonal
//! coordinate lines, lambda_k = |dx/ds_k| / |dX/ds_k|. These derivatives jump between faces and are most accurate at the
//! Gauss points of one order less (2 x 2 on a 9-node face, the centre of a 4-node face). Around each corner of the
//! mesh a polynomial is fitted to those values (superconvergent patch recovery, O. C. Zienkiewicz and J. Z. Zhu, Int. J. Numer.
//! Meth. Engng 33 (1992) 1331); within a face the polynomials of its corners are blended bilinearly. Faces beyond a
//! symmetry line take part as mirror images.
//!
//! - `coordinates`: the chart
//! - `corners`: which faces meet at which corner
//! - `patch`: a polynomial around a corner
//! - `recovery`: stretches of one state

mod coordinates;
mod corners;
mod patch;
mod recovery;

pub use coordinates::Chart;
pub use recovery::Recovery;
