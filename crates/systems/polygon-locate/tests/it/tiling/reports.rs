//! Tests of single answers against known surroundings: each fault by the smallest answer that has it.

use predicament_exact::Exact;
use predicament_polygon_locate::algorithm::Locations;
use predicament_polygon_locate::checks::{Counts, Fault, tiling_report};
use predicament_polygon_locate::truth::{Flaws, Ground, map_flaws, surroundings};
use predicament_predicates::{Backend, Off, Vertex, ZeroMeaning};

use super::Case;
use crate::common::problems::{Problem, square_cells};

/// Nine cells: the middle one occurs twice, as the regions 8 and 9; the last one is missing.
fn cells() -> Case {
    let (corners, mut regions) = square_cells(3);
    let middle = regions.remove(4);
    regions.pop();
    regions.extend([middle.clone(), middle]);
    // From left to right and upwards: 0 1 2, 3 (7 8) 4, 5 6 and sea.
    Case::new(Problem::new(&corners, &regions))
}

const MEANINGS: [ZeroMeaning; 3] = [ZeroMeaning::Band, ZeroMeaning::Exact, ZeroMeaning::Never];

/// The fault of one answer, by the meaning of zero. The probe is the first or the last one at the point: the last one
/// is the map's own vertex.
fn faults(case: &Case, point: [f64; 2], own: bool, answer: (&[u32], &[u32])) -> [Option<Fault>; 3] {
    let is_there = |probe: &&Vertex| case.problem.scene.point(**probe) == point;
    let probes = &case.problem.probes;
    let probe = if own { probes.iter().rfind(is_there) } else { probes.iter().find(is_there) };
    let exact = Exact.prepare(&case.problem.scene, Off).unwrap();
    let around = surroundings(&case.edges, &exact, &[*probe.unwrap()]);
    assert_eq!((around.len(), around.is_empty(), around.is_map_vertex(0)), (1, false, own));
    let answers = Locations::of([(answer.0.to_vec(), answer.1.to_vec())].into_iter());
    MEANINGS.map(|zero| {
        let report = tiling_report(&around, &answers, zero);
        let [violation] = report.violations() else {
            assert_eq!(report.violations(), []);
            return None;
        };
        assert_eq!((violation.probe, violation.ground), (0, around.ground(0)));
        Some(violation.fault)
    })
}

type Row = (&'static [u32], &'static [u32], [Option<Fault>; 3]);

fn assert_faults(case: &Case, point: [f64; 2], own: bool, rows: &[Row]) {
    for &(inside, boundary, expected) in rows {
        let found = faults(case, point, own, (inside, boundary));
        assert_eq!(found, expected, "in {inside:?} and on {boundary:?} at {point:?}");
    }
}

const NONE: [Option<Fault>; 3] = [None; 3];
const GAP: [Option<Fault>; 3] = [Some(Fault::Gap); 3];
const DOUBLE: [Option<Fault>; 3] = [Some(Fault::Double); 3];
const MISPLACED: [Option<Fault>; 3] = [Some(Fault::Misplaced); 3];
const FALSE: [Option<Fault>; 3] = [None, Some(Fault::FalseBoundary), Some(Fault::FalseBoundary)];
const MISSED: [Option<Fault>; 3] = [None, Some(Fault::MissedBoundary), None];
const UNBROKEN: [Option<Fault>; 3] = [None, None, Some(Fault::UnbrokenTie)];
const HALF: [Option<Fault>; 3] = [None, Some(Fault::MissedBoundary), Some(Fault::UnbrokenTie)];

#[test]
fn answers_inside_a_region_are_judged_by_it() {
    assert_faults(
        &cells(),
        [0.25, 0.125],
        false,
        &[
            (&[0], &[], NONE),
            (&[], &[], GAP),
            (&[1], &[], MISPLACED),
            (&[0, 1], &[], DOUBLE),
            (&[1, 2], &[], DOUBLE),
            (&[], &[0], FALSE),
            (&[0], &[0], FALSE),
            (&[0], &[1], FALSE),
            (&[], &[1], MISPLACED),
            (&[1], &[0], MISPLACED),
        ],
    );
}

#[test]
fn answers_on_a_border_are_judged_by_its_two_sides() {
    let case = cells();
    assert_faults(
        &case,
        [1.0, 0.5],
        false,
        &[
            (&[], &[0, 1], UNBROKEN),
            (&[0], &[], MISSED),
            (&[1], &[], MISSED),
            (&[], &[0], HALF),
            (&[0], &[1], HALF),
            (&[0], &[2], FALSE),
            (&[], &[], GAP),
            (&[2], &[], MISPLACED),
            (&[], &[2], MISPLACED),
            (&[0, 1], &[], DOUBLE),
        ],
    );
    // A vertex of the map is on its own edges, however it moves. A probe with another number at the same position is
    // not.
    assert_faults(&case, [1.0, 0.0], true, &[(&[], &[0, 1], NONE), (&[], &[], MISSED), (&[], &[0, 2], FALSE)]);
    assert_faults(&case, [1.0, 0.0], false, &[(&[], &[0, 1], UNBROKEN), (&[], &[], MISSED)]);
}

