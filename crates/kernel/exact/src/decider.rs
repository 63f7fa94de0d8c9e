//! A prepared scene: the bounds of its filters, and data that its queries need later.
//!
//! A decider returns the stage that settled a query, and counts nothing. It is one type, compiled once in this crate
//! for all tallies of a [`Session`](crate::Session).
//!
//! Preparing takes one pass over the points, for their extents. A filter reads only the points of its vertices and one
//! bound. A query that the filter leaves open needs the scene's plan, which is made on first use: a scene whose filters
//! decide everything never makes one.

use alloc::{boxed::Box, vec::Vec};

pub(crate) mod batches;
mod filtered;
pub(crate) mod open;

pub use filtered::Filtered;

use predicament_arithmetic::bound;
use predicament_predicates::{
    Axis, Construction, Declined, DefinitionError, Dimension, Plane, PredicateKind, Refused, Scene, Sign, Vertex,
};

use crate::constructed::Constructed;
use crate::first::{self, First, extents};
use crate::ladder::{Flat, Prepared, Solid};
use crate::once::Once;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::stage;

/// The exact backend, prepared for one scene, without a tally.
pub(crate) struct Decider<'s> {
    /// The scene's points, in the view of its dimension; the other view is empty.
    points2: &'s [[f64; 2]],
    points3: &'s [[f64; 3]],
    /// The points of the plane for turns that filters decide first: all, or nothing if integers come first.
    filtered2: &'s [[f64; 2]],
    /// The scale that turns coordinates into integers, if integers come before any filter; else zero. By plane.
    turn_scale: [f64; 3],
    /// The bounds of static filters; NaN if there is none.
    incircle: f64,
    orient3d: f64,
    insphere: f64,
    /// True if queries run their own filters first.
    incircle_by_query: bool,
    orient3d_by_query: bool,
    insphere_by_query: bool,
    /// The extent of the scene along each of its axes.
    extent2: [f64; 2],
    extent3: [f64; 3],
    flat: Once<Box<Flat>>,
    solid: Once<Box<Solid>>,
    /// The scene, including the vertices constructed since.
    constructed: Constructed,
}

