//! The exact rational point of a constructed vertex: linear equations, solved by Cramer's rule.
//!
//! A line of the plane is one equation, and so is a plane of space. A line of space is two equations: two planes
//! through the line, each along an axis that is not parallel to the line. There are as many equations as unknowns; each
//! determinant is expanded term by term. The points of a definition may be constructed themselves; they are solved
//! first.
//!
//! The points of a definition share one denominator, so that all steps work on integers and no fraction is reduced.

use std::collections::BTreeMap;

use predicament_predicates::{Construction, Scene, Share, Vertex};
use rug::{Integer, Rational};

use crate::integers::over_one_denominator;
use crate::row::Row;

/// The exact coordinates of any vertex of the scene.
///
/// Returns `None` for a constructed vertex whose lines and planes don't meet in a single point, or whose definition
/// uses such a vertex.
///
/// # Panics
/// If the scene has no such vertex.
#[must_use]
pub fn point(scene: &Scene, v: Vertex) -> Option<Vec<Rational>> {
    row(scene, v).map(|row| row.point())
}

/// The exact coordinates of any vertex as in [`point`], over one denominator.
pub(crate) fn row(scene: &Scene, v: Vertex) -> Option<Row> {
    let input = |v| {
        let (coordinates, weight) = over_one_denominator(scene.point(v));
        Row { coordinates, weight }
    };
    Solver { scene, input: &input, known: BTreeMap::new() }.row(v)
}

/// The row of any vertex; a constructed vertex is solved again on each call.
///
/// # Panics
/// If the definition of a constructed vertex gives no point.
pub(crate) fn certain_row(scene: &Scene, v: Vertex) -> Row {
    row(scene, v).unwrap_or_else(|| panic!("{v} is not a point"))
}

/// The points of a scene. Each constructed point is computed once, since many definitions may use it.
pub(crate) struct Solver<'s> {
    pub(crate) scene: &'s Scene,
    /// The coordinates of input vertices.
    pub(crate) input: &'s dyn Fn(Vertex) -> Row,
    pub(crate) known: BTreeMap<Vertex, Option<Row>>,
}

impl Solver<'_> {
    pub(crate) fn row(&mut self, v: Vertex) -> Option<Row> {
        let Some(index) = v.construction() else { return Some((self.input)(v)) };
        if let Some(known) = self.known.get(&v) {
            return known.clone();
        }
        let row = self.meet(&self.scene.constructions()[index]);
        self.known.insert(v, row.clone());
        row
    }

    /// The intersection point of the lines and planes of a construction.
    fn meet(&mut self, construction: &Construction) -> Option<Row> {
        let vertices: Vec<Vertex> = construction.flats().flatten().copied().collect();
        let rows: Vec<Row> = vertices.iter().map(|&v| self.row(v)).collect::<Option<_>>()?;
        let one = rows.iter().fold(Integer::from(1), |one, row| one.lcm(&row.weight));
        let over_one = |row: &Row| -> Vec<Integer> {
            let factor = Integer::from(one.div_exact_ref(&row.weight));
            row.coordinates.iter().map(|x| Integer::from(x * &factor)).collect()
        };
        let points: Vec<Vec<Integer>> = rows.iter().map(over_one).collect();
        let mut row = match construction {
            Construction::Ratio { share, .. } => shared(&points, *share),
            Construction::Ssi(_) | Construction::Lpi { .. } | Construction::Tpi(_) => {
                solve(&equations(construction, &points)?)?
            }
        };
        row.weight *= one;
        if construction.is_of_inputs() { Some(row) } else { Some(row.reduced()) }
    }
}

/// The equations of the lines and planes of a construction, in units of one denominator.
///
/// Returns `None` for a line whose ends coincide, and for a share of a segment, which needs no equations.
fn equations(construction: &Construction, points: &[Vec<Integer>]) -> Option<Vec<Equation>> {
    Some(match construction {
        Construction::Ssi(_) => points.chunks(2).map(line).collect(),
        Construction::Lpi { .. } => {
            let (ends, plane) = points.split_at(2);
            let along = minus(&ends[1], &ends[0]);
            let longest = (0..3).find(|&axis| !along[axis].is_zero())?;
            let sides = (0..3).filter(|&axis| axis != longest).map(|axis| {
                let mut other = vec![Integer::new(); 3];
                other[axis] += 1;
                through(normal(&along, &other), &ends[0])
            });
            sides.chain([spanned(plane)]).collect()
        }
        Construction::Tpi(_) => points.chunks(3).map(spanned).collect(),
        Construction::Ratio { .. } => return None,
    })
}

