//! A perturbation that moves one of two meshes as a whole.
//!
//! PinMesh and 3D-EPUG-Overlay (Magalhães, Franklin and Andrade) move one of their meshes by (ε, ε², ε³) and leave the
//! other in place. Here the move is η·(ε, ε², ε³), with η smaller than every power of ε, so that no answer depends on
//! the unit of length (see `constructed/rigid.rs`). Then nothing between the two is degenerate, and each keeps its own
//! coplanar faces, as it is moved as a whole. Ties within one mesh are not broken.
//!
//! The determinants are exact polynomials in η and ε, so there is no search and no guess. In η²·ε²·ε² = η²·ε·ε³
//! infinitesimals collide; their coefficients add up. If one input vertex of one mesh meets those of the other, the
//! polynomial is linear: see `shift.rs`.

use predicament_exact::Exact;
use predicament_exact::constructed::{EXACT as CONSTRUCTED, FILTER};
use predicament_predicates::{
    Axis, Backend, Construction, Constructs, Contract, Declined, MAX_STAGES, Off, Plane, PredicateKind, Predicates,
    Question, Refused, Scene, Sessions, Sign, Tally, Vertex, ZeroMeaning,
};

use crate::constructed::{self, corner, fixed, rigid};
#[cfg(feature = "formulas")]
use crate::derived;
use crate::shift::{self, PlaneTies};

/// Simulation of Simplicity between two meshes: the second has moved by η·(ε, ε², ε³).
///
/// Both are infinitesimals, and η is smaller than every power of ε.
///
/// The answer is zero if a determinant is zero however far the mesh moves: about vertices of one mesh, and about
/// directions that both meshes have. The backend declines scenes without [two meshes](Scene::with_second_mesh).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct PerMesh;

const EXACT: usize = predicament_exact::stage::NAMES.len();

/// The exact backend's stages, then the deciding power of ε.
static STAGES: [&str; EXACT + 5] = {
    const POWERS: [&str; 5] = ["power 1", "power 2", "power 3", "power 4", "power 5 or more"];
    let mut all = [""; EXACT + 5];
    let mut i = 0;
    while i < all.len() {
        all[i] = if i < EXACT { predicament_exact::stage::NAMES[i] } else { POWERS[i - EXACT] };
        i += 1;
    }
    all
};

const _: () = assert!(EXACT + 5 <= MAX_STAGES);

/// The stage of an answer about points of lines and planes, by the deciding power of ε.
///
/// Power 0 means that the exact backend would have decided.
fn stage_of(power: usize) -> usize {
    if power == 0 { CONSTRUCTED } else { EXACT + power.min(5) - 1 }
}

impl Backend for PerMesh {
    type Session<'s, T: Tally + 's> = Session<'s, T>;

    fn name(&self) -> String {
        "sos:per-mesh".to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Never, proved: true }
    }

    fn stages(&self) -> &'static [&'static str] {
        &STAGES
    }

    fn constructs(&self) -> Constructs {
        Constructs::KeepsFirst
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
        if scene.second_mesh().is_none() {
            return Err(Declined::scene("the scene has no two meshes, one of which could be moved as a whole"));
        }
        constructed::are_of_inputs(scene)?;
        Ok(Session { exact: Exact.prepare(scene, Off)?, tally })
    }

    predicament_predicates::boxed_here!();
}

/// The backend, prepared for one scene.
pub struct Session<'s, T> {
    exact: predicament_exact::Session<'s, Off>,
    tally: T,
}

