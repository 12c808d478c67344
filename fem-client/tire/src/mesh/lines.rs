//! Grid lines of a tire's mesh: where bricks begin and end along each direction.

/// Brick of a grid line that holds a coordinate (in the unit of the edges), and the place in it, -1 to 1.
pub fn locate(edges: &[f64], value: f64) -> (usize, f64) {
    let last = edges.len() - 2;
    let index = edges
        .partition_point(|&edge| edge <= value)
        .saturating_sub(1)
        .min(last);
    let local = 2.0 * (value - edges[index]) / (edges[index + 1] - edges[index]) - 1.0;
    (index, local.clamp(-1.0, 1.0))
}

/// Edges from 0 to pi, rad: a fine sector, then sizes that grow geometrically from the fine size.
pub fn half_circle(fine_angle: f64, fine: usize, coarse: usize) -> Vec<f64> {
    let size = fine_angle / fine as f64;
    let mut edges: Vec<f64> = (0..fine).map(|i| size * i as f64).collect();
    let rest = std::f64::consts::PI - fine_angle;
    let ratio = growth_ratio(rest / size, coarse);
    edges.extend(graded(
        fine_angle,
        std::f64::consts::PI,
        coarse,
        ratio.powi(coarse as i32 - 1),
    ));
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

/// Section radii of the boundaries of `n` layers between inner and outer radius, one of them at the carcass.
pub fn layers(inner: f64, outer: f64, carcass: Option<f64>, n: usize) -> Vec<f64> {
    let wall = outer - inner;
    let below = carcass.map_or(0, |rho| {
        let share = (rho - inner) / wall;
        if share <= 0.0 || share >= 1.0 {
            0
        } else {
            ((share * n as f64).round() as usize).clamp(1, n - 1)
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
