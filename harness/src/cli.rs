//! The command line, with backends and tasks of other crates.

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser, Subcommand};
use predicament_bundle::Systems;
use predicament_judge::TieJudge;
use predicament_oracle::roster::Roster;
use predicament_predicates::{Backend, Question, Scene, Sign, Vertex};
use predicament_studies::{Entry, Ready, Study};
use predicament_tasks::{self as tasks, Contestant, Task, TaskList};

use crate::host::{Called, Host, Stream};
use crate::tool::{Guests, ReportSection, Tool};
use crate::{cmd, exit, formulas, host, interrupt, layout, names, out};

/// The id of the option `--quiet`.
const QUIET: &str = "quiet";

/// A differential test harness for geometric predicates.
///
/// Runs degenerate scenes through backends of three philosophies (exact
/// arithmetic, Simulation of Simplicity, tolerances) and several controls,
/// and reports disagreements, topology errors and throughput.
#[derive(Parser)]
#[command(name = "predicament", version, after_help = exit::HELP, propagate_version = true)]
struct Arguments {
    /// Print only errors on stderr, without notes and progress
    #[arg(short = 'q', long, global = true, id = QUIET)]
    quiet: bool,

    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Ask(cmd::ask::Args),
    Solve(cmd::solve::Args),
    Draw(cmd::draw::Args),
    Derive(cmd::derive::Args),
    Run(cmd::run::Args),
    Gate(cmd::gate::Args),
    Judge(cmd::judge::Args),
    Bench(cmd::bench::Args),
    Report(cmd::report::Args),
    Scoreboard(cmd::scoreboard::Args),
    Hunt(cmd::hunt::Args),
    Shrink(cmd::shrink::Args),
    Replay(cmd::replay::Args),
    Corpus(cmd::corpus::Args),
    Data(cmd::data::Args),
    Shard(cmd::shard::Args),
    Engines(cmd::engines::Args),
    Setup(cmd::setup::Args),
}

/// The `study` command, with one subcommand for each study.
fn study(studies: &[Entry]) -> clap::Command {
    clap::Command::new(names::STUDY)
        .about("Measure backends: which one for what, where they break, what they cost")
        .after_help(format!(
            "Examples:\n  {0} study compare --out out/compare\n  {0} study stress --help",
            out::program()
        ))
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommands(studies.iter().map(Entry::command))
}

/// The tool with its built-in systems and studies; its methods add more.
#[must_use]
pub fn cli() -> Cli<(), Systems> {
    let guests = Guests { studies: predicament_bundle::STUDIES.to_vec(), ..Guests::default() };
    Cli { backends: (), tasks: Systems, guests }
}

/// The tool with additional backends, tasks and studies; see [`cli`].
pub struct Cli<B, T> {
    backends: B,
    tasks: T,
    guests: Guests,
}

