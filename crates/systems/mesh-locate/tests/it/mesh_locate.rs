//! Tests of points in meshes: by exact signs, by broken ties, along all axes, against the judge's crossing sums.

use std::collections::BTreeSet;

use predicament_exact::Exact;
use predicament_grid::two_level::Sizes;
use predicament_judge::Judged;
use predicament_judge::solids::{Materials, Place};
use predicament_mesh::MaterialMesh;
use predicament_mesh_locate::algorithm::{Location, MeshIndex, Ray, Scratch, locate_all, question_all};
use predicament_predicates::{Backend, Off, Predicates, Question, Scene, Sign, Vertex, forward_to};
use predicament_sos::{PerMesh, Sos};
use predicament_tolerance::Tolerance;
use proptest::prelude::*;

/// A session that forbids algorithms all shortcuts.
struct Forbidding<P> {
    session: P,
}

impl Predicates for Forbidding<&dyn Predicates> {
    fn allows(&self, _: &str) -> bool {
        false
    }

    forward_to!(session: scene, predicates);
}

/// Tetrahedra over points.
#[derive(Clone, Default, Debug)]
struct Solids {
    points: Vec<[f64; 3]>,
    tetrahedra: Vec<[usize; 4]>,
}

/// A lattice of unit cubes with the given number along each axis; six tetrahedra along the diagonal make each cube.
fn lattice([nx, ny, nz]: [usize; 3]) -> Solids {
    let mut solids = Solids::default();
    let at = |x: usize, y: usize, z: usize| (x * (ny + 1) + y) * (nz + 1) + z;
    for x in 0..=nx {
        for y in 0..=ny {
            for z in 0..=nz {
                solids.points.push([x, y, z].map(|i| f64::from(u32::try_from(i).unwrap())));
            }
        }
    }
    for x in 0..nx {
        for y in 0..ny {
            for z in 0..nz {
                for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]] {
                    let mut corner = [x, y, z];
                    let mut corners = vec![at(x, y, z)];
                    for axis in order {
                        corner[axis] += 1;
                        corners.push(at(corner[0], corner[1], corner[2]));
                    }
                    solids.tetrahedra.push(corners.try_into().unwrap());
                }
            }
        }
    }
    solids
}

/// Tetrahedra one above the other, each at any position in its own layer, sheared so that their boxes overlap.
fn layers(corners: &[[[i32; 3]; 4]], [sx, sy]: [i32; 2]) -> Solids {
    let mut solids = Solids::default();
    // One tetrahedron that has a volume in any case.
    let solid = [[0, 0, 0], [7, 0, 0], [0, 7, 0], [0, 0, 7]];
    for (layer, corners) in (0..).zip(corners.iter().chain([&solid])) {
        let first = solids.points.len();
        for [x, y, z] in corners {
            solids.points.push([*x, *y, z + 9 * layer + sx * x + sy * y].map(f64::from));
        }
        solids.tetrahedra.push([first, first + 1, first + 2, first + 3]);
    }
    solids
}

impl Solids {
    /// The scene of the points and queries, the mesh, and the queries. Tetrahedra without volume are left out.
    fn scene(&self, queries: &[[f64; 3]]) -> (Scene, MaterialMesh, Vec<Vertex>) {
        let points = [&self.points[..], queries].concat();
        let scene = Scene::from_points3(&points).unwrap();
        let mut tetrahedra = Vec::new();
        for corners in &self.tetrahedra {
            let [a, b, c, d] = corners.map(Vertex::input);
            match predicament_judge::sign(&scene, Question::Orient3d, &[a, b, c, d]) {
                Sign::Positive => tetrahedra.push([a, b, c, d]),
                Sign::Negative => tetrahedra.push([b, a, c, d]),
                Sign::Zero => {}
            }
        }
        let mesh = MaterialMesh::of_tetrahedra(self.points.len(), &tetrahedra).unwrap();
        let queries: Vec<Vertex> = (self.points.len()..points.len()).map(Vertex::input).collect();
        let scene = scene.with_second_mesh(queries.iter().copied());
        (scene, mesh, queries)
    }

