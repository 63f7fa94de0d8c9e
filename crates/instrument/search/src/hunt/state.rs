//! A hunt written down: all that is needed to go on as if it had never stopped.

use crate::SearchError;
use predicament_corpus::{Heading, Level, Spelled, Suite, Vocabulary};
use predicament_formats::{Cache, Manifest};
use serde::{Deserialize, Serialize};

use super::heights::heights;
use super::population::{Island, Member, Population};

/// How far a hunt has come, and what it has found.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct State {
    /// Generations that are over.
    pub generations: u64,
    /// Scenes that were made: their numbers go up to this.
    pub scenes: u64,
    /// Scenes of these that backends have answered: the others were none of the task.
    pub evaluations: u64,
    /// Seeds that show what is wanted as they are: they are none of the hunt's finds, and left out.
    pub known: Vec<String>,
    /// The reason of a backend that has declined every scene of the first generation.
    pub declined: Option<String>,
    /// What was found.
    pub finds: Vec<Find>,
    islands: Vec<SavedIsland>,
    curious: Vec<SavedMember>,
}

/// A find.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Find {
    /// The finding.
    pub class: String,
    /// The check that shows it.
    pub check: String,
    /// The queries that it is about.
    pub query: String,
    /// What the backend answers.
    pub got: String,
    /// What is true.
    pub truth: String,
    /// The number of the scene in the hunt.
    pub number: u64,
    /// Scenes that backends had answered with the generation in which it was found.
    pub evaluations: u64,
    /// Seconds until then.
    pub seconds: f64,
    /// The numbers of the scenes that it was derived from.
    pub parents: Vec<u64>,
    /// Where it comes from, in words.
    pub story: String,
    /// The scene as it was found, and shrunk, as suites of one scene.
    pub found: String,
    /// The shrunk scene.
    pub shrunk: String,
    /// The content id of the shrunk scene.
    pub scene_id: String,
    /// Scenes that were looked at to shrink it.
    pub shrinking: u64,
    /// Points, constructions, items and what they name, before and after.
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

/// A scene as a suite of its own.
pub(super) fn text(spelled: &Spelled) -> String {
    spelled.suite("A hunt", Heading { name: "scene", ..Heading::default() })
}

/// The scene of such a suite.
///
/// # Errors
/// One line, where it is none, or of a task that cannot write it out.
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
    /// Whether everything in it can be read, for a hunt of this task.
    ///
    /// # Errors
    /// [`SearchError`] with the first find or scene that cannot be read.
    pub fn check(&self, vocabulary: &Vocabulary, task: &str) -> Result<(), SearchError> {
        for (at, find) in self.finds.iter().enumerate() {
            read(vocabulary, &find.shrunk).map_err(|why| SearchError::Find { number: at + 1, why: Box::new(why) })?;
        }
        self.population(vocabulary, heights(task).len()).map(drop)
    }

    /// Takes the population down.
    pub(super) fn save(&mut self, population: &Population) {
        let all = |members: &[Member]| members.iter().map(SavedMember::of).collect();
        self.curious = all(&population.curious);
        let island =
            |island: &Island| SavedIsland { members: all(&island.members), idle: island.idle, peak: island.peak };
        self.islands = population.islands.iter().map(island).collect();
    }

    /// The population as it was taken down; an empty one with so many islands before the first generation.
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
