//! Tests of covers: by exact signs and by broken ties, against the truth.

use std::sync::atomic::AtomicBool;

use predicament_cover::algorithm::Surface;
use predicament_cover::answer::{Cover, Reason};
use predicament_cover::checks::{Asked, Law, Verdict};
use predicament_cover::task::HoleScene;
use predicament_cover::truth::{Around, Signs, Truth};
use predicament_exact::Exact;
use predicament_judge::Judged;
use predicament_predicates::{Backend, Off, Predicates, Question, Scene, Vertex};
use predicament_sos::infinitesimal::judge;
use predicament_sos::{Scheme, Sos};
use predicament_tasks::Watch;
use proptest::prelude::*;

fn vertices(all: &[usize]) -> Vec<Vertex> {
    all.iter().map(|&v| Vertex::input(v)).collect()
}

fn corners([a, b, c]: [usize; 3]) -> [Vertex; 3] {
    [a, b, c].map(Vertex::input)
}

/// A scene with one loop through all points.
fn bare(points: &[[f64; 3]]) -> (Scene, HoleScene) {
    let scene = Scene::from_points3(points).unwrap();
    let loops = vec![scene.vertices().collect()];
    (scene, HoleScene { triangles: Vec::new(), loops, are_written: true })
}

fn solved(session: &dyn Predicates, content: &HoleScene) -> Vec<Cover> {
    let mut surface = Surface::new(session.scene(), &content.triangles);
    content.loops.iter().map(|around| surface.cover(session, around)).collect()
}

/// The covers by exact signs, after a comparison with the truth; the covers with broken ties are compared, too.
fn judged(scene: &Scene, content: &HoleScene) -> Vec<Cover> {
    let truth = Truth::new(scene, content, &Watch::new(&AtomicBool::new(false), None, &|_| {})).unwrap();
    let exact = solved(&Exact.prepare(scene, Off).unwrap(), content);
    let sos = Sos::default();
    let broken = solved(&sos.prepare(scene, Off).unwrap(), content);
    let ties = |scene: &Scene, question: Question, args: &[Vertex]| judge(Scheme::PerCoordinate, scene, question, args);
    let (of_exact, of_sos) = (Judged::exact(scene), Judged::perturbed(scene, &ties));
    for (covers, session) in [(&exact, &of_exact), (&broken, &of_sos)] {
        let signs = Signs::new(session);
        let mut surface = Around::default();
        surface.extend(&content.triangles);
        for (at, cover) in covers.iter().enumerate() {
            let areas = truth.areas[at].as_ref();
            let asked = Asked { signs: &signs, surface: &surface, around: &content.loops[at], areas };
            let verdict = asked.verdict(cover);
            assert_eq!(verdict, Verdict::Right, "loop {at}: {cover}");
            if let Cover::Triangles(triangles) = cover {
                surface.extend(triangles);
            }
        }
    }
    exact
}

fn triangles(all: &[[usize; 3]]) -> Cover {
    Cover::Triangles(all.iter().map(|&one| corners(one)).collect())
}

#[test]
fn the_diagonal_with_less_area_covers_a_saddle() {
    let (scene, content) = bare(&[[0., 0., 0.], [4., 0., 3.], [4., 4., 0.], [0., 5., 3.]]);
    assert_eq!(judged(&scene, &content), [triangles(&[[0, 1, 2], [0, 2, 3]])]);
}

#[test]
fn a_cover_that_crosses_is_not_taken() {
    // The least areas of covers with crossings are smaller by 3 % and by 31 %.
    let five = [[6., 1., 2.], [6., 7., 3.], [8., 4., 0.], [4., 7., 7.], [8., 1., 6.]];
    for scale in [1.0, 2.0_f64.powi(332), 2.0_f64.powi(-332)] {
        let (scene, content) = bare(&five.map(|point| point.map(|x| x * scale)));
        assert_eq!(judged(&scene, &content), [triangles(&[[0, 1, 3], [0, 3, 4], [1, 2, 3]])]);
    }
    let (scene, content) = bare(&[[5., 7., 4.], [4., 7., 3.], [8., 1., 4.], [6., 8., 7.], [0., 2., 1.], [8., 3., 4.]]);
    assert_eq!(judged(&scene, &content), [triangles(&[[0, 1, 5], [1, 2, 5], [2, 3, 4], [2, 4, 5]])]);
}

#[test]
fn a_trefoil_has_no_cover() {
    let (scene, content) = bare(&[[3., 1., 3.], [4., 8., 0.], [5., 1., 8.], [0., 8., 3.], [7., 6., 0.], [6., 7., 7.]]);
    assert_eq!(judged(&scene, &content), [Cover::Uncovered(Reason::Crosses)]);
    // The judge decides every loop of eleven points.
    let point = |at: u8| {
        let t = f64::from(at) * std::f64::consts::TAU / 11.0;
        [t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin()]
    };
    let (scene, content) = bare(&(0..11).map(point).collect::<Vec<_>>());
    assert_eq!(judged(&scene, &content), [Cover::Uncovered(Reason::Crosses)]);
}

#[test]
fn a_cover_is_in_the_way_of_the_next_one() {
    let points = [
        [0., 0., 0.],
        [8., 0., 4.],
        [8., 8., 0.],
        [0., 8., 4.],
        [2., 2., 3.],
        [6., 2., 4.5],
        [6., 6., 3.],
        [2., 6., 4.5],
    ];
    let scene = Scene::from_points3(&points).unwrap();
    let second = vertices(&[5, 6, 7, 4]);
    let alone = HoleScene { triangles: Vec::new(), loops: vec![second.clone()], are_written: true };
    assert_eq!(judged(&scene, &alone), [triangles(&[[5, 6, 4], [6, 7, 4]])]);
    let both = HoleScene { loops: vec![vertices(&[0, 1, 2, 3]), second], ..alone };
    assert_eq!(judged(&scene, &both)[1], triangles(&[[5, 6, 7], [5, 7, 4]]));
}

