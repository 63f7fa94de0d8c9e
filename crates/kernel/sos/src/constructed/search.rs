//! The search for the largest monomial of a polynomial that is only known by its values.
//!
//! Each coordinate of each input vertex has a separate infinitesimal δ, and the next one is smaller than any power of
//! the previous one: δ₁ ≫ δ₂ ≫ …. Of two monomials the one with the lower degree in the *smallest* infinitesimal of the
//! two is larger, whatever their other degrees are. So the search finds a polynomial's largest monomial from its
//! smallest infinitesimal up: the lowest degree with a nonzero coefficient, that coefficient's lowest degree in the
//! next infinitesimal, and so on.
//!
//! # What is certain
//! A determinant about four constructed vertices has up to 108 infinitesimals, too many to expand. A coefficient is a
//! polynomial in the larger infinitesimals. Its value at a fixed place modulo 2^61 − 1 is a guess whether it is zero. A
//! nonzero value proves that the polynomial isn't zero. A zero value proves nothing. So once the search has found a
//! monomial, it proves that the skipped monomials have no coefficients: by one evaluation in integers if nothing moves,
//! and else by [`certain`](super::certain). If the proof fails the search goes on there. So the answer is certain,
//! whatever the coordinates are.

use predicament_predicates::{Scene, Sign, Vertex};
use smallvec::SmallVec;

use super::certain::{Matrix, Moving};
use super::moved::Moved;
use super::residue::Residue;
use super::series::{Coefficient, Cut, Number, Series, Short};
use crate::integer::Integer;
use crate::whole;

/// A polynomial of the coordinates.
pub(super) trait Expression {
    fn of<S: Number>(&self, moved: &Moved<'_, S>) -> S;

    /// The matrix whose determinant it is, except for the sign.
    fn matrix(&self) -> Matrix;
}

/// The deciding part of a moved polynomial.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Leading {
    /// The coefficient, never zero.
    pub(super) coefficient: Integer,
    /// The largest monomial: infinitesimals and their degrees, the smallest infinitesimal first.
    pub(super) monomial: Vec<(usize, usize)>,
}

impl Leading {
    pub(super) fn sign(&self) -> Sign {
        self.coefficient.cmp0().into()
    }

    /// The total degree of the largest monomial.
    pub(super) fn degree(&self) -> usize {
        self.monomial.iter().map(|(_, degree)| degree).sum()
    }
}

/// A question's input vertices and their infinitesimals.
pub(super) struct Search<'q> {
    scene: &'q Scene,
    inputs: &'q [Vertex],
    /// The exponent of the common power of two.
    unit: i32,
    /// Significand and exponent of each coordinate.
    ///
    /// The coordinates are integers over a common power of two, which changes no sign.
    coordinates: Vec<(i64, u32)>,
    /// The coordinates modulo the prime, unmoved and moved.
    residues: Vec<[Residue; 2]>,
}

/// The pseudo-random value of an infinitesimal, always the same.
fn noise(infinitesimal: usize) -> u64 {
    // splitmix64
    let mut z = (infinitesimal as u64 + 61).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}

fn residues(coordinates: &[(i64, u32)]) -> Vec<[Residue; 2]> {
    let residue = |(at, &(m, k)): (usize, &(i64, u32))| {
        let coordinate = Residue::scaled(m, k);
        [coordinate, coordinate.plus(Residue::new(noise(at)))]
    };
    coordinates.iter().enumerate().map(residue).collect()
}

