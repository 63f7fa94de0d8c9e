//! The judge of ties about constructed vertices: whole polynomials.
//!
//! Every coordinate of every input vertex behind a question gets an
//! infinitesimal of its own, planes and lines get their coefficients as minors
//! of the matrix of their points, constructed vertices are the minors of those,
//! and all of it is multiplied out, monomial by monomial. First nothing moves,
//! then the vertex with the smallest index, then one more vertex at a time: once
//! the polynomial isn't zero, its largest monomial decides.
//!
//! What is zero wherever the vertices are would take all of them, and is seen at
//! two places with large random coordinates instead, in integers of any size. In
//! the same way a question about more than a few vertices is rid of those
//! that the largest monomial does without.

use std::collections::BTreeMap;

use predicament_predicates::{Axis, Construction, Question, Scene, Sign, Vertex};
use rug::{Integer, Rational};

/// Degrees by infinitesimal, four bits each, the smallest infinitesimal's in the
/// highest bits: the smallest key is the largest monomial.
#[derive(Clone, Debug, Default)]
struct Polynomial(BTreeMap<u128, Integer>);

const BITS: usize = 4;

/// Of so many vertices whole polynomials can be written out.
const FEW: usize = 7;

/// The key of an infinitesimal; the largest is number 0.
fn key(infinitesimal: usize) -> u128 {
    assert!(infinitesimal < 128 / BITS, "too many vertices have to move for this judge");
    1 << (BITS * infinitesimal)
}

impl Polynomial {
    fn constant(c: Integer) -> Polynomial {
        let mut polynomial = Polynomial::default();
        if !c.is_zero() {
            polynomial.0.insert(0, c);
        }
        polynomial
    }

    /// Degrees stay below 16: four points of three planes each share a
    /// vertex twelve times at most.
    fn times(&self, other: &Polynomial) -> Polynomial {
        let mut product: BTreeMap<u128, Integer> = BTreeMap::new();
        for (a, x) in &self.0 {
            for (b, y) in &other.0 {
                *product.entry(a + b).or_default() += x * y;
            }
        }
        product.retain(|_, c| !c.is_zero());
        Polynomial(product)
    }

    fn add(&mut self, other: &Polynomial, negative: bool) {
        for (&monomial, c) in &other.0 {
            let sum = self.0.entry(monomial).or_default();
            if negative {
                *sum -= c
            } else {
                *sum += c
            }
            if sum.is_zero() {
                self.0.remove(&monomial);
            }
        }
    }

    fn sign(&self) -> Sign {
        self.0.values().next().map_or(Sign::Zero, |c| c.cmp0().into())
    }
}

/// By Laplace along the first column.
fn determinant(matrix: &[Vec<Polynomial>]) -> Polynomial {
    let [first, ..] = matrix else { return Polynomial::default() };
    if first.len() == 1 {
        return first[0].clone();
    }
    let mut sum = Polynomial::default();
    for (at, row) in matrix.iter().enumerate() {
        let rest: Vec<Vec<Polynomial>> =
            matrix.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, row)| row[1..].to_vec()).collect();
        if !row[0].0.is_empty() {
            sum.add(&row[0].times(&determinant(&rest)), at % 2 == 1);
        }
    }
    sum
}

/// The maximal minors of n rows of n + 1 entries, with alternating signs: what
/// all rows are orthogonal to.
fn orthogonal(rows: &[Vec<Polynomial>]) -> Vec<Polynomial> {
    let without = |column: usize| -> Vec<Vec<Polynomial>> {
        rows.iter()
            .map(|row| row.iter().enumerate().filter(|(i, _)| *i != column).map(|(_, x)| x.clone()).collect())
            .collect()
    };
    let minor = |column: usize| {
        let mut signed = Polynomial::default();
        signed.add(&determinant(&without(column)), column % 2 == 1);
        signed
    };
    (0..=rows.len()).map(minor).collect()
}

struct Moved {
    /// Homogeneous.
    points: BTreeMap<Vertex, Vec<Polynomial>>,
}

