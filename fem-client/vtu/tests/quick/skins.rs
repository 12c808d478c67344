//! The skins of the whole wheel: on the mesh's nodes, completed by mirror images, and as glTF.

use std::sync::atomic::AtomicBool;

use fem_client::scene::{Level, Scene};
use fem_client::solver::{Readout, SolveRequest, Solver};
use serde_json::{Value, json};
use tire::embedded::EmbeddedSolver;
use vtu::solved_body::Body;
use vtu::wheel_glb::glb;
use vtu::wheel_skins::{Skin, WheelSkins};
use vtu::{DataArray, Values, VtuGrid};

/// Largest difference from a node of the VTU file, mm.
const OF_VTU_MM: f64 = 1e-5;

struct Solved {
    skins: WheelSkins,
    grid: VtuGrid,
}

fn solved(level: Level, depths: [f64; 5], shift_mm: [f64; 2]) -> Solved {
    let mut scene = Scene::preset("foot-tire").expect("ships");
    scene.model.level = level;
    scene.ground.depths_mm = depths.to_vec();
    scene.ground.shift_mm = shift_mm;
    if shift_mm != [0.0; 2] {
        scene.contact.friction = 0.5;
    }
    let request = SolveRequest {
        scene: &scene,
        readout: &Readout::default(),
        start: None,
        watch: &AtomicBool::new(false),
    };
    let solved = EmbeddedSolver::default().solve(&request);
    let state = solved.expect("an equilibrium").state;
    let body = Body::of(&scene, &state).expect("a mesh");
    Solved {
        skins: body.skins(),
        grid: body.grid(""),
    }
}

fn vectors<'a>(data: &'a [DataArray], name: &str) -> &'a [[f64; 3]] {
    let array = data.iter().find(|array| array.name == name);
    match &array.expect("the array").values {
        Values::Float(values) => values.as_chunks().0,
        Values::Byte(_) => panic!("{name} has flags"),
    }
}

fn sum(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + b[i])
}

fn as_single(x: [f64; 3]) -> [f64; 3] {
    x.map(|x| f64::from(x as f32))
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
}

/// Every point of a skin is a node of the file in both states, mirrored at planes of symmetry; how many of the nodes were met.
fn nodes_met(solved: &Solved, skin: &Skin, symmetric: [bool; 2]) -> usize {
    let data = &solved.grid.point_data;
    let (whole, inflation) = (
        vectors(data, "displacement"),
        vectors(data, "displacement_inflated"),
    );
    let nodes: Vec<[[f64; 3]; 2]> = (0..solved.grid.points.len())
        .map(|k| {
            let x = &solved.grid.points[k];
            [sum(x, &inflation[k]), sum(x, &whole[k])]
        })
        .collect();
    let mut met = vec![false; nodes.len()];
    for (start, displacement) in skin.inflated_mm.iter().zip(&skin.displacement_mm) {
        let (sent, moved) = (as_single(*start), as_single(*displacement));
        let end = sum(&sent, &moved);
        let folded = |x: [f64; 3]| {
            let fold = |is: bool, sign: f64, x: f64| if is && sign < 0.0 { -x } else { x };
            [
                fold(symmetric[0], start[0], x[0]),
                fold(symmetric[1], start[1], x[1]),
                x[2],
            ]
        };
        let near = |node: &[[f64; 3]; 2]| {
            distance(node[0], folded(sent)) < OF_VTU_MM
                && distance(node[1], folded(end)) < OF_VTU_MM
        };
        let found = nodes.iter().position(near);
        met[found.unwrap_or_else(|| panic!("no node at {start:?}"))] = true;
    }
    met.iter().filter(|met| **met).count()
}

