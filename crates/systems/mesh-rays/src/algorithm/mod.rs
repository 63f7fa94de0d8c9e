//! All hits of lines, rays and segments with a mesh, sorted along each.
//!
//! First, a tree of boxes selects the triangles near each query. Then signs of input vertices say which vertices, edges
//! and faces the query hits (`find.rs`), and in which order (`order.rs`). Where these signs do not decide the order,
//! the points are constructed, in one call for all queries, so that ids do not depend on threads. Nothing is rounded
//! unless the session rounds.
//!
//! # Zeros
//! Zeros of exact sessions say that the line goes through a vertex or an edge, or is in the plane of a face: the answer
//! has these features. A perturbed session has none of these zeros, and its answer has faces only.

mod beam;
mod find;
mod order;

use std::collections::BTreeMap;

use predicament_grid::sort::sort_by_sign;
use predicament_grid::tree::Tree;
use predicament_grid::{Bounds, parallel};
use predicament_predicates::{Construction, Predicates, Refused, Scene, Sign, Vertex};

use crate::answer::{Extent, Feature, Groups, Hit, Hits};
use beam::Beam;
use find::{Asking, Found};

/// A mesh with a tree over its triangles. It depends on raw coordinates only, not on a backend.
#[derive(Clone, Debug)]
pub struct MeshTree {
    triangles: Vec<[Vertex; 3]>,
    /// The vertices of the triangles, ascending.
    vertices: Vec<Vertex>,
    tree: Tree,
}

impl MeshTree {
    /// The mesh of these triangles.
    ///
    /// # Panics
    /// If there are 2^32 triangles, or the scene lacks one of the vertices, or is planar.
    #[must_use]
    pub fn new(scene: &Scene, triangles: &[[Vertex; 3]]) -> MeshTree {
        let mut vertices = triangles.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let boxes: Vec<Bounds<3>> =
            triangles.iter().map(|corners| Bounds::of(corners.map(|v| scene.point3(v)))).collect();
        MeshTree { triangles: triangles.to_vec(), vertices, tree: Tree::new(&boxes) }
    }
}

/// The hits of one query, and their order as far as it is known before points are constructed.
struct Sorted {
    found: Found,
    /// The order of each two points, `None` where signs of input vertices do not decide it.
    order: Vec<Option<Sign>>,
    /// The definitions of points whose order is not decided, by the points' indices.
    open: Vec<(usize, Option<Construction>)>,
}

impl Sorted {
    fn decided(&self, i: usize, j: usize) -> Option<Sign> {
        self.order[i * self.found.points.len() + j]
    }
}

/// The hits of all queries, each given by two points, sorted along each.
///
/// # Errors
/// [`Refused`] if the order of hits needs a constructed vertex, and the session does not construct it.
///
/// # Panics
/// If the session's scene lacks one of the vertices.
pub fn hits<P: Predicates + ?Sized>(
    session: &mut P,
    mesh: &MeshTree,
    extent: Extent,
    queries: &[[Vertex; 2]],
) -> Result<Vec<Hits>, Refused> {
    let all = {
        let session = &*session;
        parallel::each(queries.len(), &|at| sorted(session, mesh, extent, queries[at]))
    };
    let all: Vec<Sorted> = all.into_iter().collect::<Result<_, _>>().map_err(Refused::session)?;
    let definitions: Vec<Construction> = all.iter().flat_map(|one| &one.open).filter_map(|(_, of)| *of).collect();
    let mut points = if definitions.is_empty() { Vec::new() } else { session.construct(&definitions)? }.into_iter();
    let constructed: Vec<BTreeMap<usize, Vertex>> = all
        .iter()
        .map(|one| {
            let vertex = |(at, of): &(usize, Option<Construction>)| match (of, one.found.points[*at].feature) {
                (None, Feature::Vertex(v)) => Some((*at, v)),
                _ => Some((*at, points.next()?)),
            };
            one.open.iter().filter_map(vertex).collect()
        })
        .collect();
    let session = &*session;
    Ok(parallel::each(queries.len(), &|at| {
        let asking = Asking::new(session, queries[at], extent);
        grouped(&asking, &all[at], &constructed[at])
    }))
}

