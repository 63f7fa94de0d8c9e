//! Tests of results where meshes touch: the limit of a perturbed result is the exact one, and the laws of sets hold.
//!
//! Results are compared as sums of oriented triangles in rationals (`checks::chains`), so equal results may be divided
//! into other triangles.

use std::collections::BTreeSet;

use predicament_corpus::{Level, Library, Vocabulary};
use predicament_formats::Cache;
use predicament_mesh_intersect::checks::chains::{Chain, Segments};
use predicament_mesh_intersect::task::{MeshIntersect, TwoMeshes};
use rug::Rational;

use crate::common::shapes::{Random, Shape};
use crate::common::surfaces::{
    Results, cancel, difference, exactly, in_the_limit, pair, scaled, sum_of_volumes, surface,
};
use crate::common::volumes::{Point, Surface, common, volume};

/// The flaw of a scene: results are refused, or differ.
fn flaw(first: &Shape, second: &Shape) -> Option<String> {
    let (scene, meshes) = pair(first, second);
    let both = exactly(&scene, &meshes).and_then(|exact| Ok((exact, in_the_limit(&scene, &meshes)?)));
    match both {
        Err(why) => Some(why),
        Ok((exact, limit)) => difference(&exact, &limit).map(ToOwned::to_owned),
    }
}

/// Unit cubes of a lattice around the origin, chosen at random.
fn polycube(random: &mut Random) -> Shape {
    let mut cells = vec![[0; 3]];
    let along = |at: u64, by: u64| i32::try_from(at / by % 3).unwrap() - 1;
    cells.extend((0..27).filter(|_| random.below(3) == 0).map(|at| [along(at, 9), along(at, 3), along(at, 1)]));
    Shape::cubes(&cells)
}

fn tetrahedron(random: &mut Random, most: u32) -> Shape {
    loop {
        let shape = Shape::tetrahedron([(); 4].map(|()| random.point(most)));
        if !shape.triangles.is_empty() {
            return shape;
        }
    }
}

/// The pairs of a sample: polycubes, tetrahedra with corners on few integers, a shape with itself, and with itself
/// moved by a vector of the lattice.
fn sample(seed: u64) -> [(Shape, Shape); 6] {
    let mut random = Random(seed + 1);
    let (cubes, corners) = (polycube(&mut random), tetrahedron(&mut random, 3));
    let by = random.point(2);
    let others = (polycube(&mut random).moved(by), tetrahedron(&mut random, 3));
    let by = random.point(2);
    [
        (cubes.clone(), others.0),
        (corners.clone(), others.1),
        (cubes.clone(), cubes.clone()),
        (cubes.clone(), cubes.moved(by)),
        (corners.clone(), corners.clone()),
        (corners.clone(), corners.moved(by)),
    ]
}

#[test]
fn the_limit_of_a_perturbed_result_is_the_exact_one() {
    let mut compared = 0;
    for seed in 0..predicament_effort::some_or_all(12, 1_000) {
        for (kind, (first, second)) in sample(seed).into_iter().enumerate() {
            assert_eq!(flaw(&first, &second), None, "{kind} of {seed}: {first:?} and {second:?}");
            compared += 4;
        }
    }
    println!("{compared} results compared");
}

#[test]
fn the_limit_of_a_perturbed_result_is_the_exact_one_in_every_scene() {
    let library = Library::embedded(&Vocabulary::new(vec![&MeshIntersect])).unwrap();
    let cache = Cache::default_dir().unwrap_or_else(|_| Cache::new(""));
    let most = predicament_effort::some_or_all(400, usize::MAX);
    for (name, least) in [("touching", 30), ("intersections", 30), ("package-intersections", 0)] {
        let suite = library.suite(name).unwrap();
        let (mut compared, mut larger, mut missing) = (0, 0, 0);
        for scene in &suite.scenes {
            let Ok(loaded) = scene.load(Level::Quick, &cache) else {
                assert_eq!(least, 0, "{name}/{} cannot be read", scene.name);
                missing += 1;
                continue;
            };
            let content: &TwoMeshes = loaded.content().unwrap();
            if content.triangles() > most {
                larger += 1;
                continue;
            }
            let exact = exactly(&loaded.scene, &content.meshes).unwrap();
            let limit = in_the_limit(&loaded.scene, &content.meshes).unwrap();
            assert_eq!(difference(&exact, &limit), None, "{name}/{}", scene.name);
            compared += 1;
        }
        println!("{name}: {compared} scenes compared, {larger} larger, {missing} without their data");
        assert!(compared >= least, "{name}: {compared} scenes");
    }
}