    /// Points with ties: corners, midpoints, centres, and points straight above, below and next to them.
    fn queries(&self) -> Vec<[f64; 3]> {
        let mut queries = self.points.clone();
        for corners in &self.tetrahedra {
            let points = corners.map(|v| self.points[v]);
            for (i, j) in [(0, 1), (0, 3), (1, 2), (2, 3)] {
                queries.push([0, 1, 2].map(|axis: usize| f64::midpoint(points[i][axis], points[j][axis])));
            }
            queries.push([0, 1, 2].map(|axis: usize| points.iter().map(|p| p[axis]).sum::<f64>() / 4.0));
        }
        let near: Vec<[f64; 3]> = queries
            .iter()
            .flat_map(|&[x, y, z]| [[x, y, z.next_up()], [x, y, z - 0.25], [x.next_down(), y, z], [x, y + 0.125, z]])
            .collect();
        queries.extend(near);
        queries
    }
}

/// Compares all methods of location with each other and with the judge.
fn agrees(solids: &Solids, queries: &[[f64; 3]]) {
    let (scene, mesh, vertices) = solids.scene(queries);
    let index = MeshIndex::new(mesh, &scene);
    let judge = Materials::new(&scene, index.mesh().triangles(), index.mesh().sides());
    let places: Vec<Place> = vertices.iter().map(|&q| judge.locate(q)).collect();
    let exact = Exact.prepare(&scene, Off).unwrap();
    let by_truth = |location: &Location, place: &Place| match (location, place) {
        (Location::In(region), Place::In(truth)) => region == truth,
        (Location::On(triangle), Place::On(triangles)) => *triangle == triangles[0],
        _ => false,
    };
    let answers = all_ways(&index, &exact, &vertices);
    for (at, (answer, place)) in answers.iter().zip(&places).enumerate() {
        assert!(by_truth(answer, place), "{:?}: {answer:?}, {place:?}", queries[at]);
    }
    assert_eq!(answers, all_ways(&index, &Judged::exact(&scene), &vertices));
    let on_surface = |triangle: &u32| index.mesh().sides()[*triangle as usize];
    let perturbed = |session: &dyn Predicates| {
        for (at, (answer, place)) in all_ways(&index, session, &vertices).iter().zip(&places).enumerate() {
            let is_legal = match (answer, place) {
                (Location::In(region), Place::On(triangles)) => {
                    triangles.iter().flat_map(on_surface).any(|of| of == *region)
                }
                _ => by_truth(answer, place),
            };
            assert!(is_legal, "{:?}: {answer:?}, {place:?}", queries[at]);
        }
    };
    perturbed(&Sos::default().prepare(&scene, Off).unwrap());
    perturbed(&PerMesh.prepare(&scene, Off).unwrap());
}

/// The answers, after a check that all methods agree.
fn all_ways(index: &MeshIndex, session: &dyn Predicates, queries: &[Vertex]) -> Vec<Location> {
    let answers = locate_all(index, session, queries, &|_| true);
    for ray in Ray::ALL {
        let asked = question_all(index, session, queries, &[ray], &|_| true);
        for (at, (answer, asked)) in answers.iter().zip(&asked).enumerate() {
            let point = session.scene().point3(queries[at]);
            assert_eq!(answer, asked, "{point:?} by {ray:?}");
        }
    }
    answers
}

#[test]
fn points_of_a_lattice_of_tetrahedra_are_in_one_each() {
    let solids = lattice([2, 1, 2]);
    agrees(&solids, &solids.queries());
}

/// A corner of one tetrahedron in a face, or on an edge, of another: a moved vertex is in either, or between them.
#[test]
fn corners_that_touch_other_triangles_are_located_by_all_that_touch() {
    // Along x, y and z in turn, from either side.
    for turn in 0..6 {
        let turned = |[x, y, z]: [f64; 3]| {
            let mut p = if turn < 3 { [x, y, z] } else { [-x, y, z] };
            p.rotate_right(turn % 3);
            p
        };
        for [y, z] in [[2.0, 1.0], [0.0, 2.0], [4.0, 4.0]] {
            let below = [[0.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, 0.0, 8.0], [-8.0, 1.0, 1.0]];
            let above = [[0.0, y, z], [1.0, y + 4.0, z], [1.0, y, z + 4.0], [1.0, y - 1.0, z - 1.0]];
            let points: Vec<[f64; 3]> = below.into_iter().chain(above).map(turned).collect();
            let solids = Solids { points, tetrahedra: vec![[0, 1, 2, 3], [4, 5, 6, 7]] };
            let (scene, mesh, queries) = solids.scene(&solids.points);
            all_ways(&MeshIndex::new(mesh, &scene), &PerMesh.prepare(&scene, Off).unwrap(), &queries);
        }
    }
}

