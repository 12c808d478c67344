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

/// Decodes as any decoder does.
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

fn words(numbers: impl Iterator<Item = i64>) -> Vec<u8> {
    numbers.flat_map(i64::to_le_bytes).collect()
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
        push_base64(&mut text, plain.bytes());
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
