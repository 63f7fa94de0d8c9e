//! The table of what the sources name: each command, file and test that `docs/COVERAGE.md` names exists.

use std::collections::BTreeMap;
use std::path::Path;

use crate::book::stage::files;
use crate::command::root;

const PAGE: &str = "docs/COVERAGE.md";
const COMMANDS: &str = "docs/COMMANDS.md";

/// The names in backticks of a cell.
fn names(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

/// The names of the tests below a folder of a repository.
fn tests(root: &Path, folder: &str) -> Vec<String> {
    let mut all = Vec::new();
    for file in files(root, folder).expect("a folder").iter().filter(|file| file.ends_with(".rs")) {
        let text = std::fs::read_to_string(root.join(file)).expect("a source file");
        for part in text.split("#[test]").skip(1) {
            let name = part.split("fn ").nth(1).and_then(|rest| rest.split('(').next());
            all.extend(name.map(str::to_owned));
        }
    }
    all
}

/// The errors of the rows of a page, and the number of its rows.
fn flaws(page: &str, root: &Path) -> (Vec<String>, usize) {
    let commands = std::fs::read_to_string(root.join(COMMANDS)).expect("the page of commands");
    let groups = ["kernel", "instrument", "systems", "lab"];
    let folder = |name: &str| {
        let crates = groups.map(|group| format!("crates/{group}/{name}"));
        crates.into_iter().chain((name == "harness").then(|| name.to_owned())).find(|path| root.join(path).is_dir())
    };
    let mut known: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let (mut flaws, mut rows) = (Vec::new(), 0);
    for (at, line) in page.lines().enumerate() {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [_, _, places, held] = cells[..] else { continue };
        if !places.contains('`') {
            continue;
        }
        rows += 1;
        let mut flaw = |what: &str, why: &str| flaws.push(format!("{PAGE}:{}: `{what}`: {why}", at + 1));
        for place in names(places) {
            let exists = if place.starts_with("predicament ") {
                commands.lines().any(|heading| heading.strip_prefix("### ") == Some(place))
            } else {
                root.join(place).exists()
            };
            if !exists {
                flaw(place, "no such command or file");
            }
        }
        if names(held).next().is_none() {
            flaw(held, "no test");
        }
        for test in names(held) {
            let Some((of, name)) = test.split_once("::") else {
                flaw(test, "not `folder::test`");
                continue;
            };
            let Some(path) = folder(of) else {
                flaw(test, "no crate has this folder");
                continue;
            };
            let tests = known.entry(of.to_owned()).or_insert_with(|| tests(root, &path));
            if !tests.iter().any(|known| known == name) {
                flaw(test, "no such test");
            }
        }
    }
    (flaws, rows)
}

#[test]
fn what_the_table_of_sources_names_exists() {
    let page = std::fs::read_to_string(root().join(PAGE)).expect("the page");
    let (flaws, rows) = flaws(&page, &root());
    assert!(rows > 60, "{rows} rows");
    assert!(flaws.is_empty(), "{}", flaws.join("\n"));
}

#[test]
fn a_row_with_a_wrong_name_is_found() {
    let row = |place: &str, test: &str| flaws(&format!("| 1 | what | `{place}` | `{test}` |\n"), &root()).0;
    let test = "mesh::loops_and_rings";
    assert_eq!(row("predicament study bounds", test), [""; 0]);
    assert_eq!(row("predicament study bonds", test).len(), 1, "a command");
    assert_eq!(row("crates/kernel/exact/src", test), [""; 0]);
    assert_eq!(row("crates/kernel/exact/source", test).len(), 1, "a file");
    assert_eq!(row("docs", "mesh::loops_and_ring").len(), 1, "a test");
    assert_eq!(row("docs", "meshes::loops_and_rings").len(), 1, "a crate");
}
