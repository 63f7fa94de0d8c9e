//! Solids for cutting: many of their parts are in line, in one plane, or next to each other.

use predicament_corpus::Random;
use predicament_formats::bits::{integer, power_of_two};
use predicament_mesh::{MaterialMesh, OUTSIDE};
use predicament_predicates::Vertex;

use predicament_mesh_locate::task::generate::surface_of;
use predicament_mesh_locate::task::probes::Surface;
use predicament_tasks::solids::Shape;

fn count(i: usize) -> f64 {
    integer(i64::try_from(i).expect("scenes are smaller than memory"))
}

fn closed(points: Vec<[f64; 3]>, corners: Vec<[Vertex; 3]>) -> Surface {
    let mesh = MaterialMesh::of_closed(points.len(), corners);
    Surface {
        mesh: mesh.unwrap_or_else(|why| panic!("the generated mesh is invalid: {why}")),
        points,
        tetrahedra: Vec::new(),
    }
}

/// A prism in the shape of a comb: strips between its teeth triangulate bottom and top, and all teeth end on the same
/// lines.
pub(super) fn combs(n: usize, _: &mut Random) -> Surface {
    let teeth = (n / 24).max(1);
    let (mut points, mut corners): (Vec<[f64; 3]>, Vec<[Vertex; 3]>) = (Vec::new(), Vec::new());
    // Lines of vertices along the comb: its back, the beginning of teeth, and their ends, at the bottom and at the top.
    let line = |points: &mut Vec<[f64; 3]>, y: f64, z: f64| -> Vec<Vertex> {
        (0..2 * teeth)
            .map(|at| {
                points.push([count(at), y, z]);
                Vertex::input(points.len() - 1)
            })
            .collect()
    };
    let [low, high] = [0.0, 1.0].map(|z| [-1.0, 0.0, 4.0].map(|y| line(&mut points, y, z)));
    let mut square = |[a, b, c, d]: [Vertex; 4]| corners.extend([[a, b, c], [a, c, d]]);
    let [low_back, low_root, low_tip] = &low;
    let [high_back, high_root, high_tip] = &high;
    let last = 2 * teeth - 1;
    for at in 0..last {
        let next = at + 1;
        square([high_back[at], high_back[next], high_root[next], high_root[at]]);
        square([low_root[at], low_root[next], low_back[next], low_back[at]]);
        square([low_back[at], low_back[next], high_back[next], high_back[at]]);
        if at % 2 == 0 {
            square([high_root[at], high_root[next], high_tip[next], high_tip[at]]);
            square([low_tip[at], low_tip[next], low_root[next], low_root[at]]);
            square([low_tip[next], low_tip[at], high_tip[at], high_tip[next]]);
            square([low_tip[at], low_root[at], high_root[at], high_tip[at]]);
            square([low_root[next], low_tip[next], high_tip[next], high_root[next]]);
        } else {
            square([low_root[next], low_root[at], high_root[at], high_root[next]]);
        }
    }
    square([low_root[0], low_back[0], high_back[0], high_root[0]]);
    square([low_back[last], low_root[last], high_root[last], high_back[last]]);
    closed(points, corners)
}

/// A solid between the ground plane and random heights from 1 to 2 over a square: all of its walls are in five planes.
pub(super) fn terrain(n: usize, rng: &mut Random) -> Surface {
    let side = (n / 4).isqrt().max(1);
    let mut shape = Shape::default();
    let place = |i: usize, j: usize| i * (side + 1) + j;
    for is_top in [true, false] {
        for i in 0..=side {
            for j in 0..=side {
                let height = if is_top { 1.0 + rng.unit() } else { 0.0 };
                shape.points.push([count(i), count(j), height]);
            }
        }
    }
    let below = (side + 1) * (side + 1);
    let mut triangle = |corners: [usize; 3]| {
        shape.faces.push(corners.map(|at| u32::try_from(at).expect("scenes are smaller than memory")));
    };
    for i in 0..side {
        for j in 0..side {
            let [a, b, c, d] = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
            [[a, b, c], [a, c, d]].into_iter().for_each(&mut triangle);
            [[a, c, b], [a, d, c]].map(|lower| lower.map(|at| at + below)).into_iter().for_each(&mut triangle);
        }
        // Walls along the ground's four sides, counterclockwise as seen from above.
        let next = i + 1;
        let walls = [
            [place(i, 0), place(next, 0)],
            [place(side, i), place(side, next)],
            [place(next, side), place(i, side)],
            [place(0, next), place(0, i)],
        ];
        for [a, b] in walls {
            [[a + below, b + below, b], [a + below, b, a]].into_iter().for_each(&mut triangle);
        }
    }
    surface_of(shape, [OUTSIDE, 1])
}