impl<T: Tally> Session<'_, T> {
    #[inline(always)]
    fn settle<const N: usize>(&self, question: Question, args: [Vertex; N], (sign, stage): (Sign, usize)) -> Sign {
        if sign.is_zero() {
            return self.tie(question, args, || stage);
        }
        self.tally.settled(question.kind(), stage);
        sign
    }

    /// Answers a query about constructed vertices that the exact backend's filter leaves open.
    #[inline(never)]
    fn settle_constructed<const N: usize>(
        &self,
        question: Question,
        args: [Vertex; N],
        decided: fixed::Decided,
        exact: impl FnOnce() -> (Sign, usize),
    ) -> Sign {
        let (sign, stage) = match decided {
            None => return self.settle(question, args, exact()),
            Some(Some((sign, power))) => (sign, stage_of(power)),
            Some(None) => (Sign::Zero, CONSTRUCTED),
        };
        self.tally.settled(question.kind(), stage);
        sign
    }

    /// For each vertex, true if it moves; some do.
    fn second(&self) -> &[bool] {
        self.exact.scene().second_mesh().unwrap_or_default()
    }

    #[inline(never)]
    fn compare_constructed(&self, axis: Axis, [a, b]: [Vertex; 2]) -> Sign {
        if let Some(sign) = self.exact.constructed().compare_by_filter(axis, a, b) {
            self.tally.settled(PredicateKind::Compare, FILTER);
            return sign;
        }
        let decided = fixed::compare(self.exact.scene(), self.second(), axis, [a, b]);
        let exact = || (self.exact.constructed().compare_exactly(axis, [a, b]), CONSTRUCTED);
        self.settle_constructed(Question::Compare(axis), [a, b], decided, exact)
    }

    #[inline(never)]
    fn orient2d_constructed(&self, plane: Plane, [a, b, c]: [Vertex; 3]) -> Sign {
        let (constructed, args) = (self.exact.constructed(), [a, b, c]);
        if let Some(sign) = constructed.orient2d_by_first_filter(plane, a, b, c) {
            self.tally.settled(PredicateKind::Orient2d, FILTER);
            return sign;
        }
        let mut decided = corner::orient2d(&self.exact, self.second(), plane, args).map(Some);
        if decided.is_none() {
            if let Some(sign) = constructed.orient2d_by_filter(plane, a, b, c) {
                self.tally.settled(PredicateKind::Orient2d, FILTER);
                return sign;
            }
            decided = fixed::orient2d(self.exact.scene(), self.second(), plane, args);
        }
        let exact = || (constructed.orient2d_exactly(plane, args), CONSTRUCTED);
        self.settle_constructed(Question::Orient2d(plane), args, decided, exact)
    }

    #[cold]
    #[inline(never)]
    fn tie<const N: usize>(&self, question: Question, args: [Vertex; N], exact_stage: impl FnOnce() -> usize) -> Sign {
        // Between input vertices a derivative breaks most ties; all others need polynomials.
        let shifted = match (question, &args[..]) {
            (Question::Compare(axis), &[a, b]) => shift::compare(&self.exact, axis, [a, b]),
            (Question::Orient2d(plane), &[a, b, c]) => shift::orient2d(&self.exact, plane, [a, b, c]),
            (Question::Orient3d, &[a, b, c, d]) => shift::orient3d(&self.exact, [a, b, c, d]),
            _ => None,
        };
        let decided = shifted.unwrap_or_else(|| rigid::decide(self.exact.scene(), question, &args));
        self.broken(question.kind(), decided, exact_stage)
    }

    /// Tallies a tie: by the deciding power, or by the exact backend's stage.
    fn broken(&self, kind: PredicateKind, decided: Option<(Sign, usize)>, exact_stage: impl FnOnce() -> usize) -> Sign {
        if let Some((sign, power)) = decided {
            self.tally.settled(kind, stage_of(power.max(1)));
            return sign;
        }
        if T::LISTENS {
            self.tally.settled(kind, exact_stage());
        }
        Sign::Zero
    }

    /// Answers a query that the exact backend's first filter leaves open.
    ///
    /// If vertices of the two meshes coincide, it is a tie without any computation.
    #[cold]
    #[inline(never)]
    fn next_orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        let exact = || self.exact.decide_orient3d(a, b, c, d);
        if shift::has_twins(self.exact.scene(), [a, b, c, d]) {
            return self.tie(Question::Orient3d, [a, b, c, d], || exact().1);
        }
        self.settle(Question::Orient3d, [a, b, c, d], exact())
    }
}

impl<T: Tally> Predicates for Session<'_, T> {
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.exact.construct_where(definitions, constructed::is_of_inputs)
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        Some(&Exact)
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.exact.supports(kind)
    }

    #[cfg(feature = "formulas")]
    fn sign(&self, predicate: predicament_predicates::Derived, vertices: &[Vertex]) -> Sign {
        let kind = PredicateKind::Derived(predicate);
        let (sign, stage) = self.exact.decide_derived(predicate, vertices);
        if sign.is_zero() {
            let decided = derived::moved_tie(self.second(), self.scene(), predicate, vertices);
            return self.broken(kind, decided.map(|(sign, place)| (sign, place + 1)), || stage);
        }
        self.tally.settled(kind, stage);
        sign
    }

    fn moves_second_mesh(&self) -> bool {
        true
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        if a.is_constructed() || b.is_constructed() {
            return self.compare_constructed(axis, [a, b]);
        }
        self.settle(Question::Compare(axis), [a, b], self.exact.decide_compare(axis, a, b))
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        if a.is_constructed() || b.is_constructed() || c.is_constructed() {
            return self.orient2d_constructed(plane, [a, b, c]);
        }
        self.settle(Question::Orient2d(plane), [a, b, c], self.exact.decide_orient2d(plane, a, b, c))
    }

    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        match self.exact.filter_orient3d(a, b, c, d) {
            Some((sign, stage)) if !sign.is_zero() => {
                self.tally.settled(PredicateKind::Orient3d, stage);
                sign
            }
            _ => self.next_orient3d(a, b, c, d),
        }
    }

    fn orient3d_plane(&self, plane: [Vertex; 3], points: &[Vertex], out: &mut [Sign]) {
        let [a, b, c] = plane;
        if T::LISTENS {
            // Only single queries tell which of the exact backend's stages settled them.
            return points.iter().zip(out).for_each(|(&d, out)| *out = self.orient3d(a, b, c, d));
        }
        self.exact.orient3d_plane(plane, points, out);
        let mut ties = None;
        for (&d, out) in points.iter().zip(out).filter(|(_, out)| out.is_zero()) {
            let ties = ties.get_or_insert_with(|| PlaneTies::new(&self.exact, plane));
            *out = match ties.as_ref().and_then(|ties| ties.of(&self.exact, d)) {
                Some(decided) => self.broken(PredicateKind::Orient3d, decided, || 0),
                None => self.orient3d(a, b, c, d),
            };
        }
    }

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.settle(Question::Incircle, [a, b, c, d], self.exact.decide_incircle(a, b, c, d))
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.settle(Question::Insphere, [a, b, c, d, e], self.exact.decide_insphere(a, b, c, d, e))
    }
}
