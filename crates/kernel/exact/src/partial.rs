//! A control: the first stages of the ladder, then the sign of the estimate.
//!
//! It measures the value of each stage. Without the exact stages it is plain floating point that detects doubtful
//! answers and returns them anyway. Stages run in the order of [`stage`], without the shortcuts of [`Session`]: with
//! all of them the signs are those of [`Exact`](crate::Exact).

use alloc::{format, string::String, vec::Vec};
use predicament_arithmetic::Plan;
use predicament_predicates::{
    Axis, Backend, Construction, Constructs, Contract, Declined, Dimension, Off, Plane, PredicateKind, Predicates,
    Refused, Scene, Sign, Tally, Vertex, ZeroMeaning,
};

use crate::ladder::Prepared;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
use crate::scene_integers::Integers;
use crate::{Session, stage};

/// The exact backend's stages up to one of them, then the sign of the double determinant.
///
/// Nothing about it is proved. It decides constructed vertices and comparisons as `exact` does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Partial {
    last: usize,
}

/// The exact backend's stages, and a last stage for queries that all others leave open.
const NAMES: [&str; stage::NAMES.len() + 1] = {
    let mut all = ["estimate"; stage::NAMES.len() + 1];
    let mut at = 0;
    while at < stage::NAMES.len() {
        all[at] = stage::NAMES[at];
        at += 1;
    }
    all
};
const ESTIMATE: usize = stage::NAMES.len();

impl Partial {
    /// The number of stages.
    pub const STAGES: usize = stage::DYADIC;

    /// The backend with the first `stages` stages, or `None` if `stages` is 0 or too large.
    #[must_use]
    pub const fn new(stages: usize) -> Option<Partial> {
        if stages >= stage::DOUBLE && stages <= Partial::STAGES { Some(Partial { last: stages }) } else { None }
    }
}

impl Backend for Partial {
    type Session<'s, T: Tally + 's> = PartialSession<'s, T>;

    /// The name `exact:stages=` with the number of stages.
    fn name(&self) -> String {
        format!("exact:stages={}", self.last)
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &NAMES
    }

    fn constructs(&self) -> Constructs {
        Constructs::Keeps
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<PartialSession<'s, T>, Declined> {
        PartialSession::new(scene, tally, self.last)
    }

    predicament_predicates::boxed_here!();
}

/// A session of the first stages, prepared for one scene.
pub struct PartialSession<'s, T> {
    /// An exact session, for comparisons and constructed vertices.
    exact: Session<'s, Off>,
    tally: T,
    /// The last stage that runs.
    last: usize,
    points2: &'s [[f64; 2]],
    points3: &'s [[f64; 3]],
    /// The rungs of the turn in each plane: xy, yz, zx.
    orient2d: [Prepared; 3],
    orient3d: Prepared,
    incircle: Prepared,
    insphere: Prepared,
    integers2: Integers<2>,
    integers3: Integers<3>,
}

