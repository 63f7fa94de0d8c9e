//! The packages that `engines install`, `engines build` and the chores install, checked against the project's rules:
//! versions fixed, digests known, scripts off.

use std::path::{Path, PathBuf};

use crate::command::root;

/// The commands of `install` in an `engine.toml`, and the cargo commands of `build`.
///
/// Each of them is on one line. Cargo's `build` fetches missing packages.
fn commands(config: &str) -> Vec<Vec<String>> {
    let of = |key: &str| {
        let line = config.lines().find_map(|line| line.strip_prefix(key)).unwrap_or_default();
        let words = |command: &str| command.split('"').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
        line.split("],").map(words).filter(|words| !words.is_empty()).collect::<Vec<_>>()
    };
    of("install").into_iter().chain(of("build").into_iter().filter(|words| words[0] == "cargo")).collect()
}

/// The error of a command in a folder; `None` if its packages are fixed.
fn wrong(folder: &Path, command: &[String]) -> Option<String> {
    let has = |word: &str| command.iter().any(|other| other == word);
    let shown = command.join(" ");
    let is = |program: &str| command[0] == program || command[0].ends_with(&format!("/{program}"));
    let read = |file: &str| std::fs::read_to_string(folder.join(file)).unwrap_or_default();
    if is("apt-get") {
        let packages = command.iter().skip(2).filter(|word| !word.starts_with('-'));
        return packages
            .filter(|package| !package.contains('='))
            .map(|package| format!("{shown}: fix the version of {package}"))
            .next();
    }
    if is("npm") {
        if !has("ci") || !has("--ignore-scripts") {
            return Some(format!("{shown}: use `npm ci --ignore-scripts`"));
        }
        return unlocked(&read("package-lock.json")).map(|why| format!("{shown}: {why}"));
    }
    if has("pip") || is("pip") {
        if !has("--require-hashes") || !has("--only-binary=:all:") {
            return Some(format!("{shown}: use `--require-hashes --only-binary=:all:`"));
        }
        let file = command.iter().skip_while(|word| *word != "-r").nth(1);
        let list = file.map(|file| read(file)).unwrap_or_default();
        return unhashed(&list).map(|why| format!("{shown}: {why}"));
    }
    if is("cargo") {
        if !has("--locked") {
            return Some(format!("{shown}: use `--locked`"));
        }
        let manifest = command.iter().skip_while(|word| *word != "--manifest-path").nth(1);
        let manifest = manifest.map_or("Cargo.toml", String::as_str);
        return unsummed(&read(&manifest.replace(".toml", ".lock"))).map(|why| format!("{shown}: {why}"));
    }
    (!has("venv")).then(|| format!("{shown}: a client that this test does not know"))
}

/// The error of npm's lock file: each package must have a digest and none an address.
fn unlocked(lock: &str) -> Option<String> {
    let packages = lock.matches("\n    \"node_modules/").count();
    let digests = lock.matches("\"integrity\": \"sha512-").count();
    if packages == 0 || packages != digests {
        return Some(format!("package-lock.json has {packages} packages and {digests} digests"));
    }
    lock.contains("\"resolved\"")
        .then(|| "package-lock.json names a host; make it with --omit-lockfile-registry-resolved".to_owned())
}

/// The error of cargo's lock file.
///
/// Each package must be of this repository, or have a digest and come from the registry.
fn unsummed(lock: &str) -> Option<String> {
    let packages: Vec<&str> = lock.split("[[package]]").skip(1).filter(|one| one.contains("\nsource = ")).collect();
    if packages.is_empty() {
        return Some("Cargo.lock is missing, or has no package of the registry".to_owned());
    }
    let is_fixed = |one: &&str| one.contains("\nsource = \"registry+") && one.contains("\nchecksum = \"");
    let loose = packages.into_iter().find(|one| !is_fixed(one))?;
    Some(format!("a package without a digest, or of another source: {}", loose.trim().replace('\n', ", ")))
}

