//! The mesh that importers return, and helpers that read lines of text.

use predicament_mesh::half_edge::IndexedFaces;
use predicament_predicates::Vertex;

use super::{ImportNotes, Places};
use crate::decimals::{Place, explain, shown};
use crate::lines::lines;
use crate::{CorpusError, Decimals};

/// Points, and simplices of their indices.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ImportedMesh {
    /// The points.
    pub points: Vec<[f64; 3]>,
    /// Edges that belong to no face (OBJ only).
    pub edges: Vec<[Vertex; 2]>,
    /// The faces as in the file, with any number of corners from three on.
    pub faces: IndexedFaces,
    /// The triangles of the faces.
    pub triangles: Vec<[Vertex; 3]>,
    /// The positions of the points and the faces in the file.
    pub places: Places,
    /// Counts of what the reader left out or changed.
    pub notes: ImportNotes,
    /// True if degenerate faces are kept; otherwise they are refused, or dropped and counted.
    pub(super) keeps_degenerate: bool,
}

/// A line without its comment, or `None` if it is then empty.
pub(super) fn content(line: &str) -> Option<&str> {
    let line = memchr::memchr(b'#', line.as_bytes()).map_or(line, |at| &line[..at]).trim();
    (!line.is_empty()).then_some(line)
}

/// The lines with content, numbered from 1.
pub(super) fn contents(text: &str) -> impl Iterator<Item = (usize, &str)> {
    lines(text).filter_map(|line| content(line.body).map(|body| (line.number, body)))
}

/// Replaces `words` by those of a line.
pub(super) fn split<'t>(line: &'t str, words: &mut Vec<&'t str>) {
    words.clear();
    if line.is_ascii() {
        words.extend(line.split_ascii_whitespace());
    } else {
        words.extend(line.split_whitespace());
    }
}

pub(super) fn no_vertex(file: &str, line: usize, word: &str, points: usize, first: &str) -> CorpusError {
    let message = format!("`{}` is not one of the {points} vertices", shown(word));
    CorpusError::file(file, message, format!("indices count from {first}")).at_line(line)
}

pub(super) fn point(file: &str, line: usize, words: &[&str], decimals: &Decimals) -> Result<[f64; 3], CorpusError> {
    let Some(words) = words.first_chunk::<3>() else {
        let message = format!("a vertex of {} coordinates", words.len());
        return Err(CorpusError::file(file, message, "write three coordinates").at_line(line));
    };
    let mut point = [0.0; 3];
    for (x, word) in point.iter_mut().zip(words) {
        *x = decimals.read(word).map_err(|why| {
            let (message, cure) = explain(Place::Data, word, &why);
            CorpusError::file(file, message, cure).at_line(line)
        })?;
    }
    Ok(point)
}

/// True if a vertex is named twice.
fn has_repeats(corners: &[Vertex]) -> bool {
    if let [a, b, c] = corners {
        return a == b || b == c || c == a;
    }
    let mut sorted = corners.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).any(|pair| pair[0] == pair[1])
}

impl ImportedMesh {
    /// Appends a point and its position.
    pub(super) fn push_point(&mut self, point: [f64; 3], at: usize) {
        self.points.push(point);
        self.places.push_point(at);
    }

    /// Appends a face, its triangles, and its position. The error is a message and its fix.
    pub(super) fn push_face(&mut self, corners: &[Vertex], at: usize) -> Result<(), (String, &'static str)> {
        let [first, rest @ ..] = corners else {
            return Err(("a face without corners".to_owned(), "remove it"));
        };
        if rest.len() < 2 && !self.keeps_degenerate {
            return Err((format!("a face of {} corners", corners.len()), "give it three, or remove it"));
        }
        if !self.keeps_degenerate && has_repeats(corners) {
            return Err(("a face that names a vertex twice".to_owned(), "divide it, or remove it"));
        }
        // The corners are input vertices, of which there are at most 2^31.
        self.faces.push(corners.iter().filter_map(|corner| u32::try_from(corner.index()).ok()));
        self.triangles.extend(rest.windows(2).map(|next| [*first, next[0], next[1]]));
        self.places.push_face(at);
        Ok(())
    }
}
