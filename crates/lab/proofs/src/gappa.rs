//! Gappa and Coq as programs: a script goes in, a verdict comes out.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// The digits that Gappa computes with: more than the terms of third order in u need.
const PRECISION: &str = "-Eprecision=400";

/// A number that Gappa has printed or reads: a whole number, or one times a power of two, as in `3b-53`.
pub type Number = String;

/// Gappa, and the scripts that it has accepted.
#[derive(Default)]
pub struct Gappa {
    /// Each accepted script, with the upper ends of the intervals that it asked for.
    accepted: RefCell<BTreeMap<String, Vec<Number>>>,
}

/// Returns true if a program can be started here.
#[must_use]
pub fn is_here(program: &str) -> bool {
    Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok()
}

impl Gappa {
    /// The upper ends of the intervals that the script asks for with `in ?`, by the expressions as Gappa prints them.
    ///
    /// (Gappa does not keep their order.)
    ///
    /// # Errors
    /// A message with the script if Gappa does not prove it, or bounds other expressions.
    pub fn ask(&self, script: &str, of: &[&str]) -> Result<Vec<Number>, String> {
        if let Some(known) = self.accepted.borrow().get(script) {
            return Ok(known.clone());
        }
        let (is_proved, output) = run("gappa", &[PRECISION, "-Wno-unbound-variable"], script)?;
        if !is_proved {
            return Err(format!("gappa does not prove\n{script}{output}"));
        }
        let results: Vec<(&str, Number)> = output.lines().filter_map(result).collect();
        let find = |wanted: &&str| {
            let found = results.iter().find(|(expression, _)| expression == wanted);
            found.map(|(_, end)| end.clone()).ok_or_else(|| format!("no bound of {wanted} in\n{script}{output}"))
        };
        let found = of.iter().map(find).collect::<Result<Vec<_>, _>>()?;
        self.accepted.borrow_mut().insert(script.to_owned(), found.clone());
        Ok(found)
    }

    /// The upper end of the one interval that the script asks for.
    ///
    /// # Errors
    /// See [`Gappa::ask`].
    pub fn bound(&self, script: &str) -> Result<Number, String> {
        if let Some(known) = self.accepted.borrow().get(script) {
            return Ok(known[0].clone());
        }
        let (is_proved, output) = run("gappa", &[PRECISION, "-Wno-unbound-variable"], script)?;
        let mut results = output.lines().filter_map(result);
        match (results.next(), results.next()) {
            (Some((_, end)), None) if is_proved => {
                self.accepted.borrow_mut().insert(script.to_owned(), vec![end.clone()]);
                Ok(end)
            }
            _ => Err(format!("gappa does not find one bound in\n{script}{output}")),
        }
    }

    /// Returns true if Gappa proves the script.
    #[must_use]
    pub fn proves(&self, script: &str) -> bool {
        self.ask(script, &[]).is_ok()
    }

    /// The scripts that have been accepted, in alphabetical order.
    #[must_use]
    pub fn scripts(&self) -> Vec<String> {
        self.accepted.borrow().keys().cloned().collect()
    }
}

/// The expression and the upper end of a line such as `x in [-1b-53 {-1.1e-16, -2^(-53)}, 1b-53 {1.1e-16, 2^(-53)}]`.
fn result(line: &str) -> Option<(&str, Number)> {
    let (expression, interval) = line.split_once(" in [")?;
    // The ends are numbers with approximations in braces; an interval of one number has one end.
    let ends = interval.split('}').filter_map(|part| part.split('{').next());
    let words: Vec<&str> = ends.map(|part| part.trim_start_matches([',', ' ']).trim()).filter(|w| *w != "]").collect();
    let last = words.iter().rev().find(|word| !word.is_empty())?;
    // Whole numbers have no braces.
    let last = last.trim_end_matches(']').rsplit(", ").next()?;
    Some((expression.trim(), last.to_owned()))
}

/// The proofs that Gappa writes of scripts, as one file for Coq with the library Flocq.
///
/// Gappa assumes the equations of its hints. Here Coq proves them, and nothing else may be assumed.
///
/// # Errors
/// The script that Gappa does not prove, or whose proof assumes something.
pub fn for_coq(scripts: &[String]) -> Result<String, String> {
    let mut file = "Require Import Reals Gappa.Gappa_library.\n".to_owned();
    for (index, script) in scripts.iter().enumerate() {
        let (is_proved, proof) = run("gappa", &[PRECISION, "-Wno-unbound-variable", "-Bcoq"], script)?;
        file += &format!("Module proof_{index}.\n");
        for line in proof.lines().filter(|line| !line.starts_with("Require")) {
            match line.strip_prefix("Hypothesis ") {
                Some(equation) => file += &format!("Lemma {equation} Proof. unfold Float1; field. Qed.\n"),
                None => file += &format!("{line}\n"),
            }
        }
        if !is_proved || !proof.contains("Qed.") || file.contains("Hypothesis") {
            return Err(format!("gappa writes no whole proof for Coq of\n{script}"));
        }
        file += &format!("End proof_{index}.\n");
    }
    Ok(file)
}

/// Has Coq check a file, and returns what it prints.
///
/// # Errors
/// A message with Coq's words, or if the file admits something.
pub fn by_coq(proof: &str, folder: &Path, name: &str) -> Result<String, String> {
    let file = folder.join(format!("{name}.v"));
    if ["Admitted", "admit", "Axiom"].iter().any(|word| proof.contains(word)) {
        return Err(format!("{} is not a whole proof", file.display()));
    }
    std::fs::write(&file, proof).map_err(|error| format!("{}: {error}", file.display()))?;
    let coqc = Command::new("coqc").args(["-q", &format!("{name}.v")]).current_dir(folder).output();
    let output = coqc.map_err(|error| format!("coqc: {error}"))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    Err(format!("coqc refuses {}: {}", file.display(), String::from_utf8_lossy(&output.stderr)))
}

fn run(program: &str, arguments: &[&str], input: &str) -> Result<(bool, String), String> {
    let piped = Command::new(program)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let mut child = piped.map_err(|error| format!("{program}: {error}"))?;
    let mut stdin = child.stdin.take().expect("piped");
    // (A program that ends before it has read all says why.)
    let _ = stdin.write_all(input.as_bytes());
    drop(stdin);
    let output = child.wait_with_output().map_err(|error| format!("{program}: {error}"))?;
    // Gappa prints results on stderr when it writes a proof, else on stdout.
    let is_proof = arguments.contains(&"-Bcoq");
    let mut text = String::from_utf8_lossy(&output.stdout).into_owned();
    if !is_proof {
        text.push_str(&String::from_utf8_lossy(&output.stderr));
    }
    Ok((output.status.success(), text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn upper_ends_are_read() {
        let of = |line| result(line).map(|(expression, end)| format!("{expression}: {end}"));
        let line = "  x in [-1b-53 {-1.1e-16, -2^(-53)}, 3b-53 {3.3e-16, 2^(-51.4)}]";
        assert_eq!(of(line).as_deref(), Some("x: 3b-53"));
        let line = "  |s| in [0, 9007199254740993b-53 {1, 2^(0)}]";
        assert_eq!(of(line).as_deref(), Some("|s|: 9007199254740993b-53"));
        assert_eq!(of("  s - S in [0, 2]").as_deref(), Some("s - S: 2"));
        assert_eq!(result("Results:"), None);
    }
}
