//! The data of a new suite: where they are, which columns have the coordinates, and which tasks fit.

use std::path::{Path, PathBuf};

use predicament_formats::geometry::{self, Shape};
use predicament_formats::{Columns, CorpusError, Decimals, mesh, points, read_bytes, recognised_columns};
use predicament_predicates::Dimension;

use crate::exit::Failure;

/// A data file that a suite names.
pub struct Data {
    /// Its path as seen from the suite.
    pub path: String,
    /// The columns of the coordinates, where the suite has to say which they are.
    pub columns: Option<Columns>,
    /// Its path as seen from here; none where it is not there.
    place: Option<PathBuf>,
}

/// The kind of data, by the extension of the file.
enum Kind {
    Rows,
    Shapes,
    Mesh,
}

impl Data {
    /// Looks for a file beside the suite, then as seen from here, and at its header.
    pub fn find(suite: &Path, path: &str, columns: Option<Columns>) -> Result<Data, Failure> {
        let folder = suite.parent().unwrap_or(Path::new(""));
        let beside = folder.join(path);
        let (path, place) = if beside.is_file() {
            (path.to_owned(), Some(beside))
        } else if Path::new(path).is_file() {
            (seen_from(folder, Path::new(path)).map_err(Failure::io(Path::new(path)))?, Some(PathBuf::from(path)))
        } else {
            (path.to_owned(), None)
        };
        let mut data = Data { path, columns, place };
        if let (None, Some(place)) = (&data.columns, &data.place) {
            let found = recognised_columns(&place.display().to_string(), read_bytes(place)?)?;
            data.columns = found.map(|found| found.columns);
        }
        Ok(data)
    }

    /// Whether the file is there.
    pub fn is_there(&self) -> bool {
        self.place.is_some()
    }

    fn kind(&self) -> Kind {
        let lower = self.path.to_lowercase();
        let name = lower.strip_suffix(".gz").unwrap_or(&lower);
        let ends = |all: &[&str]| all.iter().any(|end| name.ends_with(end));
        if ends(&[".geojson", ".json", ".wkt"]) {
            Kind::Shapes
        } else if ends(&[".off", ".obj", ".ply", ".stl"]) {
            Kind::Mesh
        } else {
            Kind::Rows
        }
    }

    /// The tasks that fit, the best one first.
    ///
    /// # Errors
    /// The reason why the file is refused.
    pub fn tasks(&self) -> Result<&'static [&'static str], CorpusError> {
        let Some(place) = &self.place else { return Ok(&[]) };
        let (file, bytes, decimals) = (place.display().to_string(), read_bytes(place)?, Decimals::new(true));
        Ok(match self.kind() {
            Kind::Rows => of_points(points::read_columns(&file, bytes, self.columns.as_ref(), &decimals)?.dimension),
            Kind::Mesh => match mesh::read(&file, bytes, &decimals)?.triangles.is_empty() {
                true => of_points(Dimension::Three),
                false => &["mesh-locate", "slice", "contacts3d", "hull3d", "orient3d"],
            },
            Kind::Shapes => {
                let geometry = geometry::read(&file, bytes, &decimals)?;
                let shapes = || geometry.features.iter().flat_map(|feature| &feature.shapes);
                let is_point = |shape: &Shape| matches!(shape, Shape::Point(_));
                if shapes().all(is_point) {
                    of_points(geometry.points()?.0)
                } else if shapes().all(|shape| matches!(shape, Shape::Polygon(_))) {
                    &["polygon-locate"]
                } else if shapes().all(|shape| matches!(shape, Shape::Line(_))) {
                    &["crossings"]
                } else {
                    &["contacts2d"]
                }
            }
        })
    }

    /// An error about a suite that is not written, as an error about its data.
    pub fn own(&self, why: CorpusError, suite: &Path) -> CorpusError {
        let Some(place) = self.place.as_ref().filter(|_| why.file == suite.display().to_string()) else { return why };
        let file = place.display().to_string();
        let message = why.message.strip_prefix(&format!("with {file}: ")).unwrap_or(&why.message).to_owned();
        CorpusError { message, ..CorpusError::file(file, "", why.cure) }
    }
}

fn of_points(dimension: Dimension) -> &'static [&'static str] {
    match dimension {
        Dimension::Two => &["orient2d"],
        Dimension::Three => &["orient3d"],
    }
}

/// The path of a file as a suite in a folder names it: from the folder if the file is in it, else from the root.
fn seen_from(folder: &Path, file: &Path) -> std::io::Result<String> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let file = file.canonicalize()?;
    let inside = folder.canonicalize().ok().and_then(|folder| file.strip_prefix(folder).ok().map(Path::to_path_buf));
    Ok(inside.unwrap_or(file).display().to_string())
}
