//! `corpus`: make, list, check, tidy and generate suites, keep their expectations, fetch data.

mod expect;
mod fmt;
mod new;
mod resolve;

use std::collections::BTreeSet;
use std::path::PathBuf;

use predicament_corpus::{Heading, LoadedScene, SceneDef};
use predicament_formats::fetch;
use predicament_tasks::Watch;
use serde_json::json;

use crate::exit::{self, Failure};
use crate::out::program;
use crate::select::Selector;
use crate::shared::tell_not_selected;
use crate::tool::Tool;
use crate::vectors::{SCHEMA, VERSION, Vectors, tasks};
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
Examples:
  predicament corpus list --scenes
  predicament corpus verify mine.toml
  predicament corpus fmt mine.toml points.csv         decimals with digits that no double holds as hex floats, beside
  predicament corpus gen families -f 'near-orient3d'  generate, and show how degenerate it is
  predicament corpus gen classics -f 'kettner-a1$' --toml > mine.toml   write it out, as a suite to change
  predicament corpus gen families -f 'near-orient' --json               as test vectors, with all truths
  predicament corpus fetch                            real data, into the cache";

/// Suites: list, make, verify, format, generate; expectations; fetch data
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    /// Name the suites, or with --scenes all their scenes
    List {
        /// Name every scene as well
        #[arg(long)]
        scenes: bool,
        /// A line for each suite, or one JSON object for each, with its scenes
        #[arg(long, value_enum, default_value_t = Format::Text)]
        format: Format,
    },
    Fmt(fmt::Args),
    New(new::Args),
    /// Load every scene: syntax, coordinates, ids, data
    Verify(Selector),
    /// Generate or import scenes and show how degenerate they are
    Gen {
        #[command(flatten)]
        selector: Selector,
        /// Print the scenes written out, as a suite: points, and what is asked about them by their indices
        #[arg(long)]
        toml: bool,
        /// Print the queries of the five predicates, or scenes of tasks with one right answer, as test vectors: points
        /// and all truths (docs/VECTORS.md)
        #[arg(long, conflicts_with = "toml")]
        json: bool,
    },
    /// Fetch real data with npm and cargo, verified by SHA-256
    Fetch {
        /// Keys of the manifest; everything that is missing if left out
        keys: Vec<String>,
        /// Where to put them; $PREDICAMENT_CACHE or the user's cache if left out
        #[arg(long, value_name = "DIR")]
        cache: Option<PathBuf>,
    },
    Expect(expect::Args),
    Resolve(resolve::Args),
}

/// The format of a list.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
enum Format {
    /// Lines for people.
    Text,
    /// One JSON object a line.
    Json,
}

/// Runs the command.
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    match args.command {
        Command::List { scenes, format } => list(tool, scenes, format == Format::Json),
        Command::Fmt(args) => fmt::run(&args, tool),
        Command::Verify(selector) => verify(tool, &selector),
        Command::Gen { selector, json: true, .. } => vectors(tool, &selector),
        Command::Gen { selector, toml, .. } => generate(tool, &selector, toml),
        Command::Fetch { keys, cache } => fetch_all(tool, &keys, cache),
        Command::New(args) => new::run(&args, tool),
        Command::Expect(args) => expect::run(&args, tool),
        Command::Resolve(args) => resolve::run(&args),
    }
}

fn list(tool: &Tool, scenes: bool, as_json: bool) -> exit::Outcome {
    let (library, own) = (tool.library()?, tool.own_suites()?);
    for suite in own.iter().chain(library.suites()?) {
        if as_json {
            let scene =
                |def: &SceneDef| json!({ "name": def.name, "task": def.task, "family": def.family, "tags": def.tags });
            let scenes: Vec<_> = suite.scenes.iter().map(scene).collect();
            let (title, fetch) = (&suite.title, suite.needs_fetch);
            say!("{}", json!({ "suite": suite.name, "title": title, "needs_fetch": fetch, "scenes": scenes }));
            continue;
        }
        let fetched = if suite.needs_fetch { format!("  (needs `{} corpus fetch`)", program()) } else { String::new() };
        say!("{:<14} {:>4} scenes  {}{fetched}", suite.name, suite.scenes.len(), suite.title);
        if scenes {
            for def in &suite.scenes {
                say!("    {:<40} {:<16} {}", def.name, def.task, def.family);
            }
        }
    }
    Ok(exit::OK)
}

fn verify(tool: &Tool, selector: &Selector) -> exit::Outcome {
    let selection = selector.select(tool)?;
    let planned = selection.plan()?;
    let queries: u64 = planned.iter().map(|scene| scene.plan.queries).sum();
    say!("{} suites, {} scenes, {queries} queries: all valid", selection.suites.len(), planned.len());
    tell_not_selected(&selection.not_selected, "verified");
    Ok(exit::OK)
}

