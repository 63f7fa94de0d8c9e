//! Planted faults: backends with one known error each, to prove that checks can fail.
//!
//! A harness that has never found an error proves nothing. Each fault consists of the real backends' own parts with one
//! part wrong, claims the real contract, and `selftest` must detect it on the embedded corpora.

mod alone;
mod area;
mod boastful;
mod catches;
mod colliding;
mod contacts;
mod deadly;
mod filters;
mod over;
mod ties;
mod unsteady;

use predicament_controls::{Naive, Pivot, Shewchuk};
use predicament_exact::{Exact, raw};
use predicament_predicates::{
    Backend, Band, Construction, Constructs, Contract, Declined, Off, Plane, PredicateKind, Predicates, Question,
    Refused, Scene, Sign, Tally, Vertex, ZeroMeaning, answer_by,
};
use predicament_sos::{Scheme, Sos, infinitesimal};
use predicament_tolerance::{Misscaled, Tolerance};

use predicament_judge::TieJudge;

use crate::boxed::Boxed;
use crate::visit::{Visit, hand};
use over::Over;

pub use area::Area;
pub use deadly::Deadly;
pub use unsteady::Unsteady;

/// A planted fault of a backend.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    /// SoS with the sign of one term of one list swapped: still antisymmetric, still never zero.
    SosSwappedTerm,
    /// SoS whose batches of orientations negate every tie; single calls are right.
    SosBatchFlipped,
    /// SoS with the sign of the first term of one list swapped, for vertices of the scene's second half only: the first
    /// ties of a scene are broken correctly.
    SosLateSwappedTerm,
    /// SoS that sorts the vertices and drops the parity of the sort.
    SosDroppedParity,
    /// SoS that perturbs by the position in the argument list, not by identity.
    SosPlaceAsIdentity,
    /// SoS that drops the parity of the sort if the last term, a constant, decides.
    SosDroppedLastParity,
    /// SoS that stops after the first-order terms and answers zero for the rest.
    SosFirstOrderOnly,
    /// SoS that stops after the first-order terms and then uses the order of the vertices.
    SosFirstOrderThenParity,
    /// SoS that lifts points moved by ε^(2^i) again, where squares of infinitesimals collide with others, and keeps one
    /// term of each power.
    SosCollidingLift,
    /// SoS that moves coordinates in one order for circles and spheres and in another for the other predicates: each
    /// predicate alone is consistent.
    SosMixedOrders,
    /// SoS that breaks ties of comparisons cyclically: the first vertex before the second, the second before the third,
    /// and the third before the first.
    SosCircularTies,
    /// SoS that breaks each tie of a determinant of directions by the order of its vertices alone.
    SosAloneOnSphere,
    /// Exact, with the bound of the floating-point filter halved.
    ExactHalvedFilter,
    /// Exact, with the bound of the floating-point filter two percent too small.
    ExactTightFilter,
    /// Exact, with a filter whose bound is a multiple of the determinant, not of the sum of its terms' magnitudes:
    /// every determinant passes.
    ExactRelativeFilter,
    /// Exact, with the static bound of the scene's first half of vertices used for all.
    ExactStaleBound,
    /// Exact, but floating-point determinants that are NaN count as zero.
    ExactNan,
    /// Exact, with integers of one limb where differences need two.
    ExactOneLimb,
    /// Adaptive floating point (the crate `robust`) for input where it can underflow or overflow.
    ExactUnguarded,
    /// Exact, with zero for all determinants below the smallest normal double.
    ExactFlushed,
    /// Exact for constructed vertices that were rounded to the nearest doubles.
    ExactRoundedVertex,
    /// Tolerance, with the band narrower than its promise.
    ToleranceNarrow,
    /// Tolerance, with the band wider than its promise.
    ToleranceWide,
    /// Tolerance, with bands of formulas that are far too wide, in its claims too.
    ToleranceBoastfulFormula,
    /// Exact comparisons, but a tie answers "greater": an endpoint counts twice.
    CompareGreaterOnTies,
    /// Exact, but an edge extends beyond its ends.
    ContactsEndlessEdge,
    /// Exact, but of two edges only the second is tested for crossing the other's line, and an edge pierces every
    /// triangle near it whose plane it crosses.
    ContactsOneSided,
    /// Tolerance, with vertices registered within half the promised distance.
    ToleranceNarrowContacts,
    /// Tolerance, with vertices registered within twice the promised distance.
    ToleranceWideContacts,
    /// Tolerance, with Algorithms 3 and 8 as the paper prints them.
    ToleranceAsPrinted,
    /// Tolerance, right about the registered pairs, with the printed sign of an edge's weight.
    ToleranceMirroredWeight,
    /// Exact, but it reverses some answers to queries that it has answered before.
    UnsteadyAgain,
    /// Tolerance, with one of its tolerances twice or half the published value, in its claims too.
    Misscaled(Misscaled),
}

