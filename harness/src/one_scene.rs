//! One scene: of a suite, or of a task on files of the user's.

use std::path::Path;

use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_formats::{Columns, CorpusError, Manifest};
use predicament_tasks::AnyTask;

use crate::columns;
use crate::exit::Failure;
use crate::out::word;
use crate::select::Selector;
use crate::shared::tell_remarks;
use crate::tool::Tool;

/// The part of a command line that selects one scene.
#[derive(clap::Args)]
pub struct OneScene {
    #[command(flatten)]
    pub selector: Selector,

    /// For a task on files: another key of the scene, as `KEY=VALUE`; VALUE is TOML, or a word
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,

    /// For a task on files: take the nearest doubles of decimals that are none
    #[arg(long)]
    pub round: bool,

    /// For a task on files: the columns of x and y (and z) in a CSV file of points, by names in the header or numbers
    /// from 1
    #[arg(long, value_name = "COLUMNS", value_parser = columns::parse)]
    pub columns: Option<Columns>,
}

/// The keys of files of points, which may have other columns.
const OF_POINTS: [&str; 2] = ["points", "probes"];

impl OneScene {
    /// The scene that is selected, or that of a task on files.
    pub fn load(&self, tool: &Tool) -> Result<LoadedScene, Failure> {
        match files(self, tool)? {
            Some((task, files)) => {
                let loaded = of_files(self, tool, task, files)?;
                loaded.remarks.iter().for_each(|remark| note!("{remark}"));
                Ok(loaded)
            }
            None => {
                let loaded = of_suite(self, tool)?;
                tell_remarks(&loaded);
                Ok(loaded)
            }
        }
    }

    /// The name of a loaded scene in messages: the files of a task on files, else its suite and its name.
    pub fn named(&self, loaded: &LoadedScene) -> String {
        match self.selector.suites.split_first() {
            Some((_, files)) if loaded.suite == SOLVED && !files.is_empty() => files.join(" and "),
            _ => format!("{}/{}", loaded.suite, loaded.name),
        }
    }
}

/// The one scene that is selected.
fn of_suite(args: &OneScene, tool: &Tool) -> Result<LoadedScene, Failure> {
    let of_files = [("--set", !args.set.is_empty()), ("--round", args.round), ("--columns", args.columns.is_some())];
    if let Some(option) = of_files.iter().find(|(_, is)| *is) {
        let message = format!("{} is for a task on files; write the key in the suite", option.0);
        return Err(Failure::usage(message));
    }
    let selection = args.selector.select(tool)?;
    let defs = selection.defs();
    match defs.as_slice() {
        [def] => selection.load(def),
        [] => Err(selection.nothing()),
        [first, second, ..] => {
            let message = format!("{}/{} and {}/{} are selected", first.suite, first.name, second.suite, second.name);
            Err(Failure::usage(format!("{message}; choose one scene with -f")))
        }
    }
}

/// A task and files of the user's.
type OnFiles<'a> = (&'static dyn AnyTask, &'a [String]);

/// The task and the files, where those are named and no suites.
fn files<'a>(args: &'a OneScene, tool: &Tool) -> Result<Option<OnFiles<'a>>, Failure> {
    let Some((first, files)) = args.selector.suites.split_first() else { return Ok(None) };
    let Some(task) = tool.tasks().iter().copied().find(|task| task.name() == first) else { return Ok(None) };
    // A suite can have the name of a task.
    let Some(second) = files.first() else { return Ok(None) };
    let library = tool.library()?;
    let is_suite = second.ends_with(".toml") || library.names().any(|name| name == second);
    Ok((!is_suite).then_some((task, files)))
}

