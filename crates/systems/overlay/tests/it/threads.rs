//! Tests that results are the same on any number of threads.

use predicament_exact::Exact;
use predicament_overlay::algorithm::overlay::{Edge, Method, Operation, Overlay, Polygon, Regions, Rule};
use predicament_overlay::algorithm::overlay::{arrange, operate, overlay};
use predicament_overlay::algorithm::snap::{self, Drawing, Snapped, snap};
use predicament_predicates::{Backend, Construction, Off, Predicates, Scene, Vertex};

use crate::overlay::Numbers;

/// The results of a call on one, two and three threads, which have to be equal.
fn same<R: PartialEq + Send>(call: impl Fn() -> R + Sync) -> R {
    let on = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(&call);
    let first = on(1);
    for threads in [2, 3] {
        assert!(on(threads) == first, "{threads} threads");
    }
    first
}

/// Octagons in a lattice, so many that threads share them, and in one corner a loop that passes through one point many
/// times.
fn octagons(numbers: &mut Numbers, side: u32, from: u32) -> Vec<Vec<[f64; 2]>> {
    const AROUND: [[i32; 2]; 8] = [[9, 0], [7, 6], [0, 9], [-6, 7], [-9, 0], [-7, -6], [0, -9], [6, -7]];
    let mut loops = Vec::new();
    for at in 0..side * side {
        let centre = [at % side, at / side].map(|at| f64::from(12 * at + from + numbers.below(3)));
        let grow = f64::from(1 + numbers.below(3)) / 2.0;
        loops.push(AROUND.map(|by| [0, 1].map(|axis: usize| centre[axis] + grow * f64::from(by[axis]))).to_vec());
    }
    let through = (0..48).flat_map(|at| {
        let [x, y] = [f64::from(at) - 24.0, if at % 2 == 0 { 25.0 } else { -25.0 }].map(|by| 3.0 * by);
        let [x, centre] = [if at % 2 == 0 { x } else { -x }, f64::from(60 + from)];
        [[centre - x, centre - y], [centre + x, centre + y]]
    });
    loops.push(through.collect());
    loops
}

#[test]
fn overlays_do_not_depend_on_the_number_of_threads() {
    let mut numbers = Numbers(5);
    let loops = [0, 5].map(|from| octagons(&mut numbers, 33, from));
    let points: Vec<[f64; 2]> = loops.iter().flatten().flatten().copied().collect();
    let scene = Scene::from_points2(&points).unwrap();
    let mut vertices = scene.vertices();
    let operands = loops.each_ref().map(|loops| {
        let loops: Vec<Vec<Vertex>> = loops.iter().map(|one| vertices.by_ref().take(one.len()).collect()).collect();
        Polygon::of_vertices(&loops, Rule::NonZero)
    });
    let [a, b] = &operands;
    let (found, _, regions): (Overlay, Scene, Vec<Regions>) = same(|| {
        let [mut session, mut other] = [Exact.prepare(&scene, Off).unwrap(), Exact.prepare(&scene, Off).unwrap()];
        let found = overlay(&mut session, [a, b], Method::Grid).unwrap();
        let regions = Operation::ALL.map(|operation| found.regions(operation));
        let short = operate(&mut other, [a, b], Operation::Union, Method::Grid).unwrap();
        (found, session.scene().clone(), regions.into_iter().chain([short]).collect())
    });
    assert!(found.arrangement.broken.is_none() && regions.iter().all(|made| made.broken.is_none()));
    let loops = |made: &Regions| made.regions.iter().map(|region| region.loops().count()).sum::<usize>();
    assert!(found.arrangement.pieces.len() > 20_000 && regions.iter().all(|made| loops(made) > 100));
}

#[test]
fn snap_rounding_does_not_depend_on_the_number_of_threads() {
    let mut numbers = Numbers(8);
    let count = 8500;
    let mut points: Vec<[f64; 2]> = Vec::new();
    for _ in 0..count {
        let from = [0, 1].map(|_: usize| f64::from(numbers.below(1 << 16)));
        points.extend([from, from.map(|x| x + f64::from(numbers.below(1 << 11)) - 1024.0)]);
    }
    let scene = Scene::from_points2(&points).unwrap();
    let edges: Vec<Edge> =
        (0..count).map(|at| [2 * at, 2 * at + 1].map(Vertex::input)).map(|[a, b]| Edge::whole(a, b)).collect();
    let snapped = |method: snap::Method| -> Vec<Snapped> {
        same(|| {
            let mut session = Exact.prepare(&scene, Off).unwrap();
            arrange(&mut session, &edges, Method::Grid).unwrap();
            let segment = |[a, _]: [Vertex; 2]| u32::try_from(a.index() / 2).unwrap();
            let crossing = |construction: &Construction| match *construction {
                Construction::Ssi(lines) => lines.map(segment),
                _ => unreachable!("segments cross in the plane"),
            };
            let crossings: Vec<[u32; 2]> = session.scene().constructions().iter().map(crossing).collect();
            assert!(crossings.len() > 1000);
            let segments: Vec<[u32; 2]> = (0..).step_by(2).take(count).map(|at| [at, at + 1]).collect();
            let drawing = Drawing { points: &points, segments: &segments, crossings: &crossings, touching: &[] };
            vec![snap(drawing, 4, method).unwrap()]
        })
    };
    let rounded = snapped(snap::Method::Snap);
    assert!(rounded[0].chains.iter().map(Vec::len).sum::<usize>() > 20_000);
    snapped(snap::Method::Iterated);
}
