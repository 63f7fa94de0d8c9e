//! The table of ties in `docs/EXACT.md`: it has each task that is not about signs alone, and its last column has what
//! `exact` is expected not to do.

use std::collections::BTreeSet;

use predicament_corpus::Library;

fn read(path: &str) -> String {
    std::fs::read_to_string(format!("{}/../../../{path}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// The rows of the table: the tasks, and the last column.
fn rows(page: &str) -> Vec<(BTreeSet<String>, String)> {
    let table = page.split("| task | a tie, and its rule | left |\n").nth(1).unwrap();
    let lines = table.lines().skip(1).take_while(|line| line.starts_with('|'));
    let row = |line: &str| {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [tasks, _, left] = cells[..] else { panic!("three columns: {line}") };
        (tasks.split('`').skip(1).step_by(2).map(str::to_owned).collect(), left.to_owned())
    };
    lines.map(row).collect()
}

/// The tasks of the scenes that have an expected finding of `exact`.
fn expected(library: &Library, expectations: &str) -> BTreeSet<String> {
    let expectations: toml::Table = expectations.parse().unwrap();
    let words = |value: Option<&toml::Value>| -> Vec<String> {
        let one = |value: &toml::Value| value.as_str().unwrap().to_owned();
        match value {
            Some(toml::Value::Array(all)) => all.iter().map(one).collect(),
            value => value.map(one).into_iter().collect(),
        }
    };
    let entries = expectations["expect"].as_array().unwrap().iter();
    let of_exact = entries.filter(|entry| words(entry.get("backend")).iter().any(|backend| backend == "exact"));
    let scenes: Vec<String> = of_exact.flat_map(|entry| words(entry.get("scene"))).collect();
    let is_named = |name: &str| {
        scenes.iter().any(|pattern| match pattern.split_once('*') {
            Some((start, _)) => name.starts_with(start),
            None => name == pattern,
        })
    };
    let suites = library.suites().unwrap().iter();
    let all = suites.flat_map(|suite| suite.scenes.iter().map(move |scene| (suite, scene)));
    let named = all.filter(|(suite, scene)| is_named(&format!("{}/{}", suite.name, scene.name)));
    named.map(|(_, scene)| scene.task.to_owned()).collect()
}

#[test]
fn the_page_has_the_ties_of_every_task_and_what_is_left() {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let rows = rows(&read("docs/EXACT.md"));
    for task in predicament_bundle::tasks().iter().filter(|task| task.parts_of_replies().is_some()) {
        let count = rows.iter().filter(|(tasks, _)| tasks.contains(task.name())).count();
        assert_eq!(count, 1, "rows of {}", task.name());
    }
    let left = |rows: &[(BTreeSet<String>, String)]| -> BTreeSet<String> {
        rows.iter().filter(|(_, left)| !left.is_empty()).flat_map(|(tasks, _)| tasks.clone()).collect()
    };
    assert_eq!(left(&rows), expected(&library, &read("corpora/expected.toml")));
    // An entry more, and a cell that claims less.
    let more =
        "[[expect]]\nbackend = [\"exact\", \"naive\"]\nclass = \"declined\"\nscene = [\"slices/*\"]\nreason = \"\"\n";
    assert_eq!(expected(&library, more), BTreeSet::from(["slice".to_owned()]));
}
