//! The installed CalculiX, which takes seconds a run.

mod installed;
