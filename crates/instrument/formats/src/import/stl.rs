//! The reader of STL files, in binary and in ASCII. Vertices with equal coordinates are one vertex: the format repeats
//! them in every triangle.
//!
//! The crate `stl_io` reads decimals as singles and rounds them silently. In binary a coordinate is a single, which is
//! a double; in ASCII it is a decimal like any other. Normals, colours and names do not affect the points and are
//! skipped.

use super::Places;
use super::imported_mesh::{ImportedMesh, contents};
use super::shared::SharedVertices;
use crate::decimals::{Place, explain, shown};
use crate::file::text_of;
use crate::{CorpusError, Decimals};

/// The size in bytes of a binary file's header, with the number of triangles in the last four bytes.
const HEADER: usize = 84;
/// The size in bytes of a triangle: a normal, three corners, two more bytes.
const TRIANGLE: usize = 50;

/// The fix for a file that ends too early.
const AGAIN: &str = "fetch or copy it again";

/// Reads a file. It is binary if its length matches its number of triangles, as binary files may also begin with the
/// word `solid`.
pub(super) fn read(
    file: &str,
    bytes: Vec<u8>,
    decimals: &Decimals,
    mesh: ImportedMesh,
) -> Result<ImportedMesh, CorpusError> {
    // Text has no zero byte; a binary file has zero bytes in its number of triangles.
    let is_binary = bytes.contains(&0);
    if let Some((_, rest)) = bytes.split_at_checked(HEADER - 4)
        && let Some((count, body)) = rest.split_first_chunk()
    {
        let count = u32::from_le_bytes(*count);
        let said = usize::try_from(count).ok().and_then(|count| count.checked_mul(TRIANGLE));
        if said == Some(body.len()) {
            return binary(file, body, mesh);
        }
        if is_binary {
            let message = format!(
                "a binary file of {} bytes, and its {count} triangles take {}",
                bytes.len(),
                u64::from(count) * TRIANGLE as u64 + HEADER as u64
            );
            return Err(CorpusError::file(file, message, AGAIN).at_byte(HEADER - 4));
        }
    } else if is_binary {
        let message = format!("the file ends in the header of a binary file, which takes {HEADER} bytes");
        return Err(CorpusError::file(file, message, AGAIN).at_byte(bytes.len()));
    }
    ascii(file, &text_of(file, bytes)?, decimals, mesh)
}

/// Triangles, as their corners.
#[derive(Default)]
struct Triangles {
    shared: SharedVertices<3>,
    mesh: ImportedMesh,
}

impl Triangles {
    /// Appends a triangle and its position, and its corners with their positions.
    fn push(&mut self, at: usize, corners: [([f64; 3], usize); 3]) {
        let [a, b, c] = corners.map(|(corner, at)| {
            let vertex = self.shared.vertex(corner);
            if vertex.index() == self.mesh.places.points() {
                self.mesh.places.push_point(at);
            }
            vertex
        });
        if (a == b || b == c || c == a) && !self.mesh.keeps_degenerate {
            self.mesh.notes.degenerate_faces += 1;
        } else {
            self.mesh.faces.push([a, b, c].into_iter().filter_map(|v| u32::try_from(v.index()).ok()));
            self.mesh.triangles.push([a, b, c]);
            self.mesh.places.push_face(at);
        }
    }

    fn done(self) -> ImportedMesh {
        ImportedMesh { points: self.shared.into_points(), ..self.mesh }
    }
}

fn binary(file: &str, body: &[u8], mesh: ImportedMesh) -> Result<ImportedMesh, CorpusError> {
    let mut triangles = Triangles { mesh, ..Triangles::default() };
    triangles.mesh.places = Places::binary();
    for (index, triangle) in body.chunks_exact(TRIANGLE).enumerate() {
        let at = HEADER + index * TRIANGLE;
        let mut numbers = triangle[12..48].as_chunks().0.iter().map(|bytes| f64::from(f32::from_le_bytes(*bytes)));
        let corners = [0, 1, 2].map(|corner| {
            let point = [(); 3].map(|()| numbers.next().unwrap_or_default());
            (point, at + 12 + corner * 12)
        });
        if let Some((_, corner)) = corners.iter().find(|(point, _)| !point.iter().all(|x| x.is_finite())) {
            let message = format!("triangle {index} has a corner that is not finite");
            return Err(CorpusError::file(file, message, "remove the triangle").at_byte(*corner));
        }
        triangles.push(at, corners);
    }
    Ok(triangles.done())
}

