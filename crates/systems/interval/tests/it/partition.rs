//! Cells of a line: the check without a judge, and the rule without infinitesimals.

use predicament_exact::Exact;
use predicament_interval::algorithm::{Place, cells_at, half_open, place};
use predicament_interval::checks::{PartitionFault, partition_fault};
use predicament_judge::interval as judge;
use predicament_predicates::{Axis, Backend, Off, Scene, Vertex};
use predicament_sos::{Scheme, Sos};

use Place::{AtEnd, Inside, Outside};

#[test]
fn a_partition_has_each_point_once() {
    let legal: [(Place, &[Place]); 6] = [
        (Outside, &[]),
        (Outside, &[Outside]),
        (Inside, &[Inside, Outside]),
        (Inside, &[AtEnd, AtEnd]),
        (Inside, &[AtEnd, AtEnd, AtEnd]),
        (AtEnd, &[AtEnd]),
    ];
    for (whole, found) in legal {
        assert_eq!(partition_fault(whole, found.iter().copied()), None, "{whole:?} {found:?}");
    }
    let broken: [(Place, &[Place], PartitionFault); 9] = [
        (Outside, &[Inside], PartitionFault::Stray),
        (Outside, &[AtEnd], PartitionFault::Stray),
        (Inside, &[], PartitionFault::Gap),
        (AtEnd, &[Outside], PartitionFault::Gap),
        (Inside, &[Inside, Inside], PartitionFault::Double),
        (Inside, &[Inside, AtEnd], PartitionFault::Double),
        // Two ends are in the place where two cells meet.
        (Inside, &[AtEnd], PartitionFault::Double),
        (AtEnd, &[Inside], PartitionFault::Double),
        (AtEnd, &[AtEnd, Inside], PartitionFault::Double),
    ];
    for (whole, found, fault) in broken {
        assert_eq!(partition_fault(whole, found.iter().copied()), Some(fault), "{whole:?} {found:?}");
    }
}

/// The judge's name of a place.
fn judged(place: judge::Place) -> Place {
    match place {
        judge::Place::Outside => Outside,
        judge::Place::AtEnd => AtEnd,
        judge::Place::Inside => Inside,
    }
}

/// Every choice of three coordinates out of 0, 1 and 2, for a point and the
/// two ends of a cell in every order of their numbers.
fn each_triple(mut visit: impl FnMut(&Scene, [Vertex; 2], Vertex)) {
    for values in 0..27 {
        let at = |i: u32| f64::from(values / 3_i32.pow(i) % 3);
        let scene = Scene::from_points2(&[[0.0, at(0)], [7.0, at(1)], [-7.0, at(2)]]).unwrap();
        for [l, r, p] in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            visit(&scene, [l, r].map(Vertex::input), Vertex::input(p));
        }
    }
}

#[test]
fn the_rule_is_what_simulation_of_simplicity_answers() {
    let mut ties = 0;
    each_triple(|scene, cell, point| {
        for scheme in [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke] {
            let sos = Sos { scheme };
            let session = sos.prepare(scene, Off).unwrap();
            let rule = judged(judge::perturbed_place(scene, Axis::Y, cell, point));
            let found = place(&session, Axis::Y, cell, point);
            assert_eq!(found, rule, "{:?}: {point} in {cell:?}", scene.coordinates());
        }
        let exact = Exact.prepare(scene, Off).unwrap();
        let truth = judged(judge::place(scene, Axis::Y, cell, point));
        assert_eq!(place(&exact, Axis::Y, cell, point), truth);
        ties += usize::from(truth == AtEnd);
    });
    assert!(ties > 50, "{ties}");
}

#[test]
fn a_point_that_is_moved_further_obeys_the_rule_of_the_paper() {
    each_triple(|scene, cell, point| {
        let along = |vertex| scene.coordinate(Axis::Y, vertex);
        let rule = judge::perturbed_place(scene, Axis::Y, cell, point) == judge::Place::Inside;
        if cell.iter().all(|&end| point < end) {
            assert_eq!(rule, half_open(cell.map(along), along(point)));
        } else if cell.iter().all(|&end| point > end) {
            let [left, right] = cell.map(along);
            assert_eq!(rule, left < along(point) && along(point) <= right);
        }
    });
}

#[test]
fn points_in_a_chain_with_repeated_ends_are_in_one_cell() {
    // Ends at 0, 1, 1, 1, 2, of equal ones the larger number first; probes before and behind.
    let along = [0.0, 1.0, 2.0, 0.0, 1.0, 1.0, 1.0, 2.0, 0.0, 1.0, 2.0];
    let points: Vec<[f64; 2]> = along.iter().map(|&x| [x, 0.0]).collect();
    let scene = Scene::from_points2(&points).unwrap();
    let ends = [3, 6, 5, 4, 7].map(Vertex::input);
    let cells: Vec<[Vertex; 2]> = ends.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let sos = Sos::default();
    let (sos, exact) = (sos.prepare(&scene, Off).unwrap(), Exact.prepare(&scene, Off).unwrap());
    for (probe, inside) in [(0, Some(0)), (1, Some(3)), (2, None), (8, None), (9, Some(0)), (10, Some(3))] {
        let probe = Vertex::input(probe);
        let found: Vec<_> = cells_at(&sos, Axis::X, &cells, probe).collect();
        assert_eq!(found, inside.map(|cell| (cell, Inside)).into_iter().collect::<Vec<_>>(), "{probe}");
        let places = cells_at(&exact, Axis::X, &cells, probe).map(|(_, place)| place);
        assert_eq!(partition_fault(place(&exact, Axis::X, [ends[0], ends[4]], probe), places), None);
    }
}
