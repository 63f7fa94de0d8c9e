//! Known faults, planted one by one in a copy of the tree: each must be detected.
//!
//! Spoiled answers prove that judges can fail. They do not prove that the scenes of the corpora, or the tests, reach
//! the place of an algorithm's error and show it. A fault is data: a text of a file, and its replacement. It is stored
//! in its crate, in `tests/faults.toml`; algorithms do not know it.

mod read;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::command::{cargo_command, root};

/// The folder of the copied tree, and of the runs in it.
const FOLDER: &str = "target/planted";

/// A planted fault.
#[derive(Debug)]
struct Planted {
    name: String,
    /// A description of the fault, in one line.
    what: String,
    changes: Vec<Change>,
    seen: Seen,
}

/// A text that occurs once in a file, and its replacement.
#[derive(Debug)]
struct Change {
    /// The file, relative to the root of the tree.
    file: PathBuf,
    is: String,
    becomes: String,
}

/// The check that must detect a fault, and passes without it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Seen {
    /// A test of this package with this in its name fails.
    Test { package: String, name: String },
    /// A run of this suite by this backend has findings of each of these classes and checks.
    Run { suite: String, backend: String, finds: Vec<[String; 2]> },
}

impl Change {
    /// The file's text without and with the change.
    ///
    /// # Errors
    /// If the old text does not occur exactly once.
    fn texts(&self, tree: &Path) -> Result<[String; 2], String> {
        let path = tree.join(&self.file);
        let text = std::fs::read_to_string(&path).map_err(|why| format!("{}: {why}", path.display()))?;
        let changed = self.applied(&text).map_err(|why| format!("{}: {why}", path.display()))?;
        Ok([text, changed])
    }

    fn applied(&self, text: &str) -> Result<String, String> {
        match text.matches(&self.is).count() {
            1 => Ok(text.replacen(&self.is, &self.becomes, 1)),
            count => Err(format!("this is there {count} times, and not once:\n{}", self.is)),
        }
    }
}

/// Plants the faults with these names, or all, and prints which were detected.
///
/// # Errors
/// If a fault is not detected or does not compile, or no fault has the name.
pub(super) fn try_all(names: &[String]) -> Result<(), String> {
    let all = read::all(&root())?;
    if let Some(unknown) = names.iter().find(|name| all.iter().all(|fault| fault.name != **name)) {
        let known: Vec<&str> = all.iter().map(|fault| fault.name.as_str()).collect();
        return Err(format!("mutants: no planted fault is called `{unknown}`; there are {}", known.join(", ")));
    }
    let chosen: Vec<&Planted> = all.iter().filter(|fault| names.is_empty() || names.contains(&fault.name)).collect();
    let folder = root().join(FOLDER);
    let tree = Tree { path: folder.join("tree"), built: root().join(super::BUILT), out: folder.join("run") };
    tree.copy()?;
    let mut without = BTreeMap::new();
    let mut unseen = Vec::new();
    for fault in chosen {
        println!("\n== {}: {}", fault.name, fault.what);
        let before = match without.get(&fault.seen) {
            Some(&known) => known,
            None => tree.sees(&fault.seen)?,
        };
        without.insert(&fault.seen, before);
        let seen = if before == Sight::Nothing { tree.planted(fault)? } else { Sight::Unclear };
        println!("{}: {}", fault.name, seen.told());
        if seen != Sight::Fault {
            unseen.push(fault.name.as_str());
        }
    }
    match unseen[..] {
        [] => Ok(()),
        _ => Err(format!("mutants: not seen: {}", unseen.join(", "))),
    }
}

/// Updates the copy of the tree, and returns its folder.
pub(super) fn copied() -> Result<PathBuf, String> {
    let folder = root().join(FOLDER);
    let tree = Tree { path: folder.join("tree"), built: PathBuf::new(), out: PathBuf::new() };
    tree.copy().map(|()| tree.path)
}

/// The result of a check.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Sight {
    Fault,
    Nothing,
    /// Findings of some of the checks, or a run that ended otherwise.
    Part,
    /// The faulty tree does not compile.
    Unbuilt,
    /// The check fails without the fault.
    Unclear,
}

impl Sight {
    fn told(self) -> &'static str {
        match self {
            Sight::Fault => "caught",
            Sight::Nothing => "MISSED",
            Sight::Part => "MISSED BY SOME of its checks",
            Sight::Unbuilt => "DOES NOT COMPILE",
            Sight::Unclear => "NOT TRIED: what has to see it sees something without it, or does not run",
        }
    }
}

/// A copy of the tree, its build folder, and a folder for a run.
struct Tree {
    path: PathBuf,
    built: PathBuf,
    out: PathBuf,
}

