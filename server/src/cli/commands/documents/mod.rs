//! Documents by themselves, without running them.

mod document_schema;
mod validate;

pub use document_schema::Schema;
pub(crate) use validate::Validate;