impl<'s, T: Tally> PartialSession<'s, T> {
    fn new(scene: &'s Scene, tally: T, last: usize) -> Result<PartialSession<'s, T>, Declined> {
        let (points2, points3): (&[_], &[_]) = match scene.dimension() {
            Dimension::Two => (scene.coordinates().as_chunks().0, &[]),
            Dimension::Three => (&[], scene.coordinates().as_chunks().0),
        };
        let (flat, solid) = (Plan::of(points2), Plan::of(points3));
        let orient2d = match scene.dimension() {
            Dimension::Two => [Prepared::new::<Orient2d, 2, 3>(&flat); 3],
            Dimension::Three => [Plane::Xy, Plane::Yz, Plane::Zx]
                .map(|plane| Prepared::new::<Orient2d, 2, 3>(&solid.project(plane.axes().map(Axis::index)))),
        };
        // If no integer stage runs, no integers are computed.
        let has_integers = last >= stage::INTEGER;
        Ok(PartialSession {
            exact: Session::new(scene, Off)?,
            tally,
            last,
            points2,
            points3,
            orient2d,
            orient3d: Prepared::new::<Orient3d, 3, 4>(&solid),
            incircle: Prepared::new::<Incircle, 2, 4>(&flat),
            insphere: Prepared::new::<Insphere, 3, 5>(&solid),
            integers2: if has_integers { Integers::new(&flat, points2) } else { Integers::None },
            integers3: if has_integers { Integers::new(&solid, points3) } else { Integers::None },
        })
    }

    #[inline(always)]
    fn decide<P: Predicate<D, N>, const D: usize, const N: usize, const E: usize>(
        &self,
        prepared: &Prepared,
        points: &[[f64; D]; N],
        integers: (&Integers<E>, [usize; D], [Vertex; N]),
    ) -> Sign {
        let (sign, stage) = match prepared.decide_to::<P, D, N, E>(points, integers, self.last) {
            Some(decided) => decided,
            None => (Sign::of(P::estimate(*points).determinant), ESTIMATE),
        };
        self.tally.settled(P::KIND, stage);
        sign
    }

    fn tallied(&self, kind: PredicateKind, (sign, stage): (Sign, usize)) -> Sign {
        self.tally.settled(kind, stage);
        sign
    }

    fn in2<const N: usize>(&self, vertices: [Vertex; N]) -> Option<[[f64; 2]; N]> {
        points(self.points2, vertices)
    }

    fn in3<const N: usize>(&self, vertices: [Vertex; N]) -> Option<[[f64; 3]; N]> {
        points(self.points3, vertices)
    }
}

/// The points of these vertices; `None` if one is constructed.
fn points<const D: usize, const N: usize>(of: &[[f64; D]], vertices: [Vertex; N]) -> Option<[[f64; D]; N]> {
    let mut points = [[0.0; D]; N];
    for (point, vertex) in points.iter_mut().zip(vertices) {
        *point = *of.get(vertex.index())?;
    }
    Some(points)
}

impl<T: Tally> Predicates for PartialSession<'_, T> {
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.exact.construct(definitions)
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.tallied(PredicateKind::Compare, self.exact.decide_compare(axis, a, b))
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let (vertices, prepared) = ([a, b, c], &self.orient2d[plane as usize]);
        if let Some(points) = self.in3(vertices) {
            let axes = plane.axes().map(Axis::index);
            let points = points.map(|point| axes.map(|axis| point[axis]));
            return self.decide::<Orient2d, 2, 3, 3>(prepared, &points, (&self.integers3, axes, vertices));
        }
        match self.in2(vertices).filter(|_| plane == Plane::Xy) {
            Some(points) => self.decide::<Orient2d, 2, 3, 2>(prepared, &points, (&self.integers2, [0, 1], vertices)),
            None => self.tallied(PredicateKind::Orient2d, self.exact.decide_orient2d(plane, a, b, c)),
        }
    }

    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let vertices = [a, b, c, d];
        match self.in3(vertices) {
            Some(points) => {
                let integers = (&self.integers3, [0, 1, 2], vertices);
                self.decide::<Orient3d, 3, 4, 3>(&self.orient3d, &points, integers)
            }
            None => self.tallied(PredicateKind::Orient3d, self.exact.decide_orient3d(a, b, c, d)),
        }
    }

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let vertices = [a, b, c, d];
        match self.in2(vertices) {
            Some(points) => {
                let integers = (&self.integers2, [0, 1], vertices);
                self.decide::<Incircle, 2, 4, 2>(&self.incircle, &points, integers)
            }
            None => self.tallied(PredicateKind::Incircle, self.exact.decide_incircle(a, b, c, d)),
        }
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        let vertices = [a, b, c, d, e];
        match self.in3(vertices) {
            Some(points) => {
                let integers = (&self.integers3, [0, 1, 2], vertices);
                self.decide::<Insphere, 3, 5, 3>(&self.insphere, &points, integers)
            }
            None => self.tallied(PredicateKind::Insphere, self.exact.decide_insphere(a, b, c, d, e)),
        }
    }
}
