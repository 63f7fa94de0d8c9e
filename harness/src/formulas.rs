//! Formulas that users write: as text, or as a TOML file; `--formula` makes them predicates of the tool.

use std::ffi::OsString;
use std::path::Path;

use predicament_predicates::Derived;
use predicament_predicates::formula::{Definition, Formula};

use crate::exit::Failure;

/// The option that makes a formula a predicate, for every command that takes predicates or tasks.
const OPTION: &str = "--formula";

/// The keys of a file with a formula.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: String,
    formula: String,
    #[serde(default)]
    about: Option<String>,
    #[serde(default)]
    points: Vec<String>,
    #[serde(default)]
    dimension: Option<usize>,
}

/// A formula from its text, or from the TOML file with this path.
pub fn read(text: &str) -> Result<Definition, Failure> {
    let path = Path::new(text);
    if path.extension().is_none_or(|extension| extension != "toml") {
        return Ok(Definition::anonymous(text));
    }
    let content = std::fs::read_to_string(path).map_err(Failure::io(path))?;
    let file: File = toml::from_str(&content).map_err(|error| {
        let keys = "a formula has the keys `name` and `formula`, and perhaps `about`, `points` and `dimension`";
        Failure::usage(format!("{}: {}; {keys}", path.display(), error.to_string().trim_end()))
    })?;
    let about = file.about.unwrap_or_else(|| format!("the sign of a formula of {}", path.display()));
    Ok(Definition { name: file.name, about, text: file.formula, points: file.points, dimension: file.dimension })
}

/// Derives a formula; an error shows the place in its text.
pub fn derive(definition: Definition) -> Result<Formula, Failure> {
    let text = definition.text.clone();
    Formula::new(definition).map_err(|error| Failure::usage(error.shown(&text)))
}

/// Takes `--formula FILE` out of the words of a command line, and makes each formula a predicate of the tool.
pub fn registered(words: Vec<OsString>) -> Result<Vec<OsString>, Failure> {
    let mut rest = Vec::with_capacity(words.len());
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        let text = word.to_string_lossy();
        // The words after `--` are another command.
        if text == "--" {
            rest.push(word);
            rest.extend(words);
            break;
        }
        let file = if text == OPTION {
            let missing = || Failure::usage(format!("{OPTION} needs a TOML file with a formula"));
            words.next().ok_or_else(missing)?.to_string_lossy().into_owned()
        } else if let Some(file) = text.strip_prefix("--formula=") {
            file.to_owned()
        } else {
            rest.push(word);
            continue;
        };
        let mut definition = read(&file)?;
        if definition == Definition::anonymous(&file) {
            let cure = "write a TOML file with `name` and `formula`, so that the predicate has a name";
            if definition.text.contains('=') && !definition.text.contains(';') {
                return Err(Failure::usage(format!("`{file}` is not a formula; {cure}")));
            }
            "formula".clone_into(&mut definition.name);
        }
        let formula = derive(definition)?;
        Derived::register(formula).map_err(|reason| Failure::usage(format!("{file}: {reason}")))?;
    }
    Ok(rest)
}