impl<'q> Search<'q> {
    pub(super) fn new(scene: &'q Scene, inputs: &'q [Vertex]) -> Search<'q> {
        let (unit, coordinates) = integers(scene, inputs);
        let residues = residues(&coordinates);
        Search { scene, inputs, unit, coordinates, residues }
    }

    /// The exponent of the unit: coordinates are multiples of 2 to this power.
    pub(super) fn unit(&self) -> i32 {
        self.unit
    }

    /// The largest monomial; `None` if the polynomial is zero however the vertices move.
    pub(super) fn leading(&self, expression: &impl Expression) -> Option<Leading> {
        self.leading_of(expression, 0)
    }

    /// The largest monomial of a polynomial that is known to be zero if nothing moves.
    pub(super) fn leading_of_tie(&self, expression: &impl Expression) -> Option<Leading> {
        self.leading_of(expression, 1)
    }

    /// The largest monomial of a polynomial that is zero with fewer than `least` nonzero infinitesimals.
    fn leading_of(&self, expression: &impl Expression, least: usize) -> Option<Leading> {
        let all = self.coordinates.len();
        let mut chosen: Vec<(usize, usize)> = Vec::new();
        let mut active = self.fewest(expression, least, all, &chosen)?;
        while let Some(smallest) = active.checked_sub(1) {
            chosen.push((smallest, 0));
            // Some degree has a coefficient: the polynomial of these infinitesimals is not zero.
            loop {
                chosen.last_mut().expect("pushed above").1 += 1;
                if self.is_there(expression, smallest, &chosen) || !self.vanishes(expression, smallest, &chosen) {
                    break;
                }
            }
            active = self.fewest(expression, 0, smallest, &chosen).expect("found above");
        }
        Some(Leading { coefficient: self.coefficient(expression, &chosen), monomial: chosen })
    }

    /// The least number of infinitesimals, from `least` to `most`, for which a coefficient is not zero.
    fn fewest(
        &self,
        expression: &impl Expression,
        least: usize,
        most: usize,
        chosen: &[(usize, usize)],
    ) -> Option<usize> {
        let mut with = match self.probably_fewest(expression, least, most, chosen) {
            Some(with) => with,
            None if self.vanishes(expression, most, chosen) => return None,
            None => most,
        };
        while with > least && !self.vanishes(expression, with - 1, chosen) {
            with -= 1;
        }
        Some(with)
    }

    /// A number of infinitesimals for which the coefficient is not zero, and probably the least.
    fn probably_fewest(
        &self,
        expression: &impl Expression,
        least: usize,
        most: usize,
        chosen: &[(usize, usize)],
    ) -> Option<usize> {
        let is_there = |active: usize| self.is_there(expression, active, chosen);
        // Mostly few suffice: try growing numbers from none on, then bisect between the last two.
        let (mut without, mut with) = (least, least);
        while !is_there(with) {
            if with == most {
                return None;
            }
            (without, with) = (with + 1, (2 * with + 1).min(most));
        }
        while without < with {
            let middle = usize::midpoint(without, with);
            if is_there(middle) { with = middle } else { without = middle + 1 }
        }
        Some(with)
    }

    /// Returns true if a coefficient is certainly zero.
    ///
    /// The coefficients of lower powers of the last chosen infinitesimals must be zero.
    fn vanishes(&self, expression: &impl Expression, active: usize, chosen: &[(usize, usize)]) -> bool {
        if active == 0 {
            return self.coefficient(expression, chosen).is_zero();
        }
        let (cut, matrix) = (cut(chosen), expression.matrix());
        self.moving(&cut, &matrix, chosen, active).is_zero(&self.coordinates)
    }

    /// Returns true if the coefficient of the chosen powers is nonzero as a polynomial in the `active` largest
    /// infinitesimals.
    fn is_there(&self, expression: &impl Expression, active: usize, chosen: &[(usize, usize)]) -> bool {
        !self.residue(expression, active, chosen).is_zero()
    }

    /// The residue of a coefficient at a fixed place of the `active` largest infinitesimals.
    fn residue(&self, expression: &impl Expression, active: usize, chosen: &[(usize, usize)]) -> Residue {
        self.evaluate(expression, |at| self.residues[at][usize::from(at < active)], chosen)
    }

    fn moving<'m>(
        &'m self,
        cut: &'m Cut,
        matrix: &'m Matrix,
        chosen: &'m [(usize, usize)],
        active: usize,
    ) -> Moving<'m> {
        Moving { cut, dimension: self.scene.dimension().count(), matrix, inputs: self.inputs, chosen, active }
    }

    fn coefficient(&self, expression: &impl Expression, chosen: &[(usize, usize)]) -> Integer {
        self.evaluate(expression, |at| self.integer(at), chosen)
    }

    fn integer(&self, at: usize) -> Integer {
        let (m, k) = self.coordinates[at];
        Integer::from(m) << k
    }

    /// The coefficient of the chosen powers, with values for the other infinitesimals.
    fn evaluate<C: Coefficient>(
        &self,
        expression: &impl Expression,
        place: impl Fn(usize) -> C,
        chosen: &[(usize, usize)],
    ) -> C {
        match chosen {
            [] => self.evaluate_in::<Short<C, 1>>(expression, place, chosen).last(),
            [(_, 1)] => self.evaluate_in::<Short<C, 2>>(expression, place, chosen).last(),
            _ => self.evaluate_in::<Series<C>>(expression, place, chosen).last(),
        }
    }

    fn evaluate_in<S: Number>(
        &self,
        expression: &impl Expression,
        place: impl Fn(usize) -> S::Coefficient,
        chosen: &[(usize, usize)],
    ) -> S {
        let cut = &cut(chosen);
        let moved = |at: usize| {
            let one = chosen.iter().position(|&(infinitesimal, _)| infinitesimal == at);
            match one.and_then(|one| cut.place(one, 1)) {
                Some(monomial) => S::moved(cut, place(at), monomial),
                None => S::constant(cut, place(at)),
            }
        };
        let coordinates: SmallVec<[S; 32]> = (0..self.coordinates.len()).map(moved).collect();
        expression.of(&Moved { dimension: self.scene.dimension(), cut, inputs: self.inputs, coordinates: &coordinates })
    }
}

/// The cut at the degrees of chosen infinitesimals.
fn cut(chosen: &[(usize, usize)]) -> Cut {
    Cut::new(chosen.iter().map(|&(_, degree)| degree))
}

/// The coordinates of these vertices in units of their lowest bit.
///
/// The unit's exponent comes first, then significands and exponents from 0 on.
pub(super) fn integers(scene: &Scene, inputs: &[Vertex]) -> (i32, Vec<(i64, u32)>) {
    whole::parts(inputs.iter().flat_map(|&v| scene.point(v)).copied())
}

