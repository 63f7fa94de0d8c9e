//! The judge of ties about constructed vertices: whole polynomials.
//!
//! Every coordinate of every input vertex behind a question gets a separate infinitesimal. Planes and lines get their
//! coefficients as minors of the matrix of their points, constructed vertices are the minors of those, and all of it is
//! multiplied out, monomial by monomial. First nothing moves, then the first coordinate of the vertex with the smallest
//! index, then one more coordinate at a time. Once the polynomial isn't zero, its largest monomial decides, as all
//! others have a smaller infinitesimal.
//!
//! A polynomial that is zero wherever the vertices are would need all of them. Instead the judge evaluates it at two
//! places with large random coordinates, in integers of any size. In the same way the judge removes from a question
//! about more than a few vertices those that the largest monomial does not need.

use predicament_predicates::{Axis, Construction, Question, Scene, Sign, Vertex};
use rug::{Integer, Rational};

use super::polynomial::{Number, Polynomial, determinant, orthogonal};

/// The number of bits for a degree.
///
/// A monomial's key consists of degrees by infinitesimal, the smallest infinitesimal's in the highest bits: the
/// smallest key is the largest monomial. Degrees stay below 16: four points of three planes each share a vertex twelve
/// times at most.
const BITS: usize = 4;

/// The number of vertices up to which whole polynomials are expanded.
const FEW: usize = 7;

/// The key of an infinitesimal; the largest infinitesimal is number 0.
fn key(infinitesimal: usize) -> u128 {
    assert!(infinitesimal < 128 / BITS, "too many vertices have to move for this judge");
    1 << (BITS * infinitesimal)
}

/// The polynomials behind a question.
#[derive(Clone, Copy)]
enum Part {
    /// The determinant times the weights of all constructed vertices.
    Determinant,
    /// The weight of the argument with this number.
    Weight(usize),
}

/// The input vertices of a question, and its polynomials as functions of their positions.
struct Asked<'q> {
    scene: &'q Scene,
    question: Question,
    args: &'q [Vertex],
    /// The input vertices, ascending.
    vertices: Vec<Vertex>,
    /// Their coordinates times a common denominator.
    places: Vec<Vec<Integer>>,
}

/// Homogeneous points of a question's input vertices.
type Points<N> = Vec<Vec<N>>;