#[test]
fn every_vertex_is_a_node_of_the_solved_body_or_its_mirror_image() {
    let cases = [
        (
            Level::Draft,
            [0.8, 0.9, 1.0, 0.9, 0.8],
            [0.0; 2],
            [true, true],
        ),
        (
            Level::Draft,
            [0.6, 0.9, 1.0, 1.1, 1.2],
            [0.0; 2],
            [false, true],
        ),
        (Level::Draft, [1.0; 5], [0.0, 0.3], [true, false]),
        (Level::Draft, [1.0; 5], [0.3, 0.3], [false, false]),
        (Level::Coarse, [1.0; 5], [0.0; 2], [true, true]),
    ];
    for (level, depths, shift, symmetric) in cases {
        let solved = solved(level, depths, shift);
        let skins = &solved.skins;
        let (rows, columns) = (skins.phi_deg.len(), skins.theta_deg.len());
        for skin in [&skins.inner, &skins.outer] {
            assert_eq!(skin.inflated_mm.len(), rows * columns);
            let met = nodes_met(&solved, skin, symmetric);
            let part = |is: bool, all: usize| if is { all / 2 + 1 } else { all };
            let modelled = part(symmetric[1], rows) * part(symmetric[0], columns);
            assert_eq!(
                met, modelled,
                "{level:?} {depths:?} {shift:?}: all nodes of the skin"
            );
        }
    }
}

#[test]
fn lines_ascend_around_the_whole_wheel_and_points_stand_at_their_angles() {
    for depths in [[1.0; 5], [0.6, 0.9, 1.0, 1.1, 1.2]] {
        let Solved { skins, .. } = solved(Level::Draft, depths, [0.0; 2]);
        let ascends = |angles: &[f64]| angles.windows(2).all(|pair| pair[0] < pair[1]);
        assert!(ascends(&skins.phi_deg) && ascends(&skins.theta_deg));
        assert_eq!(skins.theta_deg[0], -180.0);
        assert!(
            skins.theta_deg.iter().all(|theta| *theta < 180.0) && skins.theta_deg.contains(&0.0)
        );
        assert!((skins.phi_deg[0] + 120.0).abs() < 1e-9 && skins.phi_deg.contains(&0.0));
        let columns = skins.theta_deg.len();
        for (k, [x, y, z]) in skins.outer.inflated_mm.iter().enumerate() {
            let (theta, phi) = (skins.theta_deg[k % columns], skins.phi_deg[k / columns]);
            assert_eq!(
                x.abs() > 1e-9 && *x > 0.0,
                theta > 0.0 && theta < 180.0,
                "{theta}"
            );
            assert_eq!(*y > 1e-9, phi > 0.0, "{phi}");
            // Inflation moves no point by a degree around the wheel.
            assert!((x.atan2(-z).to_degrees() - theta).abs() < 1.0 || theta == -180.0);
        }
    }
}

#[test]
fn the_ground_presses_where_the_tread_is_pressed() {
    let depths = [0.6, 0.9, 1.0, 1.1, 1.2];
    let Solved { skins, .. } = solved(Level::Draft, depths, [0.0; 2]);
    let ground = &skins.ground;
    assert!(ground.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    assert!(ground[0][0] < -50.0 && ground[ground.len() - 1][0] > 50.0);
    let height = |x: f64| {
        let k = ground
            .iter()
            .position(|point| point[0] >= x)
            .expect("within");
        let ([x0, z0], [x1, z1]) = (ground[k - 1], ground[k]);
        z0 + (z1 - z0) * (x - x0) / (x1 - x0)
    };
    let outer = &skins.outer;
    let gaps = outer
        .inflated_mm
        .iter()
        .zip(&outer.displacement_mm)
        .filter_map(|(x, u)| {
            let [x, _, z] = sum(x, u);
            (z < -45.0).then(|| z - height(x))
        });
    let (lowest, touching) = gaps.fold((f64::INFINITY, 0), |(lowest, touching), gap| {
        (gap.min(lowest), touching + usize::from(gap < 0.01))
    });
    // The penalty lets the tread in by a hundredth of a millimetre or so, and nowhere deeper.
    assert!((-0.05..0.0).contains(&lowest), "{lowest}");
    assert!(touching > 20, "{touching}");
}

/// A glTF file's document and buffer, checked for what every such file must have.
fn parts(file: &[u8]) -> (Value, &[u8]) {
    let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().expect("four bytes"));
    assert_eq!(
        (&file[..4], word(4), word(8) as usize),
        (&b"glTF"[..], 2, file.len())
    );
    let text = word(12) as usize;
    assert_eq!((&file[16..20], text % 4), (&b"JSON"[..], 0));
    let binary = 20 + text;
    let length = word(binary) as usize;
    assert_eq!(
        (&file[binary + 4..binary + 8], length % 4),
        (&b"BIN\0"[..], 0)
    );
    assert_eq!(binary + 8 + length, file.len());
    let document = serde_json::from_slice(&file[20..binary]).expect("JSON");
    (document, &file[binary + 8..])
}

