//! The backend: floating-point determinants, compared with κ, ξ and the bands of [`circles`].

use std::marker::PhantomData;

use predicament_predicates::{
    Axis, Backend, Band, Construction, Contract, Declined, Dimension, Plane, PredicateKind, Predicates, Question,
    Refused, Scene, Sign, Tally, Vertex, ZeroMeaning,
};

use crate::band::is_sound;
use crate::contacts::{EdgeVertex, Pairs};
use crate::extent::largest_extent;
use crate::float::check_precision;
use crate::quantities;
use crate::{ContactTolerances, Float, Misscaled, Tolerances2d, Tolerances3d, circles};

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];
const STAGES: [&str; 1] = ["float"];
const INPUT_ONLY: &str = "the tolerances are for input vertices, not for constructed ones";

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
/// Contacts are the paper's Algorithms 2 to 5 and 7 to 12, with the tolerances
/// of Algorithm 1 or 6 for the scene's
/// [primitive lengths](Scene::primitive_lengths), and without such lengths
/// declined. They have an L of their own, [`Session::contact_tolerances`].
///
/// Everything is computed in `F`: `f64`, or `f32` for scenes whose coordinates
/// are numbers of it; other scenes are declined. So are those with constructed
/// vertices, and sessions construct none: κ and ξ bound the rounding of
/// determinants of input vertices, not that of a computed vertex beside it.
///
/// A scene where L, a product of coordinate differences or a tolerance leaves
/// the range of normal numbers of `F` is declined, as the paper assumes "no
/// underflow or overflow"; where only those of `incircle` or `insphere` do,
/// that predicate is. Where all points coincide (L = 0) the tolerances are
/// zero and everything is degenerate, which is right; where all primitives are
/// points, only equal ones are in contact.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Tolerance<F = f64> {
    form: EdgeVertex,
    misscaled: Option<Misscaled>,
    float: PhantomData<F>,
}

/// The backend in double precision.
#[allow(non_upper_case_globals)] // it reads as the unit struct that it would be without its parameter
pub const Tolerance: Tolerance = Tolerance::new();

impl<F> Tolerance<F> {
    /// The scheme as it has to be.
    #[must_use]
    pub const fn new() -> Tolerance<F> {
        Tolerance { form: EdgeVertex::Corrected, misscaled: None, float: PhantomData }
    }

    /// The scheme with Algorithms 3 and 8 as the paper prints them, which is
    /// wrong: see [`as_printed`](crate::algorithms::as_printed).
    #[must_use]
    pub const fn as_printed() -> Tolerance<F> {
        Tolerance { form: EdgeVertex::AsPrinted, misscaled: None, float: PhantomData }
    }

    /// The scheme with a tolerance that is not the paper's: a planted fault.
    #[must_use]
    pub const fn misscaled(by: Misscaled) -> Tolerance<F> {
        Tolerance { form: EdgeVertex::Corrected, misscaled: Some(by), float: PhantomData }
    }
}

impl<F> Default for Tolerance<F> {
    fn default() -> Tolerance<F> {
        Tolerance::new()
    }
}

/// [`struct@Tolerance`], prepared for one scene.
#[derive(Clone, Debug)]
pub struct Session<'s, T, F = f64> {
    scene: &'s Scene,
    tally: T,
    /// One for each of [`PLANES`]; a 2D scene has the first only.
    planar: Vec<Result<Tolerances2d<F>, Declined>>,
    spatial: Option<Tolerances3d<F>>,
    /// That of `incircle` in 2D, of `insphere` in 3D.
    circular: Result<Band, Declined>,
    contacts: Result<ContactTolerances<F>, Declined>,
    form: EdgeVertex,
}

impl<F: Float> Backend for Tolerance<F> {
    type Session<'s, T: Tally + 's> = Session<'s, T, F>;

