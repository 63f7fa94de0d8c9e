//! Judgements that occur in two of the exported folders, so that a sum over a table counts each error once.
//!
//! A bench stores the judgement of the answers that it times, usually the judgement of a run beside it. Among folders
//! of the same build of the tool, a bench's row about a scene and a backend that a run has judged is a copy.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use predicament_records::{Error, RunFolder};

use crate::Found;

/// The columns that identify a scene on a backend; only tables with all four columns have such rows.
const KEY: [&str; 4] = ["suite", "scene", "scene_id", "backend"];
/// Tables of times, which a run does not have.
const OWN: [&str; 2] = ["phases.csv", "costs.csv"];

/// The scenes and backends that runs have judged, by build.
#[derive(Default)]
pub(crate) struct Copies(HashSet<u64>);

impl Copies {
    /// Reads the judgements of the runs among these folders; empty if there is no bench that may have copies.
    pub fn of(runs: &[Found]) -> Result<Copies, Error> {
        let folders = runs.iter().map(|found| RunFolder::open(&found.path)).collect::<Result<Vec<_>, _>>()?;
        let mut judged = HashSet::new();
        if folders.iter().any(|folder| folder.plan.timed) {
            for folder in folders.iter().filter(|folder| !folder.plan.timed) {
                let mut places = None;
                folder.each_row("summary.csv", |line, record| {
                    if line == 1 {
                        places = places_of(&record.iter().collect::<Vec<_>>());
                    } else if let Some(places) = places {
                        judged.insert(digest(folder, places, |place| record.get(place)));
                    }
                    Ok(())
                })?;
            }
        }
        Ok(Copies(judged))
    }

    /// The positions of the key columns in a table of this folder, if it can have copies.
    pub fn places(&self, folder: &RunFolder, file: &str, columns: &[&str]) -> Option<[usize; 4]> {
        if self.0.is_empty() || !folder.plan.timed || OWN.contains(&file) { None } else { places_of(columns) }
    }

    /// True if a row, with its key cells at these positions, is a copy.
    pub fn has<'c>(&self, folder: &RunFolder, places: [usize; 4], cell: impl Fn(usize) -> Option<&'c str>) -> bool {
        self.0.contains(&digest(folder, places, cell))
    }
}

fn places_of(columns: &[&str]) -> Option<[usize; 4]> {
    let place = |key: &str| columns.iter().position(|column| *column == key);
    Some([place(KEY[0])?, place(KEY[1])?, place(KEY[2])?, place(KEY[3])?])
}

/// A 64-bit hash of the build and of the key cells. Two of a million rows collide in one of 30 million exports.
fn digest<'c>(folder: &RunFolder, places: [usize; 4], cell: impl Fn(usize) -> Option<&'c str>) -> u64 {
    let mut hasher = DefaultHasher::new();
    (&folder.env.commit, folder.env.dirty, &folder.plan.created_by, folder.plan.level).hash(&mut hasher);
    places.map(cell).hash(&mut hasher);
    hasher.finish()
}
