//! Forces from recordings: recipes and recordings of users in, estimators, reports and estimates out.
//!
//! - [`recorded_texts`]: recordings from their texts
//! - [`look`]: what stands in them, before anything is learnt
//! - [`fit_forecast`]: how long a fit takes; `fit_memory`: how much memory
//! - [`submission_reader`]: recipe and recordings in one document
//! - [`fitting`]: learns an estimator on all cores; [`fit_process`]: the same in a process of its own
//! - [`model_file`]: estimators as texts
//! - [`applying`]: estimates of a recording, whole or row by row; [`streamed_lines`]: of a stream that goes on whatever a row is like
//! - [`rig_recording`]: recordings of a virtual rig on a study's layout
//! - [`estimator_queue`]: the line of estimators that the service learns; `learning`: one of them; `learnt_parts`: what is kept of it

pub mod applying;
pub mod estimator_queue;
pub mod fit_forecast;
pub(crate) mod fit_memory;
pub mod fit_process;
pub mod fitting;
pub(crate) mod learning;
pub(crate) mod learnt_parts;
pub mod look;
pub mod model_file;
pub mod recorded_texts;
pub mod rig_recording;
pub mod streamed_lines;
pub mod submission_reader;