    /// `tolerance`, `tolerance:f32`, or that of a planted fault for the printed form.
    fn name(&self) -> String {
        let name = match (self.form, self.misscaled) {
            (_, Some(misscaled)) => format!("fault:{}", misscaled.fault),
            (EdgeVertex::Corrected, None) => "tolerance".to_owned(),
            (EdgeVertex::AsPrinted, None) => "fault:tolerance-as-printed".to_owned(),
        };
        if F::NAME == <f64 as Float>::NAME { name } else { format!("{name}:{}", F::NAME) }
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

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T, F>, Declined> {
        check_precision::<F>()?;
        if !scene.constructions().is_empty() {
            return Err(Declined::scene(INPUT_ONLY));
        }
        check_coordinates::<F>(scene)?;
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
        let circular = circles::prepared::<F>(scene);
        let contacts = ContactTolerances::new(scene);
        let (planar, spatial, contacts) = match self.misscaled {
            None => (planar, spatial, contacts),
            Some(by) => (
                planar.into_iter().map(|plane| plane.map(|plane| by.plane(plane))).collect(),
                spatial.map(|space| by.space(space)),
                contacts.map(|contacts| by.contacts(contacts)),
            ),
        };
        Ok(Session { scene, tally, planar, spatial, circular, contacts, form: self.form })
    }
}

/// Whether all coordinates are numbers of `F`.
fn check_coordinates<F: Float>(scene: &Scene) -> Result<(), Declined> {
    let is_exact = |x: &f64| F::nearest(*x).wide() == *x;
    let Some(at) = scene.coordinates().iter().position(|x| !is_exact(x)) else { return Ok(()) };
    let (dimension, x, name) = (scene.dimension().count(), scene.coordinates()[at], F::NAME);
    let (point, axis) = (at / dimension, at % dimension);
    Err(Declined::scene(format!(
        "point {point}: coordinate {axis} is {x}, which {name} does not hold exactly; round the scene to {name} first"
    )))
}

/// The tolerances of one projection, if `F` can hold them.
fn planar<F: Float>(scene: &Scene, plane: Plane) -> Result<Tolerances2d<F>, Declined> {
    let tolerances = Tolerances2d::from_length(F::above(largest_extent(scene, &plane.axes())));
    let check = tolerances.check_range();
    check.map_err(|declined| Declined::predicate(PredicateKind::Orient2d, declined.reason))?;
    Ok(tolerances)
}

/// The tolerances of space, if `F` can hold those of volumes.
fn spatial<F: Float>(scene: &Scene) -> Result<Tolerances3d<F>, Declined> {
    let tolerances = Tolerances3d::from_length(F::above(largest_extent(scene, &[Axis::X, Axis::Y, Axis::Z])));
    let Tolerances3d { length, sigma, xi, .. } = tolerances;
    let volume = F::nearest(6.0) * length * length * length;
    if length == F::ZERO || (is_sound::<F>(sigma) && is_sound::<F>(xi) && volume.wide().is_finite()) {
        return Ok(tolerances);
    }
    let (name, length) = (F::NAME, length.wide());
    let reason =
        format!("with L = {length:e} the tolerance ξ = 56 ε^¾ L³ or a volume leaves the range of normal {name}");
    Err(Declined::scene(reason))
}

/// Zero within the tolerance, else the sign of the computed value.
#[inline(always)]
fn register<F: Float>(value: F, band: Band) -> Sign {
    let value = value.wide();
    if value.abs() <= band.width { Sign::Zero } else { Sign::of(value) }
}

impl<T, F: Float> Session<'_, T, F> {
    /// The tolerances of a projection; a 2D scene has only [`Plane::Xy`].
    ///
    /// # Errors
    /// [`Declined`] where the projection has none, or is not of this scene.
    #[inline]
    pub fn tolerances2d(&self, plane: Plane) -> Result<&Tolerances2d<F>, Declined> {
        match self.planar.get(plane as usize) {
            Some(tolerances) => tolerances.as_ref().map_err(Clone::clone),
            None => Err(Declined::predicate(PredicateKind::Orient2d, "a 2D scene has no such projection")),
        }
    }

    /// The tolerances of a 3D scene.
    #[must_use]
    pub fn tolerances3d(&self) -> Option<&Tolerances3d<F>> {
        self.spatial.as_ref()
    }

    /// The tolerances of contacts.
    ///
    /// # Errors
    /// [`Declined`] where the scene has no primitive lengths, or `F` no room for them.
    pub fn contact_tolerances(&self) -> Result<&ContactTolerances<F>, Declined> {
        self.contacts.as_ref().map_err(Clone::clone)
    }

