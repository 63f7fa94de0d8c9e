//! The answer: triangles in a form that does not depend on the order of their construction.

use std::collections::HashMap;

use predicament_predicates::{Construction, Vertex};

use super::{Contradiction, Triangulation};

/// The Delaunay triangulation of points of the plane.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Delaunay2 {
    /// The triangles, each counterclockwise from its smallest vertex on, sorted.
    pub triangles: Vec<[Vertex; 3]>,
    /// All vertices in their order by x, then by y, one for each place, if there is no triangle; else empty.
    pub chain: Vec<Vertex>,
    /// The vertices in the place of another vertex, each with the smallest vertex there; sorted.
    pub copies: Vec<[Vertex; 2]>,
    /// The edges that constraints consist of, each by its ends, the smaller first; sorted.
    pub constrained: Vec<[Vertex; 2]>,
    /// The points where constraints cross, in the order of their construction.
    pub crossings: Vec<Construction>,
    /// The invariant that did not hold, if signs contradict each other.
    pub broken: Option<Contradiction>,
}

/// The numbers of triangles, of collinear vertices, and of copies.
impl std::fmt::Display for Delaunay2 {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.chain.len() {
            0 => write!(f, "{} triangles", self.triangles.len())?,
            length => write!(f, "{length} vertices in one line")?,
        }
        if !self.copies.is_empty() {
            write!(f, ", {} copies", self.copies.len())?;
        }
        if !self.crossings.is_empty() {
            write!(f, ", {} crossings", self.crossings.len())?;
        }
        self.broken.map_or(Ok(()), |broken| write!(f, "; broken: {broken}"))
    }
}

impl Triangulation {
    /// The triangles in their canonical form.
    #[must_use]
    pub fn answer(&self) -> Delaunay2 {
        let ends = |edge| {
            let [a, b] = [self.mesh.start(edge), self.mesh.end(edge)];
            [a.min(b), a.max(b)]
        };
        let mut constrained: Vec<[Vertex; 2]> = self.mesh.constrained().map(ends).collect();
        constrained.sort_unstable();
        Delaunay2 {
            triangles: sorted(self.triangles()),
            chain: self.chain.clone(),
            copies: resolved(&self.copies),
            constrained,
            crossings: self.crossings.clone(),
            broken: self.broken,
        }
    }

    /// The triangles, each from its smallest vertex on, unsorted.
    pub fn triangles(&self) -> impl Iterator<Item = [Vertex; 3]> + '_ {
        (0..self.mesh.len()).filter_map(|triangle| {
            let [a, b, c] = self.mesh.solid(triangle)?;
            let rotated = if a < b && a < c {
                [a, b, c]
            } else if b < c {
                [b, c, a]
            } else {
                [c, a, b]
            };
            Some(rotated)
        })
    }

    /// The number of triangles.
    #[must_use]
    pub fn count(&self) -> usize {
        (0..self.mesh.len()).filter(|&triangle| self.mesh.solid(triangle).is_some()).count()
    }
}

/// Sorts triangles: by first vertices into buckets of about two triangles each.
fn sorted(triangles: impl Iterator<Item = [Vertex; 3]>) -> Vec<[Vertex; 3]> {
    let all: Vec<[Vertex; 3]> = triangles.collect();
    // (Constructed vertices have the largest indices, and are few.)
    let input = all.iter().filter(|triangle| !triangle[0].is_constructed()).map(|triangle| triangle[0].index()).max();
    let buckets = input.map_or(0, |largest| largest + 1);
    let bucket = |triangle: &[Vertex; 3]| triangle[0].index().min(buckets);
    let mut starts = vec![0_usize; buckets + 1];
    all.iter().for_each(|triangle| starts[bucket(triangle)] += 1);
    let mut sum = 0;
    for start in &mut starts {
        sum += std::mem::replace(start, sum);
    }
    let mut sorted = all.clone();
    for triangle in &all {
        let place = &mut starts[bucket(triangle)];
        sorted[*place] = *triangle;
        *place += 1;
    }
    // Each start is now the end of its bucket.
    let mut start = 0;
    for end in starts {
        sorted[start..end].sort_unstable();
        start = end;
    }
    sorted
}

/// Each copy with its final representative. A representative can become a copy later.
pub(super) fn resolved(found: &[[Vertex; 2]]) -> Vec<[Vertex; 2]> {
    let mut last: HashMap<Vertex, Vertex> = HashMap::with_capacity(found.len());
    for &[copy, of] in found.iter().rev() {
        let of = last.get(&of).copied().unwrap_or(of);
        last.insert(copy, of);
    }
    let mut copies: Vec<[Vertex; 2]> = last.into_iter().map(|(copy, of)| [copy, of]).collect();
    copies.sort_unstable();
    copies
}
