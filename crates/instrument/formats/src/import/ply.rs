//! The reader of PLY files; the crate `ply-rs-bw` parses the header and both binary forms.
//!
//! The crate keeps every bit of binary numbers. For ASCII it returns rounded numbers, so that form is read
//! [here](super::ply_ascii).

use std::io::{BufReader, ErrorKind};

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Encoding};
use predicament_predicates::Vertex;

use super::imported_mesh::ImportedMesh;
use super::ply_element::{Element, ended};
use super::{Places, ply_ascii, ply_header};
use crate::decimals::shown;
use crate::lines::lines;
use crate::{CorpusError, Decimals, Position};

/// Reads the elements `vertex` and `face`; others are skipped, except strips of triangles, which are refused.
pub(super) fn read(
    file: &str,
    bytes: &[u8],
    decimals: &Decimals,
    mut mesh: ImportedMesh,
) -> Result<ImportedMesh, CorpusError> {
    let mut rest = bytes;
    let mut reader = Reader::new(BufReader::with_capacity(1, &mut rest));
    let header = Parser::<Element>::new().read_header(&mut reader).map_err(|error| {
        // If the header does not end, the parser reports the line behind the last.
        let last = lines(&String::from_utf8_lossy(bytes)).count().max(1);
        broken(file, &error).at(error.line().map(|line| Position::Line(line.min(last))))
    })?;
    drop(reader);
    let text = &bytes[..bytes.len() - rest.len()];
    ply_header::check(file, text, &header, rest.len())?;
    match header.encoding {
        Encoding::Ascii => {
            let mut payload = ply_ascii::Payload::new(file, text, rest, decimals)?;
            for kind in header.elements.values() {
                for index in 0..kind.count {
                    let (line, element) = payload.element(kind, index)?;
                    take(file, &mut mesh, kind, index, element, Position::Line(line))?;
                }
            }
            payload.end()?;
        }
        encoding => {
            mesh.places = Places::binary();
            for kind in header.elements.values() {
                for index in 0..kind.count {
                    let at = bytes.len() - rest.len();
                    let element = binary(file, encoding, &mut rest, kind, index).map_err(|error| error.at_byte(at))?;
                    take(file, &mut mesh, kind, index, element, Position::Byte(at))?;
                }
            }
            if !rest.is_empty() {
                let message = format!("{} bytes follow the elements that the header counts", rest.len());
                return Err(CorpusError::file(file, message, "correct the counts").at_byte(bytes.len() - rest.len()));
            }
        }
    }
    Ok(mesh)
}

/// The error for input that the parser cannot read.
fn broken(file: &str, error: &ParseError) -> CorpusError {
    // The parser's own message uses names of its grammar.
    let said = error.to_string();
    let said = said.lines().next().unwrap_or_default();
    let line = error.line().map(|line| format!("Line {line}: ")).unwrap_or_default();
    let said = shown(said.strip_prefix(&line).unwrap_or(said));
    let message = format!("the PLY file is not understood: {said}");
    CorpusError::file(file, message, "write the file again or convert it to OFF or OBJ")
}

/// The next element of a binary file.
fn binary(
    file: &str,
    encoding: Encoding,
    rest: &mut &[u8],
    kind: &ElementDef,
    index: usize,
) -> Result<Element, CorpusError> {
    let parser = Parser::new();
    let read = match encoding {
        Encoding::BinaryBigEndian => parser.read_big_endian_element(rest, kind),
        _ => parser.read_little_endian_element(rest, kind),
    };
    read.map_err(|error| match error.kind() {
        ErrorKind::UnexpectedEof => ended(file, kind, index),
        _ => broken(file, &error),
    })
}

