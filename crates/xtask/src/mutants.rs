//! The mutation score: small changes to the code that decides the truth, each of which a test must detect.
//!
//! Planted faults show that checks detect known kinds of faults; cargo-mutants makes thousands of others. All of them
//! take days, so the command takes a sample: every n-th in the order of the code, beginning at another one if `--from`
//! says so.
//!
//! A crate's own tests are the quick ones. With `--all-tests`, mutants that they miss run again with the tests of the
//! crates above, which compare backends, judges and checks with each other.
//!
//! `--planted` tries the known faults, in algorithms ([`planted`]). `--score` tries a sample of changes of algorithms
//! by the quick run and the gate alone: one build has them all (`tools/switches`).

mod planted;

use std::collections::BTreeSet;
use std::path::Path;

use crate::command::{answers, cargo_command, fresh, root, step, step_ending};

/// The packages whose errors would be taken for truth.
const PACKAGES: [&str; 6] = ["arithmetic", "exact", "sos", "tolerance", "laws", "judge"];
/// The folder of the results.
const FOLDER: &str = "target/mutants";
/// The folder of the builds.
const BUILT: &str = "target/mutants-build";
/// The packages whose tests run after those of a mutant's own package: all systems, and these.
const ABOVE: [&str; 4] = ["tasks", "oracle", "studies", "search"];
/// The time limit for the tests of these packages together, in seconds.
///
/// By default cargo-mutants would allow them only the time of a mutant's own tests.
const SECONDS_ABOVE: &str = "1800";
/// The exit codes of cargo-mutants with missed or timed-out mutants, which are counted and are not errors.
const FINE: [i32; 3] = [0, 2, 3];

/// The folder of the results of `--score`.
const SWITCHES: &str = "target/switches";

/// Tries a sample of changes of the algorithms by the quick run and the gate.
fn by_runs(args: &[String]) -> Result<(), String> {
    let tree = planted::copied()?.display().to_string();
    let [built, out] = [BUILT, SWITCHES].map(|folder| root().join(folder).display().to_string());
    let tool = ["run", "--quiet", "--manifest-path", "tools/switches/Cargo.toml", "--", &tree, &built, &out];
    let words: Vec<&str> = tool.into_iter().chain(args.iter().map(String::as_str)).collect();
    step("changes of algorithms by the quick run", &cargo_command(&words), &[])
}

/// The packages of the systems: the folders of their group.
fn systems() -> Result<Vec<String>, String> {
    let group = root().join("crates/systems");
    let entries = std::fs::read_dir(&group).map_err(|why| format!("{}: {why}", group.display()))?;
    let folders = entries.flatten().filter(|entry| entry.path().join("Cargo.toml").is_file());
    let mut names: Vec<String> = folders.filter_map(|entry| entry.file_name().into_string().ok()).collect();
    names.sort();
    Ok(names)
}

/// The results of one package's mutants.
#[derive(Default)]
struct Score {
    caught: Vec<String>,
    /// The mutants that only tests of crates above detect.
    above: Vec<String>,
    missed: Vec<String>,
    timeout: Vec<String>,
    unviable: usize,
}

impl Score {
    /// Reads the output folder of cargo-mutants.
    fn read(folder: &Path) -> Result<Score, String> {
        let lines = |name: &str| -> Result<Vec<String>, String> {
            let path = folder.join("mutants.out").join(name);
            let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            Ok(text.lines().map(str::to_owned).collect())
        };
        let unviable = lines("unviable.txt")?.len();
        Ok(Score {
            caught: lines("caught.txt")?,
            above: Vec::new(),
            missed: lines("missed.txt")?,
            timeout: lines("timeout.txt")?,
            unviable,
        })
    }

    /// Adds the results of a second run with the missed mutants.
    ///
    /// (cargo-mutants always tries mutants that delete a field of a file, even if not selected: they are ignored here.)
    ///
    /// # Errors
    /// If a missed mutant was not tried again.
    fn tried_again(&mut self, again: &Score) -> Result<(), String> {
        let missed = std::mem::take(&mut self.missed);
        for mutant in missed {
            let all = [
                (&again.caught, &mut self.above),
                (&again.timeout, &mut self.timeout),
                (&again.missed, &mut self.missed),
            ];
            match all.into_iter().find(|(of, _)| of.contains(&mutant)) {
                Some((_, of)) => of.push(mutant),
                None => return Err(format!("mutants: cargo-mutants did not try this one again: {mutant}")),
            }
        }
        Ok(())
    }

    fn add(&mut self, other: &Score) {
        self.caught.extend(other.caught.iter().cloned());
        self.above.extend(other.above.iter().cloned());
        self.missed.extend(other.missed.iter().cloned());
        self.timeout.extend(other.timeout.iter().cloned());
        self.unviable += other.unviable;
    }

