//! Lists of studies, sweeps and estimators: how they are asked for.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use axum::http::StatusCode;
use serde::Deserialize;
use store::queue::listed::{Archived, Listed};
use store::queue::study_rows::State;

use crate::http::edge::problem_document::Problem;

const PAGE: u32 = 50;
const LARGEST_PAGE: u32 = 200;
/// Characters of what is searched for: no name has more.
const LONGEST_SEARCH: usize = 200;

/// Query of a list.
#[derive(Deserialize)]
pub(super) struct PageQuery {
    limit: Option<String>,
    pub cursor: Option<String>,
    state: Option<String>,
    pub sweep: Option<String>,
    search: Option<String>,
    archived: Option<String>,
}

impl PageQuery {
    /// Entries of a page.
    pub fn limit(&self) -> Result<u32, Problem> {
        let limit = self.limit.as_deref();
        let limit = limit.map_or(Some(PAGE), |text| text.parse().ok());
        let in_range = limit.filter(|limit| (1..=LARGEST_PAGE).contains(limit));
        in_range.ok_or_else(|| wrong("limit is a whole number from 1 to 200"))
    }

    /// The one state whose entries are listed.
    pub(crate) fn of_state(&self) -> Result<Option<State>, Problem> {
        let named = |name: &str| {
            let wrong = || wrong("state is one of queued, running, done, failed, cancelled");
            State::named(name).ok_or_else(wrong)
        };
        self.state.as_deref().map(named).transpose()
    }

    /// Returns what is looked for.
    pub fn listed(&self) -> Result<Listed<'_>, Problem> {
        let archived = match self.archived.as_deref() {
            None | Some("false") => Archived::Without,
            Some("true") => Archived::Alone,
            Some("all") => Archived::All,
            Some(_) => return Err(wrong("archived is one of true, false, all")),
        };
        let search = self.search.as_deref();
        if search.is_some_and(|text| text.chars().count() > LONGEST_SEARCH) {
            return Err(wrong("search has at most 200 characters"));
        }
        Ok(Listed { search, archived })
    }
}

fn wrong(detail: &str) -> Problem {
    Problem::new(StatusCode::BAD_REQUEST, detail)
}
