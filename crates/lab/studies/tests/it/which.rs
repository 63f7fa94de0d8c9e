//! docs/WHICH.md agrees with the files of the sample: each of its figures is made from them again.

use std::path::{Path, PathBuf};

use predicament_effort::some_or_all;
use predicament_report::splice;
use predicament_studies::compare::part;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

fn page() -> String {
    std::fs::read_to_string(root().join("docs/WHICH.md")).unwrap().replace("\r\n", "\n")
}

/// The page made from the files of a folder.
fn made(page: &str, folder: &Path) -> Result<String, String> {
    splice(page, &[], &[], &|name| part(folder, name).map(|made| made.map_err(|why| why.to_string())))
        .map(|(page, _)| page)
        .map_err(|why| why.message)
}

/// A copy of the sample's files in a separate folder.
fn copy(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("predicament-which-{name}-{}", std::process::id()));
    for study in ["compare", "curves", "stress", "cut", "parity", "parity-space", "decimals", "ablation"] {
        std::fs::create_dir_all(folder.join(study)).unwrap();
        for file in std::fs::read_dir(root().join("reports/sample").join(study)).unwrap() {
            let file = file.unwrap();
            std::fs::copy(file.path(), folder.join(study).join(file.file_name())).unwrap();
        }
    }
    folder
}

#[test]
fn the_page_says_what_the_files_of_the_sample_say() {
    let page = page();
    assert!(page.matches("<!-- predicament: which ").count() > 15, "{page}");
    let made = made(&page, &root().join("reports/sample")).unwrap();
    for (ours, theirs) in page.lines().zip(made.lines()) {
        assert_eq!(ours, theirs, "`cargo xtask sample` recreates the page");
    }
    assert_eq!(page, made);
}

#[test]
fn readme_says_what_the_files_of_the_sample_say() {
    let readme = std::fs::read_to_string(root().join("README.md")).unwrap().replace("\r\n", "\n");
    assert_eq!(readme.matches("<!-- predicament: which ").count(), 2, "the tree and the table");
    assert_eq!(
        made(&readme, &root().join("reports/sample")).as_ref(),
        Ok(&readme),
        "`cargo xtask sample` recreates it"
    );
    assert!(readme.lines().count() <= 100, "README has {} lines", readme.lines().count());
}

/// Text outside of the marks has no figures that could be wrong.
#[test]
fn no_figure_is_written_by_hand() {
    let mut hand = String::new();
    let mut rest = page();
    while let Some((before, marked)) = rest.split_once("<!-- predicament: ") {
        hand += before;
        rest = marked.split_once("<!-- /predicament -->").unwrap().1.to_owned();
    }
    hand += &rest;
    // Code and links are not figures; nor are the level of intervals and the logarithm.
    let mut plain = String::new();
    for (at, part) in hand.split('`').enumerate() {
        plain += if at % 2 == 0 { part } else { "" };
    }
    let plain = plain.replace("95 %", "").replace("log2", "");
    let with_figures: Vec<&str> = plain.lines().filter(|line| line.contains(|c: char| c.is_ascii_digit())).collect();
    assert!(with_figures.is_empty(), "{with_figures:?}");
}

#[test]
fn a_figure_that_changes_and_a_file_that_is_missing_are_seen() {
    let (page, folder) = (page(), copy("changed"));
    assert_eq!(made(&page, &folder).as_ref(), Ok(&page));
    // One scene of one backend in one input.
    let file = folder.join("compare/compare.csv");
    let text = std::fs::read_to_string(&file).unwrap();
    let is_it = |line: &&str| line.starts_with("orient2d,near,") && line.contains(",naive,wrong answers,");
    let line = text.lines().find(is_it).unwrap();
    let mut cells: Vec<&str> = line.split(',').collect();
    cells[6] = "123456.0";
    std::fs::write(&file, text.replace(line, &cells.join(","))).unwrap();
    assert_ne!(made(&page, &folder).unwrap(), page);
    for (study, name) in [
        ("compare", "compare.csv"),
        ("compare", "promises.csv"),
        ("compare", "conditioning.csv"),
        ("curves", "compare.csv"),
        ("stress", "breaks.csv"),
        ("stress", "stress-laws.csv"),
        ("cut", "cut.csv"),
        ("parity", "parity.csv"),
        ("parity-space", "parity-space.csv"),
        ("ablation", "ablation.csv"),
    ]
    .into_iter()
    .step_by(some_or_all(3, 1))
    {
        let path = folder.join(study).join(name);
        let kept = std::fs::read(&path).unwrap();
        std::fs::remove_file(&path).unwrap();
        let why = made(&page, &folder).unwrap_err();
        assert!(why.contains(&format!("{study}/{name}")) && why.starts_with("line "), "{why}");
        std::fs::write(&path, kept).unwrap();
    }
    let why = made("<!-- predicament: which way -->\n<!-- /predicament -->", &folder).unwrap_err();
    assert!(why.contains("no part is called `which way`; the parts are tree, "), "{why}");
    std::fs::remove_dir_all(&folder).unwrap();
}
