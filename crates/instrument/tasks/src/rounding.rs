//! Errors of rounded vertices, and the violated laws that they excuse.
//!
//! A session that keeps constructed vertices as doubles cannot represent them exactly. Then a cap is off its plane, and
//! areas add up to a little less, though each sign may be right. Such a finding has the class [`Class::Rounded`], not
//! [`Class::Topology`], if all of this holds:
//!
//! 1. The law is metric: it is about distances, areas or volumes. A reversed triangle, an open surface or two crossing
//!    edges are never excused, even if rounding caused them.
//! 2. The law holds for the same answer with each vertex at its exact position, which is the rational point of its
//!    definition.
//! 3. Each coordinate of each constructed vertex is at most [`BOUND`] units from there.
//!
//! # The unit
//! The unit of a vertex is the unit in the last place of the largest coordinate, along any axis, of the input vertices
//! that define it, directly or through other constructed vertices. The arithmetic has worked with these numbers: a
//! coordinate near zero between points far from it is a difference of large numbers, and arithmetic in doubles could
//! not keep its last place. The largest coordinate of the scene would be simpler, but one far point would excuse gross
//! errors everywhere.
//!
//! # The bound
//! The nearest doubles are off by half a unit at most. Four units are eight times that. This allows two or three
//! roundings on the way, as x + t·(y − x) with a well-conditioned t has them, but not a division by a number that is
//! mostly error.
//!
//! If each of d coordinates is off by at most K units of size u, a vertex is at most δ = √d·K·u from its exact
//! position. The law holds at the exact positions, so the excused error is bounded, too:
//!
//! * A vertex is at most δ off its plane or segment, and at most δ beyond a plane.
//! * A region with a boundary of length p has an area that is at most pδ + nπδ² off, for n corners: all changes are
//!   within δ of the boundary.
//! * A solid with a surface of area A and edges of length p together has a volume that is at most Aδ + πpδ² + 4nπδ³/3
//!   off, for the same reason.
//!
//! All decisions use rationals; only reported numbers are rounded.

use predicament_judge::{Points, nearest, rational};
use predicament_predicates::{Construction, Scene, Vertex};
use rug::Rational;

use crate::Class;

/// The maximum error of each coordinate of a vertex, in units, for the class `Rounded`.
pub const BOUND: u32 = 4;

/// The exact positions of rounded vertices.
pub struct Rounding<const D: usize> {
    /// The exact positions, in the order of the vertices; a vertex that is not a point keeps its rounded position.
    pub exact: Vec<[Rational; D]>,
    /// The vertex with the largest error, in its units; the error is `None` if the vertex is not a point.
    worst: Option<(Vertex, Option<Rational>)>,
}

impl<const D: usize> Rounding<D> {
    /// Compares vertices of a scene with their rounded positions, which have finite coordinates.
    pub fn new(scene: &Scene, rounded: impl IntoIterator<Item = (Vertex, [f64; D])>) -> Rounding<D> {
        let (points, largest) = (Points::of(scene), largest(scene));
        let mut all = Rounding { exact: Vec::new(), worst: None };
        for (v, rounded) in rounded {
            let Some(index) = v.construction() else {
                all.exact.push(rounded.map(rational));
                continue;
            };
            let exact = points.point(v).and_then(|point| <[Rational; D]>::try_from(point.into_owned()).ok());
            let off = exact.as_ref().map(|exact| {
                let off = exact.iter().zip(rounded).map(|(exact, x)| (rational(x) - exact).abs());
                off.max().unwrap_or_default() / rational(last_place(largest[index]))
            });
            let is_worse = match (&all.worst, &off) {
                (None, _) => true,
                (Some((_, None)), _) => false,
                (Some((_, Some(_))), None) => true,
                (Some((_, Some(worst))), Some(off)) => off > worst,
            };
            if is_worse {
                all.worst = Some((v, off));
            }
            all.exact.push(exact.unwrap_or_else(|| rounded.map(rational)));
        }
        all
    }

    /// Compares the vertices that these definitions add to a scene with their rounded positions.
    pub fn of_definitions(scene: &Scene, definitions: &[Construction], rounded: &[[f64; D]]) -> Rounding<D> {
        let (scene, vertices) = defined(scene, definitions);
        Rounding::new(&scene, vertices.into_iter().zip(rounded.iter().copied()))
    }

    /// True if all vertices are within the bound.
    pub fn is_within(&self) -> bool {
        self.worst.as_ref().is_none_or(|(_, off)| off.as_ref().is_some_and(|off| *off <= BOUND))
    }

    /// The class of a violated metric law, and the reason, as the end of the finding's text.
    pub fn class(&self, holds_exactly: bool) -> (Class, String) {
        let class = if holds_exactly && self.is_within() { Class::Rounded } else { Class::Topology };
        let far = match &self.worst {
            None => "no vertex is rounded".to_owned(),
            Some((v, None)) => format!("{v} is not a point, exactly"),
            Some((v, Some(off))) => format!("{v} has the largest error, {}; bound {BOUND} ulp", told(off)),
        };
        let more = if holds_exactly { "" } else { "; also violated with vertices at their exact positions" };
        (class, format!("{far}{more}"))
    }
}

/// The rounding errors of an answer, and the laws that they do not excuse.
pub struct Excuse<const D: usize, L> {
    /// The errors of the vertices.
    pub rounding: Rounding<D>,
    /// The metric laws that are also violated with vertices at their exact positions.
    pub violated: Vec<L>,
}

impl<const D: usize, L: PartialEq> Excuse<D, L> {
    /// The class of a violated law, and the finding's text. Only a metric law has an excuse.
    pub fn judged(excuse: Option<&Excuse<D, L>>, law: &L, told: String) -> (Class, String) {
        let Some(Excuse { rounding, violated }) = excuse else { return (Class::Topology, told) };
        let (class, why) = rounding.class(!violated.contains(law));
        (class, format!("{told}; {why}"))
    }
}

