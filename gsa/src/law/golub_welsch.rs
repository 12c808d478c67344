//! Zeros of an orthogonal polynomial: the eigenvalues of its symmetric tridiagonal Jacobi matrix.
//!
//! G. H. Golub, J. H. Welsch, "Calculation of Gauss quadrature rules", Math. Comp. 23 (1969) 221-230. The
//! eigenvalues come from the implicit QL iteration with Wilkinson's shift; they are polished afterwards by Newton on
//! the recurrence, so the iteration need only be good to a few digits more than it takes to tell zeros apart.

use crate::law::recurrence::Recurrence;

/// QL needs two or three sweeps per eigenvalue; thirty is the customary bound.
const MAX_SWEEPS: usize = 30;
/// Newton doubles the digits: from 1e-13 one step reaches rounding, the others confirm it.
const POLISH_STEPS: usize = 3;

/// Zeros of p_N in ascending order; exactly mirrored, with an exact zero in the middle of odd rules, if the law is
/// symmetric. `None` if the iteration does not settle.
pub(crate) fn zeros(recurrence: &Recurrence) -> Option<Vec<f64>> {
    let mut t = tridiagonal_eigenvalues(recurrence.diagonal(), recurrence.off_diagonal())?;
    t.sort_by(f64::total_cmp);
    for zero in &mut t {
        for _ in 0..POLISH_STEPS {
            *zero -= recurrence.newton_step(*zero);
        }
    }
    if recurrence.is_symmetric() {
        mirror(&mut t);
    }
    t.windows(2).all(|pair| pair[0] < pair[1]).then_some(t)
}

fn mirror(t: &mut [f64]) {
    let n = t.len();
    for j in 0..n / 2 {
        t[j] = -t[n - 1 - j];
    }
    if n % 2 == 1 {
        t[n / 2] = 0.0;
    }
}

/// Eigenvalues, unordered, of the symmetric tridiagonal matrix with this diagonal and off-diagonal.
fn tridiagonal_eigenvalues(diagonal: &[f64], off_diagonal: &[f64]) -> Option<Vec<f64>> {
    let n = diagonal.len();
    let mut d = diagonal.to_vec();
    let mut e = off_diagonal.to_vec();
    e.push(0.0);
    for first in 0..n {
        let mut sweeps = 0;
        loop {
            let last = block_end(&d, &e, first);
            if last == first {
                break;
            }
            if sweeps == MAX_SWEEPS {
                return None;
            }
            sweeps += 1;
            ql_sweep(&mut d, &mut e, first, last);
        }
    }
    Some(d)
}

/// Last row of the unreduced block that starts at `first`: where the off-diagonal is negligible beside the diagonal.
fn block_end(d: &[f64], e: &[f64], first: usize) -> usize {
    (first..d.len() - 1)
        .find(|&m| e[m].abs() <= f64::EPSILON * (d[m].abs() + d[m + 1].abs()))
        .unwrap_or(d.len() - 1)
}

/// Does an implicit QL sweep on rows `first..=last`: a shift at the top, a bulge chased up from the bottom.
fn ql_sweep(d: &mut [f64], e: &mut [f64], first: usize, last: usize) {
    let half_gap = (d[first + 1] - d[first]) / (2.0 * e[first]);
    let shift = d[first] - e[first] / (half_gap + half_gap.hypot(1.0).copysign(half_gap));
    let mut g = d[last] - shift;
    let (mut sine, mut cosine, mut carried) = (1.0, 1.0, 0.0);
    for row in (first..last).rev() {
        let bulge = sine * e[row];
        let kept = cosine * e[row];
        let radius = bulge.hypot(g);
        e[row + 1] = radius;
        if radius == 0.0 {
            // The block fell apart by itself; the next sweep works on the smaller one.
            d[row + 1] -= carried;
            e[last] = 0.0;
            return;
        }
        sine = bulge / radius;
        cosine = g / radius;
        g = d[row + 1] - carried;
        let turn = (d[row] - g) * sine + 2.0 * cosine * kept;
        carried = sine * turn;
        d[row + 1] = g + carried;
        g = cosine * turn - kept;
    }
    d[first] -= carried;
    e[first] = g;
    e[last] = 0.0;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvalues_of_the_second_difference_matrix() {
        // diagonal 2, off-diagonal -1: lambda_k = 2 - 2 cos(k pi / (n + 1))
        let n = 40;
        let mut found = tridiagonal_eigenvalues(&vec![2.0; n], &vec![-1.0; n - 1]).unwrap();
        found.sort_by(f64::total_cmp);
        for (k, value) in found.iter().enumerate() {
            let angle = (k + 1) as f64 * std::f64::consts::PI / (n + 1) as f64;
            // backward stable: n eps times the norm, which is 4
            assert!((value - (2.0 - 2.0 * angle.cos())).abs() < 160.0 * f64::EPSILON);
        }
    }

    #[test]
    fn a_split_matrix_is_solved_block_by_block() {
        let mut found = tridiagonal_eigenvalues(&[3.0, 1.0, 1.0], &[0.0, 1.0]).unwrap();
        found.sort_by(f64::total_cmp);
        for (value, expected) in found.iter().zip([0.0, 2.0, 3.0]) {
            assert!((value - expected).abs() < 8.0 * f64::EPSILON);
        }
    }

    #[test]
    fn zeros_of_a_skewed_law_need_no_symmetry() {
        // Laguerre (exponential law): a_k = 2k+1, b_k = k^2; zeros of L_2 are 2 -+ sqrt(2)
        let found = tridiagonal_eigenvalues(&[1.0, 3.0], &[1.0]).unwrap();
        let sum: f64 = found.iter().sum();
        let product: f64 = found.iter().product();
        assert!(
            (sum - 4.0).abs() < 8.0 * f64::EPSILON && (product - 2.0).abs() < 16.0 * f64::EPSILON
        );
    }

    #[test]
    fn symmetric_zeros_are_exact_mirrors() {
        for n in 1..=64 {
            let t = zeros(&Recurrence::hermite(n)).unwrap();
            for j in 0..n {
                assert_eq!(t[j], -t[n - 1 - j]);
            }
        }
    }
}
