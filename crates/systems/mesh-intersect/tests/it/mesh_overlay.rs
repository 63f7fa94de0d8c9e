//! Tests of overlays of two meshes against volumes that are found without an overlay, and against the laws of an
//! overlay.

use predicament_exact::Exact;
use predicament_mesh_intersect::algorithm::overlay::{Contacts, Zeros, mesh_overlay};
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Backend, Off};
use predicament_sos::{PerMesh, Sos};
use rug::Rational;

use crate::common::overlaid::{Pair, Seen};
use crate::common::shapes::{Random, Shape};
use crate::common::volumes::{common, volume};

/// A rotation of integer coordinates that keeps no plane, with a scaling by five.
const TURN: [[f64; 3]; 3] = [[4., -2., 1.], [1., 4., -2.], [-2., 1., 4.]];
/// A small shear.
const LEAN: [[f64; 3]; 3] = [[1., 0., 0.], [0.125, 1., 0.], [0.0625, -0.1875, 1.]];

/// The statistics of all backends together: exact, sos, sos:per-mesh; and the number of pairs that touch.
#[derive(Default, Debug)]
struct All([Seen; 3], usize);

impl All {
    /// Checks by all backends.
    fn check(&mut self, first: &Shape, second: &Shape) {
        let pair = Pair::new(first.clone(), second.clone());
        let scene = &pair.scene;
        let (is_degenerate, size) = (pair.is_degenerate(), first.triangles.len() + second.triangles.len());
        self.1 += usize::from(is_degenerate);
        let exact = pair.check(&mut Exact.prepare(scene, Off).unwrap(), Zeros::Zero);
        assert_eq!((exact.done, exact.flat), (1, 0), "{:?}", pair.shapes);
        // Ties of constructed vertices take `sos` milliseconds each, because all vertices move.
        let by_sos = !is_degenerate || size <= 24 || predicament_effort::whole();
        let sos = Sos::default();
        let sos = if by_sos { pair.check(&mut sos.prepare(scene, Off).unwrap(), Zeros::Zero) } else { Seen::default() };
        // Vertices of the first mesh have lower numbers and move further: relative to a plane of either mesh, all move
        // to one side. So no edge that is parallel to a plane passes through a triangle of it, and nothing is declined.
        assert_eq!((sos.refused, sos.done), (0, usize::from(by_sos)), "{:?}", pair.shapes);
        let per_mesh = pair.check(&mut PerMesh.prepare(scene, Off).unwrap(), Zeros::Zero);
        assert_eq!(per_mesh.done, 1, "{:?}", pair.shapes);
        let seen = [exact, sos, per_mesh];
        (0..3).for_each(|at| self.0[at] += seen[at]);
    }
}

fn unit() -> Shape {
    Shape::cuboid([0.; 3], [2.; 3])
}

#[test]
fn the_truth_about_volumes_is_that_of_boxes_and_of_parts() {
    let apex = [0.375, 0.28125, 0.2421875].map(predicament_judge::rational);
    let mut random = Random(1);
    for _ in 0..40 {
        let [a, b] = [(); 2].map(|()| {
            let low = random.point(4);
            (low, low.map(|x| x + 2.0 + random.whole(1)))
        });
        let along = |i: usize| (a.1[i].min(b.1[i]) - a.0[i].max(b.0[i])).max(0.0);
        let closed = along(0) * along(1) * along(2);
        let [first, second] = [a, b].map(|(low, high)| Shape::cuboid(low, high));
        let [first, second] = [first.boundary(1), second.boundary(1)];
        assert_eq!(common(&first, &second, &apex), closed);
        assert_eq!(common(&first, &first, &apex), volume(&first));
        // A tetrahedron in a box is the sum of its intersections with the boxes that the box is cut into.
        let tetrahedron = Shape::tetrahedron([(); 4].map(|()| random.point(4)));
        let tetrahedron = if tetrahedron.triangles.is_empty() { continue } else { tetrahedron.boundary(1) };
        let cut = random.whole(3);
        let [low, high] = [[-4.0; 3], [4.0; 3]];
        let parts = [(low, [cut, 4.0, 4.0]), ([cut, -4.0, -4.0], high)].map(|(low, high)| Shape::cuboid(low, high));
        let sum: Rational = parts.iter().map(|part| common(&tetrahedron, &part.boundary(1), &apex)).sum();
        assert_eq!(sum, volume(&tetrahedron));
        assert!(sum > 0);
    }
}

