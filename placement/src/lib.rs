//! From a study to ranked locations and layouts.
//!
//! The modules, in reading order, one arrow of the chain each:
//!
//! - [`study`]: the study document: what varies, what is asked
//! - [`plan`]: the design points of a study, a pure function of the document
//! - [`archive`]: where solved points are kept, so that none is solved twice
//! - [`run`]: solves the points that the archive lacks, on all cores
//! - [`result`]: the answer
//! - [`score`]: responses to indices per output
//! - [`rank`]: indices to ranked locations
//! - [`layout`]: strain rings to ranked layouts
