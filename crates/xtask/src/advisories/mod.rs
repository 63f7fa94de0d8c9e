//! `cargo xtask advisories`: checks the lock files against a RustSec advisory database on this machine.
//!
//! It reads the database itself and does not use the network. So it runs wherever a copy exists, and can be tested with
//! a copy of two files.

mod database;
mod version;

use std::path::{Path, PathBuf};

use crate::command::root;
use database::{Advisory, Database, entries, strings};
use version::Version;

/// The message about everything that this check does not cover.
const NOT_CHECKED: &str = "not checked: yanked versions, the toolchain, C code of crates (GMP), and the lists of npm and pip (package-lock.json, \
                           requirements.txt), for which `npm audit` and `pip-audit` ask the network";

/// Checks all lock files against the database of `--db DIR`, or against one that cargo-audit or cargo-deny has left.
///
/// # Errors
/// If there is no database, something in it can't be read, or a locked version is vulnerable or unsound.
pub fn check(args: &[String]) -> Result<(), String> {
    let named = match args {
        [] => None,
        [option, folder] if option == "--db" => Some(PathBuf::from(folder)),
        _ => return Err("usage: cargo xtask advisories [--db DIR]".to_owned()),
    };
    let folder = named.or_else(at_hand).ok_or(
        "no advisory database is on this machine, so no lock file was checked; clone RustSec's advisory-db and name it by \
         `--db DIR`",
    )?;
    let database = Database::open(&folder)?;
    println!("{} advisories, the newest of {}", database.advisories.len(), database.newest());
    let mut findings = Findings { unread: database.unread.clone(), ..Findings::default() };
    let file = root().join("deny.toml");
    findings.ignored =
        ignored(&std::fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?)?;
    for lock in locks(&root())? {
        let text = std::fs::read_to_string(root().join(&lock)).map_err(|error| format!("{lock}: {error}"))?;
        findings.hold(&lock, &text, &database.advisories);
    }
    findings.tell()
}

/// Runs the same check in `nightly`, which continues without a database and reports that.
///
/// # Errors
/// As [`check`], except for a missing database.
pub fn check_if_at_hand() -> Result<(), String> {
    println!("\n== advisories");
    if at_hand().is_none() {
        println!("== advisories: NOT RUN: no advisory database is on this machine; see `cargo xtask help`");
        return Ok(());
    }
    check(&[])
}

/// The database that cargo-audit or cargo-deny stores in cargo's folder.
fn at_hand() -> Option<PathBuf> {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| std::env::home_dir().map(|home| home.join(".cargo")))?;
    let of_deny = entries(&home.join("advisory-dbs")).unwrap_or_default();
    std::iter::once(home.join("advisory-db")).chain(of_deny).find(|folder| folder.join("crates").is_dir())
}

/// The lock files of cargo: of the workspace, of the fuzz targets, of the tool `switches` and of each engine in Rust.
///
/// # Errors
/// If a folder can't be read.
pub fn locks(root: &Path) -> Result<Vec<String>, String> {
    let mut locks = ["Cargo.lock", "fuzz/Cargo.lock", "tools/switches/Cargo.lock"].map(str::to_owned).to_vec();
    let mut packages = entries(&root.join("engines"))?;
    packages.sort();
    for package in packages.into_iter().filter(|package| package.join("Cargo.toml").is_file()) {
        let name = package.file_name().unwrap_or_default().to_string_lossy().into_owned();
        locks.push(format!("engines/{name}/Cargo.lock"));
    }
    Ok(locks)
}

/// The ids in the list `ignore` of deny.toml with their reasons.
fn ignored(config: &str) -> Result<Vec<(String, String)>, String> {
    let list =
        config.split_once("\nignore = [\n").and_then(|(_, rest)| rest.split_once("\n]")).map_or("", |(list, _)| list);
    let entries = list.lines().map(|line| match strings(line)?.0.as_slice() {
        [id, reason] if !reason.trim().is_empty() => Ok((id.clone(), reason.clone())),
        _ => Err(format!("deny.toml: `{}` is not an id with a reason", line.trim())),
    });
    entries.collect()
}

/// The findings, one line for each.
#[derive(Default, PartialEq, Eq, Debug)]
struct Findings {
    /// Vulnerable or unsound versions.
    hits: Vec<String>,
    /// Versions of unmaintained crates or with a notice, and ignored hits.
    notes: Vec<String>,
    /// The files that could not be read.
    unread: Vec<String>,
    /// Ignored advisories, each with the reason.
    ignored: Vec<(String, String)>,
    /// The number of checked packages.
    packages: usize,
}

