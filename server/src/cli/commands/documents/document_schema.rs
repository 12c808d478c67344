//! `strainsite schema`: what a document may say, for editors and checkers.

use clap::Args;
use clap::builder::PossibleValuesParser;
use documents::schemas::DocumentKind;

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::print;

/// Print the JSON Schema of a document, for editors and checkers
#[derive(Debug, Args)]
pub struct Schema {
    /// Document
    #[arg(value_parser = PossibleValuesParser::new(DocumentKind::ALL.map(DocumentKind::as_str)))]
    document: String,
}

impl Schema {
    /// Prints it.
    pub fn execute(&self) -> Result<(), Failure> {
        let kind = DocumentKind::named(&self.document)
            .ok_or_else(|| Failure::other("there is no such document"))?;
        let text = serde_json::to_string_pretty(&kind.schema()).map_err(Failure::other)?;
        print(&format!("{text}\n"))
    }
}
