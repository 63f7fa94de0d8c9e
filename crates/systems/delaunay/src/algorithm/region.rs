//! Regions: triangles that are removed together, and the triangles that replace them.

use super::Contradiction;
use predicament_predicates::Vertex;

use super::mesh::{Edge, INFINITE, Mesh};

/// A connected set of triangles.
#[derive(Clone, Default, Debug)]
pub(super) struct Region {
    pub triangles: Vec<u32>,
    /// The edges around the region, as seen from outside, in counterclockwise order.
    pub border: Vec<Edge>,
    open: Vec<Edge>,
    corners: Vec<Vertex>,
}

impl Region {
    /// Fills the region from a triangle on, across each edge that `reaches` accepts. `reaches` gets the edge as seen
    /// from inside and from outside. All triangles of the region are marked.
    ///
    /// # Errors
    /// [`Contradiction::Disc`] if the fill reaches a marked triangle. If the region must be `ALONE`, also if a marked
    /// triangle is beside an edge of its border.
    #[inline(always)]
    pub fn fill<const ALONE: bool>(
        &mut self,
        mesh: &mut Mesh,
        first: u32,
        mut reaches: impl FnMut(&mut Mesh, Edge, Edge) -> bool,
    ) -> Result<(), Contradiction> {
        mesh.mark(first);
        self.triangles.clear();
        self.border.clear();
        self.open.clear();
        self.triangles.push(first);
        self.open.extend([2, 1, 0].map(|corner| Edge::new(first, corner)));
        while let Some(edge) = self.open.pop() {
            let outside = mesh.across(edge);
            if reaches(mesh, edge, outside) {
                if mesh.mark(outside.triangle()) {
                    return Err(Contradiction::Disc);
                }
                self.triangles.push(outside.triangle());
                self.open.push(outside.previous());
                self.open.push(outside.next());
            } else {
                // A border line that the region touches from both sides would be inside the region.
                if ALONE && mesh.is_marked(outside.triangle()) {
                    return Err(Contradiction::Disc);
                }
                self.border.push(outside);
            }
        }
        Ok(())
    }

    /// Replaces the region by triangles that join its border to a vertex; returns the last finite one.
    #[inline(always)]
    pub fn star(&mut self, mesh: &mut Mesh, v: Vertex) -> u32 {
        let mut solid = 0;
        let mut open: Option<[Edge; 2]> = None;
        for (at, &outside) in self.border.iter().enumerate() {
            let (a, b) = (mesh.end(outside), mesh.start(outside));
            let edge = match self.triangles.get(at) {
                Some(&triangle) => mesh.set(triangle, v, a, b),
                None => mesh.add(v, a, b),
            };
            mesh.join(edge, outside);
            if a != INFINITE && b != INFINITE {
                solid = edge.triangle();
            }
            // The edge from v to a is the twin of the edge from b to v of the previous triangle.
            open = match open {
                None => Some([edge.previous(), edge.next()]),
                Some([first, last]) => {
                    mesh.link(last, edge.previous());
                    Some([first, edge.next()])
                }
            };
        }
        if let Some([first, last]) = open {
            mesh.link(last, first);
        }
        solid
    }

    /// True if no vertex comes twice on the border.
    pub fn is_simple(&mut self, mesh: &Mesh) -> bool {
        self.corners.clear();
        self.corners.extend(self.border.iter().map(|&outside| mesh.end(outside)));
        self.corners.sort_unstable();
        self.corners.windows(2).all(|pair| pair[0] != pair[1])
    }

    /// Replaces the region by a fan from its vertex with the smallest index. The region has no infinite vertex.
    pub fn fan(&mut self, mesh: &mut Mesh) {
        let smallest = (0..self.border.len()).min_by_key(|&at| mesh.end(self.border[at])).unwrap_or(0);
        self.border.rotate_left(smallest);
        let Some((&first, others)) = self.border.split_first() else { return };
        let v = mesh.end(first);
        let mut open = first;
        for (&outside, &triangle) in others.iter().zip(&self.triangles) {
            let edge = mesh.set(triangle, v, mesh.end(outside), mesh.start(outside));
            mesh.join(edge, outside);
            mesh.join(edge.previous(), open);
            open = edge.next();
            mesh.set_round(open, true);
        }
        if let Some(&last) = others.last() {
            mesh.set_round(open, false);
            mesh.join(open, last);
        }
    }
}