fn ascii(file: &str, text: &str, decimals: &Decimals, mesh: ImportedMesh) -> Result<ImportedMesh, CorpusError> {
    const CURE: &str = "write `facet`, `outer loop`, three times `vertex x y z`, `endloop`, `endfacet`";
    let error = |line: usize, message: String, cure: &str| Err(CorpusError::file(file, message, cure).at_line(line));
    let mut triangles = Triangles { mesh, ..Triangles::default() };
    let mut corners: Vec<([f64; 3], usize)> = Vec::with_capacity(3);
    let mut facet = 0;
    // The expected words of a facet, in turn.
    let mut within = Within::File;
    let mut last = 0;
    for (line, words) in contents(text) {
        last = line;
        let words: Vec<&str> = words.split_whitespace().collect();
        within = match (within, words.as_slice()) {
            (Within::File, ["solid", ..]) => Within::Solid,
            (Within::Solid, ["endsolid", ..]) => Within::File,
            (Within::Solid, ["facet", ..]) => {
                facet = line;
                Within::Facet
            }
            (Within::Facet, ["outer", "loop"]) => Within::Loop,
            (Within::Loop, ["vertex", numbers @ ..]) if corners.len() < 3 => {
                let &[x, y, z] = numbers else {
                    return error(line, format!("a vertex of {} coordinates", numbers.len()), "write three");
                };
                let number = |word: &str| {
                    decimals.read(word).map_err(|why| {
                        let (message, cure) = explain(Place::Data, word, &why);
                        CorpusError::file(file, message, cure).at_line(line)
                    })
                };
                corners.push(([number(x)?, number(y)?, number(z)?], line));
                Within::Loop
            }
            (Within::Loop, ["endloop"]) if corners.len() == 3 => {
                triangles.push(facet, [corners[0], corners[1], corners[2]]);
                corners.clear();
                Within::Closed
            }
            (Within::Closed, ["endfacet"]) => Within::Solid,
            (_, [word, ..]) => return error(line, format!("`{}` is out of place", shown(word)), CURE),
            (within, []) => within,
        };
    }
    match within {
        Within::File if last > 0 => Ok(triangles.done()),
        Within::File => Err(CorpusError::file(file, "the file is empty", AGAIN)),
        _ => error(last, "the file ends before `endsolid`".to_owned(), AGAIN),
    }
}

/// The nesting of an ASCII file's unfinished keywords.
#[derive(Clone, Copy)]
enum Within {
    File,
    Solid,
    Facet,
    Loop,
    Closed,
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::Position;

    const SQUARE: &str = "solid a square\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 1 1 0\n endloop\nendfacet\n\
        facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 1 0\n  vertex 0 1 -0\n endloop\nendfacet\n\
        facet normal 0 0 1\n outer loop\n  vertex 1 1 0\n  vertex 1 1 0\n  vertex 0 1 0\n endloop\nendfacet\nendsolid a square\n";

    fn packed(triangles: &[[[f32; 3]; 3]], head: &[u8]) -> Vec<u8> {
        let mut bytes = head.to_vec();
        bytes.resize(HEADER - 4, b' ');
        bytes.extend(u32::try_from(triangles.len()).unwrap().to_le_bytes());
        for triangle in triangles {
            bytes.extend(
                [[0.0, 0.0, 1.0], triangle[0], triangle[1], triangle[2]]
                    .as_flattened()
                    .iter()
                    .flat_map(|x: &f32| x.to_le_bytes()),
            );
            bytes.extend([7, 7]);
        }
        bytes
    }

    fn of(bytes: impl Into<Vec<u8>>) -> Result<ImportedMesh, CorpusError> {
        read("m.stl", bytes.into(), &Decimals::new(false), ImportedMesh::default())
    }

    fn without_places(mesh: &ImportedMesh) -> ImportedMesh {
        ImportedMesh { places: Places::default(), ..mesh.clone() }
    }

    #[test]
    fn dropped_triangles_have_no_place() {
        let flat = SQUARE.replacen("vertex 1 0 0", "vertex 0 0 0", 1);
        let mesh = of(flat).unwrap();
        assert_eq!((mesh.triangles.len(), mesh.places.face(0)), (1, Some(Position::Line(9))));
    }

