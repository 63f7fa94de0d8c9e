//! Data that a scene's table refers to: files beside the suite and downloads, and points from either.

use std::path::{Path, PathBuf};

use predicament_formats::points::ImportedPoints;
use predicament_formats::{
    Cache, Columns, CorpusError, Decimals, Entry, Field, ImportNotes, POINTS, Places, points, read_bytes, read_points,
    text_of,
};
use predicament_predicates::{Dimension, Scene, Vertex};

use crate::Context;

/// A data file that a suite refers to, and the line of the reference.
#[derive(Clone, Debug)]
pub struct Origin {
    place: OriginPlace,
    /// The suite's file and the line of the key.
    named: (String, usize),
}

#[derive(Clone, Debug)]
enum OriginPlace {
    /// A file beside the suite.
    Path(PathBuf),
    /// A file of a package.
    Fetched(Entry),
}

impl Origin {
    fn new(place: OriginPlace, field: &Field<'_, '_>) -> Origin {
        Origin { place, named: (field.file().to_owned(), field.line()) }
    }

    /// The file beside the suite that a key's value names.
    ///
    /// # Errors
    /// As [`Context::path`].
    pub fn path(context: &Context<'_>, field: &Field<'_, '_>) -> Result<Origin, CorpusError> {
        context.path(field).map(|path| Origin::new(OriginPlace::Path(path), field))
    }

    /// The file of a package that a key's value names.
    ///
    /// # Errors
    /// As [`Context::fetched`].
    pub fn fetched(context: &Context<'_>, field: &Field<'_, '_>) -> Result<Origin, CorpusError> {
        context.fetched(field).map(|entry| Origin::new(OriginPlace::Fetched(entry), field))
    }

    /// The file's name and its bytes.
    ///
    /// # Errors
    /// [`CorpusError`] at the suite's line if the file can't be read or was not fetched.
    pub fn bytes(&self, cache: &Cache) -> Result<(String, Vec<u8>), CorpusError> {
        match &self.place {
            OriginPlace::Path(path) => Ok((path.display().to_string(), self.opened(read_bytes(path))?)),
            OriginPlace::Fetched(entry) => {
                Ok((cache.path(entry).display().to_string(), self.opened(cache.bytes(entry))?))
            }
        }
    }

    /// The file's name and its text.
    ///
    /// # Errors
    /// As [`bytes`](Origin::bytes), and if it is not UTF-8.
    pub fn text(&self, cache: &Cache) -> Result<(String, String), CorpusError> {
        let (file, bytes) = self.bytes(cache)?;
        let text = text_of(&file, bytes)?;
        Ok((file, text))
    }

    /// The value that was read, or an error at the line that refers to the file.
    fn opened<T>(&self, read: Result<T, CorpusError>) -> Result<T, CorpusError> {
        let (file, line) = &self.named;
        read.map_err(|error| error.named_by(file, *line))
    }

    /// The path of a file beside the suite; `None` for a fetched file.
    fn beside(&self) -> Option<&Path> {
        match &self.place {
            OriginPlace::Path(path) => Some(path),
            OriginPlace::Fetched(_) => None,
        }
    }

    /// The manifest entry of a fetched file; `None` for a file beside the suite.
    #[must_use]
    pub fn entry(&self) -> Option<&Entry> {
        match &self.place {
            OriginPlace::Path(_) => None,
            OriginPlace::Fetched(entry) => Some(entry),
        }
    }
}

/// The `points` of a scene: written in the suite, `{ path = "…" }`, or `{ fetch = "…" }`, with `columns` of a CSV file.
#[derive(Clone, Debug)]
pub struct PointSource {
    file: String,
    line: usize,
    place: PointPlace,
}

#[derive(Clone, Debug)]
enum PointPlace {
    Written(Dimension, Vec<f64>),
    File { origin: Origin, columns: Option<Columns>, round: bool },
}

impl PointSource {
    /// Reads the value of `points`.
    ///
    /// # Errors
    /// [`CorpusError`] at the line that is wrong. Errors in a data file appear when it is loaded.
    pub fn read(context: &Context<'_>, field: &Field<'_, '_>, file: &str) -> Result<PointSource, CorpusError> {
        let place = if field.is_table() {
            let table = field.fields(&POINTS)?;
            let origin = match table.get("fetch") {
                Some(key) => Origin::fetched(context, &key)?,
                None => Origin::path(context, &table.required("path")?)?,
            };
            let columns = table.get("columns").map(|field| Columns::read(&field)).transpose()?;
            table.finish()?;
            PointPlace::File { origin, columns, round: context.round() }
        } else {
            let (dimension, coordinates) = read_points(field)?;
            PointPlace::Written(dimension, coordinates)
        };
        Ok(PointSource { file: file.to_owned(), line: field.line(), place })
    }

