//! Content ids: a hash of a scene's content, independent of its name.

use std::collections::BTreeMap;

use predicament_formats::{CorpusError, Written, hex};
use predicament_predicates::{Construction, Scene, Vertex};
use sha2::{Digest, Sha256};

use crate::{Content, LoadedScene, SceneDef};

/// The content id of a scene: the first 16 hex digits of a SHA-256 over its canonical bytes, dimension, coordinate
/// bits, constructions if any, and content.
///
/// Names, tags and sources are not included, so that expectations and baselines survive renames. Negative zeros are
/// hashed as positive zeros: the two are the same point, and every predicate is a function of points.
#[must_use]
pub fn content_id(scene: &Scene, content: &dyn Content) -> String {
    let mut canon = Canon(Sha256::new());
    canon.bytes(b"predicament scene 1\n");
    canon.count(scene.dimension().count());
    canon.count(scene.coordinates().len());
    for &x in scene.coordinates() {
        // -0 + 0 is +0 in the default rounding; all other values stay.
        canon.bytes(&(x + 0.0).to_bits().to_le_bytes());
    }
    if !scene.constructions().is_empty() {
        canon.text("constructed");
        canon.count(scene.constructions().len());
        for construction in scene.constructions() {
            canon.construction(construction);
        }
    }
    if !scene.weights().is_empty() {
        canon.text("weights");
        for &weight in scene.weights() {
            canon.bytes(&(weight + 0.0).to_bits().to_le_bytes());
        }
    }
    content.canon(&mut canon);
    hex(&canon.0.finalize()[..8])
}

/// The content id of a scene with a truth of decimals: a hash of the id of its doubles and of its decimals.
pub(crate) fn written_id(id: &str, written: &Written) -> String {
    let mut canon = Canon(Sha256::new());
    canon.bytes(b"predicament decimals 1\n");
    canon.text(id);
    (0..written.numerators().len()).for_each(|at| canon.text(&written.text(at)));
    hex(&canon.0.finalize()[..8])
}

/// A digest of values, encoded so that adjacent values stay distinct.
pub struct Canon(Sha256);

impl Canon {
    fn bytes(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// Adds a number.
    ///
    /// # Panics
    /// If it has more than 64 bits.
    pub fn count(&mut self, n: usize) {
        self.bytes(&u64::try_from(n).expect("no machine has more").to_le_bytes());
    }

    /// Adds a text, preceded by its length.
    pub fn text(&mut self, text: &str) {
        self.count(text.len());
        self.bytes(text.as_bytes());
    }

    /// Adds vertices, preceded by their number.
    pub fn vertices(&mut self, vertices: &[Vertex]) {
        self.count(vertices.len());
        for vertex in vertices {
            self.count(vertex.index());
        }
    }

    fn construction(&mut self, construction: &Construction) {
        self.text(match construction {
            Construction::Ssi(_) => "ssi",
            Construction::Lpi { .. } => "lpi",
            Construction::Tpi(_) => "tpi",
            Construction::Ratio { .. } => "ratio",
        });
        for flat in construction.flats() {
            self.vertices(flat);
        }
        if let Construction::Ratio { share, .. } = construction {
            self.text(&share.to_string());
        }
    }
}

/// The ids seen so far. Two scenes of one library must differ in content, or an expectation for one would apply to
/// both.
#[derive(Clone, Debug, Default)]
pub struct SeenIds(BTreeMap<String, String>);

impl SeenIds {
    /// An empty set of ids.
    #[must_use]
    pub fn new() -> SeenIds {
        SeenIds::default()
    }

    /// Records a loaded scene and its definition.
    ///
    /// # Errors
    /// [`CorpusError`] if another scene with the same content was seen before.
    pub fn insert(&mut self, definition: &SceneDef, loaded: &LoadedScene) -> Result<(), CorpusError> {
        self.note(loaded.id.clone(), definition)
    }

    pub(crate) fn note(&mut self, id: String, definition: &SceneDef) -> Result<(), CorpusError> {
        let name = format!("{}/{}", definition.suite, definition.name);
        match self.0.get(&id) {
            Some(other) if *other != name => {
                let message = format!("scene `{name}` has the same content as `{other}` (id {id})");
                Err(CorpusError::file(&definition.file, message, "remove one of the two").at_line(definition.line))
            }
            _ => {
                self.0.insert(id, name);
                Ok(())
            }
        }
    }
}