impl Fault {
    /// All faults that `selftest` plants and must detect.
    pub fn planted() -> impl Iterator<Item = Fault> {
        Fault::ALL.into_iter().chain(Misscaled::visible().map(Fault::Misscaled))
    }

    /// All faults except wrongly scaled tolerances.
    const ALL: [Fault; 32] = [
        Fault::SosSwappedTerm,
        Fault::SosBatchFlipped,
        Fault::SosLateSwappedTerm,
        Fault::SosDroppedParity,
        Fault::SosPlaceAsIdentity,
        Fault::SosDroppedLastParity,
        Fault::SosFirstOrderOnly,
        Fault::SosFirstOrderThenParity,
        Fault::SosCollidingLift,
        Fault::SosMixedOrders,
        Fault::SosCircularTies,
        Fault::SosAloneOnSphere,
        Fault::ExactHalvedFilter,
        Fault::ExactTightFilter,
        Fault::ExactRelativeFilter,
        Fault::ExactStaleBound,
        Fault::ExactNan,
        Fault::ExactOneLimb,
        Fault::ExactUnguarded,
        Fault::ExactFlushed,
        Fault::ExactRoundedVertex,
        Fault::ToleranceNarrow,
        Fault::ToleranceWide,
        Fault::ToleranceBoastfulFormula,
        Fault::CompareGreaterOnTies,
        Fault::ContactsEndlessEdge,
        Fault::ContactsOneSided,
        Fault::ToleranceNarrowContacts,
        Fault::ToleranceWideContacts,
        Fault::ToleranceAsPrinted,
        Fault::ToleranceMirroredWeight,
        Fault::UnsteadyAgain,
    ];