/// The point that divides a segment: coordinate by coordinate p/q of the first end and the rest of the second.
fn shared(ends: &[Vec<Integer>], share: Share) -> Row {
    let [p, q] = share.fraction().map(Integer::from);
    let of_second = Integer::from(&q - &p);
    let part = |(a, c): (&Integer, &Integer)| Integer::from(a * &p) + Integer::from(c * &of_second);
    Row { coordinates: ends[0].iter().zip(&ends[1]).map(part).collect(), weight: q }
}

/// The linear equation a·x = b.
struct Equation {
    a: Vec<Integer>,
    b: Integer,
}

/// The equation of the line of the plane through two points.
fn line(ends: &[Vec<Integer>]) -> Equation {
    // The direction, rotated by a right angle.
    let [x, y]: [Integer; 2] = [0, 1].map(|i| Integer::from(&ends[1][i] - &ends[0][i]));
    through(vec![-y, x], &ends[0])
}

/// The equation of the line or plane with normal `a` through `p`.
fn through(a: Vec<Integer>, p: &[Integer]) -> Equation {
    let b = a.iter().zip(p).map(|(a, p)| Integer::from(a * p)).sum();
    Equation { a, b }
}

/// The equation of the plane through three points.
fn spanned(points: &[Vec<Integer>]) -> Equation {
    through(normal(&minus(&points[1], &points[0]), &minus(&points[2], &points[0])), &points[0])
}

fn minus(p: &[Integer], q: &[Integer]) -> Vec<Integer> {
    p.iter().zip(q).map(|(p, q)| Integer::from(p - q)).collect()
}

fn normal(u: &[Integer], v: &[Integer]) -> Vec<Integer> {
    let minor = |i: usize, j: usize| Integer::from(&u[i] * &v[j]) - Integer::from(&u[j] * &v[i]);
    vec![minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// The solution of two or three equations by Cramer's rule, or `None` if they are linearly dependent.
///
/// Each determinant is a minor of the matrix with the right sides as its last column.
fn solve(equations: &[Equation]) -> Option<Row> {
    let row = |at: usize| -> Vec<&Integer> { equations[at].a.iter().chain([&equations[at].b]).collect() };
    let (weight, coordinates) = match equations.len() {
        2 => {
            let two = minors([&row(0), &row(1)]);
            let [weight, x, y] = [[0, 1], [2, 1], [0, 2]].map(|[i, j]: [usize; 2]| two[i][j].clone());
            (weight, vec![x, y])
        }
        3 => {
            let (first, two) = (row(0), minors([&row(1), &row(2)]));
            let three = |[i, j, k]: [usize; 3]| {
                Integer::from(first[i] * &two[j][k]) + Integer::from(first[j] * &two[k][i]) + first[k] * &two[i][j]
            };
            (three([0, 1, 2]), [[3, 1, 2], [0, 3, 2], [0, 1, 3]].map(three).to_vec())
        }
        other => panic!("{other} equations don't meet in a point"),
    };
    match weight.cmp0() {
        std::cmp::Ordering::Equal => None,
        std::cmp::Ordering::Greater => Some(Row { coordinates, weight }),
        std::cmp::Ordering::Less => {
            Some(Row { coordinates: coordinates.into_iter().map(|x| -x).collect(), weight: -weight })
        }
    }
}

/// The determinants of two rows in each pair of columns.
fn minors([a, b]: [&[&Integer]; 2]) -> [[Integer; 4]; 4] {
    let mut minors: [[Integer; 4]; 4] = Default::default();
    for i in 0..a.len() {
        for j in 0..i {
            let minor = Integer::from(a[j] * b[i]) - a[i] * b[j];
            minors[i][j] = Integer::from(-&minor);
            minors[j][i] = minor;
        }
    }
    minors
}
