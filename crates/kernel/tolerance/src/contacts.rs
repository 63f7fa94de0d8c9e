//! Contact queries of a session: the paper's algorithms on pairs of a scene's simplices.

use predicament_predicates::{Band, Declined, Dimension, Scene, Vertex};

use crate::algorithms::{as_printed, plane, space};
use crate::{Float, Tolerances2d, Tolerances3d};

/// The form of Algorithms 3 and 8.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum EdgeVertex {
    /// The corrected form, û = B − A.
    Corrected,
    /// The printed form, û = A − B.
    AsPrinted,
}

/// The tolerances of Algorithm 1 or 6 for the two meshes of a scene.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ContactTolerances<F = f64> {
    /// The tolerances of a 2D scene.
    Plane(Tolerances2d<F>),
    /// The tolerances of a 3D scene.
    Space(Tolerances3d<F>),
}

impl<F: Float> ContactTolerances<F> {
    /// The tolerances for the scene's primitive lengths.
    ///
    /// # Errors
    /// [`Declined`] if the scene has no lengths, or if `F` cannot represent the intermediate values.
    pub fn new(scene: &Scene) -> Result<ContactTolerances<F>, Declined> {
        let lengths = scene.primitive_lengths().ok_or_else(|| {
            Declined::scene(
                "tolerances for contacts are made from the lengths of both meshes' primitives, and the scene has none",
            )
        })?;
        let [la, lb] = lengths.map(F::above);
        Ok(match scene.dimension() {
            Dimension::Two => {
                let tolerances = Tolerances2d::from_lengths(la, lb);
                tolerances.check_range()?;
                ContactTolerances::Plane(tolerances)
            }
            Dimension::Three => {
                let tolerances = Tolerances3d::from_lengths(la, lb);
                tolerances.check_range()?;
                ContactTolerances::Space(tolerances)
            }
        })
    }

    /// L: an upper bound of all coordinate differences within a pair that is nearer than σ₊.
    #[must_use]
    pub fn length(&self) -> F {
        match self {
            ContactTolerances::Plane(tolerances) => tolerances.length,
            ContactTolerances::Space(tolerances) => tolerances.length,
        }
    }

    /// All tolerances of Figure 1 or 5, by the paper's symbols.
    #[must_use]
    pub fn bands(&self) -> Vec<(&'static str, Band)> {
        match *self {
            ContactTolerances::Plane(tolerances) => tolerances.bands().to_vec(),
            ContactTolerances::Space(tolerances) => tolerances.bands().to_vec(),
        }
    }

    /// The tolerance that is a distance, by the ranks of a pair: σ, τ, and in space δ or γ.
    #[must_use]
    pub fn band(&self, ranks: [u8; 2]) -> Option<Band> {
        let ranks = [ranks[0].min(ranks[1]), ranks[0].max(ranks[1])];
        match (self, ranks) {
            (ContactTolerances::Plane(tolerances), [0, 0]) => Some(tolerances.sigma),
            (ContactTolerances::Plane(tolerances), [0, 1]) => Some(tolerances.tau),
            (ContactTolerances::Space(tolerances), [0, 0]) => Some(tolerances.sigma),
            (ContactTolerances::Space(tolerances), [0, 1]) => Some(tolerances.tau),
            (ContactTolerances::Space(tolerances), [0, 2]) => Some(tolerances.delta),
            (ContactTolerances::Space(tolerances), [1, 1]) => Some(tolerances.gamma),
            _ => None,
        }
    }
}

/// The pairs of simplices of one scene.
///
/// A pair whose points are further apart along an axis than L is never registered, and nothing is computed about it. L
/// holds both primitives with σ₊ between them, so such points are further apart than every tolerance. That keeps the
/// algorithms within their proved and checked range. If all primitives are points (L = 0) only equal points are
/// registered.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pairs<'a, F> {
    pub(crate) scene: &'a Scene,
    pub(crate) tolerances: &'a ContactTolerances<F>,
    pub(crate) form: EdgeVertex,
}

/// The points of both simplices, in the plane or in space.
enum Points<F, const N: usize, const M: usize> {
    Plane([[F; 2]; N], [[F; 2]; M]),
    Space([[F; 3]; N], [[F; 3]; M]),
}

