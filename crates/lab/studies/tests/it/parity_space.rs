//! Broken curves of intersection: the smallest scenes found, and the search that found them.

use predicament_studies::Precision;
use predicament_studies::parity::smallest;
use predicament_studies::parity::space::{
    Broken, Census, Recipe, Surface, SurfacePair, examine, random_surfaces, search, shrink_broken,
};
use predicament_studies::shrink::Shrink;
use predicament_tasks::Contestant;

use crate::backend;

const NAMES: [&str; 5] = ["exact", "sos", "sos:per-mesh", "tolerance", "tolerance:f32"];

fn count(precision: Precision, seed: u64, numbers: std::ops::Range<u64>) -> Census {
    let backends = NAMES.map(backend);
    search(&backends.each_ref().map(AsRef::as_ref), precision, seed, numbers)
}

fn tetrahedra(a: [[f64; 3]; 4], b: [[f64; 3]; 4]) -> SurfacePair {
    let triangles = vec![[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
    SurfacePair { surfaces: [a, b].map(|points| Surface { points: points.to_vec(), triangles: triangles.clone() }) }
}

/// The scene of the documentation in double precision, and one in single precision.
fn documented() -> [(&'static str, SurfacePair); 2] {
    let double = tetrahedra(
        [[0.0, -32.0, 0.0], [0.0, 0.0, 1024.0], [0.0, 0.0, 0.0], [-16.0, 0.0, 0.0]],
        [[-16.0, -2.0, 0.0], [0.0, 0.0, 0.0], [0.0, 32.0, 0.0], [-1.0, -4.0, 1024.0]],
    );
    let single = tetrahedra(
        [[0.0, -8.0, 0.0], [0.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 8.0]],
        [[2.0, 0.0, -8.0], [0.0, -4.0, 8.0], [0.0, 0.0, 0.0], [-8.0, 0.0, -12.0]],
    );
    [("tolerance", double), ("tolerance:f32", single)]
}

fn broken(name: &str, pair: &SurfacePair) -> Vec<Broken> {
    examine(backend(name).as_ref(), pair).unwrap().broken()
}

#[test]
fn the_scenes_of_the_documentation_are_broken_with_their_tolerances_only() {
    for (name, pair) in documented() {
        assert!(pair.is_embedded());
        assert_eq!(broken(name, &pair), [Broken::NoDirection], "{name}");
        for whole in ["exact", "sos", "sos:per-mesh"] {
            let examined = examine(backend(whole).as_ref(), &pair).unwrap();
            assert_eq!(examined.broken(), [], "{whole}");
            assert!(!examined.contacts.registered.is_empty());
        }
    }
}

#[test]
fn the_search_counts_what_is_broken() {
    for (precision, name) in [(Precision::Double, "tolerance"), (Precision::Single, "tolerance:f32")] {
        let census = count(precision, 3, 0..100);
        assert_eq!(census.backends, NAMES);
        assert_eq!(census.rows.len(), 5 * Recipe::ALL.len());
        let place = NAMES.iter().position(|other| *other == name).unwrap();
        for (&(recipe, backend), row) in &census.rows {
            assert_eq!((row.pairs, row.declined), (100, 0), "{recipe:?}");
            if backend < 3 {
                assert_eq!((row.loose, row.some), (0, 0), "{recipe:?} {}", NAMES[backend]);
                assert!(row.boundaries > 50 && row.pieces > 50, "{recipe:?}: {row:?}");
            }
            if backend == 1 || backend == 2 {
                assert_eq!(row.registered[..3], [0; 3], "only pairs of the last level");
            }
        }
        let near = census.rows[&(Recipe::Near, place)];
        assert!(near.registered.iter().all(|&count| count > 20), "every level: {near:?}");
        let found = census.found.iter().filter(|found| found.backend == place).count();
        let some: usize = Recipe::ALL.iter().map(|recipe| census.rows[&(*recipe, place)].some).sum();
        assert_eq!(found, some);
        if precision == Precision::Double {
            assert!(some > 3, "{some}");
        }
    }
}

#[test]
fn a_search_in_parts_is_the_search_of_the_whole() {
    let part = |numbers| count(Precision::Double, 3, numbers);
    assert_eq!(part(0..20).and(part(20..30)), part(0..30));
    assert_eq!(Census::default().and(part(0..5)), part(0..5));
    assert_ne!(count(Precision::Double, 4, 0..5), part(0..5));
}

#[test]
fn surfaces_are_embedded_and_either_precision_holds_them() {
    for precision in Precision::ALL {
        for recipe in Recipe::ALL {
            for number in 0..40 {
                let (pair, _) = random_surfaces(recipe, precision, 2, number);
                assert!(pair.is_embedded());
                for x in pair.surfaces.iter().flat_map(|surface| surface.points.as_flattened()) {
                    #[allow(clippy::cast_possible_truncation)] // the assertion detects lost bits
                    let single = *x as f32;
                    assert_eq!(f64::from(single), *x);
                }
            }
        }
    }
}

/// The counts fail if contacts are wrong: a broken tie, and a lost level.
#[test]
fn planted_faults_break_curves() {
    let broken = |name: &str| {
        let fault = backend(name);
        let pairs = (0..60).map(|number| random_surfaces(Recipe::Near, Precision::Double, 5, number).0);
        let found: Vec<Broken> = pairs
            .flat_map(|pair| examine(fault.as_ref(), &pair).map_or(Vec::new(), |examined| examined.broken()))
            .collect();
        Broken::ALL.map(|way| found.iter().filter(|found| **found == way).count())
    };
    let [no_way, no_direction, odd] = broken("fault:contacts-one-sided");
    assert!(no_way > 5 && no_direction > 5 && odd > 5, "{no_way} {no_direction} {odd}");
}

#[test]
fn a_find_shrinks_to_two_tetrahedra() {
    let [tolerance, exact] = ["tolerance", "exact"].map(backend);
    let backends: [&dyn Contestant; 2] = [tolerance.as_ref(), exact.as_ref()];
    let census = count(Precision::Double, 3, 0..60);
    let finds: Vec<_> = census.found.iter().filter(|found| found.backend == 3).take(2).collect();
    let kept = smallest(backends, Precision::Double, 3, &finds);
    assert!(!kept.is_empty());
    for (kind, small) in &kept {
        assert!(small.minimal && small.pair.is_embedded());
        assert_eq!(broken("tolerance", &small.pair), kind.ways);
        assert_eq!(broken("exact", &small.pair), []);
        assert_eq!(small.pair.size().0, 8, "two tetrahedra");
        let again = shrink_broken(backends, small.pair.clone(), &kind.ways, 20_000);
        assert_eq!((again.scene, again.taken), (small.pair.clone(), 0));
    }
}
