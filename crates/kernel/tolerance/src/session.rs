//! The session of the tolerance backend: points and widths are prepared, queries run one by one and in batches.
//!
//! A batch is computed in vector registers, in the order of operations of one query, so its answers are the same bit by
//! bit.

use std::sync::OnceLock;

use predicament_lanes::{self as lanes, Along, View, Whole, Xy, Yz, Zx};
use predicament_predicates::{
    Axis, Band, Construction, Declined, Derived, Dimension, Plane, PredicateKind, Predicates, Question, Refused, Scene,
    Sign, Tally, Vertex,
};

use crate::contacts::{EdgeVertex, Pairs};
use crate::{ContactTolerances, Float, Tolerances2d, Tolerances3d, circles, derived, quantities};

/// The reason to decline a scene with constructed vertices, or a construction.
pub(crate) const INPUT_ONLY: &str = "the tolerances are for input vertices, not for constructed ones";

/// [`Tolerance`](struct@crate::Tolerance), prepared for one scene.
#[derive(Clone, Debug)]
pub struct Session<'s, T, F = f64> {
    scene: &'s Scene,
    /// The scene's points, in the view of its dimension; the other view is empty.
    points2: &'s [[f64; 2]],
    points3: &'s [[f64; 3]],
    /// The scene in the coordinates to compute with, if these are not its own; always `None` in double precision.
    shifted: Option<Scene>,
    widths: Widths,
    tally: T,
    tolerances: Tolerances<F>,
    form: EdgeVertex,
    /// The bands of the first formulas that the session was asked about.
    known: [OnceLock<(Derived, Result<Band, Declined>)>; KEPT],
}

/// The number of formulas of a scene whose bands are kept; the band of another formula is derived for each query.
const KEPT: usize = 16;

/// The tolerances of a scene, or the reason why it has none.
#[derive(Clone, Debug)]
pub(crate) struct Tolerances<F> {
    /// The tolerances of each plane, in the order of planes; a 2D scene has the first only.
    pub(crate) planar: Vec<Result<Tolerances2d<F>, Declined>>,
    pub(crate) spatial: Option<Tolerances3d<F>>,
    /// The band of `incircle` in 2D, of `insphere` in 3D.
    pub(crate) circular: Result<Band, Declined>,
    pub(crate) contacts: Result<ContactTolerances<F>, Declined>,
}

/// The width T of each predicate, as queries look it up; NaN if the predicate is declined.
#[derive(Clone, Copy, Debug)]
struct Widths {
    /// The width κ of each plane.
    kappa: [f64; 3],
    xi: f64,
    incircle: f64,
    insphere: f64,
}

impl Widths {
    fn new<F>(tolerances: &Tolerances<F>, dimension: Dimension) -> Widths {
        let Tolerances { planar, spatial, circular, .. } = tolerances;
        let of_plane = |at: usize| planar.get(at).and_then(|plane| plane.as_ref().ok()).map(|plane| plane.kappa.width);
        let circular = circular.as_ref().map_or(f64::NAN, |band| band.width);
        let [incircle, insphere] = match dimension {
            Dimension::Two => [circular, f64::NAN],
            Dimension::Three => [f64::NAN, circular],
        };
        Widths {
            kappa: [0, 1, 2].map(|at| of_plane(at).unwrap_or(f64::NAN)),
            xi: spatial.as_ref().map_or(f64::NAN, |spatial| spatial.xi.width),
            incircle,
            insphere,
        }
    }
}

/// The number whose sign is the answer: a computed value beyond the tolerance, else zero, also for NaN.
#[inline(always)]
fn beyond(width: f64, value: f64) -> f64 {
    if value.abs() > width { value } else { 0.0 }
}

/// The difference of two coordinates.
#[inline(always)]
fn order([[a], [b]]: [[f64; 1]; 2]) -> f64 {
    // Zero for equal coordinates only, since underflow is gradual.
    a - b
}

// The points of a scene are numbers of `F`: they are not rounded before the computation.

/// Twice the signed area, in the order of Algorithm 5's first area.
///
/// Edge vectors from the last point, then their cross product.
#[inline(always)]
fn area<F: Float>([a, b, c]: [[f64; 2]; 3]) -> f64 {
    quantities::area(&flat::<F>(c), &flat::<F>(a), &flat::<F>(b)).wide()
}

