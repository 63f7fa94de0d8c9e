//! Overlay of two meshes that touch, where a zero means zero.
//!
//! Simulation of Simplicity exists to avoid the cases below. They are written out here, so that "touching" has an
//! answer: the closed sets as given.
//!
//! # The cases
//! Two simplices, one of either mesh, meet if their relative interiors do. The intersection of two relative interiors
//! is convex and open in its plane, line or point, so it has one dimension, at most that of either simplex:
//!
//! | first, second | a point | a segment | an area |
//! |---|---|---|---|
//! | vertex, vertex | one position | | |
//! | vertex, edge | inside the edge | | |
//! | vertex, triangle | inside the triangle | | |
//! | edge, edge | they cross | they overlap | |
//! | edge, triangle | the edge passes through | the edge is in the plane | |
//! | triangle, triangle | | their planes cross | they are in one plane |
//!
//! With the rows for exchanged meshes these are all pairs of kinds and all dimensions that both allow, except two
//! triangles that meet in one point: two planes that cross have a line in common, and the intersection of two open
//! triangles on it is open. Names of points follow (`found.rs`): a name is a pair of simplices, so several
//! constructions of one point never arise.
//!
//! # Steps
//! 1. Vertices at one position get one representative (`stands.rs`), and triangles that both meshes have are set aside.
//! 2. Each other pair of near triangles is intersected: two planes (`skew.rs`), or one (`coplanar.rs`). All decisions
//!    are orientations of input vertices.
//! 3. Points inside edges are constructed, each by its edge and a plane, and distributed over simplices (`marks.rs`).
//! 4. Each touched triangle is triangulated with the segments in it. No two of them cross: the other mesh meets the
//!    plane of the triangle in points and segments of its own simplices. The triangles between segments are a part,
//!    and the segments at its border say where it is in the other mesh (`face.rs`): in a region, or in a triangle of
//!    it. Around an edge of the other mesh the order of its triangles decides.
//! 5. Other parts and untouched triangles follow from their neighbours, or are located (`regions.rs`).
//!
//! A part in triangles of both meshes is divided alike by both, as its border is, and inside it nothing else is. It
//! occurs once in the result, with its triangle in either mesh ([`Shared`]).
//!
//! # Regularised results
//! A result consists of the parts with its inside on exactly one side. So it is the border of the closure of its
//! interior (Requicha's *regularised* operation): a sheet without volume has the outside on both sides, or the inside,
//! and is not in it. Contacts that a regularised intersection loses are listed by [`super::MeshOverlay::contacts`].
//!
//! # What is taken
//! Meshes whose triangles meet in common vertices and edges only, after vertices at one position have become one:
//! two boxes of one mesh may share an edge. If triangles of one mesh meet otherwise, and an invariant breaks, they are
//! named (`own.rs`).

mod contacts;
mod coplanar;
mod face;
mod found;
mod marks;
mod own;
mod regions;
mod skew;
mod stands;
mod triangle;

use std::num::NonZero;
use std::sync::Arc;

use predicament_grid::Bounds;
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Construction, Predicates, Vertex};

use self::face::{Dividing, Part, Place};
use self::found::{Found, Simplex};
use self::marks::Marks;
use self::regions::{Decided, Regions};
use self::stands::Stands;
use self::triangle::Triangles;
use super::near::{Near, number};
use super::same;
use super::{Contradiction, Extent, MeshOverlay, Piece, Step, Undone};
use crate::algorithm::resolve::faces::turn;

/// A part of a triangle of either mesh that is in both.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Shared {
    /// Its vertices, with the orientation of the first mesh's triangle.
    pub triangle: [Vertex; 3],
    /// The index of the triangle in either mesh.
    pub of: [u32; 2],
    /// True if the second mesh's triangle faces the other way.
    pub is_turned: bool,
}

