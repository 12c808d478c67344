//! Layouts of so many films out of many places: [`layout_search`] chooses from [`search_films`], goes by a [`search_criterion`], and keeps the [`best_layouts`].

pub mod best_layouts;
pub mod layout_search;
pub mod search_criterion;
pub mod search_films;