/// The scene of a task on files.
fn of_files(args: &OneScene, tool: &Tool, task: &dyn AnyTask, files: &[String]) -> Result<LoadedScene, Failure> {
    if args.selector.filter.is_some() {
        return Err(Failure::usage("-f chooses a scene of a suite, but the input is files; leave it out"));
    }
    let (name, keys) = (task.name(), task.file_keys());
    if files.len() > keys.len() {
        let takes = if keys.len() == 1 { "one file".to_owned() } else { format!("{} files", keys.len()) };
        return Err(Failure::usage(format!(
            "{name} takes {takes}, {}, but {} are named",
            keys.join(" and "),
            files.len()
        )));
    }
    // A literal string of TOML has no escapes: names with quotes in them need the other kind.
    let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
    let mut text = format!("title = \"A file\"\n[[scene]]\nname = \"solved\"\ntask = {}\n", quoted(name));
    let takes_columns = keys.iter().zip(files).any(|(key, _)| OF_POINTS.contains(key));
    if args.columns.is_some() && !takes_columns {
        return Err(Failure::usage(format!("--columns is for files of points, but {name} has none; leave it out")));
    }
    for (key, file) in keys.iter().zip(files) {
        let path = std::path::absolute(file).map_err(|error| Failure::usage(format!("{file}: {error}")))?;
        let is_points = OF_POINTS.contains(key);
        let columns = is_points.then(|| columns::of_file(Path::new(file), args.columns.as_ref())).flatten();
        text += &format!("{key} = {}\n", columns::table(&path.display().to_string(), columns.as_ref()));
    }
    if args.round {
        text += "round = true\n";
    }
    for pair in &args.set {
        let Some((key, value)) = pair.split_once('=') else {
            return Err(Failure::usage(format!("--set {pair}: write KEY=VALUE, such as queries=all")));
        };
        let is_key = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || "_-".contains(c));
        if value.contains(['\n', '\r']) {
            return Err(Failure::usage(format!("--set {key}: the value has a line break; write it in one line")));
        }
        if !is_key {
            return Err(Failure::usage(format!(
                "--set {pair}: `{key}` is not a key; write KEY=VALUE, such as queries=all"
            )));
        }
        let is_toml = format!("x = {value}").parse::<toml::Table>().is_ok_and(|table| table.len() == 1);
        text += &format!("{key} = {}\n", if is_toml { value.to_owned() } else { quoted(value) });
    }
    let own = |error: CorpusError| own(error, name);
    let suite =
        Suite::parse(tool.vocabulary(), SOLVED, &text, Some(Path::new(".")), &Manifest::default()).map_err(own)?;
    let [def] = suite.scenes.as_slice() else {
        return Err(Failure::usage("--set adds more scenes; set only keys of the scene"));
    };
    def.load(Level::Quick, &args.selector.cache()?).map_err(own)
}

/// The name of the suite that is not written down.
const SOLVED: &str = "solve";

/// An error about files, with the cures of this command.
fn own(error: CorpusError, task: &str) -> Failure {
    let rounds =
        error.cure.contains("write `round = true`").then(|| "add --round to read the nearest doubles".to_owned());
    let cure = rounds.clone().unwrap_or_else(|| set(&error.cure));
    if error.file != SOLVED {
        return CorpusError { cure, ..error }.into();
    }
    // A key of the scene, in backticks, is an option here.
    let cure = match (rounds, error.message.contains("can't be read")) {
        (Some(cure), _) => cure,
        (None, true) => "name an existing file".to_owned(),
        (None, false) if cure.contains('`') => format!("{cure}, with --set KEY=VALUE"),
        (None, false) => cure,
    };
    Failure::usage(format!("{task}: {}; {cure}", error.message))
}

/// A cure with options in the place of keys: `add --set check=false` for ``write `check = false` ``.
fn set(cure: &str) -> String {
    let Some((before, rest)) = cure.split_once("write `") else { return cure.to_owned() };
    let Some((key, after)) = rest.split_once('`') else { return cure.to_owned() };
    match key.split_once(" = ") {
        Some((key, value)) => format!("{before}add --set {}{}", word(&format!("{key}={value}")), set(after)),
        None => format!("{before}write `{key}`{}", set(after)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_of_a_cure_become_options() {
        assert_eq!(
            set("cut them, or write `check = false` to take it"),
            "cut them, or add --set check=false to take it"
        );
        assert_eq!(
            set("write `planes`, or write `moved = [1, 0, 0]`"),
            "write `planes`, or add --set 'moved=[1, 0, 0]'"
        );
        assert_eq!(set("write `x"), "write `x");
    }
}
