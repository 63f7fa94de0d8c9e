//! The written files of benches and of the shipped predicates are those of the generator.

use predicament_formula::{CATALOGUE, Definition, Formula, write};

use crate::common::{HAND_MADE, Input, Random, slices};

/// Compares a file with what the generator writes; writes it if the variable UPDATE is set.
fn holds(path: &str, file: &str, written: &str) {
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(format!("{}/{path}", env!("CARGO_MANIFEST_DIR")), written).unwrap();
    }
    assert!(written == file, "{path}: run the test with UPDATE=1");
}

fn shipped() -> Vec<Formula> {
    CATALOGUE.iter().map(|entry| Formula::new(entry.definition()).unwrap()).collect()
}

#[test]
fn the_shipped_predicates_are_compiled_as_the_generator_writes_them() {
    let shipped = shipped();
    let written = write::compiled(&shipped.iter().collect::<Vec<_>>());
    holds("src/shipped/written.rs", include_str!("../../src/shipped/written.rs"), &written);
}

#[test]
fn compiled_estimates_are_the_interpreted_ones() {
    let mut random = Random(7);
    for formula in shipped() {
        for at in 0..400 {
            let points = Input::ALL[at % Input::ALL.len()].points(&formula, &mut random);
            let slices = slices(&points);
            let [value, bound] = formula.estimate(&slices);
            let [interpreted, other] = formula.interpreted(&slices);
            let same = |x: f64, y: f64| x.to_bits() == y.to_bits() || x.is_nan() && y.is_nan();
            assert!(same(value, interpreted) && same(value, formula.value(&slices)), "{}", formula.name());
            let ratio = bound / other;
            assert!(same(bound, other) || (ratio - 1.0).abs() < 1e-14, "{}: {bound} {other}", formula.name());
        }
        // A wrong number of points has no certain sign.
        assert_eq!(formula.certain(&[]), None, "{}", formula.name());
    }
}

#[test]
fn the_derived_predicates_of_the_bench_are_written_by_the_generator() {
    for (name, file) in [
        ("orient3d", include_str!("../../benches/derived/orient3d.rs")),
        ("incircle", include_str!("../../benches/derived/incircle.rs")),
    ] {
        let (_, text, dimension) = HAND_MADE.into_iter().find(|(other, ..)| *other == name).unwrap();
        let definition =
            Definition { name: name.to_owned(), dimension: Some(dimension), ..Definition::anonymous(text) };
        let written = write::rust(&Formula::new(definition).unwrap(), &[]);
        holds(&format!("benches/derived/{name}.rs"), file, &written);
    }
}