#[test]
fn tetrahedra_and_boxes_anywhere() {
    let (mut random, mut all) = (Random(2), All::default());
    for round in 0..predicament_effort::scaled(600) {
        let most = [3, 40][round % 2];
        let mut shape = || loop {
            let shape = Shape::tetrahedron([(); 4].map(|()| random.point(most)));
            if !shape.triangles.is_empty() {
                return shape;
            }
        };
        let [first, second] = [shape(), shape()];
        all.check(&first, &second);
        let low = random.point(2);
        all.check(&first, &Shape::cuboid(low, low.map(|x| x + 3.0)));
    }
    let (touching, [exact, _, per_mesh]) = (all.1, all.0);
    assert!(touching > 5 && exact.done - touching > 40 && per_mesh.constructed > 100, "{all:?}");
}

/// Tests a face of one mesh in the plane of a face of the other: contacts are found if and only if the faces meet.
#[test]
fn faces_in_one_plane_touch_or_are_apart() {
    let (mut random, mut seen) = (Random(6), [0, 0]);
    for _ in 0..predicament_effort::scaled(4_000) {
        let mut over = |height: f64| loop {
            let mut points = [(); 4].map(|()| random.point(4));
            points[..3].iter_mut().for_each(|p| p[2] = 0.0);
            points[3][2] = height;
            let shape = Shape::tetrahedron(points);
            if !shape.triangles.is_empty() {
                return shape;
            }
        };
        let pair = Pair::without_truth(over(3.0), over(-3.0));
        let mut session = Exact.prepare(&pair.scene, Off).unwrap();
        let overlay = mesh_overlay(&mut session, pair.meshes(), Zeros::Zero).unwrap();
        let touches = overlay.contacts() != Contacts::default();
        assert_eq!(touches, pair.is_degenerate(), "{:?}", pair.shapes);
        assert!(overlay.solid(Operation::Intersection).triangles.is_empty());
        seen[usize::from(touches)] += 1;
    }
    assert!(seen[0] > 30 && seen[1] > 30, "{seen:?}");
}

#[test]
fn boxes_that_touch_in_every_way() {
    let mut all = All::default();
    let ulp = 1f64.next_up() - 1.0;
    for by in
        [[0.; 3], [0., 0., 2.], [0., 2., 2.], [2.; 3], [0., 0., 1.], [0., 1., 1.], [1.; 3], [-2., 0., 1.], [3., 0., 0.]]
    {
        all.check(&unit(), &unit().moved(by));
        all.check(&unit().moved(by), &unit());
    }
    for by in
        [[ulp, 0., 0.], [0., -ulp, 0.], [2f64.powi(-30), 0., 2f64.powi(-30)], [2f64.powi(-30); 3], [-ulp, ulp, -ulp]]
    {
        // From 1 to 2 every multiple of an ulp is a double.
        let one = || Shape::cuboid([1.25; 3], [1.75; 3]);
        all.check(&one(), &one().moved(by));
    }
    // Boxes of different sizes, inside each other, with sides in one plane.
    all.check(&unit(), &Shape::cuboid([0.; 3], [1.; 3]));
    all.check(&unit(), &Shape::cuboid([0., 0., 1.], [1., 2., 2.]));
    all.check(&Shape::cuboid([-1., 0., 0.], [3., 1., 1.]), &unit());
    let (touching, [_, _, per_mesh]) = (all.1, all.0);
    assert!(touching > 20 && per_mesh.flat > 100 && per_mesh.located > 100, "{all:?}");
}