#[test]
fn at_a_coast_there_may_be_nothing_and_in_the_sea_there_must_not_be_anything() {
    let case = cells();
    let coast: [Row; 6] = [
        (&[], &[], MISSED),
        (&[0], &[], MISSED),
        (&[], &[0, 3], UNBROKEN),
        (&[0, 3], &[], DOUBLE),
        (&[1], &[], MISPLACED),
        (&[], &[1], FALSE),
    ];
    assert_faults(&case, [0.0, 1.0], false, &coast);
    let sea: [Row; 4] = [(&[], &[], NONE), (&[4], &[], MISPLACED), (&[4, 6], &[], DOUBLE), (&[], &[4], FALSE)];
    assert_faults(&case, [2.25, 2.125], false, &sea);
}

#[test]
fn where_the_map_overlaps_itself_two_regions_are_right_and_none_is_no_gap() {
    let rows: [Row; 6] = [
        (&[7, 8], &[], NONE),
        (&[7], &[8], FALSE),
        (&[], &[], MISPLACED),
        (&[7], &[], MISPLACED),
        (&[3, 7, 8], &[], MISPLACED),
        (&[3, 4], &[], MISPLACED),
    ];
    assert_faults(&cells(), [1.25, 1.125], false, &rows);
}

#[test]
fn answers_are_counted_by_the_ground_and_by_what_they_name() {
    let case = cells();
    let exact = Exact.prepare(&case.problem.scene, Off).unwrap();
    let at = |point: [f64; 2]| *case.problem.probes.iter().find(|v| case.problem.scene.point(**v) == point).unwrap();
    // Ten probes on land, one in the sea.
    let probes: Vec<Vertex> = (0..10).map(|_| at([0.25, 0.125])).chain([at([2.25, 2.125])]).collect();
    let around = surroundings(&case.edges, &exact, &probes);
    let answers = [(&[0][..], &[0][..]), (&[], &[]), (&[], &[]), (&[0], &[]), (&[0], &[]), (&[0], &[]), (&[0, 1], &[])];
    let repeated = answers.into_iter().chain([(&[0, 1][..], &[][..]); 2]).chain([(&[0, 1, 2][..], &[][..])]);
    let answers = Locations::of(repeated.map(|(inside, boundary)| (inside.to_vec(), boundary.to_vec())));
    let report = tiling_report(&around, &answers, ZeroMeaning::Band);
    let land = report.counts(Ground::Land);
    assert_eq!(land, Counts { boundary: 1, none: 2, one: 3, more: 4 });
    assert_eq!(land.probes(), 10);
    assert_eq!(report.counts(Ground::Sea), Counts::default());
    let wrong: Vec<(usize, Fault)> = report.violations().iter().map(|v| (v.probe, v.fault)).collect();
    let gaps = [1, 2].map(|probe| (probe, Fault::Gap));
    assert_eq!(wrong, [&gaps[..], &[6, 7, 8, 9].map(|probe| (probe, Fault::Double))].concat());
}

#[test]
fn gaps_doubles_and_misplaced_answers_are_faults_of_the_topology() {
    let topological = [Fault::Gap, Fault::Double, Fault::Misplaced];
    assert!(topological.into_iter().all(Fault::is_topological));
    let promises = [Fault::FalseBoundary, Fault::MissedBoundary, Fault::UnbrokenTie];
    assert!(!promises.into_iter().any(Fault::is_topological));
}

/// Tests a corner on the middle of another region's side, without an edge on an edge.
#[test]
fn a_corner_on_a_side_is_a_defect_there_alone() {
    let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 4.0], [3.0, 6.0], [1.0, 6.0]];
    let case = Case::new(Problem::new(&corners, &[vec![vec![0, 1, 2, 3]], vec![vec![4, 5, 6]]]));
    let v = Vertex::input;
    assert_eq!(case.flaws, Flaws { junctions: vec![([v(2), v(3)], v(4))], ..Flaws::default() });
    assert_eq!(case.ground_at([2.0, 4.0]), Ground::Defect);
    assert_eq!(case.ground_at([2.0, 6.0]), Ground::Coast);
    assert_eq!(case.ground_at([4.0, 4.0]), Ground::Coast);
    case.assert_lawful();
}

#[test]
fn all_vertices_in_one_place_are_duplicates_of_the_first() {
    // Three triangles with a corner each at the origin, one with −0.
    let corners = [
        [0.0, 0.0],
        [4.0, 1.0],
        [1.0, 4.0],
        [-0.0, 0.0],
        [-1.0, 4.0],
        [-4.0, 1.0],
        [0.0, -0.0],
        [-1.0, -4.0],
        [1.0, -4.0],
    ];
    let case = Case::new(Problem::new(&corners, &[vec![vec![0, 1, 2]], vec![vec![3, 4, 5]], vec![vec![6, 7, 8]]]));
    let v = Vertex::input;
    let exact = Exact.prepare(&case.problem.scene, Off).unwrap();
    let flaws = map_flaws(&case.edges, &exact);
    assert_eq!(flaws, Flaws { duplicates: vec![[v(0), v(3)], [v(0), v(6)]], ..Flaws::default() });
    assert_eq!((flaws.len(), flaws.is_empty(), Flaws::default().is_empty()), (2, false, true));
}
