//! Solids with rational corners or points: the fast computations against the computations for scenes, and against
//! definitions.

use predicament_judge::rational;
use predicament_judge::solids::{Boundary, Materials, Place};
use predicament_predicates::{Scene, Vertex};
use rug::Rational;

use crate::random::{Random, effort};

/// A tetrahedron with small integer corners and a volume, counterclockwise as seen from outside.
fn tetrahedron(random: &mut Random, end: usize) -> Option<[[i64; 3]; 4]> {
    let mut point = || [(); 3].map(|()| i64::try_from(random.below(end)).unwrap());
    let [a, b, c, d] = [(); 4].map(|()| point());
    match height([a, b, c], d) {
        0 => None,
        1.. => Some([a, b, c, d]),
        _ => Some([b, a, c, d]),
    }
}

const FACES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

fn less(p: [i64; 3], q: [i64; 3]) -> [i64; 3] {
    [0, 1, 2].map(|axis: usize| p[axis] - q[axis])
}

fn normal([a, b, c]: [[i64; 3]; 3]) -> [i64; 3] {
    let (u, v) = (less(b, a), less(c, a));
    [(1, 2), (2, 0), (0, 1)].map(|(j, k): (usize, usize)| u[j] * v[k] - u[k] * v[j])
}

fn dot(p: [i64; 3], q: [i64; 3]) -> i64 {
    (0..3).map(|axis| p[axis] * q[axis]).sum()
}

/// The scaled height of `q` above a triangle, positive on the side where it appears counterclockwise.
fn height(triangle: [[i64; 3]; 3], q: [i64; 3]) -> i64 {
    dot(normal(triangle), less(q, triangle[0]))
}

fn double(x: i64) -> f64 {
    f64::from(i32::try_from(x).unwrap())
}

/// A point over a denominator.
fn over(p: [i64; 3], denominator: u32) -> [Rational; 3] {
    p.map(|x| Rational::from((x, denominator)))
}

fn of(corners: [[i64; 3]; 4]) -> [[[i64; 3]; 3]; 4] {
    FACES.map(|face| face.map(|corner| corners[corner as usize]))
}

#[test]
fn windings_of_rational_solids_are_one_inside_and_zero_outside() {
    let mut random = Random::new(32);
    let (mut inside, mut outside, mut unknown) = (0_usize, 0_usize, 0_usize);
    for _ in 0..300 * effort() {
        let Some(corners) = tetrahedron(&mut random, 13) else { continue };
        for denominator in [1_u32, 3, 7] {
            let points = corners.map(|p| over(p, denominator)).to_vec();
            let boundary = Boundary::new(points.clone(), FACES.to_vec());
            // The same surface seen from inside has the negated winding number.
            let reversed = Boundary::new(points, FACES.map(|[a, b, c]| [a, c, b]).to_vec());
            for _ in 0..8 {
                // Quarters, in the box of the solid or next to it; 4 times the point and the denominator are integers.
                let q = [(); 3].map(|()| i64::try_from(random.below(1 + 48 / denominator as usize)).unwrap());
                let scaled = q.map(|x| x * i64::from(denominator));
                let heights = of(corners.map(|p| p.map(|x| 4 * x))).map(|face| height(face, scaled));
                let q = q.map(|x| double(x) / 4.0);
                let by_definition = i64::from(heights.iter().all(|&height| height < 0));
                let is_on = !heights.iter().any(|&height| height > 0) && heights.contains(&0);
                let found = boundary.winding(q);
                assert_eq!(reversed.winding(q), found.map(|winding| -winding), "{corners:?} {q:?}");
                match found {
                    None => unknown += 1,
                    Some(_) if is_on => panic!("{q:?} is on the surface of {corners:?} over {denominator}"),
                    Some(winding) => {
                        assert_eq!(winding, by_definition, "{corners:?} over {denominator}: {q:?}");
                        inside += usize::from(winding == 1);
                        outside += usize::from(winding == 0);
                    }
                }
            }
        }
    }
    assert!(inside > 60 && outside > 1000 && unknown > 20, "{inside} inside, {outside} outside, {unknown} unknown");
    assert!(unknown < outside / 4, "{unknown} of {outside} are not told");
}

#[test]
fn near_a_surface_is_near_a_plane_and_within_the_box() {
    let mut random = Random::new(33);
    let mut counts = [0_usize; 2];
    for _ in 0..400 * effort() {
        let Some(corners) = tetrahedron(&mut random, 9) else { continue };
        let triangle = of(corners)[0];
        let boundary = Boundary::new(triangle.map(|p| over(p, 1)).to_vec(), vec![[0, 1, 2]]);
        for _ in 0..8 {
            let q = [(); 3].map(|()| i64::try_from(random.below(15)).unwrap() - 3);
            let distance = i64::try_from(random.below(5)).unwrap();
            let is_in_box = (0..3).all(|axis| {
                let along = triangle.map(|corner| corner[axis]);
                let (low, high) = (along.into_iter().min().unwrap(), along.into_iter().max().unwrap());
                low - distance <= q[axis] && q[axis] <= high + distance
            });
            let length = dot(normal(triangle), normal(triangle));
            let expected = is_in_box && height(triangle, q).pow(2) <= distance.pow(2) * length;
            assert_eq!(boundary.is_near(q.map(double), double(distance)), expected, "{triangle:?} {q:?} {distance}");
            counts[usize::from(expected)] += 1;
        }
    }
    assert!(counts.iter().all(|&count| count > 200), "{counts:?}");
}

