//! The audit of whole sets of contacts.

use predicament_contacts::algorithm::pairs::{Contact, contacts};
use predicament_contacts::checks::audit::{Audit, PairKind, Published, Symbol, Verdict, audit};
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplex, Simplices};
use predicament_predicates::{Backend, Dimension, Off, Predicates, Scene, Vertex};
use predicament_tolerance::{Misscaled, Tolerance};

fn v<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
    indices.map(Vertex::input)
}

/// A scene with two complexes, and their lengths set in the scene.
fn prepared(scene: Scene, a: &Simplices, b: &Simplices) -> (Scene, [Complex; 2]) {
    let complexes = [a, b].map(|given| Complex::new(&scene, given).unwrap());
    let lengths = [0, 1].map(|i| complexes[i].primitive_length(&scene));
    (scene.with_primitive_lengths(lengths), complexes)
}

/// Strips of triangles on a coarse grid of integers, with small displacements of some points.
fn plane() -> (Scene, [Complex; 2]) {
    let place = |i: i32| [f64::from(i * 7 % 5), f64::from(i * 5 % 7) + if i % 3 == 0 { 1e-8 } else { 0.0 }];
    let points: Vec<[f64; 2]> = (0..40).map(place).collect();
    let strip = |from: usize| Simplices {
        triangles: (from..from + 17).map(|i| v([i, i + 1, i + 2])).collect(),
        ..Simplices::default()
    };
    prepared(Scene::from_points2(&points).unwrap(), &strip(0), &strip(20))
}

/// Strips of tetrahedra on such a grid.
fn space() -> (Scene, [Complex; 2]) {
    let place = |i: i32| {
        let off = if i % 3 == 0 { 1e-4 } else { 0.0 };
        [f64::from(i * 7 % 5), f64::from(i * 3 % 7) + off, f64::from(i * i % 4)]
    };
    let points: Vec<[f64; 3]> = (0..40).map(place).collect();
    let cells = |from: usize| Simplices {
        tetrahedra: (from..from + 16).map(|i| v([i, i + 1, i + 2, i + 3])).collect(),
        ..Simplices::default()
    };
    prepared(Scene::from_points3(&points).unwrap(), &cells(0), &cells(20))
}

fn registered_kinds(audit: &Audit) -> Vec<PairKind> {
    PairKind::ALL.into_iter().filter(|&kind| audit.count(kind, Verdict::Agree) > 0).collect()
}

#[test]
fn contacts_by_tolerances_and_by_exact_signs_pass() {
    for (scene, [a, b]) in [plane(), space()] {
        let session = Exact.prepare(&scene, Off).unwrap();
        let found = contacts(&session, &a, &b);
        let exact = audit(&session, &a, &b, &found);
        assert_eq!(exact.findings, [], "exact");
        let session = Tolerance.prepare(&scene, Off).unwrap();
        let found = contacts(&session, &a, &b);
        let tolerant = audit(&session, &a, &b, &found);
        assert_eq!(tolerant.findings, [], "tolerance");
        assert!(found.registered.len() > 20 && tolerant.judged() > 200, "{tolerant:?}");
        assert!(tolerant.ended > 0 && registered_kinds(&tolerant).len() >= 4, "{tolerant:?}");
    }
}

