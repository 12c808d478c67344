//! A study's map as a VTU file: the inner surface at the means, with strains and indices on it.

use results::{IndexMap, MapLayer, StudyResult};
use serde_json::{Map, Value};
use vtu::{CellShape, DataArray, VtuGrid};

use super::export_choice::ExportError;

/// Value that stands where there is no number. No index, deviation or error is negative by so much, so that a threshold at zero finds it.
const MISSING: f64 = -1.0;

/// The text of the file.
///
/// # Errors
/// [`ExportError::NoMap`] without a map.
pub fn vtu(result: &StudyResult) -> Result<String, ExportError> {
    let map = result.map.as_ref().ok_or(ExportError::NoMap)?;
    let shape = &map.shape;
    let mut data = vec![DataArray::vectors(
        "displacement",
        "mm",
        &shape.displacement_mm,
    )];
    let mut left_out = Vec::new();
    for layer in &map.layers {
        add_layer(layer, result, &mut data, &mut left_out);
    }
    let grid = VtuGrid {
        points: shape.inflated_mm.clone(),
        shape: CellShape::Quad,
        cells: quads(map),
        texts: texts(result, &data, &left_out),
        point_data: data,
        cell_data: Vec::new(),
    };
    Ok(grid.to_xml()?)
}

/// The arrays of one direction.
fn add_layer(
    layer: &MapLayer,
    result: &StudyResult,
    data: &mut Vec<DataArray>,
    left_out: &mut Vec<String>,
) {
    let direction = layer.direction;
    let strain = layer.strain.clone();
    data.push(DataArray::floats(
        format!("strain_{direction}"),
        "1",
        1,
        strain,
    ));
    let mut add = |name: String, values: &[Option<f64>]| {
        if values.iter().all(Option::is_none) {
            left_out.push(name);
            return;
        }
        let numbers = values.iter().map(|value| value.unwrap_or(MISSING));
        let numbers = DataArray::floats(&name, "1", 1, numbers.collect());
        data.push(numbers);
        if values.iter().any(Option::is_none) {
            let known = values.iter().map(Option::is_some);
            data.push(DataArray::flags(format!("{name}_known"), known));
        }
    };
    add(format!("std_{direction}"), &layer.std);
    for (input, indices) in result.inputs.iter().zip(&layer.first_order) {
        add(format!("first_order_{direction}_{}", input.name), indices);
    }
    add(format!("first_order_error_{direction}"), &layer.error);
    for (input, errors) in result.inputs.iter().zip(&layer.first_order_error) {
        add(
            format!("first_order_error_{direction}_{}", input.name),
            errors,
        );
    }
}

/// Cells between neighbouring points, their normals outward.
fn quads(map: &IndexMap) -> Vec<u32> {
    let (columns, rows) = (map.theta_deg.len(), map.phi_deg.len());
    let point = |row: usize, column: usize| (row * columns + column) as u32;
    let cell = |row: usize, column: usize| {
        [
            point(row, column),
            point(row + 1, column),
            point(row + 1, column + 1),
            point(row, column + 1),
        ]
    };
    let rows = 0..rows.saturating_sub(1);
    rows.flat_map(|row| (0..columns.saturating_sub(1)).flat_map(move |column| cell(row, column)))
        .collect()
}

fn texts(
    result: &StudyResult,
    data: &[DataArray],
    left_out: &[String],
) -> Vec<(&'static str, String)> {
    let study = &result.study;
    let mut units = Map::from_iter([("points".to_owned(), Value::from("mm"))]);
    units.extend(data.iter().filter_map(|array| {
        let unit = array.unit?;
        Some((array.name.clone(), unit.into()))
    }));
    vec![
        ("study", study.id.clone()),
        ("name", study.name.clone()),
        ("spec_sha256", study.spec_sha256.clone()),
        ("version", study.version.clone()),
        ("units", Value::Object(units).to_string()),
        ("reading", READING.to_owned()),
        ("left_out", Value::from(left_out).to_string()),
    ]
}