#[test]
fn boxes_in_each_other_have_labels_for_what_is_between() {
    // Nested boxes around the origin; each region lies between a box and the next.
    let mut points = Vec::new();
    let (mut triangles, mut sides) = (Vec::new(), Vec::new());
    let sizes: Vec<f64> = (1..=12).rev().map(|size| f64::from(size) * 4.0).collect();
    for (region, &half) in (1..).zip(&sizes) {
        let first = points.len();
        for corner in 0..8 {
            points.push([0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { -half } else { half }));
        }
        for [a, b, c, d] in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            triangles
                .extend([[a, b, c], [a, c, d]].map(|corners: [usize; 3]| corners.map(|at| Vertex::input(first + at))));
            sides.extend([[region - 1, region]; 2]);
        }
    }
    let vertices = points.len();
    // Points on lines through corners and edges, in faces, and between them.
    let steps = [-50.0, -48.0, -46.5, -33.5, -32.0, -0.0, 0.0, 2.0, 4.0, 7.0, 20.0, 21.0, 48.0, 49.0];
    let mut expected = Vec::new();
    for x in steps {
        for y in steps {
            for z in steps {
                points.push([x, y, z]);
                let out = [x, y, z].map(f64::abs).into_iter().fold(0.0, f64::max);
                expected.push(if sizes.contains(&out) {
                    None
                } else {
                    Some(sizes.iter().filter(|&&size| size > out).count())
                });
            }
        }
    }
    let scene = Scene::from_points3(&points).unwrap();
    let mesh = MaterialMesh::new(vertices, triangles, sides).unwrap();
    let index = MeshIndex::with_sizes(mesh, &scene, Some(Sizes { coarse: [32; 3], fine: 2, full: 2 }));
    assert!(index.references().len() > 10, "{}", index.references().len());
    let queries: Vec<Vertex> = (vertices..points.len()).map(Vertex::input).collect();
    let session = Exact.prepare(&scene, Off).unwrap();
    for (answer, expected) in all_ways(&index, &session, &queries).iter().zip(&expected) {
        match (answer, expected) {
            (Location::In(region), Some(expected)) => assert_eq!(*region as usize, *expected),
            (Location::On(_), None) => {}
            other => panic!("{other:?}"),
        }
    }
    // Labels by points that the grid chooses.
    let references = index.references();
    let with = Scene::from_points3(&[&points[..], &references[..]].concat()).unwrap();
    let session = Exact.prepare(&with, Off).unwrap();
    let references: Vec<Vertex> = (points.len()..with.len()).map(Vertex::input).collect();
    let labels = index.labels(&session, &references);
    let without = index.labels(&Forbidding { session: &session as &dyn Predicates }, &references);
    assert_ne!(labels, without, "a session can forbid labels");
    let mut scratch = Scratch::new();
    let mut regions: BTreeSet<usize> = BTreeSet::new();
    for (&q, expected) in queries.iter().zip(&expected) {
        let answer = index.locate(&session, &labels, q, &mut scratch);
        assert_eq!(answer, index.question(&session, q, Ray::UP, &mut scratch));
        assert_eq!(answer, index.locate(&session, &without, q, &mut scratch));
        regions.extend(expected);
    }
    assert!(regions.len() > 5);
}