    /// The fault's name after `fault:`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Fault::SosSwappedTerm => "sos-swapped-term",
            Fault::SosBatchFlipped => "sos-batch-flipped",
            Fault::SosLateSwappedTerm => "sos-late-swapped-term",
            Fault::SosDroppedParity => "sos-dropped-parity",
            Fault::SosPlaceAsIdentity => "sos-place-as-identity",
            Fault::SosDroppedLastParity => "sos-dropped-last-parity",
            Fault::SosFirstOrderOnly => "sos-first-order-only",
            Fault::SosFirstOrderThenParity => "sos-first-order-then-parity",
            Fault::SosCollidingLift => "sos-colliding-lift",
            Fault::SosMixedOrders => "sos-mixed-orders",
            Fault::SosCircularTies => "sos-circular-ties",
            Fault::SosAloneOnSphere => "sos-alone-on-sphere",
            Fault::ExactHalvedFilter => "exact-halved-filter",
            Fault::ExactTightFilter => "exact-tight-filter",
            Fault::ExactRelativeFilter => "exact-relative-filter",
            Fault::ExactStaleBound => "exact-stale-bound",
            Fault::ExactNan => "exact-nan",
            Fault::ExactOneLimb => "exact-one-limb",
            Fault::ExactUnguarded => "exact-unguarded",
            Fault::ExactFlushed => "exact-flushed",
            Fault::ExactRoundedVertex => "exact-rounded-vertex",
            Fault::ToleranceNarrow => "tolerance-narrow",
            Fault::ToleranceWide => "tolerance-wide",
            Fault::ToleranceBoastfulFormula => "tolerance-boastful-formula",
            Fault::CompareGreaterOnTies => "compare-greater-on-ties",
            Fault::ContactsEndlessEdge => "contacts-endless-edge",
            Fault::ContactsOneSided => "contacts-one-sided",
            Fault::ToleranceNarrowContacts => "tolerance-narrow-contacts",
            Fault::ToleranceWideContacts => "tolerance-wide-contacts",
            Fault::ToleranceAsPrinted => "tolerance-as-printed",
            Fault::ToleranceMirroredWeight => "tolerance-mirrored-weight",
            Fault::UnsteadyAgain => Unsteady::Again.name(),
            Fault::Misscaled(misscaled) => misscaled.fault,
        }
    }

    /// A one-line description of the fault.
    #[must_use]
    pub const fn what(self) -> &'static str {
        match self {
            Fault::SosSwappedTerm => "the sign of the third term of every list is reversed",
            Fault::SosBatchFlipped => "ties of orientations have the opposite sign in batches, but not in single calls",
            Fault::SosLateSwappedTerm => {
                "the sign of the first term of every list is reversed for the second half of the vertices"
            }
            Fault::SosDroppedParity => "ties are sorted by vertex without the parity of the sort",
            Fault::SosPlaceAsIdentity => {
                "vertices are perturbed by their position in the argument list, not by identity"
            }
            Fault::SosDroppedLastParity => "the parity of the sort is dropped where the last term decides",
            Fault::SosFirstOrderOnly => "only terms that move one coordinate are used; other ties are answered zero",
            Fault::SosFirstOrderThenParity => {
                "only terms that move one coordinate are used; other ties follow the order of the vertices"
            }
            Fault::SosCollidingLift => {
                "points moved by eps^(2^i) are lifted again, and only one term of each power is kept"
            }
            Fault::SosMixedOrders => {
                "circles and spheres perturb the coordinates in another order than the other predicates"
            }
            Fault::SosCircularTies => "ties of comparisons are broken cyclically over three vertices",
            Fault::SosAloneOnSphere => "ties of turns on the sphere follow the order of the vertices",
            Fault::ExactHalvedFilter => "the bound of the floating-point filter is halved",
            Fault::ExactTightFilter => "the bound of the floating-point filter is two percent too small",
            Fault::ExactRelativeFilter => {
                "the filter's bound is relative to the determinant, so that every determinant passes"
            }
            Fault::ExactStaleBound => "the static bound of the first half of the vertices is used for all",
            Fault::ExactNan => "floating-point determinants that are NaN are answered as zero",
            Fault::ExactOneLimb => "integers of one limb are used where differences need two",
            Fault::ExactUnguarded => "adaptive floating point is used where it underflows or overflows",
            Fault::ExactFlushed => "determinants below the smallest normal double are answered as zero",
            Fault::ExactRoundedVertex => "constructed vertices are rounded to doubles; later steps are exact",
            Fault::ToleranceNarrow => "the band is a third of its promised width",
            Fault::ToleranceWide => "the band is twice its promised width",
            Fault::ToleranceBoastfulFormula => "bands of formulas, also as claimed, are 2^30 times as wide as allowed",
            Fault::CompareGreaterOnTies => "equal coordinates compare as greater, in both orders",
            Fault::ContactsEndlessEdge => "a vertex on an edge's line counts as on the edge",
            Fault::ContactsOneSided => {
                "two edges meet if the second crosses the line of the first; in space an edge meets a triangle if it \
                 crosses its plane"
            }
            Fault::ToleranceNarrowContacts => "vertices are registered only within half the tolerance",
            Fault::ToleranceWideContacts => "vertices are registered within twice the tolerance",
            Fault::ToleranceAsPrinted => {
                "the interpolation weight of an edge's point has the sign that the paper prints"
            }
            Fault::ToleranceMirroredWeight => {
                "only the weight has the sign that the paper prints; the registered pairs are right"
            }
            Fault::UnsteadyAgain => "one query in seven has the opposite answer when it is asked again",
            Fault::Misscaled(misscaled) => misscaled.what,
        }
    }

    /// The part of the tool that is wrong.
    #[must_use]
    pub const fn area(self) -> Area {
        match self {
            Fault::SosSwappedTerm
            | Fault::SosBatchFlipped
            | Fault::SosLateSwappedTerm
            | Fault::SosDroppedParity
            | Fault::SosPlaceAsIdentity
            | Fault::SosDroppedLastParity
            | Fault::SosFirstOrderOnly
            | Fault::SosFirstOrderThenParity
            | Fault::SosCollidingLift
            | Fault::SosMixedOrders
            | Fault::SosCircularTies
            | Fault::SosAloneOnSphere
            | Fault::CompareGreaterOnTies => Area::Sos,
            Fault::ExactHalvedFilter
            | Fault::ExactTightFilter
            | Fault::ExactRelativeFilter
            | Fault::ExactStaleBound
            | Fault::ExactUnguarded => Area::Filters,
            Fault::ExactNan | Fault::ExactOneLimb | Fault::ExactFlushed | Fault::ExactRoundedVertex => Area::Arithmetic,
            Fault::ContactsEndlessEdge | Fault::ContactsOneSided | Fault::UnsteadyAgain => Area::Answers,
            Fault::ToleranceNarrow
            | Fault::ToleranceWide
            | Fault::ToleranceBoastfulFormula
            | Fault::ToleranceNarrowContacts
            | Fault::ToleranceWideContacts
            | Fault::ToleranceAsPrinted
            | Fault::ToleranceMirroredWeight
            | Fault::Misscaled(_) => Area::Tolerance,
        }
    }

    const fn poses_as(self) -> ZeroMeaning {
        match self {
            Fault::SosSwappedTerm
            | Fault::SosBatchFlipped
            | Fault::SosLateSwappedTerm
            | Fault::SosDroppedParity
            | Fault::SosPlaceAsIdentity
            | Fault::SosDroppedLastParity
            | Fault::SosFirstOrderOnly
            | Fault::SosFirstOrderThenParity
            | Fault::SosCollidingLift
            | Fault::SosMixedOrders
            | Fault::SosCircularTies
            | Fault::SosAloneOnSphere
            | Fault::CompareGreaterOnTies => ZeroMeaning::Never,
            Fault::ExactHalvedFilter
            | Fault::ExactTightFilter
            | Fault::ExactRelativeFilter
            | Fault::ExactStaleBound
            | Fault::ExactNan
            | Fault::ExactOneLimb
            | Fault::ExactUnguarded
            | Fault::ExactFlushed
            | Fault::ExactRoundedVertex
            | Fault::ContactsEndlessEdge
            | Fault::ContactsOneSided
            | Fault::UnsteadyAgain => ZeroMeaning::Exact,
            Fault::ToleranceNarrow
            | Fault::ToleranceWide
            | Fault::ToleranceBoastfulFormula
            | Fault::ToleranceNarrowContacts
            | Fault::ToleranceWideContacts
            | Fault::ToleranceAsPrinted
            | Fault::ToleranceMirroredWeight
            | Fault::Misscaled(_) => ZeroMeaning::Band,
        }
    }

    /// True if sessions construct vertices: wrong arithmetic reaches the judges of overlays and cuts.
    fn constructs(self) -> bool {
        self.poses_as() == ZeroMeaning::Exact && self.area() == Area::Arithmetic
    }
}

