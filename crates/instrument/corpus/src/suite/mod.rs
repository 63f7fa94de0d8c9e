//! Suites: named lists of scenes, each a few lines of TOML.

mod generator;
mod scene;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use predicament_formats::{
    Cache, CorpusError, Decimals, Document, Entry, Field, Fields, Manifest, TableKind, read_suite, shown, use_one_of,
};

use crate::{SeenIds, Vocabulary};
pub use scene::SceneDef;

/// The keys of a suite.
pub(crate) static SUITE: TableKind =
    TableKind::new("suite", &["title", "description", "round", "truth", "scene", "generate"]);

/// A suite: the scenes of a TOML file, in the order of the file.
#[derive(Clone, Debug)]
pub struct Suite {
    /// The file's name without `.toml`.
    pub name: String,
    /// A heading for readers.
    pub title: String,
    /// A paragraph for readers.
    pub description: String,
    /// True if any scene needs data from `predicament corpus fetch`.
    pub needs_fetch: bool,
    /// The scenes.
    pub scenes: Vec<SceneDef>,
    file: String,
}

impl Suite {
    /// Reads a suite.
    ///
    /// Everything that needs no generator, no data file and no download is checked here: keys, tasks, families,
    /// coordinates, queries, and that scenes written in the file have different names and contents.
    ///
    /// `file` is the name in error messages; its stem is the suite's name. Data paths are relative to `base`; without a
    /// base (embedded suites) they are errors. `manifest` resolves fetch keys.
    ///
    /// # Errors
    /// [`CorpusError`] at the line that is wrong.
    pub fn parse(
        vocabulary: &Vocabulary,
        file: &str,
        text: &str,
        base: Option<&Path>,
        manifest: &Manifest,
    ) -> Result<Suite, CorpusError> {
        let name = Path::new(file).file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        if name.chars().any(char::is_control) {
            let message = format!("the suite's name `{}` has control characters", name.escape_debug());
            return Err(CorpusError::file(shown(file), message, "rename the file"));
        }
        let document = Document::new(file, text);
        let root = document.parse()?;
        let fields = Fields::new(&document, &SUITE, root.get_ref(), 0);
        let title = fields.required("title")?.string()?;
        let description = fields.string_or_empty("description")?;
        let round = fields.bool_or("round", false)?;
        let decimal = takes_decimals(&fields, false)?;
        let mut context = Context {
            suite: name.clone(),
            base: base.map(Path::to_path_buf),
            manifest,
            vocabulary,
            round,
            decimal,
            is_invalid: false,
            data: RefCell::default(),
        };
        let mut scenes = Vec::new();
        for (tables, kind, read) in [
            ("scene", &vocabulary.scene, scene::read as Read),
            ("generate", &vocabulary.generator, generator::read as Read),
        ] {
            for table in array(&fields, tables)? {
                let table = table.fields(kind)?;
                context.round = table.bool_or("round", round)?;
                context.decimal = takes_decimals(&table, decimal)?;
                context.is_invalid = tables == "scene" && table.bool_or("invalid", false)?;
                let decimals = Decimals::new(context.round).keeping(context.decimal);
                scenes.push(read(&context, table.reading(&decimals))?);
            }
        }
        fields.finish()?;
        scenes.sort_by_key(|scene: &SceneDef| scene.line);
        let needs_fetch = scenes.iter().any(SceneDef::needs_fetch);
        let suite = Suite { name, title, description, needs_fetch, scenes, file: file.to_owned() };
        suite.check_names()?;
        suite.check_ids(&mut SeenIds::new())?;
        Ok(suite)
    }

    /// Reads a suite from disk.
    ///
    /// # Errors
    /// [`CorpusError`] if the file can't be read, or as [`Suite::parse`].
    pub fn from_file(vocabulary: &Vocabulary, path: &Path, manifest: &Manifest) -> Result<Suite, CorpusError> {
        let file = path.display().to_string();
        let text = read_suite(path)?;
        Suite::parse(vocabulary, &file, &text, path.parent(), manifest)
    }

