//! Grid lines of a tire's mesh: where bricks begin and end along each direction.

use std::f64::consts::PI;

/// Brick of a grid line that holds a coordinate (in the unit of the edges), and the place in it, -1 to 1.
pub(crate) fn locate(edges: &[f64], value: f64) -> (usize, f64) {
    let last = edges.len() - 2;
    let index = edges
        .partition_point(|&edge| edge <= value)
        .saturating_sub(1)
        .min(last);
    let local = 2.0 * (value - edges[index]) / (edges[index + 1] - edges[index]) - 1.0;
    (index, local.clamp(-1.0, 1.0))
}

/// Edges from 0 to pi, rad: a fine sector (its end and its intervals), then sizes that grow geometrically from the last one to the end of the middle sector, if
/// there is one, and from there to pi.
pub(crate) fn half_circle(
    (fine_end, fine): (f64, usize),
    middle: Option<(f64, usize)>,
    coarse: usize,
) -> Vec<f64> {
    let mut edges = graded(0.0, fine_end, fine, 1.0);
    for (end, intervals) in middle.into_iter().chain([(PI, coarse)]) {
        let last = edges[edges.len() - 1];
        let size = last - edges[edges.len() - 2];
        let growth = growth_ratio((end - last) / size, intervals).powi(intervals as i32 - 1);
        edges.extend(graded(last, end, intervals, growth).into_iter().skip(1));
    }
    edges
}

/// The ratio q of neighbouring sizes for which q + q^2 + ... + q^n equals `length` (in units of the size before them).
fn growth_ratio(length: f64, n: usize) -> f64 {
    let sum = |q: f64| (1..=n).map(|k| q.powi(k as i32)).sum::<f64>();
    let (mut low, mut high) = (0.1, 100.0);
    // Bisection in the logarithm: 60 halvings of ln 1000 end below round-off.
    for _ in 0..60 {
        let middle = f64::sqrt(low * high);
        if sum(middle) < length {
            low = middle
        } else {
            high = middle
        }
    }
    f64::sqrt(low * high)
}

/// Edges from `start` to `end`, in their unit, whose sizes form a geometric series with the last `growth` times the first.
pub fn graded(start: f64, end: f64, n: usize, growth: f64) -> Vec<f64> {
    let ratio = if n > 1 {
        growth.powf(1.0 / (n as f64 - 1.0))
    } else {
        1.0
    };
    let sizes: Vec<f64> = (0..n).map(|k| ratio.powi(k as i32)).collect();
    let scale = (end - start) / sizes.iter().sum::<f64>();
    let mut edges = vec![start];
    let mut sum = 0.0;
    for size in &sizes[..n - 1] {
        sum += size;
        edges.push(start + scale * sum);
    }
    edges.push(end);
    edges
}

/// Returns these edges with one at each end of the interval from `low` to `high`, and the intervals between no longer than `most`; all in the edges' unit.
/// Edges at zero and at both ends stay; the others make room.
pub fn fitted(edges: &[f64], [low, high]: [f64; 2], most: f64) -> Vec<f64> {
    let (first, last) = (edges[0], edges[edges.len() - 1]);
    let inside = |target: &f64| first < *target && *target < last && *target != 0.0;
    let mut anchors = vec![(0, first), (edges.len() - 1, last)];
    if let Some(zero) = edges.iter().position(|&edge| edge == 0.0) {
        anchors.push((zero, 0.0));
    }
    // The next line outward comes to the end, so that the interval has more lines, not fewer.
    let outward = [
        (
            low,
            edges.partition_point(|&edge| edge <= low).checked_sub(1),
        ),
        (high, Some(edges.partition_point(|&edge| edge < high))),
    ];
    for (target, line) in outward.into_iter().filter(|(target, _)| inside(target)) {
        let is_taken = |line: usize| anchors.iter().any(|anchor| anchor.0 == line);
        if let Some(line) = line.filter(|&line| line < edges.len() && !is_taken(line)) {
            anchors.push((line, target));
        }
    }
    anchors.sort_by_key(|anchor| anchor.0);
    let mut moved = warped(edges, &anchors);
    let extra = [low, high].into_iter().filter(|target| inside(target));
    for target in extra.collect::<Vec<_>>() {
        if !moved.contains(&target) {
            moved.insert(moved.partition_point(|&edge| edge < target), target);
        }
    }
    split(&moved, [low, high], most)
}

/// Edges with these lines at these places, and the others between them in proportion.
fn warped(edges: &[f64], anchors: &[(usize, f64)]) -> Vec<f64> {
    let mut moved = edges.to_vec();
    for pair in anchors.windows(2) {
        let ((i, from), (j, to)) = (pair[0], pair[1]);
        let (start, end) = (edges[i], edges[j]);
        for line in i + 1..j {
            moved[line] = from + (to - from) * (edges[line] - start) / (end - start);
        }
        (moved[i], moved[j]) = (from, to);
    }
    moved
}

