//! Scenes for tests: random constructions. Polynomials for tests: coefficients that are integers of GMP.

use predicament_exact::Exact;
use predicament_predicates::{Backend, Construction, Dimension, Off, Predicates, Question, Scene, Share, Sign, Vertex};
use rug::Integer;

use super::row::Rows;
use super::series::Coefficient;

/// The reference for polynomials whose coefficients are integers of any length.
impl Coefficient for Integer {
    fn one() -> Self {
        Integer::from(1)
    }

    fn zero() -> Self {
        Integer::new()
    }

    fn whole(n: i64) -> Self {
        Integer::from(n)
    }

    fn is_zero(&self) -> bool {
        Integer::is_zero(self)
    }

    fn add(&mut self, other: &Self) {
        *self += other;
    }

    fn subtract(&mut self, other: &Self) {
        *self -= other;
    }

    fn add_product(&mut self, a: &Self, b: &Self) {
        *self += a * b;
    }
}

/// A small generator for reproducible samples (xorshift).
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 >> 8).unwrap() % bound
    }

    /// Distinct input vertices among the first `points`.
    pub(super) fn different<const N: usize>(&mut self, points: usize) -> [Vertex; N] {
        let mut all: Vec<usize> = (0..points).collect();
        std::array::from_fn(|_| Vertex::input(all.swap_remove(self.below(all.len()))))
    }
}

/// Tries this many constructions of a scene's input vertices, and keeps those that have a point.
pub(super) fn constructions(random: &mut Random, scene: &mut Scene, tries: usize) {
    let points = scene.len();
    let found = {
        let mut session = Exact.prepare(scene, Off).unwrap();
        for at in 0..tries {
            // (A definition without a point is refused.)
            let _ = session.construct(&[match (scene.dimension(), at % 3) {
                // A seventh is long in every base of doubles; shares may be outside of the segment.
                _ if random.below(4) == 0 => {
                    let numerator = i64::try_from(random.below(12)).unwrap() - 2;
                    Construction::Ratio {
                        ends: random.different(points),
                        share: Share::new(numerator, [1, 2, 3, 7][random.below(4)]).unwrap(),
                    }
                }
                (Dimension::Two, _) => Construction::Ssi([random.different(points), random.different(points)]),
                (_, 0) => Construction::Lpi { line: random.different(points), plane: random.different(points) },
                _ => Construction::Tpi([random.different(points), random.different(points), random.different(points)]),
            }]);
        }
        session.scene().constructions().to_vec()
    };
    for construction in found {
        scene.construct(construction).unwrap();
    }
}

/// The result for a tie by a search through all monomials.
pub(super) fn search_all(scene: &Scene, question: Question, args: &[Vertex]) -> Option<(Sign, usize)> {
    super::search_all(scene, &Rows::new(scene), question, args)
}
