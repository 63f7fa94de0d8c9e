//! Checks of Boolean operations on solids that other programs compute, in doubles.
//!
//! A program's vertices are rounded, so its result is compared with the operands at a distance, `within`, which is that
//! of its farthest vertex from the operands' surfaces, and at least that of a few roundings.
//!
//! * `vertex off the surfaces`: each vertex is within that distance of a triangle of an operand.
//! * `open surface`: at each edge, as many triangles come as go. Vertices at one place are one vertex here.
//! * `wrong solid`: the surface goes once around a point that is farther than that from both operands' surfaces, if the
//!   operation says that the point is inside, and otherwise not around it.
//! * `crossing triangles`: no edge of the result passes through a triangle by more than the distance.
//! * `wrong volume`: union and intersection have the volumes of both operands together, and difference and intersection
//!   that of the first, up to the volume of the operands' surfaces widened by the distance.
//!
//! The true result's boundary is a part of the operands' surfaces. A surface whose vertices are within δ of where they
//! belong is within δ of the true one, because the distance of two triangles is largest at their corners. So the result
//! differs from the true one only within δ of it, and that is all that the checks demand.
//!
//! The points are an even sample: beside triangles of both operands and of the result, on both sides and at several
//! distances, and anywhere. Where a point is, is decided exactly: points, operands and results are doubles.

mod distance;
mod pierced;
mod points;

use std::collections::BTreeMap;

use predicament_judge::boxes::{Boxes, extent};
use predicament_judge::rational;
use predicament_judge::solids::Boundary;
use predicament_overlay::answer::Operation;
use rug::Rational;

/// A triangle in doubles.
pub type Corners = [[f64; 3]; 3];

/// The check of vertices.
pub const OFF: &str = "vertex off the surfaces";
/// The check of edges.
pub const OPEN: &str = "open surface";
/// The check of points.
pub const SOLID: &str = "wrong solid";
/// The check of triangles that pass through each other.
pub const CROSSING: &str = "crossing triangles";
/// The check of volumes.
pub const VOLUME: &str = "wrong volume";

