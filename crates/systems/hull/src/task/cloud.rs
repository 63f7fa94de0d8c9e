//! The keys `points` and `method`: the content of a hull's scene.

use crate::algorithm::{PlaneMethod, SpaceMethod};
use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Level, Parts, PointSource, Source, Spelled, spelled_points,
};
use predicament_formats::{Cache, CorpusError, Entry, Fields};
use predicament_predicates::{Dimension, Scene};

/// A method for finding a hull.
pub trait Method: Copy + Default + PartialEq + Eq + std::fmt::Debug + Send + Sync + 'static {
    /// The name of the task.
    const TASK: &'static str;
    /// The dimension of the task's points.
    const DIMENSION: Dimension;
    /// The methods with their names in suites; the first one is the default.
    const NAMES: [(&'static str, Self); 2];

    /// The method's name in suites.
    fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, method)| *method == self).map_or(Self::NAMES[0].0, |(name, _)| name)
    }
}

impl Method for PlaneMethod {
    const TASK: &'static str = "hull2d";
    const DIMENSION: Dimension = Dimension::Two;
    const NAMES: [(&'static str, PlaneMethod); 2] = [("chain", PlaneMethod::Chain), ("divide", PlaneMethod::Divide)];
}

impl Method for SpaceMethod {
    const TASK: &'static str = "hull3d";
    const DIMENSION: Dimension = Dimension::Three;
    const NAMES: [(&'static str, SpaceMethod); 2] =
        [("incremental", SpaceMethod::Incremental), ("divide", SpaceMethod::Divide)];
}

/// The content of a scene: all its vertices, and the method for their hull.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Cloud<M> {
    /// The number of points.
    pub points: usize,
    /// The method.
    pub method: M,
}

impl<M: Method> Content for Cloud<M> {
    fn count(&self) -> usize {
        self.points
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text(M::TASK);
        canon.text(self.method.name());
    }

    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let words = vec![("method", format!("\"{}\"", self.method.name()))];
        Some(Spelled { words, ..spelled_points(scene) })
    }
}

/// Reads `method`.
pub(super) fn method<M: Method>(fields: &Fields<'_, '_>) -> Result<M, CorpusError> {
    let Some(field) = fields.get("method") else { return Ok(M::default()) };
    let name = field.str()?;
    let known = M::NAMES.into_iter().find(|(known, _)| *known == name);
    known.map(|(_, method)| method).ok_or_else(|| {
        let names = M::NAMES.map(|(name, _)| name).join(" or ");
        field.error(format!("{} has no method `{name}`", M::TASK), format!("write {names}"))
    })
}

/// Reads `points` and `method`.
pub(super) fn read<M: Method>(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
    let method = method::<M>(fields)?;
    let asked = Asked { points: PointSource::read(context, &fields.required("points")?, fields.file())?, method };
    if asked.points.is_written() {
        // Nothing comes from the cache: everything is written out.
        return Ok(Source::Written(asked.load(Level::Quick, &Cache::new(""))?));
    }
    Ok(Source::elsewhere(asked))
}

/// Points, written out or in a data file beside the suite.
struct Asked<M> {
    points: PointSource,
    method: M,
}

impl<M: Method> Elsewhere for Asked<M> {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let (scene, notes) = self.points.scene(cache)?;
        if scene.dimension() != M::DIMENSION {
            let [wanted, found] = [M::DIMENSION, scene.dimension()].map(Dimension::count);
            let message = format!("{} takes points with {wanted} coordinates, not {found}", M::TASK);
            return Err(self.points.error(message, format!("give every point {wanted} coordinates")));
        }
        let cloud = Cloud { points: scene.len(), method: self.method };
        Ok(Parts { notes, ..Parts::new(scene, cloud) })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.points.entry()
    }
}
