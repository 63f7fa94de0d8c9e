//! The backend: floating-point determinants, compared with κ, ξ and the bands of [`circles`].

use nalgebra::{Vector2, Vector3};
use predicament_predicates::{
    Axis, Backend, Band, Contract, Declined, Dimension, Plane, PredicateKind, Predicates, Question, Scene, Sign, Tally,
    Vertex, ZeroMeaning,
};

use crate::extent::largest_extent;
use crate::{Tolerances2d, Tolerances3d, circles, is_sound};

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];
const STAGES: [&str; 1] = ["float"];

/// The tolerance backend: `orient2d` is zero within κ, `orient3d` within ξ.
///
/// The paper has no tolerance for the other predicates: those of `incircle` and
/// `insphere` are ours, derived with its calculus in [`circles`]; the order of
/// coordinates is the raw one, zero where they are equal (what to do with the
/// tie is the caller's business).
///
/// L is the largest edge of the bounding box of all points in the scene; for
/// `orient2d` in a 3D scene, of their projection to its plane, so that the
/// projections are three 2D scenes of their own.
///
/// A scene with constructed vertices is declined.
///
/// A scene where L, a product of coordinate differences or a tolerance leaves
/// the range of normal doubles is declined, as the paper assumes "no underflow
/// or overflow"; where only those of `incircle` or `insphere` do, that predicate is. Where all points coincide (L = 0) the tolerances are zero and
/// everything is degenerate, which is right.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Tolerance;

/// [`Tolerance`], prepared for one scene.
#[derive(Clone, Debug)]
pub struct Session<'s, T> {
    scene: &'s Scene,
    tally: T,
    /// One for each of [`PLANES`]; a 2D scene has the first only.
    planar: Vec<Result<Tolerances2d, Declined>>,
    spatial: Option<Tolerances3d>,
    /// That of `incircle` in 2D, of `insphere` in 3D.
    circular: Result<Band, Declined>,
}

impl Backend for Tolerance {
    type Session<'s, T: Tally + 's> = Session<'s, T>;

    fn name(&self) -> String {
        "tolerance".into()
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        match kind {
            PredicateKind::Compare => Contract { zero: ZeroMeaning::Exact, proved: true },
            PredicateKind::Orient2d | PredicateKind::Orient3d | PredicateKind::Incircle | PredicateKind::Insphere => {
                Contract { zero: ZeroMeaning::Band, proved: true }
            }
        }
    }

    fn stages(&self) -> &'static [&'static str] {
        &STAGES
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
        if !scene.constructions().is_empty() {
            return Err(Declined::scene("the tolerances are for input vertices, not for constructed ones"));
        }
        let planes = match scene.dimension() {
            Dimension::Two => &PLANES[..1],
            Dimension::Three => &PLANES,
        };
        let planar: Vec<_> = planes.iter().map(|&plane| planar(scene, plane)).collect();
        let spatial = match scene.dimension() {
            Dimension::Two => None,
            Dimension::Three => Some(spatial(scene)?),
        };
        if let (Dimension::Two, Err(declined)) = (scene.dimension(), &planar[0]) {
            return Err(Declined::scene(declined.reason.clone()));
        }
        Ok(Session { scene, tally, planar, spatial, circular: circles::prepared(scene) })
    }
}

/// The tolerances of one projection, if doubles can hold them.
fn planar(scene: &Scene, plane: Plane) -> Result<Tolerances2d, Declined> {
    let tolerances = Tolerances2d::from_length(largest_extent(scene, &plane.axes()));
    let Tolerances2d { length, sigma, kappa, .. } = tolerances;
    if length == 0.0 || (is_sound(sigma) && is_sound(kappa) && (2.0 * length * length).is_finite()) {
        return Ok(tolerances);
    }
    let reason = format!("with L = {length:e} the tolerance κ = 21 ε L² or an area leaves the range of normal doubles");
    Err(Declined::predicate(PredicateKind::Orient2d, reason))
}

/// The tolerances of space, if doubles can hold them.
fn spatial(scene: &Scene) -> Result<Tolerances3d, Declined> {
    let tolerances = Tolerances3d::from_length(largest_extent(scene, &[Axis::X, Axis::Y, Axis::Z]));
    let Tolerances3d { length, sigma, xi, .. } = tolerances;
    if length == 0.0 || (is_sound(sigma) && is_sound(xi) && (6.0 * length * length * length).is_finite()) {
        return Ok(tolerances);
    }
    let reason =
        format!("with L = {length:e} the tolerance ξ = 56 ε^¾ L³ or a volume leaves the range of normal doubles");
    Err(Declined::scene(reason))
}

/// Zero within the tolerance, else the sign of the computed value.
#[inline]
fn register(value: f64, band: Band) -> Sign {
    if value.abs() <= band.width { Sign::Zero } else { Sign::of(value) }
}