/// Every second cell of a lattice, each a separate cube: neighbours share edges and corners, with two vertices each.
pub(super) fn checkers(n: usize, _: &mut Random) -> Surface {
    let cubes = (n / 12).max(2);
    let side = (1..).find(|side: &usize| side.pow(3).div_ceil(2) >= cubes).unwrap_or(1);
    let (mut points, mut corners) = (Vec::new(), Vec::new());
    let cells = (0..side.pow(3)).map(|at| [at / (side * side), at / side % side, at % side]);
    for [i, j, k] in cells.filter(|cell| cell.iter().sum::<usize>() % 2 == 0).take(cubes) {
        let first = points.len();
        points.extend((0..8).map(|at: usize| [count(i + (at & 1)), count(j + (at >> 1 & 1)), count(k + (at >> 2))]));
        let squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        for square in squares {
            let [a, b, c, d] = square.map(|at: usize| Vertex::input(first + at));
            corners.extend([[a, b, c], [a, c, d]]);
        }
    }
    closed(points, corners)
}

/// A tetrahedron, given by a corner and the ends of its three edges.
fn tetrahedron(corner: [f64; 3], to: [[f64; 3]; 3], points: &mut Vec<[f64; 3]>, corners: &mut Vec<[Vertex; 3]>) {
    let first = points.len();
    points.push(corner);
    points.extend(to.map(|by| [corner[0] + by[0], corner[1] + by[1], corner[2] + by[2]]));
    let [a, b, c, d] = [0, 1, 2, 3].map(|at| Vertex::input(first + at));
    corners.extend([[a, c, b], [a, b, d], [b, c, d], [c, a, d]]);
}

/// Tetrahedra along x, side by side: a length for each, and 2^-20 across. Rotated by a quarter turn, each crosses all
/// others.
pub(super) fn needles(n: usize, _: &mut Random) -> Surface {
    let needles = (n / 4).max(1);
    let (mut points, mut corners) = (Vec::new(), Vec::new());
    let thin = power_of_two(-20);
    for at in 0..needles {
        let corner = [-1.0 - count(needles), count(at), 0.0];
        let along = [2.0 * count(needles) + 2.0, 0.0, 0.0];
        tetrahedron(corner, [along, [0.0, thin, 0.0], [0.0, 0.0, thin]], &mut points, &mut corners);
    }
    closed(points, corners)
}

/// Tetrahedra of random sizes up to a half, one in each cell of a lattice.
pub(super) fn crowd(n: usize, rng: &mut Random) -> Surface {
    let many = (n / 4).max(1);
    let side = (1..).find(|side: &usize| side.pow(3) >= many).unwrap_or(1);
    let (mut points, mut corners) = (Vec::new(), Vec::new());
    for at in 0..many {
        let cell = [at / (side * side), at / side % side, at % side];
        let corner = cell.map(|i| count(i) + rng.unit() / 4.0);
        let size = 0.25 + rng.unit() / 4.0;
        let to = [[size, 0.0, 0.0], [rng.unit() / 8.0, size, 0.0], [rng.unit() / 8.0, rng.unit() / 8.0, size]];
        tetrahedron(corner, to, &mut points, &mut corners);
    }
    closed(points, corners)
}
