//! The keys of the task: `map`, or `points` and `loops`; `probes`, and rules for more.

use predicament_corpus::{Context, Elsewhere, Level, Parts, PointSource};
use predicament_formats::{Cache, CorpusError, Entry, Fields, ImportNotes};
use predicament_predicates::Dimension;
use predicament_tasks::map_source::MapSource;

use super::content::Probing;
use super::probes::with_probes;

/// A map and the rules for its probes.
pub(super) struct ProbedMap {
    map: MapSource,
    probes: Option<PointSource>,
    probing: Probing,
}

impl ProbedMap {
    /// Reads `map`, or `points` and `loops`, and the rules for probes.
    pub(super) fn read(context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<ProbedMap, CorpusError> {
        let map = MapSource::of_scene(context, fields)?;
        let probes = fields.get("probes");
        let probes = probes.map(|field| PointSource::read(context, &field, fields.file())).transpose()?;
        Ok(ProbedMap { map, probes, probing: Probing::read(fields)? })
    }
}

/// The probes that a scene lists or has in a file, and the changes made by reading them.
fn given(probes: &PointSource, cache: &Cache) -> Result<(Vec<[f64; 2]>, ImportNotes), CorpusError> {
    let (dimension, coordinates, notes) = probes.coordinates(cache)?;
    if dimension == Dimension::Three {
        return Err(probes.error("`probes` have 3 coordinates each; maps need 2", "give each 2"));
    }
    if coordinates.iter().any(|x| !x.is_finite()) {
        return Err(probes.error("a coordinate that is not finite", "correct the probes"));
    }
    Ok((coordinates.as_chunks().0.to_vec(), notes))
}

impl Elsewhere for ProbedMap {
    fn load(&self, level: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let imported = self.map.map(cache)?;
        let mut notes = imported.notes;
        let mut probes = Vec::new();
        if let Some(source) = &self.probes {
            let (read, of_probes) = given(source, cache)?;
            notes.add(&of_probes);
            probes = read;
        }
        let parts = with_probes(imported.points, imported.map, &probes, self.probing, level);
        Ok(Parts { notes, ..parts })
    }

    fn fetch_entry(&self) -> Option<&Entry> {
        self.map.entry().or(self.probes.as_ref().and_then(PointSource::entry))
    }
}