impl<T> Session<'_, T> {
    /// The tolerances of a projection; a 2D scene has only [`Plane::Xy`].
    ///
    /// # Errors
    /// [`Declined`] where the projection has none, or is not of this scene.
    pub fn tolerances2d(&self, plane: Plane) -> Result<&Tolerances2d, Declined> {
        match self.planar.get(plane as usize) {
            Some(tolerances) => tolerances.as_ref().map_err(Clone::clone),
            None => Err(Declined::predicate(PredicateKind::Orient2d, "a 2D scene has no such projection")),
        }
    }

    /// The tolerances of a 3D scene.
    #[must_use]
    pub fn tolerances3d(&self) -> Option<&Tolerances3d> {
        self.spatial.as_ref()
    }

    /// Twice the signed area, as Algorithm 5 computes its first: edge vectors
    /// from the last point, then their cross product.
    #[inline]
    fn area(&self, plane: Plane, [a, b, c]: [Vertex; 3]) -> f64 {
        let [a, b, c] = [a, b, c].map(|v| Vector2::from(self.scene.point2(plane, v)));
        (a - c).perp(&(b - c))
    }

    /// Six times the signed volume, as Algorithm 11 computes its first: edge
    /// vectors from the last point, a cross product and a dot product.
    #[inline]
    fn volume(&self, [a, b, c, d]: [Vertex; 4]) -> f64 {
        let [a, b, c, d] = [a, b, c, d].map(|v| Vector3::from(self.scene.point3(v)));
        (a - d).cross(&(b - d)).dot(&(c - d))
    }

    /// The determinant of `incircle`, in the order of [`circles::incircle`].
    #[inline]
    fn circle(&self, vertices: [Vertex; 4]) -> f64 {
        circles::incircle(&vertices.map(|v| self.scene.point2(Plane::Xy, v)))
    }

    /// The determinant of `insphere`, in the order of [`circles::insphere`].
    #[inline]
    fn sphere(&self, vertices: [Vertex; 5]) -> f64 {
        circles::insphere(&vertices.map(|v| self.scene.point3(v)))
    }

    /// The band of the predicate for circles that scenes of `dimension` have.
    fn circular(&self, dimension: Dimension) -> Result<Band, Declined> {
        if self.scene.dimension() == dimension {
            return self.circular.clone();
        }
        Err(match dimension {
            Dimension::Two => Declined::predicate(PredicateKind::Incircle, "needs a 2D scene"),
            Dimension::Three => Declined::predicate(PredicateKind::Insphere, "needs a 3D scene"),
        })
    }

    #[inline]
    fn circle_band(&self, dimension: Dimension) -> Band {
        match &self.circular {
            Ok(band) if self.scene.dimension() == dimension => *band,
            _ => panic!("{}", self.circular(dimension).expect_err("declined")),
        }
    }

    #[inline]
    fn kappa(&self, plane: Plane) -> Band {
        match self.tolerances2d(plane) {
            Ok(tolerances) => tolerances.kappa,
            Err(declined) => panic!("{declined}"),
        }
    }

    #[inline]
    fn xi(&self) -> Band {
        self.spatial.expect("orient3d needs a 3D scene").xi
    }
}

impl<T: Tally> Predicates for Session<'_, T> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        match kind {
            PredicateKind::Compare => Ok(()),
            PredicateKind::Orient2d => {
                self.planar.iter().try_for_each(|plane| plane.as_ref().map(|_| ()).map_err(Clone::clone))
            }
            PredicateKind::Orient3d if self.spatial.is_some() => Ok(()),
            PredicateKind::Orient3d => Err(Declined::predicate(kind, "needs a 3D scene")),
            PredicateKind::Incircle => self.circular(Dimension::Two).map(|_| ()),
            PredicateKind::Insphere => self.circular(Dimension::Three).map(|_| ()),
        }
    }

    #[inline]
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Compare, 0);
        let (a, b) = (self.scene.coordinate(axis, a), self.scene.coordinate(axis, b));
        a.partial_cmp(&b).expect("coordinates are finite").into()
    }

    #[inline]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Orient2d, 0);
        register(self.area(plane, [a, b, c]), self.kappa(plane))
    }

    #[inline]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Orient3d, 0);
        register(self.volume([a, b, c, d]), self.xi())
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Incircle, 0);
        register(self.circle([a, b, c, d]), self.circle_band(Dimension::Two))
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Insphere, 0);
        register(self.sphere([a, b, c, d, e]), self.circle_band(Dimension::Three))
    }

    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        match (question, args) {
            (Question::Orient2d(plane), &[a, b, c]) => Some(self.area(plane, [a, b, c])),
            (Question::Orient3d, &[a, b, c, d]) => Some(self.volume([a, b, c, d])),
            (Question::Incircle, &[a, b, c, d]) => Some(self.circle([a, b, c, d])),
            (Question::Insphere, &[a, b, c, d, e]) => Some(self.sphere([a, b, c, d, e])),
            _ => None,
        }
    }

    /// κ of the projection, ξ, or a band of [`circles`].
    fn band(&self, question: Question) -> Option<Band> {
        match question {
            Question::Orient2d(plane) => self.tolerances2d(plane).ok().map(|tolerances| tolerances.kappa),
            Question::Orient3d => self.spatial.map(|tolerances| tolerances.xi),
            Question::Incircle => self.circular(Dimension::Two).ok(),
            Question::Insphere => self.circular(Dimension::Three).ok(),
            Question::Compare(_) => None,
        }
    }

    /// σ₊, the largest of the tolerances that are distances.
    fn reach(&self) -> f64 {
        match (&self.spatial, &self.planar[0]) {
            (Some(tolerances), _) => tolerances.sigma.upper,
            (None, Ok(tolerances)) => tolerances.sigma.upper,
            (None, Err(_)) => 0.0,
        }
    }
}