/// The laws of sets that an operation on two shapes violates. `counts` are of results that are operands again, and of
/// those whose coordinates are no doubles.
fn violated(first: &Shape, second: &Shape, counts: &mut [usize; 2]) -> Option<String> {
    let of = |first: &Shape, second: &Shape| -> Result<Results, String> {
        let (scene, meshes) = pair(first, second);
        exactly(&scene, &meshes)
    };
    let mut laws = || -> Result<Option<&'static str>, String> {
        let (a, b) = (surface(first), surface(second));
        let [union, both, less, other] = of(first, second)?;
        let [swapped_union, swapped_both, swapped_less, swapped_other] = of(second, first)?;
        let empty = Surface::new();
        let is_same = |a: &Surface, b: &Surface| cancel(&[(a, 1), (b, -1)]);
        if ![(&union, &swapped_union), (&both, &swapped_both), (&other, &swapped_other)]
            .iter()
            .all(|(own, swapped)| is_same(own, swapped))
        {
            return Ok(Some("A and B may be exchanged"));
        }
        if !cancel(&[(&less, 1), (&swapped_less, 1), (&other, -1)]) {
            return Ok(Some("A∖B and B∖A together are the symmetric difference"));
        }
        if !cancel(&[(&union, 1), (&both, 1), (&a, -1), (&b, -1)]) {
            return Ok(Some("union and intersection together are A and B together"));
        }
        let apex: Point = [0.375, 0.28125, 0.2421875].map(predicament_judge::rational);
        if sum_of_volumes(&[(&union, 1), (&a, -1), (&b, -1)]) != -common(&a, &b, &apex) || volume(&both) < 0 {
            return Ok(Some("the union has the volumes of A and B less the common one"));
        }
        let bounds = Shape::cuboid([-16.0; 3], [16.0; 3]);
        let outside = |shape: &Shape| bounds.clone().and(&shape.clone().inverted());
        let [union_outside, both_outside, ..] = of(&outside(first), &outside(second))?;
        let bounds = surface(&bounds);
        if !cancel(&[(&both_outside, 1), (&bounds, -1), (&union, 1)])
            || !cancel(&[(&union_outside, 1), (&bounds, -1), (&both, 1)])
        {
            return Ok(Some("De Morgan, in a box"));
        }
        // The results as operands.
        let Some([less, both, whole]) = scaled([&less, &both, &a]) else {
            counts[1] += usize::from(!less.is_empty() && !both.is_empty());
            return Ok(None);
        };
        counts[0] += 1;
        let [together, common, again, _] = of(&less, &both)?;
        let is_law =
            is_same(&together, &surface(&whole)) && is_same(&common, &empty) && is_same(&again, &surface(&less));
        Ok((!is_law).then_some("(A∖B) ∪ (A∩B) = A"))
    };
    match laws() {
        Err(why) => Some(why),
        Ok(law) => law.map(ToOwned::to_owned),
    }
}

#[test]
fn the_laws_of_sets_hold_where_meshes_touch() {
    let mut counts = [0; 2];
    for seed in 0..predicament_effort::some_or_all(4, 400) {
        for (kind, (first, second)) in sample(seed).into_iter().enumerate() {
            let law = violated(&first, &second, &mut counts);
            assert_eq!(law, None, "{kind} of {seed}: {first:?} and {second:?}");
        }
    }
    println!("{} times results were operands, {} times they were not doubles", counts[0], counts[1]);
    assert!(counts[0] > 3, "{counts:?}");
}

