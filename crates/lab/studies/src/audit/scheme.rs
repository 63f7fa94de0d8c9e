//! The algorithms of the tolerance crate, applied to a pair of point lists.

use predicament_contacts::algorithm::pairs::Weights;
use predicament_contacts::checks::audit::{Bands, Published, Symbol};
use predicament_error_calculus::Enclosure;
use predicament_predicates::Dimension;
use predicament_tolerance::algorithms::{as_printed, plane, space};
use predicament_tolerance::{ContactTolerances, Float, Tolerances2d, Tolerances3d};
use rug::Rational;

use super::{Form, Thresholds};

/// The paper's algorithms for one L; points of the plane have z = 0.
pub struct Scheme<F> {
    /// The tolerances of that L.
    pub tolerances: ContactTolerances<F>,
    /// True if Algorithms 3 and 8 are the printed ones.
    printed: bool,
}

impl<F: Float> Scheme<F> {
    /// The algorithms for the number of `F` that is nearest to this L.
    #[must_use]
    pub fn new(dimension: Dimension, length: f64, form: Form) -> Scheme<F> {
        let length = F::nearest(length);
        let tolerances = match dimension {
            Dimension::Two => ContactTolerances::Plane(Tolerances2d::from_length(length)),
            Dimension::Three => ContactTolerances::Space(Tolerances3d::from_length(length)),
        };
        let tolerances = match form {
            Form::Misscaled(misscaled) => misscaled.contacts(tolerances),
            Form::Corrected | Form::AsPrinted => tolerances,
        };
        Scheme { tolerances, printed: form == Form::AsPrinted }
    }

