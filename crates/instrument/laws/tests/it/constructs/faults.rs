//! A faulty backend: exact answers, and one fault in how it constructs.

use predicament_controls::Shewchuk;
use predicament_exact::Exact;
use predicament_predicates::{
    Backend, Construction, Constructs, Contract, Declined, DefinitionError, NoPoint, Off, Plane, PredicateKind,
    Predicates, Question, Refused, Scene, Sign, Tally, Vertex, answer_by,
};

/// True if a construction was refused because lines, or a line and a plane, are parallel.
fn is_parallel(reason: &DefinitionError) -> bool {
    matches!(reason, DefinitionError::NoPoint(NoPoint::ParallelLines | NoPoint::ParallelToPlane))
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fault {
    None,
    /// A construction in another order than before gives a new vertex.
    ForgetsToIntern,
    /// Ids are sorted by construction, whatever order the constructions arrive in.
    Sorts,
    /// Constructions before a refused construction stay.
    KeepsThePrefix,
    /// Vertices defined by constructed vertices are rounded.
    RoundsTheSecondLevel,
    /// Vertices are rounded if the scene was not prepared with them.
    RoundsWhatIsNew,
    /// Vertices are rounded in batches only.
    RoundsInBatches,
    /// The backend declares that it keeps vertices, but it declines constructions.
    DeclinesInstead,
    /// The backend declares that it declines constructions, but it constructs.
    ConstructsInSecret,
    /// Parallel lines get the vertex of the previous construction.
    TakesParallels,
}

pub struct Faulty(pub Fault);

pub struct Session<'s> {
    exact: <Exact as Backend>::Session<'s, Off>,
    /// A session with rounded vertices, and exact signs about the rounded vertices.
    rounded: <Shewchuk as Backend>::Session<'s, Off>,
    prepared: usize,
    fault: Fault,
}

impl Backend for Faulty {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        format!("{:?}", self.0)
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Exact.contract(kind)
    }

    fn stages(&self) -> &'static [&'static str] {
        Exact.stages()
    }

    fn constructs(&self) -> Constructs {
        if self.0 == Fault::ConstructsInSecret { Constructs::Declines } else { Constructs::Keeps }
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
        let (exact, rounded) = (Exact.prepare(scene, Off)?, Shewchuk.prepare(scene, Off)?);
        Ok(Session { exact, rounded, prepared: scene.constructions().len(), fault: self.0 })
    }
}

impl Session<'_> {
    fn both(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        let vertices = self.exact.construct(definitions)?;
        self.rounded.construct(definitions)?;
        Ok(vertices)
    }

    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let rounds = |v: &Vertex| match self.fault {
            Fault::RoundsTheSecondLevel => self.scene().construction(*v).is_some_and(|by| !by.is_of_inputs()),
            Fault::RoundsWhatIsNew => self.is_new(*v),
            _ => false,
        };
        if args.iter().any(rounds) { question.ask(&self.rounded, &args) } else { question.ask(&self.exact, &args) }
    }

    fn is_new(&self, v: Vertex) -> bool {
        v.construction().is_some_and(|index| index >= self.prepared)
    }
}

impl Predicates for Session<'_> {
    fn scene(&self) -> &Scene {
        self.exact.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        let known = self.scene().constructions().len();
        match self.fault {
            Fault::DeclinesInstead => return Err(Refused::session("not today")),
            Fault::Sorts => {
                let mut sorted = definitions.to_vec();
                sorted.sort_unstable();
                self.both(&sorted)?;
            }
            _ => {}
        }
        let mut constructed = self.both(definitions);
        if let Err(Refused::Definition { index, reason, .. }) = &constructed {
            let (prefix, rest) = definitions.split_at(*index);
            match self.fault {
                Fault::KeepsThePrefix => drop(self.both(prefix)),
                Fault::TakesParallels if is_parallel(reason) => constructed = self.both(&[prefix, &rest[1..]].concat()),
                _ => {}
            }
        }
        if let (Fault::ForgetsToIntern, Ok(vertices)) = (self.fault, &mut constructed) {
            for (vertex, definition) in vertices.iter_mut().zip(definitions) {
                let known_by_order = *definition == definition.canonical();
                if vertex.construction().is_some_and(|index| index < known) && !known_by_order {
                    *vertex = Vertex::constructed(known);
                }
            }
        }
        constructed
    }

    answer_by!(ask);

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        for (&[a, b, c], out) in queries.iter().zip(out) {
            let rounds = self.fault == Fault::RoundsInBatches && [a, b, c].iter().any(|&v| self.is_new(v));
            *out = if rounds { self.rounded.orient2d(plane, a, b, c) } else { self.orient2d(plane, a, b, c) };
        }
    }
}
