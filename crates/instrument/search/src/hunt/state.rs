//! The saved state of a hunt: everything needed to resume it as if it had never stopped.

use crate::SearchError;
use predicament_corpus::{Heading, Level, Spelled, Suite, Vocabulary};
use predicament_formats::{Cache, Manifest};
use serde::{Deserialize, Serialize};

use super::heights::heights;
use super::population::{Island, Member, Population};

/// The progress of a hunt, and its finds.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct State {
    /// The number of completed generations.
    pub generations: u64,
    /// The number of scenes made; scenes are numbered up to it.
    pub scenes: u64,
    /// The number of these scenes that backends have answered; the others were not scenes of the task.
    pub evaluations: u64,
    /// Seeds that show the wanted finding unchanged: they are not finds, and are left out.
    pub known: Vec<String>,
    /// The reason of a backend that has declined every scene of the first generation.
    pub declined: Option<String>,
    /// The finds.
    pub finds: Vec<Find>,
    islands: Vec<SavedIsland>,
    curious: Vec<SavedMember>,
}

/// A find.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Find {
    /// The finding's class.
    pub class: String,
    /// The check that shows it.
    pub check: String,
    /// The queries that it is about.
    pub query: String,
    /// The backend's answer.
    pub got: String,
    /// The true answer.
    pub truth: String,
    /// The number of the scene in the hunt.
    pub number: u64,
    /// The number of scenes that backends had answered at the end of the find's generation.
    pub evaluations: u64,
    /// The seconds until the find.
    pub seconds: f64,
    /// The numbers of the scenes that it was derived from.
    pub parents: Vec<u64>,
    /// The scene's origin, in words.
    pub story: String,
    /// The scene as it was found, as a suite of one scene.
    pub found: String,
    /// The shrunk scene, as a suite of one scene.
    pub shrunk: String,
    /// The content id of the shrunk scene.
    pub scene_id: String,
    /// The number of scenes evaluated to shrink it.
    pub shrinking: u64,
    /// The number of points, constructions, items and vertices named by them, before and after shrinking.
    pub pieces: [usize; 2],
}

#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
struct SavedMember {
    scene: String,
    heights: Vec<i64>,
    conduct: u64,
    number: u64,
    parents: Vec<u64>,
    story: Vec<String>,
}

#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
struct SavedIsland {
    members: Vec<SavedMember>,
    idle: u64,
    peak: Option<(i64, u64)>,
}

/// Writes a scene as a suite of one scene.
pub(super) fn text(spelled: &Spelled) -> String {
    spelled.suite("A hunt", Heading { name: "scene", ..Heading::default() })
}

/// Reads the scene of such a suite.
///
/// # Errors
/// One line, if the text is not such a suite, or its task cannot write it out.
pub fn read(vocabulary: &Vocabulary, text: &str) -> Result<Spelled, SearchError> {
    let suite = Suite::parse(vocabulary, "hunt", text, None, &Manifest::default()).map_err(SearchError::Scene)?;
    let [def] = suite.scenes.as_slice() else { return Err(SearchError::NotOneScene) };
    let loaded = def.load(Level::Quick, &Cache::new("")).map_err(SearchError::Scene)?;
    loaded.spelled().ok_or_else(|| SearchError::NotWritten { task: def.task.to_string() })
}

impl SavedMember {
    fn of(member: &Member) -> SavedMember {
        let Member { spelled, heights, conduct, number, parents, story } = member.clone();
        SavedMember { scene: text(&spelled), heights, conduct, number, parents, story }
    }

    fn member(&self, vocabulary: &Vocabulary) -> Result<Member, SearchError> {
        let SavedMember { scene, heights, conduct, number, parents, story } = self.clone();
        let spelled = read(vocabulary, &scene).map_err(|why| SearchError::Member { number, why: Box::new(why) })?;
        Ok(Member { spelled, heights, conduct, number, parents, story })
    }
}

impl State {
    /// Checks that everything in the state can be read, for a hunt of this task.
    ///
    /// # Errors
    /// [`SearchError`] with the first find or scene that cannot be read.
    pub fn check(&self, vocabulary: &Vocabulary, task: &str) -> Result<(), SearchError> {
        for (at, find) in self.finds.iter().enumerate() {
            read(vocabulary, &find.shrunk).map_err(|why| SearchError::Find { number: at + 1, why: Box::new(why) })?;
        }
        self.population(vocabulary, heights(task).len()).map(drop)
    }

    /// Stores the population in the state.
    pub(super) fn save(&mut self, population: &Population) {
        let all = |members: &[Member]| members.iter().map(SavedMember::of).collect();
        self.curious = all(&population.curious);
        let island =
            |island: &Island| SavedIsland { members: all(&island.members), idle: island.idle, peak: island.peak };
        self.islands = population.islands.iter().map(island).collect();
    }

    /// The saved population; before the first generation, an empty one with `measures` islands.
    pub(super) fn population(&self, vocabulary: &Vocabulary, measures: usize) -> Result<Population, SearchError> {
        if self.islands.is_empty() {
            return Ok(Population::new(measures));
        }
        let all = |members: &[SavedMember]| -> Result<Vec<Member>, SearchError> {
            members.iter().map(|member| member.member(vocabulary)).collect()
        };
        let island = |saved: &SavedIsland| -> Result<Island, SearchError> {
            Ok(Island { members: all(&saved.members)?, idle: saved.idle, peak: saved.peak })
        };
        if self.islands.len() != measures {
            return Err(SearchError::Islands { found: self.islands.len(), measures });
        }
        let islands = self.islands.iter().map(island).collect::<Result<_, _>>()?;
        Ok(Population { islands, curious: all(&self.curious)? })
    }
}
