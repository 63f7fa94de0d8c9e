//! Laws about many tuples: batches give the same findings as single checks, and use batched queries only.

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use predicament_exact::Exact;
use predicament_laws::axioms::{
    antisymmetry, antisymmetry_of_all, independence_of_later_vertices, independence_of_later_vertices_of_all,
    relations, transitivity, transitivity_of_all,
};
use predicament_predicates::{
    Axis, Backend, Off, Plane, Predicates, Question, Scene, Sign, Vertex, ZeroMeaning, answer_by,
};
use predicament_sos::Sos;

use super::{choices, grid2, grid3};
use crate::common::{Fault, Faulty};

/// A session that answers batches only, each query as another session answers it alone; it counts the batches.
struct Batches<'s, P> {
    alone: &'s P,
    batches: AtomicUsize,
}

impl<P: Predicates> Batches<'_, P> {
    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        panic!("{} was asked alone", question.query(&args))
    }

    fn answer<const N: usize>(&self, question: Question, queries: &[[Vertex; N]], out: &mut [Sign]) {
        self.batches.fetch_add(1, Relaxed);
        queries.iter().zip(out).for_each(|(query, out)| *out = question.ask(self.alone, query));
    }
}

impl<P: Predicates> Predicates for Batches<'_, P> {
    fn scene(&self) -> &Scene {
        self.alone.scene()
    }

    answer_by!(ask);

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        self.answer(Question::Compare(axis), queries, out);
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.answer(Question::Orient2d(plane), queries, out);
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.answer(Question::Orient3d, queries, out);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.answer(Question::Incircle, queries, out);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        self.answer(Question::Insphere, queries, out);
    }
}

/// Every third choice of vertices, not all in ascending order.
fn some<const N: usize>(vertices: usize) -> Vec<[Vertex; N]> {
    let mut some: Vec<[Vertex; N]> = choices(vertices).into_iter().step_by(3).collect();
    some.iter_mut().step_by(2).for_each(|args| args.reverse());
    some
}

/// Compares the findings for tuples in one batch with the findings for each tuple alone; returns their number.
fn compare<P: Predicates>(alone: &P, zero: ZeroMeaning, questions: &[Question]) -> usize {
    let session = Batches { alone, batches: AtomicUsize::new(0) };
    let asked = |most: usize| assert!((1..=most).contains(&session.batches.swap(0, Relaxed)), "{most} batches");
    let n = alone.scene().len();
    let mut count = 0;
    for &question in questions {
        let tuples: Vec<Vec<Vertex>> = match question.kind().arity() {
            2 => some::<2>(n).iter().map(|args| args.to_vec()).collect(),
            3 => some::<3>(n).iter().map(|args| args.to_vec()).collect(),
            4 => some::<4>(n).iter().map(|args| args.to_vec()).collect(),
            _ => some::<5>(n).iter().map(|args| args.to_vec()).collect(),
        };
        let queries: Vec<&[Vertex]> = tuples.iter().map(Vec::as_slice).collect();
        let found = antisymmetry_of_all(&session, question, &queries, zero);
        asked(1);
        assert_eq!(found, queries.iter().map(|args| antisymmetry(alone, question, args, zero)).collect::<Vec<_>>());
        count += found.iter().map(Vec::len).sum::<usize>();
        for relation in relations(question) {
            let tuples: Vec<Vec<Vertex>> = relation.tuples(n).step_by(5).collect();
            let found = relation.check_all(&session, &tuples, zero.into());
            asked(relation.questions().count());
            let each: Vec<_> = tuples.iter().map(|tuple| relation.check(alone, tuple, zero.into())).collect();
            assert_eq!(found, each, "{:?}", relation.at_infinity());
            count += found.iter().flatten().count();
        }
    }
    let triples = some::<3>(n);
    let found = transitivity_of_all(&session, Axis::X, &triples, zero);
    asked(1);
    assert_eq!(found, triples.iter().map(|&triple| transitivity(alone, Axis::X, triple, zero)).collect::<Vec<_>>());
    count + found.iter().flatten().count()
}

#[test]
fn what_is_asked_in_batches_finds_what_is_found_alone() {
    let planar = [Question::Compare(Axis::X), Question::Orient2d(Plane::Xy), Question::Incircle];
    let spatial = [Question::Compare(Axis::Z), Question::Orient2d(Plane::Yz), Question::Orient3d, Question::Insphere];
    let mut found = 0;
    for (scene, questions) in [(grid2(3), planar.as_slice()), (grid3(), &spatial)] {
        for fault in [
            Fault::None,
            Fault::OneSidedPair([0, 4]),
            Fault::FlippedTriple([0, 2, 7]),
            Fault::FlippedQuadruple([0, 1, 2, 4]),
            Fault::TiesByPlace,
            Fault::TiesUp,
            Fault::Epsilon(1.5),
        ] {
            let alone = Faulty { inner: Exact.prepare(&scene, Off).unwrap(), fault };
            for zero in [ZeroMeaning::Exact, ZeroMeaning::Band, ZeroMeaning::Never] {
                let count = compare(&alone, zero, questions);
                assert!(count == 0 || !matches!(fault, Fault::None));
                found += count;
            }
        }
    }
    assert!(found > 100, "{found} violations to compare");
}

#[test]
fn later_vertices_are_left_out_in_two_batches() {
    let (scene, first) = (grid2(4), grid2(4).coordinates()[..24].to_vec());
    let first = Scene::new(scene.dimension(), first).unwrap();
    let sos = Sos::default();
    let [few, all] = [&first, &scene]
        .map(|scene| Faulty { inner: sos.prepare(scene, Off).unwrap(), fault: Fault::CountedFromTheEnd });
    let batches = [&few, &all].map(|alone| Batches { alone, batches: AtomicUsize::new(0) });
    let triples = some::<3>(12);
    let queries: Vec<&[Vertex]> = triples.iter().map(<[Vertex; 3]>::as_slice).collect();
    let turn = Question::Orient2d(Plane::Xy);
    let found = independence_of_later_vertices_of_all(&batches[0], &batches[1], turn, &queries);
    let alone = queries.iter().map(|args| independence_of_later_vertices(&few, &all, turn, args));
    assert_eq!(found, alone.collect::<Vec<_>>());
    assert!(found.iter().any(Option::is_some));
    assert_eq!(batches.map(|session| session.batches.into_inner()), [1, 1]);
}
