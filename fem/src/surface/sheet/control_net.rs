//! Control points of a rectangular sheet.

use super::spline::{Basis, basis, function_count};
use crate::tensor::Vector;

/// A rectangle in its own coordinates s1, s2, whose origin is its middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outline {
    /// Half of its extents, mm.
    pub half: [f64; 2],
    /// Spans along each; even where it is mirrored.
    pub spans: [usize; 2],
    /// Displacement whose sign the mirror changes, where the half with a negative coordinate is the mirror image of the other one.
    pub mirrors: [Option<usize>; 2],
}

/// A control point: the node that has its displacements, and their signs.
pub(super) type Control = (usize, Vector);

impl Outline {
    /// Returns the number of meshed parts that make up the whole.
    pub fn copies(&self) -> f64 {
        let mirrored = self.mirrors.iter().flatten().count();
        [1.0, 2.0, 4.0][mirrored]
    }

    /// Control points with displacements of their own, along each coordinate.
    pub fn control_points(&self) -> [usize; 2] {
        [0, 1].map(|k| {
            let all = function_count(self.spans[k]);
            match self.mirrors[k] {
                Some(_) => all / 2,
                None => all,
            }
        })
    }

    /// Number of control points with displacements of their own.
    pub fn node_count(&self) -> usize {
        self.control_points().iter().product()
    }

    /// Spans that are integrated.
    pub(super) fn spans(&self) -> impl Iterator<Item = [usize; 2]> {
        let first = [0, 1].map(|k| self.mirrors[k].map_or(0, |_| self.spans[k] / 2));
        let [along, across] = self.spans;
        (first[1]..across).flat_map(move |j| (first[0]..along).map(move |i| [i, j]))
    }

    /// The nine control points of a span, those along s1 first.
    pub(super) fn controls(&self, span: [usize; 2]) -> [Control; 9] {
        std::array::from_fn(|a| {
            let along = self.control(0, span[0] + a % 3);
            let across = self.control(1, span[1] + a / 3);
            let sign = [0, 1, 2].map(|i| along.1[i] * across.1[i]);
            (across.0 * self.control_points()[0] + along.0, sign)
        })
    }

    /// The own control point along one coordinate that stands for this one, and the signs of its displacements.
    fn control(&self, k: usize, index: usize) -> Control {
        let Some(axis) = self.mirrors[k] else {
            return (index, [1.0; 3]);
        };
        let middle = function_count(self.spans[k]) / 2;
        if index >= middle {
            return (index - middle, [1.0; 3]);
        }
        let mut sign = [1.0; 3];
        sign[axis] = -1.0;
        (middle - 1 - index, sign)
    }

    /// Coordinates of a point of a span, mm.
    pub(super) fn at(&self, span: [usize; 2], t: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| (span[k] as f64 + t[k]) * self.width(k) - self.half[k])
    }

    /// The functions of a span along each coordinate, derivatives by mm.
    pub(super) fn bases(&self, span: [usize; 2], t: [f64; 2]) -> [Basis; 2] {
        [0, 1].map(|k| {
            let unit = basis(self.spans[k], span[k], t[k]);
            let h = self.width(k);
            Basis {
                values: unit.values,
                first: unit.first.map(|d| d / h),
                second: unit.second.map(|d| d / (h * h)),
            }
        })
    }

    /// Width of a span, mm.
    pub(super) fn width(&self, k: usize) -> f64 {
        2.0 * self.half[k] / self.spans[k] as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mirrored_control_points_have_the_other_sign_and_the_same_node() {
        let outline = Outline {
            half: [2.0, 1.0],
            spans: [4, 2],
            mirrors: [Some(0), None],
        };
        assert_eq!((outline.control_points(), outline.copies()), ([3, 4], 2.0));
        assert_eq!(
            outline.spans().collect::<Vec<_>>(),
            [[2, 0], [3, 0], [2, 1], [3, 1]]
        );
        // Of the six functions along s1, 2 and 3 are images of each other.
        let controls = outline.controls([2, 0]);
        assert_eq!(controls[0], (0, [-1.0, 1.0, 1.0]));
        assert_eq!(controls[1], (0, [1.0, 1.0, 1.0]));
        assert_eq!(controls[2], (1, [1.0, 1.0, 1.0]));
        assert_eq!(controls[3].0, 3);
        assert_eq!(outline.at([2, 1], [0.0, 1.0]), [0.0, 1.0]);
    }
}