/// Overlays two meshes in a session with exact zeros.
///
/// # Errors
/// [`Undone::Own`] if triangles of one mesh meet otherwise than in whole edges and corners, and break an invariant.
pub(super) fn overlay(
    session: &mut dyn Predicates,
    meshes: &[Arc<MaterialMesh>; 2],
    extent: Extent,
    done: &mut dyn FnMut(Step),
) -> Result<MeshOverlay, Undone> {
    let overlaid = by_cases(session, meshes, extent, done);
    let Err(broken @ Undone::Broken(_)) = overlaid else { return overlaid };
    let stands = Stands::new(session.scene(), [&meshes[0], &meshes[1]]);
    let own = |mesh: usize| Some(Undone::Own { mesh, triangles: own::pair(session, &meshes[mesh], &stands)? });
    Err((0..2).find_map(own).unwrap_or(broken))
}

fn by_cases(
    session: &mut dyn Predicates,
    meshes: &[Arc<MaterialMesh>; 2],
    extent: Extent,
    done: &mut dyn FnMut(Step),
) -> Result<MeshOverlay, Undone> {
    let before = session.scene().constructions().len();
    let both = [&*meshes[0], &*meshes[1]];
    let stands = Stands::new(session.scene(), both);
    let twins = same::twins(session.scene(), both);
    let asked = twins[0].iter().any(Option::is_some).then(|| {
        let others =
            |twins: &Vec<Option<u32>>| (0..).zip(twins).filter(|(_, twin)| twin.is_none()).map(|(at, _)| at).collect();
        twins.each_ref().map(others)
    });
    let (near, bounds) = Near::of(session.scene(), both, asked);
    let corners = [0, 1].map(|mesh: usize| -> Vec<[Vertex; 3]> {
        let corners = |&at: &u32| both[mesh].triangles()[at as usize].map(|v| stands.of(v));
        near[mesh].triangles.iter().map(corners).collect()
    });
    let [first, second] = near;
    let near = [first.over(&corners[0]), second.over(&corners[1])];
    let is_twin = [0, 1].map(|mesh: usize| -> Vec<bool> {
        near[mesh].triangles.iter().map(|&at| twins[mesh][at as usize].is_some()).collect()
    });
    let triangles =
        [0, 1].map(|mesh: usize| Triangles { near: &near[mesh], corners: &corners[mesh], is_twin: &is_twin[mesh] });
    done(Step::Near);
    let found = triangle::found(session, [&triangles[0], &triangles[1]]);
    done(Step::Passages);
    let vertices = construct(session, [&triangles[0], &triangles[1]], &found)?;
    let session = &*session;
    let marks = [0, 1].map(|mesh: usize| Marks::new(session, mesh, &near[mesh], &found, &vertices));
    let mut is_on = [vec![false; session.scene().len()], vec![false; session.scene().len()]];
    for pair in &found.points {
        for mesh in 0..2 {
            if let Simplex::Vertex(v) = pair[mesh] {
                is_on[mesh][v.index()] = true;
            }
        }
    }
    done(Step::Points);
    let mut overlay = MeshOverlay {
        meshes: meshes.clone(),
        whole: [Vec::new(), Vec::new()],
        pieces: [Vec::new(), Vec::new()],
        shared: Vec::new(),
        constructions: Vec::new(),
    };
    for mesh in 0..2 {
        // (Pairs of twins are left out, and no twin is divided.)
        let is_on_other = |v: Vertex| is_on[mesh][v.index()];
        let dividing = Dividing {
            session,
            mesh,
            own: &triangles[mesh],
            marks: &marks[mesh],
            other: &triangles[1 - mesh],
            other_mesh: both[1 - mesh],
            is_on_other: &is_on_other,
        };
        let decided =
            divide(&dividing, &stands, &twins[mesh], &meshes[mesh], &meshes[1 - mesh], &bounds[1 - mesh], extent)?;
        overlay.add(mesh, decided, session)?;
    }
    overlay.add_twins(&twins[0], &stands);
    done(Step::Regions);
    overlay.constructions = session.scene().constructions()[before..].to_vec();
    done(Step::Faces);
    Ok(overlay)
}

