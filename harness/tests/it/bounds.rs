//! `predicament study bounds`, and the page made from it.

use crate::common::{column, expect};

#[test]
fn the_committed_page_is_what_the_command_prints() {
    let page = include_str!("../../../docs/BOUNDS.md");
    // the results of a search come last, and are not derived
    let (page, found) = page.split_once("\n## Worst cases\n").expect("the search comes last");
    assert!(found.contains("`predicament study worst`"));
    assert_eq!(expect(0, &["study", "bounds"]).stdout, page, "run `cargo xtask pages`");
    assert_eq!(expect(0, &["study", "bounds", "--format", "md"]).stdout, page);
}

#[test]
fn the_table_has_a_row_for_every_bound_and_every_constraint_at_every_epsilon() {
    let told = expect(0, &["study", "bounds", "--format", "csv"]);
    let tables = column(&told.stdout, "table");
    let rows = |name: &str| tables.iter().filter(|table| *table == name).count();
    // 42 quantities and m² ≤ 12L⁴, 6 statements about tolerances, 16 of tables, 6 of ours
    assert_eq!(rows("bound"), 42 + 1 + 6 + 16 + 6);
    assert_eq!(rows("definition"), 9);
    assert_eq!(rows("constraint") % 5, 0);
    assert!(column(&told.stdout, "verdict").iter().all(|verdict| verdict != "undecided"));
    let expressions = column(&told.stdout, "expression");
    assert!(expressions[0].contains("Bx") || expressions[0].contains("Ax"), "{}", expressions[0]);
}

#[test]
fn an_unknown_format_is_refused() {
    let told = expect(2, &["study", "bounds", "--format", "xml"]);
    assert!(told.stderr.contains("csv") && told.stderr.contains("md"), "{}", told.stderr);
}
