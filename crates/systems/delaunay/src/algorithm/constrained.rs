//! Constraints: segments between vertices that have to be edges, or chains of edges.
//!
//! The triangles that a segment crosses are replaced. On each side of the segment, the polygon of vertices is
//! triangulated anew; each triangle takes the vertex whose circle contains no other vertex of the polygon. If the
//! segment passes through a vertex, it continues from there. If it crosses an edge of another constraint, the crossing
//! point is constructed and inserted, and both constraints pass through it. In the end, every edge that is not part of
//! a constraint is Delaunay: the circles of its triangles contain no vertex visible across it.
//!
//! All ends are vertices, so a constraint never leaves the hull. A constraint whose ends are in one place has no
//! length, and adds no edge. Constraints that overlap share edges.

use std::collections::HashMap;

use predicament_predicates::{Construction, Plane, PredicateKind, Predicates, Refused, Sign, Vertex};

use super::chain::is_between;
use super::hole::Side;
use super::mesh::{Edge, INFINITE};
use super::{Contradiction, Triangulation};

/// The constrained Delaunay triangulation of the scene's input vertices.
///
/// # Errors
/// [`Refused`] if constraints cross, and the session does not construct the crossing or does not answer incircle
/// queries about it.
pub fn constrained_delaunay2d<P: Predicates + ?Sized>(
    session: &mut P,
    constraints: &[[Vertex; 2]],
) -> Result<Triangulation, Refused> {
    let mut triangulation = super::delaunay2d(&*session);
    if triangulation.mesh.is_empty() || triangulation.broken.is_some() {
        return Ok(triangulation);
    }
    let stands: HashMap<Vertex, Vertex> =
        super::answer::resolved(&triangulation.copies).into_iter().map(|[copy, of]| (copy, of)).collect();
    let inputs = session.scene().len();
    let mut laying = Laying { triangulation: &mut triangulation, inputs, at: vec![NONE; inputs], of: HashMap::new() };
    laying.note((0..laying.triangulation.mesh.len()).collect());
    for (number, constraint) in constraints.iter().enumerate() {
        let ends = constraint.map(|v| stands.get(&v).copied().unwrap_or(v));
        if let Err(broken) = laying.lay(session, constraints, number, ends)? {
            laying.triangulation.broken = Some(broken);
            break;
        }
    }
    triangulation.cut_faces();
    Ok(triangulation)
}

/// The mark of a vertex without a triangle.
const NONE: u32 = u32::MAX;

/// The state of laying constraints into a triangulation.
struct Laying<'a> {
    triangulation: &'a mut Triangulation,
    inputs: usize,
    /// A triangle of each vertex, input vertices first.
    at: Vec<u32>,
    /// The first constraint of each edge that is part of one, by its ends, the smaller first.
    of: HashMap<[Vertex; 2], usize>,
}

/// The first vertex or edge that a segment meets.
enum First {
    /// A vertex, at the end of this edge.
    Vertex(Edge, Vertex),
    /// An edge.
    Edge(Edge),
}

/// The triangles that a segment crosses.
enum Crossed {
    /// All triangles up to this vertex, with the edges on the right from the first one on, and those on the left from
    /// the last one on.
    UpTo(Vertex, [Vec<(Vertex, Edge)>; 2], Vec<u32>),
    /// The triangles up to this edge of another constraint.
    Constraint(Edge),
}

fn key(a: Vertex, b: Vertex) -> [Vertex; 2] {
    [a.min(b), a.max(b)]
}