fn generate(tool: &Tool, selector: &Selector, as_suite: bool) -> exit::Outcome {
    interrupt::leave_at_once();
    let selection = selector.select(tool)?;
    let defs = selection.defs();
    if defs.is_empty() {
        return Err(selection.nothing());
    }
    if as_suite {
        say!("title = \"Scenes written out\"");
    }
    let mut names = BTreeSet::new();
    let working = progress::working("");
    for def in defs {
        working.now(format!("{}/{}", def.suite, def.name));
        let loaded = selection.load(def)?;
        if as_suite {
            // Names are unique in a suite, and these scenes may be of several.
            let name = &loaded.name;
            let name = if names.insert(name.clone()) { name.clone() } else { format!("{}-{name}", loaded.suite) };
            say!("\n{}", table(tool, &loaded, &name)?);
            continue;
        }
        say!(
            "{}/{} ({}, {} vertices{}, id {})",
            loaded.suite,
            loaded.name,
            loaded.task,
            loaded.scene.len(),
            match loaded.scene.constructions().len() {
                0 => String::new(),
                constructed => format!(", {constructed} constructed"),
            },
            loaded.id
        );
        if !loaded.notes.is_clean() {
            say!("  read with changes: {}", loaded.notes);
        }
        let watch = Watch::new(interrupt::flag(), None, &|_| {});
        let stopped = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
        for line in tool.task(loaded.task).describe_scene(&loaded, &watch).map_err(stopped)?.lines() {
            say!("  {line}");
        }
    }
    Ok(exit::OK)
}

/// Prints the test vectors of scenes, a row a line.
fn vectors(tool: &Tool, selector: &Selector) -> exit::Outcome {
    interrupt::leave_at_once();
    let selection = selector.select(tool)?;
    let defs = selection.defs();
    if defs.is_empty() {
        return Err(selection.nothing());
    }
    let mut vectors = Vectors::new(tool)?;
    let working = progress::working("");
    let mut rows = Vec::new();
    // Rows of tasks have a schema of their own, so that a file is about either.
    let is_of_tasks = tasks::TASKS.contains(&defs[0].task);
    for def in defs {
        working.now(format!("{}/{}", def.suite, def.name));
        let loaded = selection.load(def)?;
        match is_of_tasks {
            true => rows.push(tasks::row(tool, &loaded)?.to_string()),
            false => rows.extend(vectors.rows(&loaded)?.iter().map(ToString::to_string)),
        }
    }
    drop(working);
    let schema = if is_of_tasks { tasks::SCHEMA } else { SCHEMA };
    say!("{{\"schema\":\"{schema}\",\"version\":{VERSION},\"rows\":[\n{}\n]}}", rows.join(",\n"));
    Ok(exit::OK)
}

/// The scene written out, with a comment where what is read from it has another id.
fn table(tool: &Tool, loaded: &LoadedScene, name: &str) -> Result<String, Failure> {
    let LoadedScene { suite, id, tags, source, analysis, .. } = loaded;
    let spelled = loaded.spelled().ok_or_else(|| {
        Failure::usage(format!("{suite}/{} can't be written out; choose other scenes by -f", loaded.name))
    })?;
    let table = spelled.table(Heading { name, tags, source, analysis });
    let again = spelled.loaded(tool.vocabulary(), name)?.id;
    let note = if again == *id { String::new() } else { format!("# Its id is {again} here; it was {id}.\n") };
    Ok(note + table.trim_end())
}

fn fetch_all(tool: &Tool, keys: &[String], cache: Option<PathBuf>) -> exit::Outcome {
    let library = tool.library()?;
    let selector = Selector { cache, ..Selector::everything() };
    let cache = selector.cache()?;
    let entries: Vec<_> =
        library.manifest().entries().filter(|entry| keys.is_empty() || keys.contains(&entry.key)).collect();
    if let Some(unknown) = keys.iter().find(|key| entries.iter().all(|entry| entry.key != **key)) {
        let names: Vec<&str> = library.manifest().entries().map(|entry| entry.key.as_str()).collect();
        return Err(Failure::usage(format!("unknown data `{unknown}`; use one of {}", names.join(", "))));
    }
    let mut failed = Vec::new();
    for entry in entries {
        if cache.has(entry) {
            say!("{:<20} present", entry.key);
            continue;
        }
        // A client that is not here, such as Debian's, costs its files only.
        match fetch(entry, &cache, &mut |line| tell!("{line}")) {
            Ok(path) => say!("{:<20} {}", entry.key, path.display()),
            Err(why) => failed.push(why.to_string()),
        }
    }
    if failed.is_empty() { Ok(exit::OK) } else { Err(Failure { message: failed.join("\n"), code: exit::CORPUS }) }
}
