//! The rational point of a constructed vertex: linear equations by Cramer's rule.
//!
//! A line of the plane is one equation, a plane of space is one, and a line of
//! space is where two planes meet: through the line and along an axis that is
//! not the line's own. As many equations as unknowns; each determinant is
//! expanded term by term. The points of a definition may be constructed
//! themselves: theirs are found first.

use std::collections::BTreeMap;

use predicament_predicates::{Construction, Scene, Vertex};
use rug::Rational;

use crate::determinant::{determinant, rational};

/// The exact coordinates of any vertex of the scene; none for a constructed
/// vertex whose lines and planes don't meet in one point, or go through such a vertex.
///
/// # Panics
/// If the scene has no such vertex.
#[must_use]
pub fn point(scene: &Scene, v: Vertex) -> Option<Vec<Rational>> {
    Points { scene, known: BTreeMap::new() }.point(v)
}

/// Points of a scene, each constructed one computed once: many may define one vertex.
struct Points<'s> {
    scene: &'s Scene,
    known: BTreeMap<Vertex, Option<Vec<Rational>>>,
}

impl Points<'_> {
    fn point(&mut self, v: Vertex) -> Option<Vec<Rational>> {
        let Some(index) = v.construction() else {
            return Some(self.scene.point(v).iter().map(|&x| rational(x)).collect());
        };
        if let Some(known) = self.known.get(&v) {
            return known.clone();
        }
        let point = self.equations(&self.scene.constructions()[index]).and_then(|equations| solve(&equations));
        self.known.insert(v, point.clone());
        point
    }

    fn points<const N: usize>(&mut self, vertices: [Vertex; N]) -> Option<[Vec<Rational>; N]> {
        let mut points: [Vec<Rational>; N] = std::array::from_fn(|_| Vec::new());
        for (point, v) in points.iter_mut().zip(vertices) {
            *point = self.point(v)?;
        }
        Some(points)
    }

    /// The equations of what meets in the point; none for a line whose ends coincide.
    fn equations(&mut self, construction: &Construction) -> Option<Vec<Equation>> {
        Some(match *construction {
            Construction::Ssi([first, second]) => {
                vec![line(&self.points(first)?), line(&self.points(second)?)]
            }
            Construction::Lpi { line, plane } => {
                let [p, q] = self.points(line)?;
                let along = minus(&q, &p);
                let longest = (0..3).find(|&axis| along[axis].cmp0().is_ne())?;
                let sides = (0..3).filter(|&axis| axis != longest).map(|axis| {
                    let mut other = vec![Rational::new(); 3];
                    other[axis] += 1;
                    through(normal(&along, &other), &p)
                });
                sides.chain([spanned(&self.points(plane)?)]).collect()
            }
            Construction::Tpi([l, m, n]) => {
                vec![spanned(&self.points(l)?), spanned(&self.points(m)?), spanned(&self.points(n)?)]
            }
        })
    }
}

/// a·x = b.
struct Equation {
    a: Vec<Rational>,
    b: Rational,
}

/// The line of the plane through two points.
fn line([p, q]: &[Vec<Rational>; 2]) -> Equation {
    // The direction turned by a right angle.
    let [x, y]: [Rational; 2] = [0, 1].map(|i| Rational::from(&q[i] - &p[i]));
    through(vec![-y, x], p)
}

/// The line or plane with this normal through p.
fn through(a: Vec<Rational>, p: &[Rational]) -> Equation {
    let b = a.iter().zip(p).map(|(a, p)| Rational::from(a * p)).sum();
    Equation { a, b }
}

/// The plane of three points.
fn spanned([p, q, r]: &[Vec<Rational>; 3]) -> Equation {
    through(normal(&minus(q, p), &minus(r, p)), p)
}

fn minus(p: &[Rational], q: &[Rational]) -> Vec<Rational> {
    p.iter().zip(q).map(|(p, q)| Rational::from(p - q)).collect()
}

fn normal(u: &[Rational], v: &[Rational]) -> Vec<Rational> {
    let minor = |i: usize, j: usize| Rational::from(&u[i] * &v[j]) - Rational::from(&u[j] * &v[i]);
    vec![minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// Cramer's rule; none where the equations depend on each other.
fn solve(equations: &[Equation]) -> Option<Vec<Rational>> {
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
    weight.cmp0().is_ne().then(|| (0..equations.len()).map(|i| with_column(Some(i)) / &weight).collect())
}
