//! The algorithms of the tolerance crate, asked about a pair of point lists.

use predicament_algorithms::contacts::Weights;
use predicament_checks::audit::{Bands, PairKind};
use predicament_corpus::Thresholds;
use predicament_predicates::{Band, Dimension};
use predicament_tolerance::algorithms::{as_printed, plane, space};
use predicament_tolerance::{ContactTolerances, Float, Tolerances2d, Tolerances3d};

/// Points of either dimension: those of the plane have z = 0.
pub type Simplex = Vec<[f64; 3]>;

/// The scheme for one L.
pub struct Scheme<F> {
    pub tolerances: ContactTolerances<F>,
    pub printed: bool,
}

impl<F: Float> Scheme<F> {
    pub fn new(dimension: Dimension, length: f64, printed: bool) -> Scheme<F> {
        let length = F::nearest(length);
        let tolerances = match dimension {
            Dimension::Two => ContactTolerances::Plane(Tolerances2d::from_length(length)),
            Dimension::Three => ContactTolerances::Space(Tolerances3d::from_length(length)),
        };
        Scheme { tolerances, printed }
    }

    pub fn dimension(&self) -> Dimension {
        match self.tolerances {
            ContactTolerances::Plane(_) => Dimension::Two,
            ContactTolerances::Space(_) => Dimension::Three,
        }
    }

    pub fn bands(&self) -> Bands {
        Bands::new(self.dimension(), |ranks| self.tolerances.band(ranks))
    }

    pub fn thresholds(&self) -> Thresholds {
        let of = |ranks| {
            let Band { lower, width, upper } = self.tolerances.band(ranks)?;
            Some([lower, width, upper])
        };
        let [sigma, tau] = [[0, 0], [1, 0]].map(|ranks| of(ranks).unwrap());
        // The plane's top-level pairs have no band of their own.
        let [gamma, delta] = [[1, 1], [2, 0]].map(|ranks| of(ranks).unwrap_or(tau));
        Thresholds { length: self.tolerances.length().wide(), sigma, tau, delta, gamma }
    }

    /// The pair's weights if it is registered; the simplex of higher rank is first.
    pub fn ask(&self, first: &[[f64; 3]], second: &[[f64; 3]]) -> Option<[Weights; 2]> {
        match &self.tolerances {
            ContactTolerances::Plane(t) => self.ask_plane(t, &points(first), &points(second)),
            ContactTolerances::Space(t) => self.ask_space(t, &points(first), &points(second)),
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

    /// Whether a sub-pair is registered, the most degenerate asked first.
    pub fn has_registered_faces(&self, first: &[[f64; 3]], second: &[[f64; 3]]) -> bool {
        let (of_first, of_second) = (faces(first), faces(second));
        let mut pairs: Vec<_> = of_first.iter().flat_map(|s| of_second.iter().map(move |t| [s, t])).collect();
        pairs.sort_by_key(|[s, t]| s.len() + t.len());
        let whole = first.len() + second.len();
        pairs.into_iter().filter(|[s, t]| s.len() + t.len() < whole).any(|[s, t]| {
            let (s, t) = if s.len() < t.len() { (t, s) } else { (s, t) };
            self.ask(s, t).is_some()
        })
    }
}

/// The kinds of pairs in the hierarchy of a space.
pub fn kinds(dimension: Dimension) -> impl Iterator<Item = PairKind> {
    PairKind::ALL
        .into_iter()
        .filter(move |kind| kind.ranks().map(usize::from).iter().sum::<usize>() <= dimension.count())
}

pub fn faces(simplex: &[[f64; 3]]) -> Vec<Simplex> {
    let chosen =
        |subset: u32| simplex.iter().enumerate().filter(|(i, _)| subset >> i & 1 == 1).map(|(_, &p)| p).collect();
    (1_u32..1 << simplex.len()).map(chosen).collect()
}

fn points<F: Float, const D: usize>(simplex: &[[f64; 3]]) -> Vec<[F; D]> {
    simplex.iter().map(|point| std::array::from_fn(|i| F::nearest(point[i]))).collect()
}

fn pad<const N: usize>(weights: [f64; N]) -> Weights {
    std::array::from_fn(|i| weights.get(i).copied().unwrap_or(0.0))
}

fn along<F: Float>(fraction: F) -> Weights {
    let fraction = fraction.wide();
    [1.0 - fraction, fraction, 0.0, 0.0]
}
