//! Tests of rays and meshes: by exact signs and by broken ties, against the truth.

use std::sync::atomic::AtomicBool;

use predicament_exact::Exact;
use predicament_mesh_rays::algorithm::{MeshTree, hits};
use predicament_mesh_rays::answer::{Extent, Hits, describe};
use predicament_mesh_rays::task::RayScene;
use predicament_mesh_rays::truth::Truth;
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_sos::Sos;
use predicament_tasks::Watch;
use predicament_tolerance::Tolerance;
use proptest::prelude::*;

/// A scene of triangles and queries: first the queries' points, then the mesh.
fn scene(points: &[[f64; 3]], triangles: &[[usize; 3]], rays: &[[[f64; 3]; 2]], extent: Extent) -> (Scene, RayScene) {
    let all = [rays.as_flattened(), points].concat();
    let corners = triangles.iter().map(|corners| corners.map(|v| Vertex::input(2 * rays.len() + v))).collect();
    let ends = (0..rays.len()).map(|at| [2 * at, 2 * at + 1].map(Vertex::input)).collect();
    (Scene::from_points3(&all).unwrap(), RayScene::new(corners, ends, extent))
}

fn solved<P: Predicates>(session: &mut P, content: &RayScene) -> Vec<Hits> {
    let tree = MeshTree::new(session.scene(), &content.triangles);
    hits(session, &tree, content.extent, &content.rays).unwrap()
}

fn truth(scene: &Scene, content: &RayScene) -> Truth {
    Truth::new(scene, content, &Watch::new(&AtomicBool::new(false), None, &|_| {})).unwrap()
}

/// Compares exact hits with the truth, and perturbed hits with those of the judge.
fn agrees(scene: &Scene, content: &RayScene) {
    let truth = truth(scene, content);
    let exact = solved(&mut Exact.prepare(scene, Off).unwrap(), content);
    let sos = Sos::default();
    let broken = solved(&mut sos.prepare(scene, Off).unwrap(), content);
    for at in 0..content.rays.len() {
        let known = truth.of(at).unwrap();
        assert_eq!(describe(&exact[at].groups), describe(&known.groups), "ray {at} of {:?}", content.extent);
        if known.crossings.is_some() {
            assert_eq!(exact[at].crossings, known.crossings, "ray {at}: {}", describe(&known.groups));
            assert_eq!(broken[at].crossings, known.crossings, "ray {at}: {}", describe(&broken[at].groups));
        }
    }
}

const CUBE: [[f64; 3]; 8] =
    [[0., 0., 0.], [4., 0., 0.], [4., 4., 0.], [0., 4., 0.], [0., 0., 4.], [4., 0., 4.], [4., 4., 4.], [0., 4., 4.]];

const FACES: [[usize; 3]; 12] = [
    [0, 3, 2],
    [0, 2, 1],
    [4, 5, 6],
    [4, 6, 7],
    [0, 1, 5],
    [0, 5, 4],
    [3, 7, 6],
    [3, 6, 2],
    [0, 4, 7],
    [0, 7, 3],
    [1, 2, 6],
    [1, 6, 5],
];

#[test]
fn a_ray_hits_what_it_passes() {
    let rays = [
        [[2., 2., 2.], [4., 4., 4.]],
        [[2., 2., 2.], [4., 4., 2.]],
        [[-1., 0., 0.], [-0.5, 0., 0.]],
        [[-1., 1., 4.], [0., 1., 4.]],
        [[1., 1., 9.], [1., 1., 8.]],
        [[2., 2., 2.], [2., 3., 2.5]],
    ];
    let (scene, content) = scene(&CUBE, &FACES, &rays, Extent::Ray);
    let exact = solved(&mut Exact.prepare(&scene, Off).unwrap(), &content);
    let told: Vec<String> = exact.iter().map(|hits| describe(&hits.groups)).collect();
    assert_eq!(
        told,
        [
            "vertex 18",
            "edge 14 18",
            "vertex 12, edge 12 13 along, vertex 13",
            "edge 16 19, face 3 along, edge 16 18, face 2 along, edge 17 18",
            "edge 16 18, edge 12 14",
            "face 6",
        ]
    );
    let sums: Vec<Option<i64>> = exact.iter().map(|hits| hits.crossings).collect();
    assert_eq!(sums, [Some(1), Some(1), Some(0), Some(0), Some(0), Some(1)]);
    agrees(&scene, &content);
}

