//! Fingerprint of a plan: what its points follow from, in a few letters that a table can carry.

use std::fmt::Write as _;

use sha2::{Digest, Sha256};

/// Bytes of the hash that are kept: of two plans, one in four thousand million pairs looks alike.
const BYTES: usize = 4;

/// The fingerprint of the plan that begins with these points. It begins with a letter, so that no spreadsheet takes it for a number. Points that an
/// adaptive method adds, and its tolerance, don't change it.
pub fn fingerprint(inputs: &[String], first_points: &[Vec<f64>]) -> String {
    let mut hash = Sha256::new();
    for name in inputs {
        hash.update(name.len().to_le_bytes());
        hash.update(name);
    }
    for x in first_points.iter().flatten() {
        hash.update(x.to_bits().to_le_bytes());
    }
    let mut text = "p".to_owned();
    for byte in hash.finalize().iter().take(BYTES) {
        // Writing to a string never fails.
        let _ = write!(text, "{byte:02x}");
    }
    text
}

/// Whether a cell holds a fingerprint, this plan's or another one's.
pub(super) fn is_fingerprint(cell: &str) -> bool {
    let digits = cell.strip_prefix('p').unwrap_or_default();
    digits.len() == 2 * BYTES && digits.bytes().all(|byte| byte.is_ascii_hexdigit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plans_are_told_apart() {
        let of = |name: &str, x: f64| fingerprint(&[name.to_owned()], &[vec![x]]);
        assert!(is_fingerprint(&of("a", 0.5)));
        assert_eq!(of("a", 0.5), of("a", 0.5));
        assert_ne!(of("a", 0.5), of("b", 0.5));
        assert_ne!(of("a", 0.5), of("a", 0.5 + f64::EPSILON));
        for other in ["p", "pfoot", "0123abcd", "p0123abcde"] {
            assert!(!is_fingerprint(other), "{other}");
        }
    }
}
