//! Unions of cubes: against known unions, against cells tested one by one, against the algorithm.

use predicament_cube_union::algorithm::{Mass, ScaledCubes, cube_union, cube_union_by};
use predicament_judge::cubes::{Cubes, Measures, NotCubes, Vertices};
use predicament_predicates::{Backend, Scene, Vertex};
use predicament_predicates::{Dimension, Off};
use predicament_sos::Sos;
use rug::{Integer, Rational};

use crate::random::{Random, cubes, effort};

fn scene(lowers: &[[f64; 3]], edge: f64) -> Scene {
    let points: Vec<[f64; 3]> = lowers.iter().flat_map(|&lower| [lower, lower.map(|c| c + edge)]).collect();
    Scene::from_points3(&points).unwrap()
}

fn measured(scene: &Scene) -> Measures {
    Cubes::of_scene(scene).unwrap().measures()
}

fn measures(of: [i64; 3], [corners, edge_faces, three_faces]: [u64; 3]) -> Measures {
    let [volume, area, edge_length] = of.map(Rational::from);
    Measures { volume, area, edge_length, vertices: Vertices { corners, edge_faces, three_faces } }
}

#[test]
fn known_unions_are_measured() {
    let of = |lowers: &[[f64; 3]], edge: f64| measured(&scene(lowers, edge));
    assert_eq!(of(&[], 1.0), Measures::default());
    assert_eq!(of(&[[-1.0, 5.0, 7.0]], 2.0), measures([8, 24, 24], [8, 0, 0]));
    assert_eq!(of(&[[0.0; 3], [1.0; 3]], 2.0), measures([15, 42, 48], [14, 6, 0]));
    // A common face: open by one order of the cubes, closed by the other; the seam is a step.
    assert_eq!(of(&[[0.0, 0.0, 2.0], [0.0; 3]], 2.0), measures([16, 48, 48], [16, 0, 0]));
    let closed = of(&[[0.0; 3], [0.0, 0.0, 2.0]], 2.0);
    assert_eq!(
        (closed.volume, closed.area, closed.edge_length),
        (Rational::from(16), Rational::from(40), Rational::from(48))
    );
    // n identical cubes: six edges are stairs of n steps.
    let stairs = of(&[[0.0; 3]; 5], 3.0);
    assert_eq!((stairs.volume, stairs.area), (Rational::from(27), Rational::from(54)));
    assert_eq!(stairs.edge_length, 3 * (6 + 6 * (2 * 5 - 1)));
    // Exact beyond 64-bit integers.
    let edge = 2.0_f64.powi(-40);
    let wide = of(&[[2.0_f64.powi(-90); 3], [4096.0; 3]], edge);
    assert_eq!(
        wide,
        Measures {
            volume: Rational::from((2, Integer::from(1) << 120)),
            area: Rational::from((12, Integer::from(1) << 80)),
            edge_length: Rational::from((24, Integer::from(1) << 40)),
            vertices: Vertices { corners: 16, ..Vertices::default() },
        }
    );
}

#[test]
fn what_is_no_scene_of_cubes_is_refused() {
    let refused = |points: &[[f64; 3]]| Cubes::of_scene(&Scene::from_points3(points).unwrap()).unwrap_err();
    assert_eq!(refused(&[[0.0; 3]]), NotCubes::NoPairs);
    assert_eq!(refused(&[[0.0; 3]; 2]), NotCubes::Extent { cube: 0, axis: 0 });
    assert_eq!(refused(&[[1.0; 3], [0.0; 3]]), NotCubes::Extent { cube: 0, axis: 0 });
    assert_eq!(refused(&[[0.0; 3], [1.0, 1.0, 2.0]]), NotCubes::Extent { cube: 0, axis: 2 });
    assert_eq!(refused(&[[0.0; 3], [1.0; 3], [1.0; 3], [2.0, 2.5, 2.0]]), NotCubes::Extent { cube: 1, axis: 1 });
    let flat = Scene::from_points2(&[[0.0; 2], [1.0; 2]]).unwrap();
    assert_eq!(Cubes::of_scene(&flat), Err(NotCubes::NoPairs));
}

