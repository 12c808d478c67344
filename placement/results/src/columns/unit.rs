//! Units of fields and columns, which their names end with.

/// A pure number's.
pub const PURE: &str = "1";
/// Unit of hundredths, and of their differences.
pub(crate) const PERCENT: &str = "%";

/// Endings of names with the units that they stand for; a longer one stands before those that it ends with.
const ENDINGS: [(&str, &str); 11] = [
    ("_percent", PERCENT),
    ("_n_per_mm3", "N/mm^3"),
    ("_n_per_mm", "N/mm"),
    ("_per_mpa", "1/MPa"),
    ("_mpa", "MPa"),
    ("_mm", "mm"),
    ("_deg", "deg"),
    ("_nc", "nC"),
    ("_n", "N"),
    ("_s", "s"),
    ("_v", "V"),
];

/// The unit of the field at a path such as `ground.depths_mm[2]`; `1` for a pure number.
pub fn unit_of(path: &str) -> &'static str {
    let field = path.rsplit('.').next().unwrap_or_default();
    let name = field.split('[').next().unwrap_or_default();
    let named = ENDINGS.iter().find(|(ending, _)| name.ends_with(ending));
    named.map_or(PURE, |(_, unit)| unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_s_name_says_its_unit() {
        for (path, unit) in [
            ("ground.depths_mm[2]", "mm"),
            ("material.terms[0].mu_mpa", "MPa"),
            ("material.terms[0].alpha", "1"),
            ("material.d1_per_mpa", "1/MPa"),
            ("carcass.stiffness_n_per_mm", "N/mm"),
            ("contact.penalty_n_per_mm3", "N/mm^3"),
            ("contact.friction", "1"),
            ("geometry.bead_angle_deg", "deg"),
        ] {
            assert_eq!(unit_of(path), unit, "{path}");
        }
    }
}
