//! The embedded solver against limit cases and symmetries, and what its version stands for.

mod foot_tire;
mod solver_sources;
mod whole_tire;
