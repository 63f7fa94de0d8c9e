//! The position of a constructed vertex, and its weights, in the limit of a vanishing perturbation.
//!
//! Coordinates and weights of a constructed vertex are ratios of polynomials in the infinitesimals. If the given lines
//! and planes meet in one point, the limit of the ratio is the ratio at zero. If they do not (two equal lines, a line
//! in a plane), the point exists only after the move, and the largest monomials of both polynomials determine the
//! limit. It is their coefficients' ratio if the monomials are equal, zero if the numerator's is infinitely smaller,
//! and none if it is infinitely larger.

use std::cmp::Ordering;

use predicament_arithmetic::BigInt;
use predicament_predicates::{Axis, Construction, Dimension, Scene, Vertex};
use smallvec::smallvec;

use super::certain::Matrix;
use super::moved::{Moved, inputs};
use super::place::Place;
use super::search::{Expression, Leading, Search};
use super::series::Number;

/// A rational number in lowest terms.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Ratio {
    /// The numerator.
    pub numerator: BigInt,
    /// The denominator, greater than zero.
    pub denominator: BigInt,
}

impl Ratio {
    fn new(numerator: BigInt, denominator: BigInt) -> Ratio {
        let common = numerator.gcd(&denominator);
        let common = if denominator.is_negative() { -common } else { common };
        Ratio { numerator: numerator.div_exact(&common), denominator: denominator.div_exact(&common) }
    }

    /// The product with a power of two.
    fn times_power_of_two(self, exponent: i32) -> Ratio {
        let places = exponent.unsigned_abs();
        match exponent < 0 {
            true => Ratio::new(self.numerator, self.denominator << places),
            false => Ratio::new(self.numerator << places, self.denominator),
        }
    }
}

/// A constructed vertex in the limit; a value that grows without bound is `None`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Limit {
    /// The coordinates.
    pub position: Vec<Option<Ratio>>,
    /// The weights of the vertices that define it.
    ///
    /// For two segments, the fraction of the way from the first point to the second, of each. For a line and a plane,
    /// that fraction along the line, and the barycentric coordinates in the triangle that spans the plane. For three
    /// planes nothing, and nothing for a share of a segment, which is given.
    pub weights: Vec<Option<Ratio>>,
}

/// The limit of a constructed vertex as the perturbation [`PerCoordinate`](crate::Scheme::PerCoordinate) goes to zero.
///
/// `None` if the lines and planes meet in no unique point however they are moved.
///
/// # Panics
/// If `v` is not a constructed vertex of the scene, or other constructed vertices define it.
#[must_use]
pub fn limit(scene: &Scene, v: Vertex) -> Option<Limit> {
    let construction = scene.construction(v).expect("a constructed vertex of the scene");
    let place = Place::Meet(*construction);
    let inputs = inputs(&[place]);
    let search = Search::new(scene, &inputs);
    let leading = |part: Part| search.leading(&Polynomial { dimension: scene.dimension().count(), place, part });
    let weight = leading(Part::Weight)?;
    let axes: &[Axis] = match scene.dimension() {
        Dimension::Two => &[Axis::X, Axis::Y],
        Dimension::Three => &[Axis::X, Axis::Y, Axis::Z],
    };
    // Coordinates are integers in units of a power of two; a weight has one length less than a coordinate times it.
    let position = axes.iter().map(|&axis| {
        let along = ratio(leading(Part::Along(axis)).as_ref(), &weight);
        along.map(|along| along.times_power_of_two(search.unit()))
    });
    let fractions = match construction {
        Construction::Ssi(_) => 2,
        Construction::Lpi { .. } => 4,
        Construction::Tpi(_) | Construction::Ratio { .. } => 0,
    };
    let weights = (0..fractions).map(|at| {
        let whole = leading(Part::Whole(at)).expect("the lines and planes meet");
        ratio(leading(Part::Share(at)).as_ref(), &whole)
    });
    Some(Limit { position: position.collect(), weights: weights.collect() })
}

/// The limit of a ratio; a numerator of `None` is zero.
fn ratio(numerator: Option<&Leading>, denominator: &Leading) -> Option<Ratio> {
    let zero = || Ratio { numerator: BigInt::ZERO, denominator: BigInt::from(1_u64) };
    let Some(numerator) = numerator else { return Some(zero()) };
    match size(numerator, denominator) {
        Ordering::Less => Some(zero()),
        Ordering::Equal => {
            let [n, d] = [numerator, denominator].map(|leading| leading.coefficient.clone().into_limbs());
            Some(Ratio::new(n, d))
        }
        Ordering::Greater => None,
    }
}

/// The order of two monomials: the one with the lower degree in the smallest infinitesimal in which they differ is
/// larger.
fn size(a: &Leading, b: &Leading) -> Ordering {
    // Both lists begin with the smallest infinitesimal, the one with the largest number.
    for ((i, degree), (j, other)) in a.monomial.iter().zip(&b.monomial) {
        match (i.cmp(j), degree.cmp(other)) {
            (Ordering::Equal, Ordering::Equal) => {}
            (Ordering::Equal, by_degree) => return by_degree.reverse(),
            // The one that has it is smaller.
            (by_number, _) => return by_number.reverse(),
        }
    }
    a.monomial.len().cmp(&b.monomial.len()).reverse()
}

/// The polynomials of a ratio.
#[derive(Clone, Copy)]
enum Part {
    /// The weight of the homogeneous row.
    Weight,
    /// The row's entry along an axis.
    Along(Axis),
    /// The numerator of a weight, by the weight's index.
    Share(usize),
    /// The denominator of a weight, by the weight's index.
    Whole(usize),
}

struct Polynomial {
    dimension: usize,
    place: Place,
    part: Part,
}

impl Expression for Polynomial {
    fn of<S: Number>(&self, moved: &Moved<'_, S>) -> S {
        match self.part {
            Part::Weight => moved.weight(&self.place),
            Part::Along(axis) => moved.row(&self.place).swap_remove(axis.index()),
            Part::Share(at) => moved.fraction(&self.place, at)[0].clone(),
            Part::Whole(at) => moved.fraction(&self.place, at)[1].clone(),
        }
    }

    fn matrix(&self) -> Matrix {
        let entry = |column| Matrix { places: smallvec![self.place], columns: smallvec![column] };
        let Place::Meet(construction) = self.place else { panic!("an input vertex has no parts") };
        // The side of a point relative to a line or plane, or to a line that is spun around another one.
        let side = |vertices: &[Vertex]| Matrix {
            places: vertices.iter().map(|&v| Place::Input(v)).collect(),
            columns: (0..vertices.len()).collect(),
        };
        match (self.part, construction) {
            (Part::Along(axis), _) => entry(axis.index()),
            (Part::Weight | Part::Whole(_), _) => entry(self.dimension),
            (Part::Share(0), Construction::Ssi([[p, _], [a, b]]))
            | (Part::Share(1), Construction::Ssi([[a, b], [p, _]])) => side(&[a, b, p]),
            (Part::Share(0), Construction::Lpi { line: [p, _], plane: [a, b, c] }) => side(&[a, b, c, p]),
            (Part::Share(at), Construction::Lpi { line: [p, q], plane }) => {
                // The two that follow in the ring of three.
                side(&[p, q, plane[at % 3], plane[(at + 1) % 3]])
            }
            (Part::Share(at), construction) => panic!("no weight {at} of {construction}"),
        }
    }
}
