//! The weight of the crate that other libraries depend on.

use std::collections::BTreeSet;
use std::path::Path;

use super::dependencies;

/// The names in a section of dependencies that are compiled without any feature.
fn compiled(manifest: &str) -> Vec<&str> {
    let sections = manifest.split("\n[").filter(|section| section.starts_with("dependencies]"));
    let lines = sections.flat_map(str::lines).skip(1).filter(|line| !line.contains("optional = true"));
    lines.filter(|line| line.contains('=')).filter_map(|line| line.split(['.', ' ', '=']).next()).collect()
}

/// `predicament-exact` takes one more crate of the kernel: no GMP, no serde, no build script.
#[test]
fn the_exact_kernel_depends_on_the_kernel_alone() {
    let kernel = Path::new(env!("CARGO_MANIFEST_DIR")).join("../kernel");
    let (mut open, mut seen) = (vec!["exact".to_owned()], BTreeSet::new());
    while let Some(name) = open.pop() {
        let folder = kernel.join(&name);
        let text = std::fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_else(|why| panic!("{name}: {why}"));
        assert!(!folder.join("build.rs").exists(), "{name} has a build script");
        for package in compiled(&text) {
            let own = package.strip_prefix("predicament-");
            let own = own.unwrap_or_else(|| panic!("{name} depends on {package}; make it optional"));
            if seen.insert(own.to_owned()) {
                open.push(own.to_owned());
            }
        }
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), ["arithmetic"]);
    let manifest = "[package]\n\n[dependencies]\npredicament-a.workspace = true\n# about b\nserde = { version = \"1\", \
                    optional = true }\nrug = \"1\"\n\n[dev-dependencies]\nproptest = \"1\"\n";
    assert_eq!(compiled(manifest), ["predicament-a", "rug"]);
    assert_eq!(dependencies(manifest), ["predicament-a"]);
}
