//! The order of directions around a vertex, which consists of turns on the sphere.

use predicament_predicates::{Derived, Predicates, Sign, Vertex};
use predicament_tasks::Class;

use crate::common::{checks, judged_by_name, load};

/// The number of places where the order around a vertex is not cyclic: a, b, c and a, c, d are in counterclockwise
/// order, by two of three turns, and a, b, d are not.
fn not_cyclic(session: &dyn Predicates) -> usize {
    let turn = Derived::named("orient_on_sphere").unwrap();
    let vertices: Vec<Vertex> = session.scene().vertices().take(10).collect();
    let is_left = |o, a, b| session.sign(turn, &[o, a, b]) == Sign::Positive;
    let mut found = 0;
    for &o in &vertices {
        let ordered = |[a, b, c]: [Vertex; 3]| {
            [[a, b], [b, c], [c, a]].into_iter().filter(|&[a, b]| is_left(o, a, b)).count() > 1
        };
        let but = |some: &[Vertex]| -> Vec<Vertex> {
            vertices.iter().copied().filter(|v| *v != o && !some.contains(v)).collect()
        };
        for a in but(&[]) {
            for b in but(&[a]) {
                for c in but(&[a, b]).into_iter().filter(|&c| ordered([a, b, c])) {
                    let later = but(&[a, b, c]).into_iter().filter(|&d| ordered([a, c, d]));
                    found += later.filter(|&d| !ordered([a, b, d])).count();
                }
            }
        }
    }
    found
}

#[test]
fn the_order_around_a_vertex_is_cyclic() {
    let axes = load("axes");
    let of = |backend: &str| {
        let (backend, mut found) = (predicament_bundle::backend(backend).unwrap(), None);
        backend.with_session(&axes.scene, &mut |session| found = Some(not_cyclic(session))).unwrap();
        found.unwrap()
    };
    assert_eq!([of("sos"), of("sos:edelsbrunner-mucke")], [0, 0]);
    // Ties that are broken alone are no order, and `run` finds that.
    assert!(of("fault:sos-alone-on-sphere") > 0);
    let outcome = judged_by_name(&axes, "fault:sos-alone-on-sphere");
    assert!(checks(&outcome).contains(&(Class::Inconsistent, "grassmann-plucker")), "{:?}", checks(&outcome));
}
