//! The laws for the answer about a loop.

use std::collections::BTreeMap;

use predicament_predicates::Vertex;
use rug::Integer;

use crate::answer::{Cover, Reason};
use crate::truth::{Areas, Around, Corners, Found, Signs, hunt, is_flat, meet};

/// A law for the answer about a loop.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Law {
    /// The triangles are a disk, its border is the loop in its direction, and its vertices are those of the loop.
    Disk,
    /// An edge inside the cover is not an edge of the mesh or of another cover.
    Edge,
    /// Each triangle has an area.
    Flat,
    /// Triangles of the cover have only vertices and edges in common, with each other and with the mesh.
    Crossing,
    /// The area is at most the least one, within the stated error.
    Least,
    /// A loop is not covered only if there is no cover.
    Uncovered,
}

/// The judgement of the answer about a loop.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Verdict {
    /// All laws hold.
    Right,
    /// All laws hold, except that the search for a better cover ended at its work limit.
    Undecided,
    /// A law does not hold.
    Wrong {
        /// The law.
        law: Law,
        /// The violation, in words.
        what: String,
        /// The triangles whose positions matter: those of the violation, or of a better cover.
        triangles: Vec<[Vertex; 3]>,
    },
}

/// A loop, and all that its judgement needs.
pub struct Asked<'a> {
    /// The judge's signs, exact or perturbed.
    pub signs: &'a Signs<'a>,
    /// The mesh, and the covers of earlier loops.
    pub surface: &'a Around,
    /// The loop.
    pub around: &'a [Vertex],
    /// Its areas; `None` if the loop passes a vertex twice.
    pub areas: Option<&'a Areas>,
}

impl Asked<'_> {
    /// Judges the answer.
    #[must_use]
    pub fn verdict(&self, cover: &Cover) -> Verdict {
        let wrong = |law: Law, what: String, triangles: Vec<[Vertex; 3]>| Verdict::Wrong { law, what, triangles };
        let (triangles, areas) = match (cover, self.areas) {
            (Cover::Uncovered(Reason::Repeats), None) => return Verdict::Right,
            (Cover::Uncovered(Reason::Repeats), Some(_)) => {
                return wrong(Law::Uncovered, "the loop passes each vertex once".to_owned(), Vec::new());
            }
            (_, None) => return wrong(Law::Uncovered, "the loop passes a vertex twice".to_owned(), Vec::new()),
            (Cover::Uncovered(_), Some(areas)) => {
                return match hunt(self.signs, self.surface, self.around, areas, None) {
                    Found::Cover(all) => {
                        let what = format!("there is a cover: {}", Cover::Triangles(all.clone()));
                        wrong(Law::Uncovered, what, all)
                    }
                    Found::Nothing => Verdict::Right,
                    Found::Undecided => Verdict::Undecided,
                };
            }
            (Cover::Triangles(triangles), Some(areas)) => (triangles, areas),
        };
        let places = match disk(self.around, triangles) {
            Ok(places) => places,
            Err(what) => return wrong(Law::Disk, what, Vec::new()),
        };
        if let Some((law, what, triangles)) = self.flaw(&places, triangles) {
            return wrong(law, what, triangles);
        }
        let area: Integer = places.iter().map(|&corners| areas.twice(corners)).sum();
        match hunt(self.signs, self.surface, self.around, areas, Some(area - areas.slack())) {
            Found::Cover(all) => {
                let what = format!("a cover has less area: {}", Cover::Triangles(all.clone()));
                wrong(Law::Least, what, all)
            }
            Found::Nothing => Verdict::Right,
            Found::Undecided => Verdict::Undecided,
        }
    }

    /// The first violation of a law about edges, areas and crossings.
    fn flaw(&self, places: &[Corners], triangles: &[[Vertex; 3]]) -> Option<(Law, String, Vec<[Vertex; 3]>)> {
        let n = self.around.len();
        for &[a, b, c] in places {
            for [from, to] in [[a, b], [b, c], [a, c]] {
                let ends = [self.around[from], self.around[to]];
                if (2..n - 1).contains(&(to - from)) && self.surface.has_edge(ends) {
                    let what = format!("the edge {} {} has other triangles", ends[0], ends[1]);
                    return Some((Law::Edge, what, Vec::new()));
                }
            }
        }
        let told = |[a, b, c]: [Vertex; 3]| format!("{a} {b} {c}");
        if let Some(&flat) = triangles.iter().find(|&&corners| is_flat(self.signs, corners)) {
            return Some((Law::Flat, format!("{} has no area", told(flat)), vec![flat]));
        }
        for (at, &first) in triangles.iter().enumerate() {
            let among = triangles[at + 1..].iter().copied().find(|&second| meet(self.signs, first, second));
            if let Some(second) = among.or_else(|| self.surface.met(self.signs, first)) {
                let what = format!("{} and {} meet", told(first), told(second));
                return Some((Law::Crossing, what, vec![first, second]));
            }
        }
        None
    }
}

/// The places on the loop of the corners of each triangle, if the triangles are a disk whose border is the loop.
///
/// The triangles of a disk with all its vertices on its border are a triangulation of a polygon. So the edge from the
/// first point to the last has one triangle, and the edges of this triangle divide the rest into two smaller polygons.
///
/// # Errors
/// The violation, in words.
pub fn disk(around: &[Vertex], triangles: &[[Vertex; 3]]) -> Result<Vec<Corners>, String> {
    let place: BTreeMap<Vertex, usize> = around.iter().enumerate().map(|(at, &v)| (v, at)).collect();
    // For each edge from place i to place k, the apexes of its triangles between these places.
    let mut apexes: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
    let mut places = Vec::with_capacity(triangles.len());
    for &[a, b, c] in triangles {
        let [Some(&i), Some(&j), Some(&k)] = [a, b, c].map(|v| place.get(&v)) else {
            return Err(format!("{a} {b} {c} has a vertex that is not of the loop"));
        };
        let mut corners = [i, j, k];
        while corners[0] > corners[1] || corners[0] > corners[2] {
            corners.rotate_left(1);
        }
        let [i, j, k] = corners;
        if !(i < j && j < k) {
            return Err(format!("{a} {b} {c} runs against the loop"));
        }
        apexes.entry([i, k]).or_default().push(j);
        places.push(corners);
    }
    let (mut open, mut used) = (vec![[0, around.len() - 1]], 0);
    while let Some([i, k]) = open.pop() {
        if k - i > 1 {
            let Some(&[j]) = apexes.get(&[i, k]).map(Vec::as_slice) else {
                return Err(format!("the edge {} {} does not have one triangle", around[i], around[k]));
            };
            used += 1;
            open.extend([[i, j], [j, k]]);
        }
    }
    if used < triangles.len() {
        return Err(format!("{} triangles are not of the disk", triangles.len() - used));
    }
    Ok(places)
}
