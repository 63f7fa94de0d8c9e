//! All the suites of a folder, or those that the tool carries with it.

use std::path::{Path, PathBuf};

use include_dir::{Dir, include_dir};

use predicament_formats::{Cache, CorpusError, Manifest, read_suite};

use crate::{Level, LoadedScene, SeenIds, Suite, Vocabulary};

// A link to the folder of the repository; in a package it is the folder itself.
static EMBEDDED: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/corpora");

/// Files of a corpora folder that are no suites.
const COMPANIONS: [&str; 2] = [FETCH, "expected.toml"];
const FETCH: &str = "fetch.toml";

/// The suites and the fetch manifest of one corpora folder.
#[derive(Clone, Debug)]
pub struct Library {
    suites: Vec<Suite>,
    manifest: Manifest,
    folder: Option<PathBuf>,
    vocabulary: Vocabulary,
}

impl Library {
    /// The suites in `corpora/`, as they were when the tool was built.
    ///
    /// # Errors
    /// [`CorpusError`] where a suite is wrong.
    pub fn embedded(vocabulary: &Vocabulary) -> Result<Library, CorpusError> {
        let mut files: Vec<(String, String)> = EMBEDDED
            .files()
            .filter_map(|file| Some((file.path().to_str()?.to_owned(), file.contents_utf8()?.to_owned())))
            .collect();
        files.sort();
        let named = files.iter().map(|(name, text)| (name.as_str(), format!("corpora/{name}"), text.as_str()));
        Library::assemble(vocabulary, named.collect(), None)
    }

    /// The suites of a folder on disk.
    ///
    /// # Errors
    /// [`CorpusError`] where the folder can't be read or a suite is wrong.
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
                files.push((name, path.display().to_string(), text));
            }
        }
        files.sort();
        let named = files.iter().map(|(name, file, text)| (name.as_str(), file.clone(), text.as_str()));
        Library::assemble(vocabulary, named.collect(), Some(folder))
    }

    /// Suites from (file name, name in errors, text), sorted.
    fn assemble(
        vocabulary: &Vocabulary,
        files: Vec<(&str, String, &str)>,
        folder: Option<&Path>,
    ) -> Result<Library, CorpusError> {
        let manifest = match files.iter().find(|(name, ..)| *name == FETCH) {
            Some((_, file, text)) => Manifest::parse(file, text)?,
            None => Manifest::default(),
        };
        let mut suites = Vec::new();
        let mut seen = SeenIds::new();
        for (name, file, text) in files {
            if !COMPANIONS.contains(&name) && name.ends_with(".toml") {
                let suite = Suite::parse(vocabulary, &file, text, folder, &manifest)?;
                suite.check_ids(&mut seen)?;
                suites.push(suite);
            }
        }
        Ok(Library { suites, manifest, folder: folder.map(Path::to_path_buf), vocabulary: vocabulary.clone() })
    }

    /// The tasks that its suites can name.
    #[must_use]
    pub fn vocabulary(&self) -> &Vocabulary {
        &self.vocabulary
    }

    /// The suites in the order of their names.
    #[must_use]
    pub fn suites(&self) -> &[Suite] {
        &self.suites
    }

    /// What can be fetched.
    #[must_use]
    pub fn manifest(&self) -> &Manifest {
        &self.manifest
    }

    /// A suite by its name, or by the path of a TOML file.
    ///
    /// # Errors
    /// [`CorpusError`] where there is neither, or the file is wrong.
    pub fn suite(&self, name: &str) -> Result<Suite, CorpusError> {
        if let Some(suite) = self.suites.iter().find(|suite| suite.name == name) {
            return Ok(suite.clone());
        }
        let path = Path::new(name);
        if path.extension().is_some_and(|extension| extension == "toml") {
            return Suite::from_file(&self.vocabulary, path, &self.manifest);
        }
        let known: Vec<_> = self.suites.iter().map(|suite| suite.name.as_str()).collect();
        Err(CorpusError::usage(
            name,
            "no suite has this name",
            format!("use one of {}, or a TOML file", known.join(", ")),
        ))
    }

    /// A file beside the suites, such as `expected.toml`: the name to use in
    /// errors and the text; none where there is no such file.
    ///
    /// # Errors
    /// [`CorpusError`] where the file is there and can't be read.
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

    /// Loads every scene, one at a time, and hands it to `visit`; two scenes
    /// with the same content are an error.
    ///
    /// # Errors
    /// The first [`CorpusError`] of a scene.
    pub fn verify(&self, level: Level, cache: &Cache, mut visit: impl FnMut(&LoadedScene)) -> Result<(), CorpusError> {
        let mut seen = SeenIds::new();
        for scene in self.suites.iter().flat_map(|suite| &suite.scenes) {
            let loaded = scene.load(level, cache)?;
            seen.insert(scene, &loaded)?;
            visit(&loaded);
        }
        Ok(())
    }
}