impl Laying<'_> {
    fn place(&self, v: Vertex) -> usize {
        v.construction().map_or(v.index(), |index| self.inputs + index)
    }

    /// Records a triangle for each corner of these triangles.
    fn note(&mut self, triangles: Vec<u32>) {
        for triangle in triangles {
            for v in self.triangulation.mesh.corners(triangle) {
                if v != INFINITE {
                    let place = self.place(v);
                    if place >= self.at.len() {
                        self.at.resize(place + 1, NONE);
                    }
                    self.at[place] = triangle;
                }
            }
        }
    }

    /// Lays one constraint; the inner error is an invariant that does not hold.
    fn lay<P: Predicates + ?Sized>(
        &mut self,
        session: &mut P,
        constraints: &[[Vertex; 2]],
        number: usize,
        [a, b]: [Vertex; 2],
    ) -> Result<Result<(), Contradiction>, Refused> {
        let mut open = if a == b { Vec::new() } else { vec![[a, b]] };
        // A constraint passes each vertex at most once, and crosses each constraint at most once.
        for _ in 0..2 * (self.at.len() + constraints.len()) {
            let Some([u, w]) = open.pop() else { return Ok(Ok(())) };
            let first = match self.first(&*session, u, w) {
                Ok(first) => first,
                Err(broken) => return Ok(Err(broken)),
            };
            let v = match first {
                First::Vertex(edge, v) => {
                    self.triangulation.mesh.constrain(edge);
                    self.of.entry(key(u, v)).or_insert(number);
                    v
                }
                First::Edge(edge) => match self.crossed(&*session, u, w, edge) {
                    Ok(Crossed::UpTo(v, sides, triangles)) => {
                        self.replace(&*session, [u, v], edge, sides, &triangles);
                        self.of.insert(key(u, v), number);
                        if let Some(broken) = self.triangulation.broken {
                            return Ok(Err(broken));
                        }
                        v
                    }
                    Ok(Crossed::Constraint(edge)) => match self.cross(session, constraints, number, edge)? {
                        Ok(v) => {
                            open.extend([[v, w], [u, v]]);
                            continue;
                        }
                        Err(broken) => return Ok(Err(broken)),
                    },
                    Err(broken) => return Ok(Err(broken)),
                },
            };
            if v != w {
                open.push([v, w]);
            }
        }
        Ok(if open.is_empty() { Ok(()) } else { Err(Contradiction::Leaves) })
    }

    /// The first vertex or edge that the segment from u to w meets.
    fn first<P: Predicates + ?Sized>(&self, session: &P, u: Vertex, w: Vertex) -> Result<First, Contradiction> {
        let mesh = &self.triangulation.mesh;
        let triangle =
            self.at.get(self.place(u)).copied().filter(|&triangle| triangle != NONE).ok_or(Contradiction::Leaves)?;
        let opposite = mesh.opposite(triangle, u).ok_or(Contradiction::Leaves)?;
        let star: Vec<Edge> = mesh.around(opposite).collect();
        if let Some(edge) = star.iter().find(|&&edge| mesh.start(edge) == w) {
            return Ok(First::Vertex(edge.previous(), w));
        }
        let side = |v: Vertex| if v == INFINITE { None } else { Some(session.orient2d(Plane::Xy, u, w, v)) };
        let sides: Vec<Option<Sign>> = star.iter().map(|&edge| side(mesh.start(edge))).collect();
        for (at, &edge) in star.iter().enumerate() {
            let (here, next) = (sides[at], sides[(at + 1) % sides.len()]);
            let v = mesh.start(edge);
            if here == Some(Sign::Zero) && is_between(session, u, w, v) {
                return Ok(First::Vertex(edge.previous(), v));
            }
            if here == Some(Sign::Negative) && next == Some(Sign::Positive) {
                return Ok(First::Edge(edge));
            }
        }
        Err(Contradiction::Leaves)
    }

    /// The triangles that the segment from u to w crosses, from an edge on.
    fn crossed<P: Predicates + ?Sized>(
        &mut self,
        session: &P,
        u: Vertex,
        w: Vertex,
        first: Edge,
    ) -> Result<Crossed, Contradiction> {
        let mesh = &mut self.triangulation.mesh;
        mesh.unmark();
        mesh.mark(first.triangle());
        let mut triangles = vec![first.triangle()];
        let (mut right, mut left) = (vec![(u, first.previous())], vec![(mesh.end(first), first.next())]);
        let mut edge = first;
        loop {
            if mesh.is_constrained(edge) {
                return Ok(Crossed::Constraint(edge));
            }
            let outside = mesh.across(edge);
            if mesh.is_infinite(outside.triangle()) || mesh.mark(outside.triangle()) {
                return Err(Contradiction::Crosses);
            }
            triangles.push(outside.triangle());
            let v = mesh.apex(outside);
            let side = if v == w { Sign::Zero } else { session.orient2d(Plane::Xy, u, w, v) };
            if side != Sign::Positive {
                right.push((mesh.start(outside.next()), outside.next()));
            }
            if side != Sign::Negative {
                left.push((v, outside.previous()));
            }
            edge = match side {
                Sign::Positive => outside.next(),
                Sign::Negative => outside.previous(),
                Sign::Zero => {
                    left.reverse();
                    return Ok(Crossed::UpTo(v, [right, left], triangles));
                }
            };
        }
    }

    /// Replaces crossed triangles by triangles on both sides of an edge.
    fn replace<P: Predicates + ?Sized>(
        &mut self,
        session: &P,
        [u, v]: [Vertex; 2],
        first: Edge,
        [right, left]: [Vec<(Vertex, Edge)>; 2],
        triangles: &[u32],
    ) {
        let mesh = &mut self.triangulation.mesh;
        // Two-sided edges are known by their old names until both sides exist. The new edge takes the name of the first
        // crossed edge; an edge with crossed triangles on both sides keeps its own name.
        let base = [mesh.across(first), first];
        let side = |&(v, edge): &(Vertex, Edge)| {
            let outside = mesh.across(edge);
            (v, if mesh.is_marked(outside.triangle()) { Side::Twin(edge) } else { Side::Kept(outside) })
        };
        let right: Vec<(Vertex, Side)> = [(v, Side::Twin(base[0]))].into_iter().chain(right.iter().map(side)).collect();
        let left: Vec<(Vertex, Side)> = [(u, Side::Twin(base[1]))].into_iter().chain(left.iter().map(side)).collect();
        let twins: Vec<([Edge; 2], bool)> = right
            .iter()
            .chain(&left)
            .filter_map(|&(_, side)| match side {
                Side::Twin(edge) => Some(([edge, mesh.across(edge)], edge == base[1] || mesh.is_constrained(edge))),
                Side::Kept(_) => None,
            })
            .collect();
        triangles.iter().for_each(|&triangle| mesh.free(triangle));
        let mut new: HashMap<Edge, Edge> = HashMap::new();
        let mut filled = Vec::new();
        for polygon in [right, left] {
            filled.extend(self.triangulation.fill_hole(session, polygon, &mut new));
        }
        let mut constrained: Vec<Edge> = Vec::new();
        for ([edge, other], is_constrained) in twins {
            if let (Some(&edge), Some(&other)) = (new.get(&edge), new.get(&other)) {
                self.triangulation.mesh.link(edge, other);
                if is_constrained {
                    constrained.push(edge);
                }
            }
        }
        constrained.into_iter().for_each(|edge| self.triangulation.mesh.constrain(edge));
        self.triangulation.look_for_round(session, &filled);
        self.triangulation.near = filled.last().copied().unwrap_or(0);
        self.note(filled);
    }

    /// Inserts the crossing point of a constraint and an edge of another; the inner error is an invariant that does not
    /// hold.
    fn cross<P: Predicates + ?Sized>(
        &mut self,
        session: &mut P,
        constraints: &[[Vertex; 2]],
        number: usize,
        edge: Edge,
    ) -> Result<Result<Vertex, Contradiction>, Refused> {
        let mesh = &self.triangulation.mesh;
        let [a, b] = [mesh.start(edge), mesh.end(edge)];
        let Some(other) = self.of.remove(&key(a, b)) else { return Ok(Err(Contradiction::Once)) };
        let definition = Construction::Ssi([constraints[other], constraints[number]]);
        let [v] = session.construct(&[definition])?[..] else { return Ok(Err(Contradiction::Once)) };
        session.supports(PredicateKind::Incircle).map_err(|declined| Refused::session(declined.to_string()))?;
        if self.at.get(self.place(v)).is_some_and(|&triangle| triangle != NONE) {
            return Ok(Err(Contradiction::Once));
        }
        if let Err(broken) = self.triangulation.replace(&*session, v, edge.triangle(), Some(edge)) {
            return Ok(Err(broken));
        }
        let mesh = &mut self.triangulation.mesh;
        let Some(opposite) = mesh.opposite(self.triangulation.near, v) else { return Ok(Err(Contradiction::Once)) };
        let star: Vec<Edge> = mesh.around(opposite).collect();
        for &edge in &star {
            let end = mesh.start(edge);
            if end == a || end == b {
                mesh.constrain(edge.previous());
                self.of.insert(key(v, end), other);
            }
        }
        self.triangulation.crossings.push(definition);
        self.note(star.iter().map(|edge| edge.triangle()).collect());
        Ok(Ok(v))
    }
}