impl Findings {
    /// Checks each package of a lock file against the advisories.
    fn hold(&mut self, lock: &str, text: &str, advisories: &[Advisory]) {
        for (package, version) in packages(text) {
            self.packages += 1;
            let Some(parsed) = Version::parse(version) else {
                self.unread.push(format!("{lock}: {package} {version} is not a version"));
                continue;
            };
            for advisory in advisories.iter().filter(|advisory| advisory.package == package) {
                let patched =
                    if advisory.patched.is_empty() { "none".to_owned() } else { advisory.patched.join(" or ") };
                let kind = advisory.informational.as_deref().unwrap_or("vulnerable");
                let mut line = format!("{lock}: {package} {version}: {}, {kind}; patched: {patched}", advisory.id);
                let reason = self.ignored.iter().find(|(id, _)| *id == advisory.id).map(|(_, reason)| reason);
                if let Some(reason) = reason {
                    line += &format!("; let pass by deny.toml: {reason}");
                }
                match advisory.affects(&parsed) {
                    Err(why) => self.unread.push(format!("{}: {why}", advisory.id)),
                    Ok(true) if reason.is_none() && ["vulnerable", "unsound"].contains(&kind) => self.hits.push(line),
                    Ok(true) => self.notes.push(line),
                    Ok(false) => {}
                }
            }
        }
    }

    /// Prints the lines; returns an error if one of them requires a change.
    fn tell(&self) -> Result<(), String> {
        self.hits.iter().for_each(|line| println!("{line}"));
        self.notes.iter().for_each(|line| println!("note: {line}"));
        self.unread.iter().for_each(|line| println!("not read: {line}"));
        println!("{} locked packages checked; {NOT_CHECKED}", self.packages);
        if self.hits.is_empty() && self.unread.is_empty() {
            return Ok(());
        }
        Err(format!(
            "{} advisories about locked versions, {} files or versions not read",
            self.hits.len(),
            self.unread.len()
        ))
    }
}

