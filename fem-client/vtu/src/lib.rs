//! Solved tires for pictures: unstructured grids as VTU files, VTK's XML format, for ParaView and its like; and the skins of the whole wheel as glTF.
//!
//! Arrays follow the grid as base64 of little-endian numbers, so that the file is well-formed XML and every bit of a number is kept. A text of the
//! field data is an array of its UTF-8 bytes, with the text itself as the name of its component: meshio refuses whole files for VTK's
//! arrays of strings. An array's unit is VTK's own `UNITS_LABEL`.

pub mod solved_body;
pub mod wheel_glb;
pub mod wheel_skins;

use std::fmt::Write;

/// Points, cells of one kind, and what is known of them.
#[derive(Debug, Clone, PartialEq)]
pub struct VtuGrid {
    /// Coordinates, mm.
    pub points: Vec<[f64; 3]>,
    /// Shape of every cell.
    pub shape: CellShape,
    /// Points of the cells, one cell after the other, in VTK's order.
    pub cells: Vec<u32>,
    /// Arrays with a tuple per point.
    pub point_data: Vec<DataArray>,
    /// Arrays with a tuple per cell.
    pub cell_data: Vec<DataArray>,
    /// Names and texts: where it is from, and how to read it.
    pub texts: Vec<(&'static str, String)>,
}

/// Cells of VTK.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellShape {
    /// 4 points.
    Quad,
    /// 8 points.
    Hexahedron,
    /// 27 points.
    TriquadraticHexahedron,
}

impl CellShape {
    /// VTK's number of the type, and the points of a cell.
    fn numbers(self) -> (u8, usize) {
        match self {
            Self::Quad => (9, 4),
            Self::Hexahedron => (12, 8),
            Self::TriquadraticHexahedron => (29, 27),
        }
    }
}

/// A named array.
#[derive(Debug, Clone, PartialEq)]
pub struct DataArray {
    /// Its name.
    pub name: String,
    /// Its unit; `1` for pure numbers, `None` for flags.
    pub unit: Option<&'static str>,
    /// Numbers in a tuple.
    pub components: usize,
    /// All numbers, tuple by tuple.
    pub values: Values,
}

/// Numbers of an array.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// 64-bit floating point.
    Float(Vec<f64>),
    /// Flags.
    Byte(Vec<u8>),
}

impl DataArray {
    /// Numbers, this many in a tuple.
    pub fn floats(
        name: impl Into<String>,
        unit: &'static str,
        components: usize,
        values: Vec<f64>,
    ) -> Self {
        Self {
            name: name.into(),
            unit: Some(unit),
            components,
            values: Values::Float(values),
        }
    }

    /// Vectors of a unit.
    pub fn vectors(name: &str, unit: &'static str, values: &[[f64; 3]]) -> Self {
        Self::floats(name, unit, 3, values.as_flattened().to_vec())
    }

    /// One flag in a tuple: 1 for yes.
    pub fn flags(name: impl Into<String>, values: impl Iterator<Item = bool>) -> Self {
        Self {
            name: name.into(),
            unit: None,
            components: 1,
            values: Values::Byte(values.map(u8::from).collect()),
        }
    }
}

/// A grid that no reader would understand.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum VtuError {
    /// NaN or an infinity.
    #[error("{array} has a number that isn't finite")]
    NotFinite {
        /// The array.
        array: String,
    },
    /// Too few or too many numbers.
    #[error("{array} has {numbers} numbers where {expected} belong")]
    Length {
        /// The array.
        array: String,
        /// What it has.
        numbers: usize,
        /// What it should have.
        expected: usize,
    },
    /// A cell has a point that isn't there.
    #[error("a cell has the point {point} of {points}")]
    Point {
        /// Its number.
        point: u32,
        /// How many there are.
        points: usize,
    },
}