/// The judge of ties by the scheme that the faults claim.
fn ties_by_coordinate() -> Box<TieJudge> {
    Box::new(|scene, question, args| infinitesimal::judge(Scheme::PerCoordinate, scene, question, args))
}

/// Finds the faulty backend with this name and passes it to the visitor; returns the visitor if there is none.
pub(crate) fn visit<V: Visit>(name: &str, visitor: V) -> Result<V::Out, V> {
    if let Some(deadly) = Deadly::ALL.into_iter().find(|deadly| deadly.name() == name) {
        // Until it strikes, it is as correct as exact.
        return Ok(visitor.visit(Boxed::new(Faulty { fault: Fault::ContactsOneSided, deadly: Some(deadly) }), None));
    }
    if let Some(unsteady) = Unsteady::ALL.into_iter().find(|&unsteady| Unsteady::name(unsteady) == name) {
        return Ok(visitor.visit(Boxed::new(unsteady), None));
    }
    // A scaled tolerance that keeps its promise is not a fault to detect, but it can be run.
    let mut all = Fault::ALL.into_iter().chain(Misscaled::ALL.map(Fault::Misscaled));
    let Some(fault) = all.find(|fault| fault.name() == name) else { return Err(visitor) };
    Ok(match fault {
        Fault::ContactsEndlessEdge | Fault::ContactsOneSided => {
            visitor.visit(Boxed::new(Over::new(fault, Exact, contacts::Contacts)), None)
        }
        Fault::ToleranceNarrowContacts | Fault::ToleranceWideContacts | Fault::ToleranceMirroredWeight => {
            visitor.visit(Boxed::new(Over::new(fault, Tolerance, contacts::Contacts)), None)
        }
        Fault::ToleranceBoastfulFormula => {
            visitor.visit(Boxed::new(Over::new(fault, Tolerance, boastful::Boastful)), None)
        }
        Fault::ToleranceAsPrinted => hand(visitor, Tolerance::<f64>::as_printed(), None),
        Fault::Misscaled(misscaled) => hand(visitor, Tolerance::<f64>::misscaled(misscaled), None),
        Fault::SosAloneOnSphere => {
            let honest = Sos { scheme: Scheme::PerCoordinate };
            visitor.visit(Boxed::new(Over::new(fault, honest, alone::Alone)), Some(ties_by_coordinate()))
        }
        _ => match fault.poses_as() {
            ZeroMeaning::Never => visitor.visit(Boxed::new(Faulty { fault, deadly: None }), Some(ties_by_coordinate())),
            ZeroMeaning::Exact | ZeroMeaning::Band => visitor.visit(Boxed::new(Faulty { fault, deadly: None }), None),
        },
    })
}