/// The lower corners and the edge of a scene of cubes with small integers.
#[allow(clippy::cast_possible_truncation)] // small integers
fn integers(scene: &Scene) -> (Vec<[i64; 3]>, i64) {
    let at = |v: usize| scene.point3(Vertex::input(v)).map(|c| c as i64);
    ((0..scene.len() / 2).map(|cube| at(2 * cube)).collect(), at(1)[0] - at(0)[0])
}

/// The measures by definition, cell by cell. Cubes are really moved, by less than a unit; every cell between all planes
/// is tested against every cube. Widths are those before moving.
fn by_cells(lowers: &[[i64; 3]], edge: i64) -> Measures {
    let count = i64::try_from(lowers.len()).unwrap();
    let scale = 2 * count + 2;
    let by = |cube: usize| 2 * (count - i64::try_from(cube).unwrap());
    let planes = [0, 1, 2].map(|axis| {
        let mut planes: Vec<(i64, i64)> = lowers
            .iter()
            .enumerate()
            .flat_map(|(cube, lower)| [lower[axis], lower[axis] + edge].map(|at| (scale * at + by(cube), at)))
            .collect();
        planes.sort_unstable();
        planes
    });
    let cells = planes[0].len() + 1;
    // Cell i along an axis contains a point just behind plane i − 1.
    let inner = |axis: usize, i: usize| if i == 0 { i64::MIN } else { planes[axis][i - 1].0 + 1 };
    let is_filled = |cell: [usize; 3]| {
        let point = [0, 1, 2].map(|axis| inner(axis, cell[axis]));
        (0..lowers.len()).any(|cube| {
            (0..3).all(|axis| {
                let low = scale * lowers[cube][axis] + by(cube);
                low < point[axis] && point[axis] < low + scale * edge
            })
        })
    };
    let width = |axis: usize, i: usize| match i {
        0 => 0,
        _ if i == planes[axis].len() => 0,
        _ => planes[axis][i].1 - planes[axis][i - 1].1,
    };
    let all: Vec<[usize; 3]> =
        (0..cells).flat_map(|x| (0..cells).flat_map(move |y| (0..cells).map(move |z| [x, y, z]))).collect();
    let filled: Vec<bool> = all.iter().map(|&cell| is_filled(cell)).collect();
    let at = |[x, y, z]: [usize; 3]| filled[(x * cells + y) * cells + z];
    let (mut sums, mut kinds) = ([0_i64; 3], [0; 3]);
    for &cell in &all {
        let next = |steps: [usize; 3]| [0, 1, 2].map(|axis| cell[axis] + steps[axis]);
        let widths = [0, 1, 2].map(|axis| width(axis, cell[axis]));
        sums[0] += i64::from(at(cell)) * widths.iter().product::<i64>();
        for axis in 0..3 {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            let step = |axes: &[usize]| [0, 1, 2].map(|axis| usize::from(axes.contains(&axis)));
            let is_last = |axis: usize| cell[axis] + 1 == cells;
            if !is_last(axis) && at(cell) != at(next(step(&[axis]))) {
                sums[1] += widths[j] * widths[k];
            }
            if !is_last(j) && !is_last(k) {
                let quads = [at(cell), at(next(step(&[j]))), at(next(step(&[k]))), at(next(step(&[j, k])))];
                let is_edge = quads[0] ^ quads[1] ^ quads[2] ^ quads[3] || quads[0] == quads[3] && quads[0] != quads[1];
                sums[2] += i64::from(is_edge) * widths[axis];
            }
        }
        if cell.iter().all(|&i| i + 1 < cells) {
            let octants = (0..8).filter(|i| at(next([i >> 2, i >> 1 & 1, i & 1]))).count();
            for (kind, octants_of_kind) in kinds.iter_mut().zip([1, 5, 7]) {
                *kind += u64::from(octants == octants_of_kind);
            }
            assert_ne!(octants, 3);
        }
    }
    measures(sums, kinds)
}

/// The volume by inclusion and exclusion.
fn by_inclusion(lowers: &[[i64; 3]], edge: i64) -> i64 {
    (1_u32..1 << lowers.len())
        .map(|set| {
            let chosen = || (0..lowers.len()).filter(|cube| set >> cube & 1 == 1).map(|cube| lowers[cube]);
            let extent = |axis: usize| {
                let along = || chosen().map(move |lower| lower[axis]);
                (along().min().unwrap() + edge - along().max().unwrap()).max(0)
            };
            let sign = if set.count_ones() % 2 == 1 { 1 } else { -1 };
            sign * (0..3).map(extent).product::<i64>()
        })
        .sum()
}