impl Tree {
    /// Updates the copy to equal the tree, without files that git ignores.
    ///
    /// Unchanged files stay, and are not compiled again.
    fn copy(&self) -> Result<(), String> {
        let listed = Command::new("git")
            .args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"])
            .current_dir(root())
            .stderr(Stdio::inherit())
            .output()
            .map_err(|why| format!("git did not start: {why}"))?;
        if !listed.status.success() {
            return Err("mutants: git does not list the files of the tree".to_owned());
        }
        let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
        // A link to a folder is copied as that folder.
        let of = |name: &str| {
            let path = root().join(name);
            if path.is_dir() { files_in(&path) } else { vec![path] }
        };
        let listed = listed.split('\0').filter(|name| !name.is_empty()).flat_map(of).filter(|path| path.is_file());
        let text = |why: std::io::Error, path: &Path| format!("{}: {why}", path.display());
        let mut kept: Vec<PathBuf> = Vec::new();
        for from in listed {
            let to = self.path.join(from.strip_prefix(root()).expect("a file of the tree"));
            let new = std::fs::read(&from).map_err(|why| text(why, &from))?;
            if std::fs::read(&to).ok().as_ref() != Some(&new) {
                let folder = to.parent().expect("a file in the tree");
                std::fs::create_dir_all(folder).map_err(|why| text(why, folder))?;
                std::fs::write(&to, new).map_err(|why| text(why, &to))?;
            }
            kept.push(to);
        }
        kept.sort_unstable();
        for old in files_in(&self.path).into_iter().filter(|path| kept.binary_search(path).is_err()) {
            std::fs::remove_file(&old).map_err(|why| text(why, &old))?;
        }
        Ok(())
    }

    /// The result of the check with a fault planted.
    fn planted(&self, fault: &Planted) -> Result<Sight, String> {
        let mut before: Vec<(PathBuf, String)> = Vec::new();
        let write =
            |path: &Path, text: &str| std::fs::write(path, text).map_err(|why| format!("{}: {why}", path.display()));
        let mut planted = Ok(());
        for change in &fault.changes {
            let path = self.path.join(&change.file);
            planted = change.texts(&self.path).and_then(|[text, changed]| {
                before.push((path.clone(), text));
                write(&path, &changed)
            });
            if planted.is_err() {
                break;
            }
        }
        let seen = planted.and_then(|()| self.sees(&fault.seen));
        // The last first: a file may have changed twice.
        for (path, text) in before.iter().rev() {
            write(path, text)?;
        }
        seen
    }

    /// The result of a test or a run in the tree.
    fn sees(&self, seen: &Seen) -> Result<Sight, String> {
        match seen {
            Seen::Test { package, name } => {
                let package = format!("predicament-{package}");
                // Unit tests are in the library. Others may be in any program of tests.
                let place: &[&str] = if name.contains("tests::") { &["--lib"] } else { &["--test", "*"] };
                let test = [&["test", "--quiet", "--profile", "mutants", "-p", &package], place].concat();
                if self.cargo(&[&test[..], &["--no-run"]].concat())? != 0 {
                    return Ok(Sight::Unbuilt);
                }
                Ok(if self.cargo(&[&test[..], &["--", name]].concat())? == 0 { Sight::Nothing } else { Sight::Fault })
            }
            Seen::Run { suite, backend, finds } => {
                if self.cargo(&["build", "--quiet", "--profile", "mutants", "--bin", "predicament"])? != 0 {
                    return Ok(Sight::Unbuilt);
                }
                if self.out.exists() {
                    std::fs::remove_dir_all(&self.out).map_err(|why| format!("{}: {why}", self.out.display()))?;
                }
                let out = self.out.display().to_string();
                let tool = self.built.join("mutants/predicament").with_extension(std::env::consts::EXE_EXTENSION);
                let run = ["run", suite, "-b", backend, "--quiet", "--out", &out];
                let code = self.run(tool.as_os_str(), &run)?;
                let path = self.out.join("findings.csv");
                let findings = std::fs::read_to_string(&path).map_err(|why| format!("{}: {why}", path.display()))?;
                Ok(match (code, has_all(&findings, backend, finds)) {
                    // Expected findings do not come from a fault.
                    (0 | 100, [_, false]) => Sight::Nothing,
                    (100, [true, _]) => Sight::Fault,
                    (code, [all, any]) => {
                        println!("the run ended with {code}; findings of all checks: {all}, of any: {any}");
                        Sight::Part
                    }
                })
            }
        }
    }

    fn cargo(&self, args: &[&str]) -> Result<i32, String> {
        let words = cargo_command(args);
        let args: Vec<&str> = words[1..].iter().map(String::as_str).collect();
        self.run(words[0].as_ref(), &args)
    }

