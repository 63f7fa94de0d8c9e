//! The recipes of docs/CI.md with the files of `ci/`: jobs with a token run no foreign code, and installed versions are
//! fixed.

use std::process::{Command, Stdio};

use crate::command::{answers, root};

/// A Python program that reads YAML from stdin and checks that it is a table of jobs, or an action.
const PARSE: &str = "import sys, yaml\nof = yaml.safe_load(sys.stdin)\n\
                     jobs = {'action': of['runs']} if 'runs' in of else of.get('jobs', of)\n\
                     assert jobs and all('steps' in job or 'script' in job for job in jobs.values()), 'a job without steps'";

/// Parses each recipe with Python's yaml, or reports that it is missing.
///
/// # Errors
/// If a recipe is not YAML, or is neither a table of jobs nor an action.
pub fn check() -> Result<(), String> {
    println!("\n== recipes of docs/CI.md");
    if !answers("python3", &["-c", "import yaml"]) {
        println!("== recipes of docs/CI.md: NOT RUN: there is no python3 with yaml here; type `pip install pyyaml`");
        return Ok(());
    }
    let page = page()?;
    let recipes = blocks(&page, "yaml");
    for recipe in &recipes {
        parse(recipe)?;
    }
    println!("== recipes of docs/CI.md: ok, {} parsed", recipes.len());
    Ok(())
}

fn parse(recipe: &str) -> Result<(), String> {
    use std::io::Write as _;

    let failed = |error: std::io::Error| format!("python3 did not read a recipe: {error}");
    let mut python = Command::new("python3").args(["-c", PARSE]).stdin(Stdio::piped()).spawn().map_err(failed)?;
    if let Some(mut stdin) = python.stdin.take() {
        stdin.write_all(recipe.as_bytes()).map_err(failed)?;
    }
    let status = python.wait().map_err(failed)?;
    let first = recipe.lines().next().unwrap_or_default();
    if status.success() { Ok(()) } else { Err(format!("the recipe of docs/CI.md that begins with `{first}` is wrong")) }
}

fn page() -> Result<String, String> {
    let path = root().join("docs/CI.md");
    std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
}

