//! Where vertices are: the nearest doubles, and which vertices are at one place.

use std::cmp::Ordering;

use predicament_predicates::{Axis, Predicates, Scene, Vertex};

use super::nearest::nearest;
use crate::algorithm::overlay::{SurfaceContradiction, Undone};

/// The doubles nearest to all vertices of a scene.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Places {
    /// By the number of the construction: the doubles, and where the point is from there.
    constructed: Vec<([f64; 3], [Ordering; 3])>,
}

impl Places {
    /// The doubles nearest to the vertices that a scene constructs.
    ///
    /// # Errors
    /// [`Undone::Broken`] where a line and a plane of input vertices meet in no single point, or a vertex is constructed otherwise.
    pub fn new(scene: &Scene) -> Result<Places, Undone> {
        let mut places = Places::default();
        places.extend(scene)?;
        Ok(places)
    }

    /// Adds what the scene has constructed since.
    pub(crate) fn extend(&mut self, scene: &Scene) -> Result<(), Undone> {
        let new = &scene.constructions()[self.constructed.len()..];
        let points = predicament_grid::parallel::all(new, &|definition| nearest(scene, definition));
        for point in points {
            self.constructed.push(point.ok_or(Undone::Broken(SurfaceContradiction::Point.into()))?);
        }
        Ok(())
    }

    /// The doubles nearest to a vertex; -0 comes as 0.
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn nearest(&self, scene: &Scene, v: Vertex) -> [f64; 3] {
        let point = v.construction().map_or_else(|| scene.point3(v), |index| self.constructed[index].0);
        point.map(|x| x + 0.0)
    }

    /// In each coordinate of a vertex the double on the other side of its place than the nearest one; the nearest one where that is its
    /// place.
    pub(crate) fn beyond(&self, scene: &Scene, v: Vertex) -> [f64; 3] {
        let nearest = self.nearest(scene, v);
        let sides = v.construction().map_or([Ordering::Equal; 3], |index| self.constructed[index].1);
        [0, 1, 2].map(|axis: usize| match sides[axis] {
            Ordering::Less => nearest[axis].next_down(),
            Ordering::Equal => nearest[axis],
            Ordering::Greater => nearest[axis].next_up(),
        })
    }

    /// Whether a vertex is where [`Places::nearest`] says.
    ///
    /// # Panics
    /// If the scene has no such vertex.
    #[must_use]
    pub fn is_exact(&self, v: Vertex) -> bool {
        v.construction().is_none_or(|index| self.constructed[index].1 == [Ordering::Equal; 3])
    }
}

/// Which vertices stand for others at the same place.
#[derive(Default)]
pub(crate) struct Same {
    /// A vertex and the one that stands for it, ascending; those that stand for themselves are left out.
    stands: Vec<[Vertex; 2]>,
}

impl Same {
    /// Of these vertices at one place the first stands for all: an input vertex, if there is one. Input vertices of one mesh alone stay as
    /// they are.
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

    /// The vertex that stands for one.
    pub fn stand(&self, v: Vertex) -> Vertex {
        self.stands.binary_search_by_key(&v, |pair| pair[0]).map_or(v, |at| self.stands[at][1])
    }

    /// How many vertices another one stands for.
    pub fn count(&self) -> usize {
        self.stands.len()
    }
}
