//! Batches answer like single queries, also if they are full of ties.

use crate::common::{Random, grid_scene, questions};
use predicament_exact::Exact;
use predicament_predicates::{
    Backend, Construction, Counts, Off, Plane, PredicateKind, Predicates, QuerySet, Question, Scene, Sign, Vertex,
};
use predicament_sos::{PerMesh, Scheme, Sos};

const QUERIES: usize = 500;
const VERTICES: usize = 60;

fn check(session: &impl Predicates, dimension: usize) {
    check_among(session, &questions(dimension), &(0..VERTICES).map(Vertex::input).collect::<Vec<_>>());
}

fn check_among(session: &impl Predicates, questions: &[Question], vertices: &[Vertex]) {
    let mut random = Random(5);
    let mut vertex = || vertices[random.below(vertices.len())];
    for &question in questions {
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
            // If a tally listens, queries run one by one.
            let counts = Counts::new();
            check(&backend.prepare(&scene, &counts).unwrap(), dimension);
            // Ties of numbers so long that doubles round, at all scales, including the ends of the range.
            for exponent in [-1060, -400, -100, 0, 30, 200, 900] {
                let [half, rest] = [exponent / 2, exponent - exponent / 2].map(|exponent| 2_f64.powi(exponent));
                let longer = |x: &f64| x * f64::from_bits(0x3ff1_2345_6789_0000) * half * rest;
                let longer = scene.coordinates().iter().map(longer).collect();
                let scene = Scene::new(scene.dimension(), longer).unwrap();
                check(&backend.prepare(&scene, Off).unwrap(), dimension);
            }
        }
    }
}

/// Vertices of a line or a plane, so that every query is a tie, and others; half of them constructed.
#[test]
fn batches_about_constructed_vertices_are_queries_one_by_one() {
    let v = Vertex::input;
    let mut flat = grid_scene(2, 3, &(0..9).collect::<Vec<_>>());
    let crossings = [[[0, 8], [2, 6]], [[1, 7], [3, 5]], [[0, 4], [3, 5]], [[1, 5], [2, 8]], [[0, 3], [5, 4]]];
    let crossings = crossings.map(|lines| flat.construct(Construction::Ssi(lines.map(|ends| ends.map(v)))).unwrap());
    let mut solid = grid_scene(3, 2, &(0..8).collect::<Vec<_>>());
    let meets =
        [([0, 7], [1, 2, 4]), ([1, 6], [0, 3, 5]), ([0, 4], [0, 1, 2]), ([2, 6], [0, 1, 3]), ([1, 5], [3, 2, 0])]
            .map(|(line, plane)| Construction::Lpi { line: line.map(v), plane: plane.map(v) });
    let meets = meets.map(|meet| solid.construct(meet).unwrap());
    // On the middle line of the square grid, and on the bottom of the cube.
    let line = [&[3, 4, 5].map(v)[..], &crossings[..3], &crossings[4..]].concat();
    let bottom = [&[0, 1, 2, 3].map(v)[..], &meets[2..]].concat();
    let all = |scene: &Scene, constructed: &[Vertex]| {
        (0..scene.len()).map(v).chain(constructed.iter().copied()).collect::<Vec<_>>()
    };
    let scenes = [(2, &flat, [line, all(&flat, &crossings)]), (3, &solid, [bottom, all(&solid, &meets)])];
    for (dimension, scene, groups) in scenes {
        let backend = Sos::default();
        let session = backend.prepare(scene, Off).unwrap();
        let exact = Exact.prepare(scene, Off).unwrap();
        let circles = [Question::Incircle, Question::Insphere];
        let questions: Vec<Question> = questions(dimension).into_iter().filter(|q| !circles.contains(q)).collect();
        for vertices in &groups {
            check_among(&session, &questions, vertices);
        }
        // All of them at once, each a tie.
        let (question, [ties, _]) =
            (if dimension == 2 { Question::Orient2d(Plane::Xy) } else { Question::Orient3d }, groups);
        let args: Vec<Vertex> = ties.windows(question.kind().arity()).flatten().copied().collect();
        for args in args.chunks(question.kind().arity()) {
            assert_eq!(question.ask(&exact, args), Sign::Zero, "{args:?}");
        }
    }
}

/// Asks some queries one by one, and checks that one stage settles each, and never an exact stage for ties.
fn tallied<B: Backend>(backend: &B, scene: &Scene, vertices: &[Vertex], first_of_ties: usize) -> [u64; 2] {
    let counts = Counts::new();
    let session = backend.prepare(scene, &counts).unwrap();
    let exact = Exact.prepare(scene, Off).unwrap();
    let dimension = scene.dimension().count();
    let circles = [Question::Incircle, Question::Insphere];
    let (mut random, mut seen) = (Random(8), [0; 2]);
    for question in questions(dimension) {
        if circles.contains(&question) && vertices.iter().any(|v| v.is_constructed()) {
            continue;
        }
        let settled =
            |stages: std::ops::Range<usize>| stages.map(|stage| counts.get(question.kind(), stage)).sum::<u64>();
        for _ in 0..100 {
            let args: Vec<Vertex> =
                (0..question.kind().arity()).map(|_| vertices[random.below(vertices.len())]).collect();
            let before = [settled(0..backend.stages().len()), settled(first_of_ties..backend.stages().len())];
            let sign = question.ask(&session, &args);
            let after = [settled(0..backend.stages().len()), settled(first_of_ties..backend.stages().len())];
            assert_eq!(after[0] - before[0], 1, "{question:?} of {args:?}");
            // (Two vertices in order of their indices are not a term of a list.)
            let is_broken = question.ask(&exact, &args).is_zero() && !sign.is_zero();
            let by_term = after[1] - before[1] == 1;
            assert!(is_broken || !by_term, "{question:?} of {args:?}");
            assert!(by_term || !is_broken || question.kind() == PredicateKind::Compare, "{question:?} of {args:?}");
            seen[usize::from(is_broken)] += 1;
        }
    }
    seen
}

