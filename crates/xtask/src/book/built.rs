//! The links of a built book: each has to lead to a file of it, and to an anchor that the file has.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::stage::{files, resolved};

/// Checks all links of the pages in a folder; returns their number.
///
/// # Errors
/// If a page can't be read or a link leads nowhere: with the first such links, by page.
pub fn check(folder: &Path) -> Result<usize, String> {
    let (root, name) = (folder.parent().map_or_else(PathBuf::new, Path::to_owned), folder.file_name());
    let name = name.map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let mut pages = BTreeMap::new();
    for file in files(&root, &name)? {
        let is_page = file.ends_with(".html");
        let text = if is_page { std::fs::read_to_string(root.join(&file)) } else { Ok(String::new()) };
        pages.insert(file.clone(), text.map_err(|error| format!("{file}: {error}"))?);
    }
    let (mut count, mut dead) = (0, Vec::new());
    for (page, text) in &pages {
        for target in targets(text) {
            count += 1;
            if !leads(&pages, page, target) {
                dead.push(format!("{page}: {target}"));
            }
        }
    }
    if dead.is_empty() {
        return Ok(count);
    }
    let more = dead.len().saturating_sub(20);
    Err(format!(
        "{} links of the book lead nowhere ({more} more):\n  {}",
        dead.len(),
        dead[..dead.len() - more].join("\n  ")
    ))
}

/// The relative targets of links and images of a page.
fn targets(page: &str) -> impl Iterator<Item = &str> {
    let of = |mark: &'static str| page.split(mark).skip(1).filter_map(|rest| rest.split('"').next());
    let is_other = |target: &&str| !["://", "data:", "mailto:", "javascript:"].iter().any(|mark| target.contains(mark));
    of(" href=\"").chain(of(" src=\"")).filter(is_other)
}

/// True if a target is a file of the book and has the anchor.
fn leads(pages: &BTreeMap<String, String>, page: &str, target: &str) -> bool {
    let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
    let to = if file.is_empty() { Some(page.to_owned()) } else { resolved(page, file) };
    let Some(text) = to.and_then(|to| pages.get(&to)) else { return false };
    anchor.is_empty() || text.contains(&format!(" id=\"{anchor}\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_that_leads_nowhere_is_seen() {
        let folder = std::env::temp_dir().join(format!("predicament-built-{}", std::process::id()));
        std::fs::create_dir_all(folder.join("deep")).unwrap();
        let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
        write("a.svg", "");
        write("deep/b.html", "<h2 id=\"x\"></h2> <a href=\"../a.html\"> <a href=\"https://example.org/\">");
        write("a.html", "<a href=\"deep/b.html#x\"> <img src=\"a.svg\"> <a href=\"#y\"> <b id=\"y\">");
        assert_eq!(check(&folder), Ok(4));
        for dead in ["deep/b.html#z", "c.html", "../a.html", "#z"] {
            write("a.html", &format!("<a class=\"c\" href=\"{dead}\">"));
            assert!(check(&folder).unwrap_err().ends_with(&format!("a.html: {dead}")), "{dead}");
        }
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