    /// An empty list of points, for scenes whose points come from elsewhere.
    #[must_use]
    pub fn none(dimension: Dimension) -> PointSource {
        PointSource { file: String::new(), line: 0, place: PointPlace::Written(dimension, Vec::new()) }
    }

    /// The manifest entry of the fetched file that holds the points, if any.
    #[must_use]
    pub fn entry(&self) -> Option<&Entry> {
        match &self.place {
            PointPlace::Written(..) => None,
            PointPlace::File { origin, .. } => origin.entry(),
        }
    }

    /// True if the points are written in the suite.
    #[must_use]
    pub fn is_written(&self) -> bool {
        matches!(self.place, PointPlace::Written(..))
    }

    /// The error about the points as a whole; for points in a file beside the suite, the message names that file.
    #[must_use]
    pub fn error(&self, message: impl Into<String>, cure: impl Into<String>) -> CorpusError {
        let mut message = message.into();
        if let PointPlace::File { origin, .. } = &self.place
            && let Some(path) = origin.beside().map(|path| path.display().to_string())
            && !message.contains(&path)
        {
            message = format!("with {path}: {message}");
        }
        CorpusError::file(&self.file, message, cure).at_line(self.line)
    }

    /// The points' dimension and coordinates, and counts of changes by their reader.
    ///
    /// # Errors
    /// [`CorpusError`] if the data file is missing or wrong.
    pub fn coordinates(&self, cache: &Cache) -> Result<(Dimension, Vec<f64>, ImportNotes), CorpusError> {
        let (points, _) = self.load(cache)?;
        Ok((points.dimension, points.coordinates, points.notes))
    }

    /// Loads the points; returns them with the name of their data file.
    fn load(&self, cache: &Cache) -> Result<(ImportedPoints, Option<String>), CorpusError> {
        match &self.place {
            PointPlace::Written(dimension, coordinates) => {
                let (dimension, coordinates) = (*dimension, coordinates.clone());
                let (places, notes) = (Places::default(), ImportNotes::default());
                Ok((ImportedPoints { dimension, coordinates, places, notes }, None))
            }
            PointPlace::File { origin, columns, round } => {
                let decimals = Decimals::new(*round);
                let (file, bytes) = origin.bytes(cache)?;
                let mut points = points::read_columns(&file, bytes, columns.as_ref(), &decimals)?;
                points.notes.rounded += decimals.rounded();
                Ok((points, Some(file)))
            }
        }
    }

    /// The points as a scene, and counts of changes by their reader.
    ///
    /// # Errors
    /// As [`coordinates`](PointSource::coordinates), and if the points make no scene.
    pub fn scene(&self, cache: &Cache) -> Result<(Scene, ImportNotes), CorpusError> {
        self.located(cache).map(|points| (points.scene, points.notes))
    }

    /// The points as a scene, with their positions in the data file.
    ///
    /// # Errors
    /// As [`scene`](PointSource::scene).
    pub fn located(&self, cache: &Cache) -> Result<LocatedPoints, CorpusError> {
        let (points, file) = self.load(cache)?;
        let scene = Scene::new(points.dimension, points.coordinates)
            .map_err(|error| self.error(error.to_string(), "correct the points"))?;
        Ok(LocatedPoints { scene, notes: points.notes, places: points.places, file })
    }
}

/// Points as a scene, with their positions in their data file.
#[derive(Clone, Debug)]
pub struct LocatedPoints {
    /// The points.
    pub scene: Scene,
    /// Counts of changes by the reader of the data file.
    pub notes: ImportNotes,
    places: Places,
    file: Option<String>,
}

impl LocatedPoints {
    /// The positions of these points, to be appended to a message about them; empty if they are not in a data file.
    #[must_use]
    pub fn places(&self, of: &[Vertex]) -> String {
        let Some(file) = &self.file else { return String::new() };
        let names: Vec<String> = of.iter().map(|v| self.places.point_name(v.index())).collect();
        format!(" (in {file}: {})", names.join(", "))
    }
}
