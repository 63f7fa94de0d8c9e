//! The written files that benches use are those of the generator.

use predicament_formula::{Definition, Formula, write};

use crate::common::HAND_MADE;

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
        if std::env::var_os("UPDATE").is_some() {
            let path = format!("{}/benches/derived/{name}.rs", env!("CARGO_MANIFEST_DIR"));
            std::fs::write(path, &written).unwrap();
        }
        assert_eq!(written, file, "run the test with UPDATE=1");
    }
}
