//! Studies that are solved with finite elements.

mod contacts;
mod effects;
mod film_points;
mod layouts;
mod menu;
