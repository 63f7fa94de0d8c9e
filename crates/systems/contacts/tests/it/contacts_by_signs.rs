//! The contacts of the exact backend, on every pair of simplices of small grids, compared with set theory.
//!
//! The open simplex of some points is the set of their combinations with positive weights that add up to one; this also
//! holds for points in special position. The contacts of two simplices must be those pairs of their faces whose open
//! simplices meet while those of no sub-pair do.
//!
//! Integers decide whether open simplices meet, without any notion of orientation. The weights of common points are a
//! polytope, and every vertex of it is the unique solution of some independent columns of the equations. A common point
//! with positive weights exists iff every weight is positive at some vertex: then the mean of all vertices has positive
//! weights.

use std::collections::{BTreeSet, HashMap};

use crate::common::faces::faces;
use predicament_contacts::algorithm::pairs::contacts;
use predicament_exact::Exact;
use predicament_mesh::{Complex, Simplices};
use predicament_predicates::{Backend, Dimension, Off, Scene, Vertex};

/// The weights of these columns only, by elimination without fractions; `None` unless there is exactly one solution.
fn solve(mut rows: Vec<Vec<i64>>, unknowns: usize) -> Option<Vec<[i64; 2]>> {
    for column in 0..unknowns {
        let pivot = (column..rows.len()).find(|&row| rows[row][column] != 0)?;
        rows.swap(column, pivot);
        let by = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(at, row)| *at != column && row[column] != 0) {
            let q = row[column];
            row.iter_mut().zip(&by).for_each(|(x, y)| *x = *x * by[column] - y * q);
            let common = row.iter().fold(0, |g, &x| gcd(g, x.abs()));
            if common > 1 {
                row.iter_mut().for_each(|x| *x /= common);
            }
        }
    }
    let rest = rows[unknowns..].iter().all(|row| row[unknowns] == 0);
    rest.then(|| (0..unknowns).map(|i| [rows[i][unknowns], rows[i][i]]).collect())
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// True if the open simplices of these points have a common point.
fn meet(a: &[&[i8]], b: &[&[i8]]) -> bool {
    let all = a.len() + b.len();
    let column = |i: usize| -> Vec<i64> {
        let (point, sign) = if i < a.len() { (a[i], 1) } else { (b[i - a.len()], -1) };
        let of = |inside: bool| i64::from(inside);
        point.iter().map(|&c| sign * i64::from(c)).chain([of(i < a.len()), of(i >= a.len())]).collect()
    };
    let columns: Vec<Vec<i64>> = (0..all).map(column).collect();
    let equations = columns[0].len();
    let mut positive = 0_u32;
    for bits in 1_u32..1 << all {
        let chosen: Vec<usize> = (0..all).filter(|i| bits >> i & 1 == 1).collect();
        if chosen.len() > equations || bits & !positive == 0 {
            continue;
        }
        let row = |row: usize| -> Vec<i64> {
            chosen.iter().map(|&i| columns[i][row]).chain([i64::from(row + 2 >= equations)]).collect()
        };
        let Some(weights) = solve((0..equations).map(row).collect(), chosen.len()) else { continue };
        if weights.iter().all(|&[n, d]| n == 0 || (n > 0) == (d > 0)) {
            for (&i, _) in chosen.iter().zip(&weights).filter(|(_, [n, _])| *n != 0) {
                positive |= 1 << i;
            }
        }
    }
    positive == (1 << all) - 1
}

/// All points of a grid.
fn grid(sides: &[i8]) -> Vec<Vec<i8>> {
    sides.iter().fold(vec![vec![]], |points, &side| {
        points.iter().flat_map(|point| (0..side).map(|c| [&point[..], &[c]].concat())).collect()
    })
}

/// All ways to choose `count` items from `from`, with repetition.
fn choices(from: usize, count: usize) -> Vec<Vec<usize>> {
    (0..count).fold(vec![vec![]], |all: Vec<Vec<usize>>, _| {
        all.iter()
            .flat_map(|chosen| {
                let first = chosen.last().copied().unwrap_or(0);
                (first..from).map(|i| [&chosen[..], &[i]].concat())
            })
            .collect()
    })
}

