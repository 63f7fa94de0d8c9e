//! Tests of simplification: by exact signs, by broken ties and by doubles.

use predicament_exact::Exact;
use predicament_mesh::HalfEdgeMesh;
use predicament_predicates::{Backend, Off, Question, Scene, Sign, Vertex};
use predicament_simplify::algorithm::simplify;
use predicament_simplify::answer::{Simplified, Step, same_facing};
use predicament_simplify::checks::{Facing, Obstacle, Replay, facing};
use predicament_simplify::truth::{Component, Flaw, components};
use predicament_sos::Sos;
use predicament_tolerance::Tolerance;
use proptest::prelude::*;

fn triangles(corners: &[[usize; 3]]) -> Vec<[Vertex; 3]> {
    corners.iter().map(|corners| corners.map(Vertex::input)).collect()
}

fn by<B: Backend>(backend: &B, scene: &Scene, triangles: &[[Vertex; 3]], target: usize) -> Simplified {
    let mesh = HalfEdgeMesh::of_scene(scene.len(), triangles).unwrap();
    let session = backend.prepare(scene, Off).unwrap();
    simplify(&session, mesh, target, &mut |_| Ok::<_, ()>(())).unwrap()
}

/// A grid of squares, each cut in two triangles, with this height at each point.
fn grid(side: usize, height: impl Fn(usize, usize) -> f64) -> (Scene, Vec<[Vertex; 3]>) {
    let double = |i: usize| f64::from(u32::try_from(i).unwrap());
    let row = side + 1;
    let places = (0..row).flat_map(|x| (0..row).map(move |y| [x, y]));
    let points: Vec<[f64; 3]> = places.map(|[x, y]| [double(x), double(y), height(x, y)]).collect();
    let at = |x: usize, y: usize| x * row + y;
    let squares = (0..side).flat_map(|x| (0..side).map(move |y| [x, y]));
    let corners = squares.flat_map(|[x, y]| {
        let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
        [[a, b, c], [a, c, d]]
    });
    let corners: Vec<[usize; 3]> = corners.collect();
    (Scene::from_points3(&points).unwrap(), triangles(&corners))
}

/// Does the steps again, by the link condition's definition and exact signs; returns the number of refusals.
fn replayed(scene: &Scene, input: &[[Vertex; 3]], answer: &Simplified, target: usize) -> usize {
    let mut replay = Replay::new(scene.len(), input);
    let mut refused = 0;
    for step in &answer.steps {
        match *step {
            Step::Collapse { gone, kept } => {
                assert_eq!(replay.obstacle([gone, kept]), None, "{step:?}");
                assert!(replay.moved(gone, kept).all(|[b, c]| facing(scene, [gone, kept, b, c]).is_kept()), "{step:?}");
                replay.collapse(gone, kept);
            }
            Step::Refusal { gone, kept, base: [b, c], .. } => {
                assert!(!facing(scene, [gone, kept, b, c]).is_kept(), "{step:?}");
                refused += 1;
            }
        }
    }
    assert_eq!(replay.triangles().count(), answer.triangles.len());
    assert_eq!(components(&answer.triangles), components(input), "the surface stays what it is");
    if answer.triangles.len() > target {
        let open = replay.edges().into_iter().find(|&[gone, kept]| {
            let mut moved = replay.moved(gone, kept);
            replay.obstacle([gone, kept]).is_none() && moved.all(|[b, c]| facing(scene, [gone, kept, b, c]).is_kept())
        });
        assert_eq!(open, None, "an edge can be collapsed");
    }
    refused
}

#[test]
fn a_flat_sheet_keeps_its_area_while_its_rim_stays() {
    let (scene, input) = grid(6, |_, _| 0.0);
    let exact = by(&Exact, &scene, &input, 2);
    replayed(&scene, &input, &exact, 2);
    // Twice the area in the plane: each triangle is counterclockwise.
    let twice = |&[a, b, c]: &[Vertex; 3]| {
        let [a, b, c] = [a, b, c].map(|v| scene.point3(v));
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    assert!(exact.triangles.iter().all(|corners| twice(corners) > 0.0), "{:?}", exact.triangles);
    assert_eq!(exact.triangles.len(), 2);
    assert_eq!(exact.triangles.iter().map(twice).sum::<f64>(), 72.0);
}

#[test]
fn a_tetrahedron_is_the_end() {
    let points = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    let scene = Scene::from_points3(&points).unwrap();
    let input = triangles(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]);
    let exact = by(&Exact, &scene, &input, 0);
    assert_eq!(exact.triangles, input);
    assert!(exact.steps.iter().all(|step| matches!(step, Step::Refusal { .. })));
    assert_eq!(exact.reach, 0.0);
    let replay = Replay::new(4, &input);
    assert_eq!(replay.obstacle([0, 1].map(Vertex::input)), Some(Obstacle::Edge(Vertex::input(2))));
}