#[test]
fn what_is_left_out_or_added_is_found() {
    for (scene, [a, b]) in [plane(), space()] {
        let session = Tolerance.prepare(&scene, Off).unwrap();
        let found = contacts(&session, &a, &b);
        // If a pair of full dimension is missing, only that pair is affected.
        let last = *found.registered.last().unwrap();
        let mut without = found.clone();
        without.registered.pop();
        let findings = audit(&session, &a, &b, &without).findings;
        assert_eq!(
            findings.iter().map(|f| (f.a, f.b, f.verdict)).collect::<Vec<_>>(),
            [(last.a, last.b, Verdict::Missed)]
        );
        assert!(!findings[0].registered && findings[0].distance == 0.0);

        // A pair of vertices that are far apart, and must not be queried.
        let far = Contact { a: Simplex { rank: 0, index: 0 }, b: Simplex { rank: 0, index: 4 }, ..last };
        assert!(!session.vertex_vertex(a.vertices()[0], b.vertices()[4]));
        let mut with = found.clone();
        with.registered.push(far);
        let findings = audit(&session, &a, &b, &with).findings;
        assert!(findings.iter().any(|f| f.registered && f.kind == PairKind::VertexVertex && f.distance > 0.1));

        // A pair that had ended.
        let first = found.registered[0];
        let above = a.edges().iter().position(|edge| edge.contains(&a.vertices()[first.a.index as usize])).unwrap();
        let ended = Contact { a: Simplex { rank: 1, index: u32::try_from(above).unwrap() }, ..first };
        let mut with = found.clone();
        with.registered.push(ended);
        let findings = audit(&session, &a, &b, &with).findings;
        assert!(findings.iter().any(|f| f.verdict == Verdict::Unasked && f.a == ended.a && f.b == ended.b));

        // A weight outside the simplex.
        let mut bent = found.clone();
        bent.registered.last_mut().unwrap().on_a[0] = -0.25;
        let verdicts: Vec<_> = audit(&session, &a, &b, &bent).findings.iter().map(|f| f.verdict).collect();
        assert_eq!(verdicts, [Verdict::BadWeight]);
    }
}

#[test]
fn the_printed_form_is_found() {
    for (scene, [a, b]) in [plane(), space()] {
        let backend = Tolerance::<f64>::as_printed();
        let session = backend.prepare(&scene, Off).unwrap();
        let found = contacts(&session, &a, &b);
        let audit = audit(&session, &a, &b, &found);
        assert!(audit.count(PairKind::EdgeVertex, Verdict::Missed) > 0, "{audit:?}");
    }
}

/// Two edges of the plane; the second one begins at this position along the first and this distance off it.
fn beside([along, off]: [f64; 2]) -> (Scene, [Complex; 2]) {
    let points = [[0.0, 0.0], [1.0, 0.0], [along, off], [along, 1.0]];
    let edge = |from: usize| Simplices { edges: vec![v([from, from + 1])], ..Simplices::default() };
    prepared(Scene::from_points2(&points).unwrap(), &edge(0), &edge(2))
}

/// Ended pairs are queried all the same, so that a tolerance that differs from the published one is noticed there.
#[test]
fn a_tolerance_of_another_size_is_misread_where_a_pair_has_ended() {
    let (scene, _) = beside([0.0, 0.0]);
    let published = Published::of(&Tolerance::<f64>::new().prepare(&scene, Off).unwrap()).unwrap();
    let ([sigma, ..], [_, tau, beyond]) = (published.rounded(Symbol::Sigma), published.rounded(Symbol::Tau));
    let off = (beyond + sigma) / 2.0;
    assert!(beyond < off && off < sigma && off < 2.0 * tau, "σ₋ {sigma}, τ {tau}, τ₊ {beyond}");
    // The two beginnings are one point, so the hierarchy does not query whether one of them is on the other edge. It is
    // beyond τ₊ of that edge, and within 2τ.
    let (scene, [a, b]) = beside([0.8 * (sigma * sigma - off * off).sqrt(), off]);
    let misread = |backend: &Tolerance<f64>| {
        let session = backend.prepare(&scene, Off).unwrap();
        let found = contacts(&session, &a, &b);
        assert_eq!(found.registered.len(), 1);
        let audit = audit(&session, &a, &b, &found);
        assert!(audit.ended > 0 && audit.read > 0, "{audit:?}");
        let told = audit.findings.iter().map(|finding| (finding.kind, finding.verdict)).collect::<Vec<_>>();
        (told, audit.count(PairKind::EdgeVertex, Verdict::Misread))
    };
    assert_eq!(misread(&Tolerance::new()), (vec![], 0));
    let doubled = |of: &&Misscaled| of.dimension == Dimension::Two && of.symbol == "τ" && !of.halved;
    let doubled = Misscaled::ALL.iter().find(doubled).unwrap();
    let (told, counted) = misread(&Tolerance::misscaled(*doubled));
    assert!(counted > 0 && told.len() as u64 == counted, "{told:?}");
    assert!(told.iter().all(|found| *found == (PairKind::EdgeVertex, Verdict::Misread)), "{told:?}");
}
