//! Derivatives of a response as text.

use std::fmt::Write;

use fem_client::solver::derivative::Derivative;
use serde_json::Value;

/// A microstrain.
pub(super) const MICROSTRAIN: f64 = 1e-6;

/// Block of lines for each derivative: per unit of the number, in the units of the report above it.
pub(super) fn derivative_text(derivatives: &[Derivative]) -> String {
    derivatives.iter().map(block).collect()
}

fn block(derivative: &Derivative) -> String {
    let of = |field: &str| number(derivative.of.get(field), 1.0);
    let inflated = derivative.of.get("inflated");
    let radius = number(
        inflated.and_then(|inflated| inflated.get("outer_radius_mm")),
        1.0,
    );
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "\nper unit of {}: reaction {} N, depth {} mm, inflated radius {radius} mm",
        derivative.by,
        of("reaction_n"),
        of("depth_mm"),
    );
    let locations = derivative.of.get("locations").and_then(Value::as_array);
    for location in locations.into_iter().flatten() {
        let strain = |field: &str| number(location.get(field), MICROSTRAIN);
        let _ = writeln!(
            text,
            "{:4} {:>48} {:>22} {:>18}",
            location
                .get("name")
                .and_then(Value::as_str)
                .unwrap_or_default(),
            strain("strain_x"),
            strain("strain_y"),
            number(location.get("von_mises_mpa"), 1.0),
        );
    }
    text
}

/// A number in a unit, to six digits.
fn number(value: Option<&Value>, unit: f64) -> String {
    let value = value.and_then(Value::as_f64);
    value.map_or_else(String::new, |value| {
        let value = value / unit;
        match value.abs().log10().floor() {
            _ if value == 0.0 => "0".to_owned(),
            whole if (-4.0..6.0).contains(&whole) => {
                format!("{value:.*}", (5.0 - whole).max(0.0) as usize)
            }
            _ => format!("{value:.5e}"),
        }
    })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_block_says_per_unit_of_what() {
        let of = json!({"reaction_n": 12.345_678_9, "depth_mm": 0.2, "inflated": {"outer_radius_mm": 0.0},
            "locations": [{"name": "P3", "strain_x": -0.012_345_67, "strain_y": 1e-12, "von_mises_mpa": 0.5}]});
        let Value::Object(of) = of else {
            unreachable!("an object")
        };
        let by = "ground.depths_mm[2]".to_owned();
        let text = derivative_text(&[Derivative { by, of }]);
        let words: Vec<&str> = text.split_whitespace().collect();
        assert_eq!(words[3], "ground.depths_mm[2]:");
        assert_eq!(words[5], "12.3457");
        assert_eq!(
            words[words.len() - 4..],
            ["P3", "-12345.7", "1.00000e-6", "0.500000"]
        );
        assert_eq!(derivative_text(&[]), "");
    }
}
