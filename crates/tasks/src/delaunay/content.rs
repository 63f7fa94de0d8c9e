//! `points`: what a scene of a Delaunay triangulation asks.

use predicament_corpus::{Canon, Content, Context, Elsewhere, Level, Parts, PointSource, Source};
use predicament_formats::{Cache, CorpusError, Fields};
use predicament_predicates::Dimension;

/// All vertices of a scene.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Sites {
    /// How many.
    pub points: usize,
}

impl Content for Sites {
    fn count(&self) -> usize {
        self.points
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("delaunay2d");
    }
}

/// Reads `points`.
pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let asked = Asked { points: PointSource::read(context, &fields.required("points")?, fields.file())? };
    if asked.points.is_written() {
        // Nothing is read from a cache: everything is written out.
        return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(asked))
}

/// Points, written out or in a data file beside the suite.
struct Asked {
    points: PointSource,
}

impl Elsewhere for Asked {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (scene, notes) = self.points.scene(cache)?;
        if scene.dimension() != Dimension::Two {
            let message = "delaunay2d takes points of 2 coordinates, not of 3";
            return Err(self.points.error(message, "give every point 2 coordinates"));
        }
        let sites = Sites { points: scene.len() };
        Ok(Parts { notes, ..Parts::new(scene, sites) })
    }
}