/// Six times the signed volume, in the order of Algorithm 11's first volume.
///
/// Edge vectors from the last point, a cross product and a dot product.
#[inline(always)]
fn volume<F: Float>([a, b, c, d]: [[f64; 3]; 4]) -> f64 {
    quantities::volume(&solid::<F>(a), &solid::<F>(b), &solid::<F>(c), &solid::<F>(d)).wide()
}

/// The determinant of `incircle`, in the order of [`circles::incircle`].
#[inline(always)]
fn circle<F: Float>([a, b, c, d]: [[f64; 2]; 4]) -> f64 {
    circles::incircle(&[flat::<F>(a), flat::<F>(b), flat::<F>(c), flat::<F>(d)]).wide()
}

/// The determinant of `insphere`, in the order of [`circles::insphere`].
#[inline(always)]
fn sphere<F: Float>([a, b, c, d, e]: [[f64; 3]; 5]) -> f64 {
    circles::insphere(&[solid::<F>(a), solid::<F>(b), solid::<F>(c), solid::<F>(d), solid::<F>(e)]).wide()
}

#[inline(always)]
fn flat<F: Float>([x, y]: [f64; 2]) -> [F; 2] {
    [F::nearest(x), F::nearest(y)]
}

#[inline(always)]
fn solid<F: Float>([x, y, z]: [f64; 3]) -> [F; 3] {
    [F::nearest(x), F::nearest(y), F::nearest(z)]
}

impl<'s, T, F: Float> Session<'s, T, F> {
    pub(crate) fn new(
        (scene, shifted): (&'s Scene, Option<Scene>),
        tally: T,
        tolerances: Tolerances<F>,
        form: EdgeVertex,
    ) -> Session<'s, T, F> {
        let (points2, points3): (&[_], &[_]) = match scene.dimension() {
            Dimension::Two => (scene.coordinates().as_chunks().0, &[]),
            Dimension::Three => (&[], scene.coordinates().as_chunks().0),
        };
        let widths = Widths::new(&tolerances, scene.dimension());
        Session { scene, points2, points3, shifted, widths, tally, tolerances, form, known: Default::default() }
    }
}

