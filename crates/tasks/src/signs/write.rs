//! Answers as a CSV file: one line for each query.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use predicament_predicates::{QuerySet, Sign};

/// Writes `signs.csv`: the query as findings name it, and its sign as -1, 0 or 1.
pub(super) fn csv(queries: &QuerySet, answers: &[Sign], folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let path = folder.join("signs.csv");
    let mut text = String::from("query,sign\n");
    for (at, sign) in answers.iter().enumerate() {
        // Writing to a string does not fail.
        let _ = writeln!(text, "\"{}\",{}", queries.question().query(queries.args(at)), sign.as_i8());
    }
    std::fs::write(&path, text)?;
    Ok(vec![path])
}
