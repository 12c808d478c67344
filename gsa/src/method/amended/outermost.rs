//! Distance of runs that failed from those that gave a number.
//!
//! Runs tend to fail at the ends of a law's range, or where several inputs add up. So the distance is looked for along each input and along the line
//! from the middle of the runs that gave a number to the middle of the others, in standard deviations of the inputs.

/// Standard deviation of each coordinate of some points.
pub(super) fn deviations(points: &[Vec<f64>]) -> Vec<f64> {
    let count = points.len() as f64;
    let of_input = |input: usize| {
        let values = || points.iter().map(|point| point[input]);
        let mean = values().sum::<f64>() / count;
        let squares = values().map(|x| (x - mean).powi(2));
        (squares.sum::<f64>() / count).sqrt()
    };
    let inputs = points.first().map_or(0, Vec::len);
    (0..inputs).map(of_input).collect()
}

/// Distance of the outermost failed run from the last one that gave a number, along whichever line it is largest; 0 where none lies beyond all others.
pub(super) fn beyond_others(points: &[Vec<f64>], values: &[f64], deviations: &[f64]) -> f64 {
    let standard = |point: &Vec<f64>| -> Vec<f64> {
        let coordinates = point.iter().zip(deviations);
        coordinates.map(|(x, deviation)| x / deviation).collect()
    };
    let (good, failed): (Vec<_>, Vec<_>) = points
        .iter()
        .map(standard)
        .zip(values)
        .partition(|(_, y)| y.is_finite());
    let [good, failed] = [good, failed].map(|runs| {
        let points = runs.into_iter().map(|(point, _)| point);
        points.collect::<Vec<Vec<f64>>>()
    });
    if good.is_empty() || failed.is_empty() {
        return 0.0;
    }
    let unit = |input: usize| (0..deviations.len()).map(move |i| f64::from(u8::from(i == input)));
    let along = (0..deviations.len()).map(|input| unit(input).collect());
    let all = along.chain([between_middles(&good, &failed)]);
    let distances = all.map(|direction: Vec<f64>| {
        let backwards = direction.iter().map(|d| -d).collect::<Vec<f64>>();
        let ways = [direction, backwards].map(|way| last(&failed, &way) - last(&good, &way));
        ways[0].max(ways[1])
    });
    distances.filter(|d| d.is_finite()).fold(0.0, f64::max)
}

/// Largest coordinate along a direction.
fn last(points: &[Vec<f64>], direction: &[f64]) -> f64 {
    let along = |point: &Vec<f64>| point.iter().zip(direction).map(|(x, d)| x * d).sum::<f64>();
    points.iter().map(along).fold(f64::NEG_INFINITY, f64::max)
}

/// Direction from the mean of some points to the mean of others, of unit length.
fn between_middles(from: &[Vec<f64>], to: &[Vec<f64>]) -> Vec<f64> {
    let mean = |points: &[Vec<f64>], input: usize| {
        points.iter().map(|point| point[input]).sum::<f64>() / points.len() as f64
    };
    let inputs = from.first().map_or(0, Vec::len);
    let step: Vec<f64> = (0..inputs).map(|i| mean(to, i) - mean(from, i)).collect();
    let length = step.iter().map(|d| d * d).sum::<f64>().sqrt();
    step.iter().map(|d| d / length).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a grid of steps of 0.1 on the unit square.
    fn grid() -> Vec<Vec<f64>> {
        let at = |k: usize| vec![(k / 11) as f64 / 10.0, (k % 11) as f64 / 10.0];
        (0..121).map(at).collect()
    }

    fn distance(fails: impl Fn(&[f64]) -> bool) -> f64 {
        let points = grid();
        let value = |x: &Vec<f64>| if fails(x) { f64::NAN } else { 1.0 };
        let values: Vec<f64> = points.iter().map(value).collect();
        beyond_others(&points, &values, &[0.5; 2])
    }

    #[test]
    fn what_fails_at_an_end_or_in_a_corner_lies_beyond() {
        // 0.3 of the first input, and 0.4 of the second
        assert!((distance(|x| x[0] > 0.75) - 0.6).abs() < 1e-12);
        assert!((distance(|x| x[1] < 0.35) - 0.8).abs() < 1e-12);
        // from 1.6 to 2 along both inputs, and nothing along either
        let corner = distance(|x| x[0] + x[1] > 1.65);
        assert!((corner - 0.4 * 2f64.sqrt()).abs() < 1e-12, "{corner}");
    }

    #[test]
    fn what_fails_inside_does_not() {
        let inside = distance(|x| (x[0] - 0.5).hypot(x[1] - 0.5) < 0.25);
        assert!(inside < 1e-12, "{inside}");
        assert_eq!(distance(|_| false), 0.0);
        assert_eq!(distance(|_| true), 0.0);
    }

    #[test]
    fn deviations_are_those_of_the_points() {
        let found = deviations(&grid());
        assert!(found.iter().all(|d| (d - 0.1f64.sqrt()).abs() < 1e-12));
    }
}