impl<'q> Asked<'q> {
    fn new(scene: &'q Scene, question: Question, args: &'q [Vertex]) -> Asked<'q> {
        let flats = |v: &Vertex| -> Vec<Vertex> {
            let index = v.construction();
            let defined_by = index.map(|index| scene.constructions()[index].flats().flatten().copied().collect());
            defined_by.unwrap_or_else(|| vec![*v])
        };
        let mut vertices: Vec<Vertex> = args.iter().flat_map(flats).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let exact = |&x: &f64| Rational::from_f64(x).expect("a scene's coordinates are finite");
        let points: Vec<Vec<Rational>> = vertices.iter().map(|&v| scene.point(v).iter().map(exact).collect()).collect();
        // Denominators of doubles are powers of two: the largest is a common one.
        let common = points.iter().flatten().map(Rational::denom).max().cloned().unwrap_or_else(|| Integer::from(1));
        let integer = |x: Rational| {
            let (numerator, own) = x.into_numer_denom();
            numerator << (common.significant_bits() - own.significant_bits())
        };
        let places = points.into_iter().map(|point| point.into_iter().map(integer).collect()).collect();
        Asked { scene, question, args, vertices, places }
    }

    /// The points whose coordinates `moved` computes from a vertex' number, an axis and a coordinate.
    fn points<N: Number>(&self, mut moved: impl FnMut(usize, usize, &Integer) -> N) -> Points<N> {
        let point = |(at, place): (usize, &Vec<Integer>)| {
            let coordinates = place.iter().enumerate().map(|(axis, x)| moved(at, axis, x));
            coordinates.chain([N::constant(Integer::from(1))]).collect()
        };
        self.places.iter().enumerate().map(point).collect()
    }

    fn in_place(&self) -> Points<Integer> {
        self.points(|_, _, x| x.clone())
    }

    /// Some vertices moved by large random numbers: only identities are zero then.
    fn anywhere(&self, active: &[Vertex], factor: u64) -> Points<Integer> {
        let mut noise = Integer::from(1);
        let prime = (Integer::from(1) << 89) - 1;
        self.points(|at, _, x| {
            // Powers modulo the prime.
            noise *= factor;
            noise += 1;
            noise %= &prime;
            if active.contains(&self.vertices[at]) { Integer::from(x + &noise) } else { x.clone() }
        })
    }

    /// The first coordinates of some vertices moved by infinitesimals.
    fn slightly(&self, active: &[Vertex], coordinates: usize) -> Points<Polynomial> {
        let dimension = self.scene.dimension().count();
        self.points(|at, axis, x| {
            let mut moved = Polynomial::constant(x.clone());
            let rank = active.iter().position(|&active| active == self.vertices[at]);
            if let Some(infinitesimal) = rank.map(|rank| rank * dimension + axis)
                && infinitesimal < coordinates
            {
                moved.push(key(infinitesimal));
            }
            moved
        })
    }

    /// Some vertices moved as a whole, by η·(ε, ε², ε³): a monomial's key is its degree in η, then its power of ε.
    fn rigidly(&self, moving: &[bool]) -> Points<Polynomial> {
        self.points(|at, axis, x| {
            let mut moved = Polynomial::constant(x.clone());
            if moving[self.vertices[at].index()] {
                moved.push((1 << 64) + axis as u128 + 1);
            }
            moved
        })
    }

    /// A vertex' homogeneous coordinates.
    fn row<N: Number>(&self, points: &Points<N>, v: Vertex) -> Vec<N> {
        let point = |v: Vertex| &points[self.vertices.binary_search(&v).expect("a vertex of the question")];
        let Some(index) = v.construction() else { return point(v).clone() };
        let flat = |vertices: &[Vertex]| orthogonal(&vertices.iter().map(|&v| point(v).clone()).collect::<Vec<_>>());
        match &self.scene.constructions()[index] {
            Construction::Ssi(lines) => orthogonal(&lines.iter().map(|line| flat(line)).collect::<Vec<_>>()),
            Construction::Tpi(planes) => orthogonal(&planes.iter().map(|plane| flat(plane)).collect::<Vec<_>>()),
            Construction::Lpi { line, plane } => {
                let plane = flat(plane);
                let [p, q] = line.map(point);
                let at = |point: &[N]| {
                    let mut sum = N::default();
                    plane.iter().zip(point).for_each(|(a, x)| sum.add_product(a, x, false));
                    sum
                };
                let (at_p, at_q) = (at(p), at(q));
                let coordinate = |(p, q): (&N, &N)| {
                    let mut x = N::default();
                    x.add_product(p, &at_q, false);
                    x.add_product(q, &at_p, true);
                    x
                };
                p.iter().zip(q).map(coordinate).collect()
            }
            Construction::Ratio { ends: [a, c], share } => {
                // Weights are one, and so p + (q − p) is that of the row.
                let [p, q] = share.fraction().map(Integer::from);
                let [of_a, of_c] = [N::constant(p.clone()), N::constant(q - p)];
                let coordinate = |(a, c): (&N, &N)| {
                    let mut x = N::default();
                    x.add_product(a, &of_a, false);
                    x.add_product(c, &of_c, false);
                    x
                };
                point(*a).iter().zip(point(*c)).map(coordinate).collect()
            }
        }
    }

    /// The homogeneous coordinates of the arguments.
    fn rows<N: Number>(&self, points: &Points<N>) -> Points<N> {
        self.args.iter().map(|&v| self.row(points, v)).collect()
    }

    /// The value at arguments with these rows.
    fn value<N: Number>(&self, part: Part, rows: &Points<N>) -> N {
        if let Part::Weight(at) = part {
            return rows[at].last().expect("a point has a weight").clone();
        }
        let axes: &[Axis] = match &self.question {
            Question::Compare(axis) => std::slice::from_ref(axis),
            Question::Orient2d(plane) => &plane.axes(),
            Question::Incircle => &[Axis::X, Axis::Y],
            _ => &[Axis::X, Axis::Y, Axis::Z],
        };
        let lifted = matches!(self.question, Question::Incircle | Question::Insphere);
        let row = |point: &Vec<N>| {
            let mut row: Vec<N> = axes.iter().map(|axis| point[axis.index()].clone()).collect();
            if lifted {
                // For input vertices, whose weight is one.
                let mut lift = N::default();
                row.iter().for_each(|x| lift.add_product(x, x, false));
                row.push(lift);
            }
            row.extend(point.last().cloned());
            row
        };
        let matrix: Vec<Vec<N>> = rows.iter().map(row).collect();
        determinant(&matrix, &(0..matrix.len()).collect::<Vec<_>>())
    }

    /// The sign of the determinant, from the signs of polynomials.
    fn sign(&self, of: impl Fn(Part) -> Sign) -> Sign {
        let constructed = (0..self.args.len()).filter(|&at| self.args[at].is_constructed());
        constructed.fold(of(Part::Determinant), |product, at| match product {
            Sign::Zero => Sign::Zero,
            product => product * of(Part::Weight(at)),
        })
    }

    /// The sign of a polynomial under infinitesimal moves; `still` are the rows of the arguments in place.
    fn slight_sign(&self, part: Part, still: &Points<Integer>) -> Sign {
        let still = Sign::from(self.value(part, still).cmp0());
        if !still.is_zero() {
            return still;
        }
        let is_zero = |active: &[Vertex]| {
            [0x9e37_79b9_7f4a_7c15, 0xd1b5_4a32_d192_ed03]
                .iter()
                .all(|&factor| self.value_at(part, &self.anywhere(active, factor)).is_zero())
        };
        if is_zero(&self.vertices) {
            return Sign::Zero;
        }
        let mut movable = self.vertices.clone();
        if movable.len() > FEW {
            // Smallest first: if the polynomial is nonzero without a vertex' move, it has a monomial without that
            // vertex, which is larger.
            for v in self.vertices.iter().rev() {
                let others: Vec<Vertex> = movable.iter().copied().filter(|other| other != v).collect();
                if !is_zero(&others) {
                    movable = others;
                }
            }
        }
        let coordinates = movable.len() * self.scene.dimension().count();
        let mut signs = (1..=coordinates).map(|active| self.value_at(part, &self.slightly(&movable, active)).sign());
        signs.find(|sign| !sign.is_zero()).expect("the determinant is zero for certain moves only")
    }

    /// The value at these points. A weight needs the row of its argument only.
    fn value_at<N: Number>(&self, part: Part, points: &Points<N>) -> N {
        match part {
            Part::Determinant => self.value(part, &self.rows(points)),
            Part::Weight(at) => self.row(points, self.args[at]).pop().expect("a point has a weight"),
        }
    }
}