#[test]
fn sections_measure_what_cells_and_inclusion_do() {
    let mut random = Random::new(6);
    for round in 0..200 * effort() {
        let (count, end, edge) = (1 + round % 5, 1 + random.below(5), 1 + random.below(4));
        let scene = cubes(&mut random, count, end, f64::from(u32::try_from(edge).unwrap()), 1.0);
        let (lowers, edge) = integers(&scene);
        let found = measured(&scene);
        assert_eq!(found, by_cells(&lowers, edge), "{lowers:?} of {edge}");
        assert_eq!(found.volume, by_inclusion(&lowers, edge), "{lowers:?} of {edge}");
    }
}

/// The measures that an algorithm found, in the scene's units.
pub fn in_scene_units(mass: &Mass, exponent: i32) -> Measures {
    let scaled = |sum: i128, lengths: i32| Rational::from(Integer::from(sum)) << (lengths * exponent);
    let of = mass.vertices;
    Measures {
        volume: scaled(mass.volume, 3),
        area: scaled(mass.area, 2),
        edge_length: scaled(mass.edge_length, 1),
        vertices: Vertices { corners: of.corners, edge_faces: of.edge_faces, three_faces: of.three_faces },
    }
}

/// The measures from the algorithm on integers, in the scene's units.
fn by_algorithm(scene: &Scene) -> Measures {
    let cubes = ScaledCubes::of_scene(scene).unwrap();
    in_scene_units(&cube_union(&cubes.lowers, cubes.edge).unwrap(), cubes.exponent)
}

#[test]
fn the_algorithm_measures_the_same() {
    let mut random = Random::new(7);
    let sos = Sos::default();
    for round in 0..300 * effort() {
        let (count, end, edge) = (1 + random.below(40), 1 + random.below(12), 1 + random.below(7));
        let unit = [1.0, 0.125, 3.0, 1e-300][round % 4];
        let edge = f64::from(u32::try_from(edge).unwrap());
        let unit = if round % 4 == 3 { 2.0_f64.powi(-1000) } else { unit };
        let scene = cubes(&mut random, count, end, edge, unit);
        let truth = measured(&scene);
        assert_eq!(by_algorithm(&scene), truth, "{scene:?}");
        if round % 10 == 0 {
            let (mass, exponent) = cube_union_by(&sos.prepare(&scene, Off).unwrap()).unwrap();
            assert_eq!(in_scene_units(&mass, exponent), truth, "{scene:?}");
        }
    }
    // More cubes than bits in a word, spread out and crowded.
    for (count, end, edge) in [(300, 1000, 150.0), (150, 3, 2.0), (200, 20, 5.0)] {
        let scene = cubes(&mut random, count, end, edge, 1.0);
        assert_eq!(by_algorithm(&scene), measured(&scene));
    }
}

#[test]
fn a_sample_is_a_dense_part_of_the_whole() {
    let mut random = Random::new(8);
    let scene = cubes(&mut random, 1000, 100, 10.0, 1.0);
    let all = Cubes::of_scene(&scene).unwrap();
    assert_eq!(all.sample_of(1000), (0..1000).collect::<Vec<_>>());
    assert_eq!(all.sample().len(), 250);
    let part = all.sample_of(150);
    assert_eq!(part.len(), 125, "1000 halved until 150 are enough");
    assert!(part.is_sorted());
    assert_eq!(part, all.sample_of(150));
    // The part is measured as a scene with these cubes alone.
    let points: Vec<[f64; 3]> =
        part.iter().flat_map(|&cube| [2 * cube, 2 * cube + 1]).map(|v| scene.point3(Vertex::input(v))).collect();
    let alone = Scene::from_points3(&points).unwrap();
    assert_eq!(all.only(&part).measures(), measured(&alone));
    assert_eq!(alone.dimension(), Dimension::Three);
    // Halves across each axis: the part is in the lower half of the box along all of them.
    let high = points.iter().step_by(2).flatten().copied().fold(0.0, f64::max);
    assert!(high < 60.0, "{high}");
    // Identical cubes are halved as well.
    let same = Cubes::of_scene(&cubes(&mut random, 64, 1, 1.0, 1.0)).unwrap();
    assert_eq!(same.sample_of(10), (0..8).collect::<Vec<_>>());
}