impl VtuGrid {
    /// The text of the file.
    ///
    /// # Errors
    /// [`VtuError`] when lengths don't fit or a number isn't finite.
    pub fn to_xml(&self) -> Result<String, VtuError> {
        let (kind, corners) = self.shape.numbers();
        let count = self.cells.len() / corners;
        self.check(count, corners)?;
        let mut file = Writer::default();
        file.line("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
        file.line("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">");
        file.line("<UnstructuredGrid>\n<FieldData>");
        for (name, text) in self.texts.iter().filter(|(_, text)| !text.is_empty()) {
            file.text(name, text);
        }
        file.line("</FieldData>");
        let points = self.points.len();
        file.line(&format!(
            "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{count}\">"
        ));
        file.arrays("PointData", &self.point_data);
        file.arrays("CellData", &self.cell_data);
        file.arrays(
            "Points",
            &[DataArray::vectors("Points", "mm", &self.points)],
        );
        let connectivity = self.cells.iter().map(|&point| i64::from(point));
        let offsets = (1..=count).map(|cell| (cell * corners) as i64);
        file.line("<Cells>");
        file.array("Int64", "connectivity", "", &words(connectivity), None);
        file.array("Int64", "offsets", "", &words(offsets), None);
        file.array("UInt8", "types", "", &vec![kind; count], None);
        file.line("</Cells>\n</Piece>\n</UnstructuredGrid>");
        file.line("<AppendedData encoding=\"base64\">");
        let Writer { xml, appended } = file;
        Ok(format!("{xml}_{appended}\n</AppendedData>\n</VTKFile>\n"))
    }

    fn check(&self, count: usize, corners: usize) -> Result<(), VtuError> {
        let length = |array: &str, numbers: usize, expected: usize| {
            let array = array.to_owned();
            let error = VtuError::Length {
                array,
                numbers,
                expected,
            };
            (numbers == expected).then_some(()).ok_or(error)
        };
        let points = self.points.len();
        length("cells", self.cells.len(), count * corners)?;
        if let Some(&point) = self.cells.iter().find(|&&point| point as usize >= points) {
            return Err(VtuError::Point { point, points });
        }
        finite("points", self.points.as_flattened())?;
        let of_points = self.point_data.iter().map(|array| (array, points));
        let of_cells = self.cell_data.iter().map(|array| (array, count));
        for (array, tuples) in of_points.chain(of_cells) {
            let expected = tuples * array.components;
            match &array.values {
                Values::Float(values) => {
                    length(&array.name, values.len(), expected)?;
                    finite(&array.name, values)?;
                }
                Values::Byte(values) => length(&array.name, values.len(), expected)?,
            }
        }
        Ok(())
    }
}

fn finite(array: &str, values: &[f64]) -> Result<(), VtuError> {
    let array = || array.to_owned();
    let all = values.iter().all(|value| value.is_finite());
    all.then_some(())
        .ok_or_else(|| VtuError::NotFinite { array: array() })
}

fn words(numbers: impl Iterator<Item = i64>) -> Vec<u8> {
    numbers.flat_map(i64::to_le_bytes).collect()
}

/// A file in the making: its elements, and the data that follow them.
#[derive(Default)]
struct Writer {
    xml: String,
    appended: String,
}

impl Writer {
    fn line(&mut self, line: &str) {
        self.xml.push_str(line);
        self.xml.push('\n');
    }

    fn text(&mut self, name: &str, text: &str) {
        let attributes = format!(
            " NumberOfTuples=\"{}\" ComponentName0=\"{}\"",
            text.len(),
            escaped(text)
        );
        self.array("UInt8", name, &attributes, text.as_bytes(), None);
    }

    fn arrays(&mut self, element: &str, arrays: &[DataArray]) {
        self.line(&format!("<{element}>"));
        for array in arrays {
            // Without the attribute, readers take an array of plain numbers.
            let attributes = match array.components {
                1 => String::new(),
                components => format!(" NumberOfComponents=\"{components}\""),
            };
            let (kind, bytes) = match &array.values {
                Values::Float(values) => (
                    "Float64",
                    values.iter().copied().flat_map(f64::to_le_bytes).collect(),
                ),
                Values::Byte(values) => ("UInt8", values.clone()),
            };
            self.array(kind, &array.name, &attributes, &bytes, array.unit);
        }
        self.line(&format!("</{element}>"));
    }

    /// One array: its element here, its length and bytes behind all elements.
    fn array(
        &mut self,
        kind: &str,
        name: &str,
        attributes: &str,
        bytes: &[u8],
        unit: Option<&str>,
    ) {
        let (name, offset) = (escaped(name), self.appended.len());
        // Writing to a string cannot fail.
        let _ = write!(
            self.xml,
            "<DataArray type=\"{kind}\" Name=\"{name}\"{attributes} format=\"appended\" offset=\"{offset}\""
        );
        match unit {
            Some(unit) => self.line(&format!(
                "><InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey></DataArray>",
                escaped(unit)
            )),
            None => self.line("/>"),
        }
        let mut block = (bytes.len() as u64).to_le_bytes().to_vec();
        block.extend_from_slice(bytes);
        push_base64(&mut self.appended, &block);
    }
}

/// A text as XML has it within quotes; what XML can't hold becomes the replacement character.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push(char::REPLACEMENT_CHARACTER),
            control if control.is_control() => escaped.push(char::REPLACEMENT_CHARACTER),
            other => escaped.push(other),
        }
    }
    escaped
}

/// Base64 of RFC 4648, padded.
fn push_base64(text: &mut String, bytes: &[u8]) {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for group in bytes.chunks(3) {
        let byte = |k: usize| u32::from(group.get(k).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            text.push(if digit <= group.len() {
                char::from(DIGITS[(bits >> (18 - 6 * digit) & 63) as usize])
            } else {
                '='
            });
        }
    }
}

#[cfg(test)]
mod tests;
