//! The metadata of packages, and the rules by which cargo can package all of them together.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::manifests;
use crate::command::root;

/// The categories that packages use, as registries spell them.
const CATEGORIES: [&str; 4] = ["mathematics", "science", "algorithms", "development-tools::testing"];

/// The lines of a section of a manifest.
fn section<'m>(manifest: &'m str, name: &str) -> Vec<&'m str> {
    let head = format!("[{name}]");
    let lines = manifest.lines().skip_while(move |line| *line != head).skip(1);
    lines.take_while(|line| !line.starts_with('[')).collect()
}

/// The value of a key of a package, as TOML: its own, or the workspace's where it says so.
fn value<'m>(package: &[&'m str], workspace: &[&'m str], key: &str) -> Option<&'m str> {
    let of = |lines: &[&'m str], key: &str| {
        lines.iter().find_map(|line| line.strip_prefix(key)?.trim_start().strip_prefix('=').map(str::trim))
    };
    match of(package, &format!("{key}.workspace")) {
        Some("true") => of(workspace, key),
        _ => of(package, key),
    }
}

/// The strings of a list.
fn strings(list: &str) -> Vec<&str> {
    list.split('"').skip(1).step_by(2).collect()
}

/// True for a package that goes to a registry.
fn is_published(manifest: &str) -> bool {
    !section(manifest, "package").contains(&"publish = false")
}

/// The errors in the metadata of a package; `exists` is true for files in its folder.
fn lacking(manifest: &str, workspace: &str, exists: impl Fn(&str) -> bool) -> Vec<String> {
    let (package, shared) = (section(manifest, "package"), section(workspace, "workspace.package"));
    let of = |key: &str| value(&package, &shared, key);
    let text = |key: &str| of(key).map(|value| value.trim_matches('"')).unwrap_or_default();
    let mut wrong = Vec::new();
    let mut check = |is_fine: bool, why: &str| {
        if !is_fine {
            wrong.push(why.to_owned());
        }
    };
    check(
        (15..=160).contains(&text("description").chars().count()),
        "description: one sentence of 15 to 160 characters",
    );
    check(!text("description").ends_with('.'), "description: no full stop at the end");
    check(text("license") == "MIT OR Apache-2.0", "license: that of the workspace");
    let is_own = package.iter().any(|line| line.starts_with("readme = "));
    check(!text("readme").is_empty() && (!is_own || exists(text("readme"))), "readme: a file that is there");
    let keywords = strings(of("keywords").unwrap_or_default());
    let is_keyword =
        |word: &&str| word.len() <= 20 && word.chars().all(|c| c.is_ascii_alphanumeric() || "_-+".contains(c));
    check((1..=5).contains(&keywords.len()) && keywords.iter().all(is_keyword), "keywords: one to five words");
    let categories = strings(of("categories").unwrap_or_default());
    let is_known = |name: &&str| CATEGORIES.contains(name);
    check((1..=5).contains(&categories.len()) && categories.iter().all(is_known), "categories: names of the registry");
    for key in ["repository", "homepage", "documentation"] {
        let is_real = of(key).is_none_or(|value| value.starts_with("\"https://") && !value.contains("example.org"));
        check(is_real, &format!("{key}: an address that exists, or nothing"));
    }
    wrong
}

/// The packages of the workspace that a package names with a version, with the path of the manifest for each.
///
/// Cargo packages these first. A dependency of tests that has only a path is left out of packages.
fn needed<'m>(manifest: &'m str, workspace: &str) -> BTreeSet<&'m str> {
    let shared = section(workspace, "workspace.dependencies");
    let has_version = |line: &str, name: &str| {
        let shared =
            || shared.iter().any(|other| other.starts_with(&format!("{name} = ")) && other.contains("version"));
        if line.contains(".workspace = true") { shared() } else { line.contains("version") }
    };
    let lines = ["dependencies", "dev-dependencies", "build-dependencies"].map(|of| section(manifest, of)).concat();
    let named = lines.into_iter().filter(|line| line.starts_with("predicament"));
    let name = |line: &'m str| line.split(['.', ' ', '=']).next().unwrap_or_default();
    named.filter(|line| has_version(line, name(line))).map(name).collect()
}

/// Packages that wait for each other, so that none can be packaged first.
fn circle(needs: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<String> {
    let mut left: BTreeSet<String> = needs.keys().cloned().collect();
    loop {
        let waits = |name: &String| needs[name].iter().any(|other| left.contains(other));
        let still: BTreeSet<String> = left.iter().filter(|name| waits(name)).cloned().collect();
        if still.len() == left.len() {
            return left;
        }
        left = still;
    }
}

fn workspace() -> String {
    std::fs::read_to_string(root().join("Cargo.toml")).expect("the manifest of the workspace")
}

fn name(manifest: &str) -> String {
    value(&section(manifest, "package"), &[], "name").unwrap_or_default().trim_matches('"').to_owned()
}

/// The manifests of packages that go to a registry, with their folders.
fn published() -> Vec<(std::path::PathBuf, String)> {
    let bundle = root().join("harness/bundle/Cargo.toml");
    let read = |path: std::path::PathBuf| {
        let text = std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()));
        (path, text)
    };
    let all = manifests().into_iter().chain([bundle]).map(read);
    all.filter(|(_, manifest)| is_published(manifest)).collect()
}