impl<B: BackendList, T: Roster> Cli<B, T> {
    /// Adds a backend, which runs by default; `-b` selects it by name.
    #[must_use]
    pub fn backend<N: Backend + 'static>(self, backend: N) -> Cli<(Own<N>, B), T> {
        self.own(Own { backend: Arc::new(backend), ties: None })
    }

    /// Adds a backend that breaks ties, with an independent judge of its tie-breaking.
    #[must_use]
    pub fn breaking_ties<N: Backend + 'static>(
        self,
        backend: N,
        judge: impl Fn(&Scene, Question, &[Vertex]) -> Sign + Send + Sync + 'static,
    ) -> Cli<(Own<N>, B), T> {
        self.own(Own { backend: Arc::new(backend), ties: Some(Arc::new(judge)) })
    }

    fn own<N: Backend + 'static>(self, own: Own<N>) -> Cli<(Own<N>, B), T> {
        let Cli { backends, tasks, guests } = self;
        Cli { backends: (own, backends), tasks, guests }
    }

    /// Adds a task; every backend runs on its scenes.
    #[must_use]
    pub fn task<N: Task + Clone>(self, task: N) -> Cli<B, (N, T)> {
        let Cli { backends, tasks, guests } = self;
        Cli { backends, tasks: (task, tasks), guests }
    }

    /// Adds a study as a command.
    #[must_use]
    pub fn study<S: Study + 'static>(mut self) -> Cli<B, T> {
        self.guests.studies.push(Entry::of::<S>());
        self
    }

    /// Adds a section to reports, made from rows of the reported runs. A section about one task belongs to the task
    /// ([`Task::section`](predicament_tasks::Task::section)).
    #[must_use]
    pub fn section(mut self, section: ReportSection) -> Cli<B, T> {
        self.guests.sections.push(section);
        self
    }

    /// Adds a folder of suites, which run by default; commands select them by name.
    #[must_use]
    pub fn suites(mut self, folder: impl Into<PathBuf>) -> Cli<B, T> {
        self.guests.suites.push(folder.into());
        self
    }

    /// Names a file of expected disagreements for your own suites and backends, in addition to the shipped file.
    #[must_use]
    pub fn expected(mut self, file: impl Into<PathBuf>) -> Cli<B, T> {
        self.guests.expected = Some(file.into());
        self
    }

    /// Reads the command line, runs the command, and returns the exit code.
    #[must_use]
    pub fn main(self) -> ExitCode {
        ExitCode::from(self.main_with(std::env::args_os()))
    }

    /// Runs the command of these words, the program's name first, and returns the exit code.
    ///
    /// It is for programs whose own command line is another: the main function of a binding.
    #[must_use]
    pub fn main_with(self, words: impl IntoIterator<Item = OsString>) -> u8 {
        interrupt::outlive_limits();
        let words: Vec<OsString> = words.into_iter().collect();
        host::set_words(words.clone());
        self.run(words)
    }

    /// Runs the command of these words, the program's name first, inside the process of another program.
    ///
    /// The call prints nothing, keeps Ctrl-C as it is, and does not end the process: it returns the texts and the exit
    /// code. [`interrupt`](crate::interrupt) stops it. Calls wait for each other.
    #[must_use]
    pub fn call(self, words: impl IntoIterator<Item = OsString>) -> Called {
        host::call(words.into_iter().collect(), |words| self.run(words))
    }

    /// Says that the tool is inside another program.
    #[must_use]
    pub fn hosted(self, host: Host) -> Cli<B, T> {
        host::set(host);
        self
    }

    fn run(self, words: Vec<OsString>) -> u8 {
        // Formulas are tasks too, so they must be known before the tool lists its tasks.
        match formulas::registered(words) {
            Ok(words) => main(words, &Tool::new(self.backends, &self.tasks, self.guests)),
            Err(failure) => exit::code(Err(failure)),
        }
    }
}

/// The rest of [`Cli::main`]: not generic, so that programs with backends of their own do not compile it again.
fn main(words: Vec<OsString>, tool: &Tool) -> u8 {
    let command = whole(tool);
    // The words after `--` are another command.
    let own = words.iter().position(|word| word == "--").unwrap_or(words.len());
    let words: Vec<OsString> =
        words.into_iter().enumerate().map(|(at, word)| if at < own { point(word) } else { word }).collect();
    if let Some(at) = words.iter().take(own).skip(1).position(is_empty) {
        return exit::code(Err(exit::Failure::usage(empty(&words, at + 1))));
    }
    let (words, renamed) = names::current(words, tool.studies());
    let matches = layout::laid_out(command.clone()).try_get_matches_from(words);
    let asked =
        matches.and_then(|matches| Ok((matches.get_flag(QUIET), Asked::from_matches(&matches, tool.studies())?)));
    let (is_quiet, asked) = match asked {
        Ok(asked) => asked,
        Err(error) => return refused(&error),
    };
    if is_quiet {
        out::be_quiet(true);
    }
    for line in renamed {
        note!("{line}");
    }
    // If the tool panics, it must not exit with the code of `unexpected pass`.
    let done = predicament_oracle::caught(|| match asked {
        Asked::Study(study) => cmd::study::run(study.as_ref(), tool),
        Asked::Command(asked) => asked.run(tool, command),
    });
    exit::code(done.unwrap_or_else(|broken| Err(exit::Failure::usage(broken))))
}

/// Prints a help text, or the error of a command line; returns the exit code.
fn refused(error: &clap::Error) -> u8 {
    let stream = if error.use_stderr() { Stream::Told } else { Stream::Out };
    if !host::keeps(stream, &error.render().to_string()) {
        // Nobody is left to tell that the message can't be printed.
        let _ = error.print();
    }
    u8::try_from(error.exit_code()).unwrap_or(exit::USAGE)
}

/// The command line, with backends and studies of other crates in its help.
fn whole(tool: &Tool) -> clap::Command {
    let backends = format!("Backends:\n{}\n\n{}", tool.backend_help(), cmd::run::EXAMPLES);
    let command =
        Arguments::command().mut_subcommand("run", |run| run.after_help(backends)).subcommand(study(tool.studies()));
    let page = format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{}\nOptions:\n{{options}}{{after-help}}",
        names::groups(&command)
    );
    command.help_template(page)
}

/// The parsed command.
enum Asked {
    Command(Box<Command>),
    Study(Box<dyn Ready>),
}