    /// The file's name in error messages.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.file
    }

    fn check_names(&self) -> Result<(), CorpusError> {
        let mut lines = BTreeMap::new();
        for scene in &self.scenes {
            if let Some(first) = lines.insert(&scene.name, scene.line) {
                return Err(CorpusError::file(
                    &self.file,
                    format!("the name `{}` is taken by the scene in line {first}", scene.name),
                    "give every scene of a suite its own `name`",
                )
                .at_line(scene.line));
            }
        }
        Ok(())
    }

    /// Checks that scenes written in the file differ in content from each other and from those in `seen`.
    pub(crate) fn check_ids(&self, seen: &mut SeenIds) -> Result<(), CorpusError> {
        for scene in &self.scenes {
            if let Some(id) = scene.inline_id() {
                seen.note(id.to_owned(), scene)?;
            }
        }
        Ok(())
    }
}

/// Reads a table of a suite.
type Read = fn(&Context<'_>, Fields<'_, '_>) -> Result<SceneDef, CorpusError>;

/// The context for reading a scene, besides the scene's own table.
pub struct Context<'m> {
    suite: String,
    base: Option<PathBuf>,
    manifest: &'m Manifest,
    vocabulary: &'m Vocabulary,
    round: bool,
    decimal: bool,
    is_invalid: bool,
    /// The data files that the scene has referred to so far.
    data: RefCell<Vec<DataName>>,
}

/// A data file that a scene refers to.
#[derive(Clone, Debug)]
pub(crate) enum DataName {
    /// A file beside the suite.
    Path(PathBuf),
    /// A file of a package.
    Fetched(Entry),
}

impl DataName {
    /// The file's name in error messages.
    pub(crate) fn shown(&self, cache: &Cache) -> String {
        match self {
            DataName::Path(path) => path.display().to_string(),
            DataName::Fetched(entry) => cache.path(entry).display().to_string(),
        }
    }
}

impl Context<'_> {
    /// True if decimals in the scene's data files that are not doubles are rounded to the nearest: the scene's `round`,
    /// else the suite's.
    #[must_use]
    pub fn round(&self) -> bool {
        self.round
    }

    /// True if the scene is marked as invalid input: its reader leaves out the checks that the judge repeats.
    #[must_use]
    pub fn is_invalid(&self) -> bool {
        self.is_invalid
    }

    /// The path of a data file beside the suite.
    ///
    /// # Errors
    /// If the suite is embedded: it has no files beside it.
    pub fn path(&self, field: &Field<'_, '_>) -> Result<PathBuf, CorpusError> {
        let name = field.str()?;
        match &self.base {
            Some(base) => {
                let path = base.join(name);
                self.data.borrow_mut().push(DataName::Path(path.clone()));
                Ok(path)
            }
            None => {
                Err(field
                    .error("an embedded suite has no files beside it", "use `fetch`, or run the suite from a folder"))
            }
        }
    }

    /// The manifest's entry for a fetch key.
    ///
    /// # Errors
    /// If the manifest has no such key.
    pub fn fetched(&self, key: &Field<'_, '_>) -> Result<Entry, CorpusError> {
        let name = key.str()?;
        let entry = self.manifest.entry(name).cloned().ok_or_else(|| {
            key.error(format!("fetch.toml has no key `{name}`"), "use a key of fetch.toml or add an entry there")
        })?;
        self.data.borrow_mut().push(DataName::Fetched(entry.clone()));
        Ok(entry)
    }
}

/// Reads `truth`: true for decimals, `inherited` if the key is missing.
fn takes_decimals(fields: &Fields<'_, '_>, inherited: bool) -> Result<bool, CorpusError> {
    let Some(field) = fields.get("truth") else { return Ok(inherited) };
    match field.str()? {
        "doubles" => Ok(false),
        "decimals" => Ok(true),
        other => Err(field.error(format!("`{other}` is no truth"), use_one_of(other, &["doubles", "decimals"]))),
    }
}

/// The tables of an array of tables; empty if the key is missing.
fn array<'d, 't>(fields: &Fields<'d, 't>, key: &'static str) -> Result<Vec<Field<'d, 't>>, CorpusError> {
    match fields.get(key) {
        None => Ok(Vec::new()),
        Some(field) => Ok(field.items(&format!("[[{key}]] tables"))?.collect()),
    }
}
