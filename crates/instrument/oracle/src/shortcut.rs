//! Backends without a shortcut: of an algorithm, which the session forbids, or of the breaking of ties.
//!
//! Both give the answers of the whole. They are controls of time.

use predicament_exact::Exact;
use predicament_predicates::{
    Axis, Backend, Batches, Construction, Constructs, Contract, Declined, Off, Plane, PredicateKind, Predicates,
    Question, Refused, Scene, Sessions, Sign, Tally, Vertex, answer_by, forward_to,
};
use predicament_sos::ties::{Sorted, decide};
use predicament_sos::{Scheme, Sos};

/// A backend whose sessions forbid algorithms one shortcut.
pub(crate) struct Forbidding<B> {
    /// The backend.
    pub backend: B,
    /// The backend's own name.
    pub base: &'static str,
    /// The shortcut; `nothing` for none.
    pub shortcut: &'static str,
}

/// A session that forbids algorithms one shortcut.
pub(crate) struct Forbid<P> {
    session: P,
    shortcut: &'static str,
}

impl<B: Backend> Backend for Forbidding<B> {
    type Session<'s, T: Tally + 's>
        = Forbid<B::Session<'s, T>>
    where
        B: 's;

    fn name(&self) -> String {
        format!("{}:without={}", self.base, self.shortcut)
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Contract { proved: false, ..self.backend.contract(kind) }
    }

    fn stages(&self) -> &'static [&'static str] {
        self.backend.stages()
    }

    fn batches(&self, kind: PredicateKind) -> Batches {
        self.backend.batches(kind)
    }

    fn constructs(&self) -> Constructs {
        self.backend.constructs()
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined> {
        Ok(Forbid { session: self.backend.prepare(scene, tally)?, shortcut: self.shortcut })
    }
}

/// Forwards methods that write their answers to `out`.
macro_rules! forward_batches {
    ($($method:ident($($name:ident: $type:ty),*);)+) => {
        $(fn $method(&self, $($name: $type,)* out: &mut [Sign]) {
            self.session.$method($($name,)* out);
        })+
    };
}

impl<P: Predicates> Predicates for Forbid<P> {
    forward_to!(session: scene, predicates, sign);

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.session.construct(definitions)
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.session.supports(kind)
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        self.session.unperturbed()
    }

    fn moves_second_mesh(&self) -> bool {
        self.session.moves_second_mesh()
    }

    fn allows(&self, shortcut: &str) -> bool {
        shortcut != self.shortcut && self.session.allows(shortcut)
    }

    forward_batches! {
        compare_batch(axis: Axis, queries: &[[Vertex; 2]]);
        orient2d_batch(plane: Plane, queries: &[[Vertex; 3]]);
        orient2d_line(plane: Plane, line: [Vertex; 2], points: &[Vertex]);
        orient3d_batch(queries: &[[Vertex; 4]]);
        orient3d_plane(plane: [Vertex; 3], points: &[Vertex]);
        incircle_batch(queries: &[[Vertex; 4]]);
        insphere_batch(queries: &[[Vertex; 5]]);
    }
}

/// The backend `sos` that breaks each tie by the whole list of terms, one after the other: without the leading terms,
/// which are compiled one by one, and without batches of ties.
pub(crate) struct ListAlone;

/// A session of [`ListAlone`].
pub(crate) struct ByList<'s, T> {
    exact: predicament_exact::Session<'s, T>,
    sos: predicament_sos::Session<'s, Off>,
}

const SOS: Sos = Sos { scheme: Scheme::PerCoordinate };

impl Backend for ListAlone {
    type Session<'s, T: Tally + 's> = ByList<'s, T>;

    fn name(&self) -> String {
        "sos:without=leading".to_owned()
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Contract { proved: false, ..SOS.contract(kind) }
    }

    /// The stages of `exact`: the control does not count terms.
    fn stages(&self) -> &'static [&'static str] {
        Exact.stages()
    }

    fn constructs(&self) -> Constructs {
        SOS.constructs()
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<ByList<'s, T>, Declined> {
        Ok(ByList { exact: Exact.prepare(scene, tally)?, sos: SOS.prepare(scene, Off)? })
    }
}

impl<T: Tally> ByList<'_, T> {
    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        if args.iter().any(|v| v.is_constructed()) {
            return question.ask(&self.sos, &args);
        }
        let sign = question.ask(&self.exact, &args);
        if sign.is_zero() { self.tie(question, args) } else { sign }
    }

    #[cold]
    #[inline(never)]
    fn tie<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let Some(Sorted { vertices, parity }) = Sorted::new(args) else { return Sign::Zero };
        let terms = SOS.scheme.terms(question.kind());
        decide(&self.exact, question, terms, &vertices).map_or(Sign::Zero, |(sign, _)| sign * parity)
    }
}

/// Answers a batch of the exact session, then its ties one by one.
///
/// The exact session lacks constructed vertices: the session of `sos` answers a batch with one.
macro_rules! break_ties {
    ($($method:ident($($name:ident: $type:ty),*), $of:ident: $item:ty => $question:expr, $args:expr;)+) => {
        $(fn $method(&self, $($name: $type,)* of: &[$item], out: &mut [Sign]) {
            if of.as_flattened().iter().any(|v| v.is_constructed()) {
                return self.sos.$method($($name,)* of, out);
            }
            self.exact.$method($($name,)* of, out);
            for ($of, out) in of.iter().zip(out) {
                if out.is_zero() {
                    *out = self.ask($question, $args);
                }
            }
        })+
    };
}

impl<T: Tally> Predicates for ByList<'_, T> {
    fn scene(&self) -> &Scene {
        self.sos.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.sos.construct(definitions)
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.sos.supports(kind)
    }

    fn unperturbed(&self) -> Option<&dyn Sessions> {
        self.sos.unperturbed()
    }

    forward_to!(sos: sign);

    answer_by!(ask);

    break_ties! {
        compare_batch(axis: Axis), q: [Vertex; 2] => Question::Compare(axis), *q;
        orient2d_batch(plane: Plane), q: [Vertex; 3] => Question::Orient2d(plane), *q;
        orient3d_batch(), q: [Vertex; 4] => Question::Orient3d, *q;
        incircle_batch(), q: [Vertex; 4] => Question::Incircle, *q;
        insphere_batch(), q: [Vertex; 5] => Question::Insphere, *q;
    }
}
