//! Exact values of one pair of simplices.
//!
//! Everything is a polynomial in integers: all coordinates are integers in units of one power of two. Points of the
//! plane are points of space with z = 0.

use crate::answer::Weights;
use predicament_arithmetic::Scaled;
use predicament_error_calculus::vector::{cross, dot, minus, norm_squared};
use predicament_predicates::Dimension;
use rug::{Integer, Rational};

use super::quantity::Quantity;

type Point = [Integer; 3];

/// The kinds of pairs of the hierarchy, in both dimensions.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum PairKind {
    /// Two vertices: Algorithms 2 and 7.
    VertexVertex,
    /// An edge and a vertex: Algorithms 3 and 8.
    EdgeVertex,
    /// Two edges: Algorithms 4 and 9.
    EdgeEdge,
    /// A triangle and a vertex: Algorithms 5 and 10.
    TriangleVertex,
    /// A triangle and an edge: Algorithm 11.
    TriangleEdge,
    /// A tetrahedron and a vertex: Algorithm 12.
    TetrahedronVertex,
}

impl PairKind {
    /// All kinds, the most degenerate first.
    pub const ALL: [PairKind; 6] = [
        PairKind::VertexVertex,
        PairKind::EdgeVertex,
        PairKind::EdgeEdge,
        PairKind::TriangleVertex,
        PairKind::TriangleEdge,
        PairKind::TetrahedronVertex,
    ];

    /// The kind of a pair of these ranks, in either order.
    #[must_use]
    pub fn of(ranks: [u8; 2]) -> Option<PairKind> {
        PairKind::ALL.into_iter().find(|kind| kind.ranks() == [ranks[0].max(ranks[1]), ranks[0].min(ranks[1])])
    }

    /// The ranks, the higher first.
    #[must_use]
    pub const fn ranks(self) -> [u8; 2] {
        match self {
            PairKind::VertexVertex => [0, 0],
            PairKind::EdgeVertex => [1, 0],
            PairKind::EdgeEdge => [1, 1],
            PairKind::TriangleVertex => [2, 0],
            PairKind::TriangleEdge => [2, 1],
            PairKind::TetrahedronVertex => [3, 0],
        }
    }

    /// True if the ranks add up to the dimension of the space: the pair crosses or not, without a tolerance.
    #[must_use]
    pub fn is_top(self, dimension: Dimension) -> bool {
        self.ranks().map(usize::from).iter().sum::<usize>() == dimension.count()
    }

    /// The name, such as `edge-vertex`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            PairKind::VertexVertex => "vertex-vertex",
            PairKind::EdgeVertex => "edge-vertex",
            PairKind::EdgeEdge => "edge-edge",
            PairKind::TriangleVertex => "triangle-vertex",
            PairKind::TriangleEdge => "triangle-edge",
            PairKind::TetrahedronVertex => "tetrahedron-vertex",
        }
    }
}

/// A pair of simplices, the one of higher rank first.
#[derive(Clone, Debug)]
pub struct Pair {
    kind: PairKind,
    dimension: Dimension,
    /// The vertices of the first simplex, then the vertices of the second.
    points: [Point; 5],
    exponent: i32,
}

/// The feet: the closest points of two simplices' carriers, if they are strictly inside both.
#[derive(Clone, Debug)]
pub struct Feet {
    /// The square of the distance.
    pub distance_squared: Quantity,
    /// The numerators of the feet's barycentric coordinates on the first simplex and on the second, all positive.
    numerators: [Vec<Integer>; 2],
    /// The guarded quantities as integers, by the kind.
    pub(super) guarded: Vec<Quantity>,
}

impl Feet {
    /// The barycentric coordinates of the foot on each simplex.
    #[must_use]
    pub fn weights(&self) -> [Vec<Rational>; 2] {
        self.numerators.clone().map(|numerators| {
            let sum: Integer = numerators.iter().sum();
            numerators.into_iter().map(|part| Rational::from((part, sum.clone()))).collect()
        })
    }