#[test]
fn faces_at_one_place_are_passed_together() {
    // A tetrahedron, and over it a sheet: two faces on the same vertices, with opposite directions, in both orders.
    let points =
        [[0., 0., 0.], [8., 0., 0.], [0., 8., 0.], [0., 0., 8.], [-1., -1., 9.], [20., -1., 9.5], [-1., 20., 10.]];
    let queries = [[1., 1., 1.], [1., 1., -1.], [1., 1., 7.], [1., 1., 8.5], [1., 1., 20.], [0., 0., 1.], [2., 2., 9.]];
    let scene = Scene::from_points3(&[&points[..], &queries[..]].concat()).unwrap();
    let queries: Vec<Vertex> = (points.len()..scene.len()).map(Vertex::input).collect();
    let scene = scene.with_second_mesh(queries.iter().copied());
    let solid = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    for sheet in [[[4, 5, 6], [5, 4, 6]], [[5, 4, 6], [4, 5, 6]]] {
        let triangles: Vec<[Vertex; 3]> =
            sheet.iter().chain(&solid).map(|corners| corners.map(Vertex::input)).collect();
        let index = MeshIndex::new(MaterialMesh::of_closed(points.len(), triangles).unwrap(), &scene);
        let exact = Exact.prepare(&scene, Off).unwrap();
        let outside = Location::In(0);
        let expected = [Location::In(1), outside, outside, outside, outside, Location::On(3), outside];
        assert_eq!(all_ways(&index, &exact, &queries), expected);
        let sos = Sos::default();
        let [first, ..] = all_ways(&index, &sos.prepare(&scene, Off).unwrap(), &queries)[..] else { panic!() };
        assert_eq!(first, Location::In(1));
        all_ways(&index, &PerMesh.prepare(&scene, Off).unwrap(), &queries);
    }
}

/// Tests a triangle without area: all points of its line are in its plane and in line with its edges, but only points
/// in its box are on it. Tested along each axis, upright and slanted.
#[test]
fn a_triangle_without_area_has_the_points_between_its_corners_only() {
    // A tetrahedron; between two of its faces, at the edge from corner 0 to corner 3, a triangle with the edge's
    // midpoint.
    let triangles = [[0, 2, 1], [0, 1, 4], [4, 1, 3], [1, 2, 3], [2, 0, 3], [0, 4, 3]];
    let upright = [[0., 0., 0.], [8., 0., 0.], [0., 8., 0.], [0., 0., 8.], [0., 0., 4.]];
    let slanted = [[0., 0., 0.], [8., 0., 0.], [0., 8., 0.], [-4., -2., 8.], [-2., -1., 4.]];
    let steps = [-4., -2., -1., 0., 2., 4., 6., 8., 12.];
    let mut found = BTreeSet::new();
    for corners in [upright, slanted] {
        let [x, y, z] = corners[4];
        let line = steps.map(|step| [x / 4. * step, y / 4. * step, z / 4. * step]);
        // Points beside the line, but in the box, and over and under the line as seen along some axis.
        let beside = line.map(|[x, y, z]| [[x, y, z - 1.], [x - 0.25, y, z], [x, y - 0.25, z], [x, y, z + 0.5]]);
        let queries = [&line[..], beside.as_flattened()].concat();
        for turn in 0..3 {
            let turned = |points: &[[f64; 3]]| -> Vec<[f64; 3]> {
                points.iter().map(|p| [0, 1, 2].map(|axis: usize| p[(axis + turn) % 3])).collect()
            };
            let scene = Scene::from_points3(&turned(&[&corners[..], &queries].concat())).unwrap();
            let triangles = triangles.map(|corners| corners.map(Vertex::input)).to_vec();
            let index = MeshIndex::new(MaterialMesh::of_closed(5, triangles).unwrap(), &scene);
            let judge = Materials::new(&scene, index.mesh().triangles(), index.mesh().sides());
            let vertices: Vec<Vertex> = (5..scene.len()).map(Vertex::input).collect();
            for session in [&Exact.prepare(&scene, Off).unwrap() as &dyn Predicates, &Judged::exact(&scene)] {
                for (&q, answer) in vertices.iter().zip(all_ways(&index, session, &vertices)) {
                    let truth = match judge.locate(q) {
                        Place::In(region) => Location::In(region),
                        Place::On(triangles) => Location::On(triangles[0]),
                        Place::Windings(windings) => panic!("{windings:?}"),
                    };
                    assert_eq!(answer, truth, "{:?}", scene.point3(q));
                    found.insert(answer);
                }
            }
        }
    }
    assert!(found.contains(&Location::In(0)) && found.contains(&Location::In(1)) && found.len() > 4, "{found:?}");
}

#[test]
fn a_mesh_at_one_place_has_no_moved_points() {
    let triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]].map(|corners| corners.map(Vertex::input));
    let points = [[1.0; 3], [1.0; 3], [1.0; 3], [1.0; 3], [1.0; 3], [1.0, 1.0, 0.0], [2.0, 1.0, 1.0]];
    let queries = [4, 5, 6].map(Vertex::input);
    let scene = Scene::from_points3(&points).unwrap().with_second_mesh(queries);
    let index = MeshIndex::new(MaterialMesh::of_closed(4, triangles.to_vec()).unwrap(), &scene);
    let at = |session: &dyn Predicates| all_ways(&index, session, &queries);
    assert_eq!(at(&Exact.prepare(&scene, Off).unwrap()), [Location::On(0), Location::In(0), Location::In(0)]);
    assert_eq!(at(&PerMesh.prepare(&scene, Off).unwrap()), [Location::In(0); 3]);
}

