//! `engines`: programs of other languages: make, list, install, build, greet, clean.

mod doctor;
mod new;
mod whole;

use predicament_engines::{Config, Engine, EngineError, FOLDER, PREFIX, Step, all, chore, find, folder};
use predicament_predicates::{Backend, PredicateKind, ZeroMeaning};

use crate::exit::{self, Failure};
use crate::out::program;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Engines are folders with an engine.toml in $PREDICAMENT_ENGINES, or in ./engines; docs/ENGINES.md describes them.

Examples:
  predicament engines new mine --language cpp  write an engine to start from
  predicament engines                          what there is, and what is ready
  predicament engines install cgal-epick       its library, by the package manager's client
  predicament engines build                    all of them; says which were not built, and why
  predicament engines check naive-cpp          start it and greet it
  predicament engines doctor naive-cpp         which compiler settings break it
  predicament run families -b engine:naive-cpp,exact";

/// Engines: predicates of programs in other languages
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(clap::Subcommand)]
enum Command {
    New(new::Args),
    Doctor(doctor::Args),
    /// Name the engines, and say which of them start
    List,
    /// Install the libraries that engines need
    Install {
        /// Engines by name or file; all if left out
        names: Vec<String>,
    },
    /// Build engines
    Build {
        /// Engines by name or file; all if left out
        names: Vec<String>,
    },
    /// Start engines and ask them what they offer
    Check {
        /// Engines by name or file; all if left out
        names: Vec<String>,
    },
    /// Remove what was built
    Clean {
        /// Engines by name or file; all if left out
        names: Vec<String>,
    },
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    match args.command.as_ref().unwrap_or(&Command::List) {
        Command::New(args) => new::run(args, tool),
        Command::Doctor(args) => doctor::run(args, tool),
        Command::List => list(),
        Command::Install { names } => each(names, |config| step(config, Step::Install)),
        Command::Build { names } => each(names, |config| step(config, Step::Build)),
        Command::Check { names } => each(names, |config| Ok(offers(&Engine::start(config.clone())?))),
        Command::Clean { names } => each(names, |config| step(config, Step::Clean)),
    }
}

/// All engines, a line each. One that does not start is no error here.
fn list() -> exit::Outcome {
    let engines = all();
    if engines.is_empty() {
        return Err(nothing());
    }
    for config in engines {
        match config {
            Err(error) => say!("{error}"),
            Ok(config) => {
                let state = match Engine::start(config.clone()) {
                    Ok(engine) => offers(&engine),
                    Err(error) => error.to_string(),
                };
                say!("{:<20} {}", config.name, config.about);
                if !config.licence.is_empty() {
                    say!("{:<20} {}", "", config.licence);
                }
                say!("{:<20} {state}", "");
            }
        }
    }
    Ok(exit::OK)
}

/// Does something with each of these engines, with all if none is named, and says how it went.
fn each(names: &[String], work: impl Fn(&Config) -> Result<String, EngineError>) -> exit::Outcome {
    let engines = if names.is_empty() { all() } else { names.iter().map(|name| find(name)).collect() };
    if engines.is_empty() {
        return Err(nothing());
    }
    let (total, mut failed) = (engines.len(), 0);
    for config in engines {
        let done = config.map_err(|error| error.to_string()).and_then(|config| {
            work(&config).map(|said| format!("{:<20} {said}", config.name)).map_err(|error| {
                let needs = if config.needs.is_empty() { String::new() } else { format!("\n  needs {}", config.needs) };
                format!("{:<20} FAILED: {error}{needs}", config.name)
            })
        });
        match done {
            Ok(said) => say!("{said}"),
            Err(error) => {
                failed += 1;
                say!("{error}");
            }
        }
    }
    say!("{} of {total} engines", total - failed);
    if failed == 0 { Ok(exit::OK) } else { Ok(exit::USAGE) }
}

/// The folder of engines has no engine.
fn nothing() -> Failure {
    Failure::nothing(format!(
        "{} has no engines; `{} engines new NAME --language LANGUAGE` writes one there, and ${FOLDER} names another folder",
        folder().display(),
        program()
    ))
}

fn step(config: &Config, step: Step) -> Result<String, EngineError> {
    chore(config, step, |line| note!("{}: {line}", config.name))?;
    Ok(match step {
        Step::Install => "installed",
        Step::Build => "built",
        Step::Clean => "cleaned",
    }
    .to_owned())
}

/// The version, the predicates with the meaning of zero, and the tasks of an engine, in one line.
fn offers(engine: &Engine) -> String {
    let zero = match engine.contract(PredicateKind::Orient2d).zero {
        ZeroMeaning::Exact => "zero is zero",
        ZeroMeaning::Never => "ties are broken",
        ZeroMeaning::Band => "zero is a band",
    };
    let names: Vec<&str> = engine.predicates().iter().map(|kind| kind.name()).collect();
    let version = engine.version().unwrap_or_default();
    let mut parts = vec![format!("-b {PREFIX}{}: version {version}", engine.short_name())];
    if !names.is_empty() {
        parts.extend([names.join(", "), zero.to_owned()]);
    }
    if !engine.tasks().is_empty() {
        parts.push(format!("tasks {}", engine.tasks().join(", ")));
    }
    parts.join("; ")
}