/// The names and versions of the packages of a lock file that come from a registry or a repository.
fn packages(lock: &str) -> Vec<(&str, &str)> {
    fn field<'l>(package: &'l str, key: &str) -> Option<&'l str> {
        let (_, rest) = package.split_once(&format!("\n{key} = \""))?;
        rest.split('"').next()
    }
    let packages = lock.split("[[package]]").skip(1).filter(|package| field(package, "source").is_some());
    packages.filter_map(|package| Some((field(package, "name")?, field(package, "version")?))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lock file with a crate of this version from a registry, and a local crate.
    fn lock(version: &str) -> String {
        format!(
            "version = 4\n\n[[package]]\nname = \"leaky\"\nversion = \"{version}\"\nsource = \"registry+r\"\n\
             checksum = \"c\"\n\n[[package]]\nname = \"own\"\nversion = \"0.1.0\"\ndependencies = [\n \"leaky\",\n]\n"
        )
    }

    /// A database in a separate folder, with one advisory of this kind about `leaky`.
    fn database(name: &str, kind: &str) -> Database {
        let folder = std::env::temp_dir().join(format!("predicament-advisories-{name}-{}", std::process::id()));
        let of = folder.join("crates/leaky");
        std::fs::create_dir_all(&of).unwrap();
        let text = format!(
            "```toml\n[advisory]\nid = \"RUSTSEC-2024-0001\"\npackage = \"leaky\"\ndate = \"2024-01-02\"\n{kind}\n\
             [versions]\npatched = [\">= 1.2.0\", \"^1.0.7\"]\nunaffected = [\"< 0.5.0\"]\n```\n# It leaks\n"
        );
        std::fs::write(of.join("RUSTSEC-2024-0001.md"), text).unwrap();
        std::fs::write(of.join("RUSTSEC-2024-0002.md"), "no front matter").unwrap();
        let database = Database::open(&folder).unwrap();
        std::fs::remove_dir_all(&folder).unwrap();
        database
    }

    fn found(database: &Database, version: &str) -> Findings {
        let mut findings = Findings::default();
        findings.hold("Cargo.lock", &lock(version), &database.advisories);
        findings
    }

    #[test]
    fn a_vulnerable_version_is_named_and_a_patched_one_is_not() {
        let database = database("vulnerable", "");
        for version in ["0.5.0", "1.0.6", "1.2.0-rc.1"] {
            let findings = found(&database, version);
            let line =
                format!("Cargo.lock: leaky {version}: RUSTSEC-2024-0001, vulnerable; patched: >= 1.2.0 or ^1.0.7");
            // A pre-release of 1.2.0 is within `^1.0.7`.
            let expected = if version == "1.2.0-rc.1" { vec![] } else { vec![line] };
            assert_eq!((findings.hits.clone(), findings.packages), (expected, 1), "{version}");
            assert_eq!(findings.tell().is_ok(), findings.hits.is_empty());
        }
        for version in ["0.4.9", "1.0.7", "1.2.0", "3.0.0"] {
            let findings = found(&database, version);
            assert_eq!(findings, Findings { packages: 1, ..Findings::default() }, "{version}");
            assert_eq!(findings.tell(), Ok(()));
        }
    }

    #[test]
    fn what_is_unsound_is_a_hit_and_what_is_unmaintained_is_a_note() {
        let unsound = found(&database("unsound", "informational = \"unsound\""), "1.0.0");
        assert_eq!((unsound.hits.len(), unsound.notes.len()), (1, 0));
        let unmaintained = found(&database("unmaintained", "informational = \"unmaintained\""), "1.0.0");
        assert_eq!((unmaintained.hits.len(), unmaintained.notes.len()), (0, 1));
        assert_eq!(unmaintained.tell(), Ok(()));
    }

    #[test]
    fn what_deny_toml_lets_pass_is_a_note_with_the_reason() {
        let config = "[advisories]\nignore = [\n    { id = \"RUSTSEC-2024-0001\", reason = \"not reached\" },\n]\n";
        let mut findings = Findings { ignored: ignored(config).unwrap(), ..Findings::default() };
        findings.hold("Cargo.lock", &lock("1.0.0"), &database("ignored", "").advisories);
        assert!(findings.hits.is_empty() && findings.notes[0].ends_with("; let pass by deny.toml: not reached"));
        assert!(ignored(&config.replace("not reached", " ")).unwrap_err().ends_with("is not an id with a reason"));
        let ours = std::fs::read_to_string(root().join("deny.toml")).unwrap();
        assert_eq!(ignored(&ours).unwrap().len(), ours.matches("RUSTSEC-").count());
    }

    #[test]
    fn what_can_t_be_read_is_red() {
        let database = database("unread", "");
        assert!(database.unread.len() == 1 && database.unread[0].contains("RUSTSEC-2024-0002.md: it does not begin"));
        let findings = Findings { unread: database.unread, ..Findings::default() };
        assert_eq!(findings.tell().unwrap_err(), "0 advisories about locked versions, 1 files or versions not read");
        let odd = found(&Database { advisories: database.advisories, unread: Vec::new() }, "one");
        assert_eq!(odd.unread, ["Cargo.lock: leaky one is not a version"]);
    }

    #[test]
    fn every_lock_file_of_this_repository_is_held() {
        let all = locks(&root()).unwrap();
        assert_eq!(all[..3], ["Cargo.lock", "fuzz/Cargo.lock", "tools/switches/Cargo.lock"]);
        assert!(all.contains(&"engines/simplicity/Cargo.lock".to_owned()) && all.len() == 23, "{all:?}");
        let planted = |package: &str| Advisory {
            id: "RUSTSEC-2024-0003".to_owned(),
            package: package.to_owned(),
            patched: vec![">= 1000.0.0".to_owned()],
            ..Advisory::default()
        };
        for lock in &all {
            let text = std::fs::read_to_string(root().join(lock)).unwrap();
            let (package, few) = match lock.split('/').next() {
                Some("engines") => ("rustix", 7),
                Some("tools") => ("syn", 4),
                _ => ("rug", 20),
            };
            let mut findings = Findings::default();
            findings.hold(lock, &text, &[planted(package)]);
            assert!(findings.packages >= few && findings.hits.len() == 1, "{lock}: {findings:?}");
        }
    }

    #[test]
    fn arguments_are_a_folder_or_nothing() {
        let words = |words: &[&str]| words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>();
        for wrong in [&["--db"][..], &["folder"], &["--db", "a", "b"]] {
            assert!(check(&words(wrong)).unwrap_err().starts_with("usage: "), "{wrong:?}");
        }
        assert!(check(&words(&["--db", "no-such-folder"])).unwrap_err().contains("no-such-folder"));
    }
}
