//! Convex hulls in space by divide and conquer.

use predicament_mesh::half_edge::{HalfEdgeMesh, IndexedFaces};
use predicament_predicates::{Plane, Predicates, Vertex};

use super::chains::{Side, monotone, tangent};
use super::first::AXES;
use super::scratch::Scratch;
use super::{Contradiction, Hull3, faces, incremental, order, stitch};

/// The size of a part that is not divided: insertion finds its hull.
const LEAF: usize = 8;

/// The hull of consecutive vertices.
pub(super) struct Part {
    pub body: Body,
    /// The lower hull of its vertices, projected to the xy plane, left to right.
    pub lower: Vec<Vertex>,
}

/// The hull of a part's vertices, by dimension.
pub(super) enum Body {
    /// A point, a segment or a polygon.
    Flat(Hull3),
    /// A closed mesh.
    Solid(Box<HalfEdgeMesh>),
}

/// The hull of these vertices. Faces are unsorted, and may begin at any vertex.
pub(super) fn hull(session: &dyn Predicates, scratch: &mut Scratch, vertices: &[Vertex]) -> Hull3 {
    let sorted = order::sorted(session, &AXES, vertices);
    if sorted.is_empty() {
        return Hull3::default();
    }
    match part(session, scratch, &sorted) {
        Ok(part) => part.body.into_hull(),
        Err(hull) => hull,
    }
}

/// The hull of sorted vertices; the error is the hull of the part at which an invariant did not hold.
fn part(session: &dyn Predicates, scratch: &mut Scratch, sorted: &[Vertex]) -> Result<Part, Hull3> {
    if sorted.len() <= LEAF {
        let lower = monotone(session, Plane::Xy, Side::Lower, sorted);
        return Ok(Part { body: by_insertion(session, scratch, sorted)?, lower });
    }
    let (left, right) = sorted.split_at(sorted.len() / 2);
    let [left, right] = [part(session, scratch, left)?, part(session, scratch, right)?];
    let [i, j] = tangent(session, Plane::Xy, Side::Lower, &left.lower, &right.lower);
    let touching = [left.lower[i], right.lower[j]];
    let lower = left.lower[..=i].iter().chain(&right.lower[j..]).copied().collect();
    let body = match (left.body, right.body) {
        (Body::Solid(left), Body::Solid(right)) => {
            let mut parts = [*left, *right];
            match stitch::stitched(session, &mut parts, touching) {
                Ok(mesh) => Body::Solid(Box::new(mesh)),
                Err(why) => {
                    let [left, _] = parts;
                    return Err(Hull3 { broken: Some(why), ..Body::Solid(Box::new(left)).into_hull() });
                }
            }
        }
        (left, right) => {
            // A part without volume does not have a surface for stitching.
            let both: Vec<Vertex> = [left, right].into_iter().flat_map(|body| body.into_hull().vertices).collect();
            by_insertion(session, scratch, &both)?
        }
    };
    Ok(Part { body, lower })
}

fn by_insertion(session: &dyn Predicates, scratch: &mut Scratch, vertices: &[Vertex]) -> Result<Body, Hull3> {
    let hull = incremental::hull(session, scratch, vertices);
    if hull.broken.is_some() {
        return Err(hull);
    }
    if hull.faces.len() < 4 {
        return Ok(Body::Flat(hull));
    }
    hull.vertices.iter().zip(0..).for_each(|(v, at)| scratch.spoke[v.index()] = at);
    let faces: IndexedFaces = hull.faces.iter().map(|face| face.iter().map(|v| scratch.spoke[v.index()])).collect();
    hull.vertices.iter().for_each(|v| scratch.spoke[v.index()] = super::scratch::NONE);
    match HalfEdgeMesh::new(hull.vertices.clone(), &faces) {
        Ok(mesh) => Ok(Body::Solid(Box::new(mesh))),
        Err(_) => Err(Hull3 { broken: Some(Contradiction::Part), ..hull }),
    }
}

impl Body {
    fn into_hull(self) -> Hull3 {
        let mesh = match self {
            Body::Flat(hull) => return hull,
            Body::Solid(mesh) => mesh,
        };
        let of = |f| mesh.loop_of(mesh.half_edge_of_face(f)).map(|h| mesh.scene_vertex(mesh.start(h))).collect();
        let faces: Vec<Vec<Vertex>> = mesh.faces().map(of).collect();
        Hull3 { vertices: faces::corners(&faces), faces, broken: None }
    }
}
