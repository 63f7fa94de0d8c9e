//! Tests of the sweep by all pairs.

use super::*;
use predicament_mesh::Simplices;
use predicament_predicates::Vertex;

/// A pseudorandom number below `end`, from a fixed sequence.
fn below(state: &mut u64, end: u64) -> u64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) % end
}

/// Tetrahedra, or triangles in the plane, of very different sizes, with integer coordinates.
fn complexes(dimension: Dimension, seed: u64) -> (Scene, [Complex; 2]) {
    let mut state = seed;
    let corners = dimension.count() + 1;
    let mut coordinates = Vec::new();
    for _ in 0..24 {
        let size = 1 << below(&mut state, 6);
        let place: [u64; 3] = std::array::from_fn(|_| below(&mut state, 64));
        for _ in 0..corners {
            for at in &place[..dimension.count()] {
                let along = u32::try_from(at + below(&mut state, size + 1)).unwrap();
                coordinates.push(f64::from(along) - 40.0);
            }
        }
    }
    let scene = Scene::new(dimension, coordinates).unwrap();
    let of = |cells: std::ops::Range<usize>| {
        let first = |cell: usize| cell * corners;
        let given = match dimension {
            Dimension::Two => Simplices {
                triangles: cells.map(|cell| [0, 1, 2].map(|i| Vertex::input(first(cell) + i))).collect(),
                ..Simplices::default()
            },
            Dimension::Three => Simplices {
                tetrahedra: cells.map(|cell| [0, 1, 2, 3].map(|i| Vertex::input(first(cell) + i))).collect(),
                ..Simplices::default()
            },
        };
        Complex::new(&scene, &given).unwrap()
    };
    let both = [of(0..12), of(12..24)];
    (scene, both)
}

fn count(complex: &Complex, rank: u8) -> usize {
    match rank {
        0 => complex.vertices().len(),
        1 => complex.edges().len(),
        2 => complex.triangles().len(),
        _ => complex.tetrahedra().len(),
    }
}

/// True if the boxes are within reach, by the coordinates of their vertices along each axis.
fn are_near(scene: &Scene, [s, t]: [&[Vertex]; 2], reach: f64) -> bool {
    let axes = scene.point(s[0]).len();
    (0..axes).all(|axis| {
        let along = |simplex: &[Vertex]| simplex.iter().map(|&v| scene.point(v)[axis]).collect::<Vec<_>>();
        let (s, t) = (along(s), along(t));
        // Every vertex of the one is below every vertex of the other, by more than the reach.
        let below = |s: &[f64], t: &[f64]| s.iter().all(|s| t.iter().all(|t| t - s > reach));
        !below(&s, &t) && !below(&t, &s)
    })
}

#[test]
fn a_sweep_finds_the_pairs_that_are_near() {
    let mut found = [0, 0];
    for (dimension, ranks) in [
        (Dimension::Two, &[[0, 0], [1, 0], [0, 1], [1, 1], [2, 0], [0, 2]][..]),
        (Dimension::Three, &[[0, 0], [1, 1], [2, 1], [1, 2], [3, 0], [0, 3]][..]),
    ] {
        for seed in 0..6 {
            let (scene, both) = complexes(dimension, seed);
            for (&ranks, reach) in ranks.iter().flat_map(|ranks| [0.0, 1.0, 3.0, 20.0].map(|reach| (ranks, reach))) {
                let [of_a, of_b] = [0, 1].map(|i| {
                    let simplices = 0..u32::try_from(count(&both[i], ranks[i])).unwrap();
                    simplices.map(|index| Simplex { rank: ranks[i], index }).collect::<Vec<_>>()
                });
                let pairs = of_a.iter().flat_map(|&s| of_b.iter().map(move |&t| [s, t]));
                let vertices = |[s, t]: [Simplex; 2]| [both[0].vertices_of(s), both[1].vertices_of(t)];
                let expected: Vec<_> = pairs.filter(|&pair| are_near(&scene, vertices(pair), reach)).collect();
                assert_eq!(near(&scene, both.each_ref(), ranks, reach), expected, "{ranks:?} within {reach}");
                found[usize::from(reach > 0.0)] += expected.len();
            }
        }
    }
    assert!(found[0] > 500 && found[1] > 1000, "{found:?}");
}