    fn pairs(&self) -> Pairs<'_, F> {
        match &self.contacts {
            Ok(tolerances) => Pairs { scene: self.scene, tolerances, form: self.form },
            Err(declined) => panic!("{declined}"),
        }
    }

    #[inline(always)]
    fn point2(&self, plane: Plane, v: Vertex) -> [F; 2] {
        let [x, y] = self.scene.point2(plane, v);
        [F::nearest(x), F::nearest(y)]
    }

    #[inline(always)]
    fn point3(&self, v: Vertex) -> [F; 3] {
        let [x, y, z] = self.scene.point3(v);
        [F::nearest(x), F::nearest(y), F::nearest(z)]
    }

    /// Twice the signed area, as Algorithm 5 computes its first: edge vectors
    /// from the last point, then their cross product.
    #[inline(always)]
    fn area(&self, plane: Plane, vertices: [Vertex; 3]) -> F {
        // Point by point: `map` of an array of this size calls its closure as a function, which costs more than the rest.
        let [a, b, c] = vertices;
        let [a, b, c] = [self.point2(plane, a), self.point2(plane, b), self.point2(plane, c)];
        quantities::area(&c, &a, &b)
    }

    /// Six times the signed volume, as Algorithm 11 computes its first: edge
    /// vectors from the last point, a cross product and a dot product.
    #[inline(always)]
    fn volume(&self, vertices: [Vertex; 4]) -> F {
        let [a, b, c, d] = vertices;
        let [a, b, c, d] = [self.point3(a), self.point3(b), self.point3(c), self.point3(d)];
        quantities::volume(&a, &b, &c, &d)
    }

    /// The determinant of `incircle`, in the order of [`circles::incircle`].
    #[inline]
    fn circle(&self, vertices: [Vertex; 4]) -> F {
        let [a, b, c, d] = vertices;
        let plane = Plane::Xy;
        let points = [self.point2(plane, a), self.point2(plane, b), self.point2(plane, c), self.point2(plane, d)];
        circles::incircle(&points)
    }

    /// The determinant of `insphere`, in the order of [`circles::insphere`].
    #[inline]
    fn sphere(&self, vertices: [Vertex; 5]) -> F {
        let [a, b, c, d, e] = vertices;
        let points = [self.point3(a), self.point3(b), self.point3(c), self.point3(d), self.point3(e)];
        circles::insphere(&points)
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

    #[inline(always)]
    fn kappa(&self, plane: Plane) -> Band {
        match self.tolerances2d(plane) {
            Ok(tolerances) => tolerances.kappa,
            Err(declined) => panic!("{declined}"),
        }
    }

    #[inline(always)]
    fn xi(&self) -> Band {
        self.spatial.as_ref().expect("orient3d needs a 3D scene").xi
    }
}

impl<T: Tally, F: Float> Predicates for Session<'_, T, F> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn construct(&mut self, _: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        Err(Refused::session(INPUT_ONLY))
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

    #[inline(always)]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Orient2d, 0);
        register(self.area(plane, [a, b, c]), self.kappa(plane))
    }

    #[inline(always)]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Orient3d, 0);
        register(self.volume([a, b, c, d]), self.xi())
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Incircle, 0);
        let band = self.circle_band(Dimension::Two);
        register(self.circle([a, b, c, d]), band)
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Insphere, 0);
        let band = self.circle_band(Dimension::Three);
        register(self.sphere([a, b, c, d, e]), band)
    }

    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        match (question, args) {
            (Question::Orient2d(plane), &[a, b, c]) => Some(self.area(plane, [a, b, c]).wide()),
            (Question::Orient3d, &[a, b, c, d]) => Some(self.volume([a, b, c, d]).wide()),
            (Question::Incircle, &[a, b, c, d]) => Some(self.circle([a, b, c, d]).wide()),
            (Question::Insphere, &[a, b, c, d, e]) => Some(self.sphere([a, b, c, d, e]).wide()),
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

    /// σ₊, the largest of the tolerances that are distances: that of contacts,
    /// where the scene has primitive lengths.
    fn reach(&self) -> f64 {
        if let Ok(tolerances) = &self.contacts {
            return tolerances.band([0, 0]).map_or(0.0, |sigma| sigma.upper);
        }
        match (&self.spatial, &self.planar[0]) {
            (Some(tolerances), _) => tolerances.sigma.upper,
            (None, Ok(tolerances)) => tolerances.sigma.upper,
            (None, Err(_)) => 0.0,
        }
    }

    fn contact_band(&self, ranks: [u8; 2]) -> Option<Band> {
        self.contacts.as_ref().ok().and_then(|tolerances| tolerances.band(ranks))
    }

    fn supports_contacts(&self) -> Result<(), Declined> {
        self.contact_tolerances().map(|_| ())
    }

    #[inline]
    fn vertex_vertex(&self, a: Vertex, p: Vertex) -> bool {
        self.pairs().vertex_vertex(a, p)
    }

    #[inline]
    fn edge_vertex(&self, edge: [Vertex; 2], p: Vertex) -> Option<f64> {
        self.pairs().edge_vertex(edge, p)
    }

    #[inline]
    fn edge_edge(&self, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
        self.pairs().edge_edge(e, f)
    }

    #[inline]
    fn triangle_vertex(&self, triangle: [Vertex; 3], p: Vertex) -> Option<[f64; 3]> {
        self.pairs().triangle_vertex(triangle, p)
    }

    #[inline]
    fn triangle_edge(&self, triangle: [Vertex; 3], edge: [Vertex; 2]) -> Option<([f64; 3], f64)> {
        self.pairs().triangle_edge(triangle, edge)
    }

    #[inline]
    fn tetrahedron_vertex(&self, tetrahedron: [Vertex; 4], p: Vertex) -> Option<[f64; 4]> {
        self.pairs().tetrahedron_vertex(tetrahedron, p)
    }
}