    /// The row of a package in the table; a mutant that never ends counts as detected, since no test passes.
    fn row(&self, name: &str) -> String {
        let noticed = self.caught.len() + self.above.len() + self.timeout.len();
        let all = noticed + self.missed.len();
        let [low, high] = wilson(noticed, all);
        let share = 100.0 * ratio(noticed, all);
        format!(
            "| {name} | {all} | {} | {} | {} | {} | {} | {share:.1} % ({:.1} to {:.1}) |",
            self.caught.len(),
            self.above.len(),
            self.timeout.len(),
            self.missed.len(),
            self.unviable,
            100.0 * low,
            100.0 * high
        )
    }
}

/// The command's arguments.
struct Asked {
    every: u32,
    from: u32,
    all_tests: bool,
    packages: Vec<String>,
}

impl Asked {
    fn parse(args: &[String]) -> Result<Asked, String> {
        let mut asked = Asked { every: 50, from: 0, all_tests: false, packages: Vec::new() };
        let mut words = args.iter();
        while let Some(word) = words.next() {
            let mut number = |name: &str| {
                let value = words.next().and_then(|value| value.parse().ok());
                value.ok_or_else(|| format!("mutants: write a number after {name}"))
            };
            match word.as_str() {
                "--every" => asked.every = number("--every")?,
                "--from" => asked.from = number("--from")?,
                "--all-tests" => asked.all_tests = true,
                package if PACKAGES.contains(&package) => asked.packages.push(package.to_owned()),
                other => {
                    return Err(format!("mutants: `{other}` is no package of {} and no option", PACKAGES.join(", ")));
                }
            }
        }
        let Asked { every, from, .. } = asked;
        if every == 0 || from >= every {
            return Err(format!("mutants: --from {from} of --every {every}; choose from 0 to one less"));
        }
        if asked.packages.is_empty() {
            asked.packages = PACKAGES.map(str::to_owned).into();
        }
        Ok(asked)
    }
}

/// Tries every n-th mutant of the packages, from the k-th on, and prints the score and the survivors.
///
/// The option `--planted` tries the known faults instead, and `--score` the algorithms by runs.
pub fn score(args: &[String]) -> Result<(), String> {
    if let [first, options @ ..] = args
        && first == "--score"
    {
        return by_runs(options);
    }
    if let [first, names @ ..] = args
        && first == "--planted"
    {
        return planted::try_all(names);
    }
    let asked = Asked::parse(args)?;
    if !answers("cargo", &["mutants", "--version"]) {
        return Err("mutants: there is no cargo-mutants; `cargo install cargo-mutants --locked` installs it".to_owned());
    }
    let folder = root().join(fresh(FOLDER)?);
    let (mut total, mut rows) = (Score::default(), Vec::new());
    for package in &asked.packages {
        let shard = format!("{}/{}", asked.from, asked.every);
        let which = ["--shard", &shard, "--sharding", "round-robin"].map(str::to_owned);
        let what = format!("mutants of {package}, {shard}");
        let mut score = run(&what, package, &which, &folder.join(package))?;
        if asked.all_tests && !score.missed.is_empty() {
            let mut which: Vec<String> =
                score.missed.iter().flat_map(|name| ["--re".to_owned(), whole(name)]).collect();
            which.extend(files(&score.missed).into_iter().flat_map(|file| ["--file".to_owned(), file]));
            let systems = systems()?;
            let above = systems.iter().map(String::as_str).chain(ABOVE);
            let tests = above.filter(|&above| above != package.as_str());
            which.extend(tests.flat_map(|above| ["--test-package".to_owned(), format!("predicament-{above}")]));
            let what = format!("mutants of {package}, by the tests of crates above");
            which.extend(["--timeout", SECONDS_ABOVE].map(str::to_owned));
            score.tried_again(&run(&what, package, &which, &folder.join(format!("{package}-above")))?)?;
        }
        rows.push(score.row(package));
        total.add(&score);
    }
    println!(
        "\n| package | mutants | caught | by crates above | never end | missed | do not compile | noticed, with Wilson's \
         interval at 95 % |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|---|");
    rows.iter().for_each(|row| println!("{row}"));
    println!("{}", total.row("all"));
    println!("\nMissed:");
    total.missed.iter().for_each(|mutant| println!("* {mutant}"));
    Ok(())
}

