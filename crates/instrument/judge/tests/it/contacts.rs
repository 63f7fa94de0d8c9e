//! Contacts: against hand-made pairs, against separating planes, against the algorithm.

use std::collections::BTreeSet;

use predicament_contacts::algorithm::pairs::contacts as by_algorithm;
use predicament_exact::Exact;
use predicament_judge::contacts::{contact, contacts, contacts_of, ended_by, registered_twice};
use predicament_judge::{Sample, rational};
use predicament_predicates::{Backend, Dimension, Off, Scene, Vertex};
use rug::Rational;

use crate::random::{Grid, Random, complexes, effort, simplices};

type Cell = Vec<Vertex>;

fn cell(indices: &[usize]) -> Cell {
    indices.iter().map(|&i| Vertex::input(i)).collect()
}

fn faces(cell: &[Vertex]) -> Vec<Cell> {
    let subset = |bits: u32| (0..cell.len()).filter(|i| bits >> i & 1 == 1).map(|i| cell[i]).collect();
    (1_u32..1 << cell.len()).map(subset).collect()
}

/// All faces of the given cells.
fn closure(cells: &[&[usize]]) -> Vec<Cell> {
    let all: BTreeSet<Cell> = cells.iter().flat_map(|of| faces(&cell(of))).collect();
    all.into_iter().collect()
}

/// The registered pairs, as indices of vertices.
fn found(scene: &Scene, a: &[&[usize]], b: &[&[usize]]) -> Vec<[Vec<usize>; 2]> {
    let (a, b) = (closure(a), closure(b));
    let of = |cell: &Cell| cell.iter().map(|v| v.index()).collect::<Vec<usize>>();
    let mut pairs: Vec<_> = contacts(scene, &a, &b).iter().map(|c| [of(&a[c.pair[0]]), of(&b[c.pair[1]])]).collect();
    pairs.sort_by_key(|pair| (pair[0].len() + pair[1].len(), pair.clone()));
    pairs
}

fn pairs<const N: usize>(of: [[&[usize]; 2]; N]) -> Vec<[Vec<usize>; 2]> {
    of.map(|pair| pair.map(<[usize]>::to_vec)).to_vec()
}

#[test]
fn known_pairs_of_the_plane_are_registered() {
    let scene = Scene::from_points2(&[
        [0.0, 0.0],
        [4.0, 0.0],
        [0.0, 4.0],
        [1.0, 0.0],
        [3.0, 0.0],
        [1.0, 1.0],
        [0.0, 0.0],
        [5.0, 5.0],
        [2.0, -1.0],
    ])
    .unwrap();
    // An edge along another: the two vertices on it are registered, and not the edges.
    assert_eq!(found(&scene, &[&[0, 1]], &[&[3, 4]]), pairs([[&[0, 1], &[3]], [&[0, 1], &[4]]]));
    // A common vertex, and two vertices with equal coordinates.
    assert_eq!(found(&scene, &[&[0, 1]], &[&[0, 2]]), pairs([[&[0], &[0]]]));
    assert_eq!(found(&scene, &[&[0, 1]], &[&[5, 6]]), pairs([[&[0], &[6]]]));
    // Two crossing edges, and a vertex in a triangle that has one of its edges crossed.
    assert_eq!(found(&scene, &[&[0, 1]], &[&[5, 8]]), pairs([[&[0, 1], &[5, 8]]]));
    assert_eq!(found(&scene, &[&[0, 1, 2]], &[&[5, 8]]), pairs([[&[0, 1], &[5, 8]], [&[0, 1, 2], &[5]]]));
    assert_eq!(found(&scene, &[&[0, 1, 2]], &[&[7, 8]]), pairs([[&[0, 1], &[7, 8]], [&[1, 2], &[7, 8]]]));
    // A triangle without area, collinear with an edge.
    assert_eq!(found(&scene, &[&[0, 3, 4]], &[&[1]]), pairs([]));
    assert_eq!(found(&scene, &[&[0, 1, 4]], &[&[3]]), pairs([[&[0, 1], &[3]], [&[0, 4], &[3]]]));
    assert_eq!(found(&scene, &[], &[&[3]]), pairs([]));
}

#[test]
fn known_pairs_of_space_are_registered() {
    let scene = Scene::from_points3(&[
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [0.0, 0.0, 4.0],
        [1.0, 1.0, -1.0],
        [1.0, 1.0, 1.0],
        [1.0, -1.0, 0.0],
        [1.0, 1.0, 0.0],
        [2.0, 2.0, 2.0],
    ])
    .unwrap();
    let solid: &[usize] = &[0, 1, 2, 3];
    // An edge through a triangle, into the tetrahedron.
    assert_eq!(found(&scene, &[&[0, 1, 2]], &[&[4, 5]]), pairs([[&[0, 1, 2], &[4, 5]]]));
    assert_eq!(found(&scene, &[solid], &[&[4, 5]]), pairs([[&[0, 1, 2], &[4, 5]], [solid, &[5]]]));
    // Two coplanar edges, and a vertex in a triangle: degenerate in space.
    assert_eq!(found(&scene, &[&[0, 1, 2]], &[&[6, 7]]), pairs([[&[0, 1], &[6, 7]], [&[0, 1, 2], &[7]]]));
    assert_eq!(found(&scene, &[solid], &[&[8]]), pairs([]));
}

