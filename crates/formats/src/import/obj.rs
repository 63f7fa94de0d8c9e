//! OBJ.

use predicament_predicates::Vertex;

use super::mesh::{ImportedMesh, contents, no_vertex, point};
use crate::decimals::shown;
use crate::{CorpusError, Decimals};

/// Reads OBJ: `v`, `f` and `l`; what only matters for pictures is passed over.
pub(super) fn read(file: &str, text: &str, decimals: &Decimals) -> Result<ImportedMesh, CorpusError> {
    const PASSED_OVER: [&str; 8] = ["vn", "vt", "g", "o", "s", "usemtl", "mtllib", "p"];
    let mut mesh = ImportedMesh::default();
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
            // A weight or colours may follow the coordinates.
            "v" => mesh.points.push(point(file, line, &words[1..], decimals)?),
            "f" => mesh
                .push_face(&corners()?)
                .map_err(|(message, cure)| CorpusError::file(file, message, cure).at_line(line))?,
            "l" => mesh.edges.extend(corners()?.windows(2).map(|ends| [ends[0], ends[1]])),
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
