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
//! Components and Euler characteristics are judged in [`shells`](super::shells).
//!
//! The points are an even sample: beside triangles of both operands and of the result, on both sides and at several
//! distances, and anywhere. Where a point is, is decided exactly: points, operands and results are doubles.

use predicament_judge::skin::{self, Corners, Skin};
use predicament_overlay::answer::Operation;
use rug::Rational;

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
    /// The triangles of both surfaces, for distances.
    both: Skin,
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
        let both = Skin::new(skins.iter().flat_map(Skin::triangles).copied().collect());
        let area = both.triangles().iter().map(skin::area).sum();
        let length = both.triangles().iter().map(skin::length).sum();
        Solids { skins, both, area, length }
    }

    /// Both operands.
    #[must_use]
    pub fn operands(&self) -> [&Skin; 2] {
        self.skins.each_ref()
    }

    /// The largest distance of a result's vertex from the operands' surfaces; zero without vertices.
    #[must_use]
    pub fn farthest(&self, vertices: &[[f64; 3]], nearest: f64) -> f64 {
        vertices.iter().map(|&p| self.both.distance(p, nearest)).fold(0.0, f64::max)
    }

    /// At most `most` points beside these triangles, farther than `within` from both surfaces.
    fn witnesses<'t>(
        &self,
        beside: impl Iterator<Item = &'t Corners> + Clone,
        [within, coarsest]: [f64; 2],
        most: usize,
    ) -> Vec<Witness> {
        let candidates = skin::candidates(beside, [within, coarsest], most);
        let far = |p: &[f64; 3]| !self.skins.iter().any(|skin| skin.is_near(*p, within));
        let located = |p: [f64; 3]| {
            let [a, b] = &self.skins;
            Some((p, [a.winding(p)? > 0, b.winding(p)? > 0]))
        };
        candidates.into_iter().filter(far).filter_map(located).collect()
    }

    /// Points beside the operands' surfaces, farther than the first distance from them, some farther than the second:
    /// see [`Solids::violations`].
    #[must_use]
    pub fn points(&self, within: [f64; 2], most: usize) -> Vec<Witness> {
        self.witnesses(self.skins.iter().flat_map(Skin::triangles), within, most)
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
        let own = self.witnesses(result.triangles().iter(), [within, coarsest], most);
        let (mut wrong, mut first) = (0, None::<Wrong>);
        for &(p, inside) in known.iter().chain(&own) {
            let wanted = i64::from(operation.holds(inside));
            if let Some(winding) = result.winding(p).filter(|winding| *winding != wanted) {
                wrong += 1;
                let distance = self.both.distance(p, within);
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
        if let Some(what) = result.pierced(within, most) {
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
