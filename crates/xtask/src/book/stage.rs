//! The pages of the book, in a folder of their own: `docs/`, and the files of the repository that its pages link to.
//!
//! A book has no files outside of its folder, and pages of `docs/` link to some: to README, to the pages of crates, to
//! sources. The pages among them become chapters, other files are copied, and each link leads to the new place.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

use super::markdown::{is_external, links, title};

/// The folder of the pages, in the repository.
pub const DOCS: &str = "docs";
/// The list of chapters, in `docs/`.
pub const SUMMARY: &str = "docs/SUMMARY.md";
/// The folder of the book for files from outside of `docs/`.
const OUTSIDE: &str = "repository";

/// Copies `docs/` and what its pages link to into a folder; returns the number of pages.
///
/// # Errors
/// If a file can't be read or written.
pub fn stage(root: &Path, folder: &Path) -> Result<usize, String> {
    let mut left = files(root, DOCS)?;
    let mut seen: BTreeSet<String> = left.iter().cloned().collect();
    let mut chapters = BTreeSet::new();
    while let Some(path) = left.pop() {
        let from = root.join(&path);
        if !is_page(&path) {
            let bytes = std::fs::read(&from).map_err(|error| format!("{path}: {error}"))?;
            write(folder, &place(&path), &bytes)?;
            continue;
        }
        let page = std::fs::read_to_string(&from).map_err(|error| format!("{path}: {error}"))?;
        let (text, linked) = moved(root, &path, &page);
        left.extend(linked.into_iter().filter(|file| seen.insert(file.clone())));
        if path != SUMMARY {
            write(folder, &place(&path), text.as_bytes())?;
        }
        if !path.starts_with("docs/") {
            chapters.insert((path, title(&page).unwrap_or_default()));
        }
    }
    let summary = std::fs::read_to_string(root.join(SUMMARY)).map_err(|error| format!("{SUMMARY}: {error}"))?;
    let (summary, _) = moved(root, SUMMARY, &summary);
    write(folder, &place(SUMMARY), (summary + &appendix(&chapters)).as_bytes())?;
    Ok(seen.iter().filter(|path| is_page(path)).count() - 1)
}

/// The files in a folder of the repository and in those in it, by their paths in the repository.
///
/// # Errors
/// If the folder can't be read.
pub fn files(root: &Path, folder: &str) -> Result<Vec<String>, String> {
    let failed = |error: std::io::Error| format!("{folder}: {error}");
    let mut files = Vec::new();
    for entry in std::fs::read_dir(root.join(folder)).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() { files.extend(self::files(root, &path)?) } else { files.push(path) }
    }
    files.sort();
    Ok(files)
}

fn is_page(path: &str) -> bool {
    path.ends_with(".md")
}

/// The place of a file of the repository in the book. A README is the first page of its folder.
fn place(path: &str) -> String {
    let place = path.strip_prefix("docs/").map_or_else(|| format!("{OUTSIDE}/{path}"), str::to_owned);
    match place.strip_suffix("README.md") {
        Some(folder) if folder.is_empty() || folder.ends_with('/') => format!("{folder}index.md"),
        _ => place,
    }
}

/// A page with its links as they have to be in the book, and the files that it links to.
fn moved(root: &Path, path: &str, page: &str) -> (String, Vec<String>) {
    let (mut text, mut at, mut files) = (String::new(), 0, Vec::new());
    for link in links(page) {
        let target = &page[link.target.clone()];
        let (file, anchor) = target.split_at(target.find('#').unwrap_or(target.len()));
        // An image within a link comes first; the link around it begins before it and is left as it is.
        if is_external(target) || file.is_empty() || link.whole.start < at {
            continue;
        }
        let Some(mut to) = resolved(path, file) else { continue };
        if root.join(&to).is_dir() && root.join(&to).join("README.md").is_file() {
            to += "/README.md";
        }
        text += &page[at..link.whole.start];
        let shown = &page[link.text.clone()];
        // The list of chapters is no page of the book.
        if root.join(&to).is_file() && to != SUMMARY {
            let mark = if link.is_image { "!" } else { "" };
            text += &format!("{mark}[{shown}]({}{anchor})", between(&place(path), &place(&to)));
            files.push(to);
        } else if shown.replace('`', "").ends_with(&to) {
            text += shown;
        } else {
            text += &format!("{shown} (`{to}`)");
        }
        at = link.whole.end;
    }
    (text + &page[at..], files)
}