/// The [crossings](Hits::crossings) of each query, without the order of its hits: no point is constructed.
///
/// # Panics
/// If the session's scene lacks one of the vertices.
pub fn crossings<P: Predicates + ?Sized>(
    session: &P,
    mesh: &MeshTree,
    extent: Extent,
    queries: &[[Vertex; 2]],
) -> Vec<Option<i64>> {
    parallel::each(queries.len(), &|at| found(session, mesh, extent, queries[at]).1.crossings)
}

/// Finds the hits of one query.
fn found<'s, P: Predicates + ?Sized>(
    session: &'s P,
    mesh: &MeshTree,
    extent: Extent,
    ends: [Vertex; 2],
) -> (Asking<'s, P>, Found) {
    let [from, to] = ends.map(|v| session.scene().point3(v));
    let (beam, reach) = (Beam { from, to, extent }, session.reach());
    let near = mesh.tree.admitted(|bounds| beam.may_meet(&bounds.inflated(reach)));
    let asking = Asking::new(session, ends, extent);
    let found = asking.find(&mesh.triangles, &near);
    (asking, found)
}

/// Finds the hits of one query, and their order by signs of input vertices.
fn sorted<P: Predicates + ?Sized>(
    session: &P,
    mesh: &MeshTree,
    extent: Extent,
    ends: [Vertex; 2],
) -> Result<Sorted, &'static str> {
    let (asking, found) = found(session, mesh, extent, ends);
    let count = found.points.len();
    let mut order = vec![Some(Sign::Zero); count * count];
    let mut is_open = vec![false; count];
    for i in 0..count {
        for j in i + 1..count {
            let sign = asking.by_signs(&mesh.triangles, &found.points[i], &found.points[j]);
            order[i * count + j] = sign;
            order[j * count + i] = sign.map(|sign| -sign);
            if sign.is_none() {
                is_open[i] = true;
                is_open[j] = true;
            }
        }
    }
    let open = (0..count).filter(|&at| is_open[at]);
    let define = |at| Ok((at, asking.definition(&found.points[at], &mesh.vertices)?));
    let open = open.map(define).collect::<Result<_, _>>()?;
    Ok(Sorted { found, order, open })
}

/// The groups of one query.
fn grouped<P: Predicates + ?Sized>(
    asking: &Asking<'_, P>,
    sorted: &Sorted,
    constructed: &BTreeMap<usize, Vertex>,
) -> Hits {
    let points = &sorted.found.points;
    let order = |i: usize, j: usize| {
        let open = || match [i, j].map(|at| constructed.get(&at)) {
            [Some(&u), Some(&v)] => asking.order(u, v),
            _ => Sign::Zero,
        };
        sorted.decided(i, j).unwrap_or_else(open)
    };
    let mut along: Vec<usize> = (0..points.len()).collect();
    sort_by_sign(&mut along, order);
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for &at in &along {
        match groups.last_mut() {
            Some(group) if group.first().is_some_and(|&first| order(first, at) == Sign::Zero) => group.push(at),
            _ => groups.push(vec![at]),
        }
    }
    // The intervals that begin at each group, and before all.
    let mut after: Vec<Vec<Hit>> = vec![Vec::new(); groups.len() + 1];
    let place =
        |feature: Feature| groups.iter().position(|group| group.iter().any(|&at| points[at].feature == feature));
    for interval in &sorted.found.intervals {
        let is_cut = asking.extent.has_start() && interval.ends.iter().any(|(_, at)| at[0] == Sign::Negative);
        let start = if is_cut {
            groups.iter().position(|group| group.iter().any(|&at| points[at].at[0] == Sign::Zero))
        } else {
            interval.ends.iter().filter_map(|(feature, _)| place(*feature)).min()
        };
        after[start.map_or(0, |group| group + 1)].push(Hit { feature: interval.feature, is_along: true });
    }
    let groups = groups.iter().map(|group| group.iter().map(|&at| Found::hit(&points[at])).collect());
    let mut all: Groups = Vec::new();
    for (points, intervals) in std::iter::once(Vec::new()).chain(groups).zip(after) {
        all.extend([points, intervals].into_iter().filter(|group: &Vec<Hit>| !group.is_empty()));
    }
    all.iter_mut().for_each(|group| group.sort_unstable());
    Hits { groups: all, crossings: sorted.found.crossings }
}
