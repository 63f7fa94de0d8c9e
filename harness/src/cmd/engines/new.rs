//! `engines new`: a working engine to start from, with its helper.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use predicament_engines::{FILE, NAME_RULE, PREFIX, folder, is_name};
use predicament_records::replace;

use super::whole;
use crate::exit::{self, Failure};
use crate::out::{program, word};
use crate::tool::Tool;

const EXAMPLES: &str = "\
The engine answers all five predicates by plain determinants. Its comments say where to call your library instead. The \
helper that speaks the protocol is written beside it: the folder needs no other file of this project.

Examples:
  predicament engines new mine --language python
  predicament engines new mine --language python --task overlay2d   instead of predicates, a task
  predicament engines new mine --language cpp --out tools/mine   into a folder of your choice";

/// The run that the command prints: scenes on which plain determinants are wrong.
const SCENES: &str = "near.*orient2d";

/// A file of an engine: its path in the folder, and its text.
type File = (&'static str, &'static str);

/// The path in the folder and the text of a file in `templates/engine`.
macro_rules! file {
    ($folder:literal, $name:literal) => {
        file!($folder, $name => $name)
    };
    ($folder:literal, $name:literal => $path:literal) => {
        ($path, include_str!(concat!("../../../templates/engine/", $folder, "/", $name)))
    };
}

/// The page of the folder.
const README: File = ("README.md", include_str!("../../../templates/engine/README.md"));

/// Write a working engine to start from, with its helper
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The name of the engine: `-b engine:NAME` runs it
    pub name: String,

    /// The language of the engine
    #[arg(long, value_enum)]
    pub language: Language,

    /// Answer a whole task instead of predicates, such as delaunay2d
    #[arg(long, value_name = "TASK")]
    pub task: Option<String>,

    /// The folder to write; $PREDICAMENT_ENGINES/NAME or engines/NAME if left out. An existing folder is not touched
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// The language of a new engine.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Language {
    /// Python 3.8 or newer
    #[value(alias = "python3")]
    Python,
    /// C++17
    #[value(alias = "c++")]
    Cpp,
    /// Rust, without other crates
    Rust,
    /// JavaScript in Node 18 or newer
    #[value(aliases = ["javascript", "js"])]
    Node,
}

/// The files of a new engine of one language.
struct Template {
    /// The language, for the page.
    language: &'static str,
    /// The file with the predicates.
    source: File,
    /// The other files with words of the engine in them.
    others: &'static [File],
    /// The file or folder of the helper.
    helper: &'static str,
    /// The files of the helper, which are written as they are. In the repository they are links to files of `engines`;
    /// in a package they are the files themselves.
    helpers: &'static [File],
    /// The part of `engines` to call before the engine runs.
    first: &'static str,
}

const PYTHON: Template = Template {
    language: "Python",
    source: file!("python", "engine.py"),
    others: &[file!("python", "engine.toml")],
    helper: "predicament_engine.py",
    helpers: &[file!("python", "predicament_engine.py")],
    first: "check",
};

const CPP: Template = Template {
    language: "C++",
    source: file!("cpp", "engine.cpp"),
    others: &[file!("cpp", "engine.toml")],
    helper: "predicament_engine.hpp",
    helpers: &[file!("cpp", "predicament_engine.hpp")],
    first: "build",
};

const RUST: Template = Template {
    language: "Rust",
    source: file!("rust", "engine.rs"),
    // A package leaves out folders with a Cargo.toml, so the template has another name.
    others: &[file!("rust", "engine.toml"), file!("rust", "manifest.toml" => "Cargo.toml")],
    helper: "predicament_engine",
    helpers: &[
        file!("rust", "lib.rs" => "predicament_engine/mod.rs"),
        file!("rust", "message.rs" => "predicament_engine/message.rs"),
        file!("rust", "rings.rs" => "predicament_engine/rings.rs"),
        file!("rust", "server.rs" => "predicament_engine/server.rs"),
        file!("rust", "tasks.rs" => "predicament_engine/tasks.rs"),
        // Not a link: the file in `engines` needs a crate.
        file!("rust", "stdout.rs" => "predicament_engine/stdout.rs"),
    ],
    first: "build",
};

