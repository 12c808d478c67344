//! Films' signals of a study, as they are served.
//!
//! A hash over a study's rows and what they show tells when one is missing or isn't what was written.

use fem_client::solver::FilmCondition;
use fem_client::solver::direction::Direction;
use placement::result::{
    ClaimRow, FilmModel, FilmPair, SignalAxis, SignalCurve, SignalError, SignalRow, Signals,
    StressWidth,
};
use placement::study::{POSITIONS, position_name};
use serde::{Deserialize, Serialize};
use sqlx::SqliteConnection;

use crate::column::whole;
use crate::content::{encode, sha256};
use crate::row::from_row;
use crate::store_error::StoreError;

/// Stores the signals of a study's result.
///
/// # Errors
/// When the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    study: &str,
    signals: &Signals,
) -> Result<(), StoreError> {
    for (ordinal, row) in signals.rows.iter().enumerate() {
        insert_row(connection, study, ordinal, row).await?;
    }
    let findings = encode("what signals show", &Findings::of(signals))?;
    let rows_sha256 = hash(&findings, &rows(connection, study).await?);
    sqlx::query("insert into signal_findings (study, findings, rows_sha256) values (?, ?, ?)")
        .bind(study)
        .bind(findings)
        .bind(rows_sha256)
        .execute(connection)
        .await?;
    Ok(())
}

/// The signals of a study; `None` where its result has none, or there is no result.
///
/// # Errors
/// [`StoreError::Damaged`] when rows are missing or don't match their hash; when the database can't be read.
pub async fn find(
    connection: &mut SqliteConnection,
    study: &str,
) -> Result<Option<Signals>, StoreError> {
    let query = "select findings, rows_sha256 from signal_findings where study = ?";
    let stored: Option<(String, String)> = sqlx::query_as(query)
        .bind(study)
        .fetch_optional(&mut *connection)
        .await?;
    let rows = rows(connection, study).await?;
    let Some((findings, rows_sha256)) = stored else {
        return if rows.is_empty() {
            Ok(None)
        } else {
            Err(damaged(study))
        };
    };
    let intact = hash(&findings, &rows) == rows_sha256;
    let signals = intact.then(|| of_rows(&findings, &rows)).flatten();
    signals.map(Some).ok_or_else(|| damaged(study))
}

fn damaged(study: &str) -> StoreError {
    StoreError::Damaged {
        table: "signals",
        row: study.to_owned(),
    }
}

/// What the rows show.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Findings {
    curves: Vec<SignalCurve>,
    pairs: Vec<FilmPair>,
    widths: Vec<StressWidth>,
    claims: Vec<ClaimRow>,
}

impl Findings {
    fn of(signals: &Signals) -> Self {
        Self {
            curves: signals.curves.clone(),
            pairs: signals.pairs.clone(),
            widths: signals.widths.clone(),
            claims: signals.claims.clone(),
        }
    }
}

fn hash(findings: &str, rows: &[Row]) -> String {
    // Columns of text and numbers are always JSON.
    let text = serde_json::to_string(rows).unwrap_or_default();
    sha256(&[findings.as_bytes(), text.as_bytes()])
}

/// `None` where a row isn't one of this program's.
fn of_rows(findings: &str, rows: &[Row]) -> Option<Signals> {
    let Findings {
        curves,
        pairs,
        widths,
        claims,
    } = serde_json::from_str(findings).ok()?;
    Some(Signals {
        rows: rows.iter().map(Row::signal).collect::<Option<_>>()?,
        curves,
        pairs,
        widths,
        claims,
    })
}

#[derive(Serialize)]
struct Row {
    tire: String,
    film: String,
    position: String,
    direction: String,
    axis: String,
    load_n: f64,
    pressure_mpa: f64,
    contact_deg: f64,
    depth_mm: Option<f64>,
    strain: Option<f64>,
    tension_1_n_per_mm: Option<f64>,
    charge_nc: Option<f64>,
    open_circuit_v: Option<f64>,
    output_v: Option<f64>,
    output_std_v: Option<f64>,
    state: Option<String>,
    error_strain: Option<f64>,
    error_charge_nc: Option<f64>,
    error_open_circuit_v: Option<f64>,
    error_output_v: Option<f64>,
    reason: Option<String>,
}

