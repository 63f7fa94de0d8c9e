//! Shapes that maps have and shapes that they should not have: holes in islands in lakes, parts that touch, junctions;
//! rings that touch themselves, spikes, rings without area, several vertices at one position.
//!
//! All methods of location are compared, and Simulation of Simplicity is compared with winding numbers of the map that
//! has really moved.

use crate::common::agreement::{Probed, grid, sign_of_d, sign_of_moved_d};
use crate::common::winding::{self, Truth, winding_numbers, with};
use predicament_exact::Exact;
use predicament_polygon_locate::algorithm::special::{Point, locate};
use predicament_polygon_locate::algorithm::{LocateIndex, Scratch};
use predicament_predicates::{Backend, Off, Sign, Vertex};
use predicament_sos::Sos;
use rug::{Integer, Rational};

type Rings<'a> = &'a [&'a [usize]];

/// A map, probed on a grid of halves that extends beyond it.
fn probed(points: &[[f64; 2]], regions: &[Rings]) -> Probed {
    let [low, high] = [-1.0, points.as_flattened().iter().copied().fold(0.0, f64::max) + 1.0];
    on(points, regions, &grid(low, high, 0.5))
}

fn on(points: &[[f64; 2]], regions: &[Rings], places: &[[f64; 2]]) -> Probed {
    let regions: Vec<Vec<Vec<usize>>> =
        regions.iter().map(|rings| rings.iter().map(|ring| ring.to_vec()).collect()).collect();
    Probed::new(points, &regions, places)
}

const NOWHERE: [Vec<u32>; 2] = [Vec::new(), Vec::new()];

/// The regions that a position is in and on, exactly.
fn located(probed: &Probed, place: [f64; 2]) -> [Vec<u32>; 2] {
    let session = Exact.prepare(&probed.scene, Off).unwrap();
    let index = LocateIndex::new(&probed.map, &probed.scene);
    let probe = probed.scene.vertices().find(|&v| probed.scene.point(v) == place).expect("a probe is there");
    let mut scratch = Scratch::new();
    let location = index.locate(&session, probe, &mut scratch);
    [location.inside.to_vec(), location.boundary.to_vec()]
}

fn square(low: f64, high: f64) -> [[f64; 2]; 4] {
    [[low, low], [high, low], [high, high], [low, high]]
}

#[test]
fn a_hole_in_an_island_in_a_lake() {
    let points: Vec<[f64; 2]> = (0..4).flat_map(|at| square(f64::from(at), 10.0 - f64::from(at))).collect();
    let rings: Vec<Vec<usize>> = (0..4).map(|at| (4 * at..4 * at + 4).collect()).collect();
    let [land, lake, island, pond] = [0, 1, 2, 3].map(|at| &rings[at][..]);
    let map = probed(&points, &[&[land, lake, island, pond], &[lake, island], &[pond]]);
    map.check();
    let diagonal = [0.5, 1.5, 2.5, 5.0].map(|at| located(&map, [at, at]));
    assert_eq!(diagonal, [[vec![0], vec![]], [vec![1], vec![]], [vec![0], vec![]], [vec![2], vec![]]]);
    assert_eq!(located(&map, [2., 5.]), [vec![], vec![0, 1]], "on the island's shore");
    assert_eq!(located(&map, [-0.5, 5.]), NOWHERE);
}

#[test]
fn parts_that_touch_in_a_point_and_holes_that_touch_the_shell() {
    let points = [[0., 0.], [2., 0.], [2., 2.], [4., 2.], [4., 4.], [2., 4.], [0., 2.], [1., 1.]];
    // two parts with a common corner; a part whose hole touches it in a corner; a neighbour that fills the hole
    let parts: Rings = &[&[0, 1, 2, 6], &[2, 3, 4, 5]];
    let pierced: Rings = &[&[0, 1, 2, 6], &[2, 7, 1]];
    let map = probed(&points, &[parts, pierced, &[&[2, 7, 1]]]);
    map.check();
    assert_eq!(located(&map, [2., 2.]), [vec![], vec![0, 1, 2]]);
    assert_eq!(located(&map, [1., 0.5]), [vec![0, 1], vec![]]);
    assert_eq!(located(&map, [1.5, 1.]), [vec![0, 2], vec![]]);
    assert_eq!(located(&map, [2.5, 1.5]), NOWHERE, "beside the common corner");
}

#[test]
fn shared_borders_and_t_junctions() {
    let points = [[0., 0.], [4., 0.], [4., 2.], [2., 2.], [0., 2.], [4., 4.], [2., 4.], [0., 4.], [4., 2.]];
    // one region below two; the lower one has the junction's vertex, and then does not have it
    for below in [&[0, 1, 2, 3, 4][..], &[0, 1, 2, 4], &[0, 1, 8, 4]] {
        let map = probed(&points, &[&[below], &[&[4, 3, 6, 7]], &[&[3, 2, 5, 6]]]);
        map.check();
        assert_eq!(located(&map, [2., 2.]), [vec![], vec![0, 1, 2]]);
        assert_eq!(located(&map, [1., 2.]), [vec![], vec![0, 1]]);
        assert_eq!(located(&map, [1., 1.]), [vec![0], vec![]]);
        assert_eq!(located(&map, [3., 3.]), [vec![2], vec![]]);
    }
}

#[test]
fn a_ring_may_visit_a_vertex_twice_and_cross_itself() {
    let points = [[0., 0.], [4., 0.], [4., 4.], [2., 2.], [0., 4.], [1., 1.], [3., 1.]];
    // a figure of eight through vertex 3, a hole that hangs on the shell's vertex, a pentagram
    let eight = probed(&points, &[&[&[0, 1, 3, 2, 4, 3]], &[&[0, 1, 2, 3, 5, 6, 3, 4]]]);
    eight.check();
    assert_eq!(located(&eight, [2., 0.5]), [vec![0, 1], vec![]]);
    assert_eq!(located(&eight, [2., 1.5]), [vec![0], vec![]], "in the hole of the other");
    assert_eq!(located(&eight, [2., 3.]), [vec![0], vec![]]);
    assert_eq!(located(&eight, [2., 2.]), [vec![], vec![0, 1]]);
    let star = [[0., 4.], [10., 4.], [2., 10.], [5., 0.], [8., 10.]];
    let star = probed(&star, &[&[&[0, 1, 2, 3, 4]]]);
    star.check();
    assert_eq!(located(&star, [5., 5.]), NOWHERE, "twice around the middle is outside");
    assert_eq!(located(&star, [1., 7.]), NOWHERE, "between two tips");
    assert_eq!(located(&star, [2., 5.]), [vec![0], vec![]], "in a tip");
    assert_eq!(located(&star, [5., 2.]), [vec![0], vec![]], "in another");
}

#[test]
fn a_spike_bounds_nothing() {
    let points = [[0., 0.], [4., 0.], [4., 4.], [0., 4.], [2., 2.], [2., 6.], [6., 0.]];
    let plain: Rings = &[&[0, 1, 2, 3]];
    // inward, outward, along the lower side's line, and a whole ring of it
    let inward: Rings = &[&[0, 4, 0, 1, 2, 3]];
    let outward: Rings = &[&[0, 1, 2, 5, 2, 3]];
    let along: Rings = &[&[0, 1, 6, 1, 2, 3]];
    let alone: Rings = &[&[0, 1, 2, 3], &[4, 5, 2, 5]];
    for spiked in [inward, outward, along, alone] {
        let map = probed(&points, &[plain, spiked]);
        map.check();
        for place in grid(-1., 7., 0.5) {
            let [inside, boundary] = located(&map, place);
            assert!([&inside, &boundary].iter().all(|list| list.is_empty() || **list == [0, 1]), "at {place:?}");
        }
    }
}

#[test]
fn a_ring_without_area_is_all_boundary() {
    let points = [[0., 0.], [2., 2.], [4., 4.], [4., 0.], [4., 2.], [0., 2.], [2., 2.], [2., 2.]];
    // slanted, vertical, horizontal, and three vertices at one place
    let flat = [[0, 1, 2], [2, 3, 4], [5, 1, 4], [1, 6, 7]];
    for ring in flat {
        let map = probed(&points, &[&[&ring], &[&[0, 3, 2]]]);
        map.check();
        for place in grid(-1., 5., 0.5) {
            let [inside, boundary] = located(&map, place);
            assert!(!inside.contains(&0), "at {place:?}");
            let [low, high] = [0, 1].map(|axis| {
                let along = ring.map(|at| points[at][axis]);
                [along.iter().copied().fold(f64::INFINITY, f64::min), along.iter().copied().fold(0.0, f64::max)]
            });
            let in_box = low[0] <= place[0] && place[0] <= low[1] && high[0] <= place[1] && place[1] <= high[1];
            let is_on = in_box && (ring != [0, 1, 2] || place[0] == place[1]);
            assert_eq!(boundary.contains(&0), is_on, "at {place:?} of {ring:?}");
        }
    }
}

#[test]
fn several_vertices_may_be_at_one_place() {
    let corners = square(0., 2.);
    // the border between two squares twice, a corner twice in one ring, and two squares in one place
    let points = [corners, corners.map(|[x, y]| [x + 2., y]), corners].concat();
    let map = probed(&points, &[&[&[0, 1, 2, 3]], &[&[4, 5, 6, 7]], &[&[0, 8, 1, 2, 10, 3]], &[&[8, 9, 10, 11]]]);
    map.check();
    assert_eq!(located(&map, [2., 1.]), [vec![], vec![0, 1, 2, 3]]);
    assert_eq!(located(&map, [1., 1.]), [vec![0, 2, 3], vec![]]);
}

/// The exponent of ε = 2^-24. With coordinates below 2^4 no coefficient of a determinant comes near it, and there are
/// fewer than 2^4 terms.
const BITS: u32 = 24;

/// The moved vertices: coordinate i by ε^(2^i), all multiplied by the last of these denominators.
fn moved(probed: &Probed) -> Vec<winding::Point> {
    let coordinates = probed.scene.coordinates();
    let last = BITS << (coordinates.len() - 1);
    let along = |(i, &x): (usize, &f64)| {
        let whole = Integer::from(Rational::from_f64(2.0 * x).expect("finite").numer()) << last;
        Rational::from((whole >> 1_u32) + (Integer::from(1) << (last - (BITS << i))))
    };
    let all: Vec<Rational> = coordinates.iter().enumerate().map(along).collect();
    all.chunks(2).map(|pair| [pair[0].clone(), pair[1].clone()]).collect()
}

#[test]
fn a_perturbed_answer_is_that_of_the_map_that_has_moved() {
    let points = [[0., 0.], [4., 0.], [4., 4.], [0., 4.], [2., 2.]];
    let double = [[0., 0.], [4., 0.], [4., 0.], [2., 2.], [2., 2.]];
    let cases: [(&[[f64; 2]; 5], &[Rings]); 7] = [
        (&points, &[&[&[0, 1, 4, 2, 3]], &[&[1, 2, 4]]]),
        (&points, &[&[&[0, 1, 4, 2, 3, 4]]]),       // a figure of eight
        (&points, &[&[&[0, 1, 2, 3], &[0, 4, 2]]]), // a hole without area
        (&points, &[&[&[0, 4, 2]], &[&[0, 4, 0, 1, 2]]]),
        (&points, &[&[&[0, 2, 1, 3]]]), // a bow tie, crossing at vertex 4
        (&double, &[&[&[0, 1, 3]], &[&[0, 2, 4]]]),
        (&double, &[&[&[1, 3, 2, 4]], &[&[0, 1, 2, 3, 4]]]),
    ];
    let sos = Sos::default();
    let mut off_the_exact_answer = 0;
    for (points, regions) in cases.into_iter().step_by(predicament_effort::some_or_all(2, 1)) {
        for place in grid(0., 4., predicament_effort::some_or_all(2., 1.)) {
            let probed = on(points, regions, &[place]);
            let session = sos.prepare(&probed.scene, Off).unwrap();
            let index = LocateIndex::new(&probed.map, &probed.scene);
            let points = moved(&probed);
            let mut scratch = Scratch::new();
            for q in probed.probes(0) {
                let truths = winding_numbers(&probed.map, &|v: Vertex| points[v.index()].clone(), &points[q.index()]);
                let location = index.locate(&session, q, &mut scratch);
                assert_eq!(location.inside, with(&truths, Truth::Inside), "{regions:?} at {place:?} by {q}");
                assert!(location.boundary.is_empty() && with(&truths, Truth::Boundary).is_empty());
                off_the_exact_answer += usize::from(location.inside != located(&probed, place)[0]);
            }
            // the paper's derivation: a point that moves further than the map moves right
            let truths = winding_numbers(
                &probed.map,
                &|v: Vertex| points[v.index()].clone(),
                &points[probed.probes(0)[0].index()],
            );
            let derived = |l: Point, r: Point, p: Point| -> Sign { sign_of_moved_d(l, r, p) };
            let answers = locate(&probed.map, &probed.scene, place, &derived);
            assert!(answers.iter().zip(&truths).all(|(answer, truth)| *answer == Ok(*truth == Truth::Inside)));
            let plain = locate(&probed.map, &probed.scene, place, &sign_of_d);
            assert!(
                plain
                    .iter()
                    .zip(&truths)
                    .all(|(answer, truth)| answer.is_err() || *answer == Ok(*truth == Truth::Inside))
            );
        }
    }
    assert!(off_the_exact_answer > predicament_effort::some_or_all(15, 50), "ties were broken: {off_the_exact_answer}");
}
