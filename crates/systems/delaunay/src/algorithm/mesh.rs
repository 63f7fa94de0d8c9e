//! Triangles with their neighbours, around an infinite vertex.
//!
//! Beside each edge of the hull is a triangle with the infinite vertex as its last corner. So every edge has two
//! triangles, and a vertex outside of the hull is in one of the infinite triangles. A triangle takes 32 bytes, half a
//! cache line.

use predicament_predicates::Vertex;

/// The infinite vertex: a triangle with it is beyond an edge of the hull.
pub(super) const INFINITE: Vertex = Vertex::constructed(Vertex::MAX_CONSTRUCTED - 1);

/// The flag of the edge opposite of the first corner if its four vertices are on one circle; the next two bits are for
/// the other edges.
const ROUND: u32 = 1;
/// The flag of the edge opposite of the first corner if it is part of a constraint; the next two bits are for the other
/// edges.
const CONSTRAINED: u32 = 1 << 3;

/// An edge of a triangle, given by the triangle and the opposite corner; it goes counterclockwise.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Edge(u32);

impl Edge {
    #[inline(always)]
    pub fn new(triangle: u32, corner: u32) -> Edge {
        Edge(triangle << 2 | corner)
    }

    #[inline(always)]
    pub fn triangle(self) -> u32 {
        self.0 >> 2
    }

    #[inline(always)]
    pub fn corner(self) -> u32 {
        self.0 & 3
    }

    /// The edge of the same triangle that begins at the end of this one.
    #[inline(always)]
    pub fn next(self) -> Edge {
        Edge::new(self.triangle(), after(self.corner()))
    }

    /// The edge of the same triangle that ends at the start of this one.
    #[inline(always)]
    pub fn previous(self) -> Edge {
        self.next().next()
    }
}

/// The corner after this one.
#[inline(always)]
fn after(corner: u32) -> u32 {
    if corner == 2 { 0 } else { corner + 1 }
}

/// A triangle.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
struct Triangle {
    /// The corners counterclockwise; an infinite vertex is the last.
    corners: [Vertex; 3],
    /// The edge of the neighbour, opposite of each corner.
    across: [Edge; 3],
    flags: u32,
    /// The last mark of the triangle.
    mark: u32,
}

/// A triangulation of the sphere: the plane and an infinite vertex.
#[derive(Clone, Default, Debug)]
pub(super) struct Mesh {
    triangles: Vec<Triangle>,
    /// Removed triangles.
    free: Vec<u32>,
    /// The current mark.
    mark: u32,
}

impl Mesh {
    pub fn with_capacity(triangles: usize) -> Mesh {
        Mesh { triangles: Vec::with_capacity(triangles), ..Mesh::default() }
    }

    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// The number of triangle indices, including free ones.
    pub fn len(&self) -> u32 {
        u32::try_from(self.triangles.len()).unwrap_or(u32::MAX)
    }

    pub fn clear(&mut self) {
        self.triangles.clear();
        self.free.clear();
    }

    #[inline(always)]
    pub fn corners(&self, triangle: u32) -> [Vertex; 3] {
        self.triangles[triangle as usize].corners
    }

    /// The corners of a finite triangle; `None` for infinite and free ones.
    #[inline(always)]
    pub fn solid(&self, triangle: u32) -> Option<[Vertex; 3]> {
        let corners = self.corners(triangle);
        (corners[2] != INFINITE).then_some(corners)
    }

    /// True if the triangle has the infinite vertex, or is free.
    #[inline(always)]
    pub fn is_infinite(&self, triangle: u32) -> bool {
        self.corners(triangle)[2] == INFINITE
    }

    #[inline(always)]
    pub fn across(&self, edge: Edge) -> Edge {
        self.triangles[edge.triangle() as usize].across[edge.corner() as usize]
    }

    #[inline(always)]
    pub fn start(&self, edge: Edge) -> Vertex {
        self.corners(edge.triangle())[after(edge.corner()) as usize]
    }

    #[inline(always)]
    pub fn end(&self, edge: Edge) -> Vertex {
        self.corners(edge.triangle())[after(after(edge.corner())) as usize]
    }

    /// The vertex opposite of an edge.
    #[inline(always)]
    pub fn apex(&self, edge: Edge) -> Vertex {
        self.corners(edge.triangle())[edge.corner() as usize]
    }

    /// Links two edges as the two sides of one line.
    #[inline(always)]
    pub fn link(&mut self, a: Edge, b: Edge) {
        self.triangles[a.triangle() as usize].across[a.corner() as usize] = b;
        self.triangles[b.triangle() as usize].across[b.corner() as usize] = a;
    }

    /// Links an edge of a new triangle to an edge that is kept; the new edge takes over the flags.
    #[inline(always)]
    pub fn join(&mut self, new: Edge, kept: Edge) {
        let other = &mut self.triangles[kept.triangle() as usize];
        other.across[kept.corner() as usize] = new;
        let flags = other.flags >> kept.corner() & (CONSTRAINED | ROUND);
        let own = &mut self.triangles[new.triangle() as usize];
        own.across[new.corner() as usize] = kept;
        own.flags |= flags << new.corner();
    }

    /// Adds a triangle without neighbours; returns its edge opposite of the first of these vertices.
    #[inline(always)]
    pub fn add(&mut self, a: Vertex, b: Vertex, c: Vertex) -> Edge {
        let triangle = self.free.pop().unwrap_or_else(|| {
            let none = Triangle { corners: [INFINITE; 3], across: [Edge(0); 3], flags: 0, mark: 0 };
            self.triangles.push(none);
            self.len() - 1
        });
        self.set(triangle, a, b, c)
    }