from_row!(Row {
    tire,
    film,
    position,
    direction,
    axis,
    load_n,
    pressure_mpa,
    contact_deg,
    depth_mm,
    strain,
    tension_1_n_per_mm,
    charge_nc,
    open_circuit_v,
    output_v,
    output_std_v,
    state,
    error_strain,
    error_charge_nc,
    error_open_circuit_v,
    error_output_v,
    reason
});

async fn insert_row(
    connection: &mut SqliteConnection,
    study: &str,
    ordinal: usize,
    row: &SignalRow,
) -> Result<(), StoreError> {
    let error = |part: fn(&SignalError) -> f64| row.error.as_ref().map(part);
    sqlx::query(
        "insert into signals (study, ordinal, tire, film, position, direction, axis, load_n, pressure_mpa, contact_deg, depth_mm, strain,
             tension_1_n_per_mm, charge_nc, open_circuit_v, output_v, output_std_v, state,
             error_strain, error_charge_nc, error_open_circuit_v, error_output_v, reason)
         values (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
    )
    .bind(study)
    .bind(whole(ordinal))
    .bind(&row.tire)
    .bind(row.film.as_str())
    .bind(position_name(row.position))
    .bind(row.direction.as_str())
    .bind(row.over.as_str())
    .bind(row.load_n)
    .bind(row.pressure_mpa)
    .bind(row.contact_deg)
    .bind(row.depth_mm)
    .bind(row.strain)
    .bind(row.tension_1_n_per_mm)
    .bind(row.charge_nc)
    .bind(row.open_circuit_v)
    .bind(row.output_v)
    .bind(row.output_std_v)
    .bind(row.state.map(FilmCondition::as_str))
    .bind(error(|error| error.strain))
    .bind(error(|error| error.charge_nc))
    .bind(error(|error| error.open_circuit_v))
    .bind(error(|error| error.output_v))
    .bind(row.reason.as_deref())
    .execute(connection)
    .await?;
    Ok(())
}

async fn rows(connection: &mut SqliteConnection, study: &str) -> Result<Vec<Row>, StoreError> {
    let query = "select tire, film, position, direction, axis, load_n, pressure_mpa, contact_deg, depth_mm, strain, tension_1_n_per_mm,
                     charge_nc, open_circuit_v, output_v, output_std_v, state,
                     error_strain, error_charge_nc, error_open_circuit_v, error_output_v, reason
                 from signals where study = ? order by ordinal";
    Ok(sqlx::query_as(query)
        .bind(study)
        .fetch_all(connection)
        .await?)
}

impl Row {
    /// The row as it was stored; `None` where a name isn't one.
    fn signal(&self) -> Option<SignalRow> {
        let position = POSITIONS.iter().find(|(name, _)| *name == self.position);
        Some(SignalRow {
            tire: self.tire.clone(),
            film: FilmModel::named(&self.film)?,
            position: position?.1,
            direction: Direction::named(&self.direction)?,
            over: SignalAxis::named(&self.axis)?,
            load_n: self.load_n,
            pressure_mpa: self.pressure_mpa,
            contact_deg: self.contact_deg,
            depth_mm: self.depth_mm,
            strain: self.strain,
            tension_1_n_per_mm: self.tension_1_n_per_mm,
            charge_nc: self.charge_nc,
            open_circuit_v: self.open_circuit_v,
            output_v: self.output_v,
            output_std_v: self.output_std_v,
            state: match &self.state {
                Some(name) => Some(condition_named(name)?),
                None => None,
            },
            error: self.error(),
            reason: self.reason.clone(),
        })
    }

    fn error(&self) -> Option<SignalError> {
        Some(SignalError {
            strain: self.error_strain?,
            charge_nc: self.error_charge_nc?,
            open_circuit_v: self.error_open_circuit_v?,
            output_v: self.error_output_v?,
        })
    }
}

fn condition_named(name: &str) -> Option<FilmCondition> {
    let found = FilmCondition::NAMES
        .iter()
        .find(|(known, _)| *known == name);
    found.map(|(_, condition)| *condition)
}

#[cfg(test)]
mod tests;
