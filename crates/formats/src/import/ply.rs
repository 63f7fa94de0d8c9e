//! PLY: the header and both binary forms, read by the crate `ply-rs-bw`.
//!
//! The crate keeps every bit of binary numbers. Of ASCII it gives numbers that are rounded already, so that
//! form is read [here](super::ply_ascii).

use std::io::BufReader;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use predicament_predicates::Vertex;

use super::mesh::ImportedMesh;
use super::ply_ascii;
use crate::decimals::shown;
use crate::{CorpusError, Decimals};

/// An element of any kind: what matters of its properties.
#[derive(Default)]
pub(super) struct Element {
    /// `x`, `y` and `z`.
    pub(super) at: [Option<f64>; 3],
    /// `vertex_indices`, which some call `vertex_index`; none if one is negative.
    pub(super) corners: Option<Vec<u32>>,
}

/// The axis that a property of a vertex is the coordinate of.
pub(super) fn axis(name: &str) -> Option<usize> {
    ["x", "y", "z"].iter().position(|axis| *axis == name)
}

/// Whether a property of a face is the list of its vertices.
pub(super) fn is_corners(name: &str) -> bool {
    matches!(name, "vertex_indices" | "vertex_index")
}

impl PropertyAccess for Element {
    fn new() -> Element {
        Element::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if is_corners(name) {
            self.corners = property.to_u32_list();
            return PropertyAccessResult::Set;
        }
        let Some(axis) = axis(name) else { return PropertyAccessResult::Ignored };
        self.at[axis] = match property {
            Property::Char(x) => Some(x.into()),
            Property::UChar(x) => Some(x.into()),
            Property::Short(x) => Some(x.into()),
            Property::UShort(x) => Some(x.into()),
            Property::Int(x) => Some(x.into()),
            Property::UInt(x) => Some(x.into()),
            Property::Float(x) => Some(x.into()),
            Property::Double(x) => Some(x),
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

/// Reads the elements `vertex` and `face`; all others are passed over.
pub(super) fn read(file: &str, bytes: &[u8], decimals: &Decimals) -> Result<ImportedMesh, CorpusError> {
    let broken = |error: ParseError| {
        // The parser's own words name its grammar.
        let said = shown(error.to_string().lines().next().unwrap_or_default());
        let described = CorpusError::file(
            file,
            format!("the PLY file is not understood: {said}"),
            "write the file again or convert it to OFF or OBJ",
        );
        error.line().map_or(described.clone(), |line| described.at_line(line))
    };
    let mut rest = bytes;
    let mut reader = Reader::new(BufReader::with_capacity(1, &mut rest));
    let parser = Parser::<Element>::new();
    let header = parser.read_header(&mut reader).map_err(broken)?;
    drop(reader);
    let start = bytes.len() - rest.len();
    enough(file, &header, rest.len())?;
    let mut ascii = ply_ascii::Payload::new(file, &bytes[..start], rest, decimals);
    let mut reader = Reader::new(BufReader::new(rest));
    let mut mesh = ImportedMesh::default();
    for element in header.elements.values() {
        let found = match header.encoding {
            Encoding::Ascii => ascii.element(element)?,
            Encoding::BinaryBigEndian | Encoding::BinaryLittleEndian => {
                parser.read_payload_for_element(&mut reader, element, &header).map_err(broken)?
            }
        };
        match element.name.as_str() {
            "vertex" => {
                for (index, vertex) in found.into_iter().enumerate() {
                    mesh.points.push(point(file, index, vertex.at)?);
                }
            }
            "face" => {
                let vertices = mesh.points.len();
                for (index, face) in found.into_iter().enumerate() {
                    let error = |message: String, cure: &str| CorpusError::file(file, message, cure);
                    let Some(corners) = face.corners else {
                        let message = format!("face {index} has no list `vertex_indices` of numbers from 0");
                        return Err(error(message, "give every face its vertices"));
                    };
                    let of = |corner: u32| {
                        let place = usize::try_from(corner).ok().filter(|&place| place < vertices);
                        place.map(Vertex::input).ok_or_else(|| {
                            let message = format!("`{corner}` of face {index} is none of the {vertices} vertices");
                            error(message, "indices count from 0, and vertices come before faces")
                        })
                    };
                    let corners = corners.into_iter().map(of).collect::<Result<Vec<_>, _>>()?;
                    mesh.push_face(&corners)
                        .map_err(|(message, cure)| error(format!("face {index}: {message}"), cure))?;
                }
            }
            _ => {}
        }
    }
    match header.encoding {
        Encoding::Ascii => ascii.end()?,
        Encoding::BinaryBigEndian | Encoding::BinaryLittleEndian => {
            let left = reader.get_ref().buffer().len() + reader.get_ref().get_ref().len();
            if left > 0 {
                let message = format!("{left} bytes follow the elements that the header counts");
                return Err(CorpusError::file(file, message, "correct the counts"));
            }
        }
    }
    Ok(mesh)
}

/// Refuses counts that the file can't hold, before anything is made of them.
fn enough(file: &str, header: &Header, bytes: usize) -> Result<(), CorpusError> {
    let least = |element: &ElementDef| {
        let width = match header.encoding {
            // A blank or the end of a line behind each word.
            Encoding::Ascii => 2 * element.properties.len(),
            Encoding::BinaryBigEndian | Encoding::BinaryLittleEndian => {
                let width = |kind: &PropertyType| match kind {
                    PropertyType::Scalar(scalar) | PropertyType::List(scalar, _) => width(scalar),
                };
                element.properties.values().map(|property| width(&property.data_type)).sum()
            }
        };
        element.count.saturating_mul(width.max(1))
    };
    for element in header.elements.values() {
        // The last line of an ASCII file may have no end.
        if least(element) > bytes + 1 {
            let message = format!("{} elements `{}` don't fit into {bytes} bytes", element.count, element.name);
            return Err(CorpusError::file(file, message, "correct the counts or add what is missing"));
        }
    }
    Ok(())
}

/// The bytes of a number in a binary file.
fn width(scalar: &ScalarType) -> usize {
    match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}

fn point(file: &str, index: usize, at: [Option<f64>; 3]) -> Result<[f64; 3], CorpusError> {
    let error = |message: String, cure: &str| CorpusError::file(file, message, cure);
    let [Some(x), Some(y), Some(z)] = at else {
        return Err(error(format!("vertex {index} lacks one of x, y and z"), "give every vertex three coordinates"));
    };
    if [x, y, z].iter().any(|coordinate| !coordinate.is_finite()) {
        return Err(error(format!("vertex {index} is not finite: ({x}, {y}, {z})"), "remove the vertex"));
    }
    Ok([x, y, z])
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "ply\nformat ascii 1.0\ncomment a pyramid\nelement vertex 4\nproperty float x\n\
        property float y\nproperty double z\nproperty uchar red\nelement face 2\n\
        property list uchar int vertex_indices\nelement camera 1\nproperty float zoom\nend_header\n";

    fn read(file: &str, bytes: &[u8]) -> Result<ImportedMesh, CorpusError> {
        super::read(file, bytes, &Decimals::new(false))
    }

    fn ascii(vertices: &str, faces: &str) -> Result<ImportedMesh, CorpusError> {
        read("m.ply", format!("{HEADER}{vertices}{faces}1.5\n").as_bytes())
    }

    #[test]
    fn singles_and_doubles_as_they_are_declared() {
        let vertices = "0 0 0 1\n0.1 0 0.1 2\n1 1 0 3\n0 1 0 4\n";
        let error = ascii(vertices, "4 0 1 2 3\n3 3 2 1\n").unwrap_err().to_string();
        assert!(error.starts_with("m.ply:15: decimal 0.1 is not exactly a double; write `round = true`"), "{error}");
        let decimals = Decimals::new(true);
        let text = format!("{HEADER}{vertices}4 0 1 2 3\n3 3 2 1\n1.5\n");
        let mesh = super::read("m.ply", text.as_bytes(), &decimals).unwrap();
        assert_eq!(decimals.rounded(), 2);
        assert_eq!(mesh.points[1], [0.1_f32.into(), 0.0, 0.1]);
        let triangles = [[0, 1, 2], [0, 2, 3], [3, 2, 1]].map(|triangle| triangle.map(Vertex::input));
        assert_eq!(mesh.triangles, triangles);
        // The same in binary.
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
        assert_eq!(read("m.ply", &bytes), Ok(mesh));
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
            (text(ascii(vertices, "3 0 1 4\n3 3 2 1\n")), "m.ply: `4` of face 0 is none of the 4 vertices; indices"),
            (text(ascii(vertices, "3 0 1 2\n3 3 -2 1\n")), "m.ply: face 1 has no list `vertex_indices`"),
            (text(ascii(vertices, "3 0 1 2\n3 3 2 3\n")), "m.ply: face 1: a face that names a vertex twice; divide"),
            (text(ascii(vertices, "3 0 1 2\n2 3 2\n")), "m.ply: face 1: a face of 2 corners; give it three"),
            (text(ascii("0 0 0 1\n1 0 0 2\n1 1 nan 3\n0 1 0 4\n", faces)), "m.ply:16: coordinate `nan` is not finite"),
            (text(ascii("0 0 0 1\n1 0 0\n1 1 0 3\n0 1 0 4\n", faces)), "m.ply:15: the line ends before `red`"),
            (text(ascii("0 0 0 1\n1 0 0 2 9\n1 1 0 3\n0 1 0 4\n", faces)), "m.ply:15: `9` follows the last property"),
            (text(ascii(vertices, "x 0 1 2\n3 3 2 1\n")), "m.ply:18: `x` is no length of a list"),
            (text(ascii(vertices, "3 0 1\n3 3 2 1\n")), "m.ply:18: the line ends before `vertex_indices`"),
            (text(ascii(vertices, "3 0 1 b\n3 3 2 1\n")), "m.ply:18: `b` is no index"),
            (
                text(read("m.ply", HEADER.replace("vertex 4", "vertex 99999999999").as_bytes())),
                "m.ply: 99999999999 elements `vertex` don't fit into 0 bytes; correct",
            ),
            (
                text(read("m.ply", header.replace("vertex 1", "vertex 99999999999").as_bytes())),
                "m.ply: 99999999999 elements `vertex` don't fit into 0 bytes; correct",
            ),
            (text(read("m.ply", &not_a_number)), "m.ply: vertex 0 is not finite: (NaN, 0, 0); remove"),
            (text(read("m.ply", HEADER.replace("double z", "double w").as_bytes())), "m.ply"),
            (text(read("m.ply", b"solid\n")), "m.ply"),
            (text(read("m.ply", format!("{HEADER}0 0 0 1\n").as_bytes())), "m.ply"),
        ] {
            assert!(got.starts_with(expected), "{got}\n  expected {expected}");
        }
    }
}