impl<'s> Decider<'s> {
    pub fn new(scene: &'s Scene) -> Result<Decider<'s>, Declined> {
        let (points2, points3): (&[_], &[_]) = match scene.dimension() {
            Dimension::Two => (scene.coordinates().as_chunks().0, &[]),
            Dimension::Three => (&[], scene.coordinates().as_chunks().0),
        };
        let mut decider = Decider {
            points2,
            points3,
            filtered2: points2,
            turn_scale: [0.0; 3],
            incircle: f64::NAN,
            orient3d: f64::NAN,
            insphere: f64::NAN,
            incircle_by_query: false,
            orient3d_by_query: false,
            insphere_by_query: false,
            extent2: [0.0; 2],
            extent3: [0.0; 3],
            flat: Once::new(),
            solid: Once::new(),
            constructed: Constructed::new(scene)?,
        };
        match scene.dimension() {
            Dimension::Two => decider.look_at_plane(),
            Dimension::Three => decider.look_at_space(),
        }
        Ok(decider)
    }

    fn look_at_plane(&mut self) {
        self.extent2 = extents(self.points2);
        self.incircle = first::bound(self.extent2, bound::static_incircle);
        self.incircle_by_query = first::choose::<Incircle, 2, 4>(self.points2, self.incircle) == First::Query;
        // A filter that leaves much open causes many branch mispredictions. Two products of integers do not.
        if first::leaves_much::<Orient2d, 2, 3>(self.points2.len(), |at| self.points2[at]) {
            self.turn_scale[Plane::Xy as usize] = self.flat().orient2d.scale;
            if self.turn_scale[Plane::Xy as usize] != 0.0 {
                self.filtered2 = &[];
            }
        }
    }

    fn look_at_space(&mut self) {
        self.extent3 = extents(self.points3);
        self.orient3d = first::bound(self.extent3, bound::static_orient3d);
        self.insphere = first::bound(self.extent3, bound::static_insphere);
        self.orient3d_by_query = first::choose::<Orient3d, 3, 4>(self.points3, self.orient3d) == First::Query;
        self.insphere_by_query = first::choose::<Insphere, 3, 5>(self.points3, self.insphere) == First::Query;
        for plane in [Plane::Xy, Plane::Yz, Plane::Zx] {
            let axes = plane.axes().map(Axis::index);
            let seen = |at: usize| axes.map(|axis| self.points3[at][axis]);
            if first::leaves_much::<Orient2d, 2, 3>(self.points3.len(), seen) {
                self.turn_scale[plane as usize] = self.solid().orient2d[plane as usize].scale;
            }
        }
    }

    /// See [`Session::construct_where`](crate::Session::construct_where).
    pub fn construct_where(
        &mut self,
        definitions: &[Construction],
        accepts: &dyn Fn(&Construction) -> Result<(), DefinitionError>,
    ) -> Result<Vec<Vertex>, Refused> {
        self.constructed.construct_where(definitions, accepts)
    }

    /// The scene, with its constructed vertices.
    #[inline]
    pub fn scene(&self) -> &Scene {
        self.constructed.scene()
    }

    /// See [`Session::is_double`](crate::Session::is_double).
    #[inline]
    pub fn is_double(&self, kind: PredicateKind) -> bool {
        match (kind, self.constructed.scene().dimension()) {
            (PredicateKind::Compare, _) => true,
            (PredicateKind::Orient2d, Dimension::Two) => self.flat().orient2d.is_double(),
            (PredicateKind::Orient2d, Dimension::Three) => self.solid().orient2d.iter().all(Prepared::is_double),
            (PredicateKind::Incircle, _) => self.flat().incircle.is_double(),
            (PredicateKind::Orient3d, _) => self.solid().orient3d.is_double(),
            (PredicateKind::Insphere, _) => self.solid().insphere.is_double(),
            (PredicateKind::Derived(_), _) => false,
        }
    }

    /// See [`Session::is_known_double`](crate::Session::is_known_double).
    #[inline(always)]
    pub fn is_known_double(&self, kind: PredicateKind) -> bool {
        match kind {
            PredicateKind::Orient2d => self.flat.get().is_some_and(|plan| plan.orient2d.is_double()),
            PredicateKind::Incircle => self.flat.get().is_some_and(|plan| plan.incircle.is_double()),
            PredicateKind::Orient3d => self.solid.get().is_some_and(|plan| plan.orient3d.is_double()),
            PredicateKind::Insphere => self.solid.get().is_some_and(|plan| plan.insphere.is_double()),
            _ => false,
        }
    }

    /// See [`Session::constructed`](crate::Session::constructed).
    pub fn constructed(&self) -> &Constructed {
        &self.constructed
    }

    /// See [`Session::decide_compare`](crate::Session::decide_compare).
    #[inline]
    pub fn decide_compare(&self, axis: Axis, a: Vertex, b: Vertex) -> (Sign, usize) {
        let at = |v: Vertex| match self.constructed.scene().dimension() {
            Dimension::Two => self.points2.get(v.index()).map(|p| p[axis.index()]),
            Dimension::Three => self.points3.get(v.index()).map(|p| p[axis.index()]),
        };
        let (Some(x), Some(y)) = (at(a), at(b)) else { return self.compare_constructed(axis, [a, b]) };
        // The coordinates of a scene are finite, so there is always an order, in which -0 equals 0.
        const SIGNS: [Sign; 3] = [Sign::Negative, Sign::Zero, Sign::Positive];
        (SIGNS[usize::from(x >= y) + usize::from(x > y)], stage::COMPARE)
    }

    /// See [`Session::filter_orient3d`](crate::Session::filter_orient3d).
    #[inline]
    pub fn filter_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Option<(Sign, usize)> {
        let at = |v: Vertex| self.points3.get(v.index());
        let sign = Orient3d::estimate([*at(a)?, *at(b)?, *at(c)?, *at(d)?]).above(self.orient3d)?;
        Some((sign, stage::STATIC))
    }

    #[inline(always)]
    fn flat(&self) -> &Flat {
        self.flat.get_or_init(|| Box::new(Flat::new(self.points2)))
    }

    #[inline(always)]
    fn solid(&self) -> &Solid {
        self.solid.get_or_init(|| Box::new(Solid::new(self.points3)))
    }

    #[inline(always)]
    fn point2(&self, plane: Plane, v: Vertex) -> Option<[f64; 2]> {
        match (self.constructed.scene().dimension(), plane) {
            (Dimension::Two, Plane::Xy) => self.points2.get(v.index()).copied(),
            (_, plane) => {
                let point = self.points3.get(v.index())?;
                let [x, y] = plane.axes();
                Some([point[x.index()], point[y.index()]])
            }
        }
    }
}
