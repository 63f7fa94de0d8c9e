//! Cells of a line: against the algorithm, with exact and with perturbed signs.

use predicament_exact::Exact;
use predicament_interval::algorithm::{self as algorithm, half_open};
use predicament_judge::interval::{Place, cells_at, perturbed_place, place};
use predicament_predicates::{Axis, Backend, Off, Scene, Vertex};
use predicament_sos::Sos;

use crate::random::{Grid, Random};

fn same(place: algorithm::Place) -> Place {
    match place {
        algorithm::Place::Outside => Place::Outside,
        algorithm::Place::AtEnd => Place::AtEnd,
        algorithm::Place::Inside => Place::Inside,
    }
}

#[test]
fn known_points_are_in_their_cells() {
    let scene = Scene::from_points2(&[1.0, 0.0, 1.0, 2.0, 1.0].map(|x| [x, 0.0])).unwrap();
    let [first, l, m, r, last] = [0, 1, 2, 3, 4].map(Vertex::input);
    let cells = [[l, m], [m, r]];
    for point in [first, last] {
        assert_eq!(cells_at(&scene, Axis::X, &cells, point), [(0, Place::AtEnd), (1, Place::AtEnd)]);
    }
    // l ≤ p < r for a point numbered before the ends, l < p ≤ r for a point numbered behind them.
    let perturbed = |point| cells.map(|cell| perturbed_place(&scene, Axis::X, cell, point));
    assert_eq!(perturbed(first), [Place::Outside, Place::Inside]);
    assert_eq!(perturbed(last), [Place::Inside, Place::Outside]);
    assert_eq!(perturbed(m), [Place::AtEnd, Place::AtEnd]);
}

#[test]
fn places_are_those_of_exact_and_of_perturbed_signs() {
    let mut random = Random::new(9);
    let mut seen = [0; 3];
    for round in 0..400 {
        let grid = [Grid::Whole, Grid::Fine, Grid::Wide][round % 3];
        let scene = Scene::new(predicament_predicates::Dimension::Two, grid.coordinates(&mut random, 12, 4)).unwrap();
        let sos = Sos::default();
        let (exact, sos) = (Exact.prepare(&scene, Off).unwrap(), sos.prepare(&scene, Off).unwrap());
        for _ in 0..20 {
            let [left, right, point] = [(); 3].map(|()| Vertex::input(random.below(6)));
            let cell = [left, right];
            let truth = place(&scene, Axis::X, cell, point);
            assert_eq!(same(algorithm::place(&exact, Axis::X, cell, point)), truth, "{cell:?} {point} {scene:?}");
            let perturbed = perturbed_place(&scene, Axis::X, cell, point);
            assert_eq!(same(algorithm::place(&sos, Axis::X, cell, point)), perturbed, "{cell:?} {point} {scene:?}");
            if point < left.min(right) {
                let rule = half_open(cell.map(|v| scene.point(v)[0]), scene.point(point)[0]);
                assert_eq!(rule, perturbed == Place::Inside, "{cell:?} {point} {scene:?}");
            }
            seen[truth as usize] += 1;
        }
    }
    assert!(seen.iter().all(|&seen| seen > 200), "{seen:?}");
}