impl Asked {
    fn from_matches(matches: &ArgMatches, studies: &[Entry]) -> Result<Asked, clap::Error> {
        let study = matches.subcommand().filter(|(name, _)| *name == names::STUDY).and_then(|(_, one)| {
            let (name, own) = one.subcommand()?;
            Some(studies.iter().find(|study| study.name == name)?.parse(own))
        });
        match study {
            Some(study) => Ok(Asked::Study(study?)),
            None => Ok(Asked::Command(Box::new(Arguments::from_arg_matches(matches)?.command))),
        }
    }
}

impl Command {
    /// Runs the command.
    fn run(self, tool: &Tool, command: clap::Command) -> exit::Outcome {
        match self {
            Command::Ask(args) => cmd::ask::run(&args, tool),
            Command::Solve(args) => cmd::solve::run(&args, tool),
            Command::Judge(args) => cmd::judge::run(&args, tool),
            Command::Draw(args) => cmd::draw::run(args, tool),
            Command::Derive(args) => cmd::derive::run(&args),
            Command::Run(args) => cmd::run::run(args, tool),
            Command::Gate(args) => cmd::gate::run(&args, tool),
            Command::Bench(args) => cmd::bench::run(args, tool),
            Command::Report(args) => cmd::report::run(&args, tool),
            Command::Scoreboard(args) => cmd::scoreboard::run(&args, tool),
            Command::Hunt(args) => cmd::hunt::run(&args, tool),
            Command::Shrink(args) => cmd::shrink::run(&args, tool),
            Command::Replay(args) => cmd::replay::run(&args, tool),
            Command::Corpus(args) => cmd::corpus::run(args, tool),
            Command::Data(args) => cmd::data::run(&args, tool),
            Command::Shard(args) => cmd::shard::run(&args, tool),
            Command::Engines(args) => cmd::engines::run(&args, tool),
            Command::Setup(args) => cmd::setup::run(args, tool, command),
        }
    }
}

/// True if an argument is empty, or is an option with an empty value. The usual cause is a variable that is not set. No
/// argument of the tool may be empty.
fn is_empty(word: &OsString) -> bool {
    let option = |text: &str| text.starts_with("--") && text.ends_with('=');
    word.is_empty() || word.to_str().is_some_and(option)
}

/// The message about an empty argument.
fn empty(words: &[OsString], at: usize) -> String {
    let shown: Vec<String> = words[1..at].iter().map(|word| word.to_string_lossy().into_owned()).collect();
    let behind = if shown.is_empty() { String::new() } else { format!(" behind `{}`", shown.join(" ")) };
    let word = words[at].to_string_lossy();
    let what = if word.is_empty() { "an empty argument".to_owned() } else { format!("`{word}` without a value") };
    format!("{what}{behind}; write a value, or leave it out")
}

/// Puts brackets around a point such as `-1,0`, so that it is not parsed as an option.
fn point(word: OsString) -> OsString {
    let is_point = |text: &str| {
        let rest = text.strip_prefix('-').unwrap_or_default();
        rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') && rest.contains(',')
    };
    match word.to_str() {
        Some(text) if is_point(text) => OsString::from(format!("({text})")),
        _ => word,
    }
}

/// A backend of another crate.
pub struct Own<B> {
    backend: Arc<B>,
    ties: Option<Arc<TieJudge>>,
}

/// Backends of other crates: `()`, or a backend followed by a list of more.
pub trait BackendList: Send + Sync + 'static {
    /// The names of the backends.
    fn names(&self) -> Vec<String>;

    /// The backend with this name, on the sign tasks and on the tasks of the list.
    fn find<T: TaskList>(&self, name: &str, list: &T) -> Option<Box<dyn Contestant>>;
}

impl BackendList for () {
    fn names(&self) -> Vec<String> {
        Vec::new()
    }

    fn find<T: TaskList>(&self, _: &str, _: &T) -> Option<Box<dyn Contestant>> {
        None
    }
}

impl<B: Backend + 'static, Rest: BackendList> BackendList for (Own<B>, Rest) {
    fn names(&self) -> Vec<String> {
        let mut names = self.1.names();
        names.push(self.0.backend.name());
        names
    }

    fn find<T: TaskList>(&self, name: &str, list: &T) -> Option<Box<dyn Contestant>> {
        let Own { backend, ties } = &self.0;
        if backend.name() != name {
            return self.1.find(name, list);
        }
        let ties = ties
            .clone()
            .map(|judge| -> Box<TieJudge> { Box::new(move |scene, question, args| judge(scene, question, args)) });
        Some(Box::new(tasks::Entry::shared(Arc::clone(backend), ties, list.clone())))
    }
}
