//! Every check of hulls finds its fault.

use predicament_hull::algorithm::{SpaceMethod, hull3d};
use predicament_hull::checks::{Signs, plane_flaws, space_flaws};
use predicament_judge::{Judged, TieJudge};
use predicament_predicates::{Predicates, Question, Scene, Sign, Vertex};

type Faces = Vec<Vec<Vertex>>;

fn ids(indices: &[usize]) -> Vec<Vertex> {
    indices.iter().map(|&index| Vertex::input(index)).collect()
}

fn faces(of: &[&[usize]]) -> Faces {
    of.iter().map(|face| ids(face)).collect()
}

fn corners(faces: &Faces) -> Vec<Vertex> {
    let mut all: Vec<Vertex> = faces.iter().flatten().copied().collect();
    all.sort_unstable();
    all.dedup();
    all
}

fn signs<'a>(exact: &'a Judged<'a>, perturbed: Option<&'a Judged<'a>>) -> Signs<'a> {
    Signs { exact, perturbed: perturbed.map(|judged| judged as &dyn Predicates), ties: 1000, pairs: 100_000 }
}

/// The names of the failed checks.
fn in_plane(points: &[[f64; 2]], hull: &[usize]) -> Vec<&'static str> {
    let scene = Scene::from_points2(points).unwrap();
    plane_flaws(signs(&Judged::exact(&scene), None), &ids(hull)).iter().map(|flaw| flaw.check).collect()
}

fn in_space(points: &[[f64; 3]], vertices: &[Vertex], faces: &Faces) -> Vec<&'static str> {
    let scene = Scene::from_points3(points).unwrap();
    space_flaws(signs(&Judged::exact(&scene), None), vertices, faces).iter().map(|flaw| flaw.check).collect()
}

const SQUARE: [[f64; 2]; 7] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 0.0], [2.0, 2.0], [0.0, 0.0]];

#[test]
fn each_check_in_the_plane_finds_what_it_is_for() {
    assert_eq!(in_plane(&SQUARE, &[0, 1, 2, 3]), [""; 0]);
    for (check, hull) in [
        ("vertices", &[0, 1, 2, 9][..]),
        ("vertices", &[0, 1, 2, 3, 2]),
        ("span", &[0, 1]),
        ("start", &[1, 2, 3, 0]),
        ("convex", &[0, 5, 1, 2, 3]),
        ("extreme", &[0, 4, 1, 2, 3]),
        ("inside", &[0, 1, 2]),
        ("smallest index", &[6, 1, 2, 3]),
    ] {
        assert_eq!(in_plane(&SQUARE, hull), [check], "{hull:?}");
    }
    let pentagon = [[-10.0, 3.0], [-6.0, -8.0], [6.0, -8.0], [10.0, 3.0], [0.0, 10.0]];
    assert_eq!(in_plane(&pentagon, &[0, 1, 2, 3, 4]), [""; 0]);
    assert_eq!(in_plane(&pentagon, &[0, 2, 4, 1, 3]), ["wound once"]);
    let line = [[1.0, 1.0], [0.0, 0.0], [2.0, 2.0]];
    assert_eq!(in_plane(&line, &[1, 2]), [""; 0]);
    assert_eq!(in_plane(&line, &[1, 0]), ["inside"]);
    assert_eq!(in_plane(&line, &[1]), ["span"]);
    assert_eq!(in_plane(&[[1.0, 1.0], [1.0, 1.0]], &[0]), [""; 0]);
}

#[test]
fn every_point_is_between_the_chains() {
    // A triangle above a vertical edge: points left of, on, above and below it.
    let points = [[0.0, 0.0], [6.0, 3.0], [0.0, 6.0], [0.0, 3.0], [3.0, 3.0]];
    assert_eq!(in_plane(&points, &[0, 1, 2]), [""; 0]);
    for outside in [[-1.0, 3.0], [0.0, 7.0], [0.0, -1.0], [7.0, 3.0], [3.0, 1.0], [3.0, 5.0], [6.0, 3.5]] {
        let mut points = points;
        points[4] = outside;
        assert_eq!(in_plane(&points, &[0, 1, 2]), ["inside"], "{outside:?}");
    }
}

