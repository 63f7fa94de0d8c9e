//! Ear clipping on a half-edge mesh; auxiliary edges join holes to their surroundings.
//!
//! An ear is a convex corner with no other vertex in its closed triangle. Only corners that are not convex need a test:
//! if the triangle holds any vertex, it also holds a corner that is not convex. A corner that is not an ear waits for
//! the corner that blocks it.

use std::collections::VecDeque;

use predicament_mesh::half_edge::{Face, HalfEdge, HalfEdgeMesh, IndexedFaces, MeshVertex};
use predicament_predicates::{Predicates, Sign, Vertex};

use super::corners::{Corners, ranks};
use super::reflex::Reflex;
use super::sweep::{self, Bridge};
use super::view::View;
use super::{Contradiction, NONE, Output, number};

/// A walk: a cycle of linked corners along the boundary of the inside.
struct Walk {
    corners: Vec<u32>,
    /// For a hole: the corner at which the walk divides the inside in the sweep.
    split: Option<u32>,
}

/// Triangulates the region that the walks bound.
pub(super) fn triangulate<P: Predicates + ?Sized>(view: &View<'_, P>, corners: &Corners, out: &mut Output) {
    let mut walks = walks(corners, out);
    let bridges = if walks.len() > 1 { sweep::bridges(view, corners, out) } else { Vec::new() };
    let mut sees = vec![false; corners.vertex.len()];
    for bridge in &bridges {
        sees[bridge.split as usize] = true;
    }
    for walk in &mut walks {
        let first = walk.corners.iter().map(|&corner| corners.rank[corner as usize]).min();
        let is_first = |corner: &u32| Some(corners.rank[*corner as usize]) == first && sees[*corner as usize];
        walk.split = walk.corners.iter().copied().find(is_first);
    }
    let Some(mut joined) = Joined::new(corners, &walks) else {
        out.broken(Contradiction::Mesh);
        return;
    };
    for bridge in &bridges {
        if walks.iter().any(|walk| walk.split == Some(bridge.split)) {
            joined.join(corners, bridge, out);
        }
    }
    let across = ranks(&view.across(), &corners.vertex);
    for (walk, &face) in walks.iter().zip(&joined.faces.clone()) {
        if walk.split.is_none() {
            Ears::new(view, corners, &across, &mut joined, face).clip(out);
        }
    }
}

fn walks(corners: &Corners, out: &mut Output) -> Vec<Walk> {
    let mut seen = vec![false; corners.vertex.len()];
    let mut walks = Vec::new();
    for first in 0..number(corners.vertex.len()) {
        let mut walk = Vec::new();
        let mut at = first;
        while corners.is_linked(at) && !std::mem::replace(&mut seen[at as usize], true) {
            walk.push(at);
            at = corners.next[at as usize];
        }
        match walk.len() {
            0 => {}
            1 | 2 => out.broken(Contradiction::Walk),
            _ => walks.push(Walk { corners: walk, split: None }),
        }
    }
    walks
}

/// All walks as one mesh; each corner is a mesh vertex.
struct Joined {
    mesh: HalfEdgeMesh,
    /// The mesh face of each walk: the region inside an outer walk, or the region inside a hole.
    faces: Vec<Face>,
    /// The mesh vertex of each corner.
    at: Vec<Option<MeshVertex>>,
    /// The corner of each mesh vertex.
    corner_of: Vec<u32>,
}

impl Joined {
    fn new(corners: &Corners, walks: &[Walk]) -> Option<Self> {
        let corner_of: Vec<u32> = walks.iter().flat_map(|walk| &walk.corners).copied().collect();
        let mut faces = IndexedFaces::default();
        let mut start = 0;
        for walk in walks {
            let end = start + number(walk.corners.len());
            // The inside of a hole lies on the other side; then the boundary of the mesh is the hole's walk.
            match walk.split {
                None => faces.push(start..end),
                Some(_) => faces.push((start..end).rev()),
            }
            start = end;
        }
        let vertices = corner_of.iter().map(|&corner| corners.vertex[corner as usize]).collect();
        let mesh = HalfEdgeMesh::new(vertices, &faces).ok()?;
        let mut at = vec![None; corners.vertex.len()];
        for (v, &corner) in mesh.vertices().zip(&corner_of) {
            at[corner as usize] = Some(v);
        }
        Some(Joined { faces: mesh.faces().collect(), mesh, at, corner_of })
    }

    /// Joins a hole to the region around it with an auxiliary edge.
    fn join(&mut self, corners: &Corners, bridge: &Bridge, out: &mut Output) {
        let half_edges = self.at[bridge.split as usize].and_then(|v| {
            let hole = self.mesh.ring(v).find(|&h| self.mesh.is_boundary(h))?;
            Some((self.sector(corners, bridge)?, hole))
        });
        let joined = half_edges.is_some_and(|(inside, hole)| self.mesh.insert_auxiliary_edge(inside, hole).is_ok());
        if !joined {
            out.broken(Contradiction::Hole);
        }
    }

