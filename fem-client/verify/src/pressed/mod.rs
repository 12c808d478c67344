//! Bodies pressed on a rigid plane: by `plate`, against Hertz (`hertz`, `leaning`) and another code (`ring`).

pub(crate) mod hertz;
pub(crate) mod leaning;
mod plate;
pub(crate) mod ring;