/// A cube with its middle, the middles of an edge and of a face, and a corner again.
fn cube() -> Vec<[f64; 3]> {
    let mut points: Vec<[f64; 3]> =
        (0..8_u32).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(|x| 2.0 * f64::from(x))).collect();
    points.extend([[1.0, 1.0, 1.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 2.0]]);
    points
}

fn cube_faces() -> Faces {
    faces(&[&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 4, 6, 2], &[1, 3, 7, 5]])
}

#[test]
fn each_check_in_space_finds_what_it_is_for() {
    let (points, right) = (cube(), cube_faces());
    let check = |faces: &Faces| in_space(&points, &corners(faces), faces);
    assert_eq!(check(&right), [""; 0]);
    assert_eq!(in_space(&points, &corners(&right)[1..], &right), ["vertices"]);
    assert_eq!(in_space(&points, &ids(&[0, 1, 99]), &right), ["vertices"]);
    let with = |change: &dyn Fn(&mut Faces)| {
        let mut faces = right.clone();
        change(&mut faces);
        check(&faces)
    };
    assert_eq!(with(&|faces| faces[0][1] = Vertex::input(0)), ["faces"]);
    assert_eq!(with(&|faces| drop(faces.pop())), ["closed"]);
    assert_eq!(with(&|faces| faces[0].reverse()), ["closed"]);
    assert_eq!(with(&|faces| faces.truncate(2)), ["span"]);
    // The middle of an edge as a corner of both faces there.
    let middle = |faces: &mut Faces| {
        faces[0] = ids(&[0, 2, 3, 1, 9]);
        faces[2] = ids(&[1, 5, 4, 0, 9]);
    };
    assert_eq!(with(&middle), ["extreme"]);
    let halves = |faces: &mut Faces| {
        faces[0] = ids(&[0, 2, 3]);
        faces.push(ids(&[0, 3, 1]));
    };
    assert_eq!(with(&halves), ["coplanar faces"]);
    // The bottom pushed in to the middle of the cube.
    let dent = |faces: &mut Faces| {
        faces[0] = ids(&[0, 2, 8]);
        faces.extend([ids(&[2, 3, 8]), ids(&[3, 1, 8]), ids(&[1, 0, 8])]);
    };
    assert_eq!(with(&dent), ["convex"]);
    assert_eq!(
        with(&|faces| faces.iter_mut().flatten().filter(|v| v.index() == 7).for_each(|v| *v = Vertex::input(11))),
        ["smallest index"]
    );
    let corner = faces(&[&[0, 2, 1], &[0, 1, 4], &[0, 4, 2], &[1, 2, 4]]);
    assert_eq!(check(&corner), ["inside"]);
    // All faces inside out.
    assert_eq!(with(&|faces| faces.iter_mut().for_each(|face| face.reverse())), ["convex"]);
    // A face with four corners that are not coplanar: the cube's top twisted.
    let mut twisted = points.clone();
    twisted[7][2] = 3.0;
    assert!(in_space(&twisted, &corners(&right), &right).contains(&"planar"));
}

#[test]
fn surfaces_that_are_no_sphere_are_found() {
    let tetrahedron = |[a, b, c, d]: [usize; 4]| faces(&[&[a, c, b], &[a, b, d], &[b, c, d], &[a, d, c]]);
    let points: Vec<[f64; 3]> = (0..8).map(f64::from).map(|i| [i, i * i, i * i * i]).collect();
    let check = |faces: &Faces| in_space(&points, &corners(faces), faces);
    let [one, touching, apart] = [[0, 1, 2, 3], [3, 4, 5, 6], [4, 5, 6, 7]].map(tetrahedron);
    assert_eq!(check(&[one.clone(), apart].concat()), ["connected", "euler"]);
    assert_eq!(check(&[one, touching].concat()), ["manifold", "connected", "euler"]);
    // The torus of Möbius and Császár: seven vertices, each two of which share an edge.
    let torus: Faces = (0..7)
        .flat_map(|i| [vec![i, (i + 1) % 7, (i + 3) % 7], vec![i, (i + 3) % 7, (i + 2) % 7]])
        .map(|face| ids(&face))
        .collect();
    assert_eq!(check(&torus), ["euler"]);
}

