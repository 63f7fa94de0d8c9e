//! Points in maps: against hand-made maps, against winding numbers, against the algorithm.

use predicament_exact::Exact;
use predicament_judge::locate::{Borders, Location, locate};
use predicament_judge::rational;
use predicament_polygon_locate::algorithm::{LocateIndex, Scratch};
use predicament_predicates::{Backend, Off, Scene, Vertex};
use rug::Rational;

use crate::random::{Grid, Random, Regions, effort, map};

fn rings(of: &[&[&[usize]]]) -> Regions {
    let ring = |ring: &&[usize]| ring.iter().map(|&i| Vertex::input(i)).collect();
    of.iter().map(|rings| rings.iter().map(ring).collect()).collect()
}

/// The locations of probes, which are numbered after the map's vertices, as lists of regions inside and on the
/// boundary.
fn located(points: &[[f64; 2]], regions: &[&[&[usize]]], probes: &[[f64; 2]]) -> Vec<[Vec<u32>; 2]> {
    let scene = Scene::from_points2(&[points, probes].concat()).unwrap();
    let probes: Vec<Vertex> = (points.len()..scene.len()).map(Vertex::input).collect();
    locate(&scene, &rings(regions), &probes).into_iter().map(|found| [found.inside, found.boundary]).collect()
}

#[test]
fn known_points_are_where_they_are() {
    // Two squares side by side; the first has a lake with an island, the third region.
    let points = [
        [0.0, 0.0],
        [4.0, 0.0],
        [8.0, 0.0],
        [8.0, 4.0],
        [4.0, 4.0],
        [0.0, 4.0],
        [1.0, 1.0],
        [3.0, 1.0],
        [3.0, 3.0],
        [1.0, 3.0],
    ];
    let regions: [&[&[usize]]; 3] = [&[&[0, 1, 4, 5], &[6, 7, 8, 9]], &[&[1, 2, 3, 4]], &[&[9, 8, 7, 6]]];
    let probes =
        [[0.5, 2.0], [2.0, 2.0], [1.0, 2.0], [4.0, 2.0], [4.0, 4.0], [6.0, 1.0], [9.0, 1.0], [0.5, 1.0], [-1.0, 4.0]];
    let expected: [[&[u32]; 2]; 9] = [
        [&[0], &[]],
        [&[2], &[]],
        [&[], &[0, 2]],
        [&[], &[0, 1]],
        [&[], &[0, 1]],
        [&[1], &[]],
        [&[], &[]],
        [&[0], &[]],
        [&[], &[]],
    ];
    assert_eq!(located(&points, &regions, &probes), expected.map(|lists| lists.map(<[u32]>::to_vec)));
}

#[test]
fn odd_rings_follow_the_even_odd_rule() {
    // A pentagram: its center is outside.
    let points = [[0.0, 3.0], [2.0, -3.0], [-3.0, 1.0], [3.0, 1.0], [-2.0, -3.0]];
    let found = located(&points, &[&[&[0, 1, 2, 3, 4]]], &[[0.0, 0.0], [0.0, 2.0], [0.0, 1.0], [0.0, 3.0]]);
    assert_eq!(found, [[vec![], vec![]], [vec![0], vec![]], [vec![], vec![0]], [vec![], vec![0]]]);
    // A spike that runs forth and back cancels out; a spike to another vertex at the same place does not.
    let points = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [4.0, 0.0], [2.0, 0.0]];
    for (ring, on) in [([0, 1, 3, 1, 2], vec![]), ([0, 1, 3, 4, 2], vec![0])] {
        assert_eq!(located(&points, &[&[&ring]], &[[3.0, 0.0]]), [[vec![], on]]);
    }
    // A ring without area contains nothing, but is a boundary.
    let points = [[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]];
    let found = located(&points, &[&[&[0, 1, 2]]], &[[2.0, 2.0], [1.0, 2.0], [4.0, 4.0]]);
    assert_eq!(found, [[vec![], vec![0]], [vec![], vec![]], [vec![], vec![]]]);
}

/// The location by winding numbers: the sum over a region's rings is odd inside. A ring's winding number counts its
/// signed crossings of the positive y axis through the point, in rationals.
fn by_winding(scene: &Scene, regions: &Regions, probe: Vertex) -> Location {
    let at = |v: Vertex| scene.point(v).iter().map(|&x| rational(x)).collect::<Vec<Rational>>();
    let p = at(probe);
    let from_p = |v: Vertex| -> [Rational; 2] { [0, 1].map(|axis| Rational::from(&at(v)[axis] - &p[axis])) };
    let cross = |u: &[Rational; 2], v: &[Rational; 2]| Rational::from(&u[0] * &v[1]) - Rational::from(&u[1] * &v[0]);
    let mut found = Location::default();
    for (region, rings) in (0..).zip(regions) {
        let edges: Vec<[Vertex; 2]> =
            rings.iter().flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]])).collect();
        let same = |e: &[Vertex; 2], f: &[Vertex; 2]| e == f || *e == [f[1], f[0]];
        let is_odd = |edge: &[Vertex; 2]| edges.iter().filter(|other| same(edge, other)).count() % 2 == 1;
        let touches = |edge: &[Vertex; 2]| {
            let [u, v] = edge.map(from_p);
            let dot = Rational::from(&u[0] * &v[0]) + Rational::from(&u[1] * &v[1]);
            cross(&u, &v) == 0 && dot <= 0
        };
        if edges.iter().any(|edge| is_odd(edge) && touches(edge)) {
            found.boundary.push(region);
            continue;
        }
        let mut winding = 0;
        for edge in edges.iter().filter(|edge| is_odd(edge)) {
            let [u, v] = edge.map(from_p);
            let side = cross(&u, &v);
            // Left of the axis means x < 0; the axis itself counts as right.
            winding += match (u[0] < 0, v[0] < 0) {
                (false, true) if side > 0 => 1,
                (true, false) if side < 0 => -1,
                _ => 0,
            };
        }
        if winding % 2 != 0 {
            found.inside.push(region);
        }
    }
    found
}

#[test]
fn crossing_numbers_are_winding_numbers_and_what_the_algorithm_finds() {
    let mut random = Random::new(5);
    let mut seen = [0; 3];
    for round in 0..800 * effort() {
        let grid = [Grid::Whole, Grid::Whole, Grid::Fine, Grid::Wide][round % 4];
        let (scene, regions, map) = map(&mut random, grid);
        let borders = Borders::new(&scene, &regions);
        let (index, session) = (LocateIndex::new(&map, &scene), Exact.prepare(&scene, Off).unwrap());
        let mut scratch = Scratch::new();
        for probe in scene.vertices() {
            let truth = borders.locate(probe);
            let context = || format!("{probe} in {regions:?} of {scene:?}");
            if round % 5 == 0 {
                assert_eq!(truth, by_winding(&scene, &regions, probe), "{}", context());
            }
            let by_grid = index.locate(&session, probe, &mut scratch);
            assert_eq!((by_grid.inside, by_grid.boundary), (&truth.inside[..], &truth.boundary[..]), "{}", context());
            let asked = index.question(&session, probe, &mut scratch);
            assert_eq!((asked.inside, asked.boundary), (&truth.inside[..], &truth.boundary[..]), "{}", context());
            let kinds = [!truth.inside.is_empty(), !truth.boundary.is_empty(), truth == Location::default()];
            seen.iter_mut().zip(kinds).for_each(|(seen, is)| *seen += usize::from(is));
        }
    }
    assert!(seen.iter().all(|&seen| seen > 500), "{seen:?}");
}