/// An error in units, and as a fraction of the largest coordinate.
fn told(off: &Rational) -> String {
    let off = nearest(off);
    if off < 1e4 { format!("{off:.2} ulp") } else { format!("{off:.1e} ulp") }
}

/// A scene with these definitions, and the vertices that they define.
fn defined(scene: &Scene, definitions: &[Construction]) -> (Scene, Vec<Vertex>) {
    let mut scene = scene.clone();
    let vertices = definitions.iter().map_while(|&definition| scene.construct(definition).ok()).collect();
    (scene, vertices)
}

/// For each construction, the largest absolute coordinate of the input vertices that define it.
fn largest(scene: &Scene) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::with_capacity(scene.constructions().len());
    for definition in scene.constructions() {
        let of = |v: &Vertex| match v.construction() {
            Some(earlier) => all.get(earlier).copied().unwrap_or(0.0),
            None => scene.point(*v).iter().fold(0.0_f64, |largest, x| largest.max(x.abs())),
        };
        let largest = definition.flats().flatten().map(of).fold(0.0, f64::max);
        all.push(largest);
    }
    all
}

/// The unit in the last place of a nonnegative number.
pub(crate) fn last_place(x: f64) -> f64 {
    let next = x.next_up();
    if next.is_finite() { next - x } else { x - x.next_down() }
}

/// The doubles nearest to the vertices that these definitions add to a scene, with each coordinate of the first vertex
/// moved; for planted faults. `None` if a vertex is not a point, or there are none.
pub fn spoiled<const D: usize>(
    scene: &Scene,
    definitions: &[Construction],
    moved: impl Fn(f64) -> f64,
) -> Option<Vec<[f64; D]>> {
    let (scene, vertices) = defined(scene, definitions);
    let points = Points::of(&scene);
    let rounded = |&v: &Vertex| {
        let point = points.point(v)?.iter().map(nearest).collect::<Vec<f64>>();
        <[f64; D]>::try_from(point).ok()
    };
    let mut all: Vec<[f64; D]> = vertices.iter().map(rounded).collect::<Option<_>>()?;
    let first = all.first_mut()?;
    *first = first.map(moved);
    Some(all)
}

/// The next double above the coordinate, which rounding explains.
pub fn one_place(x: f64) -> f64 {
    x.next_up()
}

/// The coordinate moved by a thousandth of itself, which rounding does not explain.
pub fn far(x: f64) -> f64 {
    if x == 0.0 { 1e-3 } else { x * 1.001 }
}

#[cfg(test)]
mod tests {
    use predicament_predicates::{Construction::Ssi, Dimension};

    use super::*;

    /// Two segments that cross in (1/3, 1/3), and a point far away from them.
    fn scene() -> (Scene, Vertex) {
        let coordinates = [[0.0, 0.0], [1.0, 1.0], [0.0, 0.5], [1.0, 0.0], [1e9, 1e9]];
        let mut scene = Scene::new(Dimension::Two, coordinates.as_flattened().to_vec()).unwrap();
        let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
        let v = scene.construct(Ssi([[a, b], [c, d]])).unwrap();
        (scene, v)
    }

    #[test]
    fn a_vertex_within_the_bound_is_rounded_and_one_beyond_is_not() {
        let (scene, v) = scene();
        let third = 1.0 / 3.0;
        let unit = f64::EPSILON;
        let at = |steps: f64| Rounding::new(&scene, [(v, [third + steps * unit, third])]);
        // The unit is that of 1.0, the largest coordinate of a definition: not that of a third, nor that of the far
        // point.
        for (steps, is_within) in [(0.0, true), (1.0, true), (-3.75, true), (4.25, false), (-1e6, false)] {
            let rounding = at(steps);
            assert_eq!(rounding.is_within(), is_within, "{steps}");
            let class = if is_within { Class::Rounded } else { Class::Topology };
            assert_eq!(rounding.class(true).0, class, "{steps}");
            assert_eq!(rounding.class(false).0, Class::Topology, "what is wrong exactly is not rounded");
        }
        assert_eq!(at(1.0).class(true).1, "c0 has the largest error, 0.92 ulp; bound 4 ulp");
        assert_eq!(at(0.0).exact, [[(1, 3), (1, 3)].map(Rational::from)]);
    }

    #[test]
    fn a_vertex_without_a_place_is_never_rounded() {
        let (mut scene, v) = scene();
        let [a, b, far] = [0, 1, 4].map(Vertex::input);
        let parallel = scene.construct(Ssi([[a, b], [b, far]])).unwrap();
        let third = [1.0 / 3.0; 2];
        let rounding = Rounding::new(&scene, [(v, third), (parallel, [5.0, 5.0]), (a, [0.0, 0.0])]);
        assert!(!rounding.is_within());
        assert_eq!(rounding.class(true), (Class::Topology, format!("{parallel} is not a point, exactly")));
        assert_eq!(rounding.exact.len(), 3);
    }

    #[test]
    fn the_unit_goes_through_constructed_vertices() {
        let (mut scene, v) = scene();
        let again = scene.construct(Ssi([[Vertex::input(2), v], [Vertex::input(4), Vertex::input(1)]])).unwrap();
        assert_eq!(largest(&scene), [1.0, 1e9]);
        assert_eq!(again.construction(), Some(1));
        assert_eq!(
            [1.0, 1.5, 2.0, 0.0, f64::MAX].map(last_place).map(f64::log2),
            [-52.0, -52.0, -51.0, -1074.0, 971.0]
        );
    }
}
