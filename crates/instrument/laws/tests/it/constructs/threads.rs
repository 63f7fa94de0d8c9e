//! Ids and answers do not depend on the number of threads.

use predicament_exact::Exact;
use predicament_predicates::{Axis, Backend, Construction, Off, Plane, Predicates, Scene, Sign, Vertex};
use rayon::prelude::*;

use super::cases::Random;

/// True if two segments cross, by the signs of their ends.
fn cross(session: &impl Predicates, [[a, b], [c, d]]: [[Vertex; 2]; 2]) -> bool {
    let side = |p, q, r| session.orient2d(Plane::Xy, p, q, r);
    let apart = |x: Sign, y: Sign| !x.is_zero() && x == -y;
    apart(side(a, b, c), side(a, b, d)) && apart(side(c, d, a), side(c, d, b))
}

/// Runs one phase: finds all crossings among these segments in parallel, and constructs them in one call.
fn phase(session: &mut impl Predicates, segments: &[[Vertex; 2]]) -> Vec<Vertex> {
    let asked = &*session;
    let found: Vec<Construction> = (0..segments.len())
        .into_par_iter()
        .flat_map_iter(|i| (0..i).map(move |j| [segments[i], segments[j]]))
        .filter(|&pair| cross(asked, pair))
        .map(Construction::Ssi)
        .collect();
    session.construct(&found).expect("lines that cross meet")
}

/// Constructs two levels of crossings and sorts all vertices along x.
fn cascade(scene: &Scene, threads: usize) -> (Vec<Construction>, Vec<Vertex>, Vec<Sign>) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(|| {
        let mut session = Exact.prepare(scene, Off).expect("prepared");
        let inputs: Vec<Vertex> = scene.vertices().collect();
        let mut vertices = phase(&mut session, inputs.as_chunks().0);
        let first = vertices.clone();
        vertices.extend(phase(&mut session, first.as_chunks().0));
        let order = vertices.par_windows(2).map(|pair| session.compare(Axis::X, pair[0], pair[1])).collect();
        (session.scene().constructions().to_vec(), vertices, order)
    })
}

#[test]
fn ids_are_those_of_one_thread() {
    let mut random = Random(0x94d0_49bb_1331_11eb);
    #[allow(clippy::cast_precision_loss)] // below 2^10
    let coordinates = (0..160).map(|_| random.below(1 << 10) as f64).collect();
    let scene = Scene::new(predicament_predicates::Dimension::Two, coordinates).expect("finite");
    let alone = cascade(&scene, 1);
    let deep = alone.0.iter().filter(|construction| !construction.is_of_inputs()).count();
    assert!(alone.0.len() > deep + 50 && deep > 50, "{deep} of {}", alone.0.len());
    for threads in [2, 7] {
        assert_eq!(cascade(&scene, threads), alone);
    }
}
