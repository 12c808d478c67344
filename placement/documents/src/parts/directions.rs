//! Directions of the strains that a study asks for, and what follows from them.
//!
//! | `candidates.directions` | ranks go by | tolerance and adaptive points serve | films of a layout | model |
//! | --- | --- | --- | --- | --- |
//! | `["x", "y"]`, or left out | the sum of both indices | all outputs | x and y | three-dimensional |
//! | `["x"]` | the x strain's index | the x strains | x | three-dimensional |
//! | `["y"]` | the y strain's index | the y strains | y | three-dimensional |
//!
//! The other strain costs nothing and stays in the answer, as good as the same points make it. No question is left to a model in two
//! dimensions: for the x strain alone that was tried (`docs/develop/decisions/tire/ring.md`). The scene decides how much of the tire is meshed:
//! `tire::model`.

use fem_client::solver::direction::{Direction, PerDirection};

/// Directions of the strains that are asked for: x circumferential, y meridional.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Directions {
    /// Both strains.
    #[default]
    Both,
    /// Circumferential alone.
    X,
    /// Meridional alone.
    Y,
}

impl Directions {
    /// Returns the directions that are asked for, x first.
    pub fn asked(self) -> &'static [Direction] {
        match self {
            Self::Both => &Direction::ALL,
            Self::X => &[Direction::X],
            Self::Y => &[Direction::Y],
        }
    }

    /// Asks for all of these; `None` of none.
    pub(crate) fn of(directions: &[Direction]) -> Option<Self> {
        let has = PerDirection::of(|direction| directions.contains(&direction));
        match (has.x, has.y) {
            (true, true) => Some(Self::Both),
            (true, false) => Some(Self::X),
            (false, true) => Some(Self::Y),
            (false, false) => None,
        }
    }

    /// Whether a direction is asked for.
    pub fn include(self, direction: Direction) -> bool {
        self.asked().contains(&direction)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_which_they_are_in_any_order() {
        for directions in [Directions::Both, Directions::X, Directions::Y] {
            let mut asked = directions.asked().to_vec();
            asked.reverse();
            assert_eq!(Directions::of(&asked), Some(directions));
            for direction in Direction::ALL {
                assert_eq!(directions.include(direction), asked.contains(&direction));
            }
        }
        assert_eq!(Directions::of(&[]), None);
    }
}