/// The code blocks of a language.
fn blocks<'p>(page: &'p str, language: &str) -> Vec<&'p str> {
    let blocks = page.split("```").skip(1).step_by(2).filter_map(|block| block.split_once('\n'));
    blocks.filter(|(head, _)| *head == language).map(|(_, text)| text).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Files that the page shows, whole.
    const FILES: [&str; 2] = ["ci/github/action.yml", "ci/gitlab.yml"];

    fn file(name: &str) -> String {
        std::fs::read_to_string(root().join(name)).unwrap_or_else(|why| panic!("{name}: {why}"))
    }

    #[test]
    fn the_page_shows_each_file_as_it_is() {
        let page = page().unwrap();
        for name in FILES {
            let file = file(name);
            assert!(file.starts_with(&format!("# {name}: ")), "{name} begins with its name, so that a page names it");
            assert!(is_shown(&page, &file), "docs/CI.md shows another {name}: copy the file into its block");
            assert!(!is_shown(&page, &file.replacen("--locked", "", 1)), "{name}");
        }
    }

    /// True if a file is a block of a page.
    fn is_shown(page: &str, file: &str) -> bool {
        blocks(page, "yaml").contains(&file)
    }

    /// The jobs of a recipe as text: each begins with its name. An action is one job.
    fn jobs(recipe: &str) -> Vec<String> {
        if recipe.contains("using: composite") {
            return vec![recipe.to_owned()];
        }
        let (_, recipe) = recipe.split_at(if recipe.starts_with('#') { recipe.find('\n').unwrap_or(0) + 1 } else { 0 });
        let (head, rest) = recipe.split_once("jobs:\n").unwrap_or(("", recipe));
        let indent = rest.len() - rest.trim_start_matches(' ').len();
        let is_name =
            |line: &str| line.len() > indent && !line[indent..].starts_with(' ') && line.trim_end().ends_with(':');
        let mut jobs: Vec<String> = Vec::new();
        for line in rest.lines() {
            match jobs.last_mut() {
                Some(job) if !is_name(line) => *job += line,
                _ => jobs.push(format!("{head}{line}")),
            }
            jobs.last_mut().expect("a job").push('\n');
        }
        jobs
    }

    /// The words of a job that runs foreign code: the script, the action, or the command of the action.
    const RUNS: [&str; 3] = ["gate.sh", "ci/github", "predicament run"];

    /// The words of an installation with a fixed version: a reviewed commit, a reviewed clone, or a version.
    const FIXED: [&[&str]; 3] =
        [&["--git \"$REPOSITORY\"", "--rev \"$COMMIT\""], &["--path \"$CLONE/"], &["--version \"=$VERSION\""]];

    /// The error of a job, if any.
    fn wrong(job: &str) -> Option<&'static str> {
        let has = |word: &str| job.contains(word);
        let runs_strangers = RUNS.iter().any(|word| has(word)) && !has("branches: [main]");
        let has_token =
            ["GH_TOKEN", "COMMENT_TOKEN", "comments.sh", "secrets.", ": write"].iter().any(|word| has(word));
        let installs = job.lines().filter(|line| line.contains("cargo install"));
        let is_fixed = |line: &str| FIXED.iter().any(|words| words.iter().all(|word| line.contains(word)));
        let is_loose = |line: &str| !line.contains("--locked") || !is_fixed(line);
        let clones = ["git clone --quiet \"$REPOSITORY\" .predicament ", "checkout --quiet \"$COMMIT\""];
        if runs_strangers && has_token {
            Some("it runs code of strangers and has a token")
        } else if has_token
            && (has("cargo") || has("head_ref") || has("head.ref") || has("actions/cache") || has("  cache:"))
        {
            Some("it has a token, and fetches what a stranger may have written")
        } else if runs_strangers && (has("actions/cache@") || has("cache/save") || has("  cache:")) {
            Some("it runs code of strangers and writes a cache")
        } else if has("pull_request_target") {
            Some("it runs with the secrets of the repository")
        } else if has("actions/checkout") && !has("persist-credentials: false") {
            Some("it leaves its token in the checkout")
        } else if installs.into_iter().any(is_loose) {
            Some("it installs what is not fixed")
        } else if has("uses: ./.predicament/") && !clones.iter().all(|word| has(word)) {
            Some("it uses an action of a clone that is not fixed")
        } else {
            None
        }
    }

    #[test]
    fn no_job_runs_strangers_code_beside_a_token_or_a_cache() {
        let page = page().unwrap();
        let jobs: Vec<String> = blocks(&page, "yaml").into_iter().flat_map(jobs).collect();
        assert_eq!(jobs.len(), 7, "{jobs:#?}");
        for job in &jobs {
            assert_eq!(wrong(job), None, "{job}");
        }
        assert_eq!(jobs.iter().filter(|job| RUNS.iter().any(|word| job.contains(word))).count(), 5);
    }

    #[test]
    fn a_dangerous_job_is_seen() {
        let install = "    - cargo install --locked --git \"$REPOSITORY\" --rev \"$COMMIT\" predicament\n";
        let job = |more: &str| format!("gate:\n  script:\n{install}    - sh gate.sh\n{more}");
        assert_eq!(wrong(&job("")), None);
        for more in [
            "  env: { GH_TOKEN: \"${{ github.token }}\" }\n",
            "permissions: { pull-requests: write }\n",
            "  cache: { paths: [.tool] }\n",
            "      - uses: actions/cache@v4\n",
            "    - uses: actions/checkout@v4\n",
            "on: [pull_request_target]\n",
            "    - cargo install predicament --locked\n",
        ] {
            assert!(wrong(&job(more)).is_some(), "{more}");
        }
        let action = file("ci/github/action.yml");
        assert_eq!(wrong(&action), None);
        for (old, new) in [
            ("cache/restore", "cache"),
            ("=$VERSION", "$VERSION"),
            ("--locked --path", "--path"),
            ("CLONE: ", "GH_TOKEN: ${{ github.token }}\n        CLONE: "),
        ] {
            assert!(action.contains(old) && wrong(&action.replacen(old, new, 1)).is_some(), "{new}");
        }
        let uses = "gate:\n    steps:\n      - uses: ./.predicament/ci/github\n";
        assert!(wrong(uses).is_some(), "a clone of no fixed commit");
        assert!(wrong("comment:\n  script:\n    - sh comments.sh\n    - cargo run\n").is_some());
    }

    #[test]
    fn recipes_parse_where_python_can() {
        check().unwrap();
        if answers("python3", &["-c", "import yaml"]) {
            assert!(parse("jobs: { a: { runs-on: b } }").is_err() && parse("a: [").is_err());
        }
    }

    /// The scripts of the steps of the action, in their order.
    fn scripts(action: &str) -> Vec<String> {
        let mut scripts: Vec<String> = Vec::new();
        let mut is_open = false;
        for line in action.lines() {
            if let Some(text) = line.strip_prefix("      run: ") {
                is_open = text == "|";
                scripts.push(if is_open { String::new() } else { text.to_owned() });
            } else if let (true, Some(text), Some(script)) =
                (is_open, line.strip_prefix("        "), scripts.last_mut())
            {
                *script += &format!("{text}\n");
            } else {
                is_open = false;
            }
        }
        scripts
    }

    #[cfg(unix)]
    #[test]
    fn the_action_installs_runs_and_ends_as_the_gate_does() {
        use std::os::unix::fs::PermissionsExt as _;

        let scripts = scripts(&file("ci/github/action.yml"));
        assert_eq!(scripts.len(), 3, "{scripts:#?}");
        let folder = std::env::temp_dir().join(format!("predicament-action-{}", std::process::id()));
        let program = |name: &str, text: &str| {
            let path = folder.join(name);
            std::fs::create_dir_all(path.parent().expect("a folder")).unwrap();
            std::fs::write(&path, format!("#!/bin/sh\necho \"$(basename \"$0\") $*\" >> said\n{text}\n")).unwrap();
            std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
        };
        program("bin/cargo", "");
        let path = format!("{}/bin:/usr/bin:/bin", folder.display());
        // As a runner calls it: by `sh -e`, each step by itself.
        let run = |script: &str, env: &[(&str, &str)]| {
            let mut sh = Command::new("sh");
            sh.args(["-e", "-c", script]).current_dir(&folder).env_clear().envs(env.iter().copied());
            let status = sh.env("PATH", &path).env("HOME", &folder).env("GITHUB_STEP_SUMMARY", "summary").status();
            let said = std::fs::read_to_string(folder.join("said")).unwrap_or_default();
            let _ = std::fs::remove_file(folder.join("said"));
            (status.unwrap().code(), said)
        };
        let root = format!("--root {}/.predicament", folder.display());
        let [install, gate, summary] = [&scripts[0], &scripts[1], &scripts[2]];
        let said = run(install, &[("CLONE", "clone"), ("VERSION", "0.1.0")]);
        assert_eq!(said, (Some(0), format!("cargo install --locked --path clone/harness {root}\n")));
        let said = run(install, &[("CLONE", ""), ("VERSION", "0.1.0")]);
        assert_eq!(said, (Some(0), format!("cargo install --locked --version =0.1.0 {root} predicament\n")));
        program(".predicament/bin/predicament", "echo verdict > comment.md; [ \"$1\" = run ] && exit 100; exit 101");
        assert_eq!(run(install, &[("CLONE", ""), ("VERSION", "0.1.0")]), (Some(0), String::new()), "it is there");
        assert_eq!(run(summary, &[]).0, Some(0), "there is no comment yet");
        let given = [("SUITES", "a.toml b"), ("BACKENDS", "exact,sos"), ("EXPECTED", "known.toml")];
        let written = "--junit junit.xml --summary comment.md";
        let (code, said) = run(gate, &given);
        assert_eq!(code, Some(101), "the code is the gate's");
        let lines = format!(
            "predicament run a.toml b -b exact,sos --expected known.toml --out out/run\n\
             predicament gate out/run --expected known.toml {written}\n"
        );
        assert_eq!(said, lines);
        std::fs::create_dir_all(folder.join("out/main")).unwrap();
        let (_, said) = run(gate, &[("SUITES", "b"), ("BACKENDS", ""), ("EXPECTED", "")]);
        let lines =
            format!("predicament run b --out out/run\npredicament gate out/run --baseline out/main {written}\n");
        assert_eq!(said, lines);
        assert_eq!(run(summary, &[]).0, Some(0));
        assert_eq!(std::fs::read_to_string(folder.join("summary")).unwrap(), "verdict\n");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn a_strangers_text_stays_in_its_block() {
        let page = page().unwrap();
        let script = blocks(&page, "sh,no_run").into_iter().find(|text| text.contains("# comment-body.sh")).unwrap();
        let folder = std::env::temp_dir().join(format!("predicament-comment-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let file = folder.join("comment.md");
        let body = |text: &[u8]| {
            std::fs::write(&file, text).unwrap();
            let output = Command::new("sh").args(["-c", script, "sh"]).arg(&file).output().unwrap();
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            String::from_utf8(output.stdout).expect("ASCII")
        };
        let text = body(b"## Gate\n\n```\n/merge\n@all <b>\r/approve\x1b[2J\n\xe2\x80\xae\xff \xe2\x80\xa8/close");
        let (head, block) = text.split_once("\n\n").unwrap();
        assert_eq!(head, "The gate, in the words of the job of this request:");
        assert!(block.lines().all(|line| line.starts_with("    | ")), "{block}");
        assert!(block.contains("    | /merge\n    | @all <b>/approve[2J\n"), "{block}");
        let long = body(&b"\n".repeat(1_000_000));
        assert!(long.len() < 61_000, "{}", long.len());
        let link = folder.join("link.md");
        std::os::unix::fs::symlink(&file, &link).unwrap();
        let refused = Command::new("sh").args(["-c", script, "sh"]).arg(&link).output().unwrap();
        assert!(!refused.status.success() && refused.stdout.is_empty());
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