    /// The half-edge that ends at the corner that a bridge comes from, in the sector in which the bridge leaves.
    ///
    /// The corner's edges bound its sector, counterclockwise from the edge that leaves. Earlier bridges divide the
    /// sector. At most one bridge goes to the right above the corner, and one below; a bridge to the left is between
    /// them. So the sector of a bridge above begins at the edge that leaves, and the sector of a bridge below ends at
    /// the edge that arrives. No sign is asked: a hole may touch either edge.
    fn sector(&self, corners: &Corners, bridge: &Bridge) -> Option<HalfEdge> {
        let [r, before, after] =
            [bridge.seen, corners.previous[bridge.seen as usize], corners.next[bridge.seen as usize]]
                .map(|corner| self.at[corner as usize]);
        let (before, after) = (before?, after?);
        self.mesh.ring(r?).find(|&h| match bridge.is_above {
            true => self.mesh.end(self.mesh.next(h)) == after,
            false => self.mesh.start(h) == before,
        })
    }
}

/// A face during ear clipping.
struct Ears<'a, 'b, P: ?Sized> {
    view: &'a View<'a, P>,
    mesh: &'b mut HalfEdgeMesh,
    /// The half-edge of the face that ends at each corner.
    half_edge: Vec<HalfEdge>,
    vertex: Vec<Vertex>,
    /// The ranks along both axes.
    ranks: Vec<[u32; 2]>,
    next: Vec<u32>,
    previous: Vec<u32>,
    /// The corners that are not convex; once convex, a corner counts as convex.
    is_reflex: Vec<bool>,
    reflex: Reflex,
    /// Candidate ears.
    queue: VecDeque<u32>,
    is_queued: Vec<bool>,
    /// For each corner, the last corner that waits for it, as an index into `waits`.
    waiting: Vec<u32>,
    /// A waiting corner, and the index of another corner that waits for the same blocker.
    waits: Vec<[u32; 2]>,
    left: usize,
}

impl<'a, 'b, P: Predicates + ?Sized> Ears<'a, 'b, P> {
    fn new(view: &'a View<'a, P>, corners: &Corners, across: &[u32], joined: &'b mut Joined, face: Face) -> Self {
        let mesh = &mut joined.mesh;
        let half_edge: Vec<HalfEdge> = mesh.loop_of(mesh.half_edge_of_face(face)).collect();
        let corner = |&h: &HalfEdge| joined.corner_of[mesh.end(h).index()] as usize;
        let vertex: Vec<Vertex> = half_edge.iter().map(|h| corners.vertex[corner(h)]).collect();
        let ranks = half_edge.iter().map(|h| [corners.rank[corner(h)], across[corner(h)]]).collect();
        let left = half_edge.len();
        let end = number(left);
        Ears {
            view,
            mesh,
            half_edge,
            vertex,
            ranks,
            next: (1..end).chain([0]).collect(),
            previous: [end.wrapping_sub(1)].into_iter().chain(0..end).take(left).collect(),
            is_reflex: vec![false; left],
            reflex: Reflex::new(&[]),
            queue: VecDeque::new(),
            is_queued: vec![false; left],
            waiting: vec![NONE; left],
            waits: Vec::new(),
            left,
        }
    }

    fn around(&self, corner: u32) -> [u32; 3] {
        [self.previous[corner as usize], corner, self.next[corner as usize]]
    }

    fn turn(&self, corners: [u32; 3]) -> Sign {
        let [a, b, c] = corners.map(|corner| self.vertex[corner as usize]);
        self.view.turn(a, b, c)
    }

    fn clip(&mut self, out: &mut Output) {
        for corner in 0..number(self.left) {
            self.is_reflex[corner as usize] = self.turn(self.around(corner)) != Sign::Positive;
            if !self.is_reflex[corner as usize] {
                self.enqueue(corner);
            }
        }
        let reflex = (0..).zip(&self.ranks).zip(&self.is_reflex).filter(|(_, is_reflex)| **is_reflex);
        self.reflex = Reflex::new(&reflex.map(|((corner, &ranks), _)| (corner, ranks)).collect::<Vec<_>>());
        let mut at = 0;
        while self.left > 3 {
            let Some(corner) = self.queue.pop_front() else {
                match self.without_ears(at, out) {
                    Some(next) => at = next,
                    None => return,
                }
                continue;
            };
            self.is_queued[corner as usize] = false;
            if self.next[corner as usize] == NONE {
                continue;
            }
            match self.blocker(corner) {
                Some(blocker) => {
                    self.waits.push([corner, self.waiting[blocker as usize]]);
                    self.waiting[blocker as usize] = number(self.waits.len() - 1);
                }
                None => {
                    at = self.previous[corner as usize];
                    if !self.cut(corner, out) {
                        out.broken(Contradiction::Side);
                        return;
                    }
                }
            }
        }
        let last = (0..).zip(&self.next).find(|(_, next)| **next != NONE).map(|(corner, _)| corner);
        if let Some(corner) = last.filter(|_| self.left == 3) {
            out.triangle(self.around(corner).map(|corner| self.vertex[corner as usize]));
        }
    }