#[test]
fn the_weights_are_where_the_two_meet() {
    let scene = Scene::from_points2(&[[0.0, 0.0], [3.0, 0.0], [1.0, -1.0], [1.0, 2.0]]).unwrap();
    let third = |n: i32| Rational::from((n, 3));
    assert_eq!(
        contact(&scene, &cell(&[0, 1]), &cell(&[2, 3])),
        Some([vec![third(2), third(1)], vec![third(2), third(1)]])
    );
    let mut random = Random::new(3);
    let mut seen = 0;
    for _ in 0..200 {
        let (scene, [a, b]) = complexes(&mut random, Dimension::Three, Grid::Wide);
        let [a, b] = [simplices(&a), simplices(&b)];
        for found in contacts(&scene, &a, &b) {
            let at = |cell: &Cell, weights: &[Rational], axis: usize| -> Rational {
                cell.iter().zip(weights).map(|(&v, weight)| rational(scene.point(v)[axis]) * weight).sum()
            };
            let [on_a, on_b] = &found.weights;
            for axis in 0..3 {
                assert_eq!(at(&a[found.pair[0]], on_a, axis), at(&b[found.pair[1]], on_b, axis));
            }
            for weights in [on_a, on_b] {
                assert_eq!(weights.iter().sum::<Rational>(), 1);
                assert!(weights.iter().all(|weight| *weight > 0));
            }
            seen += 1;
        }
    }
    assert!(seen > 200, "{seen} contacts");
}

/// The determinant of integers, expanded along the first column.
fn determinant(rows: &[Vec<i64>]) -> i64 {
    if rows.is_empty() {
        return 1;
    }
    let minor = |at: usize| -> Vec<Vec<i64>> {
        let others = rows.iter().enumerate().filter(|(row, _)| *row != at);
        others.map(|(_, row)| row[1..].to_vec()).collect()
    };
    (0..rows.len()).map(|at| if at % 2 == 0 { 1 } else { -1 } * rows[at][0] * determinant(&minor(at))).sum()
}

/// All choices of `count` elements.
fn choices(from: &[usize], count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![vec![]];
    }
    (0..from.len())
        .flat_map(|at| {
            choices(&from[at + 1..], count - 1).into_iter().map(move |rest| [&from[at..=at], &rest].concat())
        })
        .collect()
}

/// The signed volume of k + 1 points in these k coordinates.
fn volume(points: &[&Vec<i64>], axes: &[usize]) -> i64 {
    let rows: Vec<Vec<i64>> =
        points[1..].iter().map(|p| axes.iter().map(|&axis| p[axis] - points[0][axis]).collect()).collect();
    determinant(&rows)
}

/// True if open simplices meet, by planes: they are apart iff a plane has one on either side and does not contain both.
/// In the flat that all points span, one such plane passes through as many points as span a plane there.
fn meet(s: &[Vec<i64>], t: &[Vec<i64>]) -> bool {
    let all: Vec<&Vec<i64>> = s.iter().chain(t).collect();
    let places: Vec<usize> = (0..all.len()).collect();
    let of = |choice: &[usize]| choice.iter().map(|&i| all[i]).collect::<Vec<_>>();
    // The flat's dimension, and coordinates in which its points stay distinct.
    let every: Vec<usize> = (0..s[0].len()).collect();
    let span = (1..=every.len()).rev().find_map(|k| {
        let wide = |axes: &Vec<usize>| choices(&places, k + 1).iter().any(|points| volume(&of(points), axes) != 0);
        choices(&every, k).into_iter().find(wide)
    });
    let Some(axes) = span else { return true };
    !choices(&places, axes.len()).iter().any(|plane| {
        let side = |p: &Vec<i64>| volume(&[&of(plane)[..], &[p]].concat(), &axes).signum();
        let [of_s, of_t]: [Vec<i64>; 2] = [s, t].map(|points| points.iter().map(side).collect());
        let proper = of_s.iter().chain(&of_t).any(|&side| side != 0);
        let between = |sign: i64| of_s.iter().all(|&x| x * sign >= 0) && of_t.iter().all(|&x| x * sign <= 0);
        proper && (between(1) || between(-1))
    })
}