#[test]
fn every_query_is_tallied_once_and_ties_by_what_breaks_them() {
    let v = Vertex::input;
    let exact = Exact.stages().len();
    for dimension in [2, 3] {
        let side = if dimension == 2 { 4 } else { 3 };
        let cells = side * side * if dimension == 3 { side } else { 1 };
        let mut scene = grid_scene(dimension, side, &Random(9).numbers(cells, 20));
        let inputs: Vec<Vertex> = (0..20).map(v).collect();
        let mut seen = vec![
            tallied(&Sos::default(), &scene, &inputs, exact),
            tallied(&Sos { scheme: Scheme::EdelsbrunnerMucke }, &scene, &inputs, exact),
        ];
        // Points of lines and planes of one half of the vertices each.
        let mut random = Random(10);
        for at in 0..60 {
            let half = |first: usize, random: &mut Random| v(first + random.below(10));
            let [a, b, p, q, r] = [0, 0, 10, 10, 10].map(|first| half(first, &mut random));
            let construction = match (dimension, at % 2) {
                (2, _) => Construction::Ssi([[a, b], [p, q]]),
                (_, 0) => Construction::Lpi { line: [a, b], plane: [p, q, r] },
                _ => Construction::Lpi { line: [p, q], plane: [a, b, half(0, &mut random)] },
            };
            let mut with = scene.clone();
            if with.construct(construction).is_ok() && Exact.prepare(&with, Off).is_ok() {
                scene = with;
            }
        }
        let constructed = scene.constructions().len();
        assert!(constructed > 5, "{constructed}");
        let all: Vec<Vertex> = inputs.iter().copied().chain((0..constructed).map(Vertex::constructed)).collect();
        seen.push(tallied(&Sos::default(), &scene, &all, exact));
        seen.push(tallied(&PerMesh, &scene.clone().with_second_mesh((10..20).map(v)), &all, exact));
        assert!(seen.iter().flatten().all(|&count| count > 20), "{seen:?}");
    }
}

/// A perturbation moves only vertices that input vertices define.
///
/// Others are refused, before and after they are constructed.
#[test]
fn vertices_that_constructed_vertices_define_are_declined() {
    let v = Vertex::input;
    let mut scene = grid_scene(2, 3, &(0..9).collect::<Vec<_>>());
    let (first, backend) = (Construction::Ssi([[v(0), v(8)], [v(2), v(6)]]), Sos::default());
    let middle = scene.construct(first).unwrap();
    let deep = Construction::Ssi([[middle, v(1)], [v(3), v(8)]]);
    let two = scene.clone().with_second_mesh((4..9).map(v));
    let refused = [
        backend.prepare(&scene, Off).unwrap().construct(&[deep]).unwrap_err(),
        PerMesh.prepare(&two, Off).unwrap().construct(&[deep]).unwrap_err(),
    ];
    scene.construct(deep).unwrap();
    let two = scene.clone().with_second_mesh((4..9).map(v));
    let declined = [backend.prepare(&scene, Off).err(), PerMesh.prepare(&two, Off).err()];
    let declined = declined.map(|declined| declined.expect("declined").to_string());
    for why in refused.iter().map(ToString::to_string).chain(declined) {
        assert!(why.contains("applies only to vertices that input vertices define"), "{why}");
    }
}

/// Queries of a plane of one mesh, of the other, and of both.
#[test]
fn batches_of_two_meshes_are_queries_one_by_one() {
    for dimension in [2, 3] {
        let side = 3;
        let cells = side * side * if dimension == 3 { side } else { 1 };
        let scene = grid_scene(dimension, side, &Random(4).numbers(cells, VERTICES));
        let scene = scene.with_second_mesh((VERTICES / 2..VERTICES).map(Vertex::input));
        check(&PerMesh.prepare(&scene, Off).unwrap(), dimension);
        check(&PerMesh.prepare(&scene, &Counts::new()).unwrap(), dimension);
    }
    // Planes of one mesh; all else on either side of them, and in them.
    let scene = grid_scene(3, 3, &Random(6).numbers(27, VERTICES));
    let scene = scene.with_second_mesh((VERTICES / 2..VERTICES).map(Vertex::input));
    let session = PerMesh.prepare(&scene, Off).unwrap();
    let exact = Exact.prepare(&scene, Off).unwrap();
    let points: Vec<Vertex> = (0..VERTICES).map(Vertex::input).collect();
    let (mut random, mut ties) = (Random(7), [0; 2]);
    for round in 0..400 {
        let mesh = round % 2;
        let plane = [(); 3].map(|()| Vertex::input(mesh * VERTICES / 2 + random.below(VERTICES / 2)));
        let mut out = vec![Sign::Zero; VERTICES];
        session.orient3d_plane(plane, &points, &mut out);
        let [a, b, c] = plane;
        for (&d, sign) in points.iter().zip(out) {
            assert_eq!(sign, session.orient3d(a, b, c, d), "{plane:?} {d:?}");
            let unmoved = exact.orient3d(a, b, c, d);
            ties[mesh] += usize::from(unmoved.is_zero() && !sign.is_zero());
        }
    }
    assert!(ties.iter().all(|&count| count > 500), "{ties:?}");
}
