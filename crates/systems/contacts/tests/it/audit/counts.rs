//! The counts of an audit, on known sets of contacts.

use predicament_contacts::algorithm::pairs::{Contact, Contacts, Weights, contacts};
use predicament_contacts::checks::audit::{Audit, PairKind, Verdict, audit};
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplex, Simplices};
use predicament_predicates::{Backend, Off, Scene, Vertex};
use predicament_tolerance::Tolerance;

const FIRST: Weights = [1.0, 0.0, 0.0, 0.0];

fn simplex(rank: u8, index: u32) -> Simplex {
    Simplex { rank, index }
}

/// Two complexes of edges over one scene.
fn edges(points: &[[f64; 2]], of: [&[[usize; 2]]; 2]) -> (Scene, [Complex; 2]) {
    let scene = Scene::from_points2(points).unwrap();
    let complexes = of.map(|edges| {
        let edges = edges.iter().map(|edge| edge.map(Vertex::input)).collect();
        Complex::new(&scene, &Simplices { edges, ..Simplices::default() }).unwrap()
    });
    (scene, complexes)
}

/// Three edges from left to right. The first two have an end of the other complex' edges on them, a quarter and half
/// way along; the third one has an end on the other's third edge.
fn combs() -> (Scene, [Complex; 2]) {
    let points = [
        [[0.0, 0.0], [4.0, 0.0], [10.0, 0.0], [14.0, 0.0], [20.0, 0.0], [24.0, 0.0]],
        [[1.0, 0.0], [1.0, 3.0], [12.0, 0.0], [12.0, 3.0], [20.0, -1.0], [20.0, 3.0]],
    ];
    edges(&points.concat(), [&[[0, 1], [2, 3], [4, 5]], &[[6, 7], [8, 9], [10, 11]]])
}

fn exact_audit(bend: impl Fn(&mut Vec<Contact>)) -> Audit {
    let (scene, [a, b]) = combs();
    let session = Exact.prepare(&scene, Off).unwrap();
    let mut found = contacts(&session, &a, &b);
    assert_eq!(found.registered.len(), 3);
    bend(&mut found.registered);
    audit(&session, &a, &b, &found)
}

/// The contact of the edge of the first complex with this index.
fn of_edge(registered: &mut [Contact], index: u32) -> &mut Contact {
    registered.iter_mut().find(|contact| contact.a == simplex(1, index)).unwrap()
}

#[test]
fn pairs_are_counted_by_kind_and_verdict() {
    let right = exact_audit(|_| {});
    assert_eq!(right.count(PairKind::EdgeVertex, Verdict::Agree), 3);
    // The two edges of each contact have ended. Without bands they are not queried.
    assert_eq!((right.judged(), right.ended, right.read), (3, 3, 0));
    assert_eq!(right.weight_errors, [0.0; 6]);
    let less = exact_audit(|registered| registered.truncate(2));
    assert_eq!([Verdict::Agree, Verdict::Missed].map(|verdict| less.count(PairKind::EdgeVertex, verdict)), [2, 1]);
    // The pair of edges has not ended, and does not cross.
    assert_eq!(less.count(PairKind::EdgeEdge, Verdict::Agree), 1);
    assert_eq!((less.judged(), less.ended, less.findings.len()), (4, 2, 1));
}

#[test]
fn the_largest_error_of_a_weight_is_kept_by_kind() {
    let bent = |first: f64, second: f64| {
        exact_audit(|registered| {
            of_edge(registered, 0).on_a[1] += first;
            of_edge(registered, 1).on_a[1] += second;
        })
        .weight_errors
    };
    assert_eq!(bent(0.25, 0.125), [0.0, 0.25, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!(bent(0.125, 0.25), [0.0, 0.25, 0.0, 0.0, 0.0, 0.0]);
    // If the edge is of the second complex, so are its weights.
    let second = exact_audit(|registered| {
        let contact = registered.iter_mut().find(|contact| contact.a.rank == 0).unwrap();
        assert_eq!(contact.on_a, FIRST);
        contact.on_b[0] += 0.125;
    });
    assert_eq!(second.weight_errors[PairKind::EdgeVertex as usize], 0.125);
    assert_eq!(second.findings, []);
}

#[test]
fn a_pair_that_was_never_to_be_asked_about_is_found_with_its_distance() {
    let far = Contact { a: simplex(0, 1), b: simplex(0, 1), on_a: FIRST, on_b: FIRST };
    let found = exact_audit(|registered| registered.push(far));
    // (4, 0) and (1, 3)
    let [only] = &found.findings[..] else { panic!("{:?}", found.findings) };
    assert_eq!((only.a, only.b, only.kind), (far.a, far.b, PairKind::VertexVertex));
    assert_eq!((only.verdict, only.registered, only.distance), (Verdict::Unasked, true, 18.0_f64.sqrt()));
    assert_eq!(found.count(PairKind::VertexVertex, Verdict::Unasked), 1);
}

/// Fans of edges without length in one place, every vertex registered with every other: all other pairs have ended.
#[test]
fn of_many_pairs_that_have_ended_every_third_is_asked_about() {
    let (n, m) = (250, 100);
    let points = vec![[0.0, 0.0]; n + m + 2];
    let [of_a, of_b] = [(0, n), (n + 1, m)].map(|(hub, n)| (1..=n).map(|i| [hub, hub + i]).collect::<Vec<_>>());
    let (scene, [a, b]) = edges(&points, [&of_a, &of_b]);
    let scene = scene.with_primitive_lengths([1.0, 1.0]);
    let pairs = (0..251).flat_map(|i| (0..101).map(move |j| (i, j)));
    let contact = |(i, j)| Contact { a: simplex(0, i), b: simplex(0, j), on_a: FIRST, on_b: FIRST };
    let all = Contacts { registered: pairs.map(contact).collect(), ..Contacts::default() };
    let found = audit(&Tolerance.prepare(&scene, Off).unwrap(), &a, &b, &all);
    assert_eq!(found.findings, []);
    assert_eq!(found.count(PairKind::VertexVertex, Verdict::Agree), 251 * 101);
    assert_eq!(found.judged(), 251 * 101);
    let levels = [250 * 101, 251 * 100, 250 * 100];
    assert_eq!(found.ended, levels.iter().sum::<u64>());
    // 25 000 pairs are three times 8192. They come in pieces of 1024, each with its own first, fourth, seventh …
    let read = levels.map(|pairs| pairs / 1024 * 342 + (pairs % 1024).div_ceil(3));
    assert_eq!(found.read, read.iter().sum::<u64>());
}

#[test]
fn of_few_pairs_that_have_ended_each_is_asked_about() {
    let (scene, [a, b]) = combs();
    let lengths = [&a, &b].map(|complex| complex.primitive_length(&scene));
    let scene = scene.with_primitive_lengths(lengths);
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let found = audit(&session, &a, &b, &contacts(&session, &a, &b));
    assert_eq!((found.ended, found.read, found.findings.len()), (3, 3, 0));
}
