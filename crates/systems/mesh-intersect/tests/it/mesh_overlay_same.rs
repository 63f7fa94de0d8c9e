//! Tests of overlays of meshes with a large common part: the result is the same if the common part is set aside and if
//! it is tested.

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use predicament_effort::some_or_all;
use predicament_exact::Exact;
use predicament_mesh_intersect::algorithm::overlay::{MeshOverlay, Solid, Zeros, mesh_overlay};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Backend, Construction, Off, Predicates, Refused, Scene, Sign, Vertex, forward_to};
use predicament_sos::PerMesh;

use crate::common::overlaid::Pair;
use crate::common::shapes::{Random, Shape};

/// A session that reports, or does not report, that it moves a mesh, and counts its queries. It can forbid to set
/// triangles aside.
struct Counted<P> {
    session: P,
    moves: bool,
    allows: bool,
    asked: AtomicUsize,
}

impl<P: Predicates> Predicates for Counted<P> {
    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.asked.fetch_add(1, Relaxed);
        self.session.orient3d(a, b, c, d)
    }

    fn moves_second_mesh(&self) -> bool {
        self.moves
    }

    fn allows(&self, shortcut: &str) -> bool {
        self.allows || shortcut != "set-aside"
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.session.construct(definitions)
    }

    forward_to!(session: scene, compare, orient2d, incircle, insphere);
}

/// An overlay, and its number of signs in space.
fn overlaid(pair: &Pair, moves: bool, allows: bool) -> (MeshOverlay, usize) {
    let session = PerMesh.prepare(&pair.scene, Off).unwrap();
    let mut session = Counted { session, moves, allows, asked: AtomicUsize::new(0) };
    let overlay = mesh_overlay(&mut session, pair.meshes(), Zeros::Zero).unwrap();
    (overlay, session.asked.into_inner())
}

/// All public data of an overlay.
fn seen(overlay: &MeshOverlay) -> (Vec<Construction>, Vec<[Vertex; 3]>, Vec<Solid>) {
    let pieces = [0, 1].map(|mesh| overlay.pieces(mesh).iter().map(|piece| piece.triangle).collect::<Vec<_>>());
    let solids = Operation::ALL.map(|operation| overlay.solid(operation)).to_vec();
    (overlay.constructions().to_vec(), pieces.concat(), solids)
}

/// Asserts that both ways give the same result; returns the ratio of their numbers of signs.
fn check(first: &Shape, second: &Shape) -> usize {
    let pair = Pair::without_truth(first.clone(), second.clone());
    let (aside, few) = overlaid(&pair, true, true);
    let (asked, many) = overlaid(&pair, false, true);
    assert!(seen(&aside) == seen(&asked));
    // Where no mesh moves, one more sign decides whether the meshes touch.
    let forbidden = overlaid(&pair, true, false).1;
    assert!(forbidden.abs_diff(many) <= 1, "nothing is set aside where the session forbids it: {forbidden}, {many}");
    many / few.max(1)
}

fn sphere() -> Shape {
    Shape::sphere(10_000.0, 5)
}

fn torus() -> Shape {
    Shape::torus([12_000.0, 5_000.0], [160, 64]).sheared([[1., 0.125, 0.], [0., 1., 0.25], [0.5, 0., 1.]])
}

/// The same surface with shuffled vertices and triangles, and with triangles from another corner on.
fn shuffled(shape: &Shape, random: &mut Random) -> Shape {
    let mut order: Vec<usize> = (0..shape.points.len()).collect();
    for at in (1..order.len()).rev() {
        let bound = u64::try_from(at + 1).unwrap();
        order.swap(at, usize::try_from(random.below(bound)).unwrap());
    }
    let mut place = vec![0; order.len()];
    order.iter().enumerate().for_each(|(to, &from)| place[from] = to);
    let mut other = shape.clone();
    other.points = order.iter().map(|&from| shape.points[from]).collect();
    for triangle in &mut other.triangles {
        *triangle = triangle.map(|v| place[v]);
        triangle.rotate_left(1);
    }
    other.triangles.reverse();
    other
}

