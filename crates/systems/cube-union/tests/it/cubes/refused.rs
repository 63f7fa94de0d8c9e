//! Inputs that are not a set of congruent cubes.

use predicament_cube_union::algorithm::{CubesError, ScaledCubes, cube_union, cube_union_by};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Scene};

#[test]
fn an_edge_must_be_positive() {
    for edge in [0, -1, i32::MIN] {
        let error = cube_union(&[[0, 0, 0]], edge).unwrap_err();
        assert_eq!(error, CubesError::Edge { edge: f64::from(edge) });
        assert!(error.to_string().contains(&edge.to_string()) && error.to_string().contains("positive"), "{error}");
        assert_eq!(cube_union(&[], edge), Err(error), "also without cubes");
    }
    for edge in [0.0, -0.5, f64::NAN, f64::INFINITY] {
        assert!(matches!(ScaledCubes::new(&[], edge), Err(CubesError::Edge { .. })));
    }
}

#[test]
fn sums_must_not_overflow() {
    // 2^42, 2^42 and 2^43 are the first extents whose product needs 128 bits.
    let far = [(1_i64 << 42) - 1, (1 << 42) - 1, (1 << 43) - 1];
    let error = cube_union(&[[0, 0, 0], far], 1).unwrap_err();
    assert_eq!(error, CubesError::TooLarge { extents: [1 << 42, 1 << 42, 1 << 43] });
    assert!(error.to_string().contains("8796093022208"), "{error}");
    let near = [far[0], far[1], far[2] - 1];
    assert_eq!(cube_union(&[[0, 0, 0], near], 1).unwrap().volume, 2);
    // A cube that almost fills the range, and one that overflows 64 bits.
    let large = (1_i64 << 42) + (1 << 40);
    assert_eq!(cube_union(&[[-1; 3]], large).unwrap().volume, i128::from(large).pow(3));
    let ends = [[i64::MIN; 3], [i64::MAX; 3]];
    assert!(matches!(cube_union(&ends, i64::MAX), Err(CubesError::TooLarge { .. })));
    assert!(matches!(cube_union(&[[0, 0, 0], [1_i64 << 62, 0, 0]], 1), Err(CubesError::TooLarge { .. })));
}

#[test]
fn floating_point_is_scaled_or_refused() {
    let cubes = ScaledCubes::new(&[[0.5, -0.0, 3.0], [-1.25, 8.0, 0.0]], 1.5).unwrap();
    assert_eq!((cubes.lowers, cubes.edge, cubes.exponent), (vec![[2, 0, 12], [-5, 32, 0]], 6, -2));
    let tiny = ScaledCubes::new(&[[5e-324, 0.0, 1e-323]], 5e-324).unwrap();
    assert_eq!((tiny.lowers, tiny.edge, tiny.exponent), (vec![[1, 0, 2]], 1, -1074));
    let huge = ScaledCubes::new(&[[f64::MAX, 0.0, -f64::MAX]], f64::MAX).unwrap();
    assert_eq!((huge.lowers, huge.exponent), (vec![[(1 << 53) - 1, 0, 1 - (1 << 53)]], 971));

    let error = ScaledCubes::new(&[[0.0; 3], [0.0, 1e-10, 0.0], [0.0, 0.0, 1e10]], 1.0).unwrap_err();
    assert!(matches!(error, CubesError::TooFine { largest: Some(2), finest: Some(1), bits: 63.. }), "{error:?}");
    assert!(error.to_string().contains("in a common unit of cube 2 and cube 1, coordinates take"), "{error}");
    let error = ScaledCubes::new(&[[0.0; 3], [0.0, 1e10, f64::NAN]], 1.0).unwrap_err();
    assert!(matches!(error, CubesError::NotFinite { cube: 1, axis: 2, .. }), "{error:?}");
    // 62 bits are accepted, 63 are not.
    assert!(ScaledCubes::new(&[[0.0, 2.0_f64.powi(61), 0.0]], 1.0).is_ok());
    assert!(matches!(
        ScaledCubes::new(&[[0.0, 2.0_f64.powi(62), 0.0]], 1.0),
        Err(CubesError::TooFine { largest: Some(0), finest: None, bits: 63 })
    ));
}

fn of_points(points: &[[f64; 3]]) -> Result<i128, CubesError> {
    let scene = Scene::from_points3(points).unwrap();
    let session = Exact.prepare(&scene, Off).unwrap();
    cube_union_by(&session).map(|(mass, _)| mass.volume)
}

#[test]
fn scenes_must_be_of_congruent_cubes() {
    let [a, b] = [[0.0; 3], [2.0; 3]];
    assert_eq!(of_points(&[]), Ok(0));
    assert_eq!(of_points(&[a, b]), Ok(1), "in units of 2");
    assert_eq!(of_points(&[a, b, a]), Err(CubesError::NoPairs { vertices: 3, dimension: 3 }));
    assert_eq!(of_points(&[a, b, a, [2.0, 2.5, 2.0]]), Err(CubesError::Unequal { cube: 1, axis: 1 }));
    assert_eq!(of_points(&[a, b, b, a]), Err(CubesError::Unequal { cube: 1, axis: 0 }));
    assert_eq!(of_points(&[b, a]), Err(CubesError::Edge { edge: -2.0 }));
    assert_eq!(of_points(&[a, a]), Err(CubesError::Edge { edge: 0.0 }));
    // 0.1 + 0.2 is not 0.3: rounded sums do not give congruent cubes.
    let error = of_points(&[[0.0; 3], [0.2; 3], [0.1; 3], [0.1 + 0.2; 3]]).unwrap_err();
    assert!(error.to_string().contains("cube 1: its extent along axis 0"), "{error}");
    let flat = Scene::from_points2(&[[0.0; 2], [1.0; 2]]).unwrap();
    let session = Exact.prepare(&flat, Off).unwrap();
    let error = cube_union_by(&session).unwrap_err();
    assert_eq!(error, CubesError::NoPairs { vertices: 2, dimension: 2 });
}