#[cfg(test)]
mod tests {
    use predicament_predicates::{Axis, Dimension, Plane, Question};
    use smallvec::SmallVec;

    use super::super::Determinant;
    use super::super::moved::inputs;
    use super::super::place::Place;
    use super::super::testing::{Random, constructions};
    use super::*;
    use crate::integer::tests::value;

    /// Checks, on the way to the largest monomial, that the proof and the value modulo the prime, both in exterior
    /// algebra, agree with the value in integers of GMP, and that coefficients are those of GMP.
    ///
    /// A polynomial is zero at that place once in 2^58. Returns the numbers of nonzero and of zero coefficients.
    fn proofs_are_values(search: &Search, determinant: &Determinant, context: &str) -> [usize; 2] {
        let mut seen = [0; 2];
        let mut check = |active: usize, chosen: &[(usize, usize)]| {
            let place = |at: usize| {
                let still = value(&search.integer(at));
                if at < active { still + noise(at) } else { still }
            };
            let moved = search.evaluate(determinant, place, chosen);
            let residue = search.residue(determinant, active, chosen);
            let prime = (rug::Integer::from(1) << 61) - 1_u32;
            let expected = rug::Integer::from(moved.modulo_ref(&prime)).to_u64().map(Residue::new);
            assert_eq!(Some(residue), expected, "{active} {chosen:?}: {context}");
            let is_there = moved != 0;
            assert_eq!(search.vanishes(determinant, active, chosen), !is_there, "{active} {chosen:?}: {context}");
            let reference = search.evaluate(determinant, |at| value(&search.integer(at)), chosen);
            assert_eq!(value(&search.coefficient(determinant, chosen)), reference, "{chosen:?}: {context}");
            // The value at that place is of coordinates of 64 bits and more.
            let length = |at: usize| value(&search.integer(at)).significant_bits().max(64 * u32::from(at < active)) + 1;
            let sizes: Vec<(i64, u32)> = (0..search.coordinates.len()).map(|at| (1, length(at))).collect();
            let bits = search.moving(&cut(chosen), &determinant.matrix(), chosen, active).bits(&sizes);
            assert!(bits.is_none_or(|bits| moved.significant_bits() <= bits), "{chosen:?}: {context}");
            seen[usize::from(!is_there)] += 1;
        };
        for active in 0..=search.coordinates.len() {
            check(active, &[]);
        }
        let monomial = search.leading(determinant).map(|leading| leading.monomial).unwrap_or_default();
        for (at, &(infinitesimal, degree)) in monomial.iter().enumerate() {
            let mut chosen = monomial[..=at].to_vec();
            // (Lower degrees first: the proof for a coefficient needs the coefficients of lower powers to be zero.)
            for lower in 1..=degree {
                chosen[at].1 = lower;
                (0..=infinitesimal).for_each(|active| check(active, &chosen));
            }
        }
        seen
    }

    #[test]
    fn what_is_certainly_zero_is_zero_wherever_it_is_looked_at() {
        let mut random = Random(0x1234_5678_9abc_def1);
        let mut seen = [0; 2];
        for round in 0..60 {
            let (dimension, axes) = if round % 3 == 0 { (Dimension::Three, 3) } else { (Dimension::Two, 2) };
            let points = if axes == 2 { 5 } else { 6 };
            // Units of few bits and of many, within the range of doubles and at its lower end.
            let unit = [1.0, 0.1, 3e-320, 1e300][round / 3 % 4];
            let coordinates = (0..points * axes).map(|_| f64::from(u32::try_from(random.below(3)).unwrap()) * unit);
            let mut scene = Scene::new(dimension, coordinates.collect()).unwrap();
            constructions(&mut random, &mut scene, 6);
            let questions: &[Question] = match (axes, round) {
                (2, _) => &[Question::Compare(Axis::Y), Question::Orient2d(Plane::Xy)],
                (_, 0..12) => &[Question::Orient3d],
                _ => &[Question::Compare(Axis::X), Question::Orient2d(Plane::Yz)],
            };
            for &question in questions {
                let mut all: Vec<Vertex> = scene.vertices().collect();
                all.extend((0..scene.constructions().len()).map(Vertex::constructed));
                let mut args: Vec<Vertex> = Vec::new();
                while args.len() < question.kind().arity() {
                    // From the end: constructed vertices first.
                    args.push(all.swap_remove(all.len() - 1 - random.below(all.len().min(4))));
                }
                let places: SmallVec<[Place; 4]> = args.iter().map(|&v| Place::simple(&scene, v)).collect();
                let inputs = inputs(&places);
                let search = Search::new(&scene, &inputs);
                let determinant = Determinant { dimension: axes, question, places: &places };
                let context = format!("{question:?} of {args:?} in {scene:?}");
                let [some, none] = proofs_are_values(&search, &determinant, &context);
                seen = [seen[0] + some, seen[1] + none];
            }
        }
        assert!(seen.iter().all(|&count| count > 200), "{seen:?}");
    }
}
