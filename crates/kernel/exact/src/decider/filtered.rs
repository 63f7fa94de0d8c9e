//! Queries that the static filter decides first, and the points that it leaves to others.

use predicament_predicates::{Axis, Plane, Sign, Vertex};

use super::Decider;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::scene_integers::scaled;
use crate::stage;

/// The result of the first filter of a query.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Filtered<'s, const D: usize, const N: usize> {
    /// The sign is certain; its stage.
    Settled(Sign, usize),
    /// The sign is not certain: the determinant in doubles, and the points that have been read.
    Left(f64, [&'s [f64; D]; N]),
    /// The static filter has not run: another one runs first, or a vertex is constructed.
    Unasked,
}

impl<'s> Decider<'s> {
    /// See [`Session::filtered_orient2d`](crate::Session::filtered_orient2d).
    #[inline(always)]
    pub fn filtered_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Filtered<'s, 2, 3> {
        let at = |v: Vertex| self.filtered2.get(v.index());
        if plane == Plane::Xy
            && let (Some(a), Some(b), Some(c)) = (at(a), at(b), at(c))
        {
            let bounded = Orient2d::anywhere([*a, *b, *c]);
            return match bounded.certain() {
                Some(sign) => Filtered::Settled(sign, stage::SEMI_STATIC),
                None => Filtered::Left(bounded.determinant, [a, b, c]),
            };
        }
        Filtered::Unasked
    }

    /// See [`Session::decide_orient2d`](crate::Session::decide_orient2d).
    #[inline(always)]
    pub fn decide_orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> (Sign, usize) {
        // The permanent costs two operations: it is as good as a bound for the scene, and needs none. Nothing else is
        // looked at before: where points come from memory, a query with fewer instructions overlaps with more others.
        if let Filtered::Settled(sign, stage) = self.filtered_orient2d(plane, a, b, c) {
            return (sign, stage);
        }
        if self.turn_scale[plane as usize] != 0.0 {
            return self.turn_in_integers(plane, a, b, c);
        }
        // A projection: where the plane is a constant, so are the indices of coordinates.
        let at = |v: Vertex| self.points3.get(v.index());
        if let (Some(a), Some(b), Some(c)) = (at(a), at(b), at(c)) {
            let [i, j] = plane.axes().map(Axis::index);
            let points = [[a[i], a[j]], [b[i], b[j]], [c[i], c[j]]];
            if let Some(sign) = Orient2d::anywhere(points).certain() {
                return (sign, stage::SEMI_STATIC);
            }
        }
        self.climb_orient2d(plane, a, b, c)
    }

    /// See [`Session::filtered_orient3d`](crate::Session::filtered_orient3d).
    #[inline(always)]
    pub fn filtered_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Filtered<'s, 3, 4> {
        let at = |v: Vertex| self.points3.get(v.index());
        if !self.orient3d_by_query
            && let (Some(a), Some(b), Some(c), Some(d)) = (at(a), at(b), at(c), at(d))
        {
            return filtered::<Orient3d, 3, 4>([a, b, c, d], self.orient3d);
        }
        Filtered::Unasked
    }

    /// See [`Session::decide_orient3d`](crate::Session::decide_orient3d).
    #[inline(always)]
    pub fn decide_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        match self.filtered_orient3d(a, b, c, d) {
            Filtered::Settled(sign, stage) => (sign, stage),
            Filtered::Left(determinant, _) => self.open_orient3d(determinant, a, b, c, d),
            Filtered::Unasked if self.orient3d_by_query => self.orient3d_by_query(a, b, c, d),
            Filtered::Unasked => self.open_orient3d(f64::NAN, a, b, c, d),
        }
    }

    /// See [`Session::filtered_incircle`](crate::Session::filtered_incircle).
    #[inline(always)]
    pub fn filtered_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Filtered<'s, 2, 4> {
        let at = |v: Vertex| self.points2.get(v.index());
        if !self.incircle_by_query
            && let (Some(a), Some(b), Some(c), Some(d)) = (at(a), at(b), at(c), at(d))
        {
            return filtered::<Incircle, 2, 4>([a, b, c, d], self.incircle);
        }
        Filtered::Unasked
    }

    /// See [`Session::decide_incircle`](crate::Session::decide_incircle).
    #[inline]
    pub fn decide_incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> (Sign, usize) {
        match self.filtered_incircle(a, b, c, d) {
            Filtered::Settled(sign, stage) => (sign, stage),
            Filtered::Left(determinant, _) => self.open_incircle(determinant, a, b, c, d),
            Filtered::Unasked if self.incircle_by_query => self.incircle_by_query(a, b, c, d),
            Filtered::Unasked => self.open_incircle(f64::NAN, a, b, c, d),
        }
    }

    /// See [`Session::filtered_insphere`](crate::Session::filtered_insphere).
    #[inline(always)]
    pub fn filtered_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Filtered<'s, 3, 5> {
        let at = |v: Vertex| self.points3.get(v.index());
        if !self.insphere_by_query
            && let (Some(a), Some(b), Some(c), Some(d), Some(e)) = (at(a), at(b), at(c), at(d), at(e))
        {
            return filtered::<Insphere, 3, 5>([a, b, c, d, e], self.insphere);
        }
        Filtered::Unasked
    }

    /// See [`Session::decide_insphere`](crate::Session::decide_insphere).
    #[inline]
    pub fn decide_insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> (Sign, usize) {
        match self.filtered_insphere(a, b, c, d, e) {
            Filtered::Settled(sign, stage) => (sign, stage),
            Filtered::Left(determinant, _) => self.open_insphere(determinant, [a, b, c, d, e]),
            Filtered::Unasked if self.insphere_by_query => self.insphere_by_query([a, b, c, d, e]),
            Filtered::Unasked => self.open_insphere(f64::NAN, [a, b, c, d, e]),
        }
    }

    /// See [`Session::turn_of_integers`](crate::Session::turn_of_integers).
    #[inline(always)]
    pub fn turn_of_integers(&self, a: Vertex, b: Vertex, c: Vertex) -> Option<(Sign, [&'s [f64; 2]; 3])> {
        let scale = self.turn_scale[Plane::Xy as usize];
        if scale == 0.0 {
            return None;
        }
        let at = |v: Vertex| self.points2.get(v.index());
        let points = [at(a)?, at(b)?, at(c)?];
        Some((Orient2d::integer(scaled(&points.map(|point| *point), scale), 2), points))
    }
}

#[inline(always)]
fn filtered<P: Predicate<D, N>, const D: usize, const N: usize>(
    points: [&[f64; D]; N],
    static_bound: f64,
) -> Filtered<'_, D, N> {
    let estimate = P::estimate(points.map(|point| *point));
    match estimate.above(static_bound) {
        Some(sign) => Filtered::Settled(sign, stage::STATIC),
        None => Filtered::Left(estimate.determinant, points),
    }
}
