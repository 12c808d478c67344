//! Studies, sweeps and estimators by what people write: `latest`, or the beginning of an identifier.

use sqlx::{AssertSqlSafe, SqliteConnection};

use crate::StoreError;

/// Name of the one that was submitted last.
pub const LATEST: &str = "latest";

/// Table whose rows have identifiers that are ordered by time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Listing {
    /// Studies.
    Studies,
    /// Sweeps.
    Sweeps,
    /// Estimators of forces.
    Estimators,
}

impl Listing {
    /// The table's name, as in addresses.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Studies => "studies",
            Self::Sweeps => "sweeps",
            Self::Estimators => "estimators",
        }
    }

    /// Name of one of them.
    pub fn one(self) -> &'static str {
        match self {
            Self::Studies => "study",
            Self::Sweeps => "sweep",
            Self::Estimators => "estimator",
        }
    }
}

/// Identifiers that are meant, two at most: the latest, or those that begin so; one that is it exactly is the only one.
///
/// # Errors
/// When the database can't be read.
pub async fn meant(
    connection: &mut SqliteConnection,
    listing: Listing,
    written: &str,
) -> Result<Vec<String>, StoreError> {
    let table = listing.as_str();
    let query = if written == LATEST {
        format!("select id from {table} order by id desc limit 1")
    } else {
        // By a range, which the index finds: hexadecimal digits and hyphens stand before the tilde.
        format!("select id from {table} where id >= ?1 and id < ?1 || '~' order by id limit 2")
    };
    let found: Vec<(String,)> = sqlx::query_as(AssertSqlSafe(query))
        .bind(written)
        .fetch_all(connection)
        .await?;
    let mut found: Vec<String> = found.into_iter().map(|(id,)| id).collect();
    if found.first().is_some_and(|first| first == written) {
        found.truncate(1);
    }
    Ok(found)
}
