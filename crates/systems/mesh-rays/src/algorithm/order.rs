//! The order of points along a line.
//!
//! The sides of a feature's corners decide most pairs: if all corners of one feature are on one side of the plane in
//! which the line crosses the other, that is the side of the whole feature. Otherwise both points are constructed, and
//! compared. A session that constructs no vertex declines only scenes that need one.

use predicament_predicates::{Axis, Construction, Predicates, Sign, Vertex};

use super::find::{Asking, Cut, Point};
use crate::answer::Feature;

/// The corners of a feature.
pub(super) fn corners(triangles: &[[Vertex; 3]], feature: &Feature) -> Vec<Vertex> {
    match *feature {
        Feature::Vertex(v) => vec![v],
        Feature::Edge(ends) => ends.to_vec(),
        Feature::Face(face) => triangles[face as usize].to_vec(),
    }
}

impl<P: Predicates + ?Sized> Asking<'_, P> {
    /// The order of two points by signs of input vertices: negative if the first one comes first, `None` if these signs
    /// do not decide it.
    pub(super) fn by_signs(&self, triangles: &[[Vertex; 3]], one: &Point, other: &Point) -> Option<Sign> {
        let [of_one, of_other] = [one, other].map(|point| corners(triangles, &point.feature));
        self.beyond(one, &of_other)
            .map(|side| -side)
            .or_else(|| self.beyond(other, &of_one))
            .or_else(|| self.apart(&of_one, &of_other))
    }

    /// The side of a point on which a feature with these corners is, along the line: positive if the feature comes
    /// later, zero if it is at the same place.
    fn beyond(&self, point: &Point, corners: &[Vertex]) -> Option<Sign> {
        let side = |v: Vertex| match point.cut {
            Cut::Vertex(u) => self.order(v, u),
            Cut::Plane(plane, _) if plane.contains(&v) => Sign::Zero,
            Cut::Edge(ends, ..) if ends.contains(&v) => Sign::Zero,
            Cut::Plane([a, b, c], ahead) => self.session.orient3d(a, b, c, v) * ahead,
            Cut::Edge([a, b], plane, ahead) => self.session.orient2d(plane, a, b, v) * ahead,
        };
        if matches!(point.cut, Cut::Vertex(_)) && corners.len() > 1 {
            // A vertex says nothing about corners that are not on the line.
            return None;
        }
        let sides: Vec<Sign> = corners.iter().map(|&v| side(v)).collect();
        match [Sign::Positive, Sign::Negative].map(|sign| sides.contains(&sign)) {
            [true, true] => None,
            [true, false] => Some(Sign::Positive),
            [false, true] => Some(Sign::Negative),
            [false, false] => Some(Sign::Zero),
        }
    }

    /// The order of two features whose boxes are apart along an axis that the line follows.
    fn apart(&self, one: &[Vertex], other: &[Vertex]) -> Option<Sign> {
        let axes = [Axis::X, Axis::Y, Axis::Z].into_iter().zip(self.ahead);
        let mut along = axes.filter(|(_, ahead)| *ahead != Sign::Zero).filter_map(|(axis, ahead)| {
            let mut signs = one.iter().flat_map(|&u| other.iter().map(move |&v| (u, v)));
            let (u, v) = signs.next()?;
            let first = self.session.compare(axis, u, v);
            let agree = first != Sign::Zero && signs.all(|(u, v)| self.session.compare(axis, u, v) == first);
            agree.then_some(first * ahead)
        });
        along.next()
    }

    /// The definition of a point; `None` for a vertex. An edge in one plane with the line takes the first of `others`
    /// that is not in that plane.
    ///
    /// # Errors
    /// If all of `others` are in that plane.
    pub(super) fn definition(&self, point: &Point, others: &[Vertex]) -> Result<Option<Construction>, &'static str> {
        let plane = match point.cut {
            Cut::Vertex(_) => return Ok(None),
            Cut::Plane(plane, _) => plane,
            Cut::Edge([a, b], ..) => {
                let [p, q] = self.ends;
                let is_beside = |v: &&Vertex| self.session.orient3d(p, q, a, **v) != Sign::Zero;
                let v = others.iter().find(is_beside).ok_or("the line and the whole mesh are in one plane")?;
                [a, b, *v]
            }
        };
        Ok(Some(Construction::Lpi { line: self.ends, plane }))
    }
}
