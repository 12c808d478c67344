//! The two directions of the inner surface, and a value for each.

use std::ops::{Index, IndexMut};

use document::Choice;
use serde::{Deserialize, Serialize};

/// A direction of the inner surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Choice)]
pub enum Direction {
    /// Circumferential.
    X,
    /// Meridional.
    Y,
}

impl std::fmt::Display for Direction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.as_str())
    }
}

/// A value for each direction; in documents a pair, x first, where no field names ([`StrainFields`] and others) are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(from = "[T; 2]", into = "[T; 2]")]
#[serde(bound(serialize = "T: Clone + Serialize"))]
pub struct PerDirection<T> {
    /// Circumferential.
    pub x: T,
    /// Meridional.
    pub y: T,
}

impl<T> PerDirection<T> {
    /// Asks a function for each direction, x first.
    pub fn of(mut value: impl FnMut(Direction) -> T) -> Self {
        let [x, y] = Direction::ALL.map(&mut value);
        Self { x, y }
    }

    /// A function of each value.
    pub fn map<U>(self, mut function: impl FnMut(T) -> U) -> PerDirection<U> {
        PerDirection {
            x: function(self.x),
            y: function(self.y),
        }
    }

    /// Pairs of values.
    pub fn zip<U>(self, other: PerDirection<U>) -> PerDirection<(T, U)> {
        PerDirection {
            x: (self.x, other.x),
            y: (self.y, other.y),
        }
    }

    /// References to the values.
    pub fn as_ref(&self) -> PerDirection<&T> {
        PerDirection {
            x: &self.x,
            y: &self.y,
        }
    }

    /// References to the values, to change them.
    pub fn as_mut(&mut self) -> PerDirection<&mut T> {
        PerDirection {
            x: &mut self.x,
            y: &mut self.y,
        }
    }

    /// The values, x first.
    pub fn iter(&self) -> std::array::IntoIter<&T, 2> {
        self.as_ref().into_iter()
    }
}

impl<T> Index<Direction> for PerDirection<T> {
    type Output = T;

    fn index(&self, direction: Direction) -> &T {
        match direction {
            Direction::X => &self.x,
            Direction::Y => &self.y,
        }
    }
}

impl<T> IndexMut<Direction> for PerDirection<T> {
    fn index_mut(&mut self, direction: Direction) -> &mut T {
        match direction {
            Direction::X => &mut self.x,
            Direction::Y => &mut self.y,
        }
    }
}

impl<T> IntoIterator for PerDirection<T> {
    type Item = T;
    type IntoIter = std::array::IntoIter<T, 2>;

    fn into_iter(self) -> Self::IntoIter {
        <[T; 2]>::from(self).into_iter()
    }
}

/// A list for each direction.
impl<T> FromIterator<PerDirection<T>> for PerDirection<Vec<T>> {
    fn from_iter<I: IntoIterator<Item = PerDirection<T>>>(values: I) -> Self {
        let (x, y) = values.into_iter().map(|value| (value.x, value.y)).unzip();
        Self { x, y }
    }
}

impl<T> From<[T; 2]> for PerDirection<T> {
    fn from([x, y]: [T; 2]) -> Self {
        Self { x, y }
    }
}

impl<T> From<PerDirection<T>> for [T; 2] {
    fn from(values: PerDirection<T>) -> Self {
        [values.x, values.y]
    }
}

/// Names under which a value per direction stands as two fields: `#[serde(flatten, with = "StrainFields")]` among the fields of an object,
/// without `flatten` as an object of its own.
#[macro_export]
macro_rules! direction_fields {
    ($($(#[$doc:meta])* $name:ident: $x:literal, $y:literal;)*) => {$(
        $(#[$doc])*
        #[derive(serde::Serialize, serde::Deserialize, utoipa::ToSchema)]
        #[serde(remote = "PerDirection")]
        pub struct $name<T> {
            /// Circumferential.
            #[serde(rename = $x)]
            #[schema(rename = $x)]
            x: T,
            /// Meridional.
            #[serde(rename = $y)]
            #[schema(rename = $y)]
            y: T,
        }
    )*};
}

direction_fields! {
    /// Names of strains and their errors.
    StrainFields: "strain_x", "strain_y";
    /// Names of a film's stretches.
    StretchFields: "stretch_x", "stretch_y";
    /// Names of the inflated crown's stretches.
    CrownStretchFields: "crown_stretch_x", "crown_stretch_y";
    /// Names of a film's tensions.
    TensionFields: "tension_x_n_per_mm", "tension_y_n_per_mm";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Point {
        name: String,
        #[serde(flatten, with = "StrainFields")]
        strain: PerDirection<f64>,
        depth_mm: f64,
        #[serde(with = "StrainFields")]
        crown: PerDirection<f64>,
        pair: PerDirection<Option<f64>>,
    }

    #[test]
    fn a_value_per_direction_stands_in_documents_as_the_field_says() {
        let point = Point {
            name: "P1".to_owned(),
            strain: PerDirection {
                x: 0.1 + 0.2,
                y: -0.0,
            },
            depth_mm: 1.0,
            crown: PerDirection { x: 1.0, y: 2.0 },
            pair: PerDirection {
                x: None,
                y: Some(1e-300),
            },
        };
        let text = serde_json::to_string(&point).expect("finite numbers");
        assert_eq!(
            text,
            "{\"name\":\"P1\",\"strain_x\":0.30000000000000004,\"strain_y\":-0.0,\"depth_mm\":1.0,\
             \"crown\":{\"strain_x\":1.0,\"strain_y\":2.0},\"pair\":[null,1e-300]}"
        );
        let back: Point = serde_json::from_str(&text).expect("reads back");
        assert_eq!(back, point);
        assert!(back.strain.y.is_sign_negative());
        let without = text.replace("\"strain_x\":0.30000000000000004,", "");
        assert!(serde_json::from_str::<Point>(&without).is_err());
    }

    #[test]
    fn values_go_by_direction_and_x_comes_first() {
        let names = PerDirection::of(Direction::as_str);
        assert_eq!(names.iter().copied().collect::<String>(), "xy");
        for direction in Direction::ALL {
            assert_eq!(names[direction], direction.to_string());
            assert_eq!(Direction::named(names[direction]), Some(direction));
        }
        assert_eq!(Direction::named("z"), None);
        let lists: PerDirection<Vec<i32>> = [1, 2]
            .map(|k| PerDirection { x: k, y: -k })
            .into_iter()
            .collect();
        assert_eq!((lists.x, lists.y), (vec![1, 2], vec![-1, -2]));
    }

    #[test]
    fn a_value_per_direction_is_described_by_the_names_of_its_fields() {
        use utoipa::PartialSchema;
        let schema = serde_json::to_value(StrainFields::<f64>::schema()).expect("a schema");
        assert_eq!(
            schema["required"],
            serde_json::json!(["strain_x", "strain_y"])
        );
    }
}