impl<T, F: Float> Session<'_, T, F> {
    /// The tolerances of a projection; a 2D scene has only [`Plane::Xy`].
    ///
    /// # Errors
    /// [`Declined`] if the projection has none, or is not of this scene.
    #[inline]
    pub fn tolerances2d(&self, plane: Plane) -> Result<&Tolerances2d<F>, Declined> {
        match self.tolerances.planar.get(plane as usize) {
            Some(tolerances) => tolerances.as_ref().map_err(Clone::clone),
            None => Err(Declined::predicate(PredicateKind::Orient2d, "a 2D scene has no such projection")),
        }
    }

    /// The tolerances of a 3D scene.
    #[must_use]
    pub fn tolerances3d(&self) -> Option<&Tolerances3d<F>> {
        self.tolerances.spatial.as_ref()
    }

    /// The tolerances of contacts.
    ///
    /// # Errors
    /// [`Declined`] if the scene has no primitive lengths, or `F` cannot represent them.
    pub fn contact_tolerances(&self) -> Result<&ContactTolerances<F>, Declined> {
        self.tolerances.contacts.as_ref().map_err(Clone::clone)
    }

    /// The scene in shifted coordinates; known to be `None` when double precision is compiled.
    #[inline(always)]
    fn shifted(&self) -> Option<&Scene> {
        if F::IS_NARROW { self.shifted.as_ref() } else { None }
    }

    /// The scene in the coordinates to compute with.
    #[inline(always)]
    fn computed(&self) -> &Scene {
        self.shifted().unwrap_or(self.scene)
    }

    /// The stage that settles all queries of the session.
    #[inline(always)]
    fn stage(&self) -> usize {
        usize::from(self.shifted().is_some())
    }

    #[inline(always)]
    fn points2(&self) -> &[[f64; 2]] {
        self.shifted().map_or(self.points2, |shifted| match shifted.dimension() {
            Dimension::Two => shifted.coordinates().as_chunks().0,
            Dimension::Three => &[],
        })
    }

    #[inline(always)]
    fn points3(&self) -> &[[f64; 3]] {
        self.shifted().map_or(self.points3, |shifted| match shifted.dimension() {
            Dimension::Two => &[],
            Dimension::Three => shifted.coordinates().as_chunks().0,
        })
    }

    #[inline]
    fn pairs(&self) -> Pairs<'_, F> {
        match &self.tolerances.contacts {
            Ok(tolerances) => Pairs { scene: self.computed(), tolerances, form: self.form },
            Err(declined) => panic!("{declined}"),
        }
    }

    /// The points of some vertices, projected to a plane.
    #[inline(always)]
    fn flat<const N: usize>(&self, plane: Plane, vertices: [Vertex; N]) -> [[f64; 2]; N] {
        let mut points = [[0.0; 2]; N];
        if let (Dimension::Two, Plane::Xy) = (self.scene.dimension(), plane) {
            for (point, v) in points.iter_mut().zip(vertices) {
                *point = self.points2()[v.index()];
            }
        } else {
            let [x, y] = plane.axes().map(Axis::index);
            for (point, v) in points.iter_mut().zip(vertices) {
                let solid = self.points3()[v.index()];
                *point = [solid[x], solid[y]];
            }
        }
        points
    }

    #[inline(always)]
    fn solid<const N: usize>(&self, vertices: [Vertex; N]) -> [[f64; 3]; N] {
        let mut points = [[0.0; 3]; N];
        for (point, v) in points.iter_mut().zip(vertices) {
            *point = self.points3()[v.index()];
        }
        points
    }

    /// A width, which must exist.
    #[inline(always)]
    fn width(&self, width: f64, question: Question) -> f64 {
        if width.is_nan() {
            self.refuse(question);
        }
        width
    }

    /// Panics with the reason why the session does not answer a question.
    #[cold]
    #[inline(never)]
    fn refuse(&self, question: Question) -> ! {
        let declined = match question {
            Question::Orient2d(plane) => self.tolerances2d(plane).err(),
            Question::Incircle => self.circular(Dimension::Two).err(),
            Question::Insphere => self.circular(Dimension::Three).err(),
            Question::Derived(derived) => self.derived(derived).err(),
            Question::Compare(_) | Question::Orient3d => None,
        };
        panic!("{}", declined.unwrap_or_else(|| Declined::predicate(question.kind(), "needs a 3D scene")))
    }

    /// The band of a predicate from a formula, derived at its first use.
    fn derived(&self, derived: Derived) -> Result<Band, Declined> {
        let prepared = || derived::prepared::<F>(self.scene, derived, self.shifted().is_some());
        let mut known = self.known.iter().map(|kept| kept.get_or_init(|| (derived, prepared())));
        known.find(|(owner, _)| *owner == derived).map_or_else(prepared, |(_, band)| band.clone())
    }

    /// The band of the predicate for circles that scenes of `dimension` have.
    fn circular(&self, dimension: Dimension) -> Result<Band, Declined> {
        if self.scene.dimension() == dimension {
            return self.tolerances.circular.clone();
        }
        Err(match dimension {
            Dimension::Two => Declined::predicate(PredicateKind::Incircle, "needs a 2D scene"),
            Dimension::Three => Declined::predicate(PredicateKind::Insphere, "needs a 3D scene"),
        })
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
                self.tolerances.planar.iter().try_for_each(|plane| plane.as_ref().map(|_| ()).map_err(Clone::clone))
            }
            PredicateKind::Orient3d if self.tolerances.spatial.is_some() => Ok(()),
            PredicateKind::Orient3d => Err(Declined::predicate(kind, "needs a 3D scene")),
            PredicateKind::Incircle => self.circular(Dimension::Two).map(|_| ()),
            PredicateKind::Insphere => self.circular(Dimension::Three).map(|_| ()),
            PredicateKind::Derived(derived) => self.derived(derived).map(|_| ()),
        }
    }

    #[inline]
    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Compare, self.stage());
        let [a, b] = match self.scene.dimension() {
            Dimension::Two => [a, b].map(|v| self.points2()[v.index()][axis.index()]),
            Dimension::Three => [a, b].map(|v| self.points3()[v.index()][axis.index()]),
        };
        Sign::of(order([[a], [b]]))
    }

    #[inline(always)]
    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Orient2d, self.stage());
        let width = self.width(self.widths.kappa[plane as usize], Question::Orient2d(plane));
        Sign::of(beyond(width, area::<F>(self.flat(plane, [a, b, c]))))
    }

    #[inline(always)]
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Orient3d, self.stage());
        let width = self.width(self.widths.xi, Question::Orient3d);
        Sign::of(beyond(width, volume::<F>(self.solid([a, b, c, d]))))
    }

    #[inline]
    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Incircle, self.stage());
        let width = self.width(self.widths.incircle, Question::Incircle);
        Sign::of(beyond(width, circle::<F>(self.flat(Plane::Xy, [a, b, c, d]))))
    }

    #[inline]
    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Insphere, self.stage());
        let width = self.width(self.widths.insphere, Question::Insphere);
        Sign::of(beyond(width, sphere::<F>(self.solid([a, b, c, d, e]))))
    }

    fn sign(&self, predicate: Derived, vertices: &[Vertex]) -> Sign {
        self.tally.settled(PredicateKind::Derived(predicate), self.stage());
        let band = self.derived(predicate).unwrap_or_else(|declined| panic!("{declined}"));
        let value = predicate.with_points(self.computed(), vertices, |points| derived::value::<F>(predicate, points));
        Sign::of(beyond(band.width, value))
    }

    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        match (question, args) {
            (Question::Orient2d(plane), &[a, b, c]) => Some(area::<F>(self.flat(plane, [a, b, c]))),
            (Question::Orient3d, &[a, b, c, d]) => Some(volume::<F>(self.solid([a, b, c, d]))),
            (Question::Incircle, &[a, b, c, d]) => Some(circle::<F>(self.flat(Plane::Xy, [a, b, c, d]))),
            (Question::Insphere, &[a, b, c, d, e]) => Some(sphere::<F>(self.solid([a, b, c, d, e]))),
            (Question::Derived(derived), args) if args.len() == derived.formula().arity() => {
                // A formula that does not follow a shift has no value here.
                let is_here = self.shifted().is_none() || self.derived(derived).is_ok();
                is_here
                    .then(|| derived.with_points(self.computed(), args, |points| derived::value::<F>(derived, points)))
            }
            _ => None,
        }
    }

    /// The band κ of the projection, ξ, or a band of [`circles`].
    fn band(&self, question: Question) -> Option<Band> {
        match question {
            Question::Orient2d(plane) => self.tolerances2d(plane).ok().map(|tolerances| tolerances.kappa),
            Question::Orient3d => self.tolerances.spatial.map(|tolerances| tolerances.xi),
            Question::Incircle => self.circular(Dimension::Two).ok(),
            Question::Insphere => self.circular(Dimension::Three).ok(),
            Question::Derived(derived) => self.derived(derived).ok(),
            Question::Compare(_) => None,
        }
    }

    /// The distance σ₊, the largest tolerance that is a distance.
    ///
    /// It is the σ₊ of contacts, if the scene has primitive lengths.
    fn reach(&self) -> f64 {
        if let Ok(tolerances) = &self.tolerances.contacts {
            return tolerances.band([0, 0]).map_or(0.0, |sigma| sigma.upper);
        }
        match (&self.tolerances.spatial, &self.tolerances.planar[0]) {
            (Some(tolerances), _) => tolerances.sigma.upper,
            (None, Ok(tolerances)) => tolerances.sigma.upper,
            (None, Err(_)) => 0.0,
        }
    }

    fn contact_band(&self, ranks: [u8; 2]) -> Option<Band> {
        self.tolerances.contacts.as_ref().ok().and_then(|tolerances| tolerances.band(ranks))
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

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        match (self.scene.dimension(), axis) {
            (Dimension::Two, Axis::X) => self.compare_many::<Along<0>, 2>(self.points2(), axis, queries, out),
            (Dimension::Two, Axis::Y) => self.compare_many::<Along<1>, 2>(self.points2(), axis, queries, out),
            (Dimension::Two, Axis::Z) => assert!(queries.is_empty(), "a 2D scene has no axis z"),
            (Dimension::Three, Axis::X) => self.compare_many::<Along<0>, 3>(self.points3(), axis, queries, out),
            (Dimension::Three, Axis::Y) => self.compare_many::<Along<1>, 3>(self.points3(), axis, queries, out),
            (Dimension::Three, Axis::Z) => self.compare_many::<Along<2>, 3>(self.points3(), axis, queries, out),
        }
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.turn_many(plane, queries, out, |vertices| vertices, area::<F>);
    }

    fn orient2d_line(&self, plane: Plane, [a, b]: [Vertex; 2], points: &[Vertex], out: &mut [Sign]) {
        if points.is_empty() {
            return;
        }
        let [p, q] = self.flat(plane, [a, b]);
        self.turn_many(plane, points.as_chunks::<1>().0, out, |[c]| [a, b, c], move |[r]| area::<F>([p, q, r]));
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let band = (self.widths.xi, Question::Orient3d);
        let one = |query| volume::<F>(self.solid(query));
        self.many::<Whole, 3, 3, 4>(band, self.points3(), (queries, out), volume::<F>, one);
    }

    fn orient3d_plane(&self, [a, b, c]: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        if points.is_empty() {
            return;
        }
        let [p, q, r] = self.solid([a, b, c]);
        let band = (self.widths.xi, Question::Orient3d);
        let one = |[d]: [Vertex; 1]| volume::<F>(self.solid([a, b, c, d]));
        let evaluate = move |[s]: [[f64; 3]; 1]| volume::<F>([p, q, r, s]);
        self.many::<Whole, 3, 3, 1>(band, self.points3(), (points.as_chunks::<1>().0, out), evaluate, one);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        let band = (self.widths.incircle, Question::Incircle);
        let one = |query| circle::<F>(self.flat(Plane::Xy, query));
        self.many::<Whole, 2, 2, 4>(band, self.points2(), (queries, out), circle::<F>, one);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        let band = (self.widths.insphere, Question::Insphere);
        let one = |query| sphere::<F>(self.solid(query));
        self.many::<Whole, 3, 3, 5>(band, self.points3(), (queries, out), sphere::<F>, one);
    }
}

