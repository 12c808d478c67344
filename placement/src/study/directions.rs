//! Which strains a study asks for, and what follows from that.
//!
//! | `candidates.directions` | ranks go by | tolerance and adaptive points serve | films of a layout | model |
//! | --- | --- | --- | --- | --- |
//! | `["x", "y"]`, or left out | the sum of both indices | all outputs | x and y | three-dimensional |
//! | `["x"]` | the x strain's index | the x strains | x | three-dimensional |
//! | `["y"]` | the y strain's index | the y strains | y | three-dimensional |
//!
//! The other strain costs nothing and stays in the answer, as good as the same points make it. No question is left to a model in two
//! dimensions: for the x strain alone that was tried (`docs/ring.md`). The scene decides how much of the tire is meshed:
//! [`tire::model`].

/// Directions of the strains that are asked for: x circumferential, y meridional.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Directions {
    /// Both.
    #[default]
    Both,
    /// Circumferential alone.
    X,
    /// Meridional alone.
    Y,
}

impl Directions {
    /// Their names in documents, x first.
    pub fn names(self) -> &'static [&'static str] {
        match self {
            Self::Both => &["x", "y"],
            Self::X => &["x"],
            Self::Y => &["y"],
        }
    }

    /// Those with these names; `None` where there is none.
    pub(crate) fn named(names: &[&str]) -> Option<Self> {
        let has = |name| names.contains(&name);
        match (has("x"), has("y")) {
            (true, true) => Some(Self::Both),
            (true, false) => Some(Self::X),
            (false, true) => Some(Self::Y),
            (false, false) => None,
        }
    }

    /// Whether a direction is asked for.
    pub fn include(self, name: &str) -> bool {
        self.names().contains(&name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_which_they_are_in_any_order() {
        for directions in [Directions::Both, Directions::X, Directions::Y] {
            let mut names = directions.names().to_vec();
            names.reverse();
            assert_eq!(Directions::named(&names), Some(directions));
            for name in ["x", "y"] {
                assert_eq!(directions.include(name), names.contains(&name));
            }
        }
        assert_eq!(Directions::named(&[]), None);
    }
}
