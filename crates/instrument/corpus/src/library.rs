//! The suites of a folder, or the suites embedded in the tool.

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use include_dir::{Dir, include_dir};

use predicament_formats::{Cache, CorpusError, Manifest, read_suite, use_one_of};

use crate::{Level, LoadedScene, SeenIds, Suite, Vocabulary};

// In the repository this is a link to the folder; in a package it is the folder itself.
static EMBEDDED: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/corpora");

/// The files of a corpora folder that are not suites.
const COMPANIONS: [&str; 2] = [FETCH, "expected.toml"];
const FETCH: &str = "fetch.toml";

/// The suites and the fetch manifest of one corpora folder.
///
/// Suites are read on first use: a command about one suite reads no other.
#[derive(Clone, Debug)]
pub struct Library {
    files: Vec<File>,
    suites: Arc<OnceLock<Result<Vec<Suite>, CorpusError>>>,
    manifest: Manifest,
    folder: Option<PathBuf>,
    vocabulary: Vocabulary,
}

/// The text of a suite.
#[derive(Clone, Debug)]
struct File {
    /// The suite's name.
    name: String,
    /// The file's name in errors.
    shown: String,
    text: Cow<'static, str>,
}

impl Library {
    /// The suites in `corpora/`, as they were when the tool was built, not yet read.
    ///
    /// # Errors
    /// [`CorpusError`] if the fetch manifest is wrong.
    pub fn embedded(vocabulary: &Vocabulary) -> Result<Library, CorpusError> {
        let named = EMBEDDED.files().filter_map(|file| Some((file.path().to_str()?, file.contents_utf8()?)));
        let files = named.map(|(name, text)| (name.to_owned(), format!("corpora/{name}"), Cow::Borrowed(text)));
        Library::assemble(vocabulary, files.collect(), None)
    }

    /// The suites of a folder on disk, all of them read.
    ///
    /// # Errors
    /// [`CorpusError`] if the folder can't be read or a suite is wrong.
    pub fn from_dir(vocabulary: &Vocabulary, folder: &Path) -> Result<Library, CorpusError> {
        let unreadable = |path: &Path, error: std::io::Error| {
            CorpusError::usage(path.display().to_string(), error.to_string(), "name a readable folder of suites")
        };
        let mut files = Vec::new();
        for file in std::fs::read_dir(folder).map_err(|error| unreadable(folder, error))? {
            let path = file.map_err(|error| unreadable(folder, error))?.path();
            if path.extension().is_some_and(|extension| extension == "toml") {
                let text = read_suite(&path)?;
                let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
                files.push((name, path.display().to_string(), Cow::Owned(text)));
            }
        }
        let library = Library::assemble(vocabulary, files, Some(folder))?;
        library.suites()?;
        Ok(library)
    }

    /// A library of suites, each given as file name, name in errors, and text.
    fn assemble(
        vocabulary: &Vocabulary,
        mut files: Vec<(String, String, Cow<'static, str>)>,
        folder: Option<&Path>,
    ) -> Result<Library, CorpusError> {
        files.sort();
        let manifest = match files.iter().find(|(name, ..)| *name == FETCH) {
            Some((_, file, text)) => Manifest::parse(file, text)?,
            None => Manifest::default(),
        };
        let suites = files.into_iter().filter(|(name, ..)| !COMPANIONS.contains(&name.as_str()));
        let suites = suites
            .filter_map(|(name, shown, text)| Some(File { name: name.strip_suffix(".toml")?.to_owned(), shown, text }));
        Ok(Library {
            files: suites.collect(),
            suites: Arc::default(),
            manifest,
            folder: folder.map(Path::to_path_buf),
            vocabulary: vocabulary.clone(),
        })
    }

    fn read(&self, file: &File) -> Result<Suite, CorpusError> {
        Suite::parse(&self.vocabulary, &file.shown, &file.text, self.folder.as_deref(), &self.manifest)
    }

    /// The tasks that the suites can use.
    #[must_use]
    pub fn vocabulary(&self) -> &Vocabulary {
        &self.vocabulary
    }

    /// The names of the suites, in order. This does not read the suites.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(|file| file.name.as_str())
    }

    /// All suites in the order of their names, read on the first call.
    ///
    /// # Errors
    /// [`CorpusError`] if a suite is wrong, or two have a scene with the same content.
    pub fn suites(&self) -> Result<&[Suite], CorpusError> {
        let read = || {
            let mut seen = SeenIds::new();
            let mut suites = Vec::new();
            for file in &self.files {
                let suite = self.read(file)?;
                suite.check_ids(&mut seen)?;
                suites.push(suite);
            }
            Ok(suites)
        };
        self.suites.get_or_init(read).as_deref().map_err(Clone::clone)
    }

    /// The manifest of files that can be fetched.
    #[must_use]
    pub fn manifest(&self) -> &Manifest {
        &self.manifest
    }

    /// A suite by its name, or by the path of a TOML file.
    ///
    /// # Errors
    /// [`CorpusError`] if neither exists, or the file is wrong.
    pub fn suite(&self, name: &str) -> Result<Suite, CorpusError> {
        if let Some(at) = self.names().position(|known| known == name) {
            return match self.suites.get() {
                Some(Ok(suites)) => Ok(suites[at].clone()),
                _ => self.read(&self.files[at]),
            };
        }
        let path = Path::new(name);
        if path.extension().is_some_and(|extension| extension == "toml") {
            return Suite::from_file(&self.vocabulary, path, &self.manifest);
        }
        let known: Vec<_> = self.names().collect();
        Err(CorpusError::usage(name, "no suite has this name", format!("{}, or a TOML file", use_one_of(name, &known))))
    }

    /// A file beside the suites, such as `expected.toml`: its name in errors and its text; `None` if the file does not
    /// exist.
    ///
    /// # Errors
    /// [`CorpusError`] if the file exists but can't be read.
    pub fn companion(&self, name: &str) -> Result<Option<(String, String)>, CorpusError> {
        let Some(folder) = &self.folder else {
            let text = EMBEDDED.get_file(name).and_then(|file| file.contents_utf8());
            return Ok(text.map(|text| (format!("corpora/{name}"), text.to_owned())));
        };
        let path = folder.join(name);
        match std::fs::read_to_string(&path) {
            Ok(text) => Ok(Some((path.display().to_string(), text))),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(error) => {
                Err(CorpusError::file(path.display().to_string(), error.to_string(), "make the file readable"))
            }
        }
    }

    /// Loads every scene, one at a time, and calls `visit` with it; two scenes with the same content are an error.
    ///
    /// # Errors
    /// The first [`CorpusError`] of a scene.
    pub fn verify(&self, level: Level, cache: &Cache, mut visit: impl FnMut(&LoadedScene)) -> Result<(), CorpusError> {
        let mut seen = SeenIds::new();
        for scene in self.suites()?.iter().flat_map(|suite| &suite.scenes) {
            let loaded = scene.load(level, cache)?;
            seen.insert(scene, &loaded)?;
            visit(&loaded);
        }
        Ok(())
    }
}
