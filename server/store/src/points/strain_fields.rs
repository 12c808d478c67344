//! The long lists of responses: strains over map and rings, where the map's points lie, kept beside the response as numbers.

use fem_client::solver::Response;
use sqlx::SqliteConnection;

use crate::content::sha256;
use crate::store_error::StoreError;

const TABLE: &str = "strain_fields";

/// The lists that are kept here, in their order in the table.
fn lists(response: &mut Response) -> impl Iterator<Item = &mut Vec<f64>> {
    let map = response.map.iter_mut().flat_map(|map| {
        let lists = [
            &mut map.theta_deg,
            &mut map.phi_deg,
            &mut map.strain.x,
            &mut map.strain.y,
        ];
        lists.into_iter().chain(&mut map.position_mm)
    });
    let rings = response.rings.iter_mut().flat_map(|ring| {
        let lists = [&mut ring.theta_deg, &mut ring.strain.x, &mut ring.strain.y];
        lists.into_iter().chain(&mut ring.turned)
    });
    map.chain(rings)
}

/// Takes the lists out of a response; `None` when it has none.
///
/// # Errors
/// [`StoreError::NotFinite`] when one of their numbers isn't finite.
pub fn take(response: &mut Response) -> Result<Option<Vec<u8>>, StoreError> {
    let mut bytes = Vec::new();
    for list in lists(response) {
        if !list.iter().all(|value| value.is_finite()) {
            return Err(StoreError::NotFinite {
                what: "the strains of a point",
            });
        }
        bytes.extend((list.len() as u64).to_le_bytes());
        bytes.extend(list.iter().flat_map(|value| value.to_le_bytes()));
        list.clear();
    }
    Ok((!bytes.is_empty()).then_some(bytes))
}

/// Puts the lists back; false when they are not those of this response, which is then of no use.
#[must_use]
fn put(response: &mut Response, bytes: &[u8]) -> bool {
    let mut rest = bytes.chunks_exact(8);
    let mut next = || {
        let word: [u8; 8] = rest.next()?.try_into().ok()?;
        Some(word)
    };
    let mut read = |list: &mut Vec<f64>| {
        let length = usize::try_from(u64::from_le_bytes(next()?)).ok()?;
        // As long as there are bytes: a length that was made up reserves nothing.
        for _ in 0..length {
            list.push(f64::from_le_bytes(next()?));
        }
        Some(())
    };
    let whole = lists(response).all(|list| list.is_empty() && read(list).is_some());
    whole && next().is_none() && bytes.len().is_multiple_of(8)
}

/// Stores the lists of an evaluation; what is there already stays.
///
/// # Errors
/// When the database can't be written.
pub async fn insert(
    connection: &mut SqliteConnection,
    key: &str,
    lists: &[u8],
) -> Result<(), StoreError> {
    sqlx::query(
        "insert into strain_fields (key, lists, sha256) values (?, ?, ?) on conflict do nothing",
    )
    .bind(key)
    .bind(lists)
    .bind(sha256(&[key.as_bytes(), lists]))
    .execute(connection)
    .await?;
    Ok(())
}

/// Completes the response under a key of the table of evaluations by what this table has beside it: lists and hash.
///
/// # Errors
/// [`StoreError::Damaged`] when the lists are missing or not those that were stored.
pub fn restore(
    key: &str,
    response: &mut Response,
    stored: Option<(Vec<u8>, String)>,
) -> Result<(), StoreError> {
    let whole = match stored {
        Some((bytes, hash)) => sha256(&[key.as_bytes(), &bytes]) == hash && put(response, &bytes),
        None => lists(response).next().is_none(),
    };
    if whole {
        return Ok(());
    }
    Err(StoreError::Damaged {
        table: TABLE,
        row: key.to_owned(),
    })
}
