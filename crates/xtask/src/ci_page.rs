//! The recipes of docs/CI.md: jobs with a token run no foreign code, and installed versions are fixed.

use std::process::{Command, Stdio};

use crate::command::{answers, root};

/// A Python program that reads YAML from stdin and checks that it is a table of jobs.
const PARSE: &str = "import sys, yaml\nof = yaml.safe_load(sys.stdin)\njobs = of.get('jobs', of)\n\
                     assert jobs and all('steps' in job or 'script' in job for job in jobs.values()), 'a job without steps'";

/// Parses each recipe with Python's yaml, or reports that it is missing.
///
/// # Errors
/// If a recipe is not YAML, or is not a table of jobs.
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

    /// The jobs of a recipe as text: each begins with its name.
    fn jobs(recipe: &str) -> Vec<String> {
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

    /// The error of a job, if any.
    fn wrong(job: &str) -> Option<&'static str> {
        let has = |word: &str| job.contains(word);
        let runs_strangers = has("gate.sh") && !has("branches: [main]");
        let has_token =
            ["GH_TOKEN", "COMMENT_TOKEN", "comments.sh", "secrets.", ": write"].iter().any(|word| has(word));
        let installs = job.lines().filter(|line| line.contains("cargo install"));
        let is_loose = |line: &str| {
            !["--locked", "--git \"$REPOSITORY\"", "--rev \"$COMMIT\""].iter().all(|word| line.contains(word))
        };
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
        } else {
            None
        }
    }

    #[test]
    fn no_job_runs_strangers_code_beside_a_token_or_a_cache() {
        let page = page().unwrap();
        let jobs: Vec<String> = blocks(&page, "yaml").into_iter().flat_map(jobs).collect();
        assert_eq!(jobs.len(), 6, "{jobs:#?}");
        for job in &jobs {
            assert_eq!(wrong(job), None, "{job}");
        }
        assert!(jobs.iter().filter(|job| job.contains("gate.sh")).count() == 4);
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
        assert!(wrong("comment:\n  script:\n    - sh comments.sh\n    - cargo run\n").is_some());
    }

    #[test]
    fn recipes_parse_where_python_can() {
        check().unwrap();
        if answers("python3", &["-c", "import yaml"]) {
            assert!(parse("jobs: { a: { runs-on: b } }").is_err() && parse("a: [").is_err());
        }
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