/// Adds a vertex or a face to the mesh.
fn take(
    file: &str,
    mesh: &mut ImportedMesh,
    kind: &ElementDef,
    index: usize,
    element: Element,
    position: Position,
) -> Result<(), CorpusError> {
    let error = |message: String, cure: &str| CorpusError::file(file, message, cure).at(Some(position));
    let (Position::Line(at) | Position::Byte(at)) = position;
    match kind.name.as_str() {
        "vertex" => {
            let [x, y, z] = element.at;
            if !element.at.iter().all(|coordinate| coordinate.is_finite()) {
                return Err(error(format!("vertex {index} is not finite: ({x}, {y}, {z})"), "remove the vertex"));
            }
            mesh.push_point(element.at, at);
        }
        "face" => {
            let vertices = mesh.points.len();
            let corners = element
                .corners
                .ok_or_else(|| error(format!("face {index} has an index below zero"), "indices count from 0"))?;
            let of = |corner: u32| {
                let place = usize::try_from(corner).ok().filter(|&place| place < vertices);
                place.map(Vertex::input).ok_or_else(|| {
                    let message = format!("`{corner}` of face {index} is not one of the {vertices} vertices");
                    error(message, "indices count from 0, and vertices come before faces")
                })
            };
            let corners = corners.into_iter().map(of).collect::<Result<Vec<_>, _>>()?;
            mesh.push_face(&corners, at).map_err(|(message, cure)| error(format!("face {index}: {message}"), cure))?;
        }
        _ => {}
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "ply\nformat ascii 1.0\ncomment a pyramid\nelement vertex 4\nproperty float x\n\
        property float y\nproperty double z\nproperty uchar red\nelement face 2\n\
        property list uchar int vertex_indices\nelement camera 1\nproperty float zoom\nend_header\n";

    fn read(file: &str, bytes: &[u8]) -> Result<ImportedMesh, CorpusError> {
        super::read(file, bytes, &Decimals::new(false), ImportedMesh::default())
    }

    fn ascii(vertices: &str, faces: &str) -> Result<ImportedMesh, CorpusError> {
        read("m.ply", format!("{HEADER}{vertices}{faces}1.5\n").as_bytes())
    }

    #[test]
    fn singles_and_doubles_as_they_are_declared() {
        let vertices = "0 0 0 1\n0.1000000001 0 0.1000000000000000001 2\n1 1 0 3\n0 1 0 4\n";
        let error = ascii(vertices, "4 0 1 2 3\n3 3 2 1\n").unwrap_err().to_string();
        assert!(
            error.starts_with("m.ply:15: decimal 0.1000000001 has digits that no double holds; write `round = true`"),
            "{error}"
        );
        let decimals = Decimals::new(true);
        let text = format!("{HEADER}{vertices}4 0 1 2 3\n3 3 2 1\n1.5\n");
        let mesh = super::read("m.ply", text.as_bytes(), &decimals, ImportedMesh::default()).unwrap();
        assert_eq!(decimals.rounded(), 2);
        assert_eq!(mesh.points[1], [0.1_f32.into(), 0.0, 0.1]);
        let triangles = [[0, 1, 2], [0, 2, 3], [3, 2, 1]].map(|triangle| triangle.map(Vertex::input));
        assert_eq!(mesh.triangles, triangles);
        // The same mesh in binary.
        let header = HEADER.replace("ascii", "binary_big_endian");
        let mut bytes = header.into_bytes();
        for [x, y, z] in &mesh.points {
            #[allow(clippy::cast_possible_truncation)] // singles
            [x, y].iter().for_each(|x| bytes.extend((**x as f32).to_be_bytes()));
            bytes.extend(z.to_be_bytes());
            bytes.push(9);
        }
        for face in [vec![0_i32, 1, 2, 3], vec![3, 2, 1]] {
            bytes.push(u8::try_from(face.len()).unwrap());
            face.iter().for_each(|corner| bytes.extend(corner.to_be_bytes()));
        }
        bytes.extend(1.5_f32.to_be_bytes());
        let start = bytes.len() - (4 * 17 + 17 + 13 + 4);
        let binary = read("m.ply", &bytes).unwrap();
        let places = |mesh: &ImportedMesh| {
            [3, 4]
                .map(|point| mesh.places.point(point))
                .into_iter()
                .chain([0, 1].map(|face| mesh.places.face(face)))
                .flatten()
                .collect::<Vec<_>>()
        };
        assert_eq!(places(&binary), [51, 68, 85].map(|at| Position::Byte(start + at)));
        assert_eq!(places(&mesh), [17, 18, 19].map(Position::Line));
        assert_eq!(binary, ImportedMesh { places: binary.places.clone(), ..mesh });
    }

    #[test]
    fn errors_say_where() {
        let vertices = "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n";
        let faces = "3 0 1 2\n3 3 2 1\n";
        let text = |result: Result<ImportedMesh, CorpusError>| result.unwrap_err().to_string();
        let header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\nproperty double y\n\
            property double z\nend_header\n";
        let coordinates = [f64::NAN, 0.0, 0.0].map(f64::to_le_bytes);
        let not_a_number = [header.as_bytes(), coordinates.as_flattened()].concat();
        for (got, expected) in [
            (
                text(ascii(vertices, "3 0 1 4\n3 3 2 1\n")),
                "m.ply:18: `4` of face 0 is not one of the 4 vertices; \
                                   indices",
            ),
            (text(ascii(vertices, "3 0 1 2\n3 3 -2 1\n")), "m.ply:19: `-2` is not an index; indices are"),
            (text(ascii(vertices, "3 0 1 2\n3 3 2 3\n")), "m.ply:19: face 1: a face that names a vertex twice; divide"),
            (text(ascii(vertices, "3 0 1 2\n2 3 2\n")), "m.ply:19: face 1: a face of 2 corners; give it three"),
            (text(ascii("0 0 0 1\n1 0 0 2\n1 1 nan 3\n0 1 0 4\n", faces)), "m.ply:16: coordinate `nan` is not finite"),
            (text(ascii("0 0 0 1\n1 0 0\n1 1 0 3\n0 1 0 4\n", faces)), "m.ply:15: the line ends before `red`"),
            (text(ascii("0 0 0 1\n1 0 0 2 9\n1 1 0 3\n0 1 0 4\n", faces)), "m.ply:15: `9` follows the last property"),
            (text(ascii(vertices, "x 0 1 2\n3 3 2 1\n")), "m.ply:18: `x` is not the length of a list"),
            (text(ascii(vertices, "3 0 1\n3 3 2 1\n")), "m.ply:18: the line ends before `vertex_indices`"),
            (text(ascii(vertices, "3 0 1 b\n3 3 2 1\n")), "m.ply:18: `b` is not an index"),
            (
                text(read("m.ply", HEADER.replace("vertex 4", "vertex 99999999999").as_bytes())),
                "m.ply:4: 99999999999 elements `vertex` don't fit into 0 bytes; correct",
            ),
            (
                text(read("m.ply", header.replace("vertex 1", "vertex 99999999999").as_bytes())),
                "m.ply:3: 99999999999 elements `vertex` don't fit into 0 bytes; correct",
            ),
            (text(read("m.ply", &not_a_number)), "m.ply: at byte 118: vertex 0 is not finite: (NaN, 0, 0); remove"),
            (text(read("m.ply", b"solid\n")), "m.ply:1: the PLY file is not understood: Expected magic number"),
            (text(read("m.ply", b"")), "m.ply: the PLY file is not understood: Unexpected end"),
            (text(read("m.ply", b"ply\nformat ascii 1.0\nelement vertex x\n")), "m.ply:3: the PLY file is not"),
            (
                text(read("m.ply", b"ply\nformat ascii 1.0\n")),
                "m.ply:2: the PLY file is not understood: Unexpected end of file",
            ),
            (text(ascii(vertices, "")), "m.ply:18: `1.5` is not the length of a list"),
            (
                text(read("m.ply", format!("{HEADER}{vertices}{faces}").as_bytes())),
                "m.ply:19: the file ends after 0 of its 1 elements `camera`; correct",
            ),
            (text(ascii(vertices, "3 0 1 2\n3 3 2 1\n7\n")), "m.ply:21: there is extra text after the elements"),
            (
                text(read("m.ply", &[HEADER.as_bytes(), vertices.as_bytes(), b"3 0 \xff 2\n3 3 2 1\n7\n"].concat())),
                "m.ply:18: the file is not text in UTF-8; write",
            ),
        ] {
            assert!(got.starts_with(expected), "{got}\n  expected {expected}");
        }
    }

    #[test]
    fn headers_say_where_points_and_faces_are() {
        for (from, to, expected) in [
            ("double z", "double w", "m.ply:4: the vertices lack one of the numbers x, y and z; give"),
            ("property double z", "property list uchar double z", "m.ply:4: the vertices lack one of"),
            ("double z", "float x", "m.ply:7: the property `x` occurs twice; rename"),
            ("element camera", "element vertex", "m.ply:11: the element `vertex` occurs twice; rename"),
            ("vertex_indices", "corners", "m.ply:9: the faces have no list `vertex_indices` of integers; give"),
            ("uchar int vertex", "uchar float vertex", "m.ply:9: the faces have no list `vertex_indices` of"),
            ("list uchar int", "int", "m.ply:9: the faces have no list"),
            (
                "element camera",
                "property list uchar int vertex_index\nelement camera",
                "m.ply:9: the faces have both `vertex_indices` and `vertex_index`; remove",
            ),
            ("element camera", "element tristrips", "m.ply:11: strips of triangles are not read; write"),
        ] {
            let header = HEADER.replacen(from, to, 1);
            assert_ne!(header, HEADER);
            let error = read("m.ply", format!("{header}0 0 0 1\n0 0 0 1\n0 0 0 1\n0 0 0 1\n").as_bytes()).unwrap_err();
            assert!(error.to_string().starts_with(expected), "{error}\n  expected {expected}");
        }
        // Names in skipped elements have no meaning.
        let other = "element tristrips 0\nproperty list uchar int vertex_indices\nelement edge 1\nproperty list uchar float x\n\
            property list uchar int vertex_index\nend_header\n";
        let text = HEADER.replace("end_header\n", other)
            + "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n3 0 1 2\n3 0 2 3\n1\n1 2.5 1 -1\n";
        assert_eq!(read("m.ply", text.as_bytes()).unwrap().faces.len(), 2);
    }

    #[test]
    fn errors_in_binary_files_have_the_byte() {
        const COUNTED: &str = "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
            property float z\nelement face 2\nproperty list char int vertex_index\nend_header\n";
        let points = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        let face = |corners: &[i32]| {
            let corners = corners.iter().flat_map(|corner| corner.to_le_bytes());
            corners.collect::<Vec<u8>>()
        };
        let file = |points: [[f32; 3]; 4], length: i8, corners: &[i32]| {
            let points: Vec<u8> = points.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
            let second = [length.to_le_bytes().to_vec(), face(corners)].concat();
            [COUNTED.as_bytes(), &points, &[3], &face(&[0, 1, 2]), &second].concat()
        };
        let good = file(points, 3, &[0, 2, 3]);
        assert_eq!(read("m.ply", &good).unwrap().faces.len(), 2);
        let mut infinite = points;
        infinite[2][1] = f32::INFINITY;
        let start = COUNTED.len();
        let second = start + 48 + 13;
        for (bytes, at, message) in [
            (file(points, 3, &[0, 2, 4]), second, "`4` of face 1 is not one of the 4 vertices; indices count from 0"),
            (file(points, 3, &[0, -2, 3]), second, "face 1 has an index below zero; indices count"),
            (file(points, 3, &[0, 2, 2]), second, "face 1: a face that names a vertex twice; divide"),
            (file(points, 2, &[0, 2]), second, "face 1: a face of 2 corners; give it three"),
            (file(points, -3, &[0, 2, 3]), second, "the PLY file is not understood: List length cannot be negative"),
            (file(infinite, 3, &[0, 2, 3]), start + 24, "vertex 2 is not finite: (1, inf, 0); remove"),
            (good[..second + 5].to_vec(), second, "the file ends after 1 of its 2 elements `face`; correct"),
            (good[..second].to_vec(), second, "the file ends after 1 of its 2 elements `face`; correct"),
            (good[..start + 50].to_vec(), start + 48, "the file ends after 0 of its 2 elements `face`; correct"),
            ([good.as_slice(), b"more"].concat(), good.len(), "4 bytes follow the elements that the header counts;"),
        ] {
            let error = read("m.ply", &bytes).unwrap_err().to_string();
            let expected = format!("m.ply: at byte {at}: {message}");
            assert!(error.starts_with(&expected), "{error}\n  expected {expected}");
        }
        let short = read("m.ply", &good[..start + 9]).unwrap_err().to_string();
        assert!(short.starts_with("m.ply:3: 4 elements `vertex` don't fit into 9 bytes; correct"), "{short}");
    }
}