/// A divided mesh: for each triangle that is not divided, its region; the parts of the others.
struct Divided {
    whole: Vec<Option<u32>>,
    parts: Vec<(u32, Place, Vec<[Vertex; 3]>)>,
}

fn divide(
    dividing: &Dividing<'_>,
    stands: &Stands,
    twins: &[Option<u32>],
    mesh: &MaterialMesh,
    other: &Arc<MaterialMesh>,
    bounds: &Bounds<3>,
    extent: Extent,
) -> Result<Divided, Undone> {
    let mut is_touched: Vec<bool> = twins.iter().map(Option::is_some).collect();
    let near = dividing.own.near;
    // Twins are whole, and known.
    let is_cut = |&place: &u32| {
        let at = near.triangles[place as usize] as usize;
        twins[at].is_none() && dividing.is_touched(place)
    };
    let cut: Vec<u32> = (0..number(near.triangles.len())).filter(is_cut).collect();
    cut.iter().for_each(|&place| is_touched[near.triangles[place as usize] as usize] = true);
    let (mut parts, mut of) = (Vec::new(), Vec::new());
    for (&place, made) in cut.iter().zip(predicament_grid::parallel::each(cut.len(), &|at| dividing.parts(cut[at]))) {
        let made: Vec<Part> = made?;
        of.extend(std::iter::repeat_n(near.triangles[place as usize], made.len()));
        parts.extend(made);
    }
    let untouched = |at: usize| (!is_touched[at]).then(|| mesh.triangles()[at].map(|v| stands.of(v)));
    let regions = Regions {
        session: dividing.session,
        untouched: &untouched,
        count: is_touched.len(),
        parts: &parts,
        other,
        bounds,
        extent,
    };
    let Decided { whole, places } = regions.decided()?;
    // A triangle that keeps its vertices is whole; others are pieces.
    let mut divided = Divided { whole, parts: Vec::new() };
    for (at, region) in divided.whole.iter_mut().enumerate() {
        let corners = mesh.triangles()[at];
        if region.is_some()
            && corners.map(|v| stands.of(v)) != corners
            && let Some(region) = region.take()
        {
            divided.parts.push((number(at), Place::Region(region), vec![corners.map(|v| stands.of(v))]));
        }
    }
    for ((part, of), place) in parts.into_iter().zip(of).zip(places) {
        let place = match place {
            Place::Shared(near) => Place::Shared(dividing.other.near.triangles[near as usize]),
            place => place,
        };
        divided.parts.push((of, place, part.triangles));
    }
    Ok(divided)
}

impl MeshOverlay {
    /// Adds a divided mesh. A part that both meshes have comes from the first.
    fn add(&mut self, mesh: usize, divided: Divided, session: &dyn Predicates) -> Result<(), Undone> {
        self.whole[mesh] = divided.whole.into_iter().map(|region| NonZero::new(region?.wrapping_add(1))).collect();
        for (of, place, triangles) in divided.parts {
            match place {
                Place::Region(region) => {
                    let piece = |triangle| Piece { triangle, of, region };
                    self.pieces[mesh].extend(triangles.into_iter().map(piece));
                }
                Place::Shared(other) if mesh == 0 => {
                    let is_turned = self.is_turned([of, other], session)?;
                    let shared = |triangle| Shared { triangle, of: [of, other], is_turned };
                    self.shared.extend(triangles.into_iter().map(shared));
                }
                Place::Shared(_) => {}
                Place::Unknown => return Err(Undone::Broken(Contradiction::Region)),
            }
        }
        Ok(())
    }

