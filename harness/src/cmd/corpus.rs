//! `corpus`: look at suites, check them, tidy them, try generators, fetch data.

use std::path::PathBuf;

use predicament_corpus::{Level, Library, LoadedScene, Work, degeneracy, fetch, fmt};
use predicament_oracle::{Case, Truth, Watch};

use crate::exit::{self, CORPUS, Failure};
use crate::interrupt;
use crate::select::Selector;

const EXAMPLES: &str = "\
Examples:
  predicament corpus list --scenes
  predicament corpus verify mine.toml
  predicament corpus fmt mine.toml                    decimals that are no doubles become hex floats
  predicament corpus gen families -f 'near-orient3d'  generate, and show how degenerate it is
  predicament corpus fetch                            real data, into the cache";

/// Suites: list, format, verify, generate, fetch
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
    },
    /// Rewrite coordinates losslessly: nearest doubles as hex floats, the decimal kept as a comment
    Fmt {
        /// TOML files, rewritten in place
        #[arg(required = true)]
        files: Vec<PathBuf>,
        /// Change nothing; fail if a file would change
        #[arg(long)]
        check: bool,
    },
    /// Load every scene: syntax, coordinates, ids, data
    Verify(Selector),
    /// Generate or import scenes and show how degenerate they are
    Gen(Selector),
    /// Fetch real data with npm and cargo, verified by SHA-256
    Fetch {
        /// Keys of the manifest; everything that is missing if left out
        keys: Vec<String>,
        /// Where to put them; $PREDICAMENT_CACHE or the user's cache if left out
        #[arg(long, value_name = "DIR")]
        cache: Option<PathBuf>,
    },
}

/// Runs the command.
pub fn run(args: Args) -> exit::Outcome {
    match args.command {
        Command::List { scenes } => list(scenes),
        Command::Fmt { files, check } => format(&files, check),
        Command::Verify(selector) => verify(&selector),
        Command::Gen(selector) => generate(&selector),
        Command::Fetch { keys, cache } => fetch_all(&keys, cache),
    }
}

fn list(scenes: bool) -> exit::Outcome {
    let library = Library::embedded()?;
    for suite in library.suites() {
        let fetched = if suite.needs_fetch { "  (needs `predicament corpus fetch`)" } else { "" };
        println!("{:<14} {:>4} scenes  {}{fetched}", suite.name, suite.scenes.len(), suite.title);
        if scenes {
            for def in &suite.scenes {
                println!("    {:<40} {:<16} {}", def.name, def.task.name(), def.family);
            }
        }
    }
    Ok(exit::OK)
}

fn format(files: &[PathBuf], check: bool) -> exit::Outcome {
    let mut changed = 0;
    for file in files {
        let name = file.display().to_string();
        let text = std::fs::read_to_string(file).map_err(|error| Failure::usage(format!("{name}: {error}")))?;
        let tidy = fmt(&name, &text)?;
        if tidy == text {
            continue;
        }
        changed += 1;
        if !check {
            // Beside the file and then renamed: an interrupted write can't lose the suite.
            let next = file.with_extension("toml.next");
            std::fs::write(&next, &tidy)
                .and_then(|()| std::fs::rename(&next, file))
                .map_err(|error| Failure::usage(format!("{name}: {error}")))?;
        }
        println!("{}: {name}", if check { "would change" } else { "changed" });
    }
    Ok(if check && changed > 0 { CORPUS } else { exit::OK })
}

fn verify(selector: &Selector) -> exit::Outcome {
    let selection = selector.select()?;
    let planned = selection.plan(predicament_report::Shard::WHOLE)?;
    let queries: u64 = planned.iter().map(|(_, scene)| scene.queries).sum();
    println!("{} suites, {} scenes, {queries} queries: all valid", selection.suites.len(), planned.len());
    for left in &selection.not_selected {
        println!("not verified: {}: {}", left.suite, left.reason);
    }
    Ok(exit::OK)
}

fn generate(selector: &Selector) -> exit::Outcome {
    let selection = selector.select()?;
    let defs = selection.defs();
    if defs.is_empty() {
        return Err(Failure::nothing("no scene is selected; see `predicament corpus list --scenes`"));
    }
    for def in defs {
        let loaded = selection.load(def)?;
        println!(
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
        match &loaded.work {
            Work::Signs(queries) => {
                println!("  {} queries; log2(|det| / permanent):", queries.len());
                print!("{}", degeneracy(&loaded));
            }
            Work::Contacts { a, b } => {
                for (name, complex) in [("a", a), ("b", b)] {
                    println!(
                        "  {name}: {} vertices, {} edges, {} triangles, {} tetrahedra",
                        complex.vertices().len(),
                        complex.edges().len(),
                        complex.triangles().len(),
                        complex.tetrahedra().len()
                    );
                }
                if !loaded.notes.is_clean() {
                    println!("  import: {}", loaded.notes);
                }
            }
            Work::Interval { cells, probes, .. } => println!("  {} cells, {} probes", cells.len(), probes.len()),
            Work::Cubes { cubes } => println!("  {cubes} cubes"),
            Work::Locate { map, probes } => {
                let edges = map.edges().count();
                println!(
                    "  {} regions, {edges} edges (shared ones once for each side), {} probes",
                    map.regions().len(),
                    probes.len()
                );
                println!("  import: {}", loaded.notes);
                flaws(&loaded)?;
            }
        }
    }
    Ok(exit::OK)
}

/// The map's own gaps and overlaps, found exactly: they are nobody's errors but the map's.
fn flaws(loaded: &LoadedScene) -> Result<(), Failure> {
    let quiet = |_: u64| {};
    let stopped = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    let case = Case::new(loaded, &Watch::new(interrupt::flag(), None, &quiet)).map_err(stopped)?;
    if let Truth::Locate(case) = case.truth() {
        let flaws = case.flaws();
        println!(
            "  the map's own flaws: {} duplicate points, {} T-junctions, {} crossings, {} overlapping edges",
            flaws.duplicates.len(),
            flaws.junctions.len(),
            flaws.crossings.len(),
            flaws.overlaps.len()
        );
        let grounds: Vec<String> = case.grounds().into_iter().map(|(name, count)| format!("{count} {name}")).collect();
        println!("  probes by their surroundings: {}", grounds.join(", "));
    }
    Ok(())
}

fn fetch_all(keys: &[String], cache: Option<PathBuf>) -> exit::Outcome {
    let library = Library::embedded()?;
    let selector = Selector { suites: Vec::new(), filter: None, level: Level::Quick, cache };
    let cache = selector.cache()?;
    let entries: Vec<_> =
        library.manifest().entries().filter(|entry| keys.is_empty() || keys.contains(&entry.key)).collect();
    if let Some(unknown) = keys.iter().find(|key| entries.iter().all(|entry| entry.key != **key)) {
        let names: Vec<&str> = library.manifest().entries().map(|entry| entry.key.as_str()).collect();
        return Err(Failure::usage(format!("nothing to fetch is called `{unknown}`; there are {}", names.join(", "))));
    }
    for entry in entries {
        if cache.has(entry) {
            println!("{:<20} present", entry.key);
            continue;
        }
        let path = fetch(entry, &cache, &mut |line| eprintln!("{line}"))?;
        println!("{:<20} {}", entry.key, path.display());
    }
    Ok(exit::OK)
}
