//! Parameters of engines: what a library lets its users set, declared in `engine.toml`, set in the name of a backend.
//!
//! `engine:NAME:key=value` starts the engine with the value in an environment variable. A parameter declares its range
//! and the values of a sweep, so that a comparison can draw its curve.

use predicament_formats::{CorpusError, Field, TableKind, use_one_of};

use crate::{Config, EngineError, EngineFailure};

static PARAMETER: TableKind =
    TableKind::new("parameter", &["about", "variable", "from", "to", "words", "default", "sweep"]);

/// A parameter of an engine.
#[derive(Clone, PartialEq, Debug)]
pub struct Parameter {
    /// Its name in `engine:NAME:key=value`.
    pub key: String,
    /// A one-line description.
    pub about: String,
    /// The environment variable that the engine reads.
    pub variable: String,
    /// The valid values.
    pub range: Range,
    /// The value if none is set, as text; empty if the library chooses.
    pub default: String,
    /// The values of a sweep, in its order.
    pub sweep: Vec<String>,
}

/// The valid values of a parameter.
#[derive(Clone, PartialEq, Debug)]
pub enum Range {
    /// Numbers, both ends included.
    Numbers(f64, f64),
    /// Words.
    Words(Vec<String>),
}

impl Range {
    /// The reason why a text is not a valid value.
    fn refuse(&self, text: &str) -> Option<String> {
        match self {
            Range::Numbers(from, to) => {
                let is_within = text.parse().is_ok_and(|x: f64| (*from..=*to).contains(&x));
                (!is_within).then(|| format!("choose a number from {from:?} to {to:?}"))
            }
            Range::Words(words) => {
                let known: Vec<&str> = words.iter().map(String::as_str).collect();
                (!known.contains(&text)).then(|| use_one_of(text, &known))
            }
        }
    }
}

/// Reads the table of a parameter.
pub(crate) fn read(field: &Field<'_, '_>) -> Result<Parameter, CorpusError> {
    let (key, table) = (field.key().to_owned(), field.fields(&PARAMETER)?);
    if key.is_empty() || !key.chars().all(|c| c.is_ascii_alphanumeric() || c == '-') {
        return Err(field.error(format!("`{key}` is no name of a parameter"), "use letters, digits and `-`"));
    }
    let text = |field: &Field<'_, '_>| field.coordinate_text().map(str::to_owned);
    let number = |field: Field<'_, '_>| -> Result<f64, CorpusError> {
        let number = text(&field)?.parse().ok().filter(|x: &f64| x.is_finite());
        number.ok_or_else(|| field.error(format!("`{}` is no number", field.key()), "write a finite number"))
    };
    let range = match table.get("words") {
        Some(words) => Range::Words(words.strings()?),
        None => Range::Numbers(number(table.required("from")?)?, number(table.required("to")?)?),
    };
    let parameter = Parameter {
        about: table.string_or_empty("about")?,
        variable: table.get("variable").map_or_else(
            || Ok(format!("PREDICAMENT_{}", key.to_ascii_uppercase().replace('-', "_"))),
            |field| field.string(),
        )?,
        default: table.get("default").map_or(Ok(String::new()), |field| text(&field))?,
        sweep: match table.get("sweep") {
            Some(values) => values.items("an array of values")?.map(|value| text(&value)).collect::<Result<_, _>>()?,
            None => Vec::new(),
        },
        range,
        key,
    };
    table.finish()?;
    for value in parameter.sweep.iter().chain(Some(&parameter.default).filter(|value| !value.is_empty())) {
        if let Some(cure) = parameter.range.refuse(value) {
            return Err(field.error(format!("`{}` has the value `{value}`", parameter.key), cure));
        }
    }
    Ok(parameter)
}

/// The name or file of an engine, and its settings: `key=value` after colons.
#[must_use]
pub fn split(name: &str) -> (&str, Option<&str>) {
    let is_settings = |at: &usize| name[at + 1..].split(':').all(|setting| setting.contains('='));
    let at = name.match_indices(':').map(|(at, _)| at).find(is_settings);
    at.map_or((name, None), |at| (&name[..at], Some(&name[at + 1..])))
}