    fn enqueue(&mut self, corner: u32) {
        if !std::mem::replace(&mut self.is_queued[corner as usize], true) {
            self.queue.push_back(corner);
        }
    }

    /// A corner that is not convex and lies in the closed triangle of a corner and its neighbours, at a position
    /// different from theirs.
    fn blocker(&mut self, corner: u32) -> Option<u32> {
        let ear = self.around(corner);
        let [a, b, c] = ear.map(|corner| self.vertex[corner as usize]);
        let at = ear.map(|corner| self.ranks[corner as usize]);
        let range = |axis: usize| {
            let along = at.map(|ranks| ranks[axis]);
            [along.into_iter().min().unwrap_or(0), along.into_iter().max().unwrap_or(0)]
        };
        let ranges = [range(0), range(1)];
        let is_reflex = &self.is_reflex;
        let (ranks, vertex, view) = (&self.ranks, &self.vertex, self.view);
        self.reflex.find(ranges, |other| {
            if !is_reflex[other as usize] {
                return None;
            }
            let [x, y] = ranks[other as usize];
            let [[left, right], [bottom, top]] = ranges;
            let is_near = (left..=right).contains(&x) && (bottom..=top).contains(&y);
            let is_inside = is_near && at.iter().all(|&[rank, _]| rank != x) && {
                let v = vertex[other as usize];
                let is_left = |p: Vertex, q: Vertex| view.turn(p, q, v) != Sign::Negative;
                !(v == a || v == b || v == c) && is_left(c, a) && is_left(a, b) && is_left(b, c)
            };
            Some(is_inside)
        })
    }

    /// Cuts a corner off; returns true if the mesh accepts the cut.
    fn cut(&mut self, corner: u32, out: &mut Output) -> bool {
        let [a, b, c] = self.around(corner);
        let Ok(rest) = self.mesh.cut_ear(self.half_edge[a as usize]) else { return false };
        self.half_edge[c as usize] = rest;
        out.triangle([a, b, c].map(|corner| self.vertex[corner as usize]));
        self.next[a as usize] = c;
        self.previous[c as usize] = a;
        self.next[b as usize] = NONE;
        self.left -= 1;
        self.release(b);
        for neighbour in [a, c] {
            if self.turn(self.around(neighbour)) == Sign::Positive {
                self.release(neighbour);
                self.enqueue(neighbour);
            }
        }
        true
    }

    /// Marks a corner that no longer blocks anything, and enqueues the corners that wait for it.
    fn release(&mut self, corner: u32) {
        if std::mem::take(&mut self.is_reflex[corner as usize]) {
            let mut at = std::mem::replace(&mut self.waiting[corner as usize], NONE);
            while at != NONE {
                let [waiting, next] = self.waits[at as usize];
                self.enqueue(waiting);
                at = next;
            }
        }
    }

    /// Cuts some corner where no corner is an ear, and returns a corner near it; `near` is a corner that is left. If a
    /// vertex is on an edge, this cuts a triangle without area; otherwise signs are wrong, and any corner will do.
    /// Returns `None` if the mesh accepts no cut.
    fn without_ears(&mut self, near: u32, out: &mut Output) -> Option<u32> {
        let mut all = Vec::with_capacity(self.left);
        let mut at = near;
        for _ in 0..self.left {
            all.push(at);
            at = self.next[at as usize];
        }
        let rank = |corner: u32| self.ranks[corner as usize][0];
        let is_spike = |&corner: &u32| {
            let [a, b, c] = self.around(corner).map(rank);
            (a < b) == (c < b)
        };
        let flat: Vec<u32> = all.iter().copied().filter(|&corner| self.turn(self.around(corner)).is_zero()).collect();
        let spike = flat.iter().copied().find(is_spike);
        let convex = all.iter().copied().find(|&corner| !self.is_reflex[corner as usize]);
        if flat.is_empty() {
            out.broken(Contradiction::Ear);
        }
        let candidates = spike.into_iter().chain(flat).chain(convex).chain(all);
        for corner in candidates {
            if self.cut(corner, out) {
                return Some(self.previous[corner as usize]);
            }
        }
        out.broken(Contradiction::Side);
        None
    }
}
