//! The check that a session's answer about a pair does not depend on the order of its vertices.

use predicament_laws::axioms::each_order;
use predicament_predicates::{Predicates, Vertex};

use predicament_tasks::ids;

/// Queries a pair with its vertices in all orders and, if both simplices have the same rank, with the two exchanged.
/// Returns, in words, the first order with a different answer.
pub(crate) fn contradiction<S: Predicates + ?Sized>(session: &S, s: &[Vertex], t: &[Vertex]) -> Option<String> {
    let expected = registers(session, s, t);
    let mut found = None;
    let mut ask = |first: &[Vertex], second: &[Vertex]| {
        if found.is_none() && registers(session, first, second) != expected {
            found = Some([first.to_vec(), second.to_vec()]);
        }
    };
    each_order(s, &mut |s, _| {
        each_order(t, &mut |t, _| {
            ask(s, t);
            if s.len() == t.len() {
                ask(t, s);
            }
        });
    });
    found.map(|[other_s, other_t]| {
        let say = |registered| if registered { "registered" } else { "not registered" };
        let [one, other] = [format!("({}, {})", ids(s), ids(t)), format!("({}, {})", ids(&other_s), ids(&other_t))];
        format!("{} as {one}, {} as {other}", say(expected), say(!expected))
    })
}

/// True if the session registers the pair by the query for its ranks.
fn registers<S: Predicates + ?Sized>(session: &S, s: &[Vertex], t: &[Vertex]) -> bool {
    match (s, t) {
        (&[p], &[q]) => session.vertex_vertex(p, q),
        (&[a, b], &[p]) => session.edge_vertex([a, b], p).is_some(),
        (&[a, b], &[c, d]) => session.edge_edge([a, b], [c, d]).is_some(),
        (&[a, b, c], &[p]) => session.triangle_vertex([a, b, c], p).is_some(),
        (&[a, b, c], &[p, q]) => session.triangle_edge([a, b, c], [p, q]).is_some(),
        (&[a, b, c, d], &[p]) => session.tetrahedron_vertex([a, b, c, d], p).is_some(),
        (s, t) => registers(session, t, s),
    }
}
