//! Conversion of a fuzzer's finds to scenes of a suite.

use std::fmt::Write as _;

use predicament_formats::hexfloat;
use predicament_predicates::{Dimension, PredicateKind, Question};

/// The scene that a target's bytes encode, as tables of a suite.
///
/// # Errors
/// A text, if the bytes encode no scene: what they are, and what to do with them.
pub fn scene(target: &str, name: &str, bytes: &[u8]) -> Result<String, String> {
    let text_targets = crate::OF_TASKS.iter().map(|(name, _)| *name).chain(["scenes"]);
    if text_targets.into_iter().any(|text| text == target) {
        let text = std::str::from_utf8(bytes).map_err(|_| "the bytes are no text, and no case".to_owned())?;
        let defs = crate::scenes::of_text(text);
        return match defs.as_slice() {
            [] => Err("the text is no suite of scenes that are written out, and no case".to_owned()),
            _ => Ok(text.split_once("[[scene]]").map_or_else(String::new, |(_, rest)| format!("[[scene]]{rest}"))),
        };
    }
    let (kind, bytes) = match (PredicateKind::ALL.into_iter().find(|kind| kind.name() == target), bytes) {
        (Some(kind), bytes) => (kind, bytes),
        (None, [head, rest @ ..]) if target == "ties" => (crate::ties::chosen(*head).0, rest),
        _ => {
            return Err(format!(
                "a find of `{target}` is a file and no scene: add it to the tests of what has read it, as it is"
            ));
        }
    };
    let (scene, questions) = crate::case(kind, bytes);
    let mut tables = String::new();
    for (number, question) in questions.iter().enumerate() {
        let _ = writeln!(tables, "[[scene]]\nname = \"{name}-{number}\"\ntask = \"{}\"", kind.name());
        let space = scene.dimension() == Dimension::Three;
        let key = match question {
            Question::Compare(axis) => format!("axis = \"{}\"\n", axis.name()),
            Question::Orient2d(plane) if space => format!("plane = \"{}\"\n", plane.name()),
            _ => String::new(),
        };
        tables.push_str(&key);
        let _ = writeln!(
            tables,
            "queries = \"all\"\nsource = \"cargo fuzz run {target}\"\nanalysis = \"Found by fuzzing.\"\npoints = ["
        );
        let width = if space { 3 } else { 2 };
        for point in scene.coordinates().chunks_exact(width) {
            let row: Vec<String> = point.iter().map(|&x| format!("\"{}\"", hexfloat::format(x))).collect();
            let _ = writeln!(tables, "    [{}],", row.join(", "));
        }
        tables.push_str("]\n\n");
    }
    Ok(tables)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::bytes;

    /// A find becomes a scene with the points of the case.
    #[test]
    fn finds_are_scenes() {
        for kind in PredicateKind::ALL {
            for run in 0..20 {
                let bytes = bytes(run);
                let tables = scene(kind.name(), "find", &bytes).unwrap();
                let (found, questions) = crate::case(kind, &bytes);
                let defs = crate::scenes::of_text(&format!("title = \"t\"\n{tables}"));
                // Scenes that differ only in their names are refused together.
                if defs.is_empty() {
                    continue;
                }
                assert_eq!(defs.len(), questions.len());
                let loaded = defs[0]
                    .load(predicament_corpus::Level::Quick, &predicament_formats::Cache::new("/nowhere"))
                    .unwrap();
                assert_eq!(loaded.scene.coordinates(), found.coordinates());
            }
        }
        let suite = "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"orient2d\"\npoints = [[0, 0], [1, 0], [0, 1]]\n";
        assert!(scene("contacts", "x", suite.as_bytes()).unwrap().starts_with("[[scene]]\nname = \"a\""));
        assert!(scene("formats", "x", b"abc").unwrap_err().contains("a file and no scene"));
        assert!(scene("scenes", "x", &[0xff]).is_err());
    }
}
