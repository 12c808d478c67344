//! Studies that are solved with finite elements.

mod effects;
mod layouts;
