//! The report in a real browser: Chromium, if installed, opens, searches, prints and compares it.

use std::path::Path;

use crate::command::{answers, fresh, root, step, target_directory};

/// The folder of the browser's work.
const FOLDER: &str = "target/browser";
/// The number of findings of two more pages.
const FEW: usize = 1_000;
const MANY: usize = 100_000;
/// The hand-written run folders.
const SMALL: [&str; 2] = ["crates/instrument/tasks/tests/data/checked", "crates/instrument/tasks/tests/data/timed"];
/// Debian's path of Chromium.
const CHROMIUM: &str = "/usr/bin/chromium";

/// Makes a page of the embedded corpora and one of very many findings, and tests both in a browser.
///
/// Without a browser it reports what is missing, which is an error only if `is_needed`. It compares a small page with
/// reviewed pictures; `accept` replaces these pictures.
pub fn check(is_needed: bool, accept: bool) -> Result<(), String> {
    let missing: Vec<&str> = [("node", "node"), ("npm", "npm"), (CHROMIUM, "chromium (Debian's package)")]
        .into_iter()
        .filter_map(|(program, name)| (!answers(program, &["--version"])).then_some(name))
        .collect();
    if !missing.is_empty() {
        let message = format!("the report in a browser: NOT RUN: there is no {}", missing.join(", no "));
        if is_needed {
            return Err(message);
        }
        println!("\n== {message}");
        return Ok(());
    }
    let folder = root().join(fresh(FOLDER)?);
    let own = root().join("crates/xtask/browser");
    for entry in std::fs::read_dir(&own).map_err(|error| format!("{}: {error}", own.display()))? {
        let path = entry.map_err(|error| format!("{}: {error}", own.display()))?.path();
        if let Some(file) = path.file_name().filter(|_| path.is_file()) {
            std::fs::copy(&path, folder.join(file)).map_err(|error| format!("{}: {error}", path.display()))?;
        }
    }
    let words = |words: &[&str]| words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>();
    let at = folder.display().to_string();
    step(
        "fetch what drives the browser",
        &words(&["npm", "ci", "--ignore-scripts", "--silent", "--prefix", &at]),
        &[],
    )?;
    let build = ["cargo", "build", "--profile", "ci", "--bin", "predicament"];
    step("build the tool", &words(&build), &[])?;
    let tool = target_directory()?.join("ci").join("predicament").display().to_string();
    let path = |name: &str| folder.join(name).display().to_string();
    let (run, few, many) = (path("run"), path("few"), path("many"));
    step("run the embedded corpora", &words(&[&tool, "run", "--out", &run]), &[])?;
    multiplied(Path::new(&run), Path::new(&few), FEW)?;
    multiplied(Path::new(&run), Path::new(&many), MANY)?;
    // Plots that answer to the pointer come from a study.
    let stress = ["study", "stress", "-q", "-t", "orient2d", "--knob", "scale", "--scenes", "1", "--out"];
    step("turn a knob", &words(&[&[&tool[..]], &stress[..], &[&format!("{run}/stress")]].concat()), &[])?;
    let script = path("check.mjs");
    // A page of hand-written run folders looks the same everywhere.
    let (out, shots) = (path("small"), path("small-screenshots"));
    step("write a small page", &words(&[&[&tool, "report"][..], &SMALL, &["--out", &out]].concat()), &[])?;
    let small = format!("{out}/report.html");
    let references = own.join("references").display().to_string();
    let compared = ["node", &script, &small, &shots, "--references", &references];
    let accepted = if accept { &["--accept"][..] } else { &[] };
    step("compare it with references", &words(&[&compared[..], accepted].concat()), &[])?;
    for (run, name, least) in [(&run, "report", 1), (&few, "few-report", FEW), (&many, "many-report", MANY)] {
        let (out, shots) = (path(name), path(&format!("{name}-screenshots")));
        step(&format!("write {name}"), &words(&[&tool, "report", run, "--out", &out]), &[])?;
        let page = format!("{out}/report.html");
        step(&format!("use {name}"), &words(&["node", &script, &page, &shots, "--least", &least.to_string()]), &[])?;
    }
    let page = format!("{}/report.html", path("report"));
    let planted = ["node", &path("faults.mjs"), &page, &path("faults"), &references, &small];
    step("plant faults", &words(&planted), &[])
}