impl Config {
    /// The configuration with these settings, `key=value` with colons between them; they become part of its name.
    ///
    /// # Errors
    /// [`EngineError`] with the declared parameters, or with the valid values.
    pub fn with_settings(mut self, settings: &str) -> Result<Config, EngineError> {
        for setting in settings.split(':') {
            let (key, value) = setting.split_once('=').unwrap_or((setting, ""));
            let Some(parameter) = self.parameters.iter().find(|parameter| parameter.key == key) else {
                let known: Vec<&str> = self.parameters.iter().map(|parameter| parameter.key.as_str()).collect();
                let cure = if known.is_empty() { "it declares none".to_owned() } else { use_one_of(key, &known) };
                return Err(self.error(EngineFailure::Setting(format!("it has no parameter `{key}`; {cure}"))));
            };
            if let Some(cure) = parameter.range.refuse(value) {
                return Err(self.error(EngineFailure::Setting(format!("{key} is `{value}`; {cure}"))));
            }
            self.environment.insert(parameter.variable.clone(), value.to_owned());
            self.name = format!("{}:{key}={value}", self.name);
        }
        Ok(self)
    }
}

/// The names of a sweep: `NAME:key=*` becomes a name for each value that the engine declares, other names stay.
///
/// # Errors
/// [`EngineError`] if there is no such engine, or it declares no such parameter or no sweep for it.
pub fn swept(name: &str) -> Result<Vec<String>, EngineError> {
    let Some((engine, key)) = name.strip_suffix("=*").and_then(|name| name.rsplit_once(':')) else {
        return Ok(vec![name.to_owned()]);
    };
    let config = crate::find(engine)?;
    let found = config.parameters.iter().find(|parameter| parameter.key == key && !parameter.sweep.is_empty());
    let values = found.map(|parameter| parameter.sweep.iter().map(|value| format!("{engine}:{key}={value}")).collect());
    values.ok_or_else(|| config.error(EngineFailure::Setting(format!("it declares no sweep of `{key}`; name values"))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_split_from_settings() {
        assert_eq!(split("geos"), ("geos", None));
        assert_eq!(split("geos:grid=1e-3"), ("geos", Some("grid=1e-3")));
        assert_eq!(split("a/engine.toml:grid=1:mode=x"), ("a/engine.toml", Some("grid=1:mode=x")));
        assert_eq!(split("C:/a/engine.toml:grid=1"), ("C:/a/engine.toml", Some("grid=1")));
    }

    #[test]
    fn settings_are_checked_and_become_part_of_the_name() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(crate::FILE);
        let text = "name = \"mine\"\nrun = [\"./engine\"]\n[parameters.grid]\nfrom = 0\nto = 1\nsweep = [1e-9, 0.5]\n\
                    [parameters.mode]\nwords = [\"fast\", \"safe\"]\nvariable = \"MODE\"\n";
        std::fs::write(&file, text).unwrap();
        let name = file.display().to_string();
        let config = crate::find(&format!("{name}:grid=0.25:mode=safe")).unwrap();
        assert_eq!(config.name, "mine:grid=0.25:mode=safe");
        assert_eq!(config.environment["PREDICAMENT_GRID"], "0.25");
        assert_eq!(config.environment["MODE"], "safe");
        let swept_names = swept(&format!("{name}:grid=*")).unwrap();
        assert_eq!(swept_names, ["1e-9", "0.5"].map(|value| format!("{name}:grid={value}")));
        for (settings, said) in [
            ("grid=2", "grid is `2`; choose a number from 0.0 to 1.0"),
            ("grid=x", "grid is `x`"),
            ("mode=slow", "mode is `slow`; use one of fast, safe"),
            ("step=1", "it has no parameter `step`"),
        ] {
            let error = crate::find(&format!("{name}:{settings}")).unwrap_err().to_string();
            assert!(error.contains(said), "{error}");
        }
        assert!(swept(&format!("{name}:mode=*")).unwrap_err().to_string().contains("no sweep of `mode`"));
    }

    #[test]
    fn a_sweep_outside_of_the_range_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(crate::FILE);
        let text = "name = \"mine\"\nrun = [\"b\"]\n[parameters.grid]\nfrom = 0\nto = 1\nsweep = [3]\n";
        std::fs::write(&file, text).unwrap();
        let error = Config::read(&file).unwrap_err().to_string();
        assert!(error.contains("`grid` has the value `3`; choose a number from 0.0 to 1.0"), "{error}");
    }
}