/// The unit cells of cubes of a size, and the shape of the cubes.
fn blocks(random: &mut Random, size: i32, by: [i32; 3]) -> (BTreeSet<[i32; 3]>, Shape) {
    let all = (0..8).filter(|_| random.below(2) == 0).map(|at: i32| [at / 4, at / 2 % 2, at % 2]);
    let cells: Vec<[i32; 3]> = all.collect();
    let place = |i: usize, x: i32| size * x + by[i];
    let units = cells.iter().flat_map(|cell| {
        (0..size.pow(3)).map(move |at| {
            let within = [at / size / size, at / size % size, at % size];
            [0, 1, 2].map(|i: usize| place(i, cell[i]) + within[i])
        })
    });
    let size = f64::from(size);
    let shape = Shape::cubes(&cells).mapped(|p| [0, 1, 2].map(|i: usize| size * p[i] + f64::from(by[i])));
    (units.collect(), shape)
}

/// Tests parts of one mesh that touch in parts of edges and in corners, but not in faces: `exact` declines and names
/// two triangles, or has the limit of a perturbed result.
#[test]
fn a_mesh_whose_parts_touch_is_declined_by_name_or_right() {
    let (mut random, mut seen) = (Random(1), [0, 0]);
    while seen[0] + seen[1] < predicament_effort::some_or_all(24, 1_000) {
        let by = [(); 3].map(|()| i32::try_from(random.below(5)).unwrap() - 2);
        let (first, small) = blocks(&mut random, 1, [0; 3]);
        let (second, large) = blocks(&mut random, 2, by);
        let around = |[x, y, z]: [i32; 3]| {
            [[x, y, z], [x + 1, y, z], [x - 1, y, z], [x, y + 1, z], [x, y - 1, z], [x, y, z + 1], [x, y, z - 1]]
        };
        let is_apart = !first.iter().flat_map(|&cell| around(cell)).any(|cell| second.contains(&cell));
        if first.is_empty() || second.is_empty() || !is_apart {
            continue;
        }
        let both = small.and(&large);
        let other = polycube(&mut random).moved(random.point(2));
        let (scene, meshes) = pair(&both, &other);
        match exactly(&scene, &meshes) {
            Err(why) => {
                let is_named = why.contains("triangles ") && why.contains(" of the first mesh meet otherwise");
                assert!(is_named, "{why}: {both:?} and {other:?}");
                seen[0] += 1;
            }
            Ok(exact) => {
                let limit = in_the_limit(&scene, &meshes).unwrap();
                assert_eq!(difference(&exact, &limit), None, "{both:?} and {other:?}");
                seen[1] += 1;
            }
        }
    }
    println!("{} declined, {} right", seen[0], seen[1]);
    assert!(seen[0] > 0 && seen[1] > 0, "{seen:?}");
}

#[test]
fn sums_of_triangles_and_segments_are_zero_only_for_equal_sets() {
    let at = |x: i32, y: i32| [x, y, 1].map(Rational::from);
    let square = [at(0, 0), at(4, 0), at(4, 4), at(0, 4), at(2, 2), at(2, 0)];
    let rest = |triangles: &[([usize; 3], i64)]| {
        let mut chain = Chain::default();
        triangles.iter().for_each(|(corners, times)| chain.add(corners.map(|at| &square[at]), *times));
        chain.rest().is_some()
    };
    let two = [([0, 1, 2], 1), ([0, 2, 3], 1)];
    let five = [([0, 5, 4], -1), ([5, 1, 4], -1), ([1, 2, 4], -1), ([2, 3, 4], -1), ([3, 0, 4], -1)];
    assert!(!rest(&[&two[..], &five].concat()));
    assert!(rest(&[&two[..], &five[..4]].concat()), "a lost triangle");
    assert!(rest(&[&two[..1], &[([0, 3, 2], 1)], &five].concat()), "a turned triangle");
    assert!(rest(&[&two[..], &[([0, 1, 4], -1)], &five[1..]].concat()), "another vertex");
    assert!(!rest(&[([0, 1, 5], 1)]), "no area");
    let rest = |segments: &[([usize; 2], i64)]| {
        let mut all = Segments::default();
        segments.iter().for_each(|(ends, times)| all.add(ends.map(|at| &square[at]), *times));
        all.rest().is_some()
    };
    assert!(!rest(&[([0, 1], 1), ([1, 5], -1), ([0, 5], -1), ([3, 3], 1)]));
    assert!(rest(&[([0, 1], 1), ([0, 5], -1)]) && rest(&[([0, 2], 1), ([1, 3], -1)]));
}
