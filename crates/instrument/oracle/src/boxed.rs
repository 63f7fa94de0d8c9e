//! A type-erased backend: tasks are compiled once for all such backends.
//!
//! Backends with published timings are passed with their own type by [`visit`](crate::roster::visit). Backends that are
//! rarely timed, or report their own time, go behind a pointer, and a query costs a dynamic call.

use predicament_predicates::{
    Backend, Batches, Constructs, Contract, Counts, Declined, PredicateKind, Predicates, Scene, Tally,
};

/// A session of any type.
type Session<'s> = Box<dyn Predicates + 's>;

/// A backend of any type.
pub(crate) struct Boxed(Box<dyn Any>);

impl Boxed {
    /// Wraps this backend.
    pub(crate) fn new<B: Backend + 'static>(backend: B) -> Boxed {
        Boxed(Box::new(backend))
    }
}

/// A [`Backend`] whose types are hidden.
trait Any: Send + Sync {
    fn name(&self) -> String;
    fn contract(&self, kind: PredicateKind) -> Contract;
    fn stages(&self) -> &'static [&'static str];
    fn batches(&self, kind: PredicateKind) -> Batches;
    fn constructs(&self) -> Constructs;
    fn version(&self) -> Option<String>;
    fn binding(&self) -> Option<Boxed>;
    fn prepare<'s>(&'s self, scene: &'s Scene, counts: Option<&'s Counts>) -> Result<Session<'s>, Declined>;
}

impl<B: Backend + 'static> Any for B {
    fn name(&self) -> String {
        Backend::name(self)
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Backend::contract(self, kind)
    }

    fn stages(&self) -> &'static [&'static str] {
        Backend::stages(self)
    }

    fn batches(&self, kind: PredicateKind) -> Batches {
        Backend::batches(self, kind)
    }

    fn constructs(&self) -> Constructs {
        Backend::constructs(self)
    }

    fn version(&self) -> Option<String> {
        Backend::version(self)
    }

    fn binding(&self) -> Option<Boxed> {
        Backend::binding(self).map(Boxed::new)
    }

    fn prepare<'s>(&'s self, scene: &'s Scene, counts: Option<&'s Counts>) -> Result<Session<'s>, Declined> {
        Backend::boxed(self, scene, counts)
    }
}

// An omitted method would use its default instead of the backend's own method.
#[deny(clippy::missing_trait_methods)]
impl Backend for Boxed {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        self.0.name()
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        self.0.contract(kind)
    }

    fn stages(&self) -> &'static [&'static str] {
        self.0.stages()
    }

    fn batches(&self, kind: PredicateKind) -> Batches {
        self.0.batches(kind)
    }

    fn constructs(&self) -> Constructs {
        self.0.constructs()
    }

    fn version(&self) -> Option<String> {
        self.0.version()
    }

    fn binding(&self) -> Option<Boxed> {
        self.0.binding()
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s>, Declined> {
        self.0.prepare(scene, tally.counts())
    }

    fn boxed<'s>(&'s self, scene: &'s Scene, counts: Option<&'s Counts>) -> Result<Session<'s>, Declined> {
        self.0.prepare(scene, counts)
    }
}
