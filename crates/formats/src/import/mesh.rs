//! Mesh importers: OFF and OBJ, in ASCII, and PLY; all of them also
//! compressed by gzip.
//!
//! Only points and faces are read. Faces with more than three corners are
//! divided into triangles by a fan around their first corner. Coordinates are
//! decimals that were rounded when they were written; each is read as the
//! double that is nearest to it.

use std::io::Read;

use flate2::read::MultiGzDecoder;
use predicament_predicates::Vertex;

use super::ply;
use crate::CorpusError;
use crate::coordinate;
use crate::document::explain;

/// Points, and simplices of their indices.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ImportedMesh {
    /// The points.
    pub points: Vec<[f64; 3]>,
    /// Edges that belong to no face (OBJ only).
    pub edges: Vec<[Vertex; 2]>,
    /// The faces.
    pub triangles: Vec<[Vertex; 3]>,
}

/// Reads a file by its extension, `.off`, `.obj` or `.ply`, each perhaps with `.gz` behind it.
pub fn read(file: &str, bytes: &[u8]) -> Result<ImportedMesh, CorpusError> {
    let lower = file.to_ascii_lowercase();
    let unpacked;
    let (name, bytes) = match lower.strip_suffix(".gz") {
        None => (lower.as_str(), bytes),
        Some(name) => {
            let mut all = Vec::new();
            MultiGzDecoder::new(bytes).read_to_end(&mut all).map_err(|why| {
                CorpusError::file(file, format!("the file can't be unpacked: {why}"), "compress it with gzip")
            })?;
            unpacked = all;
            (name, unpacked.as_slice())
        }
    };
    let text = || {
        std::str::from_utf8(bytes).map_err(|why| {
            let line = bytes[..why.valid_up_to()].iter().filter(|&&byte| byte == b'\n').count() + 1;
            CorpusError::file(file, "the file is not text", "write it in ASCII").at_line(line)
        })
    };
    if name.ends_with(".off") {
        off(file, text()?)
    } else if name.ends_with(".obj") {
        obj(file, text()?)
    } else if name.ends_with(".ply") {
        ply::read(file, bytes)
    } else {
        Err(CorpusError::file(file, "the file's name doesn't tell its format", "name a .off, .obj or .ply file"))
    }
}

/// What is left of a line without its comment, if anything.
fn content(line: &str) -> Option<&str> {
    let line = line.split('#').next().unwrap_or_default().trim();
    (!line.is_empty()).then_some(line)
}

/// The lines that say something, numbered from 1.
fn contents(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().filter_map(|(at, line)| content(line).map(|line| (at + 1, line)))
}