/// Writes a run folder that repeats the same findings up to `count`, each with a separate id.
fn multiplied(run: &Path, many: &Path, count: usize) -> Result<(), String> {
    let failed = |path: &Path| {
        let path = path.display().to_string();
        move |error: std::io::Error| format!("{path}: {error}")
    };
    std::fs::create_dir_all(many).map_err(failed(many))?;
    for entry in std::fs::read_dir(run).map_err(failed(run))? {
        let path = entry.map_err(failed(run))?.path();
        if let Some(name) = path.file_name().filter(|_| path.is_file()) {
            std::fs::copy(&path, many.join(name)).map_err(failed(&path))?;
        }
    }
    // A run's digests cover its pictures, too.
    let (maps, copies) = (run.join("maps"), many.join("maps"));
    std::fs::create_dir_all(&copies).map_err(failed(&copies))?;
    for entry in std::fs::read_dir(&maps).map_err(failed(&maps))? {
        let path = entry.map_err(failed(&maps))?.path();
        if let Some(name) = path.file_name() {
            std::fs::copy(&path, copies.join(name)).map_err(failed(&path))?;
        }
    }
    let file = many.join("findings.csv");
    let text = std::fs::read_to_string(&file).map_err(failed(&file))?;
    let (head, rows) = text.split_once('\n').ok_or("findings.csv is empty")?;
    // Rows in one line each that begin with their id.
    let rows: Vec<&str> = rows.lines().filter(|row| row.split_once(',').is_some_and(|(id, _)| is_id(id))).collect();
    if rows.is_empty() {
        return Err("findings.csv has no findings".to_owned());
    }
    let mut all = format!("{head}\n");
    for (number, row) in rows.iter().cycle().take(count).enumerate() {
        let (_, rest) = row.split_once(',').ok_or("a row has an id")?;
        all += &format!("{number:012x},{rest}\n");
    }
    std::fs::write(&file, &all).map_err(failed(&file))?;
    // A run folder stores the sizes and digests of its files.
    let output = std::process::Command::new("sha256sum").arg(&file).output().map_err(failed(&file))?;
    let digest = String::from_utf8_lossy(&output.stdout).chars().take(64).collect::<String>();
    let state = many.join("state.json");
    let text = std::fs::read_to_string(&state).map_err(failed(&state))?;
    let text: String =
        text.lines().filter(|line| !line.starts_with("  \"seal\"")).map(|line| format!("{line}\n")).collect();
    let text = replaced(&text, &[all.len().to_string(), format!("\"{digest}\"")]);
    std::fs::write(&state, text).map_err(failed(&state))
}

/// A state with other values of `findings.csv`, in order.
fn replaced(state: &str, values: &[String]) -> String {
    const KEY: &str = "\"findings.csv\": ";
    let mut parts = state.split(KEY);
    let mut text = parts.next().unwrap_or_default().to_owned();
    for (part, value) in parts.zip(values) {
        let end = part.find([',', '\n']).unwrap_or(0);
        text += &format!("{KEY}{value}{}", &part[end..]);
    }
    text
}

fn is_id(text: &str) -> bool {
    text.len() == 12 && text.chars().all(|c| c.is_ascii_hexdigit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_gets_other_values() {
        let state = "{\n  \"findings.csv\": 12,\n  \"z.csv\": 3\n }, {\n  \"findings.csv\": \"ab\"\n}";
        let wanted = "{\n  \"findings.csv\": 34,\n  \"z.csv\": 3\n }, {\n  \"findings.csv\": \"cd\"\n}";
        assert_eq!(replaced(state, &["34".to_owned(), "\"cd\"".to_owned()]), wanted);
    }
}