struct Faulty {
    fault: Fault,
    deadly: Option<Deadly>,
}

impl Backend for Faulty {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        format!("fault:{}", self.deadly.map_or(self.fault.name(), Deadly::name))
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        match self.fault.poses_as() {
            ZeroMeaning::Band => Tolerance.contract(kind),
            zero => Contract { zero, proved: false },
        }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["faulty"]
    }

    fn constructs(&self) -> Constructs {
        if self.fault.constructs() { Exact.constructs() } else { Constructs::Declines }
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
        // It declines at least as much as the backend that it imitates.
        let tolerance = match self.fault.poses_as() {
            ZeroMeaning::Band => Some(Tolerance.prepare(scene, Off)?),
            // The changed terms are those of input vertices.
            ZeroMeaning::Never => Sos { scheme: Scheme::EdelsbrunnerMucke }.prepare(scene, Off).map(|_| None)?,
            ZeroMeaning::Exact => None,
        };
        Ok(Session {
            fault: self.fault,
            deadly: self.deadly,
            adaptive: Shewchuk.prepare(scene, Off)?,
            float: FLOAT.prepare(scene, Off)?,
            exact: Exact.prepare(scene, Off)?,
            tolerance,
        })
    }
}

/// Plain floating point.
const FLOAT: Naive = Naive { pivot: Pivot::Last };

struct Session<'s> {
    fault: Fault,
    deadly: Option<Deadly>,
    adaptive: <Shewchuk as Backend>::Session<'s, Off>,
    float: <Naive as Backend>::Session<'s, Off>,
    exact: predicament_exact::Session<'s, Off>,
    tolerance: Option<predicament_tolerance::Session<'s, Off>>,
}

