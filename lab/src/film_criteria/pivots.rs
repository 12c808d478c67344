//! Choice of sensors by pivoted QR, and effective independence, of rows of a basis.
//!
//! Rows are sensors, columns modes. Pivoting takes the row that is longest after those before are projected out (K. Manohar et al., IEEE Control Syst. 38
//! (2018) 63). A row's effective independence is its leverage, the diagonal of B (B'B)^-1 B' (D. C. Kammer, J. Guid. Control Dyn. 14 (1991) 251).

/// Length of what is left of a row, over the longest row, below which it adds nothing.
const NOTHING: f64 = 1e-10;

/// Rows in the order in which pivoting takes them; those that add nothing are left out.
pub(crate) fn pivot_order(basis: &[Vec<f64>]) -> Vec<usize> {
    let mut rest = basis.to_vec();
    let longest = rest.iter().map(|row| length(row)).fold(0.0, f64::max);
    let mut order = Vec::new();
    loop {
        let open = (0..rest.len()).filter(|row| !order.contains(row));
        // The first of equals.
        let next = open.fold(None, |best: Option<(usize, f64)>, row| {
            let length = length(&rest[row]);
            match best {
                Some((_, longest)) if length <= longest => best,
                _ => Some((row, length)),
            }
        });
        let Some((row, size)) = next.filter(|(_, size)| *size > NOTHING * longest) else {
            return order;
        };
        let direction: Vec<f64> = rest[row].iter().map(|value| value / size).collect();
        for other in &mut rest {
            let along: f64 = other.iter().zip(&direction).map(|(a, b)| a * b).sum();
            other
                .iter_mut()
                .zip(&direction)
                .for_each(|(value, part)| *value -= along * part);
        }
        order.push(row);
    }
}

/// Leverage of each row, 0 to 1: columns that add nothing to those before are left out.
pub fn effective_independence(basis: &[Vec<f64>]) -> Vec<f64> {
    let columns = basis.first().map_or(0, Vec::len);
    let mut leverage = vec![0.0; basis.len()];
    let mut orthonormal: Vec<Vec<f64>> = Vec::new();
    let column = |j: usize| -> Vec<f64> { basis.iter().map(|row| row[j]).collect() };
    let longest = (0..columns).map(|j| length(&column(j))).fold(0.0, f64::max);
    for j in 0..columns {
        let mut rest = column(j);
        // Twice is enough for orthogonality to rounding.
        for _ in 0..2 {
            for direction in &orthonormal {
                let along: f64 = rest.iter().zip(direction).map(|(a, b)| a * b).sum();
                rest.iter_mut()
                    .zip(direction)
                    .for_each(|(value, part)| *value -= along * part);
            }
        }
        let size = length(&rest);
        if size > NOTHING * longest {
            rest.iter_mut().for_each(|value| *value /= size);
            leverage
                .iter_mut()
                .zip(&rest)
                .for_each(|(sum, value)| *sum += value * value);
            orthonormal.push(rest);
        }
    }
    leverage
}

fn length(row: &[f64]) -> f64 {
    row.iter().map(|value| value * value).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leverages_sum_to_the_rank() {
        let basis = vec![
            vec![1.0, 0.0, 1.0],
            vec![0.0, 2.0, 2.0],
            vec![1.0, 1.0, 2.0],
            vec![3.0, -1.0, 2.0],
        ];
        // The third column is the sum of the others.
        let leverage = effective_independence(&basis);
        assert!((leverage.iter().sum::<f64>() - 2.0).abs() < 1e-12);
        // B'B of the first two columns is [[11, -2], [-2, 6]], determinant 62: rows (1, 0) -> 6/62, (0, 2) -> 44/62.
        assert!(
            (leverage[0] - 6.0 / 62.0).abs() < 1e-12 && (leverage[1] - 44.0 / 62.0).abs() < 1e-12
        );
    }

    /// SciPy's pivoted QR and PySensors 0.4's `QR` optimiser take these rows of this basis in this order; NumPy gives these leverages.
    #[test]
    fn rows_are_taken_in_the_order_of_other_programs() {
        let entry = |i: usize, j: usize| {
            let (i, j) = (i as f64, j as f64);
            (0.7 * (i + 1.0) * (j + 1.0)).sin() + 0.3 * (1.3 * i + 0.4 * j * j).cos()
        };
        let basis: Vec<Vec<f64>> = (0..14)
            .map(|i| (0..5).map(|j| entry(i, j)).collect())
            .collect();
        assert_eq!(pivot_order(&basis), [10, 2, 9, 3, 7]);
        let leverage = effective_independence(&basis);
        for (row, expected) in [
            (0, 0.32466341),
            (6, 0.61941702),
            (8, 0.04986564),
            (13, 0.2820086),
        ] {
            assert!(
                (leverage[row] - expected).abs() < 1e-8,
                "{row}: {}",
                leverage[row]
            );
        }
    }

    #[test]
    fn rows_that_add_nothing_are_not_taken() {
        assert_eq!(
            pivot_order(&[vec![1.0, 0.0], vec![3.0, 0.0], vec![0.0, 2.0]]),
            [1, 2]
        );
        assert!(pivot_order(&[vec![0.0, 0.0]]).is_empty());
    }
}
