//! Pages lead somewhere: each relative link and anchor resolves, and the book has each page of `docs/` once.

use std::collections::BTreeMap;
use std::path::Path;

use crate::book::markdown::{anchors, is_external, links};
use crate::book::stage::{DOCS, SUMMARY, files, resolved};
use crate::command::root;

/// Pages in the folder of the workspace.
const TOP: [&str; 3] = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"];

/// The pages of a repository whose links are checked: those at the top, all of `docs/`, and READMEs of crates.
pub fn pages(root: &Path) -> Vec<String> {
    let of = |folder: &str| files(root, folder).expect("a folder").into_iter();
    let docs = of(DOCS).filter(|path| path.ends_with(".md"));
    let crates = of("crates").filter(|path| path.ends_with("/README.md") && !path.contains("/node_modules/"));
    TOP.map(str::to_owned).into_iter().chain(docs).chain(crates).collect()
}

/// The links of these pages that lead nowhere, each with its page and line.
fn dead(root: &Path, pages: &[String]) -> Vec<String> {
    let read = |path: &str| std::fs::read_to_string(root.join(path)).unwrap_or_else(|why| panic!("{path}: {why}"));
    let mut known: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut dead = Vec::new();
    for path in pages {
        let page = read(path);
        for link in links(&page) {
            let target = &page[link.target.clone()];
            if is_external(target) {
                continue;
            }
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            let to = if file.is_empty() { Some(path.clone()) } else { resolved(path, file) };
            let why = match to.filter(|to| root.join(to).exists()) {
                None => "no such file",
                Some(_) if anchor.is_empty() => continue,
                Some(to) => {
                    let of = known.entry(to.clone()).or_insert_with(|| anchors(&read(&to)));
                    if of.iter().any(|one| one == anchor) {
                        continue;
                    }
                    "no such heading"
                }
            };
            dead.push(format!("{path}:{}: ({target}): {why}", link.line(&page)));
        }
    }
    dead
}

#[test]
fn every_link_of_a_page_leads_somewhere() {
    let pages = pages(&root());
    assert!(pages.len() > 60, "{} pages", pages.len());
    let dead = dead(&root(), &pages);
    assert!(dead.is_empty(), "links that lead nowhere:\n{}", dead.join("\n"));
}

/// The errors of a list of chapters: a page that is not in it exactly once, or a chapter that is not a page.
fn unlisted(summary: &str, pages: &[String]) -> Vec<String> {
    let listed: Vec<String> =
        links(summary).iter().filter_map(|link| resolved(SUMMARY, &summary[link.target.clone()])).collect();
    let times = |page: &String| listed.iter().filter(|other| *other == page).count();
    let wrong = pages.iter().filter(|page| times(page) != 1).map(|page| format!("{page}: {} times", times(page)));
    let strange = listed.iter().filter(|page| !pages.contains(page)).map(|page| format!("{page}: no page of docs/"));
    wrong.chain(strange).collect()
}

#[test]
fn the_book_has_each_page_once() {
    let mut pages = files(&root(), DOCS).expect("the pages");
    pages.retain(|path| path.ends_with(".md") && path != SUMMARY);
    assert!(pages.len() > 40, "{} pages", pages.len());
    let summary = std::fs::read_to_string(root().join(SUMMARY)).expect("the list of chapters");
    let wrong = unlisted(&summary, &pages);
    assert!(wrong.is_empty(), "add each page to {SUMMARY} once:\n{}", wrong.join("\n"));
}

#[test]
fn a_page_that_is_not_in_the_book_is_seen() {
    let pages = ["docs/A.md", "docs/deep/B.md"].map(str::to_owned);
    assert_eq!(unlisted("- [A](A.md)\n  - [B](deep/B.md)\n", &pages), [""; 0]);
    assert_eq!(unlisted("- [A](A.md)\n- [A](A.md)\n", &pages), ["docs/A.md: 2 times", "docs/deep/B.md: 0 times"]);
    assert_eq!(unlisted("- [A](A.md)\n- [B](deep/B.md)\n- [C](C.md)\n", &pages), ["docs/C.md: no page of docs/"]);
}

#[test]
fn a_dead_link_is_seen() {
    let root = std::env::temp_dir().join(format!("predicament-links-{}", std::process::id()));
    std::fs::create_dir_all(root.join("docs")).unwrap();
    let write = |name: &str, text: &str| std::fs::write(root.join(name), text).unwrap();
    write("docs/A.md", "# One thing\n\n## `b` & c\n\n## Same\n\n## Same\n");
    let dead_of = |text: &str| {
        write("README.md", text);
        dead(&root, &["README.md".to_owned()])
    };
    let fine = "# Top\n[a](docs/A.md) [b](docs/A.md#b--c) [same](docs/A.md#same-1) [top](#top) [d](docs) [h](https://h.example/)\n";
    assert_eq!(dead_of(fine), [""; 0]);
    for (text, said) in [
        ("\n[a](docs/B.md)", "README.md:2: (docs/B.md): no such file"),
        ("[a](docs/A.md#b-c)", "README.md:1: (docs/A.md#b-c): no such heading"),
        ("[a](docs/A.md#same-2)", "README.md:1: (docs/A.md#same-2): no such heading"),
        ("[a](#top)", "README.md:1: (#top): no such heading"),
        ("![a](docs/a.svg)", "README.md:1: (docs/a.svg): no such file"),
        ("[a](../README.md)", "README.md:1: (../README.md): no such file"),
    ] {
        assert_eq!(dead_of(text), [said]);
    }
    std::fs::remove_dir_all(&root).unwrap();
}