const NODE: Template = Template {
    language: "JavaScript",
    source: file!("node", "engine.mjs"),
    others: &[file!("node", "engine.toml")],
    helper: "predicament_engine.mjs",
    helpers: &[file!("node", "predicament_engine.mjs")],
    first: "check",
};

impl Language {
    fn template(self) -> Template {
        match self {
            Language::Python => PYTHON,
            Language::Cpp => CPP,
            Language::Rust => RUST,
            Language::Node => NODE,
        }
    }
}

impl Template {
    /// All files of an engine with this name.
    fn files(&self, name: &str) -> Vec<(&'static str, String)> {
        let [first, next] = next(FILE, self.first);
        let filled = |text: &str| {
            text.replace("{name}", name)
                .replace("{program}", &program())
                .replace("{language}", self.language)
                .replace("{source}", self.source.0)
                .replace("{helper}", self.helper)
                .replace("{first}", &first)
                .replace("{next}", &next)
        };
        let own = self.others.iter().chain([&self.source, &README]).map(|(path, text)| (*path, filled(text)));
        let helpers = self.helpers.iter().map(|(path, text)| (*path, (*text).to_owned()));
        let mut files: Vec<(&str, String)> = own.chain(helpers).collect();
        files.sort();
        files
    }
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let Args { name, language, task, out } = args;
    if !is_name(name) {
        return Err(Failure::usage(format!("`{name}` is not a valid name of an engine; {NAME_RULE}")));
    }
    if let Some(short) = name.strip_suffix(".toml") {
        return Err(Failure::usage(format!("-b would take the engine `{name}` for a file; name it `{short}`")));
    }
    let template = language.template();
    let whole = task.as_deref().map(|task| whole::source(tool, name, task, *language)).transpose()?;
    let into = out.clone().unwrap_or_else(|| folder().join(name));
    make(&into)?;
    let mut files = template.files(name);
    if let Some((source, _)) = &whole {
        files.retain(|(path, _)| *path != README.0);
        if let Some((_, text)) = files.iter_mut().find(|(path, _)| *path == template.source.0) {
            text.clone_from(source);
        }
    }
    for (path, text) in &files {
        write(&into.join(path), text).map_err(|Failure { message, code }| {
            let message = format!("{message}; remove {} before you try again", into.display());
            Failure { message, code }
        })?;
    }
    let paths: Vec<&str> = files.iter().map(|(path, _)| *path).collect();
    say!("{}: written: {}", into.display(), paths.join(", "));
    let what = if whole.is_some() { "function" } else { "predicates" };
    say!("Replace the {what} in {} by calls of your library. Next:", into.join(template.source.0).display());
    let reference = if out.is_some() { into.join(FILE).display().to_string() } else { name.clone() };
    let commands = match whole {
        Some((_, suites)) => whole::next(&reference, template.first, suites),
        None => next(&reference, template.first),
    };
    for line in commands {
        say!("  {line}");
    }
    Ok(exit::OK)
}

/// Makes the folder of the engine, and those that it is in.
fn make(into: &Path) -> Result<(), Failure> {
    if let Some(parent) = into.parent() {
        std::fs::create_dir_all(parent).map_err(Failure::io(parent))?;
    }
    std::fs::create_dir(into).map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => {
            let cure = "name another engine, or another folder with --out";
            Failure::usage(format!("{}: the folder is there; {cure}", into.display()))
        }
        _ => Failure::io(into)(error),
    })
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    if let Some(parent) = path.parent() {
        std::fs::create_dir_all(parent).map_err(Failure::io(parent))?;
    }
    replace(path, text.as_bytes()).map_err(Failure::usage)
}

/// The two commands to go on with, for an engine by its name or file.
fn next(engine: &str, first: &str) -> [String; 2] {
    let (program, backends) = (program(), format!("{PREFIX}{engine},exact"));
    [
        format!("{program} engines {first} {}", word(engine)),
        format!("{program} run families -f {} -b {}", word(SCENES), word(&backends)),
    ]
}