fn number(value: &Value) -> usize {
    usize::try_from(value.as_u64().expect("a number")).expect("fits")
}

/// The four-byte words of an accessor, which lie within its view, the view within the buffer.
fn words<'b>(document: &Value, buffer: &'b [u8], accessor: &Value) -> &'b [[u8; 4]] {
    let accessor = &document["accessors"][number(accessor)];
    let view = &document["bufferViews"][number(&accessor["bufferView"])];
    let (offset, length) = (number(&view["byteOffset"]), number(&view["byteLength"]));
    assert!(offset % 4 == 0 && offset + length <= buffer.len());
    let components = if accessor["type"] == "VEC3" { 3 } else { 1 };
    assert_eq!(4 * components * number(&accessor["count"]), length);
    buffer[offset..offset + length].as_chunks().0
}

/// Vectors of an accessor; its bounds are theirs.
fn floats(document: &Value, buffer: &[u8], accessor: &Value) -> Vec<[f32; 3]> {
    let words = words(document, buffer, accessor);
    let numbers: Vec<f32> = words.iter().map(|word| f32::from_le_bytes(*word)).collect();
    assert!(numbers.iter().all(|x| x.is_finite()));
    let vectors = numbers.as_chunks::<3>().0.to_vec();
    let stated = &document["accessors"][number(accessor)];
    assert_eq!(stated["componentType"], 5126);
    for i in 0..3 {
        let of = |pick: fn(f32, f32) -> f32| vectors.iter().map(|v| v[i]).reduce(pick);
        assert_eq!(stated["min"][i].as_f64(), of(f32::min).map(f64::from));
        assert_eq!(stated["max"][i].as_f64(), of(f32::max).map(f64::from));
    }
    vectors
}

#[test]
fn the_gltf_file_is_whole_and_has_the_skins_in_metres() {
    let Solved { skins, .. } = solved(Level::Draft, [1.0; 5], [0.0; 2]);
    let file = glb(&skins, &json!({"study": "a"}));
    let (document, buffer) = parts(&file);
    assert_eq!(document["asset"]["version"], "2.0");
    assert_eq!(document["asset"]["extras"], json!({"study": "a"}));
    assert_eq!(document["buffers"], json!([{"byteLength": buffer.len()}]));
    let root = &document["nodes"][number(&document["scenes"][0]["nodes"][0])];
    let names = root["children"].as_array().expect("children").iter();
    let names: Vec<&Value> = names
        .map(|k| &document["nodes"][number(k)]["name"])
        .collect();
    assert_eq!(names, ["inner skin", "outer skin"]);
    for (mesh, skin) in [&skins.inner, &skins.outer].into_iter().enumerate() {
        let mesh = &document["meshes"][mesh];
        let primitive = &mesh["primitives"][0];
        let target = &primitive["targets"][0];
        assert_eq!(
            (&mesh["weights"], &mesh["extras"]["targetNames"]),
            (&json!([1.0]), &json!(["contact"]))
        );
        assert_eq!(
            document["materials"][number(&primitive["material"])]["doubleSided"],
            true
        );
        let attribute = |of: &Value, name: &str| floats(&document, buffer, &of[name]);
        let metres = |x: &[f64; 3]| x.map(|x| (x / 1000.0) as f32);
        let positions: Vec<_> = skin.inflated_mm.iter().map(metres).collect();
        let moved: Vec<_> = skin.displacement_mm.iter().map(metres).collect();
        assert_eq!(attribute(&primitive["attributes"], "POSITION"), positions);
        assert_eq!(attribute(target, "POSITION"), moved);
        for normal in attribute(&primitive["attributes"], "NORMAL") {
            let length: f32 = normal.iter().map(|x| x * x).sum();
            assert!((length - 1.0).abs() < 1e-5);
        }
        assert_eq!(attribute(target, "NORMAL").len(), positions.len());
        let corners = words(&document, buffer, &primitive["indices"]);
        let corners: Vec<u32> = corners
            .iter()
            .map(|word| u32::from_le_bytes(*word))
            .collect();
        let (rows, columns) = (skins.phi_deg.len(), skins.theta_deg.len());
        assert_eq!(corners.len(), 6 * (rows - 1) * columns);
        assert_eq!(corners.iter().max(), Some(&((rows * columns - 1) as u32)));
    }
}
