//! Studies that are given to another machine, as a database of their own.

use std::path::Path;

use serde_json::json;
use sqlx::{Connection, SqliteConnection};

use super::target::Merging;
use crate::Store;
use crate::store_error::StoreError;

/// Studies as they were submitted, in the queue.
const STUDIES: &str =
    "insert into other.studies (id, name, spec, spec_sha256, state, priority, place, created)
     select id, name, spec, spec_sha256, 'queued', priority, place, created
     from main.studies where id in (select value from json_each(?))";
const EVENTS: &str = "insert into other.events (study, kind, payload, created)
     select study, kind, payload, min(created) from main.events
     where kind = 'queued' and study in (select value from json_each(?)) group by study";
/// Points that needn't be solved again.
const POINTS: [&str; 3] = [
    "insert into other.evaluations select * from main.evaluations where key in (select value from json_each(?))",
    "insert into other.strain_fields select * from main.strain_fields where key in (select value from json_each(?))",
    "insert into other.start_states select * from main.start_states where key in (select value from json_each(?))",
];

impl Merging {
    /// Writes a new database with these studies, all in the queue, and with those of these points that are here.
    ///
    /// # Errors
    /// When it is there already, or can't be written.
    pub async fn give(
        &mut self,
        file: &Path,
        studies: &[String],
        keys: &[String],
    ) -> Result<(), StoreError> {
        let refused = |cause: &str| StoreError::Copy {
            path: file.to_owned(),
            cause: cause.to_owned(),
        };
        if file.exists() {
            return Err(refused("there is one already"));
        }
        Store::open(file).await?.close().await?;
        let name = file.to_str();
        let name = name.ok_or_else(|| refused("its path isn't UTF-8"))?;
        let mut writer = self.writer().await?;
        writer.attach(name).await?;
        let given = fill(writer.connection(), studies, keys).await;
        writer.detach().await?;
        given?;
        // Opened once more its rows have their seals.
        Store::open(file).await?.close().await
    }
}

async fn fill(
    connection: &mut SqliteConnection,
    studies: &[String],
    keys: &[String],
) -> Result<(), StoreError> {
    let [studies, keys] = [studies, keys].map(|list| json!(list).to_string());
    let mut transaction = connection.begin().await?;
    let of_studies = [STUDIES, EVENTS].map(|statement| (statement, &studies));
    let of_points = POINTS.map(|statement| (statement, &keys));
    for (statement, list) in of_studies.into_iter().chain(of_points) {
        let filled = sqlx::query(statement).bind(list);
        filled.execute(&mut *transaction).await?;
    }
    Ok(transaction.commit().await?)
}
