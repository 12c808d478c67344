//! Claims beside true errors: how many hold, and by how much.

/// Share of the claims that are to hold.
pub const SHARE: f64 = 0.97;

/// Returns how many claims are at least the error, percent.
pub fn held(errors: &[f64], claims: &[f64]) -> f64 {
    let pairs = errors.iter().zip(claims);
    100.0 * pairs.filter(|(error, claim)| error <= claim).count() as f64 / errors.len() as f64
}

/// Returns the quantile of true errors over claims.
pub fn over(errors: &[f64], claims: &[f64], share: f64) -> f64 {
    let pairs = errors.iter().zip(claims);
    quantile(pairs.map(|(error, claim)| error / claim).collect(), share)
}

/// Returns the value that so large a share of all values has below it: of those between two ranks the larger one.
pub fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[(share * (values.len() - 1) as f64).ceil() as usize]
}