/// A violation of a law.
#[derive(Clone, PartialEq, Debug)]
pub struct Violation {
    /// The name of the check.
    pub check: &'static str,
    /// The first place, in words.
    pub what: String,
    /// The distance from the operands' surfaces that explains it; `None` if no distance does.
    pub distance: Option<f64>,
}

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
        let boundary = Boundary::new(triangles.iter().map(|corners| corners.map(|p| p.map(rational))).collect());
        Skin { triangles, index, boundary }
    }

    /// All triangles.
    #[must_use]
    pub fn triangles(&self) -> &[Corners] {
        &self.triangles
    }

    /// The distance of a point from the nearest triangle, computed in rationals and rounded once; infinite without
    /// triangles. The search begins at a distance.
    fn distance(&self, p: [f64; 3], from: f64) -> f64 {
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
    fn six(&self) -> Rational {
        let of = |corners: &Corners| {
            let [a, b, c] = corners.map(|p| p.map(rational));
            let minor = |i: usize, j: usize| Rational::from(&b[i] * &c[j]) - Rational::from(&b[j] * &c[i]);
            Rational::from(&a[0] * &minor(1, 2))
                + Rational::from(&a[1] * &minor(2, 0))
                + Rational::from(&a[2] * &minor(0, 1))
        };
        predicament_judge::sum::sum(self.triangles.iter().map(of).collect())
    }

    /// The first edge at which more triangles come than go, in words.
    fn open(&self) -> Option<String> {
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
}

/// A point around which a result's surface goes another number of times than it should.
struct Wrong {
    p: [f64; 3],
    winding: i64,
    wanted: i64,
    distance: f64,
}

/// Two solids.
pub struct Solids {
    skins: [Skin; 2],
    /// The area of both surfaces, and the length of all edges.
    area: f64,
    length: f64,
}

/// A point with true for each operand that contains it.
pub type Witness = ([f64; 3], [bool; 2]);

impl Solids {
    /// Two operands by their surfaces.
    #[must_use]
    pub fn new(skins: [Skin; 2]) -> Solids {
        let all = || skins.iter().flat_map(|skin| &skin.triangles);
        let area = all().map(points::area).sum();
        let length = all().map(points::length).sum();
        Solids { skins, area, length }
    }

    /// The largest distance of a result's vertex from the operands' surfaces; zero without vertices.
    #[must_use]
    pub fn farthest(&self, vertices: &[[f64; 3]], nearest: f64) -> f64 {
        let of = |&p: &[f64; 3]| self.skins.iter().map(|skin| skin.distance(p, nearest)).fold(f64::INFINITY, f64::min);
        vertices.iter().map(of).fold(0.0, f64::max)
    }

    /// At most `most` points beside these triangles, farther than `within` from both surfaces.
    fn witnesses<'t>(
        &self,
        beside: impl Iterator<Item = &'t Corners> + Clone,
        [within, coarsest]: [f64; 2],
        most: usize,
    ) -> Vec<Witness> {
        let candidates = points::candidates(beside, [within, coarsest], most);
        let far = |p: &[f64; 3]| !self.skins.iter().any(|skin| skin.boundary.is_near(*p, within));
        let located = |p: [f64; 3]| {
            let [a, b] = &self.skins;
            Some((p, [a.boundary.winding(p)? > 0, b.boundary.winding(p)? > 0]))
        };
        candidates.into_iter().filter(far).filter_map(located).collect()
    }

    /// Points beside the operands' surfaces, farther than the first distance from them, some farther than the second:
    /// see [`Solids::violations`].
    #[must_use]
    pub fn points(&self, within: [f64; 2], most: usize) -> Vec<Witness> {
        self.witnesses(self.skins.iter().flat_map(|skin| &skin.triangles), within, most)
    }

    /// The laws that the result of an operation violates at this distance; `most` is the number of points beside the
    /// result's own triangles, and of edges that are tested for crossings.
    #[must_use]
    pub fn violations(
        &self,
        operation: Operation,
        result: &Skin,
        [within, coarsest]: [f64; 2],
        known: &[Witness],
        most: usize,
    ) -> Vec<Violation> {
        let mut found = Vec::new();
        if let Some(what) = result.open() {
            found.push(Violation { check: OPEN, what, distance: None });
        }
        let own = self.witnesses(result.triangles.iter(), [within, coarsest], most);
        let (mut wrong, mut first) = (0, None::<Wrong>);
        for &(p, inside) in known.iter().chain(&own) {
            let wanted = i64::from(operation.holds(inside));
            if let Some(winding) = result.boundary.winding(p).filter(|winding| *winding != wanted) {
                wrong += 1;
                let distance = self.skins.iter().map(|skin| skin.distance(p, within)).fold(f64::INFINITY, f64::min);
                if first.as_ref().is_none_or(|first| distance > first.distance) {
                    first = Some(Wrong { p, winding, wanted, distance });
                }
            }
        }
        if let Some(Wrong { p, winding, wanted, distance }) = first {
            let of = known.len() + own.len();
            let what =
                format!("the surface goes {winding} times around {p:?}, expected {wanted}; {wrong} of {of} points");
            found.push(Violation { check: SOLID, what, distance: Some(distance) });
        }
        if let Some(what) = pierced::first(&result.triangles, &result.index, within, most) {
            found.push(Violation { check: CROSSING, what, distance: None });
        }
        found
    }

    /// The laws of volumes that the results violate; the results are in the order of [`Operation::ALL`], `None` where a
    /// program has left one out. Each has its own distance.
    #[must_use]
    pub fn volumes(&self, results: [Option<(&Skin, f64)>; 4]) -> Vec<Violation> {
        let [first, second] = self.skins.each_ref().map(Skin::six);
        let [union, both, difference, _] = results;
        let six = |skin: Option<(&Skin, f64)>| skin.map(|(skin, within)| (skin.six(), within));
        let (union, both, difference) = (six(union), six(both), six(difference));
        let mut found = Vec::new();
        let mut law = |one: &Option<(Rational, f64)>, other: &Option<(Rational, f64)>, wanted: Rational, what: &str| {
            let (Some((one, w)), Some((other, v))) = (one, other) else { return };
            let within = w.max(*v);
            let off = (Rational::from(one + other) - wanted).abs().to_f64() / 6.0;
            let discs = 16.0 * self.length * within * within;
            let allowed = 4.0 * self.area * within + discs * (1.0 + within / self.length.max(f64::MIN_POSITIVE));
            if off > allowed {
                let what = format!("{what} are {off:e} off; rounding explains {allowed:.1e}");
                found.push(Violation { check: VOLUME, what, distance: Some(off / (2.0 * self.area)) });
            }
        };
        let sum = Rational::from(&first + &second);
        law(&union, &both, sum, "the volumes of union and intersection together");
        law(&difference, &both, first, "the volumes of difference and intersection together");
        found
    }
}
