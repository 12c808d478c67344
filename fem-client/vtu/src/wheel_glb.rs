//! The wheel's skins as glTF 2.0 in one binary file, for any viewer.
//!
//! Data are in metres with z upward, and the node above the skins turns them so that y points upward, as glTF asks. The displacement is a morph target with weight 1:
//! a viewer shows the pressed tire, and the inflated one at weight 0.

use std::f64::consts::FRAC_1_SQRT_2;

use fem::tensor::{Vector, cross, norm};
use serde_json::{Value, json};

use crate::wheel_skins::{Skin, WheelSkins};

const MAGIC: &[u8; 4] = b"glTF";
const VERSION: u32 = 2;
const JSON_CHUNK: &[u8; 4] = b"JSON";
const BINARY_CHUNK: &[u8; 4] = b"BIN\0";
/// glTF's numbers for 32-bit floats and unsigned integers, and for what a part of the buffer is for.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;
const METRE_MM: f64 = 1000.0;

/// Names and colours of the skins: red, green, blue and opacity.
const INNER: (&str, [f64; 4]) = ("inner skin", [0.85, 0.72, 0.45, 1.0]);
const OUTER: (&str, [f64; 4]) = ("outer skin", [0.16, 0.17, 0.19, 1.0]);

/// The bytes of the file. `origin`, an object, says where it is from.
pub fn glb(skins: &WheelSkins, origin: &Value) -> Vec<u8> {
    let mut file = Gltf::default();
    let shape = (skins.phi_deg.len(), skins.theta_deg.len());
    // Each front faces whoever looks at it: the inner skin's the cavity.
    file.add_skin(INNER, &skins.inner, &triangles(shape, false));
    file.add_skin(OUTER, &skins.outer, &triangles(shape, true));
    file.bytes(origin)
}

/// A file in the making.
#[derive(Default)]
struct Gltf {
    views: Vec<Value>,
    accessors: Vec<Value>,
    meshes: Vec<Value>,
    materials: Vec<Value>,
    nodes: Vec<Value>,
    buffer: Vec<u8>,
}

impl Gltf {
    fn add_skin(
        &mut self,
        (name, colour): (&str, [f64; 4]),
        skin: &Skin,
        triangles: &[[usize; 3]],
    ) {
        let pressed: Vec<Vector> = skin
            .inflated_mm
            .iter()
            .zip(&skin.displacement_mm)
            .map(|(x, u)| [0, 1, 2].map(|i| x[i] + u[i]))
            .collect();
        let at_rest = normals(&skin.inflated_mm, triangles);
        let turned = normals(&pressed, triangles).into_iter().zip(&at_rest);
        let turned: Vec<Vector> = turned
            .map(|(end, start)| [0, 1, 2].map(|i| end[i] - start[i]))
            .collect();
        let primitive = json!({
            "attributes": {"POSITION": self.metres(&skin.inflated_mm), "NORMAL": self.vectors(&at_rest)},
            "indices": self.indices(triangles),
            "material": self.materials.len(),
            "targets": [{"POSITION": self.metres(&skin.displacement_mm), "NORMAL": self.vectors(&turned)}],
        });
        self.materials.push(json!({
            "name": name, "doubleSided": true,
            "pbrMetallicRoughness": {"baseColorFactor": colour, "metallicFactor": 0.0, "roughnessFactor": 0.8},
        }));
        self.nodes
            .push(json!({"name": name, "mesh": self.meshes.len()}));
        self.meshes.push(json!({
            "name": name, "primitives": [primitive], "weights": [1.0], "extras": {"targetNames": ["contact"]},
        }));
    }

    fn metres(&mut self, lengths_mm: &[Vector]) -> usize {
        let metres: Vec<Vector> = lengths_mm.iter().map(|x| x.map(|x| x / METRE_MM)).collect();
        self.vectors(&metres)
    }

    /// The accessor of vectors, with their bounds.
    fn vectors(&mut self, vectors: &[Vector]) -> usize {
        let singles: Vec<[f32; 3]> = vectors.iter().map(|v| v.map(|x| x as f32)).collect();
        let bound = |pick: fn(f32, f32) -> f32, start: f32| {
            [0, 1, 2].map(|i| singles.iter().map(|v| v[i]).fold(start, pick))
        };
        let (min, max) = (
            bound(f32::min, f32::INFINITY),
            bound(f32::max, f32::NEG_INFINITY),
        );
        let words = singles.as_flattened().iter().map(|x| x.to_le_bytes());
        let view = self.view(words, VERTICES);
        self.accessor(json!({
            "bufferView": view, "componentType": FLOAT, "type": "VEC3", "count": vectors.len(), "min": min, "max": max,
        }))
    }

    fn indices(&mut self, triangles: &[[usize; 3]]) -> usize {
        let corners = triangles.as_flattened();
        let words = corners.iter().map(|&corner| (corner as u32).to_le_bytes());
        let view = self.view(words, INDICES);
        self.accessor(json!({
            "bufferView": view, "componentType": UNSIGNED_INT, "type": "SCALAR", "count": corners.len(),
        }))
    }

