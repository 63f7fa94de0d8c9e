//! The tables of a report for papers: LaTeX with booktabs, the same cells as on the other pages.

use std::fmt::Write as _;

use crate::sections::sections;
use crate::table::{Block, Section, Table};
use crate::{Error, RunDir};

/// The name of the LaTeX file.
pub const FILE: &str = "tables.tex";
/// The maximum number of rows of a table; longer tables are replaced by a comment and stay in the CSV files.
const MOST_ROWS: usize = 60;

/// All tables that are not too long, each as a `table` with a caption and a label, `tab:section-number`.
///
/// # Errors
/// If a section can't be made.
pub fn latex(runs: &[RunDir], of_tasks: &[Section]) -> Result<String, Error> {
    let mut text = "% Tables of a report by predicament; they need \\usepackage{booktabs}.\n".to_owned();
    for section in sections(runs, of_tasks)? {
        let tables = section.blocks.iter().filter_map(|block| match block {
            Block::Table(table) => Some(table),
            _ => None,
        });
        for (number, table) in (1..).zip(tables) {
            let label = format!("{}-{number}", section.id);
            if table.rows().len() > MOST_ROWS {
                let _ = writeln!(text, "\n% {label} is left out: it has {} rows.", table.rows().len());
                continue;
            }
            write(&mut text, section.title, &label, table);
        }
    }
    Ok(text)
}

/// Writes one table. Writing to a String does not fail.
fn write(text: &mut String, title: &str, label: &str, table: &Table) {
    let aligned: String = table.columns().map(|(_, numeric)| if numeric { 'r' } else { 'l' }).collect();
    let line = |cells: &mut dyn Iterator<Item = String>| format!("{} \\\\\n", cells.collect::<Vec<_>>().join(" & "));
    let caption = if table.caption().is_empty() { title.to_owned() } else { format!("{title}: {}", table.caption()) };
    let caption = if table.basis_text().is_empty() { caption } else { format!("{caption} ({})", table.basis_text()) };
    let _ = write!(
        text,
        "\n\\begin{{table}}\n\\caption{{{}}}\n\\label{{tab:{label}}}\n\\begin{{tabular}}{{{aligned}}}\n\\toprule\n",
        escaped(&caption)
    );
    *text += &line(&mut table.columns().map(|(head, _)| escaped(head)));
    *text += "\\midrule\n";
    for row in table.rows() {
        *text += &line(&mut row.iter().map(|cell| {
            let (words, detail) = (escaped(cell.text()), escaped(cell.detail_text()));
            let words = if cell.is_code() && !words.is_empty() { format!("\\texttt{{{words}}}") } else { words };
            if detail.is_empty() { words } else { format!("{words} ({detail})") }
        }));
    }
    *text += "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

/// The text escaped for LaTeX.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => out += "\\textbackslash{}",
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => out.extend(['\\', c]),
            '~' => out += "\\textasciitilde{}",
            '^' => out += "\\textasciicircum{}",
            '<' => out += "\\textless{}",
            '>' => out += "\\textgreater{}",
            '|' => out += "\\textbar{}",
            '−' => out += "$-$",
            '×' => out += "$\\times$",
            '–' => out += "--",
            '—' => out += "---",
            '∞' => out += "$\\infty$",
            '✗' => out += "$\\times$",
            '≤' => out += "$\\le$",
            '≈' => out += "$\\approx$",
            '✓' => out += "$\\checkmark$",
            '\u{a0}' => out.push('~'),
            '\n' | '\r' => out.push(' '),
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Cell;

    #[test]
    fn nothing_is_a_command_that_was_text() {
        assert_eq!(escaped("a_b & 50\u{a0}% \\x −3 0.4×"), "a\\_b \\& 50~\\% \\textbackslash{}x $-$3 0.4$\\times$");
    }

    #[test]
    fn a_table_has_its_rules_and_cells() {
        let mut table = Table::new("By class").words(["backend"]).numbers(["n_1"]);
        table.push(vec![Cell::code("sos:per_mesh"), Cell::count(1234)]);
        let mut text = String::new();
        write(&mut text, "Ties", "ties-1", &table);
        let wanted = "\n\\begin{table}\n\\caption{Ties: By class}\n\\label{tab:ties-1}\n\\begin{tabular}{lr}\n\\toprule\nbackend & n\\_1 \
                      \\\\\n\\midrule\n\\texttt{sos:per\\_mesh} & 1,234 \\\\\n\\bottomrule\n\\end{tabular}\n\\end{table}\n";
        assert_eq!(text, wanted);
    }
}