/// Two round bodies; the second has a vertex inside a triangle of the first.
fn touched() -> Shape {
    let body = sphere().mapped(|p| p.map(|x| 4.0 * x));
    let of = |at: usize| body.triangles[at].map(|v| body.points[v]);
    let height = |at: usize| of(at).iter().map(|p| p[0]).sum::<f64>();
    let top = (0..body.triangles.len()).max_by(|&a, &b| height(a).total_cmp(&height(b))).unwrap();
    let [a, b, c] = of(top);
    let place = [0, 1, 2].map(|i: usize| a[i] / 2.0 + b[i] / 4.0 + c[i] / 4.0);
    // Long along x, so that it is steeper around its lowest vertex.
    let other = sphere().mapped(|[x, y, z]| [4.0 * x, y, z]);
    let lowest = other.points.iter().min_by(|p, q| p[0].total_cmp(&q[0])).unwrap();
    let by = [0, 1, 2].map(|i: usize| place[i] - lowest[i]);
    body.and(&other.moved(by))
}

/// Both shapes, each with flags to overlay it in the given order and exchanged; by default each in one order.
fn shapes() -> [(Shape, [bool; 2]); 2] {
    [(sphere(), some_or_all([true, false], [true; 2])), (torus(), some_or_all([false, true], [true; 2]))]
}

#[test]
fn a_mesh_with_itself() {
    for (shape, is_turn) in shapes() {
        assert!(!is_turn[0] || check(&shape, &shape) > 4, "most of it is set aside");
        let other = shuffled(&shape, &mut Random(1));
        assert!(!is_turn[0] || check(&shape, &other) > 4);
        assert!(!is_turn[1] || check(&other, &shape) > 4);
    }
}

#[test]
fn a_mesh_with_itself_but_for_a_part() {
    for ((shape, is_turn), by) in shapes().into_iter().zip([[3.0, -2.0, 1.0], [-40.0, 30.0, 50.0]]) {
        let mut other = shape.clone();
        for p in other.points.iter_mut().filter(|p| p[0] + p[1] > 9_000.0) {
            *p = [0, 1, 2].map(|i: usize| p[i] + by[i]);
        }
        assert!(!is_turn[0] || check(&shape, &other) > 2, "half of it is set aside");
        assert!(!is_turn[1] || check(&other, &shape) > 2);
    }
}

#[test]
fn a_mesh_that_touches_itself() {
    let shape = touched();
    assert!(check(&shape, &shape) > 4, "most of it is set aside");
}

/// Tests extreme scales: if products of coordinates underflow or overflow, lines separate nothing; boxes and diagonals
/// still do.
#[test]
fn a_mesh_at_any_scale() {
    for exponent in [-1000, -540, -300, 300, 600, 1000].into_iter().step_by(some_or_all(2, 1)) {
        let shape = sphere().mapped(|p| p.map(|x| x * 2_f64.powi(exponent)));
        assert!(check(&shape, &shape) > 2, "2^{exponent}");
    }
}

/// Tests a mesh whose vertices are all on spikes: hardly any neighbourhood is a graph over the yz plane.
#[test]
fn a_mesh_of_folds() {
    let mut random = Random(3);
    let mut shape = Shape::sphere(10_000.0, some_or_all(4, 5));
    for p in &mut shape.points {
        let by = 0.25 + random.whole(64).abs() / 32.0;
        *p = p.map(|x| (by * x).round());
    }
    check(&shape, &shape);
}

/// Tests that ties are decided by the session if nothing moves, or if each vertex moves separately.
#[test]
fn other_sessions_do_not_say_that_a_mesh_moves() {
    let pair = Pair::without_truth(sphere(), sphere());
    let scene: &Scene = &pair.scene;
    assert!(PerMesh.prepare(scene, Off).unwrap().moves_second_mesh());
    assert!(!Exact.prepare(scene, Off).unwrap().moves_second_mesh());
    assert!(!predicament_sos::Sos::default().prepare(scene, Off).unwrap().moves_second_mesh());
    let boxed: Box<dyn Predicates> = Box::new(PerMesh.prepare(scene, Off).unwrap());
    assert!(boxed.moves_second_mesh(), "behind a pointer too");
}
