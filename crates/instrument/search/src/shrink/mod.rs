//! The smallest scene that still shows a finding.
//!
//! A finding in a scene of 10^5 points says little to a person and costs a regression test its time. Shrinking tries
//! smaller scenes and keeps each that still shows it: first what the finding does not name goes, then items and
//! vertices by halves, quarters and so on (delta debugging: Zeller and Hildebrandt 2002), then vertices that can be
//! merged, then the coordinates become simpler. What is kept is always [smaller](Size), so it ends.

pub mod descent;

mod numbers;
mod pieces;
mod size;

use std::collections::HashSet;
use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};

use predicament_corpus::{LoadedScene, Spelled, Vocabulary};
use predicament_predicates::Vertex;
use predicament_tasks::{Finding, Stop};

use crate::{SearchError, Witness};
use descent::{Descent, Evaluations};
pub use size::Size;

/// How much is tried.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Scenes that are looked at.
    pub evaluations: u64,
}

/// What came of shrinking.
#[derive(Clone, Debug)]
pub struct Shrunk {
    /// The smallest scene.
    pub spelled: Spelled,
    /// The same, as it is read from its text.
    pub loaded: LoadedScene,
    /// What it shows.
    pub finding: Finding,
    /// Scenes that were looked at.
    pub evaluations: u64,
    /// Why it ended.
    pub end: End,
}

/// Why shrinking ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum End {
    /// Nothing smaller that is tried shows the finding.
    Smallest,
    /// So many scenes were looked at as were allowed.
    Evaluations,
    /// It was interrupted.
    Interrupted,
}

impl End {
    /// A word for tables and files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            End::Smallest => "smallest",
            End::Evaluations => "evaluations",
            End::Interrupted => "interrupted",
        }
    }
}

/// Each scene that is kept, as it is found: to be written down, so that nothing is lost, and for progress.
pub type Kept<'k> = dyn FnMut(&Spelled, &Finding, u64) + 'k;

/// Shrinks a scene.
///
/// `named` are the vertices that the finding is about. `evaluations` that were made before, by a process that was
/// interrupted, count.
///
/// # Errors
/// [`SearchError`] where the scene cannot be read from its text, or does not show the finding any more.
pub fn shrink(
    vocabulary: &Vocabulary,
    witness: &dyn Witness,
    start: Spelled,
    named: &[Vertex],
    limits: Limits,
    evaluations: u64,
    kept: &mut Kept<'_>,
) -> Result<Shrunk, SearchError> {
    let loaded = start.loaded(vocabulary, NAME).map_err(SearchError::Start)?;
    let finding = witness.look(&loaded).map_err(|_| SearchError::Interrupted)?;
    let finding = finding.ok_or(SearchError::NotShown)?;
    kept(&start, &finding, evaluations);
    let (mut loaded, mut finding, mut tried) = (loaded, finding, HashSet::new());
    let mut shows = |candidate: &Spelled, evaluations: &mut Evaluations| {
        let mut hasher = DefaultHasher::new();
        candidate.table(predicament_corpus::Heading::default()).hash(&mut hasher);
        if !tried.insert(hasher.finish()) {
            return Ok(false);
        }
        // What the task refuses costs little, and is no scene.
        let Ok(read) = candidate.loaded(vocabulary, NAME) else { return Ok(false) };
        evaluations.count()?;
        let found = witness.look(&read).map_err(|stop| match stop {
            Stop::Interrupted | Stop::Timeout => End::Interrupted,
        })?;
        let Some(found) = found else { return Ok(false) };
        kept(candidate, &found, evaluations.made);
        (loaded, finding) = (read, found);
        Ok(true)
    };
    let evaluations = Evaluations { made: evaluations, most: limits.evaluations };
    let mut search = Search::new(start, Size::of, evaluations, &mut shows);
    let end = match all(&mut search, named) {
        Ok(()) => End::Smallest,
        Err(end) => end,
    };
    let (spelled, evaluations) = (search.best, search.evaluations.made);
    Ok(Shrunk { spelled, loaded, finding, evaluations, end })
}

const NAME: &str = "shrunk";

/// A search under way.
type Search<'s> = Descent<'s, Spelled, Size>;

/// Everything, until nothing changes.
fn all(search: &mut Search<'_>, named: &[Vertex]) -> Result<(), End> {
    pieces::focus(search, named)?;
    loop {
        let before = search.size.clone();
        pieces::drop_all(search)?;
        pieces::merge_all(search)?;
        numbers::simplify(search)?;
        if search.size == before {
            return Ok(());
        }
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use predicament_tasks::Class;

    use super::*;
    use crate::hunt;

    /// Shows a finding so many times, and is interrupted then.
    struct Interrupted(Cell<u64>);

    impl Witness for Interrupted {
        fn look(&self, _: &LoadedScene) -> Result<Option<Finding>, Stop> {
            let left = self.0.get().checked_sub(1).ok_or(Stop::Interrupted)?;
            self.0.set(left);
            Ok(Some(Finding::plain(Class::SignFlip, "sign", Vec::new(), "+".to_owned(), "-".to_owned())))
        }
    }

    /// What is killed before it finds a smaller scene has written something down, and can be gone on with.
    #[test]
    fn the_first_scene_is_kept_before_any_smaller_one_is_looked_at() {
        let text = "title = \"a\"\n[[scene]]\nname = \"own\"\ntask = \"orient2d\"\n\
            points = [[0, 0], [1, 0], [0, 1], [5, 5]]\nqueries = [[0, 1, 2]]\n";
        let start = hunt::read(predicament_bundle::vocabulary(), text).unwrap();
        for looks in 0..4 {
            let mut kept: Vec<(Spelled, u64)> = Vec::new();
            let witness = Interrupted(Cell::new(looks));
            let mut keep = |spelled: &Spelled, _: &Finding, evaluations| kept.push((spelled.clone(), evaluations));
            let limits = Limits { evaluations: 100 };
            let shrunk = shrink(predicament_bundle::vocabulary(), &witness, start.clone(), &[], limits, 7, &mut keep);
            if looks == 0 {
                assert!(matches!(shrunk, Err(SearchError::Interrupted)) && kept.is_empty());
                continue;
            }
            let shrunk = shrunk.unwrap();
            assert_eq!((shrunk.end, shrunk.evaluations), (End::Interrupted, 7 + looks));
            let counts: Vec<u64> = kept.iter().map(|(_, evaluations)| *evaluations).collect();
            assert_eq!(counts, (7..7 + looks).collect::<Vec<u64>>(), "the first, and each smaller one");
            assert_eq!((&kept[0].0, &kept[kept.len() - 1].0), (&start, &shrunk.spelled));
        }
    }
}
