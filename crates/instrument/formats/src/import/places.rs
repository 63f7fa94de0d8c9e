//! The positions of a mesh's parts in its file, so that later errors about the mesh have a position too.

use crate::Position;

/// The positions of a mesh's points and faces in a file: lines of a text, or bytes of a binary file.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Places {
    is_binary: bool,
    // Four bytes each: files have at most 2^31 bytes.
    points: Vec<u32>,
    faces: Vec<u32>,
}

/// The value for a position beyond the range of four bytes.
const UNKNOWN: u32 = u32::MAX;

fn short(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(UNKNOWN)
}

impl Places {
    /// The lines of faces, counted from 1, of a mesh whose points have no lines.
    #[must_use]
    pub fn of_lines(faces: impl IntoIterator<Item = usize>) -> Places {
        Places { faces: faces.into_iter().map(short).collect(), ..Places::default() }
    }

    /// The lines of points, counted from 1.
    pub(super) fn of_points(points: impl IntoIterator<Item = usize>) -> Places {
        Places { points: points.into_iter().map(short).collect(), ..Places::default() }
    }

    /// An empty list of positions in a binary file.
    pub(super) fn binary() -> Places {
        Places { is_binary: true, ..Places::default() }
    }

    /// Appends the position of a point; its first corner, if the file has no list of points.
    pub(super) fn push_point(&mut self, at: usize) {
        self.points.push(short(at));
    }

    /// Appends the position of a face.
    pub(super) fn push_face(&mut self, at: usize) {
        self.faces.push(short(at));
    }

    /// The number of points with known positions.
    pub(super) fn points(&self) -> usize {
        self.points.len()
    }

    /// The position of a point; its first corner, if the file has no list of points.
    #[must_use]
    pub fn point(&self, point: usize) -> Option<Position> {
        self.position(&self.points, point)
    }

    /// The position of a face.
    #[must_use]
    pub fn face(&self, face: usize) -> Option<Position> {
        self.position(&self.faces, face)
    }

    fn position(&self, of: &[u32], index: usize) -> Option<Position> {
        let at = of.get(index).filter(|&&at| at != UNKNOWN)?;
        let at = usize::try_from(*at).ok()?;
        Some(if self.is_binary { Position::Byte(at) } else { Position::Line(at) })
    }

    /// A point in a message: its number from 0, and its position, as in `4 (line 6)`.
    #[must_use]
    pub fn point_name(&self, point: usize) -> String {
        name(point, self.point(point))
    }

    /// A face in a message: its number from 0, and its position, as in `2 (byte 184)`.
    #[must_use]
    pub fn face_name(&self, face: usize) -> String {
        name(face, self.face(face))
    }
}

fn name(index: usize, position: Option<Position>) -> String {
    position.map_or_else(|| index.to_string(), |position| format!("{index} ({position})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_a_place_is_named_with_it() {
        let lines = Places::of_lines([7, 9, usize::MAX]);
        assert_eq!((lines.face_name(1).as_str(), lines.point_name(1).as_str()), ("1 (line 9)", "1"));
        assert_eq!((lines.face(2), lines.face(3), lines.face_name(2).as_str()), (None, None, "2"));
        let mut bytes = Places::binary();
        bytes.push_point(96);
        bytes.push_face(84);
        assert_eq!((bytes.point(0), bytes.face(0)), (Some(Position::Byte(96)), Some(Position::Byte(84))));
        assert_eq!(bytes.point_name(0), "0 (byte 96)");
    }
}
