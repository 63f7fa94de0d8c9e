//! Surfaces of triangles in doubles: the solids that other programs answer with, and the operands they get.
//!
//! All that a [`Skin`] says is decided in rationals: windings, distances (rounded once) and volumes. [`candidates`] are
//! points at which solids are worth comparing.

mod distance;
mod pierced;
mod points;
pub mod shells;

use std::collections::BTreeMap;

use rug::Rational;

use crate::boxes::{Boxes, extent};
use crate::rational;
use crate::solids::Boundary;

pub use points::{area, candidates, length};

/// A triangle in doubles.
pub type Corners = [[f64; 3]; 3];

/// A surface of triangles, counterclockwise as seen from outside.
pub struct Skin {
    triangles: Vec<Corners>,
    index: Boxes<3>,
    boundary: Boundary,
}

impl Skin {
    /// A surface with these triangles.
    #[must_use]
    pub fn new(triangles: Vec<Corners>) -> Skin {
        let index = Boxes::new(triangles.iter().map(|&corners| extent(corners)).collect());
        let points = triangles.as_flattened().iter().map(|p| p.map(rational)).collect();
        let separate = (0..).step_by(3).take(triangles.len()).map(|at| [at, at + 1, at + 2]).collect();
        let boundary = Boundary::new(points, separate);
        Skin { triangles, index, boundary }
    }

    /// All triangles.
    #[must_use]
    pub fn triangles(&self) -> &[Corners] {
        &self.triangles
    }

    /// The distance of a point from the nearest triangle, computed in rationals and rounded once; infinite without
    /// triangles. The search begins at a distance.
    #[must_use]
    pub fn distance(&self, p: [f64; 3], from: f64) -> f64 {
        if self.triangles.is_empty() {
            return f64::INFINITY;
        }
        let mut near = Vec::new();
        let mut reach = from.max(f64::MIN_POSITIVE);
        loop {
            self.index.near(&[p, p], reach, &mut near);
            let of = |&at: &u32| distance::of_triangle(&self.triangles[at as usize], p);
            let least = near.iter().map(of).fold(f64::INFINITY, f64::min);
            if least <= reach || near.len() == self.triangles.len() {
                return least;
            }
            reach *= 64.0;
        }
    }

    /// Six times the volume inside.
    #[must_use]
    pub fn six(&self) -> Rational {
        let of = |corners: &Corners| {
            let [a, b, c] = corners.map(|p| p.map(rational));
            let minor = |i: usize, j: usize| Rational::from(&b[i] * &c[j]) - Rational::from(&b[j] * &c[i]);
            Rational::from(&a[0] * &minor(1, 2))
                + Rational::from(&a[1] * &minor(2, 0))
                + Rational::from(&a[2] * &minor(0, 1))
        };
        crate::sum::sum(self.triangles.iter().map(of).collect())
    }

    /// The first edge at which more triangles come than go, in words.
    #[must_use]
    pub fn open(&self) -> Option<String> {
        let key = |p: [f64; 3]| p.map(|x| (x + 0.0).to_bits());
        let mut uses: BTreeMap<[[u64; 3]; 2], i64> = BTreeMap::new();
        for [a, b, c] in &self.triangles {
            for [p, q] in [[a, b], [b, c], [c, a]] {
                let [p, q] = [key(*p), key(*q)];
                if p != q {
                    *uses.entry([p.min(q), p.max(q)]).or_default() += if p < q { 1 } else { -1 };
                }
            }
        }
        let open: Vec<_> = uses.into_iter().filter(|(_, uses)| *uses != 0).collect();
        let ([p, q], _) = open.first()?;
        let [p, q] = [p, q].map(|p| p.map(f64::from_bits));
        Some(format!("{} edges are open, first that from {p:?} to {q:?}", open.len()))
    }

    /// The winding number of the surface around a point: 1 inside of a solid, 0 outside; `None` if the ray of the test
    /// touches the border of a triangle, or the point is on a triangle.
    #[must_use]
    pub fn winding(&self, p: [f64; 3]) -> Option<i64> {
        self.boundary.winding(p)
    }

    /// True for every point within a distance of the surface, and for some that are farther.
    #[must_use]
    pub fn is_near(&self, p: [f64; 3], distance: f64) -> bool {
        self.boundary.is_near(p, distance)
    }

    /// The first edge that passes through a triangle with more than `least` to spare on all sides, in words. At most
    /// `most` triangles, spread evenly, are compared with all near them.
    #[must_use]
    pub fn pierced(&self, least: f64, most: usize) -> Option<String> {
        pierced::first(&self.triangles, &self.index, least, most)
    }
}