fn comb() -> Shape {
    Shape::cubes(&[[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [4, 0, 0], [0, 1, 0], [2, 1, 0], [4, 1, 0]])
}

fn ring() -> Shape {
    Shape::cubes(&[[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [2, 1, 0], [0, 2, 0], [1, 2, 0], [2, 2, 0]])
}

#[test]
fn shapes_that_are_not_convex() {
    let mut all = All::default();
    let large = Shape::tetrahedron([[-20., -15., 0.5], [30., -12., 0.25], [1., 40., 0.75], [3., 2., -30.]]);
    let ell = Shape::cubes(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]]);
    // Teeth through one triangle, a ring that stands in it, and a ring that lies in it.
    let standing = |shape: Shape| shape.mapped(|[x, y, z]| [x, z + 0.125, 2.0 - y]);
    all.check(&large, &standing(comb()));
    all.check(&standing(comb()), &large);
    all.check(&large, &standing(ring()).sheared(LEAN));
    all.check(&ring().sheared(LEAN), &large);
    for by in [[0., 0., 0.], [1., 0., 0.], [0.5, 0.5, 0.5], [0., 1., 0.5], [1., 1., 1.]] {
        all.check(&comb(), &ring().moved(by));
        all.check(&ell, &comb().mapped(|[x, y, z]| [4.0 - x, 2.0 - y, z]).moved(by));
        all.check(&comb().sheared(LEAN), &standing(ring()).moved(by));
    }
    // Cubes that share an edge: four triangles there.
    let diagonal = Shape::cubes(&[[0, 0, 0], [1, 1, 0]]);
    all.check(&diagonal, &large);
    all.check(&large, &diagonal.clone().sheared(LEAN).moved([0.25, 0.5, -0.25]));
    all.check(&diagonal.clone().moved([0.5, 0.5, 0.25]), &ring());
    let (touching, [exact, _, per_mesh]) = (all.1, all.0);
    assert!(exact.done - touching > 5 && touching > 5 && per_mesh.located > 200, "{all:?}");
}

#[test]
fn spheres_and_tori() {
    let mut all = All::default();
    let sphere = Shape::sphere(10.0, 1);
    let torus = Shape::torus([12.0, 5.0], [8, 5]);
    all.check(&sphere, &sphere.clone().mapped(|[x, y, z]| [x, y + z / 64.0, z - y / 64.0]));
    all.check(&sphere, &sphere.clone().sheared(LEAN).moved([3., 2., 1.]));
    all.check(&torus, &sphere.clone().moved([11., 1., 0.]));
    all.check(&torus, &torus.clone().mapped(|[x, y, z]| [x + 11.0, z, -y]));
    all.check(
        &Shape::sphere(20.0, 2),
        &Shape::tetrahedron([[-50., -41., 3.], [61., -37., 2.], [5., 70., 4.], [1., 2., -60.]]),
    );
    if predicament_effort::whole() {
        let fine = Shape::sphere(100.0, 3);
        all.check(&fine, &fine.clone().sheared(LEAN).moved([30., 20., 10.]));
        all.check(&fine.clone().sheared(TURN), &fine.clone().mapped(|p| p.map(|x| 5.0 * x)));
    }
    let (touching, [exact, _, per_mesh]) = (all.1, all.0);
    assert!(exact.done - touching > 2 && per_mesh.constructed > 200, "{all:?}");
}

#[test]
fn results_as_half_edge_meshes_have_their_labels() {
    let ball = Shape::sphere(10.0, 1);
    let pair = Pair::without_truth(ball.clone(), ball.sheared(LEAN).moved([3., 2., 1.]));
    let mut session = PerMesh.prepare(&pair.scene, Off).unwrap();
    let overlay = mesh_overlay(&mut session, pair.meshes(), Zeros::Zero).unwrap();
    for operation in [Operation::Union, Operation::Intersection, Operation::Difference] {
        let solid = overlay.solid(operation);
        let mesh = solid.half_edges().unwrap();
        mesh.validate().unwrap();
        assert_eq!(mesh.half_edges().filter(|&h| mesh.is_boundary(h)).count(), 0);
        assert_eq!((mesh.face_count(), mesh.edge_count()), (solid.triangles.len(), solid.triangles.len() / 2 * 3));
        let mut curve = 0;
        for h in mesh.half_edges() {
            let face = mesh.face(h).unwrap();
            let place = mesh.face_user_data(face) as usize;
            assert_eq!(mesh.face_marker(face), solid.sources[place].mesh);
            assert!(solid.triangles[place].contains(&mesh.scene_vertex(mesh.end(h))));
            let other = mesh.face(mesh.opposite(h)).unwrap();
            if mesh.face_marker(other) != mesh.face_marker(face) {
                // The surfaces of the two meet on the curve, whose vertices are constructed.
                assert!([mesh.start(h), mesh.end(h)].iter().all(|&v| mesh.scene_vertex(v).is_constructed()));
                curve += 1;
            }
        }
        assert_eq!(curve, 2 * overlay.constructions().len(), "{operation:?}");
    }
    // Four triangles at each edge of the curve.
    assert!(overlay.solid(Operation::SymmetricDifference).half_edges().is_err());
}