/// Reads OFF: the word, three counts, that many points, that many faces.
fn off(file: &str, text: &str) -> Result<ImportedMesh, CorpusError> {
    const CURE: &str = "give an ASCII OFF file: the word OFF, then the numbers of vertices, faces and edges";
    let error = |line: usize, message: String, cure: &str| CorpusError::file(file, message, cure).at_line(line);
    let short = |what: &str| CorpusError::file(file, format!("the file ends before {what}"), CURE);
    let mut lines = contents(text);
    let (line, head) = lines.next().ok_or_else(|| short("the word OFF"))?;
    let rest = head
        .strip_prefix("OFF")
        .filter(|rest| rest.is_empty() || rest.starts_with(char::is_whitespace))
        .ok_or_else(|| error(line, format!("the file starts with `{head}`, not with OFF"), CURE))?;
    // The counts may stand behind the word.
    let (line, counts) = match content(rest) {
        Some(counts) => (line, counts),
        None => lines.next().ok_or_else(|| short("its counts"))?,
    };
    let counts: Vec<Option<usize>> = counts.split_whitespace().map(|count| count.parse().ok()).collect();
    let &[Some(vertices), Some(faces), Some(_)] = counts.as_slice() else {
        return Err(error(line, "three counts are expected: vertices, faces, edges".to_owned(), CURE));
    };
    let counted = |at: usize, all: usize, what: &str| {
        let message = format!("the file ends after {at} of its {all} {what}");
        CorpusError::file(file, message, "correct the counts or add what is missing")
    };
    let mut mesh = ImportedMesh::default();
    for at in 0..vertices {
        let (line, words) = lines.next().ok_or_else(|| counted(at, vertices, "vertices"))?;
        mesh.points.push(point(file, line, &words.split_whitespace().collect::<Vec<_>>())?);
    }
    for at in 0..faces {
        let (line, words) = lines.next().ok_or_else(|| counted(at, faces, "faces"))?;
        let words: Vec<&str> = words.split_whitespace().collect();
        // Colours may follow the corners.
        let corners = words[0].parse().ok().and_then(|corners: usize| words.get(1..corners.checked_add(1)?));
        let Some(corners) = corners else {
            return Err(error(line, "a face is the number of its corners, then the corners".to_owned(), CURE));
        };
        let corner = |word: &&str| {
            let index = word.parse().ok().filter(|&index: &usize| index < vertices);
            index.map(Vertex::input).ok_or_else(|| no_vertex(file, line, word, vertices, "0"))
        };
        let corners = corners.iter().map(corner).collect::<Result<Vec<_>, _>>()?;
        fan(&corners, &mut mesh.triangles).map_err(|(message, cure)| error(line, message, cure))?;
    }
    match lines.next() {
        Some((line, _)) => Err(error(line, format!("more follows the {faces} faces"), "correct the counts")),
        None => Ok(mesh),
    }
}

/// Reads OBJ: `v`, `f` and `l`; what only matters for pictures is passed over.
fn obj(file: &str, text: &str) -> Result<ImportedMesh, CorpusError> {
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
            "v" => mesh.points.push(point(file, line, &words[1..])?),
            "f" => fan(&corners()?, &mut mesh.triangles)
                .map_err(|(message, cure)| CorpusError::file(file, message, cure).at_line(line))?,
            "l" => mesh.edges.extend(corners()?.windows(2).map(|ends| [ends[0], ends[1]])),
            word if PASSED_OVER.contains(&word) => {}
            word => {
                let message = format!("`{word}` is not understood");
                let cure = "write the shape as points (v), faces (f) and lines (l)";
                return Err(CorpusError::file(file, message, cure).at_line(line));
            }
        }
    }
    Ok(mesh)
}

fn no_vertex(file: &str, line: usize, word: &str, points: usize, first: &str) -> CorpusError {
    let message = format!("`{word}` is none of the {points} vertices");
    CorpusError::file(file, message, format!("indices count from {first}")).at_line(line)
}

fn point(file: &str, line: usize, words: &[&str]) -> Result<[f64; 3], CorpusError> {
    let Some(words) = words.first_chunk::<3>() else {
        let message = format!("a vertex of {} coordinates", words.len());
        return Err(CorpusError::file(file, message, "write three coordinates").at_line(line));
    };
    let mut point = [0.0; 3];
    for (x, word) in point.iter_mut().zip(words) {
        *x = coordinate::nearest(word).map_err(|why| {
            let (message, cure) = explain(file, word, &why);
            CorpusError::file(file, message, cure).at_line(line)
        })?;
    }
    Ok(point)
}

