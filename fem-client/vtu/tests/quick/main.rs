//! Pictures of solved tires.

mod pictures;
