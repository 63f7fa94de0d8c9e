//! The rational point of a constructed vertex: linear equations by Cramer's rule.
//!
//! A line of the plane is one equation, a plane of space is one, and a line of
//! space is where two planes meet: through the line and along an axis that is
//! not the line's own. As many equations as unknowns; each determinant is
//! expanded term by term. The points of a definition may be constructed
//! themselves: theirs are found first.
//!
//! The points of a definition are taken over one denominator, so that all this is
//! about integers and no fraction is reduced on the way.

use std::collections::BTreeMap;

use predicament_predicates::{Construction, Scene, Vertex};
use rug::{Integer, Rational};

use crate::integers::over_one_denominator;
use crate::row::Row;

/// The exact coordinates of any vertex of the scene; none for a constructed
/// vertex whose lines and planes don't meet in one point, or go through such a vertex.
///
/// # Panics
/// If the scene has no such vertex.
#[must_use]
pub fn point(scene: &Scene, v: Vertex) -> Option<Vec<Rational>> {
    row(scene, v).map(|row| row.point())
}

/// The same over one denominator.
pub(crate) fn row(scene: &Scene, v: Vertex) -> Option<Row> {
    Points { scene, known: BTreeMap::new() }.row(v)
}

/// The row of any vertex, solved for anew if it is constructed.
///
/// # Panics
/// If a constructed vertex is no point.
pub(crate) fn certain_row(scene: &Scene, v: Vertex) -> Row {
    row(scene, v).unwrap_or_else(|| panic!("{v} is no point"))
}

/// Points of a scene, each constructed one computed once: many may define one vertex.
struct Points<'s> {
    scene: &'s Scene,
    known: BTreeMap<Vertex, Option<Row>>,
}

impl Points<'_> {
    fn row(&mut self, v: Vertex) -> Option<Row> {
        let Some(index) = v.construction() else {
            let (coordinates, weight) = over_one_denominator(self.scene.point(v));
            return Some(Row { coordinates, weight });
        };
        if let Some(known) = self.known.get(&v) {
            return known.clone();
        }
        let row = self.meet(&self.scene.constructions()[index]);
        self.known.insert(v, row.clone());
        row
    }

    /// Where lines and planes meet.
    fn meet(&mut self, construction: &Construction) -> Option<Row> {
        let vertices: Vec<Vertex> = construction.flats().flatten().copied().collect();
        let rows: Vec<Row> = vertices.iter().map(|&v| self.row(v)).collect::<Option<_>>()?;
        let one = rows.iter().fold(Integer::from(1), |one, row| one.lcm(&row.weight));
        let over_one = |row: &Row| -> Vec<Integer> {
            let factor = Integer::from(one.div_exact_ref(&row.weight));
            row.coordinates.iter().map(|x| Integer::from(x * &factor)).collect()
        };
        let points: Vec<Vec<Integer>> = rows.iter().map(over_one).collect();
        let mut row = solve(&equations(construction, &points)?)?;
        row.weight *= one;
        if construction.is_of_inputs() { Some(row) } else { Some(row.reduced()) }
    }
}

/// The equations of what meets, in units of one denominator; none for a line whose ends coincide.
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
    })
}

/// a·x = b.
struct Equation {
    a: Vec<Integer>,
    b: Integer,
}

/// The line of the plane through two points.
fn line(ends: &[Vec<Integer>]) -> Equation {
    // The direction turned by a right angle.
    let [x, y]: [Integer; 2] = [0, 1].map(|i| Integer::from(&ends[1][i] - &ends[0][i]));
    through(vec![-y, x], &ends[0])
}

/// The line or plane with this normal through p.
fn through(a: Vec<Integer>, p: &[Integer]) -> Equation {
    let b = a.iter().zip(p).map(|(a, p)| Integer::from(a * p)).sum();
    Equation { a, b }
}

/// The plane of three points.
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

/// Cramer's rule; none where the equations depend on each other.
fn solve(equations: &[Equation]) -> Option<Row> {
    let with_column = |replaced: Option<usize>| {
        let row = |Equation { a, b }: &Equation| {
            let mut row = a.clone();
            if let Some(column) = replaced {
                row[column].clone_from(b);
            }
            row
        };
        determinant(&equations.iter().map(row).collect::<Vec<_>>())
    };
    let weight = with_column(None);
    let coordinates = || (0..equations.len()).map(|i| with_column(Some(i))).collect();
    match weight.cmp0() {
        std::cmp::Ordering::Equal => None,
        std::cmp::Ordering::Greater => Some(Row { coordinates: coordinates(), weight }),
        std::cmp::Ordering::Less => {
            let coordinates: Vec<Integer> = coordinates();
            Some(Row { coordinates: coordinates.into_iter().map(|x| -x).collect(), weight: -weight })
        }
    }
}

/// Along the first row.
fn determinant(rows: &[Vec<Integer>]) -> Integer {
    let [first, others @ ..] = rows else { return Integer::from(1) };
    let mut sum = Integer::new();
    for (column, x) in first.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
        let without = |row: &Vec<Integer>| {
            row.iter().enumerate().filter(|&(at, _)| at != column).map(|(_, x)| x.clone()).collect()
        };
        let term = determinant(&others.iter().map(without).collect::<Vec<_>>()) * x;
        if column.is_multiple_of(2) {
            sum += term;
        } else {
            sum -= term;
        }
    }
    sum
}
