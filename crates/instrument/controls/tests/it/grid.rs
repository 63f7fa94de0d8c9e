//! Snapping to a grid, right about decimals of its own digits.

use predicament_controls::Grid;
use predicament_predicates::{Backend, Off, Plane, Predicates, Scene, Sign, Vertex};

#[test]
fn decimals_on_a_line_are_on_it_in_their_own_grid_only() {
    let scene = Scene::from_points2(&[[0.1, 0.3], [0.2, 0.6], [0.3, 0.9]]).unwrap();
    let [a, b, c] = [0, 1, 2].map(Vertex::input);
    let turn = |step: f64| Grid::new(step).unwrap().prepare(&scene, Off).unwrap().orient2d(Plane::Xy, a, b, c);
    assert_eq!((turn(0.1), turn(1e-3)), (Sign::Zero, Sign::Zero));
    assert_ne!(turn(2.0_f64.powi(-60)), Sign::Zero, "a grid finer than the doubles snaps nothing");
    assert_eq!(turn(1.0), Sign::Zero, "a coarse grid makes points equal");
    assert!([0.0, -1.0, f64::NAN, f64::INFINITY].iter().all(|&step| Grid::new(step).is_err()));
}
