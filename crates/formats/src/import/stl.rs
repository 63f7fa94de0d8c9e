//! STL, in binary and in ASCII. Vertices with equal coordinates are one vertex: the format repeats them in
//! every triangle.
//!
//! The crate `stl_io` reads decimals as singles, rounded without a word. In binary a coordinate is a single,
//! which is a double; in ASCII it is a decimal like any other. Normals, colours and names say nothing about
//! points and are passed over.

use super::mesh::{ImportedMesh, contents};
use super::shared::SharedVertices;
use crate::decimals::{Place, explain, shown};
use crate::file::text_of;
use crate::{CorpusError, Decimals};

/// The bytes before the triangles of a binary file, with their number in the last four.
const HEADER: usize = 84;
/// The bytes of a triangle: a normal, three corners, two more.
const TRIANGLE: usize = 50;

/// Reads a file. It is binary if it is as long as its number of triangles makes it, as binary files may begin
/// with the word `solid` as well.
pub(super) fn read(file: &str, bytes: Vec<u8>, decimals: &Decimals) -> Result<ImportedMesh, CorpusError> {
    if let Some((_, rest)) = bytes.split_at_checked(HEADER - 4)
        && let Some((count, body)) = rest.split_first_chunk()
    {
        let count = u32::from_le_bytes(*count);
        let said = usize::try_from(count).ok().and_then(|count| count.checked_mul(TRIANGLE));
        if said == Some(body.len()) {
            return binary(file, body);
        }
        if !bytes.starts_with(b"solid") {
            let message = format!(
                "a binary file of {} bytes, and its {count} triangles take {}",
                bytes.len(),
                u64::from(count) * TRIANGLE as u64 + HEADER as u64
            );
            return Err(CorpusError::file(file, message, "fetch or copy it again"));
        }
    }
    ascii(file, &text_of(file, bytes)?, decimals)
}

/// Triangles by their corners.
#[derive(Default)]
struct Triangles {
    shared: SharedVertices<3>,
    mesh: ImportedMesh,
}

impl Triangles {
    fn push(&mut self, corners: [[f64; 3]; 3]) {
        let [a, b, c] = corners.map(|corner| self.shared.vertex(corner));
        if a == b || b == c || c == a {
            self.mesh.notes.degenerate_faces += 1;
        } else {
            self.mesh.faces.push([a, b, c].into_iter().filter_map(|v| u32::try_from(v.index()).ok()));
            self.mesh.triangles.push([a, b, c]);
        }
    }

    fn done(self) -> ImportedMesh {
        ImportedMesh { points: self.shared.into_points(), ..self.mesh }
    }
}

fn binary(file: &str, body: &[u8]) -> Result<ImportedMesh, CorpusError> {
    let mut triangles = Triangles::default();
    for (index, triangle) in body.chunks_exact(TRIANGLE).enumerate() {
        let mut numbers = triangle[12..48].as_chunks().0.iter().map(|bytes| f64::from(f32::from_le_bytes(*bytes)));
        let corners = [(); 3].map(|()| [(); 3].map(|()| numbers.next().unwrap_or_default()));
        if corners.as_flattened().iter().any(|x| !x.is_finite()) {
            let message = format!("triangle {index} has a corner that is not finite");
            return Err(CorpusError::file(file, message, "remove the triangle"));
        }
        triangles.push(corners);
    }
    Ok(triangles.done())
}

fn ascii(file: &str, text: &str, decimals: &Decimals) -> Result<ImportedMesh, CorpusError> {
    const CURE: &str = "write `facet`, `outer loop`, three times `vertex x y z`, `endloop`, `endfacet`";
    let error = |line: usize, message: String, cure: &str| Err(CorpusError::file(file, message, cure).at_line(line));
    let mut triangles = Triangles::default();
    let mut corners: Vec<[f64; 3]> = Vec::with_capacity(3);
    // What has to follow: the words of a facet in turn.
    let mut within = Within::File;
    let mut last = 0;
    for (line, words) in contents(text) {
        last = line;
        let words: Vec<&str> = words.split_whitespace().collect();
        within = match (within, words.as_slice()) {
            (Within::File, ["solid", ..]) => Within::Solid,
            (Within::Solid, ["endsolid", ..]) => Within::File,
            (Within::Solid, ["facet", ..]) => Within::Facet,
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
                corners.push([number(x)?, number(y)?, number(z)?]);
                Within::Loop
            }
            (Within::Loop, ["endloop"]) if corners.len() == 3 => {
                triangles.push([corners[0], corners[1], corners[2]]);
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
        Within::File => Err(CorpusError::file(file, "the file is empty", "fetch or copy it again")),
        _ => error(last, "the file ends before `endsolid`".to_owned(), "fetch or copy it again"),
    }
}

/// Which words an ASCII file has begun and not ended.
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
        read("m.stl", bytes.into(), &Decimals::new(false))
    }

    #[test]
    fn equal_coordinates_are_one_vertex() {
        let mesh = of(SQUARE).unwrap();
        assert_eq!(mesh.points, [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let v = predicament_predicates::Vertex::input;
        assert_eq!(mesh.triangles, [[v(0), v(1), v(2)], [v(0), v(2), v(3)]]);
        assert_eq!(mesh.notes.degenerate_faces, 1);
        let triangles = [
            [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.]],
            [[0., 0., 0.], [1., 1., 0.], [0., 1., -0.]],
            [[1., 1., 0.], [1., 1., 0.], [0., 1., 0.]],
        ];
        // Binary files may begin like ASCII ones.
        for head in [&b"made by hand"[..], b"solid a square"] {
            assert_eq!(of(packed(&triangles, head)).unwrap(), mesh);
        }
    }

    #[test]
    fn decimals_follow_the_suite() {
        let text = SQUARE.replace("1 1 0", "1 0.1 0");
        let error = of(text.as_str()).unwrap_err().to_string();
        assert_eq!(
            error,
            "m.stl:6: decimal 0.1 is not exactly a double; write `round = true` in the scene to read the nearest double"
        );
        let decimals = Decimals::new(true);
        assert_eq!(read("m.stl", text.into(), &decimals).unwrap().points[2], [1.0, 0.1, 0.0]);
        assert_eq!(decimals.rounded(), 4);
    }

    #[test]
    fn errors_name_file_line_and_cure() {
        let mut wrong_count = packed(&[[[0.0; 3]; 3]], b"");
        wrong_count[80] = 255;
        let not_finite = packed(&[[[0.0; 3], [f32::NAN; 3], [1.0; 3]]], b"");
        let error = |bytes: Vec<u8>| of(bytes).unwrap_err().to_string();
        let changed = |from: &str, to: &str| error(SQUARE.replacen(from, to, 1).into());
        for (got, expected) in [
            (error(wrong_count), "m.stl: a binary file of 134 bytes, and its 255 triangles take 12834; fetch"),
            (error(not_finite), "m.stl: triangle 0 has a corner that is not finite; remove"),
            (error(vec![0; 200]), "m.stl: a binary file of 200 bytes, and its 0 triangles take 84; fetch"),
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
            prop_assert_eq!(&from_text, &mesh);
            // Each written coordinate is that of some vertex.
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