#[test]
fn a_surface_that_crosses_itself_is_told_as_a_contradiction_by_sums() {
    // Two overlapping boxes, both region 1.
    let mut points = Vec::new();
    let mut triangles = Vec::new();
    for shift in [0.0, 1.0] {
        let first = points.len();
        for corner in 0..8 {
            points.push([0, 1, 2].map(|axis| shift + if corner >> axis & 1 == 0 { 0.0 } else { 2.0 }));
        }
        for [a, b, c, d] in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            triangles
                .extend([[a, b, c], [a, c, d]].map(|corners: [usize; 3]| corners.map(|at| Vertex::input(first + at))));
        }
    }
    points.extend([[0.5; 3], [1.5; 3], [2.5; 3], [3.5; 3]]);
    let scene = Scene::from_points3(&points).unwrap();
    let index = MeshIndex::new(MaterialMesh::of_closed(16, triangles).unwrap(), &scene);
    let session = Exact.prepare(&scene, Off).unwrap();
    let queries = [16, 17, 18, 19].map(Vertex::input);
    for ray in Ray::ALL {
        let answers = question_all(&index, &session, &queries, &[ray], &|_| true);
        assert_eq!(answers, [Location::In(1), Location::Contradiction, Location::In(1), Location::In(0)]);
    }
    let judge = Materials::new(&scene, index.mesh().triangles(), index.mesh().sides());
    assert_eq!(judge.locate(queries[1]), Place::Windings(vec![(0, -1), (1, 2)]));
}

/// Checks the answers of a tolerance backend; returns the numbers of points in a region, on the mesh and undecided.
fn registered(solids: &Solids, queries: &[[f64; 3]]) -> [usize; 3] {
    let (scene, mesh, vertices) = solids.scene(queries);
    let index = MeshIndex::new(mesh, &scene);
    let judge = Materials::new(&scene, index.mesh().triangles(), index.mesh().sides());
    let session = Tolerance.prepare(&scene, Off).unwrap();
    let ways: Vec<Vec<Ray>> = Ray::ALL.iter().map(|&ray| vec![ray]).chain([Ray::ALL.to_vec()]).collect();
    let located = locate_all(&index, &session, &vertices, &|_| true);
    let asked = ways.iter().map(|rays| question_all(&index, &session, &vertices, rays, &|_| true));
    let answers: Vec<Vec<Location>> = asked.chain([located]).collect();
    assert_eq!(answers[ways.len() - 1], answers[ways.len()], "users get what is judged");
    for (at, &q) in vertices.iter().enumerate() {
        let place = judge.locate(q);
        for answer in answers.iter().map(|all| all[at]) {
            let is_legal = match (answer, &place) {
                (Location::In(region), Place::In(truth)) => region == *truth,
                // On all triangles that contain it, and the first triangle with the point in its band.
                (Location::On(triangle), Place::On(triangles)) => triangle <= triangles[0],
                (Location::On(triangle), Place::In(_)) => {
                    is_beside(&scene, index.mesh().triangles()[triangle as usize], q)
                }
                (Location::Undecided, Place::In(_)) => true,
                _ => false,
            };
            assert!(is_legal, "{:?}: {answer:?}, {place:?}", queries[at]);
        }
    }
    let count = |is: fn(&Location) -> bool| answers[ways.len()].iter().filter(|answer| is(answer)).count();
    [
        count(|at| matches!(at, Location::In(_))),
        count(|at| matches!(at, Location::On(_))),
        count(|at| *at == Location::Undecided),
    ]
}

/// True if a point is in the box of a triangle, with a margin of a millionth.
fn is_beside(scene: &Scene, corners: [Vertex; 3], q: Vertex) -> bool {
    (0..3).all(|axis| {
        let along = corners.map(|v| scene.point3(v)[axis]);
        let x = scene.point3(q)[axis];
        !along.iter().all(|end| x < end - 1e-6) && !along.iter().all(|end| x > end + 1e-6)
    })
}

