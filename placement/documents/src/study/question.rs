//! Question that a study's layouts answer.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use document::Table;
use document::fields::Range;
use serde::{Deserialize, Serialize};

use crate::layouts::layout_bounds::MOST_FILMS;

/// Errors of an angle: half a turn at most.
const ANGLE: Range = Range::new(1e-3, 180.0, "degrees");
const FORCE: Range = Range::new(1e-6, 1e6, "N");
const COST: Range = Range::new(0.0, 1e9, "");
const FILMS: (u64, u64) = (1, MOST_FILMS as u64);

/// Question that a study's layouts answer: the best with so many films, or the fewest films that keep errors within limits.
#[derive(Debug, Clone, Copy, PartialEq, Table, Serialize, Deserialize, utoipa::ToSchema)]
pub struct Question {
    /// Most films of a layout, those that are glued on already among them.
    #[field(within = FILMS)]
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub films: Option<usize>,
    /// Largest error of the contact angle that is allowed, degrees: of 95 in 100 contacts at the worst load.
    #[field(within = ANGLE)]
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub angle_deg: Option<f64>,
    /// Largest error of the vertical force that is allowed, N: root mean square at the worst load.
    #[field(within = FORCE)]
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub force_n: Option<f64>,
    /// Most that a layout may cost, in the currency of `film_cost` and `channel_cost`.
    #[field(within = COST)]
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cost: Option<f64>,
    /// Cost of a film that isn't glued on already.
    #[field(within = COST)]
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub film_cost: Option<f64>,
    /// Cost of a channel of the amplifier: every film has one.
    #[field(within = COST)]
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub channel_cost: Option<f64>,
}

impl Question {
    /// Whether the table says nothing.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Whether nothing is asked; costs alone are told.
    pub fn asks_nothing(&self) -> bool {
        self.films.is_none() && self.cost.is_none() && !self.has_limits()
    }

    /// Cost of a layout of so many films, of which so many are glued on already; `None` where none is known.
    pub fn cost_of(&self, films: usize, taken: usize) -> Option<f64> {
        let (film, channel) = (self.film_cost, self.channel_cost);
        film.or(channel)?;
        let new = films.saturating_sub(taken) as f64;
        Some(new * film.unwrap_or(0.0) + films as f64 * channel.unwrap_or(0.0))
    }

    /// Most films that a layout may have, by their number and by what it may cost; `None` where neither has a limit.
    pub fn most_films(&self, taken: usize) -> Option<usize> {
        let affordable = self.cost.and_then(|most| {
            let is_within =
                |films: &usize| self.cost_of(*films, taken).is_none_or(|cost| cost <= most);
            self.cost_of(1, taken)?;
            Some((1..=MOST_FILMS).take_while(is_within).last().unwrap_or(0))
        });
        match (self.films, affordable) {
            (Some(films), Some(affordable)) => Some(films.min(affordable)),
            (films, affordable) => films.or(affordable),
        }
    }

    /// Whether errors have limits.
    pub fn has_limits(&self) -> bool {
        self.angle_deg.is_some() || self.force_n.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn costs_limit_the_number_of_films() {
        let question = Question {
            cost: Some(100.0),
            film_cost: Some(4.0),
            channel_cost: Some(6.0),
            ..Question::default()
        };
        assert_eq!(question.cost_of(12, 0), Some(120.0));
        // Two are glued on already: their channels alone cost something.
        assert_eq!(question.cost_of(12, 2), Some(112.0));
        assert_eq!(
            (question.most_films(0), question.most_films(2)),
            (Some(10), Some(10))
        );
        let fewer = Question {
            films: Some(8),
            ..question
        };
        assert_eq!(fewer.most_films(0), Some(8));
        let dear = Question {
            cost: Some(9.0),
            ..question
        };
        assert_eq!(dear.most_films(0), Some(0));
        let told = Question {
            cost: None,
            ..question
        };
        assert!(told.asks_nothing() && !told.is_empty());
        assert_eq!(
            (told.most_films(0), Question::default().cost_of(3, 0)),
            (None, None)
        );
    }
}
