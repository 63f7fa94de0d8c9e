//! `setup cite`, and the section of the report about sources.

use std::fs;

use tempfile::tempdir;

use crate::common::{at, expect, read};

/// A scene with a source of its own.
fn scene(name: &str, source: &str, points: &str) -> String {
    format!("[[scene]]\nname = \"{name}\"\ntask = \"orient2d\"\n{source}points = {points}\nqueries = \"all\"\n")
}

#[test]
fn the_tool_and_its_papers_are_cited() {
    let told = expect(0, &["setup", "cite"]);
    assert!(told.stdout.starts_with("@misc{predicament,\n"), "{}", told.stdout);
    assert!(told.stdout.contains(&format!("{{Version {}", env!("CARGO_PKG_VERSION"))), "{}", told.stdout);
    assert!(told.stdout.contains("\n@article{shewchuk-1997,\n"), "{}", told.stdout);
    let short = expect(0, &["cite"]);
    assert_eq!((short.stdout, short.stderr.as_str()), (told.stdout, ""), "the short name is no earlier name");
}

#[test]
fn the_sources_of_a_run_are_cited_and_reported() {
    let folder = tempdir().unwrap();
    let suite = at(&folder, "mine.toml");
    let text = "title = \"Mine\"\n".to_owned()
        + &scene("a", "source = \"Kettner et al. 2008, failure A1\"\n", "[[0, 0], [1, 0], [0, 1]]")
        + &scene("b", "source = \"A map, 100 % mine\"\n", "[[0, 0], [2, 0], [0, 1]]")
        + &scene("c", "source = \"by hand\"\n", "[[0, 0], [3, 0], [0, 1]]")
        + &scene("d", "", "[[0, 0], [4, 0], [0, 1]]");
    fs::write(&suite, &text).unwrap();
    let out = at(&folder, "run");
    expect(0, &["run", &suite, "-b", "exact", "--out", &out]);
    let cited = expect(0, &["setup", "cite", "--run", &out]).stdout;
    for line in [
        "% Kettner et al. 2008, failure A1 (1 scene of mine)\n@article{kettner-2008,\n",
        "% A map, 100 % mine (1 scene of mine)\n@misc{a-map-100-mine,\n  title = {{A map, 100 \\% mine}},\n}\n",
        "% Scenes that are not from a publication:\n% by hand (1 scene of mine)\n",
        "% Scenes with no key `source`: mine (1)\n",
    ] {
        assert!(cited.contains(line), "{line}\n{cited}");
    }
    assert!(!cited.contains("shewchuk"), "a paper that no scene is from is not cited");
    let report = |name: &str| {
        expect(0, &["report", &out, "--out", &at(&folder, name)]);
        read(&at(&folder, name), "report.md")
    };
    let page = report("report");
    let section = page.split("## Sources of the scenes").nth(1).expect("the section");
    for row in
        ["| A map, 100 % mine | mine | 1 |", "| the suites' authors, by hand, by generators or by search | mine | 1 |"]
    {
        assert!(section.contains(row), "{row}\n{section}");
    }
    // A suite that has gone leaves scenes of which nothing is known.
    fs::remove_file(&suite).unwrap();
    let cited = expect(0, &["setup", "cite", "--run", &out]).stdout;
    assert!(cited.contains("% Scenes with a suite that is unreadable or has changed: mine (4)\n"), "{cited}");
    assert!(!report("later").contains("Sources of the scenes"));
}

#[test]
fn what_is_no_run_cannot_be_cited() {
    let folder = tempdir().unwrap();
    let told = expect(2, &["setup", "cite", "--run", &at(&folder, "none")]);
    assert!(told.stderr.lines().count() == 1 && told.stderr.contains("none"), "{}", told.stderr);
}