impl<T: Tally, F: Float> Session<'_, T, F> {
    fn compare_many<V: View<E, 1>, const E: usize>(
        &self,
        points: &[[f64; E]],
        axis: Axis,
        queries: &[[Vertex; 2]],
        out: &mut [Sign],
    ) {
        // Zero width: a comparison has no band.
        let band = (0.0, Question::Compare(axis));
        let one = |query: [Vertex; 2]| order(query.map(|v| [points[v.index()][axis.index()]]));
        self.many::<V, E, 1, 2>(band, points, (queries, out), order, one);
    }

    /// Answers turns of `N` vertices each, where `all` adds the vertices that all turns share.
    fn turn_many<const N: usize>(
        &self,
        plane: Plane,
        queries: &[[Vertex; N]],
        out: &mut [Sign],
        all: impl Fn([Vertex; N]) -> [Vertex; 3],
        evaluate: impl Fn([[f64; 2]; N]) -> f64,
    ) {
        let band = (self.widths.kappa[plane as usize], Question::Orient2d(plane));
        let (both, one) = ((queries, out), |query| area::<F>(self.flat(plane, all(query))));
        match (self.scene.dimension(), plane) {
            (Dimension::Two, _) => self.many::<Whole, 2, 2, N>(band, self.points2(), both, evaluate, one),
            (Dimension::Three, Plane::Xy) => self.many::<Xy, 3, 2, N>(band, self.points3(), both, evaluate, one),
            (Dimension::Three, Plane::Yz) => self.many::<Yz, 3, 2, N>(band, self.points3(), both, evaluate, one),
            (Dimension::Three, Plane::Zx) => self.many::<Zx, 3, 2, N>(band, self.points3(), both, evaluate, one),
        }
    }

    /// Answers a batch: `evaluate` on points in view, and `one` for queries with a vertex that is not one of the
    /// scene's points.
    #[inline(always)]
    fn many<V: View<E, D>, const E: usize, const D: usize, const N: usize>(
        &self,
        (width, question): (f64, Question),
        points: &[[f64; E]],
        (queries, out): (&[[Vertex; N]], &mut [Sign]),
        evaluate: impl Fn([[f64; D]; N]) -> f64,
        one: impl Fn([Vertex; N]) -> f64,
    ) {
        if queries.is_empty() {
            return;
        }
        let width = self.width(width, question);
        let (evaluate, one) = (|points| beyond(width, evaluate(points)), |query| Sign::of(beyond(width, one(query))));
        lanes::answer::<V, E, D, N>(points, queries, out, evaluate, one);
        self.tally.settled_many(question.kind(), self.stage(), queries.len().min(out.len()) as u64);
    }
}
