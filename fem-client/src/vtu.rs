//! Unstructured grids as VTU files, VTK's XML format, for ParaView and its like.
//!
//! Arrays follow the grid as base64 of little-endian numbers, so that the file is well-formed XML and every bit of a number is kept. A text of the
//! field data is an array of its UTF-8 bytes, with the text itself as the name of its component: meshio refuses whole files for VTK's
//! arrays of strings. An array's unit is VTK's own `UNITS_LABEL`.

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

    /// Vectors.
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
mod tests {
    use super::*;

    fn square() -> VtuGrid {
        VtuGrid {
            points: vec![
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [1.0, 1.0, 0.0],
                [0.0, 1.0, 0.5],
            ],
            shape: CellShape::Quad,
            cells: vec![0, 1, 2, 3],
            point_data: vec![DataArray::floats(
                "a \"<b>\" & c",
                "mm",
                1,
                vec![1.0, -2.0, 0.1, 5e-324],
            )],
            cell_data: vec![DataArray::flags("known", [true].into_iter())],
            texts: vec![("study", "µ < 1".to_owned()), ("none", String::new())],
        }
    }

    /// As any decoder does it.
    fn decoded(text: &str) -> Vec<u8> {
        let value = |c: u8| match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' => 62,
            _ => 63,
        };
        let digits = text.bytes().take_while(|&c| c != b'=');
        let mut bits: Vec<bool> = digits
            .flat_map(|c| (0..6).rev().map(move |k| value(c) >> k & 1 == 1))
            .collect();
        bits.truncate(bits.len() / 8 * 8);
        let byte = |bits: &[bool]| bits.iter().fold(0, |byte, bit| byte << 1 | u8::from(*bit));
        bits.chunks(8).map(byte).collect()
    }

    /// The bytes of the array with this name.
    fn block(xml: &str, name: &str) -> Vec<u8> {
        let element = xml
            .split("<DataArray ")
            .find(|e| e.contains(&format!("Name=\"{name}\"")));
        let (_, rest) = element
            .expect("the array")
            .split_once("offset=\"")
            .expect("an offset");
        let offset: usize = rest
            .split('"')
            .next()
            .expect("a number")
            .parse()
            .expect("a number");
        let (_, appended) = xml
            .split_once("<AppendedData encoding=\"base64\">\n_")
            .expect("data");
        let header = decoded(&appended[offset..offset + 12]);
        let length = u64::from_le_bytes(header[..8].try_into().expect("8 bytes")) as usize;
        let end = offset + (8 + length).div_ceil(3) * 4;
        let bytes = decoded(&appended[offset..end]);
        assert_eq!(bytes.len(), 8 + length);
        bytes[8..].to_vec()
    }

    #[test]
    fn base64_is_that_of_the_standard() {
        // RFC 4648, section 10.
        let known = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("foobar", "Zm9vYmFy"),
        ];
        for (plain, expected) in known {
            let mut text = String::new();
            push_base64(&mut text, plain.as_bytes());
            assert_eq!(text, expected);
            assert_eq!(decoded(&text), plain.as_bytes());
        }
    }

    #[test]
    fn every_array_is_where_its_element_says() {
        let xml = square().to_xml().unwrap();
        let numbers: Vec<u8> = [1.0f64, -2.0, 0.1, 5e-324]
            .into_iter()
            .flat_map(f64::to_le_bytes)
            .collect();
        assert_eq!(block(&xml, "a &quot;&lt;b&gt;&quot; &amp; c"), numbers);
        assert_eq!(block(&xml, "known"), [1]);
        assert_eq!(block(&xml, "study"), "µ < 1".as_bytes());
        assert_eq!(block(&xml, "connectivity"), words([0, 1, 2, 3].into_iter()));
        assert_eq!(block(&xml, "offsets"), words([4].into_iter()));
        assert_eq!(block(&xml, "types"), [9]);
        assert_eq!(block(&xml, "Points").len(), 12 * 8);
        assert!(!xml.contains("Name=\"none\""));
    }

    #[test]
    fn elements_are_opened_and_closed() {
        let xml = square().to_xml().unwrap();
        let mut open: Vec<&str> = Vec::new();
        for tag in xml.split('<').skip(2) {
            let (tag, _) = tag.split_once('>').expect("closed");
            let name = tag
                .trim_start_matches('/')
                .split([' ', '/'])
                .next()
                .expect("a name");
            if tag.starts_with('/') {
                assert_eq!(open.pop(), Some(name));
            } else if !tag.ends_with('/') {
                open.push(name);
            }
        }
        assert!(open.is_empty(), "{open:?}");
    }

    #[test]
    fn what_no_reader_would_understand_is_refused() {
        let mut grid = square();
        grid.points[3][2] = f64::NAN;
        assert_eq!(
            grid.to_xml(),
            Err(VtuError::NotFinite {
                array: "points".to_owned()
            })
        );
        let mut grid = square();
        grid.cells[0] = 4;
        assert_eq!(
            grid.to_xml(),
            Err(VtuError::Point {
                point: 4,
                points: 4
            })
        );
        let mut grid = square();
        grid.cells.push(0);
        assert!(matches!(grid.to_xml(), Err(VtuError::Length { .. })));
        let mut grid = square();
        grid.cell_data
            .push(DataArray::floats("a", "1", 2, vec![0.0]));
        assert!(matches!(grid.to_xml(), Err(VtuError::Length { .. })));
        grid.cell_data[1] = DataArray::floats("a", "1", 2, vec![0.0, f64::INFINITY]);
        assert_eq!(
            grid.to_xml(),
            Err(VtuError::NotFinite {
                array: "a".to_owned()
            })
        );
    }

    /// Known bytes: one quad of the unit square, without data.
    #[test]
    fn a_known_file() {
        let grid = VtuGrid {
            points: vec![[0.0; 3]; 4],
            shape: CellShape::Quad,
            cells: vec![0, 1, 2, 3],
            point_data: vec![],
            cell_data: vec![],
            texts: vec![],
        };
        let xml = grid.to_xml().unwrap();
        // 8 bytes of length (96, 32, 8 and 1) before zeros, four numbers, 4, and 9.
        let points = format!("Y{}=", "A".repeat(138));
        let cells = "IAAAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAgAAAAAAAAADAAAAAAAAAA==";
        let expected = format!(
            "_{points}{cells}CAAAAAAAAAAEAAAAAAAAAA==AQAAAAAAAAAJ\n</AppendedData>\n</VTKFile>\n"
        );
        assert!(xml.ends_with(&expected), "{xml}");
        for (name, offset) in [
            ("Points", 0),
            ("connectivity", 140),
            ("offsets", 196),
            ("types", 220),
        ] {
            let element = xml
                .lines()
                .find(|line| line.contains(&format!("Name=\"{name}\"")));
            assert!(
                element
                    .expect("the array")
                    .contains(&format!("offset=\"{offset}\"")),
                "{name}"
            );
        }
    }
}
