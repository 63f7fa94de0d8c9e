//! Project rules that the compiler does not check, as tests.

mod commands;
mod coverage;
mod engines;
mod independence;
mod kernel;
mod links;
mod packages;
mod prose;
mod trust;
mod truth;

use std::path::{Path, PathBuf};

/// The manifests of all crates.
fn manifests() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folders = |of: PathBuf| std::fs::read_dir(of).expect("a folder").map(|entry| entry.expect("an entry").path());
    let groups = folders(root.join("crates")).filter(|path| path.is_dir());
    let crates = groups.flat_map(|group| folders(group.clone()).chain([group]));
    let mut all: Vec<PathBuf> = crates.chain([root.join("harness")]).map(|one| one.join("Cargo.toml")).collect();
    all.retain(|manifest| manifest.is_file());
    all.sort();
    all
}

/// Sections that name `rug` without `gmp-mpfr-sys`.
fn without_feature(manifest: &str) -> Vec<&str> {
    let names = |section: &str, name: &str| {
        section.lines().any(|line| line.strip_prefix(name).is_some_and(|rest| rest.starts_with(['.', ' ', '='])))
    };
    let sections = manifest.split("\n[").filter(|section| names(section, "rug") && !names(section, "gmp-mpfr-sys"));
    sections.map(|section| section.lines().next().unwrap_or_default().trim_end_matches(']')).collect()
}

/// GMP is built once for each set of its features.
///
/// A crate that names only `rug` makes a second build, with GMP's own tests, when it is built alone: five minutes.
#[test]
fn whoever_names_rug_names_the_feature_of_gmp() {
    let manifests = manifests();
    assert!(manifests.len() > 20, "{manifests:?}");
    for path in manifests {
        let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert_eq!(without_feature(&text), [""; 0], "add gmp-mpfr-sys beside rug in {}", path.display());
    }
}

/// Packages that a profile compiles below level 3, by the lines of its table.
fn barely_optimised<'m>(manifest: &'m str, profile: &str) -> Vec<&'m str> {
    let table = format!("profile.{profile}.package]");
    let section = manifest.split("\n[").find(|section| section.starts_with(&table)).unwrap_or_default();
    let lines = section.lines().filter(|line| line.contains("opt-level") && !line.contains("opt-level = 3"));
    lines.map(|line| line.split(['.', ' ']).next().unwrap_or_default()).collect()
}

/// These crates turn sessions of backends into machine code, which `bench` times. At level 1 a plain
/// determinant took twenty times as long.
#[test]
fn timed_code_is_optimised() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let manifest = std::fs::read_to_string(root.join("Cargo.toml")).expect("the manifest");
    for profile in ["release", "demo"] {
        let slow = barely_optimised(&manifest, profile);
        assert!(slow.contains(&"predicament-report"), "{profile}: {slow:?}");
        for timed in
            ["-arithmetic", "-bundle", "-controls", "-exact", "-lanes", "-oracle", "-predicates", "-sos", "-tolerance"]
        {
            assert!(!slow.contains(&&*format!("predicament{timed}")), "{profile} times predicament{timed}");
        }
    }
    // The demo's own level is 1.
    let (_, demo) = manifest.split_once("[profile.demo.package]").expect("the profile of the demo");
    for timed in ["-bundle", "-controls", "-exact", "-lanes", "-predicates", "-sos", "-tolerance"] {
        let line = |setting: &str| format!("\npredicament{timed}{setting}");
        let is_optimised = demo.contains(&line(".opt-level = 3\n")) || demo.contains(&line(" = { opt-level = 3,"));
        assert!(is_optimised, "the demo times predicament{timed}");
    }
    let fine = "predicament-sos = { opt-level = 3, codegen-units = 1 }\npredicament-exact.opt-level = 3\n";
    for planted in ["predicament-bundle.opt-level = 1", "predicament-bundle = { opt-level = 1, codegen-units = 1 }"] {
        let planted = format!("\n[profile.demo.package]\n{fine}{planted}\n");
        assert_eq!(barely_optimised(&planted, "demo"), ["predicament-bundle"]);
    }
}