/// A double pyramid over a pentagon, with its ring traversed in steps.
fn double_pyramid(step: usize) -> (Vec<[f64; 3]>, Faces) {
    let ring = [[-10.0, 3.0], [-6.0, -8.0], [6.0, -8.0], [10.0, 3.0], [0.0, 10.0]];
    let mut points: Vec<[f64; 3]> = ring.iter().map(|[x, y]| [*x, *y, 0.0]).collect();
    points.extend([[0.0, 0.0, 9.0], [0.0, 0.0, -9.0]]);
    let next = |at: usize| (at + step) % 5;
    let all = (0..5).flat_map(|at| [vec![at, next(at), 5], vec![next(at), at, 6]]);
    (points, all.map(|face| ids(&face)).collect())
}

#[test]
fn pyramids_over_a_pentagram_are_wound_twice() {
    let (points, faces) = double_pyramid(1);
    assert_eq!(in_space(&points, &corners(&faces), &faces), [""; 0]);
    // Closed, one surface, V − E + F = 2, and convex at each of its edges.
    let (points, faces) = double_pyramid(2);
    assert_eq!(in_space(&points, &corners(&faces), &faces), ["wound once"]);
}

#[test]
fn faces_that_turn_to_both_sides_are_found() {
    // A prism over an L.
    let l = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    let points: Vec<[f64; 3]> = [0.0, 1.0].iter().flat_map(|z| l.iter().map(move |[x, y]| [*x, *y, *z])).collect();
    let mut prism = faces(&[&[5, 4, 3, 2, 1, 0], &[6, 7, 8, 9, 10, 11]]);
    prism.extend((0..6).map(|i| ids(&[i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6])));
    assert_eq!(in_space(&points, &corners(&prism), &prism), ["face convex", "wound once"]);
    // Bottom and top both turn back at one corner.
    let scene = Scene::from_points3(&points).unwrap();
    let flaws = space_flaws(signs(&Judged::exact(&scene), None), &corners(&prism), &prism);
    assert_eq!(flaws.iter().map(|flaw| flaw.places).collect::<Vec<_>>(), [2, 2]);
}

/// Projected along their line's axis, all these points are in one place.
#[test]
fn lines_in_space_are_seen_where_they_are_no_point() {
    for axis in 0..3 {
        let point = |x: f64| [0, 1, 2].map(|other| if other == axis { x } else { 7.0 });
        let points = [1.0, 0.0, 3.0, 2.0].map(point);
        let none = Faces::new();
        assert_eq!(in_space(&points, &ids(&[1, 2]), &none), [""; 0], "{axis}");
        for wrong in [[0, 1], [0, 2], [2, 3]] {
            assert_eq!(in_space(&points, &ids(&wrong), &none), ["inside"], "{axis}: {wrong:?}");
        }
        assert_eq!(in_space(&points, &ids(&[1]), &none), ["span"], "{axis}");
        assert_eq!(in_space(&[points[0]; 3], &ids(&[0]), &none), [""; 0]);
    }
}

