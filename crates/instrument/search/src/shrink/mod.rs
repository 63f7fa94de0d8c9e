//! Shrinking: the smallest scene that still shows a finding.
//!
//! A finding in a scene of 10^5 points says little to a person and makes a regression test slow. Shrinking tries
//! smaller scenes and keeps each that still shows the finding. First it removes everything that the finding does not
//! name. Then it removes items and vertices by halves, quarters and so on (delta debugging: Zeller and Hildebrandt
//! 2002), merges vertices, and simplifies coordinates. Each kept scene is [smaller](Size), so shrinking ends.

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

/// The limits of shrinking.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The maximum number of scenes evaluated.
    pub evaluations: u64,
}

/// The result of shrinking.
#[derive(Clone, Debug)]
pub struct Shrunk {
    /// The smallest scene.
    pub spelled: Spelled,
    /// The smallest scene, as it is read from its text.
    pub loaded: LoadedScene,
    /// The finding that it shows.
    pub finding: Finding,
    /// The number of scenes evaluated.
    pub evaluations: u64,
    /// The reason why shrinking ended.
    pub end: End,
}

/// The reason why shrinking ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum End {
    /// No smaller scene among those tried shows the finding.
    Smallest,
    /// The maximum number of scenes was evaluated.
    Evaluations,
    /// Shrinking was interrupted.
    Interrupted,
}

impl End {
    /// A short name for tables and files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            End::Smallest => "smallest",
            End::Evaluations => "evaluations",
            End::Interrupted => "interrupted",
        }
    }
}

/// A callback for each scene that is kept: it saves the scene, so that nothing is lost, and shows progress.
pub type Kept<'k> = dyn FnMut(&Spelled, &Finding, u64) + 'k;

/// Shrinks a scene to the smallest that still shows the finding.
///
/// `named` are the vertices of the finding. `evaluations` counts scenes that an interrupted process evaluated before.
///
/// # Errors
/// [`SearchError`] if the scene cannot be read from its text, or does not show the finding any more.
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
        // Scenes that the task refuses are cheap, and are not counted.
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

/// A running search.
type Search<'s> = Descent<'s, Spelled, Size>;

/// Repeats all steps until nothing changes.
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

    /// A witness that shows a finding a number of times, then is interrupted.
    struct Interrupted(Cell<u64>);

    impl Witness for Interrupted {
        fn look(&self, _: &LoadedScene) -> Result<Option<Finding>, Stop> {
            let left = self.0.get().checked_sub(1).ok_or(Stop::Interrupted)?;
            self.0.set(left);
            Ok(Some(Finding::plain(Class::SignFlip, "sign", Vec::new(), "+".to_owned(), "-".to_owned())))
        }
    }

    /// A search that is killed before it finds a smaller scene has saved something, and can be resumed.
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