/// The groups of crates, from the one without imports of other groups to the one that may import all.
const GROUPS: [&str; 4] = ["kernel", "instrument", "systems", "lab"];

/// The packages of this workspace that a manifest names in its section of dependencies.
fn dependencies(manifest: &str) -> Vec<&str> {
    let sections = manifest.split("\n[").filter(|section| section.starts_with("dependencies]"));
    let lines = sections.flat_map(str::lines).filter(|line| line.starts_with("predicament-"));
    lines.map(|line| line.split(['.', ' ', '=']).next().unwrap_or_default()).collect()
}

/// A crate imports its own group and earlier ones, in the order kernel, instrument, systems, lab; tests import
/// anything.
#[test]
fn dependencies_point_one_way() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let group = |package: &str| {
        let folder = package.trim_start_matches("predicament-");
        GROUPS.iter().position(|group| root.join("crates").join(group).join(folder).join("Cargo.toml").is_file())
    };
    let mut seen = 0;
    for path in manifests() {
        let Some(own) = GROUPS.iter().position(|group| path.starts_with(root.join("crates").join(group))) else {
            continue;
        };
        let text = std::fs::read_to_string(&path).expect("a manifest");
        for package in dependencies(&text) {
            let of = group(package).unwrap_or(GROUPS.len());
            assert!(of <= own, "{} may not import {package}", path.display());
            let is_backend =
                ["exact", "sos", "tolerance", "controls", "oracle"].map(|name| format!("predicament-{name}"));
            let names_one = GROUPS[own] == "systems" && is_backend.iter().any(|name| name == package);
            assert!(!names_one, "{}: a system names no backend, and this is {package}", path.display());
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen} dependencies");
    let manifest = "[package]\n\n[dependencies]\npredicament-hull.workspace = true\nrug = \"1\"\n\n[dev-dependencies]\npredicament-sos = {}\n";
    assert_eq!(dependencies(manifest), ["predicament-hull"]);
    assert!(group("predicament-hull") > group("predicament-judge"));
}

/// The Rust files in a folder and its subfolders.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|why| panic!("{}: {why}", folder.display()));
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let of = |path: PathBuf| if path.is_dir() { sources(&path) } else { vec![path] };
    paths.flat_map(of).filter(|path| path.extension().is_some_and(|end| end == "rs")).collect()
}

/// Returns true for a library file with tests that are never compiled.
fn has_lost_tests(manifest: &str, source: &str) -> bool {
    let library = manifest.split("\n[").find(|section| section.starts_with("lib]"));
    let says = |wanted: &str| library.is_some_and(|section| section.lines().any(|line| line == wanted));
    says("test = false") && (source.contains("#[test]") || source.contains("proptest!"))
        || says("doctest = false") && has_example(source)
}

/// Returns true for a file whose documentation has a code block; a block marked as text does not count.
fn has_example(source: &str) -> bool {
    let text = source.lines().map(str::trim_start);
    let docs = text.filter_map(|line| line.strip_prefix("///").or_else(|| line.strip_prefix("//!")));
    let mut fences = docs.map(str::trim).filter(|line| line.starts_with("```"));
    std::iter::from_fn(|| Some([fences.next()?, fences.next().unwrap_or("```")])).any(|[open, _]| open != "```text")
}

#[test]
fn no_test_is_in_a_library_that_is_not_tested() {
    for manifest in manifests() {
        let text = std::fs::read_to_string(&manifest).expect("a manifest");
        let folder = manifest.with_file_name("src");
        for path in if folder.is_dir() { sources(&folder) } else { Vec::new() } {
            let source = std::fs::read_to_string(&path).expect("a file");
            assert!(!has_lost_tests(&text, &source), "move the tests of {} into `tests`", path.display());
        }
    }
}

