//! Tables on a terminal, as Markdown.

use std::fmt::Write as _;

/// The distinct values, in the order of first appearance.
pub fn in_order<T: PartialEq>(values: impl Iterator<Item = T>) -> Vec<T> {
    values.fold(Vec::new(), |mut seen, value| {
        if !seen.contains(&value) {
            seen.push(value);
        }
        seen
    })
}

/// Appends a table as Markdown, its first columns words and the others numbers; nothing if it has no rows.
pub fn markdown(text: &mut String, title: &str, words: usize, heads: Vec<String>, rows: Vec<Vec<String>>) {
    if rows.is_empty() {
        return;
    }
    let width = |column: usize| rows.iter().chain([&heads]).map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..heads.len()).map(width).collect();
    let rule = widths.iter().enumerate().map(|(column, &width)| {
        if column < words { "-".repeat(width) } else { format!("{}:", "-".repeat(width.max(2) - 1)) }
    });
    let rule: Vec<String> = rule.collect();
    // Writing to a String does not fail.
    let _ = writeln!(text, "\n{title}\n");
    for row in [&heads, &rule].into_iter().chain(&rows) {
        let cells = row.iter().zip(&widths).enumerate().map(|(column, (cell, &width))| {
            if column < words { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        });
        let _ = writeln!(text, "| {} |", cells.collect::<Vec<_>>().join(" | "));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_line_up_and_say_nothing_about_nothing() {
        let mut text = String::new();
        let strings = |cells: &[&str]| cells.iter().map(|&cell| cell.to_owned()).collect::<Vec<_>>();
        markdown(&mut text, "None", 1, strings(&["a"]), Vec::new());
        assert_eq!(text, "");
        markdown(&mut text, "One", 1, strings(&["scene", "n"]), vec![strings(&["x", "1000"])]);
        assert_eq!(text, "\nOne\n\n| scene |    n |\n| ----- | ---: |\n| x     | 1000 |\n");
    }

    #[test]
    fn every_value_once_in_the_order_of_its_coming() {
        assert_eq!(in_order(["b", "a", "b", "c"].into_iter()), ["b", "a", "c"]);
    }
}
