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

/// The sign of the moved determinant; zero if it is zero wherever the input vertices are.
pub(super) fn judge(scene: &Scene, question: Question, args: &[Vertex]) -> Sign {
    let flats = |v: &Vertex| -> Vec<Vertex> {
        let defined_by =
            v.construction().map(|index| scene.constructions()[index].flats().flatten().copied().collect());
        defined_by.unwrap_or_else(|| vec![*v])
    };
    let mut vertices: Vec<Vertex> = args.iter().flat_map(flats).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let planar;
    let axes: &[Axis] = match &question {
        Question::Compare(axis) => std::slice::from_ref(axis),
        Question::Orient2d(plane) => {
            planar = plane.axes();
            &planar
        }
        _ => &[Axis::X, Axis::Y, Axis::Z],
    };
    let sign = |of: &dyn Fn(&Moved) -> Polynomial| {
        let is_zero = |active: &[Vertex]| {
            [0x9e37_79b9_7f4a_7c15, 0xd1b5_4a32_d192_ed03]
                .iter()
                .all(|&factor| of(&Moved::new(scene, &vertices, Move::Anywhere(active, factor))).sign().is_zero())
        };
        if is_zero(&vertices) {
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
        let signs = (0..=movable.len())
            .map(|active| of(&Moved::new(scene, &vertices, Move::Slightly(&movable[..active]))).sign());
        signs.into_iter().find(|sign| !sign.is_zero()).expect("the determinant is zero for certain moves only")
    };
    let matrix = |moved: &Moved| {
        let row = |&v: &Vertex| {
            let point = moved.point(scene, v);
            let weight = point.last().cloned();
            axes.iter().map(|axis| point[axis.index()].clone()).chain(weight).collect()
        };
        args.iter().map(row).collect::<Vec<Vec<Polynomial>>>()
    };
    let determinant = sign(&|moved| determinant(&matrix(moved)));
    args.iter().fold(determinant, |product, &v| {
        product * sign(&|moved| moved.point(scene, v).pop().expect("a point has a weight"))
    })
}
