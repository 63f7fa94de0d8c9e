//! Batches answer as their queries do one by one, also where they are full of ties.

use crate::common::{Random, grid_scene, questions};
use predicament_predicates::{Backend, Counts, Off, Predicates, QuerySet, Question, Sign, Vertex};
use predicament_sos::{Scheme, Sos};

const QUERIES: usize = 500;
const VERTICES: usize = 60;

fn check(session: &impl Predicates, dimension: usize) {
    let mut random = Random(5);
    let mut vertex = || Vertex::input(random.below(VERTICES));
    for question in questions(dimension) {
        let arity = question.kind().arity();
        let set = QuerySet::new(question, (0..QUERIES * arity).map(|_| vertex()).collect());
        let mut out = vec![Sign::Zero; QUERIES];
        set.ask_batch(session, 0..QUERIES, &mut out);
        let singles: Vec<Sign> = (0..QUERIES).map(|query| question.ask(session, set.args(query))).collect();
        assert_eq!(out, singles, "{question:?}");

        let points: Vec<Vertex> = (0..QUERIES).map(|_| vertex()).collect();
        let first: Vec<Vertex> = (1..arity).map(|_| vertex()).collect();
        match (question, &first[..]) {
            (Question::Orient2d(plane), &[a, b]) => session.orient2d_line(plane, [a, b], &points, &mut out),
            (Question::Orient3d, &[a, b, c]) => session.orient3d_plane([a, b, c], &points, &mut out),
            _ => continue,
        }
        let each = points.iter().map(|&last| question.ask(session, &[&first[..], &[last]].concat()));
        assert_eq!(out, each.collect::<Vec<_>>(), "{question:?} beside {first:?}");
    }
}

#[test]
fn batches_are_queries_one_by_one() {
    for dimension in [2, 3] {
        let side = 4;
        let cells = side * side * if dimension == 3 { side } else { 1 };
        let scene = grid_scene(dimension, side, &Random(3).numbers(cells, VERTICES));
        for scheme in Scheme::ALL {
            let backend = Sos { scheme };
            check(&backend.prepare(&scene, Off).unwrap(), dimension);
            // Where somebody listens, queries are asked one by one.
            let counts = Counts::new();
            check(&backend.prepare(&scene, &counts).unwrap(), dimension);
        }
    }
}