/// The coordinates of a simplex on a grid, as integers.
#[allow(clippy::cast_possible_truncation)] // small integers
fn integers(scene: &Scene, cell: &[Vertex]) -> Vec<Vec<i64>> {
    cell.iter().map(|&v| scene.point(v).iter().map(|&x| x as i64).collect()).collect()
}

/// The definition, literally: the hierarchy over separating planes.
#[test]
fn contacts_are_what_separating_planes_leave() {
    let mut random = Random::new(1);
    let (mut seen, mut ended) = (0, 0);
    for round in 0..150 * effort() {
        let dimension = if round % 2 == 0 { Dimension::Two } else { Dimension::Three };
        let (scene, complexes) = complexes(&mut random, dimension, Grid::Whole);
        let [a, b] = [0, 1].map(|side| simplices(&complexes[side]));
        let found: BTreeSet<[usize; 2]> = contacts(&scene, &a, &b).iter().map(|contact| contact.pair).collect();
        let mut registered: Vec<[&Cell; 2]> = Vec::new();
        let mut all: Vec<[usize; 2]> = (0..a.len()).flat_map(|s| (0..b.len()).map(move |t| [s, t])).collect();
        all.sort_by_key(|&[s, t]| a[s].len() + b[t].len());
        for pair in all {
            let [s, t] = [&a[pair[0]], &b[pair[1]]];
            let sub = |small: &Cell, large: &Cell| small.iter().all(|v| large.contains(v));
            let has_ended = registered.iter().any(|[u, v]| sub(u, s) && sub(v, t));
            let expected = !has_ended && meet(&integers(&scene, s), &integers(&scene, t));
            assert_eq!(found.contains(&pair), expected, "{s:?} {t:?} of {scene:?}");
            assert_eq!(ended_by(&scene, s, t).is_some(), has_ended, "{s:?} {t:?} of {scene:?}");
            if expected {
                registered.push([s, t]);
            }
            ended += usize::from(has_ended);
        }
        seen += registered.len();
    }
    assert!(seen > 400 && ended > 400, "{seen} contacts, {ended} pairs ended");
}

/// The pairs that the algorithm registers with exact signs, as indices in the lists of simplices.
pub fn of_algorithm(scene: &Scene, [a, b]: [&predicament_mesh::Complex; 2]) -> BTreeSet<[Cell; 2]> {
    let session = Exact.prepare(scene, Off).unwrap();
    let of = by_algorithm(&session, a, b);
    of.registered.iter().map(|c| [a.vertices_of(c.a).to_vec(), b.vertices_of(c.b).to_vec()]).collect()
}

/// The pairs that the judge registers, by their vertices.
pub fn of_judge(scene: &Scene, complexes: [&predicament_mesh::Complex; 2]) -> BTreeSet<[Cell; 2]> {
    let [a, b] = complexes.map(simplices);
    contacts(scene, &a, &b).iter().map(|c| [a[c.pair[0]].clone(), b[c.pair[1]].clone()]).collect()
}

#[test]
fn the_algorithm_with_exact_signs_registers_the_same() {
    let mut random = Random::new(2);
    let mut seen = 0;
    for round in 0..800 * effort() {
        let dimension = if round % 2 == 0 { Dimension::Two } else { Dimension::Three };
        let grid = [Grid::Whole, Grid::Whole, Grid::Fine, Grid::Wide][round / 2 % 4];
        let (scene, [a, b]) = complexes(&mut random, dimension, grid);
        let truth = of_judge(&scene, [&a, &b]);
        assert_eq!(of_algorithm(&scene, [&a, &b]), truth, "{scene:?} {a:?} {b:?}");
        assert_eq!(registered_twice(&truth.iter().cloned().collect::<Vec<_>>()), Vec::<[Cell; 2]>::new());
        seen += truth.len();
    }
    assert!(seen > 2000, "{seen} contacts");
}

#[test]
fn a_sample_finds_its_share_of_the_pairs() {
    let mut random = Random::new(4);
    let (scene, [a, b]) = complexes(&mut random, Dimension::Two, Grid::Whole);
    let [a, b] = [simplices(&a), simplices(&b)];
    let sample = Sample::within(3, a.len(), 1);
    assert!(!sample.is_all());
    let expected: Vec<_> = contacts(&scene, &a, &b).into_iter().filter(|c| sample.has(c.pair[0])).collect();
    assert_eq!(contacts_of(&scene, &a, &b, sample), expected);
}

#[test]
fn pairs_that_are_registered_twice_are_told() {
    let pair = |s: &[usize], t: &[usize]| [cell(s), cell(t)];
    let list = [pair(&[0], &[5]), pair(&[0, 1], &[5, 6]), pair(&[1, 2], &[5, 6]), pair(&[0, 1], &[6, 7])];
    assert_eq!(registered_twice(&list), [pair(&[0, 1], &[5, 6])]);
}