    /// Runs a program in the tree; returns its exit code.
    fn run(&self, program: &std::ffi::OsStr, args: &[&str]) -> Result<i32, String> {
        let status = Command::new(program)
            .args(args)
            .env("CARGO_TARGET_DIR", &self.built)
            .current_dir(&self.path)
            .stdout(Stdio::null())
            .status()
            .map_err(|why| format!("{} did not start: {why}", program.display()))?;
        Ok(status.code().unwrap_or(-1))
    }
}

/// True if a backend has findings of all of these classes and checks, and true if it has any.
fn has_all(findings: &str, backend: &str, finds: &[[String; 2]]) -> [bool; 2] {
    let has = |[class, check]: &[String; 2]| findings.contains(&format!(",{backend},{class},{check},"));
    [finds.iter().all(has), finds.iter().any(has)]
}

/// The files in a folder and its subfolders.
fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries =
        std::fs::read_dir(folder).into_iter().flatten().filter_map(|entry| entry.ok().map(|entry| entry.path()));
    let of = |path: PathBuf| if path.is_dir() { files_in(&path) } else { vec![path] };
    entries.flat_map(of).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// Each fault can be planted in the current tree.
    ///
    /// The command, which takes minutes, shows whether it is detected.
    #[test]
    fn every_text_is_in_its_file_once() {
        let all = read::all(&root()).unwrap_or_else(|why| panic!("{why}"));
        for fault in &all {
            assert!(!fault.changes.is_empty(), "{}", fault.name);
            for change in &fault.changes {
                let [text, changed] = change.texts(&root()).unwrap_or_else(|why| panic!("{}: {why}", fault.name));
                assert_ne!(text, changed, "{}", fault.name);
            }
        }
        let names: BTreeSet<&str> = all.iter().map(|fault| fault.name.as_str()).collect();
        assert_eq!(names.len(), all.len(), "each name once");
        assert!(names.len() > 50, "{}", names.len());
    }

    /// A fault whose test is not where it is looked for would never be noticed, and seem to be missed.
    #[test]
    fn every_test_of_a_fault_is_where_it_is_run() {
        let folders = ["crates", "harness"].map(|folder| root().join(folder));
        let manifests: Vec<PathBuf> =
            folders.iter().flat_map(|folder| files_in(folder)).filter(|path| path.ends_with("Cargo.toml")).collect();
        let is_of = |path: &&PathBuf, package: &str| {
            let text = std::fs::read_to_string(path).unwrap();
            text.contains(&format!("name = \"predicament-{package}\"\n"))
        };
        let mut seen = 0;
        for fault in read::all(&root()).unwrap() {
            let Seen::Test { package, name } = &fault.seen else { continue };
            let manifest = manifests.iter().find(|path| is_of(path, package)).expect(package);
            let place = manifest.with_file_name(if name.contains("tests::") { "src" } else { "tests" });
            let function = format!("fn {}", name.rsplit("::").next().unwrap_or(name));
            let has = |path: PathBuf| std::fs::read_to_string(path).is_ok_and(|text| text.contains(&function));
            assert!(files_in(&place).into_iter().any(has), "{}: no `{function}` in {}", fault.name, place.display());
            seen += 1;
        }
        assert!(seen > 40, "{seen}");
    }

    #[test]
    fn a_text_that_is_not_there_once_is_an_error() {
        let change = |is: &str| Change { file: "a.rs".into(), is: is.to_owned(), becomes: "z".to_owned() };
        let of = |is| change(is).applied("x y y");
        assert_eq!(of("x"), Ok("z y y".to_owned()));
        assert!(of("y").unwrap_err().starts_with("this is there 2 times"));
        assert!(of("w").unwrap_err().starts_with("this is there 0 times"));
        assert!(try_all(&["no-such-fault".to_owned()]).unwrap_err().contains("closed-interval"));
    }

    #[test]
    fn findings_are_told_by_class_and_check() {
        let table = "id,suite,scene,scene_id,task,backend,class,check\n1,s,a,b,t,exact,topology,gap,\n";
        let has = |backend, finds: &[[&str; 2]]| {
            let finds: Vec<[String; 2]> = finds.iter().map(|pair| pair.map(str::to_owned)).collect();
            has_all(table, backend, &finds)
        };
        assert_eq!(has("exact", &[["topology", "gap"]]), [true, true]);
        assert_eq!(has("exact", &[["topology", "gap"], ["topology", "double"]]), [false, true]);
        assert_eq!(has("sos", &[["topology", "gap"]]), [false, false]);
    }
}
