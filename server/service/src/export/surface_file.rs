//! The wheel's skins as numbers that a browser draws as they come.
//!
//! Little-endian: the length of the header as u32; the header, JSON in UTF-8, padded by spaces so that what follows begins at a multiple of four bytes; then lists of
//! 32-bit floats, whose places the header says.

use serde_json::{Value, json};
use vtu::wheel_skins::WheelSkins;

/// Bytes of a number.
const WORD: usize = 4;
/// Numbers of a point.
const COMPONENTS: usize = 3;

/// The bytes of the file for a study whose wheel was solved on the mesh of this level.
pub fn surface_file(study: &str, level: &str, skins: &WheelSkins) -> Vec<u8> {
    let (inner, outer) = (&skins.inner, &skins.outer);
    let lists = [
        ("inner_inflated_mm", &inner.inflated_mm),
        ("inner_displacement_mm", &inner.displacement_mm),
        ("outer_inflated_mm", &outer.inflated_mm),
        ("outer_displacement_mm", &outer.displacement_mm),
    ];
    let (mut arrays, mut numbers) = (Vec::<Value>::new(), Vec::new());
    for (name, points) in lists {
        arrays.push(json!({
            "name": name, "unit": "mm", "components": COMPONENTS, "offset": numbers.len(), "count": points.len(),
        }));
        let singles = points.as_flattened().iter().map(|&x| x as f32);
        numbers.extend(singles.flat_map(f32::to_le_bytes));
    }
    let along = |i: usize| {
        skins
            .ground
            .iter()
            .map(|point| point[i])
            .collect::<Vec<f64>>()
    };
    let header = json!({
        "study": study,
        "level": level,
        "rows": skins.phi_deg.len(),
        "columns": skins.theta_deg.len(),
        "phi_deg": skins.phi_deg,
        "theta_deg": skins.theta_deg,
        "ground": {"x_mm": along(0), "z_mm": along(1), "camber_deg": skins.camber_deg},
        "arrays": arrays,
    });
    let mut header = header.to_string().into_bytes();
    header.resize(header.len().next_multiple_of(WORD), b' ');
    let length = (header.len() as u32).to_le_bytes();
    [&length[..], &header, &numbers].concat()
}

#[cfg(test)]
mod tests {
    use vtu::wheel_skins::Skin;

    use super::*;

    #[test]
    fn every_list_is_where_the_header_says() {
        let skin = |start: f64| {
            let list = |start: f64| {
                (0..6)
                    .map(|k| [0.0, 1.0, 2.0].map(|i| start + f64::from(k) + i / 8.0))
                    .collect()
            };
            Skin {
                inflated_mm: list(start),
                displacement_mm: list(start + 100.0),
            }
        };
        let skins = WheelSkins {
            phi_deg: vec![-1.0, 0.0, 1.0],
            theta_deg: vec![-180.0, 0.0],
            inner: skin(0.0),
            outer: skin(1000.0),
            ground: vec![[-1.0, -50.0], [1.0, -49.5]],
            camber_deg: 2.5,
        };
        for study in ["a", "ab", "abc", "abcd"] {
            let file = surface_file(study, "draft", &skins);
            let length = u32::from_le_bytes(file[..4].try_into().expect("four bytes")) as usize;
            assert_eq!(length % 4, 0);
            let header: Value = serde_json::from_slice(&file[4..4 + length]).expect("JSON");
            assert_eq!(
                (&header["study"], &header["level"]),
                (&json!(study), &json!("draft"))
            );
            assert_eq!(
                (&header["rows"], &header["columns"]),
                (&json!(3), &json!(2))
            );
            assert_eq!(
                header["ground"],
                json!({"x_mm": [-1.0, 1.0], "z_mm": [-50.0, -49.5], "camber_deg": 2.5})
            );
            let numbers = &file[4 + length..];
            let lists = [
                &skins.inner.inflated_mm,
                &skins.inner.displacement_mm,
                &skins.outer.inflated_mm,
                &skins.outer.displacement_mm,
            ];
            let arrays = header["arrays"].as_array().expect("a list");
            assert_eq!((arrays.len(), numbers.len()), (4, 4 * 6 * 3 * 4));
            for (array, list) in arrays.iter().zip(lists) {
                let at = array["offset"].as_u64().expect("a number") as usize;
                let count = array["count"].as_u64().expect("a number") as usize;
                let words = numbers[at..at + 12 * count].as_chunks::<4>().0;
                // Eighths, which single precision holds.
                let read: Vec<f64> = words
                    .iter()
                    .map(|word| f32::from_le_bytes(*word).into())
                    .collect();
                assert_eq!(read, list.as_flattened(), "{}", array["name"]);
            }
        }
    }
}