#[test]
fn each_package_says_what_a_registry_asks() {
    let packages = published();
    assert!(packages.len() > 30, "{} packages", packages.len());
    let (workspace, mut seen) = (workspace(), BTreeMap::new());
    for (path, manifest) in &packages {
        let folder = path.parent().unwrap_or(Path::new(""));
        let wrong = lacking(manifest, &workspace, |file| folder.join(file).is_file());
        assert!(wrong.is_empty(), "{}:\n{}", path.display(), wrong.join("\n"));
        let description = value(&section(manifest, "package"), &[], "description").unwrap_or_default().to_owned();
        let other = seen.insert(description, path);
        assert!(other.is_none(), "{} and {other:?} have the same description", path.display());
    }
}

#[test]
fn packages_do_not_wait_for_each_other() {
    let workspace = workspace();
    let of = |(_, manifest): &(_, String)| {
        let needs = needed(manifest, &workspace).into_iter().map(str::to_owned).collect();
        (name(manifest), needs)
    };
    let needs: BTreeMap<String, BTreeSet<String>> = published().iter().map(of).collect();
    let circle = circle(&needs);
    assert!(circle.is_empty(), "name dependencies of tests that lead back by path alone: {circle:?}");
    assert!(
        needs["predicament"].contains("predicament-oracle")
            && !needs["predicament-judge"].contains("predicament-interval")
    );
}

#[test]
fn the_citation_has_the_version_of_the_tool() {
    let text = std::fs::read_to_string(root().join("CITATION.cff")).expect("the citation");
    let workspace = workspace();
    let version =
        value(&section(&workspace, "workspace.package"), &[], "version").expect("a version").trim_matches('"');
    assert!(
        text.lines().any(|line| line == format!("version: {version}")),
        "CITATION.cff has another version than {version}"
    );
    let changes = std::fs::read_to_string(root().join("CHANGELOG.md")).expect("the changes");
    assert!(changes.contains(&format!("\n## {version}\n")), "CHANGELOG.md has no section about {version}");
}

#[test]
fn missing_metadata_is_seen() {
    let workspace = "[workspace.package]\nlicense = \"MIT OR Apache-2.0\"\nkeywords = [\"a\"]\n\n[workspace.dependencies]\n\
                     predicament-a = { version = \"1\", path = \"a\" }\npredicament-b = { path = \"b\" }\n";
    let good = "[package]\nname = \"predicament-c\"\ndescription = \"Signs of determinants\"\nlicense.workspace = true\n\
                readme = \"README.md\"\nkeywords.workspace = true\ncategories = [\"mathematics\"]\n";
    assert_eq!(lacking(good, workspace, |_| true), [""; 0]);
    for (old, new, why) in [
        ("description = \"Signs of determinants\"\n", "", "description"),
        ("determinants", "determinants.", "description"),
        ("license.workspace = true", "license = \"MIT\"", "license"),
        ("readme = \"README.md\"\n", "", "readme"),
        ("keywords.workspace = true", "keywords = [\"a\", \"b\", \"c\", \"d\", \"e\", \"f\"]", "keywords"),
        ("keywords.workspace = true", "keywords = [\"two words\"]", "keywords"),
        ("mathematics", "maths", "categories"),
        ("categories", "repository = \"https://example.org/a\"\ncategories", "repository"),
        ("categories", "homepage = \"README.md\"\ncategories", "homepage"),
    ] {
        let said = lacking(&good.replacen(old, new, 1), workspace, |_| true);
        assert!(said.len() == 1 && said[0].starts_with(why), "{new}: {said:?}");
    }
    assert!(lacking(good, workspace, |_| false)[0].starts_with("readme"), "a file that is not there");
    assert!(is_published(good) && !is_published(&good.replace("license", "publish = false\nlicense")));
    let tests = "\n[dev-dependencies]\npredicament-a.workspace = true\npredicament-b.workspace = true\npredicament-d = { path = \"d\" }\n";
    assert_eq!(needed(&(good.to_owned() + tests), workspace), BTreeSet::from(["predicament-a"]));
}

#[test]
fn a_circle_of_packages_is_seen() {
    let needs = |pairs: &[(&str, &str)]| -> BTreeMap<String, BTreeSet<String>> {
        let mut needs: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (name, other) in pairs {
            needs.entry((*name).to_owned()).or_default().insert((*other).to_owned());
            needs.entry((*other).to_owned()).or_default();
        }
        needs
    };
    assert!(circle(&needs(&[("a", "b"), ("b", "c"), ("a", "c")])).is_empty());
    assert_eq!(circle(&needs(&[("a", "b"), ("b", "c"), ("c", "b")])).len(), 3);
}