    /// The largest difference between these weights and the exact ones, as a double with at most one rounding.
    #[must_use]
    pub fn weight_error(&self, got: &[Weights; 2]) -> f64 {
        let exact = self.weights();
        let errors = exact.iter().zip(got).flat_map(|(exact, got)| {
            exact.iter().zip(got).map(|(exact, &got)| match Rational::from_f64(got) {
                Some(got) => (got - exact).abs().to_f64(),
                None => f64::INFINITY,
            })
        });
        errors.fold(0.0, f64::max)
    }
}

impl Pair {
    /// A pair in the plane or in space, by the points of both simplices.
    ///
    /// # Panics
    /// If the hierarchy does not have such a pair, or a coordinate is not finite.
    #[must_use]
    pub fn new<const D: usize>(first: &[[f64; D]], second: &[[f64; D]]) -> Pair {
        let (first, second) = if first.len() < second.len() { (second, first) } else { (first, second) };
        let rank = |simplex: &[[f64; D]]| u8::try_from(simplex.len() - 1).expect("a simplex has four vertices at most");
        let kind = PairKind::of([rank(first), rank(second)]).expect("a pair of the hierarchy");
        let mut points = [[0.0; 3]; 5];
        for (to, from) in points.iter_mut().zip(first.iter().chain(second)) {
            to[..D].copy_from_slice(from);
        }
        let scaled = Scaled::new(points).expect("coordinates are finite");
        let dimension = if D == 2 { Dimension::Two } else { Dimension::Three };
        Pair { kind, dimension, points: scaled.integers, exponent: scaled.exponent }
    }

    /// The kind of the pair.
    #[must_use]
    pub fn kind(&self) -> PairKind {
        self.kind
    }

    /// The dimension of the pair's space.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// The vertices of both simplices as integers, and the exponent of their unit, a power of two.
    pub(super) fn points(&self) -> ([&Point; 5], i32) {
        (self.points.each_ref(), self.exponent)
    }

    /// True if the pair crosses or not, without a tolerance.
    #[must_use]
    pub fn is_top(&self) -> bool {
        self.kind.is_top(self.dimension)
    }

    /// The feet of the shortest connection between the simplices' carriers.
    ///
    /// `None` if a foot is not strictly inside, or if the shortest connection is not unique (parallel edges, a triangle
    /// without area, an edge without length).
    #[must_use]
    pub fn feet(&self) -> Option<Feet> {
        let [a, b, c, d, e] = &self.points;
        match (self.kind, self.dimension) {
            (PairKind::VertexVertex, _) => Some(Feet {
                distance_squared: Quantity::integer(norm_squared(&minus(a, b)), 2 * self.exponent),
                numerators: [vec![1.into()], vec![1.into()]],
                guarded: vec![],
            }),
            (PairKind::EdgeVertex, _) => self.edge_vertex([a, b], c),
            (PairKind::EdgeEdge, Dimension::Two) => {
                let of_ab = [area(a, c, d), area(b, c, d)];
                let of_cd = [area(c, a, b), area(d, a, b)];
                let [on_ab, on_cd] = [crossing(&of_ab)?, crossing(&of_cd)?];
                self.crossing([on_ab, on_cd], of_ab.into_iter().chain(of_cd), 2)
            }
            (PairKind::TriangleVertex, Dimension::Two) => {
                let areas = [area(d, b, c), area(a, d, c), area(a, b, d)];
                self.crossing([inside(&areas)?, vec![1.into()]], areas, 2)
            }
            (PairKind::EdgeEdge, Dimension::Three) => self.edge_edge([a, b], [c, d]),
            (PairKind::TriangleVertex, Dimension::Three) => self.triangle_vertex([a, b, c], d),
            (PairKind::TriangleEdge, _) => {
                let around = [volume(b, c, d, e), volume(c, a, d, e), volume(a, b, d, e)];
                let ends = [volume(a, b, c, d), volume(a, b, c, e)];
                self.crossing([inside(&around)?, crossing(&ends)?], around.into_iter().chain(ends), 3)
            }
            (PairKind::TetrahedronVertex, _) => {
                let volumes = [volume(e, b, c, d), volume(a, e, c, d), volume(a, b, e, d), volume(a, b, c, e)];
                self.crossing([inside(&volumes)?, vec![1.into()]], volumes, 3)
            }
        }
    }

