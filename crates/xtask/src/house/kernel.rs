//! The weight of the crates that other libraries depend on.

use std::collections::BTreeSet;
use std::path::Path;

use super::dependencies;

/// The names in a section of dependencies that are compiled without any feature.
fn compiled(manifest: &str) -> Vec<&str> {
    let sections = manifest.split("\n[").filter(|section| section.starts_with("dependencies]"));
    let lines = sections.flat_map(str::lines).skip(1).filter(|line| !line.contains("optional = true"));
    lines.filter(|line| line.contains('=')).filter_map(|line| line.split(['.', ' ', '=']).next()).collect()
}

/// The dependencies that turn on GMP in a crate that can do without it.
fn with_gmp(manifest: &str) -> Vec<&str> {
    let sections =
        manifest.split("\n[").filter(|section| section.split(']').next().unwrap_or("").ends_with("dependencies"));
    let sections = sections.filter(|section| !section.starts_with("dev-"));
    let lines = sections.flat_map(str::lines).filter(|line| !line.contains("optional = true"));
    lines.filter(|line| line.contains("features") && line.contains("\"gmp\"")).collect()
}

/// Everything that a crate is compiled with: own crates by folder, and other packages.
fn closure(folder: &Path) -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (mut open, mut seen) = (vec![folder.to_owned()], BTreeSet::new());
    while let Some(folder) = open.pop() {
        let shown = folder.display();
        let text = std::fs::read_to_string(root.join(&folder).join("Cargo.toml"));
        let text = text.unwrap_or_else(|why| panic!("{shown}: {why}"));
        assert!(!root.join(&folder).join("build.rs").exists(), "{shown} has a build script");
        assert_eq!(with_gmp(&text), [""; 0], "{shown} is built with GMP");
        for package in compiled(&text) {
            let own = package.strip_prefix("predicament-");
            if seen.insert(own.unwrap_or(package).to_owned()) {
                open.extend(own.map(|own| Path::new("kernel").join(own)));
            }
        }
    }
    seen.into_iter().collect()
}

/// `predicament-exact` takes one more crate of the kernel; `predicament-sos` and the C library take a few: no GMP, no
/// serde, no build script.
#[test]
fn the_kernel_and_the_c_library_depend_on_the_kernel_alone() {
    let sos = ["arithmetic", "exact", "lanes", "predicates", "smallvec"];
    assert_eq!(closure(Path::new("kernel/exact")), ["arithmetic"]);
    assert_eq!(closure(Path::new("kernel/sos")), sos);
    let all: BTreeSet<&str> = sos.into_iter().chain(["self_cell", "sos"]).collect();
    let mut library = closure(Path::new("bindings/c"));
    library.extend(closure(Path::new("kernel/sos")));
    library.push("sos".to_owned()); // a feature that is on by default
    assert_eq!(library.iter().map(String::as_str).collect::<BTreeSet<_>>(), all);
    let workspace = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../Cargo.toml")).unwrap();
    assert_eq!(with_gmp(&workspace), [""; 0], "no crate of the workspace gets GMP with another one");
    let given = "[dependencies]\npredicament-a = { workspace = true, features = [\"gmp\"] }\nb = { features = [\"gmp\"], \
                 optional = true }\n\n[dev-dependencies]\nc = { features = [\"gmp\"] }\n";
    assert_eq!(with_gmp(given), ["predicament-a = { workspace = true, features = [\"gmp\"] }"]);
    let manifest = "[package]\n\n[dependencies]\npredicament-a.workspace = true\n# about b\nserde = { version = \"1\", \
                    optional = true }\nrug = \"1\"\n\n[dev-dependencies]\nproptest = \"1\"\n";
    assert_eq!(compiled(manifest), ["predicament-a", "rug"]);
    assert_eq!(dependencies(manifest), ["predicament-a"]);
}
