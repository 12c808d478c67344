//! What layouts have solved: [`layout_scenes`], their answers as fields ([`layout_fields`]), and the result filled in ([`measuring_layouts`]).

pub mod layout_fields;
pub mod layout_scenes;
pub mod measuring_layouts;