    /// The squared distance between the two closed simplices.
    ///
    /// It is the distance between the feet, if they are inside, otherwise that between a face of the one and the other.
    #[must_use]
    pub fn distance_squared(&self) -> Rational {
        if let Some(feet) = self.feet() {
            return feet.distance_squared.value();
        }
        let nearest = self.facets().iter().map(Pair::distance_squared).min();
        nearest.expect("two vertices have feet")
    }

    /// The pairs of one simplex with a facet of the other, through which the feet leave the pair; two vertices have
    /// none.
    #[must_use]
    pub fn facets(&self) -> Vec<Pair> {
        let [first, second] = self.kind.ranks().map(|rank| usize::from(rank) + 1);
        let [s, t] = [&self.points[..first], &self.points[first..first + second]];
        let without = |simplex: &[Point], at: usize| {
            let mut face = simplex.to_vec();
            face.remove(at);
            face
        };
        let of_s = (0..s.len()).filter(|_| s.len() > 1).map(|at| self.of(&without(s, at), t));
        let of_t = (0..t.len()).filter(|_| t.len() > 1).map(|at| self.of(s, &without(t, at)));
        of_s.chain(of_t).collect()
    }

    /// The pairs of a face of the one with a face of the other, not both the whole: if one of them is registered, the
    /// pair has ended.
    pub fn sub_pairs(&self) -> impl Iterator<Item = Pair> {
        let [first, second] = self.kind.ranks().map(|rank| usize::from(rank) + 1);
        let [s, t] = [&self.points[..first], &self.points[first..first + second]];
        let chosen = |simplex: &[Point], bits: u32| -> Vec<Point> {
            let points = simplex.iter().enumerate();
            points.filter(|(i, _)| bits >> i & 1 == 1).map(|(_, point)| point.clone()).collect()
        };
        let [all_s, all_t] = [(1_u32 << first) - 1, (1_u32 << second) - 1];
        let pairs = (1..=all_s).flat_map(move |of_s| (1..=all_t).map(move |of_t| [of_s, of_t]));
        pairs
            .filter(move |&pair| pair != [all_s, all_t])
            .map(move |[of_s, of_t]| self.of(&chosen(s, of_s), &chosen(t, of_t)))
    }

    /// A pair of faces, in the same unit.
    fn of(&self, s: &[Point], t: &[Point]) -> Pair {
        let (s, t) = if s.len() < t.len() { (t, s) } else { (s, t) };
        let rank = |simplex: &[Point]| u8::try_from(simplex.len() - 1).expect("four vertices at most");
        let mut points: [Point; 5] = Default::default();
        for (to, from) in points.iter_mut().zip(s.iter().chain(t)) {
            to.clone_from(from);
        }
        let kind = PairKind::of([rank(s), rank(t)]).expect("faces of a pair are a pair");
        Pair { kind, dimension: self.dimension, points, exponent: self.exponent }
    }

    /// The feet of a proper crossing: the distance is zero.
    fn crossing(
        &self,
        numerators: [Vec<Integer>; 2],
        guarded: impl IntoIterator<Item = Integer>,
        degree: i32,
    ) -> Option<Feet> {
        Some(Feet {
            distance_squared: Quantity::integer(Integer::new(), 0),
            numerators,
            guarded: guarded.into_iter().map(|x| Quantity::integer(x.square(), 2 * degree * self.exponent)).collect(),
        })
    }

    /// The feet of an edge and a vertex; guarded are â² and ā².
    fn edge_vertex(&self, [a, b]: [&Point; 2], p: &Point) -> Option<Feet> {
        let (u, w) = (minus(b, a), minus(p, a));
        let m_squared = norm_squared(&u);
        let forward = dot(&u, &w);
        let back = Integer::from(&m_squared - &forward);
        if !(forward.is_positive() && back.is_positive()) {
            return None;
        }
        let exponent = 2 * self.exponent;
        let over_m = |along: &Integer| Quantity {
            numerator: Integer::from(along.square_ref()),
            denominator: m_squared.clone(),
            exponent,
        };
        let guarded = vec![over_m(&forward), over_m(&back)];
        let distance = norm_squared(&w) * &m_squared - Integer::from(forward.square_ref());
        Some(Feet {
            distance_squared: Quantity { numerator: distance, denominator: m_squared, exponent },
            numerators: [vec![back, forward], vec![1.into()]],
            guarded,
        })
    }