/// Appends the triangles of a face; or what is wrong with it, and the cure.
pub fn fan(corners: &[Vertex], out: &mut Vec<[Vertex; 3]>) -> Result<(), (String, &'static str)> {
    let [first, rest @ ..] = corners else {
        return Err(("a face without corners".to_owned(), "remove it"));
    };
    if rest.len() < 2 {
        return Err((format!("a face of {} corners", corners.len()), "give it three, or remove it"));
    }
    let mut sorted = corners.to_vec();
    sorted.sort_unstable();
    if sorted.windows(2).any(|pair| pair[0] == pair[1]) {
        return Err(("a face that names a vertex twice".to_owned(), "divide it, or remove it"));
    }
    out.extend(rest.windows(2).map(|next| [*first, next[0], next[1]]));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(file: &str, text: &str) -> Result<ImportedMesh, CorpusError> {
        super::read(file, text.as_bytes())
    }

    fn v<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
        indices.map(Vertex::input)
    }

    #[test]
    fn the_same_shape_in_both_formats() {
        let off =
            "OFF # a pyramid\n5 2 0\n\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.1 0 1e-1 # apex\n4 0 1 2 3\n3 4 0 1 255 0 0\n";
        let obj = "mtllib none\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nv 0.1 0 0.1\nf -1 1 2\n";
        let [off, obj] = [read("a.off", off).unwrap(), read("a.OBJ", obj).unwrap()];
        assert_eq!(off, obj);
        assert_eq!(off.triangles, [v([0, 1, 2]), v([0, 2, 3]), v([4, 0, 1])]);
        assert_eq!(off.points[4], [0.1, 0.0, 0.1]);
        let mut packed = flate2::read::GzEncoder::new("OFF\n1 0 0\n1 2 3\n".as_bytes(), flate2::Compression::fast());
        let mut bytes = Vec::new();
        packed.read_to_end(&mut bytes).unwrap();
        assert_eq!(super::read("c.off.gz", &bytes).unwrap().points, [[1.0, 2.0, 3.0]]);
        assert_eq!(read("b.off", "OFF 0 0 0").unwrap(), ImportedMesh::default());
        assert_eq!(read("b.obj", "v 0 0 0\nv 1 1 1\nv 2 2 0\nl 1 2 3").unwrap().edges, [v([0, 1]), v([1, 2])]);
    }

    #[test]
    fn errors_name_file_line_and_cure() {
        let off = |text: &str| read("m.off", &format!("OFF\n{text}")).unwrap_err().to_string();
        let obj = |text: &str| read("m.obj", &format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{text}")).unwrap_err().to_string();
        for (got, expected) in [
            (off("2 0 0\n0 0 0\n"), "m.off: the file ends after 1 of its 2 vertices; correct"),
            (off("1 1 0\n0 0 0\n"), "m.off: the file ends after 0 of its 1 faces; correct"),
            (off("1 0 0\n0 0 0\n0 0 1\n"), "m.off:4: more follows the 0 faces; correct"),
            (off("1 0\n0 0 0\n"), "m.off:2: three counts are expected"),
            (off(""), "m.off: the file ends before its counts; give"),
            (off("1 1 0\n0 0 0\n3 0 0 1\n"), "m.off:4: `1` is none of the 1 vertices; indices count from 0"),
            (off("1 1 0\n0 0 0\n3 0 0\n"), "m.off:4: a face is the number of its corners, then the corners; give"),
            (off("1 0 0\n0 0\n"), "m.off:3: a vertex of 2 coordinates; write three"),
            (off("1 0 0\n0 0 nan\n"), "m.off:3: coordinate `nan` is not finite; remove"),
            (obj("f 1 2\n"), "m.obj:4: a face of 2 corners; give it three"),
            (obj("f 1 2 4\n"), "m.obj:4: `4` is none of the 3 vertices; indices count from 1"),
            (obj("f 0 1 2\n"), "m.obj:4: `0` is none of the 3 vertices"),
            (obj("f -4 1 2\n"), "m.obj:4: `-4` is none of the 3 vertices"),
            (obj("f 1 2 1\n"), "m.obj:4: a face that names a vertex twice; divide it"),
            (obj("curv 1 2\n"), "m.obj:4: `curv` is not understood; write"),
            (read("m.off", "solid\n").unwrap_err().to_string(), "m.off:1: the file starts with `solid`, not with OFF;"),
            (read("m.off.gz", "OFF").unwrap_err().to_string(), "m.off.gz: the file can't be unpacked: "),
            (super::read("m.off", b"OFF\n\xff").unwrap_err().to_string(), "m.off:2: the file is not text; write"),
            (read("m.stl", "").unwrap_err().to_string(), "m.stl: the file's name doesn't tell its format; name"),
        ] {
            assert!(got.starts_with(expected), "{got}\n  expected {expected}");
        }
    }
}