impl<F: Float> Pairs<'_, F> {
    pub(crate) fn vertex_vertex(&self, a: Vertex, p: Vertex) -> bool {
        let Some(points) = self.points([a], [p]) else { return false };
        match (self.tolerances, points) {
            (ContactTolerances::Plane(t), Points::Plane([a], [p])) => plane::vertex_vertex(t, &a, &p),
            (ContactTolerances::Space(t), Points::Space([a], [p])) => space::vertex_vertex(t, &a, &p),
            _ => unreachable!("points are of the scene's dimension"),
        }
    }

    pub(crate) fn edge_vertex(&self, edge: [Vertex; 2], p: Vertex) -> Option<f64> {
        let weight = match (self.tolerances, self.points(edge, [p])?, self.form) {
            (ContactTolerances::Plane(t), Points::Plane(ab, [p]), EdgeVertex::Corrected) => {
                plane::edge_vertex(t, &ab, &p)
            }
            (ContactTolerances::Space(t), Points::Space(ab, [p]), EdgeVertex::Corrected) => {
                space::edge_vertex(t, &ab, &p)
            }
            (ContactTolerances::Plane(t), Points::Plane(ab, [p]), EdgeVertex::AsPrinted) => {
                as_printed::edge_vertex2d(t, &ab, &p)
            }
            (ContactTolerances::Space(t), Points::Space(ab, [p]), EdgeVertex::AsPrinted) => {
                as_printed::edge_vertex3d(t, &ab, &p)
            }
            _ => unreachable!("points are of the scene's dimension"),
        };
        weight.map(F::wide)
    }

    pub(crate) fn edge_edge(&self, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
        let weights = match (self.tolerances, self.points(e, f)?) {
            (ContactTolerances::Plane(t), Points::Plane(ab, pq)) => plane::edge_edge(t, &ab, &pq),
            (ContactTolerances::Space(t), Points::Space(ab, pq)) => space::edge_edge(t, &ab, &pq),
            _ => unreachable!("points are of the scene's dimension"),
        };
        weights.map(|weights| weights.map(F::wide))
    }

    pub(crate) fn triangle_vertex(&self, triangle: [Vertex; 3], p: Vertex) -> Option<[f64; 3]> {
        let weights = match (self.tolerances, self.points(triangle, [p])?) {
            (ContactTolerances::Plane(t), Points::Plane(abc, [p])) => plane::triangle_vertex(t, &abc, &p),
            (ContactTolerances::Space(t), Points::Space(abc, [p])) => space::triangle_vertex(t, &abc, &p),
            _ => unreachable!("points are of the scene's dimension"),
        };
        weights.map(|weights| weights.map(F::wide))
    }

    pub(crate) fn triangle_edge(&self, triangle: [Vertex; 3], edge: [Vertex; 2]) -> Option<([f64; 3], f64)> {
        let (ContactTolerances::Space(t), Points::Space(abc, pq)) = (self.tolerances, self.points(triangle, edge)?)
        else {
            panic!("a triangle and an edge are a pair of a 3D scene")
        };
        space::triangle_edge(t, &abc, &pq).map(|(weights, fraction)| (weights.map(F::wide), fraction.wide()))
    }

    pub(crate) fn tetrahedron_vertex(&self, tetrahedron: [Vertex; 4], p: Vertex) -> Option<[f64; 4]> {
        let (ContactTolerances::Space(t), Points::Space(abcd, [p])) = (self.tolerances, self.points(tetrahedron, [p])?)
        else {
            panic!("a tetrahedron and a vertex are a pair of a 3D scene")
        };
        space::tetrahedron_vertex(t, &abcd, &p).map(|weights| weights.map(F::wide))
    }

    /// The points of a pair, if L bounds their coordinate differences.
    #[inline]
    fn points<const N: usize, const M: usize>(&self, s: [Vertex; N], t: [Vertex; M]) -> Option<Points<F, N, M>> {
        match self.tolerances {
            ContactTolerances::Plane(tolerances) => {
                let (s, t) = (s.map(|v| self.point(v)), t.map(|v| self.point(v)));
                are_near(&s, &t, tolerances.length).then_some(Points::Plane(s, t))
            }
            ContactTolerances::Space(tolerances) => {
                let (s, t) = (s.map(|v| self.point(v)), t.map(|v| self.point(v)));
                are_near(&s, &t, tolerances.length).then_some(Points::Space(s, t))
            }
        }
    }

    /// The point of a vertex; the scene's coordinates are numbers of `F`.
    #[inline]
    fn point<const D: usize>(&self, v: Vertex) -> [F; D] {
        let point = self.scene.point(v);
        std::array::from_fn(|i| F::nearest(point[i]))
    }
}

/// Returns true if no coordinates of the points differ by more than `length`.
///
/// Rounding is monotone: an exact difference of `length` at most is rounded to at most `length`.
#[inline]
fn are_near<F: Float, const D: usize>(s: &[[F; D]], t: &[[F; D]], length: F) -> bool {
    (0..D).all(|axis| {
        let first = s[0][axis];
        let (low, high) =
            s[1..].iter().chain(t).map(|point| point[axis]).fold((first, first), |(low, high), x| {
                (if x < low { x } else { low }, if x > high { x } else { high })
            });
        high - low <= length
    })
}