#[test]
fn flat_hulls_are_two_faces() {
    let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 2.0], [2.0, 2.0, 4.0], [0.0, 2.0, 2.0], [1.0, 1.0, 2.0], [1.0, 0.0, 1.0]];
    let check = |faces: &Faces| in_space(&points, &corners(faces), faces);
    assert_eq!(check(&faces(&[&[0, 1, 2, 3], &[3, 2, 1, 0]])), [""; 0]);
    assert_eq!(check(&faces(&[&[0, 1, 2], &[2, 1, 0]])), ["inside"]);
    assert_eq!(check(&faces(&[&[0, 5, 1, 2, 3], &[3, 2, 1, 5, 0]])), ["extreme"]);
    assert_eq!(in_space(&points, &ids(&[0, 1, 2, 3]), &Faces::new()), ["vertices", "two faces"]);
    assert_eq!(in_space(&points[..2], &ids(&[0, 1]), &faces(&[&[0, 1, 0]])), ["two faces"]);
    assert_eq!(in_space(&points[..2], &ids(&[0]), &Faces::new()), ["span"]);
}

/// The judge's perturbation: the smaller the index of a vertex, the larger its displacement.
fn ties() -> Box<TieJudge> {
    Box::new(|scene: &Scene, question: Question, args: &[Vertex]| {
        predicament_sos::infinitesimal::judge(predicament_sos::Scheme::PerCoordinate, scene, question, args)
    })
}

#[test]
fn ties_are_decided_where_they_are_broken() {
    let ties = ties();
    let scene = Scene::from_points3(&cube()).unwrap();
    let (exact, perturbed) = (Judged::exact(&scene), Judged::perturbed(&scene, &ties));
    let hull = hull3d(&perturbed, SpaceMethod::Incremental);
    let check = |faces: &Faces| -> Vec<&str> {
        let flaws = space_flaws(signs(&exact, Some(&perturbed)), &corners(faces), faces);
        flaws.iter().map(|flaw| flaw.check).collect()
    };
    assert_eq!(check(&hull.faces), [""; 0]);
    // The other diagonal of two coplanar triangles is the edge of a dent.
    let mut flipped = hull.faces.clone();
    let pair = (0..flipped.len()).flat_map(|i| (0..i).map(move |j| [i, j])).find_map(|[i, j]| {
        let [f, g] = [&hull.faces[i], &hull.faces[j]];
        let own = f.iter().position(|v| !g.contains(v))?;
        let other = *g.iter().find(|v| !f.contains(v))?;
        let [a, b, c] = [f[own], f[(own + 1) % 3], f[(own + 2) % 3]];
        let is_edge = g.contains(&b) && g.contains(&c);
        (is_edge && exact.orient3d(a, b, c, other) == Sign::Zero).then_some((i, j, [a, b, other], [a, other, c]))
    });
    let (i, j, one, two) = pair.expect("the cube's faces are two triangles or more");
    flipped[i] = one.to_vec();
    flipped[j] = two.to_vec();
    assert_eq!(check(&flipped), ["convex", "inside"]);

    let line: Vec<[f64; 2]> = (0..4).map(|i| [f64::from(i), 0.0]).collect();
    let scene = Scene::from_points2(&line).unwrap();
    let (exact, perturbed) = (Judged::exact(&scene), Judged::perturbed(&scene, &ties));
    let hull =
        predicament_hull::algorithm::hull2d(&perturbed, predicament_hull::algorithm::PlaneMethod::Chain).vertices;
    let check = |hull: &[Vertex]| -> Vec<&str> {
        plane_flaws(signs(&exact, Some(&perturbed)), hull).iter().map(|flaw| flaw.check).collect()
    };
    assert_eq!(check(&hull), [""; 0]);
    let mut back = hull.clone();
    back[1..].reverse();
    assert!(check(&back).contains(&"convex"));
}

#[test]
fn two_perturbed_points_are_both_of_their_hull() {
    let ties = ties();
    let scene = Scene::from_points3(&[[0.0; 3], [0.0; 3]]).unwrap();
    let (exact, perturbed) = (Judged::exact(&scene), Judged::perturbed(&scene, &ties));
    let check = |vertices: &[usize]| -> Vec<&str> {
        let flaws = space_flaws(signs(&exact, Some(&perturbed)), &ids(vertices), &[]);
        flaws.iter().map(|flaw| flaw.check).collect()
    };
    assert_eq!(check(&[0, 1]), [""; 0]);
    assert_eq!(check(&[0]), ["span"]);
}
