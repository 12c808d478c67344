//! Tables and formats to choose from, and why a file can't be made.

use serde::Deserialize;
use utoipa::ToSchema;

/// Table of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, ToSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Table {
    /// Indices of every strain with their errors: one row per location, direction and input.
    Indices,
    /// Ranked locations.
    Locations,
    /// Ranked layouts.
    Layouts,
    /// Best layout of each number of films.
    Trade,
    /// Films of the answer, one by one: what to glue by.
    Films,
    /// Solved points: inputs, force, strains.
    Points,
    /// Readings of films by loads, pressures and contact angles.
    Signals,
    /// Kinds of film for layouts, by several criteria.
    Candidates,
    /// Errors of each force by each layout, with a virtual rig.
    Forces,
}

impl Table {
    const ALL: [Self; 9] = [
        Self::Indices,
        Self::Locations,
        Self::Layouts,
        Self::Trade,
        Self::Films,
        Self::Points,
        Self::Signals,
        Self::Candidates,
        Self::Forces,
    ];

    /// The name in addresses and file names.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Indices => "indices",
            Self::Locations => "locations",
            Self::Layouts => "layouts",
            Self::Trade => "trade",
            Self::Films => "films",
            Self::Points => "points",
            Self::Signals => "signals",
            Self::Candidates => "candidates",
            Self::Forces => "forces",
        }
    }

    /// The table of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|table| table.as_str() == name)
    }
}

/// Format of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, ToSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum FileFormat {
    /// Comma-separated values, one table.
    Csv,
    /// The whole result.
    Json,
    /// Parquet, one table with typed columns, for data frames.
    Parquet,
    /// The map on the inner surface, for ParaView.
    Vtu,
    /// Both skins of the whole wheel as glTF 2.0, for any viewer.
    Glb,
    /// Films of the answer on the unrolled inner surface, at 1:1 when printed: a template to glue by.
    Svg,
}

impl FileFormat {
    const ALL: [Self; 6] = [
        Self::Csv,
        Self::Json,
        Self::Parquet,
        Self::Vtu,
        Self::Glb,
        Self::Svg,
    ];

    /// The name in addresses, and the ending of file names.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Parquet => "parquet",
            Self::Vtu => "vtu",
            Self::Glb => "glb",
            Self::Svg => "svg",
        }
    }

    /// The format of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.as_str() == name)
    }

    /// The media type. None is registered for VTK's formats; a VTU file is well-formed XML.
    pub fn media_type(self) -> &'static str {
        match self {
            Self::Csv => "text/csv; charset=utf-8",
            Self::Json => "application/json",
            Self::Parquet => "application/vnd.apache.parquet",
            Self::Vtu => "application/xml",
            Self::Glb => "model/gltf-binary",
            Self::Svg => "image/svg+xml",
        }
    }

    /// Whether a table has to be chosen.
    pub fn has_tables(self) -> bool {
        matches!(self, Self::Csv | Self::Parquet)
    }

    /// Whether people can read it on a terminal.
    pub fn is_text(self) -> bool {
        matches!(self, Self::Csv | Self::Json)
    }
}

/// A file that can't be made.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The study has no map.
    #[error("this study has no map: its document asks for no candidates.grid")]
    NoMap,
    /// The answer has no layout.
    #[error("this study's answer has no films: its document asks for no layouts")]
    NoFilms,
    /// A result with nothing to draw the wheel from.
    #[error(
        "no state of a mesh is stored for this study's cut point: another solver found it, or another version's mesh"
    )]
    NoMesh,
    /// The map isn't one.
    #[error("the VTU file can't be made: {0}")]
    Vtu(#[from] vtu::VtuError),
    /// The writer of Parquet failed.
    #[error("the Parquet file can't be made: {0}")]
    Parquet(#[from] ::parquet::errors::ParquetError),
    /// The result can't be written as JSON.
    #[error("the result can't be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
}
