//! Pictures of solved tires.

mod pictures;
mod skins;
