//! The mutation score: small changes to the code that decides what is true, each of which a test has to notice.
//!
//! Planted faults show that checks see the faults somebody thought of; cargo-mutants makes thousands nobody did. All of them take days, so
//! a sample is taken: every n-th in the order of the code, begun at another one each time if `--from` says so.

use std::path::Path;

use crate::steps::{answers, cargo_command, fresh, root, step_ending};

/// The packages whose mistakes would be taken for truth.
const PACKAGES: [&str; 6] = ["arithmetic", "exact", "sos", "tolerance", "checks", "judge"];
/// Where the results are.
const FOLDER: &str = "target/mutants";
/// What cargo-mutants ends with where mutants were missed, or ran out of time: that is what is counted.
const FINE: [i32; 3] = [0, 2, 3];

/// What became of the mutants of one package.
#[derive(Default)]
struct Score {
    caught: Vec<String>,
    missed: Vec<String>,
    timeout: Vec<String>,
    unviable: usize,
}

impl Score {
    /// Reads the folder that cargo-mutants leaves.
    fn read(folder: &Path) -> Result<Score, String> {
        let lines = |name: &str| -> Result<Vec<String>, String> {
            let path = folder.join("mutants.out").join(name);
            let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            Ok(text.lines().map(str::to_owned).collect())
        };
        let unviable = lines("unviable.txt")?.len();
        Ok(Score {
            caught: lines("caught.txt")?,
            missed: lines("missed.txt")?,
            timeout: lines("timeout.txt")?,
            unviable,
        })
    }

    fn add(&mut self, other: &Score) {
        self.caught.extend(other.caught.iter().cloned());
        self.missed.extend(other.missed.iter().cloned());
        self.timeout.extend(other.timeout.iter().cloned());
        self.unviable += other.unviable;
    }

    /// A mutant that never ends is noticed: no test passes.
    fn row(&self, name: &str) -> String {
        let (noticed, all) =
            (self.caught.len() + self.timeout.len(), self.caught.len() + self.timeout.len() + self.missed.len());
        let [low, high] = wilson(noticed, all);
        let share = 100.0 * ratio(noticed, all);
        format!(
            "| {name} | {all} | {} | {} | {} | {} | {share:.1} % ({:.1} to {:.1}) |",
            self.caught.len(),
            self.timeout.len(),
            self.missed.len(),
            self.unviable,
            100.0 * low,
            100.0 * high
        )
    }
}

/// Tries every n-th mutant of the packages, from the k-th on, and prints the score and the survivors.
pub fn score(args: &[String]) -> Result<(), String> {
    let (mut every, mut from, mut packages) = (50_u32, 0_u32, Vec::new());
    let mut words = args.iter();
    while let Some(word) = words.next() {
        let mut number = |name: &str| {
            let value = words.next().and_then(|value| value.parse().ok());
            value.ok_or_else(|| format!("mutants: write a number after {name}"))
        };
        match word.as_str() {
            "--every" => every = number("--every")?,
            "--from" => from = number("--from")?,
            package if PACKAGES.contains(&package) => packages.push(package.to_owned()),
            other => return Err(format!("mutants: `{other}` is no package of {} and no option", PACKAGES.join(", "))),
        }
    }
    if every == 0 || from >= every {
        return Err(format!("mutants: --from {from} of --every {every}; choose from 0 to one less"));
    }
    if !answers("cargo", &["mutants", "--version"]) {
        return Err("mutants: there is no cargo-mutants; `cargo install cargo-mutants --locked` installs it".to_owned());
    }
    if packages.is_empty() {
        packages = PACKAGES.map(str::to_owned).into();
    }
    let folder = root().join(fresh(FOLDER)?);
    let (mut total, mut rows) = (Score::default(), Vec::new());
    for package in &packages {
        let out = folder.join(package);
        std::fs::create_dir_all(&out).map_err(|error| format!("{}: {error}", out.display()))?;
        let (name, shard) = (format!("predicament-{package}"), format!("{from}/{every}"));
        let out_text = out.display().to_string();
        let args = [
            "mutants",
            "--package",
            &name,
            "--shard",
            &shard,
            "--sharding",
            "round-robin",
            "--profile",
            "ci",
            "--test-tool",
            "nextest",
            "--no-shuffle",
            "--minimum-test-timeout",
            "120",
            "--output",
            &out_text,
            "--colors",
            "never",
        ];
        step_ending(&format!("mutants of {package}, {shard}"), &cargo_command(&args), &[], &FINE)?;
        let score = Score::read(&out)?;
        rows.push(score.row(package));
        total.add(&score);
    }
    println!(
        "\n| package | mutants | caught | never end | missed | do not compile | noticed, with Wilson's interval at 95 % |"
    );
    println!("|---|---:|---:|---:|---:|---:|---|");
    rows.iter().for_each(|row| println!("{row}"));
    println!("{}", total.row("all"));
    println!("\nMissed:");
    total.missed.iter().for_each(|mutant| println!("* {mutant}"));
    Ok(())
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
        assert_eq!(score.unwrap().row("x"), "| x | 4 | 3 | 0 | 1 | 1 | 75.0 % (30.1 to 95.4) |");
        assert!(none.is_err_and(|why| why.contains("missed.txt")));
        assert!(score_of(&["nothing"]).unwrap_err().contains("no package"));
        assert!(score_of(&["--every", "x"]).unwrap_err().contains("a number"));
        assert!(score_of(&["--every", "3", "--from", "3"]).unwrap_err().contains("choose from 0"));
    }

    fn score_of(words: &[&str]) -> Result<(), String> {
        super::score(&words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>())
    }
}
