//! The embedded solver against limit cases and symmetries, and what its version stands for.

mod dragged_ground;
mod foot_tire;
mod ground_profiles;
mod leaning_wheel;
mod pressed_by_force;
mod solver_sources;
mod whole_tire;
