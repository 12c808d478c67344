//! Studies of the database side by side.

use placement::compare::Entry;
use serde_json::{Map, Value};
use sqlx::SqliteConnection;

use store::StoreError;
use store::answers::result_rows;
use store::queue::design_rows::DesignRow;
use store::queue::study_rows::StudyRow;

/// A study as it is compared, under this name.
///
/// # Errors
/// [`StoreError::Damaged`] when its result doesn't match its hash; when the database can't be read.
async fn entry(
    connection: &mut SqliteConnection,
    study: &StudyRow,
    name: &str,
    set: Option<&Map<String, Value>>,
) -> Result<Entry, StoreError> {
    let found = result_rows::comparable(connection, &study.id).await?;
    let state = study.state().as_str();
    let without = || match &study.error {
        Some(error) => error.clone(),
        None => format!("it is {state}"),
    };
    Ok(Entry {
        id: study.id.clone(),
        name: name.to_owned(),
        set: set.cloned(),
        state: state.to_owned(),
        result: found.ok_or_else(without),
    })
}

/// Studies as they are compared, in their order.
///
/// # Errors
/// [`StoreError::Damaged`] when a result doesn't match its hash; when the database can't be read.
pub async fn of_studies(
    connection: &mut SqliteConnection,
    studies: &[StudyRow],
) -> Result<Vec<Entry>, StoreError> {
    let mut entries = Vec::new();
    for study in studies {
        entries.push(entry(connection, study, &study.name, None).await?);
    }
    Ok(entries)
}

/// The designs of a sweep as they are compared, in their order.
///
/// # Errors
/// As for [`of_studies`].
pub async fn of_designs(
    connection: &mut SqliteConnection,
    designs: &[DesignRow],
) -> Result<Vec<Entry>, StoreError> {
    let mut entries = Vec::new();
    for design in designs {
        let set = Some(&design.set);
        entries.push(entry(connection, &design.study, &design.name, set).await?);
    }
    Ok(entries)
}