#[test]
fn a_lost_test_is_seen() {
    let [tested, not] = ["[package]\n\n[lib]\nname = \"a\"\n", "[package]\n\n[lib]\ntest = false\n\n[features]\n"];
    let [with, without] = ["#[test]\nfn a() {}\n", "fn a() {}\n"];
    assert!(has_lost_tests(not, with));
    assert!(!has_lost_tests(not, without) && !has_lost_tests(tested, with));
    let no_examples = "[package]\n\n[lib]\ndoctest = false\n";
    let example = "    /// Adds:\n    /// ```\n    /// assert_eq!(add(1, 1), 2);\n    /// ```\n    fn add() {}\n";
    assert!(has_lost_tests(no_examples, example) && !has_lost_tests(tested, example));
    assert!(!has_lost_tests(no_examples, &example.replacen("```", "```text", 1)), "a figure");
}

/// The marks in a line that reveal a page's machine or the source of its packages.
fn names_a_host(line: &str) -> bool {
    // In pieces, so that this file passes.
    let marks =
        [["/ho", "me/"], ["/ro", "ot/"], ["/Us", "ers/"], ["crates", ".io"], ["do", "cs.rs"], ["local", "host"]];
    marks.iter().any(|mark| line.contains(&mark.concat()))
}

/// The tracked files are those outside of build folders: pages, sources, corpora, manifests.
#[test]
fn no_file_names_a_host_or_somebodys_folders() {
    fn check(path: &Path, seen: &mut usize) {
        if path.is_dir() {
            if ["target", ".git", "fuzz/corpus", "venv", "packages", "node_modules"]
                .iter()
                .any(|name| path.ends_with(name))
            {
                return;
            }
            let entries = std::fs::read_dir(path).expect("a folder");
            entries.for_each(|entry| check(&entry.expect("an entry").path(), seen));
        } else if path
            .extension()
            .is_some_and(|end| ["rs", "md", "toml", "html", "txt", "sh"].iter().any(|of| end == *of))
        {
            let text = std::fs::read_to_string(path).unwrap_or_default();
            *seen += 1;
            for (at, line) in text.lines().enumerate() {
                assert!(!names_a_host(line), "{}:{}: {line}", path.display(), at + 1);
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut seen = 0;
    for name in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "Cargo.toml", "deny.toml"] {
        check(&root.join(name), &mut seen);
    }
    for name in ["docs", "crates", "harness", "corpora", "engines", "examples", "fuzz", "reports"] {
        check(&root.join(name), &mut seen);
    }
    assert!(seen > 300, "{seen} files");
    assert!(names_a_host(&["see ", "do", "cs.rs/rug"].concat()));
}

/// Returns true if a system has its own page and its package shows it.
fn has_a_page(manifest: &str, page: &str) -> bool {
    let lines = page.lines().count();
    let says = ["## What it asks", "## What is true", "## Checks", "## Scenes", "## Run it"];
    manifest.contains("\nreadme = \"README.md\"\n")
        && (25..=70).contains(&lines)
        && says.iter().all(|heading| page.contains(heading))
}

/// The folders of all systems: all crates next to them, without their common base.
fn systems() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../systems");
    let folders = std::fs::read_dir(root).expect("the systems").map(|entry| entry.expect("an entry").path());
    folders.filter(|folder| folder.is_dir() && !folder.ends_with("grid")).collect()
}

#[test]
fn each_system_has_a_page() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../systems");
    let list = std::fs::read_to_string(root.join("README.md")).expect("a page");
    let mut seen = 0;
    for folder in systems() {
        let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap_or_default();
        assert!(has_a_page(&read("Cargo.toml"), &read("README.md")), "{} has no page", folder.display());
        let name = folder.file_name().and_then(|name| name.to_str()).expect("a name");
        assert!(list.contains(&format!("]({name}/README.md)")), "{name} is not in the list of systems");
        seen += 1;
    }
    assert!(seen > 10, "{seen} systems");
    let page = "# a\n".repeat(30);
    assert!(!has_a_page("\nreadme = \"README.md\"\n", &page), "without headings");
}

