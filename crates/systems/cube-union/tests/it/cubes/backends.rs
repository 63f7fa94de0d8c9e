//! The union by each kind of backend.

use predicament_controls::{Epsilon, Naive};
use predicament_cube_union::algorithm::{CubesError, Mass, cube_union, cube_union_by};
use predicament_cube_union::checks::{Ties, measured_by};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Scene};
use predicament_sos::{Scheme, Sos};
use predicament_tolerance::Tolerance;

use super::scenes::{Random, lattice};
use super::union::measures;

pub fn scene(lowers: &[[i64; 3]], edge: i64) -> Scene {
    let corner = |lower: [i64; 3], by: i64| lower.map(|c| f64::from(i32::try_from(c + by).unwrap()));
    let points: Vec<[f64; 3]> = lowers.iter().flat_map(|&lower| [corner(lower, 0), corner(lower, edge)]).collect();
    Scene::from_points3(&points).unwrap()
}

fn by<B: Backend>(backend: &B, scene: &Scene) -> Result<Mass, CubesError> {
    let session = backend.prepare(scene, Off).map_err(CubesError::Declined)?;
    cube_union_by(&session).map(|(mass, exponent)| {
        assert_eq!(exponent, 0, "an odd number is among the coordinates");
        mass
    })
}

#[test]
fn perturbed_sessions_agree_with_the_fast_path() {
    let mut random = Random::new(20);
    for round in 0..200 {
        let (count, end, edge) = (1 + round % 40, 1 + random.below(8), 1 + 2 * random.below(3));
        let lowers = random.lowers(count, end);
        let (scene, truth) = (scene(&lowers, edge), cube_union(&lowers, edge).unwrap());
        for scheme in [Scheme::PerCoordinate, Scheme::EdelsbrunnerMucke] {
            assert_eq!(by(&Sos { scheme }, &scene), Ok(truth), "{lowers:?} of {edge}");
        }
    }
}

#[test]
fn without_ties_signs_are_enough() {
    let mut random = Random::new(21);
    let [x, y, z] = [(); 3].map(|()| random.shuffled(&(0..300).map(|i| 10 * i).collect::<Vec<i64>>()));
    let lowers: Vec<[i64; 3]> = (0..300).map(|i| [x[i], y[i], z[i]]).collect();
    let (scene, truth) = (scene(&lowers, 505), cube_union(&lowers, 505).unwrap());
    assert_eq!(by(&Exact, &scene), Ok(truth));
    assert_eq!(by(&Naive::default(), &scene), Ok(truth));
    assert_eq!(by(&Sos::default(), &scene), Ok(truth));
}

#[test]
fn ties_are_broken_or_make_closed_cubes() {
    let mut random = Random::new(22);
    let touching = [[0, 0, 0], [0, 0, 3]];
    let at_an_edge = [[0, 0, 0], [0, 3, 3]];
    let at_a_corner = [[3, 3, 3], [0, 0, 0]];
    let twins = [[0, 0, 0], [0, 0, 0]];
    let crowd = random.lowers(60, 9);
    for lowers in [&touching[..], &at_an_edge, &at_a_corner, &twins, &lattice(3, 3), &crowd] {
        let of = scene(lowers, 3);
        assert_eq!(by(&Sos::default(), &of), cube_union(lowers, 3), "{lowers:?}");
        let closed = by(&Exact, &of).unwrap();
        assert_eq!(measures(&closed), measured_by(lowers, 3, Ties::Merged), "{lowers:?}");
        // Comparisons of doubles are exact, and integers are farther apart than epsilon.
        let others =
            [by(&Naive::default(), &of), by(&Epsilon::default(), &of), by(&Tolerance, &of)].map(Result::unwrap);
        assert_eq!(others, [closed; 3], "{lowers:?}");
    }
}

#[test]
fn a_fixed_epsilon_makes_ties_where_there_are_none() {
    let lowers = [[0.0; 3], [0.25; 3]].map(|lower| lower.map(|c: f64| c * 2.0_f64.powi(-33)));
    let points: Vec<[f64; 3]> = lowers.iter().flat_map(|&lower| [lower, lower.map(|c| c + 0.5)]).collect();
    let scene = Scene::from_points3(&points).unwrap();
    let by = |found: Result<(Mass, i32), CubesError>| found.unwrap().0;
    let truth = by(cube_union_by(&Exact.prepare(&scene, Off).unwrap()));
    assert_eq!(by(cube_union_by(&Sos::default().prepare(&scene, Off).unwrap())), truth);
    assert_eq!(truth.vertices.euler_characteristic(), Some(2));
    // The cubes are 2^-35 apart, which is less than 1e-10.
    assert_ne!(by(cube_union_by(&Epsilon::default().prepare(&scene, Off).unwrap())), truth);
}
