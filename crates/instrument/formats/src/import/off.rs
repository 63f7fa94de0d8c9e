//! The reader of OFF files in ASCII.

use predicament_predicates::Vertex;

use super::imported_mesh::{ImportedMesh, content, contents, no_vertex, point, split};
use crate::decimals::shown;
use crate::{CorpusError, Decimals};

/// Reads OFF: the keyword, three counts, the points, the faces. They are added to an empty mesh.
pub(super) fn read(
    file: &str,
    text: &str,
    decimals: &Decimals,
    mut mesh: ImportedMesh,
) -> Result<ImportedMesh, CorpusError> {
    const CURE: &str = "give an ASCII OFF file: the word OFF, then the numbers of vertices, faces and edges";
    let error = |line: usize, message: String, cure: &str| CorpusError::file(file, message, cure).at_line(line);
    let mut lines = contents(text);
    let (line, head) =
        lines.next().ok_or_else(|| CorpusError::file(file, "the file ends before the word OFF", CURE))?;
    let rest = head
        .strip_prefix("OFF")
        .filter(|rest| rest.is_empty() || rest.starts_with(char::is_whitespace))
        .ok_or_else(|| error(line, format!("the file starts with `{}`, not with OFF", shown(head)), CURE))?;
    // The counts may follow the keyword on its line.
    let (line, counts) = match content(rest) {
        Some(counts) => (line, counts),
        None => lines.next().ok_or_else(|| error(line, "the file ends before its counts".to_owned(), CURE))?,
    };
    let counts: Vec<Option<usize>> = counts.split_whitespace().map(|count| count.parse().ok()).collect();
    let &[Some(vertices), Some(faces), Some(_)] = counts.as_slice() else {
        return Err(error(line, "three counts are expected: vertices, faces, edges".to_owned(), CURE));
    };
    let counted = |last: usize, at: usize, all: usize, what: &str| {
        error(
            last,
            format!("the file ends after {at} of its {all} {what}"),
            "correct the counts or add what is missing",
        )
    };
    let mut last = line;
    let mut width = None;
    let (mut words, mut corners): (Vec<&str>, Vec<Vertex>) = (Vec::new(), Vec::new());
    for at in 0..vertices {
        let (line, text) = lines.next().ok_or_else(|| counted(last, at, vertices, "vertices"))?;
        split(text, &mut words);
        // Colours may follow the coordinates. A face among the vertices is detected by its different number of words.
        let first = *width.get_or_insert(words.len());
        if words.len() != first {
            let message = format!("a vertex of {} numbers, and the first has {first}", words.len());
            return Err(error(line, message, "correct the counts, or write three coordinates"));
        }
        mesh.push_point(point(file, line, &words, decimals)?, line);
        last = line;
    }
    for at in 0..faces {
        let (line, text) = lines.next().ok_or_else(|| counted(last, at, faces, "faces"))?;
        last = line;
        split(text, &mut words);
        // Colours may follow the corners.
        let named = words[0].parse().ok().and_then(|corners: usize| words.get(1..corners.checked_add(1)?));
        let Some(named) = named else {
            return Err(error(line, "a face is the number of its corners, then the corners".to_owned(), CURE));
        };
        let corner = |word: &&str| {
            let index = word.parse().ok().filter(|&index: &usize| index < vertices);
            index.map(Vertex::input).ok_or_else(|| no_vertex(file, line, word, vertices, "0"))
        };
        corners.clear();
        for word in named {
            corners.push(corner(word)?);
        }
        mesh.push_face(&corners, line).map_err(|(message, cure)| error(line, message, cure))?;
    }
    match lines.next() {
        Some((line, _)) => {
            Err(error(line, format!("there is extra text after the {faces} faces"), "correct the counts"))
        }
        None => Ok(mesh),
    }
}