#[test]
fn an_edge_of_the_mesh_is_not_a_diagonal() {
    // The shorter diagonal of the loop is an edge of two triangles, which would not cross the cover.
    let points = [[0., 0., 0.], [8., 0., 0.], [4., 1., 1.], [4., -1., 1.], [3., 0., 6.], [5., 0., 6.]];
    let scene = Scene::from_points3(&points).unwrap();
    let loops = vec![vertices(&[0, 2, 1, 3])];
    let without = HoleScene { triangles: Vec::new(), loops, are_written: true };
    assert_eq!(judged(&scene, &without), [triangles(&[[0, 2, 3], [2, 1, 3]])]);
    let with = HoleScene { triangles: [[2, 3, 4], [3, 2, 5]].map(corners).to_vec(), ..without };
    assert_eq!(judged(&scene, &with), [triangles(&[[0, 2, 1], [0, 1, 3]])]);
    // The edge of a tetrahedron without two triangles.
    let content = HoleScene::of_holes(6, [[0, 3, 2], [1, 2, 3]].map(corners).to_vec()).unwrap();
    assert_eq!(judged(&scene, &content), [triangles(&[[0, 2, 1], [0, 1, 3]])]);
}

#[test]
fn a_triangle_turned_over_has_no_cover() {
    let scene = Scene::from_points3(&[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]]).unwrap();
    let content = HoleScene::of_holes(3, vec![corners([0, 1, 2])]).unwrap();
    assert_eq!(judged(&scene, &content), [Cover::Uncovered(Reason::Crosses)]);
}

#[test]
fn a_loop_that_passes_a_vertex_twice_is_declined() {
    let points = [[0., 0., 0.], [1., 1., 0.], [1., -1., 0.], [-1., 1., 0.], [-1., -1., 0.]];
    let scene = Scene::from_points3(&points).unwrap();
    let content = HoleScene::of_holes(5, [[0, 2, 1], [0, 3, 4]].map(corners).to_vec()).unwrap();
    assert_eq!(content.loops, [vertices(&[0, 1, 2, 0, 4, 3])]);
    assert_eq!(judged(&scene, &content), [Cover::Uncovered(Reason::Repeats)]);
}

#[test]
fn a_wrong_cover_breaks_the_law_that_it_breaks() {
    let (scene, content) = bare(&[[0., 0., 0.], [2., 0., 0.], [4., 0., 0.], [4., 4., 0.], [0., 4., 4.]]);
    let truth = Truth::new(&scene, &content, &Watch::new(&AtomicBool::new(false), None, &|_| {})).unwrap();
    let exact = Judged::exact(&scene);
    let (signs, surface) = (Signs::new(&exact), Around::default());
    let asked = Asked { signs: &signs, surface: &surface, around: &content.loops[0], areas: truth.areas[0].as_ref() };
    let law = |cover: &Cover| match asked.verdict(cover) {
        Verdict::Wrong { law, .. } => Some(law),
        _ => None,
    };
    assert_eq!(law(&triangles(&[[0, 1, 2], [0, 2, 3], [0, 3, 4]])), Some(Law::Flat));
    assert_eq!(law(&triangles(&[[0, 1, 2], [0, 3, 2], [0, 3, 4]])), Some(Law::Disk));
    assert_eq!(law(&triangles(&[[0, 2, 3], [0, 3, 4]])), Some(Law::Disk));
    assert_eq!(law(&Cover::Uncovered(Reason::Crosses)), Some(Law::Uncovered));
    assert_eq!(law(&Cover::Uncovered(Reason::Repeats)), Some(Law::Uncovered));
    let right = judged(&scene, &content).remove(0);
    let all = [[[0, 1, 3], [0, 3, 4], [1, 2, 3]], [[0, 1, 4], [1, 2, 3], [1, 3, 4]], [[0, 1, 4], [1, 2, 4], [2, 3, 4]]];
    for cover in all.map(|all| triangles(&all)) {
        assert_eq!(law(&cover), (cover != right).then_some(Law::Least), "{cover}");
    }
}

/// Points with small coordinates, in which ties are common.
fn points(most: usize) -> impl Strategy<Value = Vec<[i8; 3]>> {
    proptest::collection::vec([-2_i8..=2, -2_i8..=2, -2_i8..=2], 3..most)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(1_000)))]

    #[test]
    fn covers_of_loops_are_right(points in points(9)) {
        let points: Vec<[f64; 3]> = points.into_iter().map(|point| point.map(f64::from)).collect();
        let (scene, content) = bare(&points);
        judged(&scene, &content);
    }

    #[test]
    fn covers_beside_triangles_are_right(around in points(7), others in points(7)) {
        let points: Vec<[f64; 3]> =
            around.iter().chain(&others).map(|point| point.map(f64::from)).collect();
        let scene = Scene::from_points3(&points).unwrap();
        let beside = (0..others.len() / 3).map(|at| [0, 1, 2].map(|corner| around.len() + 3 * at + corner));
        let beside = beside.filter(|corners| {
            let [p, q, r] = corners.map(|v| points[v]);
            let [u, v] = [q, r].map(|end| [0, 1, 2].map(|axis| end[axis] - p[axis]));
            [[1, 2], [2, 0], [0, 1]].into_iter().any(|[i, j]: [usize; 2]| u[i] * v[j] != u[j] * v[i])
        });
        let triangles = beside.map(corners).collect();
        let loops = vec![(0..around.len()).map(Vertex::input).collect()];
        judged(&scene, &HoleScene { triangles, loops, are_written: true });
    }
}