/// How the vertices of a question move.
#[derive(Clone, Copy)]
enum Move<'v> {
    /// Some of them, by infinitesimals.
    Slightly(&'v [Vertex]),
    /// Some of them, by large random numbers: nothing is zero then but what always is.
    Anywhere(&'v [Vertex], u64),
    /// Some of them as a whole, by (ε, ε², ε³): a monomial is a power of ε.
    Rigidly(&'v [bool]),
}

impl Moved {
    fn new(scene: &Scene, vertices: &[Vertex], by: Move<'_>) -> Moved {
        let dimension = scene.dimension().count();
        let exact = |x: f64| Rational::from_f64(x).expect("a scene's coordinates are finite");
        let coordinates = || vertices.iter().flat_map(|&v| scene.point(v)).map(|&x| exact(x));
        let common = coordinates().map(|x| x.denom().clone()).max().unwrap_or_else(|| Integer::from(1));
        let mut noise = Integer::from(1);
        let mut coordinate = |v: Vertex, axis: usize, x: f64| {
            let x = (exact(x) * &common).into_numer_denom().0;
            match by {
                Move::Slightly(active) => {
                    let mut polynomial = Polynomial::constant(x);
                    if let Some(rank) = active.iter().position(|&active| active == v) {
                        polynomial.0.insert(key(rank * dimension + axis), Integer::from(1));
                    }
                    polynomial
                }
                Move::Rigidly(moving) => {
                    let mut polynomial = Polynomial::constant(x);
                    if moving[v.index()] {
                        polynomial.0.insert(axis as u128 + 1, Integer::from(1));
                    }
                    polynomial
                }
                Move::Anywhere(active, factor) => {
                    // Powers modulo the prime 2^89 − 1.
                    noise = (noise.clone() * factor + 1) % ((Integer::from(1) << 89) - 1);
                    Polynomial::constant(if active.contains(&v) { x + &noise } else { x })
                }
            }
        };
        let mut point = |&v: &Vertex| {
            let mut point: Vec<Polynomial> =
                scene.point(v).iter().enumerate().map(|(axis, &x)| coordinate(v, axis, x)).collect();
            point.push(Polynomial::constant(Integer::from(1)));
            (v, point)
        };
        Moved { points: vertices.iter().map(&mut point).collect() }
    }

    fn point(&self, scene: &Scene, v: Vertex) -> Vec<Polynomial> {
        let Some(index) = v.construction() else { return self.points[&v].clone() };
        let flat =
            |vertices: &[Vertex]| orthogonal(&vertices.iter().map(|v| self.points[v].clone()).collect::<Vec<_>>());
        match &scene.constructions()[index] {
            Construction::Ssi(lines) => orthogonal(&lines.iter().map(|line| flat(line)).collect::<Vec<_>>()),
            Construction::Tpi(planes) => orthogonal(&planes.iter().map(|plane| flat(plane)).collect::<Vec<_>>()),
            Construction::Lpi { line, plane } => {
                let plane = flat(plane);
                let [p, q] = line.map(|v| &self.points[&v]);
                let at = |point: &[Polynomial]| {
                    let mut sum = Polynomial::default();
                    plane.iter().zip(point).for_each(|(a, x)| sum.add(&a.times(x), false));
                    sum
                };
                let (at_p, at_q) = (at(p), at(q));
                let coordinate = |(p, q): (&Polynomial, &Polynomial)| {
                    let mut x = p.times(&at_q);
                    x.add(&q.times(&at_p), true);
                    x
                };
                p.iter().zip(q).map(coordinate).collect()
            }
        }
    }
}

/// What a question is about: its input vertices, and its matrix as a function of their move.
struct Asked<'q> {
    scene: &'q Scene,
    question: Question,
    args: &'q [Vertex],
    vertices: Vec<Vertex>,
}

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
        Asked { scene, question, args, vertices }
    }

    fn moved(&self, by: Move<'_>) -> Moved {
        Moved::new(self.scene, &self.vertices, by)
    }

    /// The determinant times the weights of all constructed vertices.
    fn determinant(&self, moved: &Moved) -> Polynomial {
        let planar;
        let axes: &[Axis] = match &self.question {
            Question::Compare(axis) => std::slice::from_ref(axis),
            Question::Orient2d(plane) => {
                planar = plane.axes();
                &planar
            }
            Question::Incircle => &[Axis::X, Axis::Y],
            _ => &[Axis::X, Axis::Y, Axis::Z],
        };
        let lifted = matches!(self.question, Question::Incircle | Question::Insphere);
        let row = |&v: &Vertex| {
            let mut point = moved.point(self.scene, v);
            let weight = point.pop().expect("a point has a weight");
            let mut row: Vec<Polynomial> = axes.iter().map(|axis| point[axis.index()].clone()).collect();
            if lifted {
                // Of input vertices, whose weight is one.
                let mut lift = Polynomial::default();
                row.iter().for_each(|x| lift.add(&x.times(x), false));
                row.push(lift);
            }
            row.push(weight);
            row
        };
        determinant(&self.args.iter().map(row).collect::<Vec<_>>())
    }

    fn weight(&self, moved: &Moved, v: Vertex) -> Polynomial {
        moved.point(self.scene, v).pop().expect("a point has a weight")
    }

    /// The sign of the determinant, by the signs of polynomials of the move.
    fn sign(&self, of: impl Fn(&dyn Fn(&Moved) -> Polynomial) -> Sign) -> Sign {
        let determinant = of(&|moved| self.determinant(moved));
        self.args.iter().fold(determinant, |product, &v| product * of(&|moved| self.weight(moved, v)))
    }
}

/// The sign where each coordinate of each vertex moves by an infinitesimal of
/// its own; zero if it is zero wherever the input vertices are.
pub(super) fn judge(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    let asked = Asked::new(scene, question, args);
    let vertices = &asked.vertices;
    asked.sign(|of| {
        let is_zero = |active: &[Vertex]| {
            [0x9e37_79b9_7f4a_7c15, 0xd1b5_4a32_d192_ed03]
                .iter()
                .all(|&factor| of(&asked.moved(Move::Anywhere(active, factor))).sign().is_zero())
        };
        if is_zero(vertices) {
            return Sign::Zero;
        }
        let mut movable = vertices.clone();
        if movable.len() > FEW {
            // Smallest first: what is not zero without a vertex' move has a monomial without it, which is larger.
            for v in vertices.iter().rev() {
                let others: Vec<Vertex> = movable.iter().copied().filter(|other| other != v).collect();
                if !is_zero(&others) {
                    movable = others;
                }
            }
        }
        let signs = (0..=movable.len()).map(|active| of(&asked.moved(Move::Slightly(&movable[..active]))).sign());
        signs.into_iter().find(|sign| !sign.is_zero()).expect("the determinant is zero for certain moves only")
    })
}

/// The sign where the second of two meshes has moved by (ε, ε², ε³); zero if it is zero however far that moves.
///
/// # Panics
/// If the scene has no two meshes.
#[must_use]
pub fn judge_per_mesh(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    let asked = Asked::new(scene, question, args);
    let moving = scene.second_mesh().expect("a scene with two meshes");
    asked.sign(|of| of(&asked.moved(Move::Rigidly(moving))).sign())
}