/// The error of a list of requirements: each must have a fixed version and a digest.
fn unhashed(list: &str) -> Option<String> {
    let joined = list.replace("\\\n", " ");
    let mut requirements =
        joined.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')).peekable();
    if requirements.peek().is_none() {
        return Some("there is no list of requirements".to_owned());
    }
    let bad = |line: &&str| !line.contains("==") || !line.contains("--hash=sha256:") || line.contains("://");
    requirements.find(bad).map(|line| format!("`{line}` has no fixed version, no digest or an address"))
}

/// The folders of the engines that come with the project.
fn engines() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join("engines")).expect("the engines");
    let folders = entries.map(|entry| entry.expect("an engine").path());
    folders.filter(|folder| folder.join("engine.toml").is_file()).collect()
}

#[test]
fn engines_are_installed_from_fixed_versions_with_digests() {
    let mut seen = 0;
    for folder in engines() {
        let config = std::fs::read_to_string(folder.join("engine.toml")).expect("a configuration");
        for command in commands(&config) {
            seen += 1;
            assert_eq!(wrong(&folder, &command), None, "{}", folder.display());
        }
    }
    assert!(seen >= 35, "{seen} commands");
}

#[test]
fn what_chores_install_is_locked() {
    let list = std::fs::read_to_string(root().join(crate::data::REQUIREMENTS)).expect("a list");
    assert_eq!(unhashed(&list), None);
    let lock = std::fs::read_to_string(root().join("crates/xtask/browser/package-lock.json")).expect("a lock file");
    assert_eq!(unlocked(&lock), None);
}

#[test]
fn a_loose_recipe_is_seen() {
    let folder = root().join("engines/robust-predicates");
    let said = |install: &str| {
        let commands = commands(&format!("name = \"a\"\ninstall = [{install}]\n"));
        commands.iter().find_map(|command| wrong(&folder, command)).unwrap_or_default()
    };
    assert_eq!(said(r#"["npm", "ci", "--ignore-scripts"]"#), "");
    for (install, why) in [
        (r#"["npm", "ci"]"#, "use `npm ci --ignore-scripts`"),
        (r#"["npm", "install", "--ignore-scripts", "a@1.0.0"]"#, "use `npm ci --ignore-scripts`"),
        (r#"["apt-get", "install", "-y", "g++=1", "libgeos-dev"]"#, "fix the version of libgeos-dev"),
        (r#"["python3", "-m", "venv", "venv"], ["venv/bin/pip", "install", "a==1"]"#, "use `--require-hashes"),
        (
            r#"["python3", "-m", "pip", "install", "--require-hashes", "--only-binary=:all:", "-r", "none.txt"]"#,
            "there is no list",
        ),
        (r#"["brew", "install", "geos"]"#, "a client that this test does not know"),
        (r#"["cargo", "fetch"]"#, "use `--locked`"),
        (r#"["cargo", "fetch", "--locked"]"#, "Cargo.lock is missing"),
    ] {
        assert!(said(install).contains(why), "{install}: {}", said(install));
    }
    let built = commands("install = [[\"npm\", \"ci\"]]\nbuild   = [[\"c++\", \"a\"], [\"cargo\", \"build\"]]\n");
    assert_eq!(built, [["npm", "ci"], ["cargo", "build"]]);
    let lock = |source: &str| format!("[[package]]\nname = \"a\"\nversion = \"1\"\n{source}\n");
    assert_eq!(unsummed(&lock("source = \"registry+r\"\nchecksum = \"0\"")), None);
    for loose in ["source = \"registry+r\"", "source = \"git+g\"\nchecksum = \"0\"", ""] {
        assert!(unsummed(&lock(loose)).is_some(), "{loose}");
    }
    assert!(unlocked("{\n    \"node_modules/a\": {\n \"version\": \"1\"").is_some());
    assert!(unhashed("a==1 \\\n    --hash=sha256:00\nb==2\n").is_some_and(|why| why.starts_with("`b==2`")));
    assert!(unhashed("a>=1 --hash=sha256:00\n").is_some() && unhashed("a==1 \\\n    --hash=sha256:00\n").is_none());
}