/// The sign with a separate infinitesimal move of each coordinate of each vertex.
///
/// Zero if it is zero wherever the input vertices are.
pub(super) fn judge(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    let asked = Asked::new(scene, question, args);
    let still = asked.rows(&asked.in_place());
    asked.sign(|part| asked.slight_sign(part, &still))
}

/// The sign after the second of two meshes has moved by η·(ε, ε², ε³), with η smaller than every power of ε.
///
/// Zero if it is zero however far that mesh moves.
///
/// # Panics
/// If the scene does not have two meshes.
#[must_use]
pub fn judge_per_mesh(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    if let Question::Derived(derived) = question {
        return super::formula::judge_per_mesh(scene, derived, args);
    }
    let asked = Asked::new(scene, question, args);
    let rows = asked.rows(&asked.rigidly(scene.second_mesh().expect("a scene with two meshes")));
    asked.sign(|part| asked.value(part, &rows).sign())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_leave_room_for_degrees_below_16() {
        assert_eq!([0, 1, 31].map(key), [1, 16, 1 << 124]);
        assert_eq!(15 * key(4) + key(5), 0x1f_0000);
    }

    #[test]
    #[should_panic(expected = "too many vertices have to move for this judge")]
    fn a_key_of_more_infinitesimals_than_fit_is_refused() {
        key(32);
    }
}
