//! `cargo xtask book`: the pages of `docs/` as a site with a search, by mdbook.

mod built;
pub mod markdown;
pub mod stage;

use crate::command::{answers, fresh, root, step, words};

/// Where the pages are put together.
const STAGE: &str = "target/book-pages";
/// Where the site is.
const SITE: &str = "target/book";
/// The chore in words, and the cure where mdbook is missing.
const MISSING: &str = "there is no mdbook here; type `cargo install --locked mdbook`";

/// Builds the site and checks its links.
///
/// # Errors
/// If mdbook is not installed or fails, a page can't be read, or a link leads nowhere.
pub fn build() -> Result<(), String> {
    if !is_at_hand() {
        return Err(MISSING.to_owned());
    }
    let pages = stage::stage(&root(), &root().join(fresh(STAGE)?))?;
    let site = root().join(fresh(SITE)?);
    let at = site.display().to_string();
    step("the book", &words("mdbook", &["build", "--dest-dir", &at, STAGE]), &[])?;
    let links = built::check(&site)?;
    println!("== the book: {pages} pages, {links} links; open {SITE}/index.html");
    Ok(())
}

/// The same in `nightly`, which says so if mdbook is missing.
///
/// # Errors
/// As [`build`], except for a missing mdbook.
pub fn build_if_at_hand() -> Result<(), String> {
    if is_at_hand() {
        return build();
    }
    println!("\n== the book: NOT RUN: {MISSING}");
    Ok(())
}

fn is_at_hand() -> bool {
    answers("mdbook", &["--version"])
}