/// Edges with the intervals that reach into the one from `low` to `high` cut into equal parts no longer than `most`.
pub fn split(edges: &[f64], [low, high]: [f64; 2], most: f64) -> Vec<f64> {
    let mut cut = vec![edges[0]];
    for pair in edges.windows(2) {
        let (start, end) = (pair[0], pair[1]);
        // An interval that only touches is left alone; round-off isn't a part.
        let reaches = end > low && start < high;
        let parts = ((end - start) / most - 1e-9).ceil().max(1.0);
        if reaches {
            let step = (end - start) / parts;
            cut.extend((1..parts as usize).map(|k| start + step * k as f64));
        }
        cut.push(end);
    }
    cut
}

/// Layers by which a carcass may miss the middle between two boundaries and still lie there: of walls that differ a little, rounding would give some the inner and
/// some the outer one.
const TIE: f64 = 1e-9;

/// Section radii of the boundaries of `n` layers between inner and outer radius, one of them at the carcass.
pub fn layers(inner: f64, outer: f64, carcass: Option<f64>, n: usize) -> Vec<f64> {
    let wall = outer - inner;
    let below = carcass.map_or(0, |rho| {
        let share = (rho - inner) / wall;
        if share <= 0.0 || share >= 1.0 {
            0
        } else {
            ((share * n as f64 + TIE).round() as usize).clamp(1, n - 1)
        }
    });
    match carcass {
        Some(rho) if below > 0 => {
            let mut edges = graded(inner, rho, below, 1.0);
            edges.extend(graded(rho, outer, n - below, 1.0).into_iter().skip(1));
            edges
        }
        _ => graded(inner, outer, n, 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_carcass_in_the_middle_has_the_same_layers_below_it_in_walls_of_any_thickness() {
        for k in 0..1000 {
            let (outer, wall) = (12.5, 3.0 + 1e-5 * f64::from(k));
            let inner = outer - wall;
            let rho = inner + 0.5 * wall;
            assert_eq!(layers(inner, outer, Some(rho), 3)[2], rho, "{wall}");
        }
    }

    const EDGES: [f64; 6] = [-4.0, -2.0, 0.0, 1.0, 3.0, 6.0];

    #[test]
    fn sizes_of_a_half_circle_grow_steadily_through_its_sectors() {
        let sizes = |edges: &[f64]| -> Vec<f64> {
            edges.windows(2).map(|pair| pair[1] - pair[0]).collect()
        };
        let edges = half_circle((0.3, 10), Some((1.0, 12)), 4);
        assert_eq!((edges.len(), edges[0]), (27, 0.0));
        assert_eq!((edges[10], edges[22], edges[26]), (0.3, 1.0, PI));
        let sizes = sizes(&edges);
        let ratios: Vec<f64> = sizes.windows(2).map(|pair| pair[1] / pair[0]).collect();
        let is_even = |ratios: &[f64], by: f64| ratios.iter().all(|r| (r / by - 1.0).abs() < 1e-9);
        // The fine sector's are alike; each later sector has one ratio, from the size before it on.
        assert!(is_even(&ratios[..9], 1.0), "{ratios:?}");
        assert!(
            is_even(&ratios[9..21], ratios[9]) && ratios[9] > 1.0,
            "{ratios:?}"
        );
        assert!(
            is_even(&ratios[21..], ratios[21]) && ratios[21] > ratios[9],
            "{ratios:?}"
        );
        let without = half_circle((0.3, 10), None, 4);
        assert_eq!((without.len(), without[10], without[14]), (15, 0.3, PI));
    }

    #[test]
    fn lines_come_to_the_ends_of_an_interval_and_others_make_room() {
        assert_eq!(
            fitted(&EDGES, [-2.0, 2.0], 9.0),
            [-4.0, -2.0, 0.0, 2.0 / 3.0, 2.0, 6.0]
        );
        // Around zero, which stays.
        assert_eq!(
            fitted(&EDGES, [-0.5, 0.5], 9.0),
            [-4.0, -0.5, 0.0, 0.5, 2.7, 6.0]
        );
        // Between two lines: one of them comes, and where both ends want the same one, a line is added.
        let both = fitted(&EDGES, [3.5, 4.0], 9.0);
        assert!(
            both.contains(&3.5) && both.contains(&4.0) && both.contains(&6.0),
            "{both:?}"
        );
        assert!(both.windows(2).all(|pair| pair[1] > pair[0]), "{both:?}");
    }

    #[test]
    fn what_an_interval_reaches_is_cut() {
        assert_eq!(
            split(&EDGES, [0.0, 1.5], 1.0),
            [-4.0, -2.0, 0.0, 1.0, 2.0, 3.0, 6.0]
        );
        assert_eq!(split(&EDGES, [7.0, 8.0], 0.1), EDGES);
    }

    #[test]
    fn mirrored_intervals_have_mirrored_lines() {
        let edges = [-5.0, -3.0, -1.0, 0.0, 1.0, 3.0, 5.0];
        let right = fitted(&edges, [0.5, 2.0], 0.6);
        let left = fitted(&edges, [-2.0, -0.5], 0.6);
        let mirrored: Vec<f64> = left.iter().rev().map(|edge| -edge).collect();
        assert_eq!(right.len(), mirrored.len());
        for (a, b) in right.iter().zip(mirrored) {
            assert!((a - b).abs() < 1e-15);
        }
    }
}
