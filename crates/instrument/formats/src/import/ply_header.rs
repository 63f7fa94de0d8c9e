//! Checks of a PLY header that its parser does not make, with the line of each error.
//!
//! The parser returns elements and properties without their lines, and of two with one name only the last.

use ply_rs_bw::ply::{ElementDef, Encoding, Header, PropertyType, ScalarType};

use super::ply_element::{axis, is_corners};
use crate::CorpusError;
use crate::decimals::shown;

/// Refuses headers that do not describe points and faces, or whose counts exceed the file.
pub(super) fn check(file: &str, text: &[u8], header: &Header, payload: usize) -> Result<(), CorpusError> {
    let lines = lines(file, text)?;
    for element in header.elements.values() {
        let line = lines.iter().find(|(name, _)| *name == element.name).map_or(1, |(_, line)| *line);
        let error = |message: String, cure: &str| Err(CorpusError::file(file, message, cure).at_line(line));
        // The last line of an ASCII file may lack its newline.
        if least(element, header.encoding) > payload + 1 {
            let message = format!("{} elements `{}` don't fit into {payload} bytes", element.count, element.name);
            return error(message, "correct the counts or add what is missing");
        }
        let types = || element.properties.values().map(|property| (property.name.as_str(), &property.data_type));
        match element.name.as_str() {
            _ if element.count == 0 => {}
            "vertex" => {
                let is_number = |of| types().any(|(name, kind)| axis(name) == Some(of) && is_scalar(kind));
                if !(0..3).all(is_number) {
                    let message = "the vertices lack one of the numbers x, y and z".to_owned();
                    return error(message, "give every vertex three coordinates");
                }
            }
            "face" => {
                match types().filter(|(name, _)| is_corners(name)).map(|(_, kind)| kind).collect::<Vec<_>>()[..] {
                    [PropertyType::List(_, corner)] if is_integer(corner) => {}
                    [_] | [] => {
                        let message = "the faces have no list `vertex_indices` of integers".to_owned();
                        return error(message, "give every face its vertices");
                    }
                    _ => {
                        let message = "the faces have both `vertex_indices` and `vertex_index`".to_owned();
                        return error(message, "remove one of them");
                    }
                }
            }
            "tristrips" => return error("strips of triangles are not read".to_owned(), "write the triangles as faces"),
            _ => {}
        }
    }
    Ok(())
}

/// The line of each element, counted from 1. Duplicate names are an error.
fn lines<'h>(file: &str, text: &'h [u8]) -> Result<Vec<(&'h str, usize)>, CorpusError> {
    let mut elements: Vec<(&str, usize)> = Vec::new();
    let mut properties: Vec<&str> = Vec::new();
    // Comments need not be UTF-8.
    for (line, bytes) in (1..).zip(text.split(|&byte| byte == b'\n')) {
        let words: Vec<&str> = str::from_utf8(bytes).unwrap_or_default().split_ascii_whitespace().collect();
        let twice = match words[..] {
            ["element", name, ..] => {
                let is_there = elements.iter().any(|(other, _)| *other == name);
                elements.push((name, line));
                properties.clear();
                is_there.then_some(("element", name))
            }
            ["property", .., name] => {
                let is_there = properties.contains(&name);
                properties.push(name);
                is_there.then_some(("property", name))
            }
            _ => None,
        };
        if let Some((what, name)) = twice {
            let message = format!("the {what} `{}` occurs twice", shown(name));
            return Err(CorpusError::file(file, message, "rename one of the two, or remove it").at_line(line));
        }
    }
    Ok(elements)
}

fn is_scalar(kind: &PropertyType) -> bool {
    matches!(kind, PropertyType::Scalar(_))
}

fn is_integer(scalar: &ScalarType) -> bool {
    !matches!(scalar, ScalarType::Float | ScalarType::Double)
}

/// The minimum number of bytes for all elements of a kind.
fn least(element: &ElementDef, encoding: Encoding) -> usize {
    let one = match encoding {
        // Each word is followed by a blank or a newline.
        Encoding::Ascii => 2 * element.properties.len(),
        Encoding::BinaryBigEndian | Encoding::BinaryLittleEndian => {
            let width = |kind: &PropertyType| match kind {
                PropertyType::Scalar(scalar) | PropertyType::List(scalar, _) => width(scalar),
            };
            element.properties.values().map(|property| width(&property.data_type)).sum()
        }
    };
    element.count.saturating_mul(one.max(1))
}

/// The size in bytes of a number in a binary file.
fn width(scalar: &ScalarType) -> usize {
    match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}
