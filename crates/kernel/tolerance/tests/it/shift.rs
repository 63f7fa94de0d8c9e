//! Scenes that an exact shift makes numbers of single precision: the answers are those of the scene at the origin.

use predicament_predicates::{
    Axis, Backend, Counts, Derived, Dimension, Off, Plane, PredicateKind, Predicates, QuerySet, Question, Scene, Sign,
    Vertex,
};
use predicament_tolerance::Tolerance;

const SINGLE: Tolerance<f32> = Tolerance::<f32>::new();

/// Integer points up to `side`, as millimetres of a survey; and the same far from the origin.
fn survey(dimension: usize, points: usize, side: u64) -> [Scene; 2] {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        f64::from(u32::try_from((state >> 20) % side).unwrap())
    };
    let near: Vec<f64> = (0..points * dimension).map(|_| next()).collect();
    let offset = |at: usize| [448_123_456.0, 5_411_987_654.0, -99_000_001.0][at % dimension];
    let far = near.iter().enumerate().map(|(at, x)| x + offset(at)).collect();
    [near, far].map(|coordinates| {
        let scene = Scene::new(Dimension::of(dimension).unwrap(), coordinates).unwrap();
        scene.with_primitive_lengths([side, side].map(|side| f64::from(u32::try_from(side).unwrap()) * 0.75))
    })
}

fn questions(kind: PredicateKind, dimension: usize) -> Vec<Question> {
    let planes = [Plane::Xy, Plane::Yz, Plane::Zx];
    match (kind, dimension) {
        (PredicateKind::Compare, _) => {
            [Axis::X, Axis::Y, Axis::Z][..dimension].iter().map(|&axis| Question::Compare(axis)).collect()
        }
        (PredicateKind::Orient2d, 2) => vec![Question::Orient2d(Plane::Xy)],
        (PredicateKind::Orient2d, _) => planes.map(Question::Orient2d).to_vec(),
        (kind, _) => vec![kind.first_question()],
    }
}

#[test]
fn answers_bands_and_contacts_are_those_at_the_origin() {
    let mut seen = [0; 3];
    for (dimension, side) in [(2, 5), (2, 1_000_000), (3, 4), (3, 5000)] {
        let [near, far] = survey(dimension, 9, side);
        let counts = Counts::new();
        let (near, far) = (SINGLE.prepare(&near, Off).unwrap(), SINGLE.prepare(&far, &counts).unwrap());
        let v = Vertex::input;
        for kind in PredicateKind::ALL {
            assert_eq!(near.supports(kind), far.supports(kind));
            if near.supports(kind).is_err() {
                continue;
            }
            for question in questions(kind, dimension) {
                assert_eq!(near.band(question), far.band(question));
                for turn in 0..9 {
                    let args: Vec<Vertex> = (0..kind.arity()).map(|at| v((turn + at * (1 + turn % 2)) % 9)).collect();
                    let signs = [question.ask(&near, &args), question.ask(&far, &args)];
                    assert_eq!(signs[0], signs[1], "{question:?} of {args:?}");
                    assert_eq!(near.estimate(question, &args), far.estimate(question, &args));
                    let mut batch = [Sign::Zero; 9];
                    QuerySet::new(question, args.repeat(9)).ask_batch(&far, 0..9, &mut batch);
                    assert_eq!(batch, [signs[0]; 9], "{question:?} of {args:?} in a batch");
                    seen[usize::try_from(signs[0].as_i8() + 1).unwrap()] += 1;
                }
            }
            assert!(counts.get(kind, 1) > 0 && counts.get(kind, 0) == 0, "{kind}: every query is counted as shifted");
        }
        assert_eq!((near.supports_contacts(), far.supports_contacts()), (Ok(()), Ok(())));
        for at in 0..9 {
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| v((at + i) % 9));
            assert_eq!(near.vertex_vertex(a, b), far.vertex_vertex(a, b));
            assert_eq!(near.edge_vertex([a, b], c), far.edge_vertex([a, b], c));
            assert_eq!(near.edge_edge([a, b], [c, d]), far.edge_edge([a, b], [c, d]));
            assert_eq!(near.triangle_vertex([a, b, c], d), far.triangle_vertex([a, b, c], d));
            if dimension == 3 {
                let edge = [d, v((at + 4) % 9)];
                assert_eq!(near.triangle_edge([a, b, c], edge), far.triangle_edge([a, b, c], edge));
                assert_eq!(
                    near.tetrahedron_vertex([a, b, c, d], edge[1]),
                    far.tetrahedron_vertex([a, b, c, d], edge[1])
                );
            }
        }
    }
    assert!(seen.iter().all(|&count| count > 20), "{seen:?}");
}

#[test]
fn what_a_shift_does_not_help_is_declined() {
    // 0.1 + far - far is not a number of f32, and an extent of 2^25 units has 26 bits from the middle.
    let far = 2f64.powi(40);
    for points in [[[0.1, 0.0], [0.7, 1.0]], [[far, 0.0], [far + 2f64.powi(25) + 1.0, 1.0]]] {
        let declined = SINGLE.prepare(&Scene::from_points2(&points).unwrap(), Off).err().unwrap().reason;
        assert!(declined.contains("not even after a shift"), "{declined}");
    }
    assert_eq!((SINGLE.stages(), Tolerance.stages()), (&["float", "shifted float"][..], &["float"][..]));
}

/// A formula about differences follows the shift; one with weights, or about places, does not.
#[test]
fn formulas_are_answered_if_they_follow_the_shift() {
    let [near, far] = survey(2, 9, 1_000_000);
    let weights: Vec<f64> = (0..9).map(f64::from).collect();
    let [near, far] = [near, far].map(|scene| scene.with_weights(weights.clone()).unwrap());
    let (near, far) = (SINGLE.prepare(&near, Off).unwrap(), SINGLE.prepare(&far, Off).unwrap());
    let (mut answered, mut declined) = (0, 0);
    for &derived in Derived::shipped() {
        let kind = PredicateKind::Derived(derived);
        let args: Vec<Vertex> = (0..derived.arity()).map(Vertex::input).collect();
        match (near.supports(kind), far.supports(kind)) {
            (Ok(()), Ok(())) => {
                assert_eq!(near.sign(derived, &args), far.sign(derived, &args), "{}", derived.name());
                let question = Question::Derived(derived);
                assert_eq!(near.estimate(question, &args), far.estimate(question, &args), "{}", derived.name());
                answered += 1;
            }
            (Ok(()), Err(why)) => {
                assert!(why.reason.contains("the scene is shifted"), "{why}");
                assert_eq!(far.estimate(Question::Derived(derived), &args), None);
                declined += 1;
            }
            (Err(_), other) => assert!(other.is_err(), "{}", derived.name()),
        }
    }
    assert!(answered > 2 && declined > 0, "{answered} answered, {declined} declined");
}
