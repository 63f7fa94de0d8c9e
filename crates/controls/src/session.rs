//! One session for all controls: a scene, and a way to compute determinants.

use predicament_predicates::{Axis, Dimension, Plane, PredicateKind, Predicates, Question, Scene, Sign, Tally, Vertex};

/// How a control computes: a determinant for each predicate, and what sign it makes of it.
pub(crate) trait Float: Sync {
    fn orient2d(&self, points: [[f64; 2]; 3]) -> f64;
    fn orient3d(&self, points: [[f64; 3]; 4]) -> f64;
    fn incircle(&self, points: [[f64; 2]; 4]) -> f64;
    fn insphere(&self, points: [[f64; 3]; 5]) -> f64;

    /// The sign that is answered for a determinant.
    #[inline]
    fn sign(&self, determinant: f64) -> Sign {
        Sign::of(determinant)
    }
}

/// A control, prepared for one scene.
pub struct Session<'s, F, T> {
    scene: &'s Scene,
    /// The scene's points, in the view of its dimension; the other one is empty.
    points2: &'s [[f64; 2]],
    points3: &'s [[f64; 3]],
    float: F,
    tally: T,
}

impl<'s, F, T> Session<'s, F, T> {
    pub(crate) fn new(scene: &'s Scene, float: F, tally: T) -> Session<'s, F, T> {
        let (points2, points3): (&[_], &[_]) = match scene.dimension() {
            Dimension::Two => (scene.coordinates().as_chunks().0, &[]),
            Dimension::Three => (&[], scene.coordinates().as_chunks().0),
        };
        Session { scene, points2, points3, float, tally }
    }
}

#[allow(private_bounds)] // the methods are private as well
impl<F: Float, T: Tally> Session<'_, F, T> {
    /// a − b: what a comparison amounts to. It is zero for equal coordinates
    /// only, since differences underflow gradually.
    #[inline]
    fn difference(&self, axis: Axis, a: Vertex, b: Vertex) -> f64 {
        self.scene.coordinate(axis, a) - self.scene.coordinate(axis, b)
    }

    // Inlined always: points that go through memory cost several times the determinant.

    #[inline(always)]
    fn points2<const N: usize>(&self, plane: Plane, vertices: [Vertex; N]) -> [[f64; 2]; N] {
        let mut points = [[0.0; 2]; N];
        if let (Dimension::Two, Plane::Xy) = (self.scene.dimension(), plane) {
            for (point, v) in points.iter_mut().zip(vertices) {
                *point = self.points2[v.index()];
            }
        } else {
            let [x, y] = plane.axes().map(Axis::index);
            for (point, v) in points.iter_mut().zip(vertices) {
                let solid = self.points3[v.index()];
                *point = [solid[x], solid[y]];
            }
        }
        points
    }

    #[inline(always)]
    fn points3<const N: usize>(&self, vertices: [Vertex; N]) -> [[f64; 3]; N] {
        let mut points = [[0.0; 3]; N];
        for (point, v) in points.iter_mut().zip(vertices) {
            *point = self.points3[v.index()];
        }
        points
    }

    /// The coordinates of a 2D scene.
    ///
    /// # Panics
    /// If the scene is 3D, where a circle through three points says nothing
    /// about a fourth: `supports` refuses it.
    #[inline(always)]
    fn flat<const N: usize>(&self, vertices: [Vertex; N]) -> [[f64; 2]; N] {
        assert!(self.scene.dimension() == Dimension::Two, "incircle needs a 2D scene");
        let mut points = [[0.0; 2]; N];
        for (point, v) in points.iter_mut().zip(vertices) {
            *point = self.points2[v.index()];
        }
        points
    }

    #[inline]
    fn answer(&self, kind: PredicateKind, determinant: f64) -> Sign {
        self.tally.settled(kind, 0);
        self.float.sign(determinant)
    }
}

impl<F: Float, T: Tally> Predicates for Session<'_, F, T> {
    #[inline]
    fn scene(&self) -> &Scene {
        self.scene
    }

    #[inline]
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.answer(PredicateKind::Compare, self.difference(axis, a, b))
    }

    #[inline]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.answer(PredicateKind::Orient2d, self.float.orient2d(self.points2(plane, [a, b, c])))
    }

    #[inline]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.answer(PredicateKind::Orient3d, self.float.orient3d(self.points3([a, b, c, d])))
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.answer(PredicateKind::Incircle, self.float.incircle(self.flat([a, b, c, d])))
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.answer(PredicateKind::Insphere, self.float.insphere(self.points3([a, b, c, d, e])))
    }

    /// The determinant; none for wrong numbers of vertices. For a comparison
    /// it is the difference.
    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        match (question, args) {
            (Question::Compare(axis), &[a, b]) => Some(self.difference(axis, a, b)),
            (Question::Orient2d(plane), &[a, b, c]) => Some(self.float.orient2d(self.points2(plane, [a, b, c]))),
            (Question::Orient3d, &[a, b, c, d]) => Some(self.float.orient3d(self.points3([a, b, c, d]))),
            (Question::Incircle, &[a, b, c, d]) => Some(self.float.incircle(self.flat([a, b, c, d]))),
            (Question::Insphere, &[a, b, c, d, e]) => Some(self.float.insphere(self.points3([a, b, c, d, e]))),
            _ => None,
        }
    }
}
