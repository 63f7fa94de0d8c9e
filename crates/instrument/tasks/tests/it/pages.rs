//! The page of two small runs that were written by hand, with the sections of the tasks: one run was interrupted during
//! checks, the other timed answers.

use std::path::Path;

use predicament_records::RunDir;
use predicament_report::{Section, html, markdown};

const GOLDEN: &str = "tests/data/report.md";

fn runs() -> Vec<RunDir> {
    ["tests/data/checked", "tests/data/timed"].map(|path| RunDir::open(path).unwrap()).into()
}

/// The sections of all tasks, each once: several tasks may share one.
fn sections(runs: &[RunDir]) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    for section in predicament_bundle::tasks().iter().filter_map(|task| task.own_section(runs).unwrap()) {
        if !sections.contains(&section) {
            sections.push(section);
        }
    }
    sections
}

fn page(runs: &[RunDir]) -> String {
    markdown(runs, &sections(runs)).unwrap()
}

/// Compares the page with the approved one. To accept a new page: `UPDATE=1 cargo test -p predicament-tasks`, then read
/// the difference.
#[test]
fn markdown_is_as_it_was_read_and_approved() {
    let page = page(&runs());
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(GOLDEN, &page).unwrap();
    }
    let golden = std::fs::read_to_string(GOLDEN).unwrap().replace("\r\n", "\n");
    for (line, (new, old)) in page.lines().zip(golden.lines()).enumerate() {
        assert_eq!(new, old, "line {}", line + 1);
    }
    assert_eq!(page.lines().count(), golden.lines().count());
}

/// Checks the computed numbers of the tasks' sections against hand calculations from the rows.
#[test]
fn numbers_trace_to_rows() {
    let page = page(&runs());
    // A correct union, and one that was negative.
    assert!(page.contains("| 1 | corner-in-corner (cubes) | sos | 2 | 15.0000 | 42.0000 | 48.0000 | 14 | 6 | 0 |"));
    assert!(page.contains("| 1 | twins (cubes) | exact | 3 | −2.00000 (expected: 1.00000) |"), "{page}");
    // exact, edges with vertices: 1 of 4 and 3 of 4 had ended; then 2 of 9, 1 of 3 and none of none.
    let contacts = "| 1 | two-triangles (contacts) | contacts2d | exact | 1 (0 % ended) | 1 (50.0 % ended) | 2 (25.0 % ended) |  |";
    assert!(page.contains(contacts), "{page}");
    // Probes on land that naive located in two regions.
    assert!(page.contains("| 1 | two-squares (maps) | land | naive | 8 | 0 | 7 | 1 | 0 | 1 |"), "{page}");
}

#[test]
fn every_section_of_a_task_is_on_both_pages_once() {
    let runs = runs();
    let sections = sections(&runs);
    let ids: Vec<&str> = sections.iter().map(|section| section.id).collect();
    assert_eq!(ids, ["locate", "cubes", "contacts"]);
    let (page, text) = (html(&runs, &sections, &[]).unwrap(), page(&runs));
    for section in sections {
        for mark in [format!("<section id=\"{}\">", section.id), format!("<a href=\"#{}\">", section.id)] {
            assert_eq!(page.matches(&mark).count(), 1, "{mark}");
        }
        assert_eq!(text.matches(&format!("## {}\n", section.title)).count(), 1, "{}", section.title);
    }
}

#[test]
fn sections_without_rows_are_left_out_and_named() {
    let page = page(&runs()[1..]);
    let last = page.lines().find(|line| line.starts_with("Sections with nothing to show")).unwrap();
    for title in ["Points in a map", "Contacts", "Unions of cubes"] {
        assert!(last.contains(title) && !page.contains(&format!("## {title}")), "{title}: {last}");
    }
}

/// A copy of the first run with modified rows in the tasks' tables.
fn changed(folder: &Path, change: impl Fn(&str, &mut Vec<String>)) -> RunDir {
    for file in std::fs::read_dir("tests/data/checked").unwrap() {
        let (name, path) = file.map(|file| (file.file_name().into_string().unwrap(), file.path())).unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        let mut lines: Vec<String> = text.split_inclusive('\n').map(str::to_owned).collect();
        change(&name, &mut lines);
        std::fs::write(folder.join(name), lines.concat()).unwrap();
    }
    RunDir::open(folder).unwrap()
}

const TABLES: [&str; 3] = ["locate.csv", "masses.csv", "contacts.csv"];

#[test]
fn the_order_of_rows_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let backward = changed(folder.path(), |file, lines| {
        if TABLES.contains(&file) {
            assert!(lines.len() > 2, "{file} has an order");
            lines[1..].reverse();
        }
    });
    assert_eq!(sections(&[backward]), sections(&runs()[..1]));
}

#[test]
fn every_row_counts() {
    for table in TABLES {
        let folder = tempfile::tempdir().unwrap();
        let shorter = changed(folder.path(), |file, lines| {
            if file == table {
                lines.pop();
            }
        });
        assert_ne!(sections(&[shorter]), sections(&runs()[..1]), "{table}");
    }
}

#[test]
fn rows_that_make_no_sense_are_errors_that_name_their_line() {
    let bad = [
        ("contacts.csv", "s,n,i,t,b,0,0,9,1,7,6\n", "contacts.csv:9: `candidates` is not the sum of"),
        ("contacts.csv", "s,n,i,t,b,0,0,9,2,7,8\n", "contacts.csv:9: more pairs are registered than queried"),
        ("masses.csv", "s,n,i,b,1,1,1,6,6,12,-1,8,0,0\n", "masses.csv:4: an expected measure is negative or NaN"),
        ("locate.csv", "s,n,i,b,land,1,2,3,4,5,x\n", "locate.csv:8: "),
    ];
    for (table, row, message) in bad {
        let folder = tempfile::tempdir().unwrap();
        let run = [changed(folder.path(), |file, lines| lines.extend((file == table).then(|| row.to_owned())))];
        let errors: Vec<String> = predicament_bundle::tasks()
            .iter()
            .filter_map(|task| task.own_section(&run).err())
            .map(|error| error.to_string())
            .collect();
        assert!(!errors.is_empty() && errors.iter().all(|error| error.contains(message)), "{table}: {errors:?}");
    }
}
