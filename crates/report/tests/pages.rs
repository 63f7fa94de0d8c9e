//! Pages made from two small runs that were written by hand: one was
//! interrupted while it checked answers, one timed them.

use std::path::Path;

use predicament_report::{RunDir, html, markdown, scatter, write_pages};

const GOLDEN: &str = "tests/data/report.md";

fn runs() -> Vec<RunDir> {
    ["tests/data/checked", "tests/data/timed"].map(|path| RunDir::open(path).unwrap()).into()
}

/// To accept a new page: `UPDATE=1 cargo test -p predicament-report`, then read the difference.
#[test]
fn markdown_is_as_it_was_read_and_approved() {
    let page = markdown(&runs()).unwrap();
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(GOLDEN, &page).unwrap();
    }
    let golden = std::fs::read_to_string(GOLDEN).unwrap().replace("\r\n", "\n");
    for (line, (new, old)) in page.lines().zip(golden.lines()).enumerate() {
        assert_eq!(new, old, "line {}", line + 1);
    }
    assert_eq!(page.lines().count(), golden.lines().count());
}