#[test]
fn surfaces_are_told_apart() {
    let sphere = components(&triangles(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]));
    assert_eq!(sphere, Ok(vec![Component { euler: 2, loops: 0 }]));
    let (_, sheet) = grid(2, |_, _| 0.0);
    assert_eq!(components(&sheet), Ok(vec![Component { euler: 1, loops: 1 }]));
    let annulus: Vec<_> = grid(3, |_, _| 0.0).1.into_iter().enumerate().filter(|(at, _)| at / 2 != 4).collect();
    let annulus: Vec<[Vertex; 3]> = annulus.into_iter().map(|(_, corners)| corners).collect();
    assert_eq!(components(&annulus), Ok(vec![Component { euler: 0, loops: 2 }]));
    let two_fans = components(&triangles(&[[0, 1, 2], [0, 3, 4]]));
    assert_eq!(two_fans, Err(Flaw::Fans(Vertex::input(0))));
    let turned = components(&triangles(&[[0, 1, 2], [0, 1, 3]]));
    assert_eq!(turned, Err(Flaw::Side([0, 1].map(Vertex::input))));
    assert_eq!(Component { euler: 0, loops: 0 }.genus(), 1);
}

#[test]
fn a_tolerance_finds_flat_what_is_nearly_flat() {
    let (scene, input) = grid(4, |x, y| if (x + y) % 2 == 0 { 0.0 } else { 1e-18 });
    let answer = by(&Tolerance::<f64>::default(), &scene, &input, 2);
    assert_eq!(components(&answer.triangles), components(&input));
}

/// Heights of a grid, and its size.
fn terrain() -> impl Strategy<Value = (usize, Vec<i8>)> {
    (1_usize..5).prop_flat_map(|side| (Just(side), proptest::collection::vec(-2_i8..=2, (side + 1) * (side + 1))))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(400)))]

    #[test]
    fn steps_are_possible_and_turn_no_face((side, heights) in terrain(), target in 0_usize..20, scale in 0_usize..3) {
        let factor = [1.0, 1e-100, 1e100][scale];
        let (scene, input) = grid(side, |x, y| f64::from(heights[x * (side + 1) + y]));
        let points: Vec<[f64; 3]> = scene.vertices().map(|v| scene.point3(v).map(|x| x * factor)).collect();
        let scene = Scene::from_points3(&points).unwrap();
        let exact = by(&Exact, &scene, &input, target);
        replayed(&scene, &input, &exact, target);
        let sos = by(&Sos::default(), &scene, &input, target);
        prop_assert_eq!(components(&sos.triangles), components(&input));
    }

    #[test]
    fn the_formula_is_the_product_of_the_normals(
        points in [[-3_i8..=3, -3_i8..=3, -3_i8..=3], [-3_i8..=3, -3_i8..=3, -3_i8..=3], [-3_i8..=3, -3_i8..=3, -3_i8..=3], [-3_i8..=3, -3_i8..=3, -3_i8..=3]],
        scale in 0_usize..3,
    ) {
        let factor = [1.0, 0.1, 1e-200][scale];
        let points = points.map(|point| point.map(|x| f64::from(x) * factor));
        let scene = Scene::from_points3(&points).unwrap();
        let face = [0, 1, 2, 3].map(Vertex::input);
        let sign = predicament_judge::sign(&scene, Question::Derived(same_facing()), &face);
        let wanted = match facing(&scene, face) {
            Facing::Same => Sign::Positive,
            Facing::Turned => Sign::Negative,
            Facing::Flat | Facing::Undecided => Sign::Zero,
        };
        prop_assert_eq!(sign, wanted);
    }

    /// Any vertex list in any order: coordinates coincide, faces have no area, and the mesh is a closed tube.
    #[test]
    fn tubes_of_any_points_stay_tubes(points in proptest::collection::vec([-1_i8..=1, -1_i8..=1, -1_i8..=1], 16)) {
        let at = |i: usize, j: usize| i % 4 * 4 + j % 4;
        let squares = (0..4).flat_map(|i| (0..4).map(move |j| [i, j]));
        let corners: Vec<[usize; 3]> = squares.flat_map(|[i, j]| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        }).collect();
        let points: Vec<[f64; 3]> = points.into_iter().map(|point| point.map(f64::from)).collect();
        let (scene, input) = (Scene::from_points3(&points).unwrap(), triangles(&corners));
        replayed(&scene, &input, &by(&Exact, &scene, &input, 4), 4);
    }
}

#[test]
fn the_steps_are_the_same_again() {
    let (scene, input) = grid(12, |x, y| [0.0, 0.5, 0.25][(x * y + x) % 3]);
    let [one, other] = [(); 2].map(|()| by(&Exact, &scene, &input, 40));
    assert_eq!(one, other);
}
