//! An object as a list of simplices.

use predicament_predicates::Vertex;

/// The boundary of an object: directed edges in the plane, triangles in space.
///
/// In the plane the inside is left of the edges. The front of a triangle is the side from which its corners are seen
/// counterclockwise.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Object {
    size: usize,
    corners: Vec<Vertex>,
}

impl Object {
    /// The object of these edges (`N` = 2) or triangles (`N` = 3).
    #[must_use]
    pub fn new<const N: usize>(parts: &[[Vertex; N]]) -> Object {
        Object { size: N, corners: parts.as_flattened().to_vec() }
    }

    /// The polygon of these loops.
    #[must_use]
    pub fn polygon(loops: &[Vec<Vertex>]) -> Object {
        let edges = |ring: &Vec<Vertex>| {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|(&a, &b)| [a, b]).collect::<Vec<_>>()
        };
        Object::new(&loops.iter().flat_map(edges).collect::<Vec<_>>())
    }

    /// The edges or triangles.
    pub fn parts(&self) -> std::slice::ChunksExact<'_, Vertex> {
        self.corners.chunks_exact(self.size)
    }

    /// The edge or triangle with this index.
    ///
    /// # Panics
    /// If there is no such part.
    #[must_use]
    pub fn part(&self, at: u32) -> &[Vertex] {
        let from = at as usize * self.size;
        &self.corners[from..from + self.size]
    }

    /// The number of edges or triangles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.corners.len() / self.size
    }

    /// True without edges and triangles.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// The triangles; empty in the plane.
    #[must_use]
    pub fn triangles(&self) -> Vec<[Vertex; 3]> {
        self.parts().filter_map(|part| <[Vertex; 3]>::try_from(part).ok()).collect()
    }

    /// The vertices, ascending.
    #[must_use]
    pub fn vertices(&self) -> Vec<Vertex> {
        let mut all = self.corners.clone();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// True if the object has an inside: every border of a part is used equally often in both directions.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        let mut borders: Vec<([Vertex; 2], i64)> = Vec::with_capacity(self.corners.len());
        for part in self.parts() {
            match *part {
                [a, b] => borders.extend([([a, a], 1), ([b, b], -1)]),
                _ => borders.extend(part.iter().zip(part.iter().cycle().skip(1)).map(|(&u, &v)| {
                    let direction = if u < v { 1 } else { -1 };
                    ([u.min(v), u.max(v)], direction)
                })),
            }
        }
        borders.sort_unstable();
        borders
            .chunk_by(|(one, _), (other, _)| one == other)
            .all(|uses| uses.iter().map(|(_, sum)| sum).sum::<i64>() == 0)
    }
}