    #[test]
    fn equal_coordinates_are_one_vertex() {
        let mesh = of(SQUARE).unwrap();
        assert_eq!(mesh.points, [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let v = predicament_predicates::Vertex::input;
        assert_eq!(mesh.triangles, [[v(0), v(1), v(2)], [v(0), v(2), v(3)]]);
        assert_eq!(mesh.notes.degenerate_faces, 1);
        let lines = [4, 5, 6, 13].map(|line| Some(Position::Line(line)));
        assert_eq!([0, 1, 2, 3].map(|point| mesh.places.point(point)), lines);
        assert_eq!(
            [0, 1, 2].map(|face| mesh.places.face(face)),
            [Some(Position::Line(2)), Some(Position::Line(9)), None]
        );
        let triangles = [
            [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.]],
            [[0., 0., 0.], [1., 1., 0.], [0., 1., -0.]],
            [[1., 1., 0.], [1., 1., 0.], [0., 1., 0.]],
        ];
        // Binary files may begin like ASCII files.
        for head in [&b"made by hand"[..], b"solid a square"] {
            let binary = of(packed(&triangles, head)).unwrap();
            assert_eq!(without_places(&binary), without_places(&mesh));
            let at = [(0, 96), (1, 108), (2, 120), (3, 170)];
            assert!(at.iter().all(|&(point, at)| binary.places.point(point) == Some(Position::Byte(at))));
            assert_eq!([0, 1].map(|face| binary.places.face(face)), [84, 134].map(|at| Some(Position::Byte(at))));
        }
    }

    #[test]
    fn decimals_follow_the_suite() {
        let text = SQUARE.replace("1 1 0", "1 0.1000000000000000001 0");
        let error = of(text.as_str()).unwrap_err().to_string();
        assert_eq!(
            error,
            "m.stl:6: decimal 0.1000000000000000001 has digits that no double holds; write `round = true` in the scene to read the nearest double"
        );
        let decimals = Decimals::new(true);
        assert_eq!(read("m.stl", text.into(), &decimals, ImportedMesh::default()).unwrap().points[2], [1.0, 0.1, 0.0]);
        assert_eq!(decimals.rounded(), 4);
    }

    #[test]
    fn errors_name_file_line_and_cure() {
        let mut wrong_count = packed(&[[[0.0; 3]; 3]], b"");
        wrong_count[80] = 255;
        let not_finite = packed(&[[[0.0; 3], [f32::NAN; 3], [1.0; 3]]], b"");
        let error = |bytes: Vec<u8>| of(bytes).unwrap_err().to_string();
        // A binary file that begins like text.
        let cut_short = error(packed(&[[[0.0; 3]; 3]], b"solid")[..133].to_vec());
        let changed = |from: &str, to: &str| error(SQUARE.replacen(from, to, 1).into());
        for (got, expected) in [
            (
                error(wrong_count),
                "m.stl: at byte 80: a binary file of 134 bytes, and its 255 triangles take 12834; fetch",
            ),
            (error(not_finite), "m.stl: at byte 108: triangle 0 has a corner that is not finite; remove"),
            (error(vec![0; 200]), "m.stl: at byte 80: a binary file of 200 bytes, and its 0 triangles take 84; fetch"),
            (
                error(vec![0; 50]),
                "m.stl: at byte 50: the file ends in the header of a binary file, which takes 84 bytes;",
            ),
            (cut_short, "m.stl: at byte 80: a binary file of 133 bytes, and its 1 triangles take 134; fetch"),
            (error(b"OFF\n".repeat(30)), "m.stl:1: `OFF` is out of place; write"),
            (error(Vec::new()), "m.stl: the file is empty; fetch"),
            (error(b"\xff".to_vec()), "m.stl:1: the file is not text in UTF-8"),
            (changed("  vertex 1 0 0\n", ""), "m.stl:6: `endloop` is out of place; write"),
            (changed("  vertex 1 0 0\n", "  vertex 1 0\n"), "m.stl:5: a vertex of 2 coordinates; write three"),
            (changed("  vertex 1 0 0\n", "  vertex 1 0 nan\n"), "m.stl:5: coordinate `nan` is not finite"),
            (changed("outer loop", "loop"), "m.stl:3: `loop` is out of place; write"),
            (changed("endsolid a square\n", ""), "m.stl:22: the file ends before `endsolid`; fetch"),
            (error(b"OFF\n".to_vec()), "m.stl:1: `OFF` is out of place; write"),
        ] {
            assert!(got.starts_with(expected), "{got}\n  expected {expected}");
        }
    }

    fn corner() -> impl Strategy<Value = [f32; 3]> {
        let finite = any::<u32>().prop_map(f32::from_bits).prop_filter("finite", |x| x.is_finite());
        prop::array::uniform3(finite)
    }

    proptest! {
        #[test]
        fn every_bit_comes_back(triangles in prop::collection::vec(prop::array::uniform3(corner()), 1..9)) {
            let mesh = of(packed(&triangles, b"")).unwrap();
            let singles = triangles.as_flattened().as_flattened();
            let text: String = triangles
                .iter()
                .map(|corners| {
                    let corner = |[x, y, z]: &[f32; 3]| format!("vertex {x:.149} {y:.149} {z:.149}\n");
                    let corners: String = corners.iter().map(corner).collect();
                    format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
                })
                .collect();
            let from_text = of(format!("solid\n{text}endsolid\n")).unwrap();
            prop_assert_eq!(without_places(&from_text), without_places(&mesh));
            // Each written coordinate belongs to some vertex.
            for corner in singles.as_chunks::<3>().0 {
                let wide = corner.map(f64::from);
                prop_assert!(mesh.points.contains(&wide));
            }
        }

        #[test]
        fn no_bytes_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), cut in 0..400_usize) {
            let _ = of(bytes.clone());
            let mut text = SQUARE.as_bytes()[..cut.min(SQUARE.len())].to_vec();
            text.extend(bytes);
            let _ = of(text);
        }
    }
}