#[test]
fn components_that_are_apart_or_within() {
    let mut all = All::default();
    let small = Shape::cuboid([0.5; 3], [1.5; 3]);
    let far = unit().moved([7., 7., 7.]);
    let hollow = Shape::cuboid([-4.; 3], [6.; 3]).and(&Shape::cuboid([-2.; 3], [4.; 3]).inverted());
    for [first, second] in [
        [&unit(), &small],
        [&small, &unit()],
        [&unit(), &far],
        [&unit().and(&far), &small],
        [&unit().and(&far), &small.clone().and(&far.clone().moved([0.5, 0.25, 0.125]))],
        // In the cavity, through its wall, and in the wall.
        [&hollow, &unit()],
        [&unit(), &hollow],
        [&hollow, &unit().moved([2.25, 0.5, 0.125])],
        [&hollow, &small.clone().moved([3.75, 0., 0.])],
        [&hollow, &hollow.clone().sheared(LEAN)],
        // Boxes that meet while nothing in them does.
        [&ring(), &Shape::cuboid([1.25, 1.25, -1.], [1.75, 1.75, 2.])],
    ] {
        all.check(first, second);
    }
    let (touching, [_, _, per_mesh]) = (all.1, all.0);
    assert!(touching == 1 && per_mesh.located > 100, "{all:?}");
}

#[test]
fn lattices_of_tetrahedra_have_closed_regions() {
    let mut all = All::default();
    let lattice = Shape::lattice([2, 1, 1]);
    let one = Shape::lattice([1, 1, 1]);
    all.check(&one, &one.clone().moved([0.5, 0.25, 0.125]));
    all.check(&one.clone().moved([0.25, 0., 0.]), &one.clone().sheared(LEAN).moved([0.3125, 0.25, 0.4375]));
    all.check(&one.clone().sheared(TURN), &Shape::cuboid([-1., 0., 1.], [3., 2., 4.]));
    all.check(&Shape::cuboid([-0.5, 0.25, 0.125], [1.5, 0.75, 1.5]), &lattice);
    // On each other, and next to each other.
    all.check(&one, &one);
    all.check(&one, &one.clone().moved([1., 0., 0.]));
    all.check(&one, &one.clone().moved([0., 0.5, 0.]));
    let (touching, [exact, _, per_mesh]) = (all.1, all.0);
    assert!(exact.done - touching > 0 && touching > 2 && per_mesh.constructed > 100, "{all:?}");
}

/// Tests tetrahedra around an edge that passes through triangles of the other mesh.
#[test]
fn edges_of_many_triangles_pass_through() {
    let mut all = All::default();
    let axis = [[0.25, 0.5, 9.0], [0.0, 0.25, -9.0]];
    let eight = [[5., 0.], [4., 4.], [0., 5.], [-4., 4.], [-5., 0.], [-4., -4.], [0., -5.], [4., -4.]];
    // Opposite faces are in one plane with a straight axis, and not in one plane with the other axis.
    let straight = [[0., 0., 9.], [0., 0., -9.]];
    let large = Shape::tetrahedron([[-20., -15., 0.5], [30., -12., 0.25], [1., 40., 0.75], [3., 2., -30.]]);
    let slab = Shape::cuboid([-7., -8., -2.], [9., 10., 3.]);
    for axis in [axis, straight] {
        for count in [8, 3] {
            let around: Vec<[f64; 3]> =
                eight[..count].iter().zip(0_u8..).map(|(&[x, y], i)| [x, y, f64::from(i % 3)]).collect();
            let fan = Shape::fan(axis, &around, count == 8);
            for other in [&large, &slab] {
                all.check(&fan, other);
                all.check(other, &fan);
            }
            all.check(&fan, &fan.clone().sheared(TURN).mapped(|p| p.map(|x| x / 4.0)).moved([0.5, 0.25, 1.0]));
        }
    }
    // A fan whose edge ends in the plane of the other's faces.
    let short = Shape::fan([[0., 0., 3.], [0., 0., -2.]], &eight.map(|[x, y]| [x, y, 0.0]), true);
    all.check(&slab, &short);
    all.check(&short, &slab);
    let (touching, [exact, _, per_mesh]) = (all.1, all.0);
    assert!(exact.done - touching > 15 && touching > 1 && per_mesh.constructed > 500, "{all:?}");
}