impl Session<'_> {
    fn answer<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        if let Some(deadly) = self.deadly {
            deadly.strike(question);
        }
        let exact = question.ask(&self.exact, &args);
        match self.fault {
            Fault::CompareGreaterOnTies if question.kind() == PredicateKind::Compare => {
                if exact.is_zero() {
                    Sign::Positive
                } else {
                    exact
                }
            }
            Fault::SosSwappedTerm
            | Fault::SosBatchFlipped
            | Fault::SosLateSwappedTerm
            | Fault::SosDroppedParity
            | Fault::SosPlaceAsIdentity
            | Fault::SosDroppedLastParity
            | Fault::SosFirstOrderOnly
            | Fault::SosFirstOrderThenParity
            | Fault::SosCollidingLift
            | Fault::SosMixedOrders
            | Fault::SosCircularTies
            | Fault::CompareGreaterOnTies => {
                if exact.is_zero() {
                    ties::break_tie(self.fault, &self.exact, question, args)
                } else {
                    exact
                }
            }
            // These faults need points with coordinates: for other vertices they are as correct as exact.
            Fault::ExactHalvedFilter
            | Fault::ExactTightFilter
            | Fault::ExactRelativeFilter
            | Fault::ExactStaleBound
            | Fault::ExactNan
            | Fault::ExactOneLimb
            | Fault::ExactFlushed
            | Fault::ExactUnguarded
                if args.iter().any(|v| v.is_constructed()) =>
            {
                exact
            }
            Fault::ExactHalvedFilter => self.filtered(question, &args, 0.5).unwrap_or(exact),
            Fault::ExactTightFilter => self.filtered(question, &args, 0.98).unwrap_or(exact),
            Fault::ExactRelativeFilter => self.fooled(question, &args, 0.0).unwrap_or(exact),
            Fault::ExactStaleBound => self.fooled(question, &args, self.stale(question)).unwrap_or(exact),
            Fault::ExactNan => match self.float.estimate(question, &args) {
                Some(determinant) if determinant.is_nan() => Sign::Zero,
                _ => exact,
            },
            Fault::ExactOneLimb => self.one_limb(question, &args).unwrap_or(exact),
            Fault::ExactUnguarded => question.ask(&self.adaptive, &args),
            Fault::ExactFlushed => {
                let scene = self.exact.scene();
                let determinant = predicament_judge::verdict(scene, question, &args).determinant;
                if determinant.to_f64().is_normal() { exact } else { Sign::Zero }
            }
            Fault::ExactRoundedVertex => self.rounded(question, &args).unwrap_or(exact),
            Fault::ToleranceNarrow => self.banded(question, &args, 1.0 / 3.0),
            Fault::ToleranceWide => self.banded(question, &args, 2.0),
            // These are other kinds of faults: see `backend`.
            Fault::ContactsEndlessEdge
            | Fault::ContactsOneSided
            | Fault::ToleranceNarrowContacts
            | Fault::ToleranceWideContacts
            | Fault::ToleranceAsPrinted
            | Fault::ToleranceMirroredWeight
            | Fault::ToleranceBoastfulFormula
            | Fault::SosAloneOnSphere
            | Fault::UnsteadyAgain
            | Fault::Misscaled(_) => exact,
        }
    }

    /// The answer to a query in a batch.
    fn in_batch<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let answer = self.answer(question, args);
        let flips = self.fault == Fault::SosBatchFlipped && question.ask(&self.exact, &args).is_zero();
        if flips { -answer } else { answer }
    }

    /// The sign with constructed vertices rounded; `None` without constructed vertices, or if a rounded one is not
    /// finite.
    fn rounded(&self, question: Question, args: &[Vertex]) -> Option<Sign> {
        let constructed = self.exact.constructed();
        let points: Vec<&[f64]> = args.iter().map(|&v| constructed.approximation(v)).collect();
        let finite = points.as_slice().concat().iter().all(|x| x.is_finite());
        if !finite || args.iter().all(|v| !v.is_constructed()) {
            return None;
        }
        match (question, points.as_slice()) {
            (Question::Compare(axis), [a, b]) => a[axis.index()].partial_cmp(&b[axis.index()]).map(Sign::from),
            (Question::Orient2d(plane), &[a, b, c]) => {
                Some(raw::orient2d([a, b, c].map(|p| plane.axes().map(|axis| p[axis.index()]))))
            }
            (Question::Orient3d, &[a, b, c, d]) => Some(raw::orient3d([a, b, c, d].map(|p| [p[0], p[1], p[2]]))),
            _ => None,
        }
    }

    fn banded(&self, question: Question, args: &[Vertex], factor: f64) -> Sign {
        let Some(tolerance) = &self.tolerance else { return Sign::Zero };
        let (Some(value), Some(band)) = (tolerance.estimate(question, args), tolerance.band(question)) else {
            return question.ask(tolerance, args);
        };
        if value.abs() <= factor * band.width { Sign::Zero } else { Sign::of(value) }
    }
}

impl Predicates for Session<'_> {
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        if self.fault.constructs() {
            return self.exact.construct(definitions);
        }
        Err(Refused::session("the fault is in questions about the vertices that a scene is prepared with"))
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        if matches!(kind, PredicateKind::Derived(_)) {
            return Err(Declined::predicate(kind, "the fault is in predicates with methods of their own"));
        }
        match &self.tolerance {
            Some(tolerance) => tolerance.supports(kind),
            None => self.exact.supports(kind),
        }
    }

    fn supports_contacts(&self) -> Result<(), Declined> {
        match &self.tolerance {
            // No published scheme derives contacts from banded signs.
            Some(_) => Err(Declined::scene("the fault is in the signs; contacts go by distances")),
            None => self.exact.supports_contacts(),
        }
    }

    answer_by!(answer);

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        for (&args, out) in queries.iter().zip(out) {
            *out = self.in_batch(Question::Orient2d(plane), args);
        }
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        for (&args, out) in queries.iter().zip(out) {
            *out = self.in_batch(Question::Orient3d, args);
        }
    }

    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        (self.fault == Fault::ExactNan).then(|| self.float.estimate(question, args)).flatten()
    }

    fn band(&self, question: Question) -> Option<Band> {
        self.tolerance.as_ref().and_then(|tolerance| tolerance.band(question))
    }

    fn reach(&self) -> f64 {
        self.tolerance.as_ref().map_or(0.0, Predicates::reach)
    }
}