    /// The dimension of the pairs.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        match self.tolerances {
            ContactTolerances::Plane(_) => Dimension::Two,
            ContactTolerances::Space(_) => Dimension::Three,
        }
    }

    /// The tolerances that the paper publishes for the same L and ε.
    ///
    /// # Panics
    /// Never: L is finite.
    #[must_use]
    pub fn published(&self) -> Published {
        // ε = 2^-k, and 1023 is the exponent of one
        let halvings = 1023 - u32::try_from(F::EPSILON.wide().to_bits() >> 52).expect("eleven bits");
        let length = Rational::from_f64(self.tolerances.length().wide()).expect("finite");
        Published::new(self.dimension(), halvings, &Enclosure::exact(length))
    }

    /// The bands that the answers are checked against: the published ones.
    #[must_use]
    pub fn bands(&self) -> Bands {
        Bands::published(self.published())
    }

    /// The thresholds at which pairs are made: the published ones.
    #[must_use]
    pub fn thresholds(&self) -> Thresholds {
        let published = self.published();
        let [sigma, tau] = [Symbol::Sigma, Symbol::Tau].map(|symbol| published.rounded(symbol));
        // The plane's top-level pairs have no band.
        let of = |ranks| published.distance(ranks).map_or(tau, |symbol| published.rounded(symbol));
        let [gamma, delta] = [of([1, 1]), of([2, 0])];
        Thresholds { length: self.tolerances.length().wide(), sigma, tau, delta, gamma }
    }

    /// The pair's weights if it is registered; the simplex of higher rank is first.
    ///
    /// Sub-pairs are ignored.
    ///
    /// # Panics
    /// If the hierarchy has no such pair.
    #[must_use]
    pub fn ask(&self, first: &[[f64; 3]], second: &[[f64; 3]]) -> Option<[Weights; 2]> {
        match &self.tolerances {
            ContactTolerances::Plane(t) => {
                self.ask_plane(t, &points(first)[..first.len()], &points(second)[..second.len()])
            }
            ContactTolerances::Space(t) => {
                self.ask_space(t, &points(first)[..first.len()], &points(second)[..second.len()])
            }
        }
    }

    fn ask_plane(&self, t: &Tolerances2d<F>, first: &[[F; 2]], second: &[[F; 2]]) -> Option<[Weights; 2]> {
        Some(match (first, second) {
            ([a], [b]) => plane::vertex_vertex(t, a, b).then_some([pad([1.0]), pad([1.0])])?,
            (&[a, b], [p]) => {
                let ask = if self.printed { as_printed::edge_vertex2d } else { plane::edge_vertex };
                [along(ask(t, &[a, b], p)?), pad([1.0])]
            }
            (&[a, b], &[p, q]) => plane::edge_edge(t, &[a, b], &[p, q])?.map(along),
            (&[a, b, c], [p]) => [pad(plane::triangle_vertex(t, &[a, b, c], p)?.map(F::wide)), pad([1.0])],
            _ => panic!("no pair of the plane"),
        })
    }

    fn ask_space(&self, t: &Tolerances3d<F>, first: &[[F; 3]], second: &[[F; 3]]) -> Option<[Weights; 2]> {
        Some(match (first, second) {
            ([a], [b]) => space::vertex_vertex(t, a, b).then_some([pad([1.0]), pad([1.0])])?,
            (&[a, b], [p]) => {
                let ask = if self.printed { as_printed::edge_vertex3d } else { space::edge_vertex };
                [along(ask(t, &[a, b], p)?), pad([1.0])]
            }
            (&[a, b], &[p, q]) => space::edge_edge(t, &[a, b], &[p, q])?.map(along),
            (&[a, b, c], [p]) => [pad(space::triangle_vertex(t, &[a, b, c], p)?.map(F::wide)), pad([1.0])],
            (&[a, b, c], &[p, q]) => {
                let (on_triangle, on_edge) = space::triangle_edge(t, &[a, b, c], &[p, q])?;
                [pad(on_triangle.map(F::wide)), along(on_edge)]
            }
            (&[a, b, c, d], [p]) => [pad(space::tetrahedron_vertex(t, &[a, b, c, d], p)?.map(F::wide)), pad([1.0])],
            _ => panic!("no pair of space"),
        })
    }

    /// Returns true if a sub-pair is registered; the most degenerate are queried first.
    #[must_use]
    pub fn has_registered_faces(&self, first: &[[f64; 3]], second: &[[f64; 3]]) -> bool {
        let all = [first, second].map(|simplex| (1_u8 << simplex.len()) - 1);
        let whole = first.len() + second.len();
        (2..whole).any(|count| {
            (1..=all[0]).any(|s| {
                let Some(of_second) = count.checked_sub(s.count_ones() as usize).filter(|&n| n > 0) else {
                    return false;
                };
                let s = Face::of(first, s);
                (1..=all[1]).filter(|t| t.count_ones() as usize == of_second).any(|t| {
                    let t = Face::of(second, t);
                    let (s, t) = if s.count < t.count { (&t, &s) } else { (&s, &t) };
                    self.ask(s.points(), t.points()).is_some()
                })
            })
        })
    }
}

/// A face on the stack: there are many, and most pairs end at one.
struct Face {
    points: [[f64; 3]; 4],
    count: usize,
}

impl Face {
    /// The face of the points whose bits are set.
    fn of(simplex: &[[f64; 3]], chosen: u8) -> Face {
        let mut face = Face { points: [[0.0; 3]; 4], count: 0 };
        for (_, &point) in simplex.iter().enumerate().filter(|(i, _)| chosen >> i & 1 == 1) {
            face.points[face.count] = point;
            face.count += 1;
        }
        face
    }

    fn points(&self) -> &[[f64; 3]] {
        &self.points[..self.count]
    }
}

/// The simplex' points, followed by padding.
fn points<F: Float, const D: usize>(simplex: &[[f64; 3]]) -> [[F; D]; 4] {
    let mut points = [[F::ZERO; D]; 4];
    for (to, from) in points.iter_mut().zip(simplex) {
        *to = std::array::from_fn(|i| F::nearest(from[i]));
    }
    points
}

fn pad<const N: usize>(weights: [f64; N]) -> Weights {
    std::array::from_fn(|i| weights.get(i).copied().unwrap_or(0.0))
}

fn along<F: Float>(fraction: F) -> Weights {
    let fraction = fraction.wide();
    [1.0 - fraction, fraction, 0.0, 0.0]
}
