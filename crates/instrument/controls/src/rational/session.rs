//! The session of rational predicates: the points of one scene, and the answers.

use predicament_predicates::{
    Axis, Construction, Declined, Derived, PredicateKind, Predicates, Question, Refused, Scene, Sessions, Sign, Tally,
    Vertex, answer_by, formula,
};
use rug::Rational;

use super::determinant::{Point, four, lifted, minus, three, two};
use super::{ExactRational, meet};

/// A scene with rational coordinates; about 100 bytes for each coordinate.
pub struct RationalSession<T> {
    /// The scene, including vertices constructed during the session.
    scene: Scene,
    /// The coordinates of the input vertices, then those of the constructed vertices.
    coordinates: Vec<Rational>,
    tally: T,
}

impl<T: Tally> RationalSession<T> {
    pub(super) fn new(scene: &Scene, tally: T) -> Result<RationalSession<T>, Declined> {
        let mut coordinates: Vec<Rational> = scene.coordinates().iter().map(|&x| rational(x)).collect();
        for (index, construction) in scene.constructions().iter().enumerate() {
            let point = meet::point(construction, |v| place(&coordinates, scene, v))
                .map_err(|why| Declined::scene(format!("{} = {construction}: {why}", Vertex::constructed(index))))?;
            coordinates.extend(point);
        }
        Ok(RationalSession { scene: scene.clone(), coordinates, tally })
    }

    fn point(&self, v: Vertex) -> Point<'_> {
        place(&self.coordinates, &self.scene, v)
    }

    /// The answer to one of the five predicates.
    fn ask<const N: usize>(&self, question: Question, vertices: [Vertex; N]) -> Sign {
        self.tally.settled(question.kind(), 0);
        let points = vertices.map(|v| self.point(v));
        sign(&match (question, points.as_slice()) {
            (Question::Compare(axis), &[a, b]) => return a[axis.index()].cmp(&b[axis.index()]).into(),
            (Question::Orient2d(plane), &[a, b, c]) => {
                let axes = plane.axes().map(Axis::index);
                two([&minus(a, c, axes), &minus(b, c, axes)])
            }
            (Question::Orient3d, &[a, b, c, d]) => {
                three([a, b, c].map(|p| minus(p, d, XYZ)).each_ref().map(|p| &p[..]))
            }
            (Question::Incircle, &[a, b, c, d]) => {
                three([a, b, c].map(|p| lifted(minus(p, d, XY))).each_ref().map(Vec::as_slice))
            }
            (Question::Insphere, &[a, b, c, d, e]) => {
                four([a, b, c, d].map(|p| lifted(minus(p, e, XYZ))).each_ref().map(Vec::as_slice))
            }
            _ => unreachable!("{question:?} of {N} vertices"),
        })
    }

    /// The value of a formula by its program, one rational operation after the other.
    fn formula(&self, derived: Derived, vertices: &[Vertex]) -> Option<Rational> {
        let count = self.scene.dimension().count();
        // A weight is the coordinate after the last one.
        let coordinate = |point: usize, axis: usize| match vertices[point] {
            v if axis < count => self.point(v)[axis].clone(),
            v => rational(self.scene.weights()[v.index()]),
        };
        derived.formula().program().evaluate(coordinate, rational, |op, [a, b]| {
            Some(match op {
                formula::Op::Add(..) => Rational::from(a + b),
                formula::Op::Sub(..) => Rational::from(a - b),
                formula::Op::Mul(..) => Rational::from(a * b),
                _ => Rational::from(-a),
            })
        })
    }
}

const XY: [usize; 2] = [0, 1];
const XYZ: [usize; 3] = [0, 1, 2];

/// The rational with the value of a double.
fn rational(x: f64) -> Rational {
    Rational::from_f64(x).expect("coordinates, weights and constants are finite")
}

fn sign(value: &Rational) -> Sign {
    value.cmp0().into()
}

/// The coordinates of a vertex.
fn place<'c>(coordinates: &'c [Rational], scene: &Scene, v: Vertex) -> Point<'c> {
    let stride = scene.dimension().count();
    &coordinates[stride * v.construction().map_or(v.index(), |index| scene.len() + index)..][..stride]
}

impl<T: Tally> Predicates for RationalSession<T> {
    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        let before = self.coordinates.len();
        let coordinates = &mut self.coordinates;
        let vertices = self.scene.construct_all(definitions, |scene, vertex| {
            let construction = scene.construction(vertex).expect("just constructed");
            let point = meet::point(construction, |v| place(coordinates, scene, v))?;
            coordinates.extend(point);
            Ok(())
        });
        if vertices.is_err() {
            self.coordinates.truncate(before);
        }
        vertices
    }

    answer_by!(ask);

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        if matches!(kind, PredicateKind::Derived(_)) && !self.scene.constructions().is_empty() {
            return Err(Declined::predicate(kind, "formulas are about input vertices, not about constructed ones"));
        }
        self.scene.has_dimension_for(kind)
    }

    fn sign(&self, predicate: Derived, vertices: &[Vertex]) -> Sign {
        self.tally.settled(PredicateKind::Derived(predicate), 0);
        assert_eq!(vertices.len(), predicate.arity(), "{} has its number of vertices", predicate.name());
        sign(&self.formula(predicate, vertices).expect("rationals hold every value"))
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        Some(&ExactRational)
    }
}