    /// The feet of two edges; guarded are m², then â, b̂, ā and b̄.
    fn edge_edge(&self, [a, b]: [&Point; 2], [p, q]: [&Point; 2]) -> Option<Feet> {
        let (u, v, w) = (minus(b, a), minus(q, p), minus(p, a));
        let r = cross(&u, &v);
        let m_squared = norm_squared(&r);
        let on_ab = dot(&cross(&w, &v), &r);
        let on_pq = dot(&cross(&w, &u), &r);
        let [to_b, to_q] = [&on_ab, &on_pq].map(|on| Integer::from(&m_squared - on));
        let parts = [on_ab, on_pq, to_b, to_q];
        if !parts.iter().all(Integer::is_positive) {
            return None;
        }
        let guarded = self.squared(&m_squared, &parts);
        let [on_ab, on_pq, to_b, to_q] = parts;
        Some(Feet {
            distance_squared: self.height(&r, &w, m_squared),
            numerators: [vec![to_b, on_ab], vec![to_q, on_pq]],
            guarded,
        })
    }

    /// The feet of a triangle and a vertex; guarded are m², then â, b̂ and ĉ.
    fn triangle_vertex(&self, [a, b, c]: [&Point; 3], p: &Point) -> Option<Feet> {
        let (u, v, w) = (minus(b, a), minus(c, a), minus(p, a));
        let r = cross(&u, &v);
        let m_squared = norm_squared(&r);
        let of_b = dot(&cross(&w, &v), &r);
        let of_c = dot(&cross(&u, &w), &r);
        let of_a = Integer::from(&m_squared - &of_b) - &of_c;
        let parts = [of_a, of_b, of_c];
        if !parts.iter().all(Integer::is_positive) {
            return None;
        }
        let guarded = self.squared(&m_squared, &parts);
        Some(Feet {
            distance_squared: self.height(&r, &w, m_squared),
            numerators: [parts.to_vec(), vec![1.into()]],
            guarded,
        })
    }

    /// The squared height (r · w)² / ‖r‖².
    fn height(&self, r: &Point, w: &Point, m_squared: Integer) -> Quantity {
        Quantity { numerator: dot(r, w).square(), denominator: m_squared, exponent: 2 * self.exponent }
    }

    /// The squares of m² and of the weights times m².
    fn squared(&self, m_squared: &Integer, parts: &[Integer]) -> Vec<Quantity> {
        let square = |x: &Integer| Quantity::integer(Integer::from(x.square_ref()), 8 * self.exponent);
        std::iter::once(m_squared).chain(parts).map(square).collect()
    }
}

/// The weights of two ends with values of strictly opposite signs.
fn crossing([from, to]: &[Integer; 2]) -> Option<Vec<Integer>> {
    let opposite = Integer::from(from * to).is_negative();
    opposite.then(|| vec![to.clone().abs(), from.clone().abs()])
}

/// The weights of values that are strictly of one sign.
fn inside<const N: usize>(values: &[Integer; N]) -> Option<Vec<Integer>> {
    let one_sign = values.iter().all(Integer::is_positive) || values.iter().all(Integer::is_negative);
    one_sign.then(|| values.iter().map(|value| value.clone().abs()).collect())
}

/// Twice the signed area in the plane.
pub(super) fn area(p: &Point, q: &Point, r: &Point) -> Integer {
    let [[ax, ay, _], [bx, by, _]] = [minus(q, p), minus(r, p)];
    ax * by - ay * bx
}

/// Six times the signed volume.
pub(super) fn volume(a: &Point, b: &Point, c: &Point, d: &Point) -> Integer {
    dot(&cross(&minus(a, d), &minus(b, d)), &minus(c, d))
}

#[cfg(test)]
mod tests;
