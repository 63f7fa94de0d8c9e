//! Generated loops: waves, flat polygons, lattice polygons, knots, and meshes with holes.

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::{Family, Making, Parts, Random, Recipe};
use predicament_formats::bits::{integer, step};
use predicament_formats::{CorpusError, Fields};
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_tasks::solids;

use super::content::HoleScene;
use super::read::LONGEST;

macro_rules! family {
    ($name:literal, $about:literal, $make:path) => {
        Family {
            name: $name,
            reported_as: Some($name),
            parameters: &[],
            about: $about,
            read: |_, fields| recipe(fields, $make),
        }
    };
}

/// The families of loops.
pub(super) static FAMILIES: [Family; 7] = [
    family!("cover-wave", "a star-shaped loop of n points that goes up and down twice", wave),
    family!("cover-flat", "a star-shaped loop of n points in a plane, each moved by at most one double", flat),
    family!("cover-close", "the same loop, and a small triangle at most three doubles from its plane", close),
    family!("cover-comb", "a comb of about n points in a plane, with many points on a line", comb),
    family!("cover-lattice", "a loop of n points with small integer coordinates: many cross or touch", lattice),
    family!("cover-knot", "a loop of n points on a trefoil knot", knot),
    family!("cover-sphere", "a sphere of about n triangles with three holes", sphere),
];

fn recipe(_: &Fields<'_, '_>, make: fn(usize, &mut Random) -> Parts) -> Result<Recipe, CorpusError> {
    Ok(Recipe::new(|n| 9 * (n + 100), move |making: &Making| make(making.n, &mut making.random())))
}

/// One loop through all points.
fn one(points: &[[f64; 3]]) -> Parts {
    beside(points, &[])
}

/// One loop through the first points, beside triangles of others.
fn beside(points: &[[f64; 3]], others: &[[f64; 3]]) -> Parts {
    let all = [points, others].concat();
    let scene = Scene::new(Dimension::Three, all.into_flattened()).expect("finite points");
    let loops = vec![(0..points.len()).map(Vertex::input).collect()];
    let vertices: Vec<Vertex> = (points.len()..scene.len()).map(Vertex::input).collect();
    let triangles = vertices.as_chunks().0.to_vec();
    Parts::new(scene, HoleScene { triangles, loops, are_written: true })
}

fn size(n: usize) -> usize {
    n.clamp(4, LONGEST)
}

/// The direction at a part of a turn, on a square: no function that rounds differently on another platform is used.
fn around(at: usize, n: usize) -> [f64; 2] {
    let count = |i: usize| integer(i64::try_from(i).expect("scenes are smaller than memory"));
    let turn = 4.0 * count(at) / count(n);
    match turn {
        t if t < 1.0 => [1.0 - t, t],
        t if t < 2.0 => [1.0 - t, 2.0 - t],
        t if t < 3.0 => [t - 3.0, 2.0 - t],
        t => [t - 3.0, t - 4.0],
    }
}

fn wave(n: usize, random: &mut Random) -> Parts {
    let n = size(n);
    let point = |at: usize| {
        let [x, y] = around(at, n);
        let far = random.between(1.0, 2.0);
        [far * x, far * y, x * x - y * y + random.between(-0.25, 0.25)]
    };
    one(&(0..n).map(point).collect::<Vec<_>>())
}

/// A point near the plane z = 3 + x / 2 − y / 4, some doubles above it.
fn above([x, y]: [f64; 2], doubles: i64) -> [f64; 3] {
    [x, y, step(3.0 + x / 2.0 - y / 4.0, doubles)]
}

fn star(n: usize, random: &mut Random) -> Vec<[f64; 3]> {
    let n = size(n);
    let point = |at: usize| {
        let far = random.between(0.5, 2.0);
        above(around(at, n).map(|x| far * x), random.integer(-1, 1))
    };
    (0..n).map(point).collect()
}

fn flat(n: usize, random: &mut Random) -> Parts {
    one(&star(n, random))
}

fn close(n: usize, random: &mut Random) -> Parts {
    let points = star(n, random);
    let height = random.integer(-2, 2);
    let corner = |at: usize| {
        let far = random.between(0.0625, 0.125);
        above(around(at, 3).map(|x| far * x), height + random.integer(-1, 1))
    };
    beside(&points, &[0, 1, 2].map(corner))
}

fn comb(n: usize, _: &mut Random) -> Parts {
    let teeth = i64::try_from((size(n) - 2) / 4).expect("at most a hundred").max(1);
    let mut points: Vec<[i64; 2]> = (0..=2 * teeth).map(|x| [x, 0]).collect();
    points.push([2 * teeth, 2]);
    points.extend((1..2 * teeth).rev().map(|x| [x, if x % 2 == 0 { 2 } else { 1 }]));
    points.push([0, 2]);
    // The plane x + y + z = 0, in which all coordinates are integers.
    one(&points.into_iter().map(|[x, y]| [x, y, -x - y].map(integer)).collect::<Vec<_>>())
}

fn lattice(n: usize, random: &mut Random) -> Parts {
    let mut points: Vec<[f64; 3]> = Vec::new();
    while points.len() < size(n) {
        let point = [0, 1, 2].map(|_: usize| integer(random.integer(-2, 2)));
        // A few coordinates make at most 125 points; then points repeat.
        if points.len() >= 60 || !points.contains(&point) {
            points.push(point);
        }
    }
    one(&points)
}

/// A trefoil on a torus: around it three times while around its hole twice.
fn knot(n: usize, _: &mut Random) -> Parts {
    let n = size(n).max(9);
    let unit = |[x, y]: [f64; 2]| {
        let length = (x * x + y * y).sqrt();
        [x / length, y / length]
    };
    let point = |at: usize| {
        let [along, across] = [unit(around(2 * at % n, n)), unit(around(3 * at % n, n))];
        let far = 2.0 + across[0];
        [far * along[0], far * along[1], across[1]]
    };
    one(&(0..n).map(point).collect::<Vec<_>>())
}

/// A sphere without the triangles around some vertices. Holes have no common vertex.
fn sphere(n: usize, random: &mut Random) -> Parts {
    let shape = solids::sphere(n.max(72), random);
    let triangles = shape.cut(Vertex::input);
    let mut stars: BTreeMap<Vertex, BTreeSet<Vertex>> = BTreeMap::new();
    for corners in &triangles {
        corners.iter().for_each(|&v| stars.entry(v).or_default().extend(corners));
    }
    let mut centres: Vec<Vertex> = stars.keys().copied().collect();
    random.shuffle(&mut centres);
    let (mut open, mut taken): (BTreeSet<Vertex>, BTreeSet<Vertex>) = (BTreeSet::new(), BTreeSet::new());
    for centre in centres {
        if open.len() < 3 && stars[&centre].is_disjoint(&taken) {
            taken.extend(&stars[&centre]);
            open.insert(centre);
        }
    }
    let kept = triangles.into_iter().filter(|corners| !corners.iter().any(|v| open.contains(v))).collect();
    let scene = Scene::new(Dimension::Three, shape.points.into_flattened()).expect("finite points");
    let content = HoleScene::of_holes(scene.len(), kept).expect("a sphere without some triangles is a mesh");
    Parts::new(scene, content)
}