/// The path in the repository of a link's target on a page; `None` if it leaves the repository.
pub fn resolved(page: &str, target: &str) -> Option<String> {
    let mut path = PathBuf::from(page);
    path.pop();
    for part in Path::new(target).components() {
        match part {
            Component::Normal(name) => path.push(name),
            Component::CurDir => {}
            Component::ParentDir => {
                if !path.pop() {
                    return None;
                }
            }
            Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    Some(path.to_string_lossy().replace('\\', "/"))
}

/// The relative link from a page of the book to a file of it.
fn between(page: &str, file: &str) -> String {
    let page: Vec<&str> = page.split('/').collect();
    let file: Vec<&str> = file.split('/').collect();
    let folders = page.len() - 1;
    let same = (0..folders.min(file.len() - 1)).take_while(|&at| page[at] == file[at]).count();
    let up = std::iter::repeat_n("..", folders - same);
    up.chain(file[same..].iter().copied()).collect::<Vec<_>>().join("/")
}

/// The chapters from outside of `docs/`, README first: a page stands below the README of a folder that it is in.
fn appendix(chapters: &BTreeSet<(String, String)>) -> String {
    let mut text = "\n# The repository\n\n".to_owned();
    let folder = |path: &str| path.rsplit_once('/').map_or(String::new(), |(folder, _)| format!("{folder}/"));
    let (tops, others): (Vec<_>, Vec<_>) = chapters.iter().partition(|(path, _)| path == "README.md");
    for (path, title) in tops.into_iter().chain(others) {
        let is_above = |other: &str| {
            let of = folder(other);
            other.ends_with("/README.md") && path.starts_with(&of) && of.len() < folder(path).len()
        };
        let depth = chapters.iter().filter(|(other, _)| is_above(other)).count();
        text += &format!("{}- [{title}]({})\n", "  ".repeat(depth), place(path));
    }
    text
}

fn write(folder: &Path, path: &str, bytes: &[u8]) -> Result<(), String> {
    let to = folder.join(path);
    let failed = |error: std::io::Error| format!("{}: {error}", to.display());
    std::fs::create_dir_all(to.parent().unwrap_or(folder)).map_err(failed)?;
    std::fs::write(&to, bytes).map_err(failed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_book_has_what_its_pages_link_to() {
        let root = std::env::temp_dir().join(format!("predicament-book-{}", std::process::id()));
        let (from, to) = (root.join("from"), root.join("to"));
        for (path, text) in [
            ("docs/SUMMARY.md", "# Summary\n\n[Start](README.md)\n- [A](deep/A.md)\n"),
            ("docs/README.md", "[a](deep/A.md#x), [top](../README.md), [here](#y), [host](https://example.org/)\n"),
            ("docs/deep/A.md", "[up](../README.md) [code](../../src/a.rs) [crates](../../crates) [src](../../src)\n"),
            ("README.md", "# Top\n![p](p.png) [docs](docs/README.md) [no](docs) [list](docs/SUMMARY.md)\n"),
            ("p.png", "PNG"),
            ("src/a.rs", "fn a() {}\n"),
            ("crates/README.md", "# Crates\n[one](one/README.md)\n"),
            ("crates/one/README.md", "# One\n"),
        ] {
            write(&from, path, text.as_bytes()).unwrap();
        }
        assert_eq!(stage(&from, &to).unwrap(), 5);
        let read = |path: &str| std::fs::read_to_string(to.join(path)).unwrap();
        assert_eq!(
            read("index.md"),
            "[a](deep/A.md#x), [top](repository/index.md), [here](#y), [host](https://example.org/)\n"
        );
        assert_eq!(
            read("deep/A.md"),
            "[up](../index.md) [code](../repository/src/a.rs) [crates](../repository/crates/index.md) src\n"
        );
        assert_eq!(
            read("repository/index.md"),
            "# Top\n![p](p.png) [docs](../index.md) [no](../index.md) list (`docs/SUMMARY.md`)\n"
        );
        assert_eq!([read("repository/p.png"), read("repository/src/a.rs")], ["PNG", "fn a() {}\n"]);
        assert_eq!(
            read("SUMMARY.md"),
            "# Summary\n\n[Start](index.md)\n- [A](deep/A.md)\n\n# The repository\n\n- [Top](repository/index.md)\n\
             - [Crates](repository/crates/index.md)\n  - [One](repository/crates/one/index.md)\n"
        );
        std::fs::remove_dir_all(&root).unwrap();
    }

    #[test]
    fn a_link_may_not_leave_the_repository() {
        assert_eq!(resolved("docs/deep/A.md", "../../README.md").as_deref(), Some("README.md"));
        assert_eq!(resolved("README.md", "../else.md"), None);
        assert_eq!(resolved("README.md", "/etc/passwd"), None);
    }
}
