//! The engines of whole tasks are short: a library joins by a few lines, so everybody can add one.

use std::path::PathBuf;

use crate::command::root;

/// The engines of the first table after this heading: their names in backticks, one or more in a row's first cell.
fn engines_of<'p>(page: &'p str, heading: &str) -> Vec<&'p str> {
    let table = page.split_once(heading).expect("the heading").1.trim_start();
    let cells = table.lines().take_while(|line| line.starts_with('|')).filter_map(|line| line.split('|').nth(1));
    cells.flat_map(|cell| cell.split('`').skip(1).step_by(2)).collect()
}

#[test]
fn an_engine_of_whole_tasks_is_short() {
    let page = std::fs::read_to_string(root().join("docs/ENGINES.md")).expect("the page");
    let engines = engines_of(&page, "### Engines of whole tasks");
    assert!(engines.len() > 25, "{engines:?}");
    for name in engines {
        let files = std::fs::read_dir(root().join("engines").join(name)).expect(name);
        let sources = files.map(|file| file.expect("an entry").path());
        let sources: Vec<PathBuf> =
            sources.filter(|path| path.file_stem().is_some_and(|stem| stem == "engine")).collect();
        assert!(sources.len() >= 2, "{name}: a source and a configuration");
        for source in sources.iter().filter(|path| path.is_file()) {
            let lines = std::fs::read_to_string(source).map_or(0, |text| text.lines().count());
            assert!(lines <= 60, "{}: {lines} lines; an engine of a library has at most 60", source.display());
        }
    }
}

#[test]
fn engines_are_read_from_their_table() {
    let page = "# A\n| `x` | y |\n\n### B\n| engine | of |\n|---|---|\n| `a`, `b` | `c` |\n\n| `d` | |\n";
    assert_eq!(engines_of(page, "### B"), ["a", "b"]);
}