    /// Adds the triangles that both meshes have.
    fn add_twins(&mut self, twins: &[Option<u32>], stands: &Stands) {
        let standing = |mesh: usize, at: u32| self.meshes[mesh].triangles()[at as usize].map(|v| stands.of(v));
        let twin = |(at, twin): (u32, &Option<u32>)| {
            let of = [at, (*twin)?];
            let triangle = standing(0, at);
            let [a, b, c] = standing(1, of[1]);
            Some(Shared { triangle, of, is_turned: ![[a, b, c], [b, c, a], [c, a, b]].contains(&triangle) })
        };
        let shared: Vec<Shared> = (0..).zip(twins).filter_map(twin).collect();
        self.shared.extend(shared);
    }

    /// True if two triangles in one plane, one of either mesh, face opposite ways.
    fn is_turned(&self, of: [u32; 2], session: &dyn Predicates) -> Result<bool, Undone> {
        let [first, second] = [0, 1].map(|mesh: usize| self.meshes[mesh].triangles()[of[mesh] as usize]);
        let (plane, is_clockwise) = super::cut::projection(session, first).map_err(Undone::Broken)?;
        let is_also = turn(session, plane, second) == predicament_predicates::Sign::Negative;
        Ok(is_clockwise != is_also)
    }
}

/// Constructs the points inside edges; returns the vertices of all points.
fn construct(
    session: &mut dyn Predicates,
    triangles: [&Triangles<'_>; 2],
    found: &Found,
) -> Result<Vec<Vertex>, Undone> {
    let mut vertices = Vec::with_capacity(found.points.len());
    let mut definitions = Vec::new();
    for pair in &found.points {
        let edge = |mesh: usize, at: u32| triangles[mesh].near.edges[at as usize];
        let definition = match *pair {
            [Simplex::Vertex(v), _] | [_, Simplex::Vertex(v)] => {
                vertices.push(Some(v));
                continue;
            }
            [Simplex::Edge(at), Simplex::Triangle(other)] => {
                Construction::Lpi { line: edge(0, at), plane: triangles[1].corners[other as usize] }
            }
            [Simplex::Triangle(other), Simplex::Edge(at)] => {
                Construction::Lpi { line: edge(1, at), plane: triangles[0].corners[other as usize] }
            }
            [Simplex::Edge(first), Simplex::Edge(second)] => {
                let edges = [first, second];
                let plane = plane_of(session, triangles, edges).ok_or(Undone::Broken(Contradiction::NoArea))?;
                Construction::Lpi { line: edge(0, first), plane }
            }
            [Simplex::Triangle(_), Simplex::Triangle(_)] => return Err(Undone::Broken(Contradiction::Segment)),
        };
        vertices.push(None);
        definitions.push(definition);
    }
    let mut constructed = session.construct(&definitions)?.into_iter();
    let of = |known: Option<Vertex>| known.or_else(|| constructed.next()).ok_or(Undone::Broken(Contradiction::Segment));
    vertices.into_iter().map(of).collect()
}

/// A plane through the second of two edges that cross, but not through the first: by a corner of a triangle at either
/// edge, or by any other near vertex.
fn plane_of(session: &dyn Predicates, triangles: [&Triangles<'_>; 2], edges: [u32; 2]) -> Option<[Vertex; 3]> {
    let [[p, _], [a, b]] = [0, 1].map(|mesh: usize| triangles[mesh].near.edges[edges[mesh] as usize]);
    let at_edge = |mesh: usize| {
        let Triangles { near, corners, .. } = triangles[mesh];
        near.uses(edges[mesh]).map(move |(triangle, corner)| corners[triangle as usize][(corner + 2) % 3])
    };
    let all = triangles.into_iter().flat_map(|side| side.corners.as_flattened().iter().copied());
    let is_off = |w: &Vertex| ![p, a, b].contains(w) && !session.orient3d(a, b, *w, p).is_zero();
    Some([a, b, at_edge(1).chain(at_edge(0)).chain(all).find(is_off)?])
}
