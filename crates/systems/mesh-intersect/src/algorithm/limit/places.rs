//! Positions of vertices: the nearest doubles, and the vertices that coincide.

use std::cmp::Ordering;

use predicament_predicates::{Axis, Predicates, Scene, Vertex};

use super::nearest::nearest;
use crate::algorithm::overlay::{SurfaceContradiction, Undone};

/// The doubles nearest to all vertices of a scene.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Places {
    /// For each construction, by index: the nearest doubles, and the direction of the point from them.
    constructed: Vec<([f64; 3], [Ordering; 3])>,
}

impl Places {
    /// Computes the doubles nearest to the vertices that a scene constructs.
    ///
    /// # Errors
    /// [`Undone::Broken`] if a line and a plane of input vertices do not meet in a single point, or a vertex has
    /// another kind of definition.
    pub fn new(scene: &Scene) -> Result<Places, Undone> {
        let mut places = Places::default();
        places.extend(scene)?;
        Ok(places)
    }

    /// Adds the scene's newer constructions.
    pub(crate) fn extend(&mut self, scene: &Scene) -> Result<(), Undone> {
        let new = &scene.constructions()[self.constructed.len()..];
        let points = predicament_grid::parallel::all(new, &|definition| nearest(scene, definition));
        for point in points {
            self.constructed.push(point.ok_or(Undone::Broken(SurfaceContradiction::Point.into()))?);
        }
        Ok(())
    }

    /// The doubles nearest to a vertex; −0 becomes 0.
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn nearest(&self, scene: &Scene, v: Vertex) -> [f64; 3] {
        let point = v.construction().map_or_else(|| scene.point3(v), |index| self.constructed[index].0);
        point.map(|x| x + 0.0)
    }

    /// In each coordinate of a vertex, the adjacent double on the other side of its exact position than the nearest
    /// double; the nearest double itself if it is exact.
    pub(crate) fn beyond(&self, scene: &Scene, v: Vertex) -> [f64; 3] {
        let nearest = self.nearest(scene, v);
        let sides = v.construction().map_or([Ordering::Equal; 3], |index| self.constructed[index].1);
        [0, 1, 2].map(|axis: usize| match sides[axis] {
            Ordering::Less => nearest[axis].next_down(),
            Ordering::Equal => nearest[axis],
            Ordering::Greater => nearest[axis].next_up(),
        })
    }

    /// True if the doubles of [`Places::nearest`] are the exact position.
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn is_exact(&self, v: Vertex) -> bool {
        v.construction().is_none_or(|index| self.constructed[index].1 == [Ordering::Equal; 3])
    }
}

/// The representatives of coinciding vertices.
#[derive(Default)]
pub(crate) struct Same {
    /// Pairs of a vertex and its different representative, ascending.
    stands: Vec<[Vertex; 2]>,
}

impl Same {
    /// Finds coinciding vertices. The first of each group represents it: an input vertex, if there is one. Groups that
    /// consist only of input vertices of one mesh are kept.
    pub fn of(session: &dyn Predicates, places: &Places, mut vertices: Vec<Vertex>) -> Same {
        vertices.sort_unstable();
        vertices.dedup();
        let scene = session.scene();
        let mut by_place: Vec<([f64; 3], Vertex)> =
            vertices.into_iter().map(|v| (places.nearest(scene, v), v)).collect();
        by_place.sort_unstable_by(|(a, v), (b, w)| {
            let order = [0, 1, 2].into_iter().map(|axis: usize| a[axis].total_cmp(&b[axis]));
            order.fold(Ordering::Equal, Ordering::then).then(v.cmp(w))
        });
        let is_same = |a: Vertex, b: Vertex| {
            (places.is_exact(a) && places.is_exact(b))
                || [Axis::X, Axis::Y, Axis::Z].into_iter().all(|axis| session.compare(axis, a, b).is_zero())
        };
        let mut stands = Vec::new();
        let mut first: Vec<Vertex> = Vec::new();
        let is_of_second = |v: Vertex| scene.second_mesh().is_some_and(|second| second[v.index()]);
        for near in by_place.chunk_by(|a, b| a.0 == b.0) {
            let (first_of_all, last) = (near[0].1, near[near.len() - 1].1);
            if near.len() == 1 || (!last.is_constructed() && is_of_second(first_of_all) == is_of_second(last)) {
                continue;
            }
            first.clear();
            for &(_, v) in near {
                match first.iter().find(|&&other| is_same(other, v)) {
                    Some(&other) => stands.push([v, other]),
                    None => first.push(v),
                }
            }
        }
        stands.sort_unstable();
        Same { stands }
    }

    /// The representative of a vertex.
    pub fn stand(&self, v: Vertex) -> Vertex {
        self.stands.binary_search_by_key(&v, |pair| pair[0]).map_or(v, |at| self.stands[at][1])
    }

    /// The number of vertices with a different representative.
    pub fn count(&self) -> usize {
        self.stands.len()
    }
}