/// Runs cargo-mutants on some mutants of a package, and reads its output folder.
fn run(what: &str, package: &str, which: &[String], out: &Path) -> Result<Score, String> {
    std::fs::create_dir_all(out).map_err(|error| format!("{}: {error}", out.display()))?;
    let mut args: Vec<String> = ["mutants", "--package", &format!("predicament-{package}")].map(str::to_owned).into();
    args.extend_from_slice(which);
    let always = [
        "--profile",
        "mutants",
        "--test-tool",
        "nextest",
        "--no-shuffle",
        "--minimum-test-timeout",
        "60",
        "--output",
        &out.display().to_string(),
        "--colors",
        "never",
    ];
    args.extend(always.map(str::to_owned));
    // A run has one copy of the tree, in which one function changes at a time: the profile compiles little more than
    // that. The next run has another copy, and keeps the compiled dependencies.
    let built = root().join(BUILT).display().to_string();
    step_ending(what, &cargo_command(&args), &[("CARGO_TARGET_DIR", built)], &FINE)?;
    Score::read(out)
}

/// The files of some mutants, each once.
fn files(mutants: &[String]) -> BTreeSet<String> {
    mutants.iter().filter_map(|name| name.split_once(':')).map(|(file, _)| file.to_owned()).collect()
}

/// A regular expression that matches the name of one mutant.
fn whole(name: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || " _/:,'<>&;=\"".contains(c) || !c.is_ascii();
    let escaped: String = name.chars().map(|c| if plain(c) { c.to_string() } else { format!("\\{c}") }).collect();
    format!("^{escaped}$")
}

fn ratio(part: usize, of: usize) -> f64 {
    let exact = |n: usize| f64::from(u32::try_from(n).unwrap_or(u32::MAX));
    if of == 0 { 0.0 } else { exact(part) / exact(of) }
}

/// Wilson's interval at 95 %, as shares.
fn wilson(part: usize, of: usize) -> [f64; 2] {
    if of == 0 {
        return [0.0, 1.0];
    }
    let (p, z) = (ratio(part, of), 1.96);
    let n = f64::from(u32::try_from(of).unwrap_or(u32::MAX));
    let middle = p + z * z / (2.0 * n);
    let width = z * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt();
    [-1.0, 1.0].map(|side| ((middle + side * width) / (1.0 + z * z / n)).clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_score_is_read_and_told() {
        let folder = std::env::temp_dir().join(format!("xtask-mutants-{}", std::process::id()));
        let out = folder.join("mutants.out");
        std::fs::create_dir_all(&out).unwrap();
        for (name, text) in
            [("caught.txt", "a\nb\nc\n"), ("missed.txt", "d\n"), ("timeout.txt", ""), ("unviable.txt", "e\n")]
        {
            std::fs::write(out.join(name), text).unwrap();
        }
        let score = Score::read(&folder);
        std::fs::remove_file(out.join("missed.txt")).unwrap();
        let none = Score::read(&folder);
        std::fs::remove_dir_all(&folder).unwrap();
        let mut score = score.unwrap();
        assert_eq!(score.row("x"), "| x | 4 | 3 | 0 | 0 | 1 | 1 | 75.0 % (30.1 to 95.4) |");
        let mut lost = Score { missed: vec!["d".to_owned()], ..Score::default() };
        assert!(lost.tried_again(&Score::default()).unwrap_err().ends_with("again: d"));
        // One that was not selected is in no column.
        let again =
            Score { caught: vec!["d".to_owned(), "f".to_owned()], missed: vec!["g".to_owned()], ..Score::default() };
        score.tried_again(&again).unwrap();
        assert_eq!(score.row("x"), "| x | 4 | 3 | 1 | 0 | 0 | 1 | 100.0 % (51.0 to 100.0) |");
        assert!(none.is_err_and(|why| why.contains("missed.txt")));
        assert_eq!(
            whole(
                "crates/a/src/b.rs:1:2: replace <impl X for Y<'_>>::f -> Option<[u8; 2]> with Some([0; 2]) * (1 + 2)"
            ),
            r"^crates/a/src/b\.rs:1:2: replace <impl X for Y<'_>>::f \-> Option<\[u8; 2\]> with Some\(\[0; 2\]\) \* \(1 \+ 2\)$"
        );
        let two =
            ["crates/a/src/b.rs:1:2: replace + with -", "crates/a/src/b.rs:3:4: replace < with <="].map(str::to_owned);
        assert_eq!(files(&two), ["crates/a/src/b.rs".to_owned()].into());
        assert!(score_of(&["nothing"]).unwrap_err().contains("no package"));
        assert!(score_of(&["--every", "x"]).unwrap_err().contains("a number"));
        assert!(score_of(&["--every", "3", "--from", "3"]).unwrap_err().contains("choose from 0"));
    }

    fn score_of(words: &[&str]) -> Result<(), String> {
        super::score(&words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>())
    }
}