/// Integer rays against the same rays in rationals, in a scene of three times the size.
#[test]
fn points_in_thirds_are_where_they_are_in_a_mesh_of_three_times_the_size() {
    let mut random = Random::new(34);
    let mut found = [0_usize; 4];
    for _ in 0..60 * effort() {
        let Some(first) = tetrahedron(&mut random, 6) else { continue };
        let Some(second) = tetrahedron(&mut random, 6) else { continue };
        let corners = [first, second].concat();
        let triangles: Vec<[Vertex; 3]> = (0..2)
            .flat_map(|of| FACES.map(|face| face.map(|corner| Vertex::input(4 * of + corner as usize))))
            .collect();
        let sides = [[[0, 1]; 4], [[1, 2]; 4]].concat();
        let probes: Vec<[i64; 3]> =
            (0..12).map(|_| [(); 3].map(|()| i64::try_from(random.below(16)).unwrap())).collect();
        let points = corners.iter().map(|p| p.map(|x| double(3 * x))).chain(probes.iter().map(|p| p.map(double)));
        let large = Scene::from_points3(&points.collect::<Vec<_>>()).unwrap();
        let small = Scene::from_points3(&corners.iter().map(|p| p.map(double)).collect::<Vec<_>>()).unwrap();
        let (in_large, in_small) =
            (Materials::new(&large, &triangles, &sides), Materials::new(&small, &triangles, &sides));
        let in_integers = in_small.in_integers();
        for (at, &probe) in probes.iter().enumerate() {
            let q = over(probe, 3);
            let direction = [(); 3].map(|()| i32::try_from(random.below(9)).unwrap() - 4);
            if direction == [0; 3] {
                continue;
            }
            let place = in_integers.winding(&q, direction);
            assert_eq!(place, in_large.winding(Vertex::input(8 + at), direction), "{corners:?} {probe:?} / 3");
            if let Some(place) = &place {
                assert_eq!(*place, in_large.locate(Vertex::input(8 + at)), "{corners:?} {probe:?} / 3");
            }
            found[match place {
                None => 0,
                Some(Place::On(_)) => 1,
                Some(Place::In(_)) => 2,
                Some(Place::Windings(_)) => 3,
            }] += 1;
        }
    }
    assert!(found.iter().all(|&count| count > 10), "{found:?}");
}

#[test]
fn what_is_beside_a_point_of_triangles_is_where_one_comes_by_a_small_step() {
    // Less than the distance of a vertex from a plane that does not contain it: heights are integers over 6 · 1,200 at
    // most.
    let step = rational(2f64.powi(-40));
    let mut random = Random::new(35);
    let (mut told, mut fronts) = (0_usize, 0_usize);
    for _ in 0..80 * effort() {
        let Some(first) = tetrahedron(&mut random, 7) else { continue };
        let Some(second) = tetrahedron(&mut random, 7) else { continue };
        let corners = [first, second].concat();
        let scene = Scene::from_points3(&corners.iter().map(|p| p.map(double)).collect::<Vec<_>>()).unwrap();
        let triangles: Vec<[Vertex; 3]> = (0..2)
            .flat_map(|of| FACES.map(|face| face.map(|corner| Vertex::input(4 * of + corner as usize))))
            .collect();
        let sides = [[[0, 1]; 4], [[0, 2]; 4]].concat();
        let materials = Materials::new(&scene, &triangles, &sides);
        let in_integers = materials.in_integers();
        for triangle in &triangles {
            let [a, b, c] = triangle.map(|v| corners[v.index()]);
            let weights = [(); 3].map(|()| 1 + i64::try_from(random.below(4)).unwrap());
            let sum = u32::try_from(weights.iter().sum::<i64>()).unwrap();
            let q = over([0, 1, 2].map(|axis: usize| dot(weights, [a[axis], b[axis], c[axis]])), sum);
            let generic = (0..20).find_map(|_| {
                let direction = [(); 3].map(|()| i32::try_from(random.below(2001)).unwrap() - 1000);
                in_integers.winding(&q, direction)
            });
            let Some(Place::On(on)) = generic else { panic!("{q:?} is on {triangle:?}: {generic:?}") };
            let direction = [(); 3].map(|()| i32::try_from(random.below(9)).unwrap() - 4);
            if direction == [0; 3] {
                continue;
            }
            let moved = [0, 1, 2].map(|axis: usize| Rational::from(&step * direction[axis]) + &q[axis]);
            let Some((is_front, place)) = in_integers.beside(&on, &q, direction) else { continue };
            let again = in_integers.winding(&moved, direction).expect("the same ray, a step ahead");
            assert_eq!(place, again, "{corners:?} {q:?} {direction:?}");
            let of_first = triangles[on[0] as usize].map(|v| corners[v.index()]);
            let ahead = dot(normal(of_first), direction.map(i64::from));
            assert_eq!(is_front, ahead > 0, "{corners:?} {q:?} {direction:?}");
            told += 1;
            fronts += usize::from(is_front);
        }
    }
    assert!(told > 200 && fronts > told / 3 && fronts < 2 * told / 3, "{told} told, {fronts} in front");
    // Without triangles there is nothing beside the point.
    let scene = Scene::from_points3(&[[0.0; 3]]).unwrap();
    let none = Materials::new(&scene, &[], &[]);
    assert_eq!(none.in_integers().beside(&[], &over([0; 3], 1), [1, 0, 0]), None);
}