    /// Sets a triangle's corners and clears its flags; returns its edge opposite of the first of these vertices.
    #[inline(always)]
    pub fn set(&mut self, triangle: u32, a: Vertex, b: Vertex, c: Vertex) -> Edge {
        let (corners, corner) = if b == INFINITE {
            ([c, a, b], 1)
        } else if a == INFINITE {
            ([b, c, a], 2)
        } else {
            ([a, b, c], 0)
        };
        let at = &mut self.triangles[triangle as usize];
        at.corners = corners;
        at.flags = 0;
        Edge::new(triangle, corner)
    }

    /// Appends the triangles of another triangulation; returns the number to add to their indices.
    pub fn append(&mut self, other: Mesh) -> u32 {
        let offset = self.len();
        self.triangles.extend(other.triangles.into_iter().map(|mut triangle| {
            triangle.across = triangle.across.map(|edge| Edge(edge.0 + (offset << 2)));
            triangle
        }));
        self.free.extend(other.free.into_iter().map(|triangle| triangle + offset));
        self.mark = self.mark.max(other.mark);
        offset
    }

    /// Replaces the edge of two finite triangles by the other diagonal; returns the four edges around both triangles.
    pub fn flip(&mut self, edge: Edge) -> [Edge; 4] {
        let outside = self.across(edge);
        let [(a, b), (d, c)] = [edge, outside].map(|edge| (self.apex(edge), self.start(edge)));
        // From a to b, to d, to c, and back to a.
        let around = [edge.previous(), outside.next(), outside.previous(), edge.next()].map(|edge| self.across(edge));
        let [one, other] = [self.set(edge.triangle(), a, b, d), self.set(outside.triangle(), a, d, c)];
        self.link(one.next(), other.previous());
        self.join(one.previous(), around[0]);
        self.join(one, around[1]);
        self.join(other, around[2]);
        self.join(other.next(), around[3]);
        around
    }

    /// Frees a triangle.
    pub fn free(&mut self, triangle: u32) {
        self.triangles[triangle as usize].corners = [INFINITE; 3];
        self.triangles[triangle as usize].flags = 0;
        self.free.push(triangle);
    }

    /// Removes the marks of all triangles.
    #[inline(always)]
    pub fn unmark(&mut self) {
        self.mark += 1;
    }

    /// Marks a triangle; returns true if it was marked already.
    #[inline(always)]
    pub fn mark(&mut self, triangle: u32) -> bool {
        std::mem::replace(&mut self.triangles[triangle as usize].mark, self.mark) == self.mark
    }

    /// True if a triangle is marked.
    #[inline(always)]
    pub fn is_marked(&self, triangle: u32) -> bool {
        self.triangles[triangle as usize].mark == self.mark
    }

    /// True if an edge is part of a constraint.
    #[inline(always)]
    pub fn is_constrained(&self, edge: Edge) -> bool {
        self.triangles[edge.triangle() as usize].flags & CONSTRAINED << edge.corner() != 0
    }

    /// Flags both sides of an edge as part of a constraint.
    pub fn constrain(&mut self, edge: Edge) {
        for edge in [edge, self.across(edge)] {
            self.triangles[edge.triangle() as usize].flags |= CONSTRAINED << edge.corner();
        }
    }

    /// The edges that are part of constraints, each once.
    pub fn constrained(&self) -> impl Iterator<Item = Edge> + '_ {
        let edges = (0..self.len()).flat_map(|triangle| [0, 1, 2].map(|corner| Edge::new(triangle, corner)));
        edges.filter(|&edge| self.is_constrained(edge) && edge < self.across(edge))
    }

    /// True if the four vertices at an edge were found to be cocircular.
    #[inline(always)]
    pub fn is_round(&self, edge: Edge) -> bool {
        self.triangles[edge.triangle() as usize].flags & ROUND << edge.corner() != 0
    }

    /// Sets, on one side of an edge, whether its four vertices are cocircular.
    #[inline(always)]
    pub fn set_round(&mut self, edge: Edge, is_round: bool) {
        let flags = &mut self.triangles[edge.triangle() as usize].flags;
        let flag = ROUND << edge.corner();
        if (*flags & flag != 0) != is_round {
            *flags ^= flag;
        }
    }

    /// True if an edge of the triangle is round.
    #[inline]
    pub fn has_round(&self, triangle: u32) -> bool {
        self.triangles[triangle as usize].flags & (7 * ROUND) != 0
    }

    /// The edge opposite of a vertex in a triangle that has it.
    pub fn opposite(&self, triangle: u32, v: Vertex) -> Option<Edge> {
        let corner = self.corners(triangle).iter().position(|&corner| corner == v)?;
        Some(Edge::new(triangle, u32::try_from(corner).unwrap_or(0)))
    }

    /// The edges opposite of a vertex, counterclockwise, from one of them on.
    pub fn around(&self, opposite: Edge) -> impl Iterator<Item = Edge> + '_ {
        // The number of triangles bounds the steps, whatever the links are.
        let turn = move |&edge: &Edge| {
            let next = self.across(edge.next()).next();
            (next != opposite).then_some(next)
        };
        std::iter::successors(Some(opposite), turn).take(self.triangles.len())
    }

    /// Renames a vertex.
    pub fn rename(&mut self, opposite: Edge, name: Vertex) {
        let star: Vec<Edge> = self.around(opposite).collect();
        for edge in star {
            self.triangles[edge.triangle() as usize].corners[edge.corner() as usize] = name;
        }
    }
}