#[test]
fn zeros_within_a_band_put_no_point_into_another_region() {
    // If it counted as an exact zero, the sign of the edge from 0 to 1 would move the upward ray to the wrong side of
    // the edge.
    let solids = Solids {
        points: vec![[0., -f64::EPSILON * 16., 0.], [1., 0., 0.], [0., 0., 1.], [0., 1., 0.]],
        tetrahedra: vec![[0, 1, 2, 3]],
    };
    assert_eq!(registered(&solids, &[[0., 0., -1.]]), [1, 0, 0]);
    let [within, on, _] = registered(&solids, &solids.queries());
    assert!(within > 5 && on > 5);
}

#[test]
fn a_zero_of_a_small_or_steep_triangle_is_no_place_on_it() {
    // A point far from a triangle, but in line with all its edges within the scene's tolerance.
    let solids = Solids {
        points: vec![
            [0., 0., 0.],
            [1e-9, 0., 0.],
            [0., 1e-9, 0.],
            [0., 0., 1e-9],
            [4., 0., 0.],
            [4., 4., 0.],
            [4., 0., 4.],
            [5., 0., 0.],
        ],
        tetrahedra: vec![[0, 1, 2, 3], [4, 5, 6, 7]],
    };
    let [within, on, undecided] =
        registered(&solids, &[[1e-10, 1e-10, 2.], [1., 1e-10, 1e-10], [2e-10, 2e-10, 1e-10], [3., 3., 3.]]);
    assert_eq!([within, on, undecided], [3, 1, 0]);
}

#[test]
fn answers_are_the_same_on_any_number_of_threads_and_end_where_they_are_told() {
    let solids = lattice([6, 6, 6]);
    let points: Vec<[f64; 3]> = solids.queries().into_iter().cycle().take(9_000).collect();
    let (scene, mesh, queries) = solids.scene(&points);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let index = MeshIndex::new(mesh.clone(), &scene);
            let session = Sos::default();
            let session = session.prepare(&scene, Off).unwrap();
            (
                locate_all(&index, &session, &queries, &|_| true),
                locate_all(&index, &session, &queries, &|done| done < 5_000),
            )
        })
    };
    let (all, stopped) = on(1);
    assert_eq!((all.len(), stopped.len()), (9_000, 8_192));
    assert_eq!(on(3).0, all);
}

fn solids() -> impl Strategy<Value = Solids> {
    let corner = prop::array::uniform3(0..8_i32);
    let layer = prop::array::uniform4(corner);
    let layers = (prop::collection::vec(layer, 1..8), prop::array::uniform2(-4..5_i32))
        .prop_map(|(corners, shear)| layers(&corners, shear));
    let jitter = prop::array::uniform3(-0.0625..0.0625_f64);
    let lattices = (prop::array::uniform3(1..3_usize), prop::collection::vec(jitter, 27)).prop_map(|(size, jitter)| {
        let mut solids = lattice(size);
        for (point, jitter) in solids.points.iter_mut().zip(jitter) {
            *point = [0, 1, 2].map(|axis: usize| point[axis] + jitter[axis]);
        }
        solids
    });
    prop_oneof![3 => layers, 1 => lattices]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(10, 500)))]

    #[test]
    fn tetrahedra_in_layers_and_lattices(solids in solids(), more in prop::collection::vec(prop::array::uniform3(-1.0..9.0_f64), 0..40)) {
        let mut queries = solids.queries();
        queries.extend(more);
        agrees(&solids, &queries);
    }

}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(4, 500)))]

    /// Tests points of a lattice, moved by about a tolerance.
    #[test]
    fn lattices_with_noise_are_answered_within_bands(size in prop::array::uniform3(1..3_usize), noise in prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), 27), power in 30..54_i32) {
        let mut solids = lattice(size);
        for (point, noise) in solids.points.iter_mut().zip(noise) {
            *point = [0, 1, 2].map(|axis: usize| point[axis] + noise[axis] * 2f64.powi(-power));
        }
        let mut queries = lattice(size).queries();
        queries.extend(solids.queries());
        queries.extend([[0.3, 0.4, 0.6], [-1.0, 0.5, 0.5], [0.5, 0.5, -1.0], [0.0, 0.0, -1.0]]);
        registered(&solids, &queries);
    }
}