    /// A part of the buffer; words of four bytes keep all of them aligned.
    fn view(&mut self, words: impl Iterator<Item = [u8; 4]>, target: u32) -> usize {
        let offset = self.buffer.len();
        self.buffer.extend(words.flatten());
        let length = self.buffer.len() - offset;
        self.views.push(
            json!({"buffer": 0, "byteOffset": offset, "byteLength": length, "target": target}),
        );
        self.views.len() - 1
    }

    fn accessor(&mut self, accessor: Value) -> usize {
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn bytes(mut self, origin: &Value) -> Vec<u8> {
        let skins: Vec<usize> = (0..self.nodes.len()).collect();
        // A quarter of a turn about x brings z to y.
        let turn = [-FRAC_1_SQRT_2, 0.0, 0.0, FRAC_1_SQRT_2];
        self.nodes
            .push(json!({"name": "tire", "children": skins, "rotation": turn}));
        let document = json!({
            "asset": {"version": "2.0", "generator": "strainsite", "extras": origin},
            "scene": 0,
            "scenes": [{"nodes": [self.nodes.len() - 1]}],
            "nodes": self.nodes,
            "meshes": self.meshes,
            "materials": self.materials,
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": self.buffer.len()}],
        });
        let mut text = document.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let chunks = [(JSON_CHUNK, text), (BINARY_CHUNK, self.buffer)];
        let length: usize = chunks.iter().map(|(_, chunk)| 8 + chunk.len()).sum();
        let mut file = MAGIC.to_vec();
        file.extend(VERSION.to_le_bytes());
        file.extend(((12 + length) as u32).to_le_bytes());
        for (kind, chunk) in chunks {
            file.extend((chunk.len() as u32).to_le_bytes());
            file.extend(kind);
            file.extend(chunk);
        }
        file
    }
}

/// Two triangles between neighbours of rows x columns that close around the wheel, their fronts away from the section's centre or towards it.
fn triangles((rows, columns): (usize, usize), is_outward: bool) -> Vec<[usize; 3]> {
    let turned = |[a, b, c]: [usize; 3]| if is_outward { [a, b, c] } else { [a, c, b] };
    let pair = |row: usize, column: usize| {
        let next = (column + 1) % columns;
        let point = |row: usize, column: usize| row * columns + column;
        let (a, b) = (point(row, column), point(row + 1, column));
        let (c, d) = (point(row + 1, next), point(row, next));
        [[a, b, c], [a, c, d]].map(turned)
    };
    let rows = 0..rows.saturating_sub(1);
    rows.flat_map(|row| (0..columns).flat_map(move |column| pair(row, column)))
        .collect()
}

/// Unit normals at the points, means over the triangles that meet there, weighted by area.
fn normals(points: &[Vector], triangles: &[[usize; 3]]) -> Vec<Vector> {
    let mut sums = vec![[0.0; 3]; points.len()];
    for &[a, b, c] in triangles {
        let edge = |to: usize| [0, 1, 2].map(|i| points[to][i] - points[a][i]);
        let twice_area = cross(&edge(b), &edge(c));
        for corner in [a, b, c] {
            for i in 0..3 {
                sums[corner][i] += twice_area[i];
            }
        }
    }
    let unit = |sum: &Vector| match norm(sum) {
        // A point where the surface has folded onto itself: any direction is as good.
        0.0 => [0.0, 0.0, 1.0],
        length => sum.map(|x| x / length),
    };
    sums.iter().map(unit).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn normals_of_a_torus_point_away_from_its_section_and_back() {
        const SECTION: f64 = 1.0;
        const RADIUS: f64 = 5.0;
        let (rows, columns) = (9, 32);
        let angle = |part: usize, of: usize, turn: f64| turn * part as f64 / of as f64;
        let at = |k: usize, rho: f64| {
            let theta = angle(k % columns, columns, TAU) - 0.5 * TAU;
            let phi = angle(k / columns, rows - 1, 4.0) - 2.0;
            let r = RADIUS + rho * phi.cos();
            [r * theta.sin(), rho * phi.sin(), -r * theta.cos()]
        };
        let points: Vec<Vector> = (0..rows * columns).map(|k| at(k, SECTION)).collect();
        for (is_outward, sign) in [(true, 1.0), (false, -1.0)] {
            let normals = normals(&points, &triangles((rows, columns), is_outward));
            for (k, normal) in normals.iter().enumerate() {
                let (out, on) = (at(k, 2.0 * SECTION), at(k, SECTION));
                let along: f64 = (0..3).map(|i| sign * normal[i] * (out[i] - on[i])).sum();
                // Flat triangles of 11 and 29 degrees: at the border their mean leans by half of one, cos(15) = 0.966.
                assert!(along > 0.95, "{k}: {along}");
                assert!((norm(normal) - 1.0).abs() < 1e-12);
            }
        }
    }
}
