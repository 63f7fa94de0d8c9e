//! The reader of OBJ files.

use predicament_predicates::Vertex;

use super::imported_mesh::{ImportedMesh, contents, no_vertex, point};
use crate::coordinate::{self, CoordinateError};
use crate::decimals::shown;
use crate::{CorpusError, Decimals};

/// Checks the words after the three coordinates of a vertex: a weight of 1, or a colour. The error is a message and its
/// fix.
fn behind(words: &[&str]) -> Result<(), (String, &'static str)> {
    let number = |word: &&str| match coordinate::read(word) {
        Err(CoordinateError::Malformed) => Err((format!("`{}` is not a number", shown(word)), "write a number")),
        // Not read as a coordinate: it need not be a double.
        read => Ok(read),
    };
    match words.get(3..).unwrap_or_default() {
        [] => Ok(()),
        [weight] => match number(weight)? {
            Ok(1.0) => Ok(()),
            _ => Err((format!("a vertex of weight {}", shown(weight)), "divide its coordinates by the weight")),
        },
        colour @ [_, _, _] => colour.iter().try_for_each(|word| number(word).map(drop)),
        _ => Err((
            format!("a vertex of {} numbers", words.len()),
            "write three coordinates, and perhaps a weight of 1 or a colour of three numbers",
        )),
    }
}

/// Reads OBJ: `v`, `f` and `l`; elements that only affect rendering are skipped.
pub(super) fn read(
    file: &str,
    text: &str,
    decimals: &Decimals,
    mut mesh: ImportedMesh,
) -> Result<ImportedMesh, CorpusError> {
    const PASSED_OVER: [&str; 8] = ["vn", "vt", "g", "o", "s", "usemtl", "mtllib", "p"];
    for (line, words) in contents(text) {
        let words: Vec<&str> = words.split_whitespace().collect();
        let points = mesh.points.len();
        // `7/1/3` is the seventh point with a texture and a normal; -1 is the last point so far.
        let corner = |word: &&str| {
            let index: Option<i64> = word.split('/').next().and_then(|index| index.parse().ok());
            let place = index.and_then(|index| match index {
                1.. => usize::try_from(index - 1).ok(),
                _ => points.checked_sub(usize::try_from(index.unsigned_abs()).ok()?),
            });
            place
                .filter(|&place| place < points)
                .map(Vertex::input)
                .ok_or_else(|| no_vertex(file, line, word, points, "1"))
        };
        let corners = || words[1..].iter().map(corner).collect::<Result<Vec<_>, _>>();
        match words[0] {
            "v" => {
                behind(&words[1..]).map_err(|(message, cure)| CorpusError::file(file, message, cure).at_line(line))?;
                mesh.push_point(point(file, line, &words[1..], decimals)?, line);
            }
            "f" => mesh
                .push_face(&corners()?, line)
                .map_err(|(message, cure)| CorpusError::file(file, message, cure).at_line(line))?,
            "l" => {
                let corners = corners()?;
                let error = |message: &str, cure: &str| CorpusError::file(file, message, cure).at_line(line);
                if corners.len() < 2 {
                    return Err(error(&format!("a line of {} vertices", corners.len()), "give it two, or remove it"));
                }
                let edges = corners.windows(2).map(|ends| [ends[0], ends[1]]);
                if !mesh.keeps_degenerate && edges.clone().any(|[start, end]| start == end) {
                    return Err(error("a line that names a vertex twice in a row", "name it once"));
                }
                mesh.edges.extend(edges);
            }
            word if PASSED_OVER.contains(&word) => {}
            word => {
                let message = format!("`{}` is not understood", shown(word));
                let cure = "write the shape as points (v), faces (f) and lines (l)";
                return Err(CorpusError::file(file, message, cure).at_line(line));
            }
        }
    }
    Ok(mesh)
}
