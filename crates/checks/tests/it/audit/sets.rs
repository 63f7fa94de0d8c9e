//! The audit of whole sets of contacts.

use predicament_algorithms::contacts::{Contact, contacts};
use predicament_checks::audit::{Audit, PairKind, Verdict, audit};
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplex, Simplices};
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_tolerance::{Misscaled, Tolerance};

fn v<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
    indices.map(Vertex::input)
}

/// Two complexes, with their lengths in the scene.
fn prepared(scene: Scene, a: &Simplices, b: &Simplices) -> (Scene, [Complex; 2]) {
    let complexes = [a, b].map(|given| Complex::new(&scene, given).unwrap());
    let lengths = [0, 1].map(|i| complexes[i].primitive_length(&scene));
    (scene.with_primitive_lengths(lengths), complexes)
}

/// Strips of triangles on a coarse grid of integers, a little off it here and there.
fn plane() -> (Scene, [Complex; 2]) {
    let place = |i: i32| [f64::from(i * 7 % 5), f64::from(i * 5 % 7) + if i % 3 == 0 { 1e-8 } else { 0.0 }];
    let points: Vec<[f64; 2]> = (0..40).map(place).collect();
    let strip = |from: usize| Simplices {
        triangles: (from..from + 17).map(|i| v([i, i + 1, i + 2])).collect(),
        ..Simplices::default()
    };
    prepared(Scene::from_points2(&points).unwrap(), &strip(0), &strip(20))
}

/// The same with tetrahedra.
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
        // Leaving out a pair of full dimension concerns that pair alone.
        let last = *found.registered.last().unwrap();
        let mut without = found.clone();
        without.registered.pop();
        let findings = audit(&session, &a, &b, &without).findings;
        assert_eq!(
            findings.iter().map(|f| (f.a, f.b, f.verdict)).collect::<Vec<_>>(),
            [(last.a, last.b, Verdict::Missed)]
        );
        assert!(!findings[0].registered && findings[0].distance == 0.0);

        // A pair of vertices that is far apart, and far from being asked.
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

/// What the hierarchy has ended is asked about all the same, so that a tolerance that is none of the published ones is seen there.
#[test]
fn tolerances_of_another_size_are_misread_where_pairs_have_ended() {
    let mut misread = 0;
    for misscaled in Misscaled::visible() {
        for (scene, [a, b]) in [plane(), space()] {
            let backend = Tolerance::<f64>::misscaled(misscaled);
            let session = backend.prepare(&scene, Off).unwrap();
            let found = contacts(&session, &a, &b);
            let audit = audit(&session, &a, &b, &found);
            let counted: u64 = PairKind::ALL.into_iter().map(|kind| audit.count(kind, Verdict::Misread)).sum();
            let told = audit.findings.iter().filter(|finding| finding.verdict == Verdict::Misread).count();
            assert_eq!(counted, told as u64, "{misscaled:?}");
            misread += told;
        }
    }
    assert!(misread > 0);
}