/// Checks every simplex of `of_a` vertices against every one of `of_b`; returns the number of pairs and the number of
/// contacts.
fn check(sides: &[i8], [of_a, of_b]: [usize; 2]) -> [usize; 2] {
    let points = grid(sides);
    let dimension = if sides.len() == 2 { Dimension::Two } else { Dimension::Three };
    // enough copies of the grid that a point can be used more than once, in both simplices
    let copies = of_a + of_b;
    let coordinates = points.iter().flatten().map(|&c| f64::from(c)).collect::<Vec<_>>().repeat(copies);
    let scene = Scene::new(dimension, coordinates).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    let complexes = |count: usize, copy: usize| -> Vec<Complex> {
        let complex = |choice: &Vec<usize>| {
            let v: Vec<Vertex> =
                choice.iter().enumerate().map(|(i, &at)| Vertex::input(at + (copy + i) * points.len())).collect();
            let mut given = Simplices::default();
            match *v {
                [a] => given.vertices = vec![a],
                [a, b] => given.edges = vec![[a, b]],
                [a, b, c] => given.triangles = vec![[a, b, c]],
                [a, b, c, d] => given.tetrahedra = vec![[a, b, c, d]],
                _ => unreachable!(),
            }
            Complex::new(&scene, &given).unwrap()
        };
        choices(points.len(), count).iter().map(complex).collect()
    };
    let at = |cell: &[Vertex]| -> Vec<usize> { cell.iter().map(|v| v.index() % points.len()).collect() };
    let mut known: HashMap<(Vec<usize>, Vec<usize>), bool> = HashMap::new();
    let (firsts, seconds) = (complexes(of_a, 0), complexes(of_b, of_a));
    let (mut count, step) = (0, predicament_effort::some_or_all(3, 1));
    for (at_a, a) in firsts.iter().enumerate() {
        let of_a = faces(a.vertices());
        // By default one pair of three: each simplex has partners of all kinds.
        for b in seconds.iter().skip(at_a % step).step_by(step) {
            let found: BTreeSet<_> = contacts(&session, a, b)
                .registered
                .iter()
                .map(|c| (a.vertices_of(c.a).to_vec(), b.vertices_of(c.b).to_vec()))
                .collect();
            let of_b = faces(b.vertices());
            let mut pairs: Vec<_> = of_a.iter().flat_map(|s| of_b.iter().map(move |t| (s, t))).collect();
            pairs.sort_by_key(|(s, t)| s.len() + t.len());
            let mut expected: BTreeSet<(Vec<Vertex>, Vec<Vertex>)> = BTreeSet::new();
            for (s, t) in pairs {
                let subset = |small: &[Vertex], large: &[Vertex]| small.iter().all(|v| large.contains(v));
                if expected.iter().any(|(u, v)| subset(u, s) && subset(v, t)) {
                    continue;
                }
                let key = (at(s), at(t));
                let meets = *known.entry(key).or_insert_with_key(|(s, t)| {
                    let points = |cell: &[usize]| cell.iter().map(|&i| &points[i][..]).collect::<Vec<_>>();
                    meet(&points(s), &points(t))
                });
                if meets {
                    expected.insert((s.clone(), t.clone()));
                }
            }
            assert_eq!(found, expected, "{:?} and {:?}", at(a.vertices()), at(b.vertices()));
            count += found.len();
        }
    }
    [firsts.len() * seconds.len(), count]
}

#[test]
fn the_second_computation_knows_what_meets() {
    let square: [&[i8]; 4] = [&[0, 0], &[2, 0], &[2, 2], &[0, 2]];
    assert!(meet(&[square[0], square[2]], &[square[1], square[3]]), "diagonals cross");
    assert!(!meet(&[square[0], square[1]], &[square[1], square[2]]), "open edges don't meet in an end");
    assert!(meet(&[square[0], square[2]], &[&[1, 1]]) && !meet(&[square[0], square[1]], &[&[1, 1]]));
    assert!(meet(&[square[0], square[0]], &[square[0]]), "an edge of one point is that point");
    assert!(meet(&[&[0, 0], &[3, 0]], &[&[1, 0], &[2, 0]]), "one in another");
    assert!(!meet(&[&[0, 0], &[1, 0]], &[&[2, 0], &[3, 0]]) && !meet(&[&[0, 0], &[1, 0]], &[&[1, 0], &[3, 0]]));
    assert!(meet(&[&[0, 0], &[1, 0], &[3, 0]], &[&[1, 0]]), "a flat triangle is a segment");
    assert!(!meet(&[&[0, 0], &[1, 0], &[3, 0]], &[&[3, 0]]), "an open one");
}

#[test]
fn edges_and_edges_of_the_plane() {
    assert_eq!(check(&[3, 3], [2, 2])[0], 45 * 45);
    assert_eq!(check(&[4, 4], [2, 2])[0], 136 * 136);
}

#[test]
fn triangles_and_vertices_and_edges_and_triangles_of_the_plane() {
    assert_eq!(check(&[4, 4], [3, 1])[0], 816 * 16);
    assert_eq!(check(&[3, 3], [2, 3])[0], 45 * 165);
    if predicament_effort::whole() {
        assert_eq!(check(&[3, 3], [3, 3])[0], 165 * 165);
    }
    assert_eq!(check(&[3, 2], [3, 3])[0], 56 * 56);
}

#[test]
fn edges_and_edges_of_space() {
    assert_eq!(check(&[3, 3, 2], [2, 2])[0], 171 * 171);
}

#[test]
fn triangles_and_edges_of_space() {
    assert_eq!(check(&[2, 2, 2], [3, 2])[0], 120 * 36);
    assert_eq!(check(&[2, 2, 2], [2, 3])[0], 36 * 120);
    if predicament_effort::whole() {
        assert_eq!(check(&[3, 2, 2], [2, 3])[0], 78 * 364);
        assert_eq!(check(&[3, 3, 2], [2, 3])[0], 171 * 1140);
    }
}

#[test]
fn triangles_and_triangles_of_space() {
    assert_eq!(check(&[2, 2, 2], [3, 3])[0], 120 * 120);
}

#[test]
fn tetrahedra_and_all_others() {
    assert_eq!(check(&[2, 2, 2], [4, 1])[0], 330 * 8);
    if predicament_effort::whole() {
        assert_eq!(check(&[3, 2, 2], [4, 1])[0], 1365 * 12);
        assert_eq!(check(&[2, 2, 2], [3, 4])[0], 120 * 330);
        assert_eq!(check(&[3, 3, 2], [4, 1])[0], 5985 * 18);
        assert_eq!(check(&[2, 2, 2], [4, 2])[0], 330 * 36);
    }
    assert_eq!(check(&[2, 2, 2], [1, 4])[0], 8 * 330);
    assert_eq!(check(&[2, 2, 1], [3, 4])[0], 20 * 35);
}
