//! Kendall's tau: how far two criteria order the same things alike.

/// Kendall's tau-b of two lists of figures of the same things; `None` where either is the same for all. (M. G. Kendall, Biometrika 33 (1945) 239)
pub fn tau(a: &[f64], b: &[f64]) -> Option<f64> {
    let (mut alike, mut in_a, mut in_b) = (0.0, 0.0, 0.0);
    for i in 0..a.len() {
        for j in 0..i {
            let [x, y] = [sign(a[i] - a[j]), sign(b[i] - b[j])];
            alike += x * y;
            in_a += x * x;
            in_b += y * y;
        }
    }
    (in_a > 0.0 && in_b > 0.0).then(|| alike / f64::sqrt(in_a * in_b))
}

fn sign(difference: f64) -> f64 {
    if difference > 0.0 {
        1.0
    } else if difference < 0.0 {
        -1.0
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_agree_disagree_or_say_nothing() {
        assert_eq!(tau(&[1.0, 2.0, 3.0], &[10.0, 20.0, 30.0]), Some(1.0));
        assert_eq!(tau(&[1.0, 2.0, 3.0], &[3.0, 2.0, 1.0]), Some(-1.0));
        assert_eq!(tau(&[1.0, 1.0], &[1.0, 2.0]), None);
        // scipy.stats.kendalltau([12, 2, 1, 12, 2], [1, 4, 7, 1, 0]): -0.47140452079103173
        let found =
            tau(&[12.0, 2.0, 1.0, 12.0, 2.0], &[1.0, 4.0, 7.0, 1.0, 0.0]).expect("both vary");
        assert!((found + 0.471_404_520_791_031_73).abs() < 1e-15);
    }
}
