//! Solved tires for pictures: unstructured grids as VTU files, VTK's XML format, for ParaView and its like; and the skins of the whole wheel as glTF.
//!
//! Arrays follow the grid as base64 of little-endian numbers, so that the file is well-formed XML and every bit of a number is kept. A text of the
//! field data is an array of its UTF-8 bytes, with the text itself as the name of its component: meshio refuses whole files for VTK's
//! arrays of strings. An array's unit is VTK's own `UNITS_LABEL`.

pub mod solved_body;
pub mod wheel_glb;
pub mod wheel_skins;

use std::fmt::Write;
use std::iter;

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
    /// Name of the array.
    pub name: String,
    /// Unit of the values; `1` for pure numbers, `None` for flags.
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

    /// Makes an array of flags, one a tuple: 1 for yes.
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
        /// Count of the numbers that it has.
        numbers: usize,
        /// Count of the numbers that it should have.
        expected: usize,
    },
    /// A cell has a point that isn't there.
    #[error("a cell has the point {point} of {points}")]
    Point {
        /// Number of the point.
        point: u32,
        /// Count of the points.
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
        let positions = Block::Floats(self.points.as_flattened());
        file.line("<Points>");
        file.array("Float64", "Points", &of_tuples(3), positions, Some("mm"));
        file.line("</Points>\n<Cells>");
        let offsets = Block::Offsets { count, corners };
        let types = Block::Types { kind, count };
        file.array(
            "Int64",
            "connectivity",
            "",
            Block::Points(&self.cells),
            None,
        );
        file.array("Int64", "offsets", "", offsets, None);
        file.array("UInt8", "types", "", types, None);
        file.line("</Cells>\n</Piece>\n</UnstructuredGrid>");
        file.line("<AppendedData encoding=\"base64\">");
        Ok(file.with_data())
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

/// Block of an array in the file, still as the grid has it: a map has megabytes, which are written once, into the file.
enum Block<'g> {
    Floats(&'g [f64]),
    Bytes(&'g [u8]),
    /// Points of the cells.
    Points(&'g [u32]),
    /// Ends of each cell's points.
    Offsets {
        count: usize,
        corners: usize,
    },
    /// Type of the cells, one for all.
    Types {
        kind: u8,
        count: usize,
    },
}

impl Block<'_> {
    fn bytes(&self) -> usize {
        match self {
            Self::Floats(values) => size_of_val(*values),
            Self::Bytes(values) => values.len(),
            Self::Points(points) => points.len() * size_of::<i64>(),
            Self::Offsets { count, .. } => count * size_of::<i64>(),
            Self::Types { count, .. } => *count,
        }
    }

    /// Digits of its length and bytes.
    fn digits(&self) -> usize {
        (size_of::<u64>() + self.bytes()).div_ceil(3) * 4
    }

    /// Appends its length and bytes.
    fn push(&self, text: &mut String) {
        let length = (self.bytes() as u64).to_le_bytes().into_iter();
        match self {
            Self::Floats(values) => {
                let bytes = values.iter().flat_map(|value| value.to_le_bytes());
                push_base64(text, length.chain(bytes));
            }
            Self::Bytes(values) => push_base64(text, length.chain(values.iter().copied())),
            Self::Points(points) => {
                let bytes = points
                    .iter()
                    .flat_map(|&point| i64::from(point).to_le_bytes());
                push_base64(text, length.chain(bytes));
            }
            Self::Offsets { count, corners } => {
                let bytes = (1..=*count).flat_map(|cell| ((cell * corners) as i64).to_le_bytes());
                push_base64(text, length.chain(bytes));
            }
            Self::Types { kind, count } => {
                push_base64(text, length.chain(iter::repeat_n(*kind, *count)));
            }
        }
    }
}

/// The attribute of arrays that aren't of plain numbers, which readers take them for without it.
fn of_tuples(components: usize) -> String {
    match components {
        1 => String::new(),
        components => format!(" NumberOfComponents=\"{components}\""),
    }
}

/// A file in the making: its elements, and the data that will follow them.
#[derive(Default)]
struct Writer<'g> {
    xml: String,
    blocks: Vec<Block<'g>>,
    /// Digits of the blocks.
    digits: usize,
}

impl<'g> Writer<'g> {
    fn line(&mut self, line: &str) {
        self.xml.push_str(line);
        self.xml.push('\n');
    }

    fn text(&mut self, name: &str, text: &'g str) {
        let attributes = format!(
            " NumberOfTuples=\"{}\" ComponentName0=\"{}\"",
            text.len(),
            escaped(text)
        );
        let block = Block::Bytes(text.as_bytes());
        self.array("UInt8", name, &attributes, block, None);
    }

    fn arrays(&mut self, element: &str, arrays: &'g [DataArray]) {
        self.line(&format!("<{element}>"));
        for array in arrays {
            let (kind, block) = match &array.values {
                Values::Float(values) => ("Float64", Block::Floats(values)),
                Values::Byte(values) => ("UInt8", Block::Bytes(values)),
            };
            let attributes = of_tuples(array.components);
            self.array(kind, &array.name, &attributes, block, array.unit);
        }
        self.line(&format!("</{element}>"));
    }

    /// Writes an array: its element here, its length and bytes behind all elements.
    fn array(
        &mut self,
        kind: &str,
        name: &str,
        attributes: &str,
        block: Block<'g>,
        unit: Option<&str>,
    ) {
        let (name, offset) = (escaped(name), self.digits);
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
        self.digits += block.digits();
        self.blocks.push(block);
    }

    /// The elements with the data behind them.
    fn with_data(self) -> String {
        const END: &str = "\n</AppendedData>\n</VTKFile>\n";
        let mut file = self.xml;
        file.reserve_exact(1 + self.digits + END.len());
        file.push('_');
        for block in &self.blocks {
            block.push(&mut file);
        }
        file.push_str(END);
        file
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
fn push_base64(text: &mut String, bytes: impl Iterator<Item = u8>) {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut bytes = bytes.fuse();
    while let Some(first) = bytes.next() {
        let group = [Some(first), bytes.next(), bytes.next()];
        let known = group.iter().flatten().count();
        let byte = |k: usize| u32::from(group[k].unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            text.push(if digit <= known {
                char::from(DIGITS[(bits >> (18 - 6 * digit) & 63) as usize])
            } else {
                '='
            });
        }
    }
}

#[cfg(test)]
mod tests;