/// A command is a leaf: code that two commands need is in neither.
#[test]
fn nothing_imports_a_command() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../harness/src");
    let imports = |text: &str| ["crate::cmd", "super::cmd"].iter().any(|path| text.contains(path));
    let of_commands = |path: &Path| path.starts_with(root.join("cmd"));
    let mut seen = 0;
    for path in sources(&root).into_iter().filter(|path| !of_commands(path) && !path.ends_with("cli.rs")) {
        let text = std::fs::read_to_string(&path).expect("a file");
        assert!(!imports(&text), "{} imports a command", path.display());
        seen += 1;
    }
    assert!(seen > 50 && imports("use crate::cmd::run;"), "{seen} files");
}

/// The blocks of Rust of a page.
fn rust_blocks(page: &str) -> Vec<&str> {
    let blocks = page.split("```rust\n").skip(1);
    blocks.map(|rest| rest.split("\n```").next().unwrap_or_default()).collect()
}

/// The blocks of a page that are in none of these files.
fn unknown<'p>(page: &'p str, files: &[String]) -> Vec<&'p str> {
    rust_blocks(page).into_iter().filter(|block| !files.iter().any(|file| file.contains(block))).collect()
}

/// The text of a file without the parts that a page omits: the lines about itself and the path of the tool.
fn shown(file: &str) -> String {
    let own = file.lines().skip_while(|line| line.starts_with("//!")).collect::<Vec<_>>().join("\n");
    own.trim().replace("../../harness", "../predicament/harness")
}

/// The pages of a backend and of a task are complete instructions.
///
/// Each of these files is a block of the page, unshortened.
#[test]
fn a_page_has_every_file_of_its_example() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |path: &str| std::fs::read_to_string(root.join(path)).unwrap_or_else(|why| panic!("{path}: {why}"));
    let files = [
        ("BACKENDS", "mine", &["Cargo.toml", "src/lib.rs", "src/main.rs", "tests/holds.rs"][..]),
        ("TASKS", "convexity", &["Cargo.toml", "src/lib.rs", "src/main.rs", "corpora/corners.toml", "tests/holds.rs"]),
    ];
    for (page, example, files) in files {
        let text = read(&format!("docs/{page}.md"));
        let blocks: Vec<&str> =
            text.split("\n```").skip(1).step_by(2).filter_map(|b| b.split_once('\n')).map(|b| b.1).collect();
        assert!(blocks.len() >= files.len(), "{page} shows code");
        for file in files {
            let shown = shown(&read(&format!("examples/{example}/{file}")));
            assert!(
                shown.len() > 60 && blocks.iter().any(|block| block.trim() == shown),
                "docs/{page}.md has another {file}"
            );
        }
    }
    assert_eq!(shown("//! About.\n\nfn main() {}\n"), "fn main() {}");
}

#[test]
fn pages_show_the_example_as_it_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |path: &Path| std::fs::read_to_string(path).unwrap_or_else(|why| panic!("{}: {why}", path.display()));
    let sources = std::fs::read_dir(root.join("examples/leftmost/src")).expect("the example");
    let sources: Vec<String> = sources.map(|entry| read(&entry.expect("a file").path())).collect();
    for (name, blocks) in [("TASKS", 8), ("STUDIES", 3)] {
        let page = read(&root.join(format!("docs/{name}.md")));
        assert!(rust_blocks(&page).len() >= blocks, "{name} shows code");
        assert_eq!(unknown(&page, &sources), [""; 0], "{name}: copy these from examples/leftmost/src");
    }
}

#[test]
fn a_block_that_is_in_no_file_is_seen() {
    let page = "One:\n```rust\nfn a() {}\n```\nand\n```rust\nfn b() {}\n```\n";
    assert_eq!(unknown(page, &["fn a() {}\n".to_owned()]), ["fn b() {}"]);
}

#[test]
fn a_crate_without_the_feature_is_seen() {
    let manifest = "[dependencies]\nrug.workspace = true\ngmp-mpfr-sys.workspace = true\n\n[dev-dependencies]\n\
                    rug = \"1\"\nruggedness = \"1\"\n";
    assert_eq!(without_feature(manifest), ["dev-dependencies"]);
    assert_eq!(without_feature("[dependencies]\nruggedness = \"1\"\n"), [""; 0]);
}