const READING: &str = "Points are those of the inner surface of the inflated tire before contact, x in the rolling direction, y along the axle, z upward \
    from the wheel's centre; displacement is from there to the equilibrium at the means of the inputs. strain_x is circumferential, strain_y meridional, \
    both relative to the inflated tire, at the means; std_ is their standard deviation, first_order_x_NAME the first-order Sobol index of the input NAME \
    for strain_x, first_order_error_x_NAME its error, first_order_error_x the largest of these. Where there is no number stands -1, and 0 in the array of the same name that ends \
    in _known; arrays without any number are named in left_out.";

#[cfg(test)]
mod tests {
    use fem_client::solver::MapShape;
    use fem_client::solver::direction::Direction;
    use results::InputReport;
    use vtu::Values;

    use super::*;

    /// Three by three points; the middle one has no index in x, none has an error in y.
    fn result() -> StudyResult {
        let gap = |value: f64| {
            (0..9)
                .map(|k| (k != 4).then_some(value))
                .collect::<Vec<_>>()
        };
        let layer = |direction, index: Vec<Option<f64>>, error: Vec<Option<f64>>| MapLayer {
            direction,
            strain: vec![0.5; 9],
            std: vec![Some(0.25); 9],
            first_order: vec![index],
            error: error.clone(),
            first_order_error: vec![error],
            total: Vec::new(),
            status: Vec::new(),
        };
        let grid = |scale: f64| {
            (0..9)
                .map(|k| [scale * f64::from(k % 3), scale * f64::from(k / 3), 0.0])
                .collect()
        };
        StudyResult {
            inputs: vec![InputReport {
                name: "P3".to_owned(),
                vary: "ground.depths_mm[2]".to_owned(),
                distribution: Value::Null,
            }],
            map: Some(IndexMap {
                theta_deg: vec![-1.0, 0.0, 1.0],
                phi_deg: vec![-2.0, 0.0, 2.0],
                layers: vec![
                    layer(Direction::X, gap(0.75), gap(0.125)),
                    layer(Direction::Y, vec![Some(1.0); 9], vec![None; 9]),
                ],
                shape: MapShape {
                    inflated_mm: grid(1.0),
                    displacement_mm: grid(0.5),
                },
            }),
            ..StudyResult::default()
        }
    }

    #[test]
    fn what_does_not_exist_is_marked_and_never_a_nan() {
        let result = result();
        let map = result.map.as_ref().expect("a map");
        let (mut data, mut left_out) = (Vec::new(), Vec::new());
        for layer in &map.layers {
            add_layer(layer, &result, &mut data, &mut left_out);
        }
        let names: Vec<&str> = data.iter().map(|array| array.name.as_str()).collect();
        let expected = [
            "strain_x",
            "std_x",
            "first_order_x_P3",
            "first_order_x_P3_known",
            "first_order_error_x",
            "first_order_error_x_known",
            "first_order_error_x_P3",
            "first_order_error_x_P3_known",
            "strain_y",
            "std_y",
            "first_order_y_P3",
        ];
        assert_eq!(names, expected);
        assert_eq!(left_out, ["first_order_error_y", "first_order_error_y_P3"]);
        let mut index = vec![0.75; 9];
        index[4] = MISSING;
        assert_eq!(data[2].values, Values::Float(index));
        let mut known = vec![1; 9];
        known[4] = 0;
        assert_eq!(data[3].values, Values::Byte(known));
        let xml = vtu(&result).expect("a file");
        assert!(
            xml.contains("ComponentName0=\"[&quot;first_order_error_y&quot;,&quot;first_order_error_y_P3&quot;]\"")
                && !xml.contains("NaN")
        );
    }

    #[test]
    fn cells_lie_between_neighbours() {
        let result = result();
        let cells = quads(result.map.as_ref().expect("a map"));
        assert_eq!(cells[..8], [0, 3, 4, 1, 1, 4, 5, 2]);
        assert_eq!(cells.len(), 4 * 4);
    }

    #[test]
    fn without_a_map_there_is_no_file() {
        let mut result = result();
        result.map = None;
        assert!(matches!(vtu(&result), Err(ExportError::NoMap)));
    }
}