#[test]
fn a_tolerance_registers_what_is_near() {
    let rays = [[[2., 2., 2.], [4.000_000_000_01, 4., 4.]], [[1., 2., 2.], [1., 2.5, 2.]]];
    let (scene, content) = scene(&CUBE, &FACES, &rays, Extent::Ray);
    let tolerance = Tolerance::<f64>::default();
    let near = solved(&mut tolerance.prepare(&scene, Off).unwrap(), &content);
    assert_eq!(near[1].crossings, Some(1), "{}", describe(&near[1].groups));
    let exact = solved(&mut Exact.prepare(&scene, Off).unwrap(), &content);
    assert_ne!(near[0].groups, exact[0].groups, "the vertex is within the band");
}

#[test]
fn an_edge_between_two_vertices_at_one_place_is_not_hit() {
    let points = [[0., 0., 0.], [0., 0., 0.], [4., 0., 0.], [0., 4., 0.]];
    let rays = [[[0., 0., -1.], [0., 0., 1.]], [[-1., -1., 0.], [1., 1., 0.]]];
    for extent in Extent::ALL {
        let (scene, content) = scene(&points, &[[0, 1, 2], [0, 3, 1], [0, 2, 3]], &rays, extent);
        let exact = solved(&mut Exact.prepare(&scene, Off).unwrap(), &content);
        assert_eq!(describe(&exact[0].groups), "vertex 4 and vertex 5");
        agrees(&scene, &content);
    }
}

/// Triangles, queries, the place of their extent among all, and whether corners at one place are one vertex.
type Soup = (Vec<[[i8; 3]; 3]>, Vec<[[i8; 3]; 2]>, usize, bool);

/// Triangles with small coordinates, in which ties are common, and queries among them.
fn soup() -> impl Strategy<Value = Soup> {
    let point = || [-2_i8..=2, -2_i8..=2, -2_i8..=2];
    let triangles = proptest::collection::vec([point(), point(), point()], 1..7);
    let rays = proptest::collection::vec([point(), point()], 1..4);
    (triangles, rays, 0..3_usize, any::<bool>())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2_000)))]

    #[test]
    fn hits_are_those_of_the_truth((triangles, rays, extent, is_shared) in soup()) {
        let double = |point: [i8; 3]| point.map(f64::from);
        let is_triangle = |[a, b, c]: &[[i8; 3]; 3]| !is_shared || a != b && b != c && c != a;
        // If corners at one place are one vertex, triangles share edges. Otherwise edges can have no length.
        let (mut points, mut corners): (Vec<[i8; 3]>, Vec<[usize; 3]>) = (Vec::new(), Vec::new());
        for mut triangle in triangles.into_iter().filter(is_triangle) {
            if !is_shared && points.len() % 2 == 0 {
                triangle[1] = triangle[0];
            }
            corners.push(triangle.map(|point| {
                points.iter().position(|other| is_shared && *other == point).unwrap_or_else(|| {
                    points.push(point);
                    points.len() - 1
                })
            }));
        }
        let points: Vec<[f64; 3]> = points.into_iter().map(double).collect();
        let rays: Vec<[[f64; 3]; 2]> = rays.into_iter().filter(|[p, q]| p != q).map(|ray| ray.map(double)).collect();
        let (scene, content) = scene(&points, &corners, &rays, Extent::ALL[extent]);
        let truth = truth(&scene, &content);
        match hits(
            &mut Exact.prepare(&scene, Off).unwrap(),
            &MeshTree::new(&scene, &content.triangles),
            content.extent,
            &content.rays,
        ) {
            Ok(exact) => {
                for (at, hits) in exact.iter().enumerate() {
                    prop_assert_eq!(describe(&hits.groups), describe(&truth.of(at).unwrap().groups), "ray {}", at);
                }
            }
            Err(refused) => prop_assert!(refused.to_string().contains("in one plane"), "{}", refused),
        }
    }
}
