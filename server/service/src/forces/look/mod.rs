//! Recordings before anything is learnt from them.
//!
//! - [`looking`]: what their columns are taken for, and what stands in them; `column_looks`: the columns of one
//! - [`converting`]: a recording in the usual form
//! - `suspect_note`: samples that a fit holds for no measurements

mod column_looks;
pub mod converting;
pub mod looking;
pub(crate) mod suspect_note;
