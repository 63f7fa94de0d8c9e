//! Hunting: scenes are changed and recombined until one shows a finding.
//!
//! A corpus is a sample: it lacks the cases that nobody thought of. A hunt climbs. It keeps scenes that are high by
//! some [measure](Height) of how near they are to a disagreement, and scenes with new behaviour of a backend. It
//! derives more scenes from them by moves, and backends answer these. Its input is the backend, the task and the class,
//! not the place to search.
//!
//! Each scene is made from the hunt's seed, its generation and its index there, from the population at the start of the
//! generation. So the finds are the same on any number of threads, and a hunt that was stopped continues as if it had
//! not been.

mod climb;
mod heights;
mod look;
mod moves;
mod population;
mod seeds;
mod state;
mod twofold;

#[cfg(test)]
mod tests;

use predicament_corpus::{Random, Spelled};
use predicament_predicates::{Class, PredicateKind};
use predicament_tasks::{Finding, Stop};
use rayon::prelude::*;

use crate::shrink::{End, Limits, Size, shrink};
use crate::{SearchError, Wanted};
use climb::Climb;
use moves::Draft;
use population::{Member, Population};

pub use heights::{Height, heights};
pub use look::Quarry;
use seeds::shape;
pub use seeds::{Seed, has_shapes, seeds};
pub use state::{Find, State, read};

/// The options of a hunt.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Options {
    /// The seed of the random numbers.
    pub seed: u64,
    /// The number of finds after which the hunt ends.
    pub finds: usize,
    /// The maximum number of scenes evaluated to shrink each find.
    pub shrinking: u64,
    /// True if the hunt also starts from shapes of small integers, if the task has some.
    pub shapes: bool,
}

/// A running hunt.
pub struct Hunt<'a> {
    quarry: Quarry<'a>,
    options: Options,
    seeds: Vec<Seed>,
    population: Population,
    state: State,
}

/// The number of scenes in a generation from each island. The next two constants are the numbers of scenes from curious
/// scenes, and from seeds and shapes.
const FROM_ISLAND: usize = 6;
const FROM_CURIOUS: usize = 8;
const FROM_SEEDS: usize = 6;
/// The number of scenes of the rounding island that are climbed by rounding alone.
const CLIMBED: usize = 2;
/// The number of shapes in the first generation.
const SHAPES: usize = 24;
/// The name of a shape in a find's story.
const SHAPE: &str = "a shape of whole numbers";
/// The maximum number of moves in a find's story.
const STORY: usize = 12;

/// A new scene and its origin.
struct Child {
    spelled: Spelled,
    parents: Vec<u64>,
    story: Vec<String>,
}

impl<'a> Hunt<'a> {
    /// Starts a hunt, or resumes it from a saved state.
    ///
    /// # Errors
    /// One line, if the saved state is of another task, or there is nothing to start from.
    pub fn new(quarry: Quarry<'a>, options: Options, seeds: Vec<Seed>, state: State) -> Result<Hunt<'a>, SearchError> {
        let task = quarry.task.name();
        let population = state.population(quarry.vocabulary, heights(task).len())?;
        if seeds.is_empty() && !(options.shapes && has_shapes(task)) {
            return Err(SearchError::NoSeeds { task: task.to_owned() });
        }
        let mut hunt = Hunt { quarry, options, seeds, population, state };
        hunt.leave_out_known();
        Ok(hunt)
    }

    /// Removes seeds that already show the finding: scenes derived from them would not be finds.
    fn leave_out_known(&mut self) {
        let known = &self.state.known;
        self.seeds.retain(|seed| !known.contains(&seed.name));
    }

    /// The progress of the hunt.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// The state with the population, for saving.
    #[must_use]
    pub fn saved(&self) -> State {
        let mut state = self.state.clone();
        state.save(&self.population);
        state
    }

    /// True if the hunt has reached its number of finds.
    #[must_use]
    pub fn is_done(&self) -> bool {
        let nothing_left = self.seeds.is_empty() && self.shapes() == 0;
        self.state.finds.len() >= self.options.finds || nothing_left
    }

    /// The measures, each with the greatest height reached, in thousandths, and the number of that scene.
    pub fn peaks(&self) -> impl Iterator<Item = (Height, Option<(i64, u64)>)> {
        let measures = heights(self.quarry.task.name()).iter().copied();
        measures.zip(self.population.islands.iter().map(|island| island.peak))
    }

    /// Runs one generation: makes scenes, evaluates them, adds them to the population, and shrinks finds. `elapsed`
    /// returns the elapsed seconds.
    ///
    /// # Errors
    /// [`Stop::Interrupted`]; the hunt then has the state of before the generation.
    pub fn generation(&mut self, elapsed: &dyn Fn() -> f64) -> Result<(), Stop> {
        let first = self.state.generations == 0;
        let count = if first { self.seeds.len() + self.shapes() } else { self.places() };
        let children: Result<Vec<_>, Stop> = (0..count)
            .into_par_iter()
            .map(|place| {
                let child = if first { self.beginning(place) } else { self.child(place) };
                let seen = self.quarry.look(&child.spelled)?;
                Ok((child, seen))
            })
            .collect();
        let children = children?;
        // Changes are stored at the end, so that an interrupt changes nothing.
        let (mut state, mut population) = (self.state.clone(), self.population.clone());
        let mut candidates = Vec::new();
        let mut declined = Vec::new();
        if first {
            let shows =
                |(_, seen): &&(Child, Option<look::Seen>)| seen.as_ref().is_some_and(|seen| !seen.findings.is_empty());
            let known = children.iter().zip(&self.seeds).filter(|(child, _)| shows(child));
            state.known = known.map(|(_, seed)| seed.name.clone()).collect();
            state.known.dedup();
        }
        for (place, (child, seen)) in children.into_iter().enumerate() {
            state.scenes += 1;
            let Some(seen) = seen else { continue };
            state.evaluations += 1;
            declined.extend(seen.declined);
            let Child { parents, story, .. } = child;
            let (spelled, heights, conduct, number) = (seen.spelled, seen.heights, seen.conduct, state.scenes);
            if first && self.seeds.get(place).is_some_and(|seed| state.known.contains(&seed.name)) {
                continue;
            }
            let member = Member { spelled, heights, conduct, number, parents, story };
            population.add(&member);
            if !seen.findings.is_empty() {
                candidates.push((member, seen.findings));
            }
        }
        if first && declined.len() as u64 == state.evaluations {
            state.declined = declined.pop();
        }
        population.age();
        for (member, findings) in candidates {
            if state.finds.len() >= self.options.finds {
                break;
            }
            let Some(finding) = findings.iter().find(|finding| self.is_new(&state, finding)) else { continue };
            let Some(find) = self.shrunk(&member, finding, state.evaluations, elapsed)? else { continue };
            if state.finds.iter().all(|other| other.scene_id != find.scene_id || other.check != find.check) {
                state.finds.push(find);
                if self.pinned() {
                    population.scatter();
                    break;
                }
            }
        }
        state.generations += 1;
        (self.state, self.population) = (state, population);
        self.leave_out_known();
        Ok(())
    }

    /// True if a class and a check are given: then finds differ by their scenes only.
    fn pinned(&self) -> bool {
        self.quarry.wanted.class.is_some() && self.quarry.wanted.check.is_some()
    }

    /// True if a find like this is still wanted: one find for each class and check, or more if only that class and
    /// check are hunted.
    fn is_new(&self, state: &State, finding: &Finding) -> bool {
        let like = |find: &Find| find.class == finding.class.name() && find.check == finding.check;
        self.pinned() || !state.finds.iter().any(like)
    }

    fn shapes(&self) -> usize {
        if self.options.shapes && has_shapes(self.quarry.task.name()) { SHAPES } else { 0 }
    }

    /// The number of scenes in a generation.
    fn places(&self) -> usize {
        self.population.islands.len() * FROM_ISLAND + FROM_CURIOUS + FROM_SEEDS
    }

    fn random(&self, place: usize) -> Random {
        let stream = format!("hunt {} {place}", self.state.generations);
        Random::new(&stream, self.quarry.task.name(), self.options.seed)
    }

    /// An unchanged seed, or a shape.
    fn beginning(&self, place: usize) -> Child {
        let shape = || shape(self.quarry.task.name(), &mut self.random(place));
        match self.seeds.get(place) {
            Some(seed) => child_of(seed.spelled.clone(), seed.name.clone()),
            None => {
                shape().map_or_else(|| self.fresh(&mut self.random(place)), |shape| child_of(shape, SHAPE.to_owned()))
            }
        }
    }

    /// A seed or a shape to derive scenes from.
    fn fresh(&self, random: &mut Random) -> Child {
        let shape = if self.shapes() > 0 { shape(self.quarry.task.name(), random) } else { None };
        let last = i64::try_from(self.seeds.len()).unwrap_or(i64::MAX) - 1;
        match shape.filter(|_| self.seeds.is_empty() || random.one_in(2)) {
            Some(shape) => child_of(shape, SHAPE.to_owned()),
            None => {
                let seed = &self.seeds[usize::try_from(random.integer(0, last)).unwrap_or_default()];
                child_of(seed.spelled.clone(), seed.name.clone())
            }
        }
    }

    /// A scene derived from others, by its index in the generation.
    fn child(&self, place: usize) -> Child {
        let mut random = self.random(place);
        let islands = &self.population.islands;
        let island = islands.get(place / FROM_ISLAND);
        let members = match island {
            Some(island) if !island.members.is_empty() => island.members.as_slice(),
            _ => self.population.curious.as_slice(),
        };
        let is_fresh = place >= islands.len() * FROM_ISLAND + FROM_CURIOUS || members.is_empty();
        let on_rounding = place / FROM_ISLAND == heights::ROUNDING && island.is_some();
        let slot = place % FROM_ISLAND;
        // The first two slots of the rounding island climb; the first of them starts from a fresh scene.
        let climbs = on_rounding && slot < CLIMBED;
        let parent = if is_fresh || (climbs && slot == 0) {
            self.fresh(&mut random)
        } else {
            // On an island, higher scenes are more likely.
            let draw = if island.is_some() { random.unit() * random.unit() } else { random.unit() };
            derived(&members[at(draw, members.len())])
        };
        if climbs && let Some(child) = self.climbed(&parent, slot == 0, &mut random) {
            return child;
        }
        let mate = if random.one_in(3) { self.mate(&mut random) } else { None };
        let Child { spelled, mut parents, mut story } = parent;
        let mut draft = Draft { spelled, mate: mate.map(|mate| &mate.spelled), random: &mut random };
        let moves = draft.change();
        story.extend(moves.iter().map(|&name| name.to_owned()));
        parents.extend(mate.map(|mate| mate.number));
        Child { spelled: draft.spelled, parents, story: shortened(story) }
    }

    /// A random member of the population.
    fn mate(&self, random: &mut Random) -> Option<&Member> {
        let all: Vec<&Member> =
            self.population.islands.iter().flat_map(|island| &island.members).chain(&self.population.curious).collect();
        (!all.is_empty()).then(|| all[at(random.unit(), all.len())])
    }

    /// A scene in which one query is climbed by rounding alone; `None` if that cannot give the wanted class.
    fn climbed(&self, parent: &Child, anew: bool, random: &mut Random) -> Option<Child> {
        use Class::{Inconsistent, MissedZero, Overreach, SignFlip};
        let of_signs = self
            .quarry
            .wanted
            .class
            .is_none_or(|class| matches!(class, SignFlip | Overreach | MissedZero | Inconsistent));
        let kind = heights::kind_of(self.quarry.task.name())
            .filter(|&kind| !matches!(kind, PredicateKind::Compare | PredicateKind::Derived(_)) && of_signs)?;
        let loaded = parent.spelled.loaded(self.quarry.vocabulary, "climbed").ok()?;
        let content: &predicament_tasks::signs::SignQueries = loaded.content()?;
        let queries = &content.queries;
        if queries.is_empty() {
            return None;
        }
        let args = queries.args(at(random.unit(), queries.len()));
        let start = heights::points(&loaded.scene, queries.question(), args)?;
        let axes = heights::axes(queries.question());
        // Climbs get longer while nothing is found, but only in every fourth generation, because long climbs take most
        // of the time.
        let longest = (self.state.generations / 6).min(7);
        let doublings = if self.state.generations.is_multiple_of(4) { longest } else { longest.min(3) };
        let cost = match kind {
            PredicateKind::Orient3d | PredicateKind::Incircle => 3,
            PredicateKind::Insphere => 8,
            PredicateKind::Compare | PredicateKind::Orient2d | PredicateKind::Derived(_) => 1,
        };
        let steps = (6_000_u32 << doublings) / cost;
        let temperature = if anew { 0.1 } else { [0.0, 0.02, 0.1][at(random.unit(), 3)] };
        let climb = Climb { kind, dimension: axes.len(), steps, temperature };
        let end = climb.run(&start, random);
        let mut spelled = parent.spelled.clone();
        for (v, place) in args.iter().zip(&end) {
            for (&axis, &x) in axes.iter().zip(place) {
                spelled.points[v.index()][axis] = x;
            }
        }
        let mut story = parent.story.clone();
        story.push(format!("climbed {steps} steps by rounding"));
        Some(Child { spelled, parents: parent.parents.clone(), story: shortened(story) })
    }

    /// A find: the scene, and the smallest scene that shows the same. `None` if the scene does not show it again, for
    /// example after a time limit.
    fn shrunk(
        &self,
        member: &Member,
        finding: &Finding,
        evaluations: u64,
        elapsed: &dyn Fn() -> f64,
    ) -> Result<Option<Find>, Stop> {
        let seconds = elapsed();
        let witness = self.quarry.witness(Wanted::finding(finding.class, &finding.check));
        let named: Vec<_> = finding.queries.iter().flat_map(|query| query.vertices().collect::<Vec<_>>()).collect();
        let limits = Limits { evaluations: self.options.shrinking };
        let vocabulary = self.quarry.vocabulary;
        let done = shrink(vocabulary, &witness, member.spelled.clone(), &named, limits, 0, &mut |_, _, _| {});
        self.quarry.watch.done(0)?;
        let Ok(done) = done else { return Ok(None) };
        if done.end == End::Interrupted {
            return Err(Stop::Interrupted);
        }
        Ok(Some(Find {
            class: done.finding.class.name().to_owned(),
            check: done.finding.check.clone(),
            query: done.finding.query_text(),
            got: done.finding.got.clone(),
            truth: done.finding.truth.clone(),
            number: member.number,
            evaluations,
            seconds,
            parents: member.parents.clone(),
            story: member.story.join(", "),
            found: state::text(&member.spelled),
            shrunk: state::text(&done.spelled),
            scene_id: done.loaded.id.clone(),
            shrinking: done.evaluations,
            pieces: [&member.spelled, &done.spelled].map(|spelled| Size::of(spelled).pieces),
        }))
    }
}

/// An index below `count`, from a number between 0 and 1.
fn at(draw: f64, count: usize) -> usize {
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    // few, and not negative
    let place = (draw * count as f64) as usize;
    place.min(count.saturating_sub(1))
}

fn child_of(spelled: Spelled, name: String) -> Child {
    Child { spelled, parents: Vec::new(), story: vec![name] }
}

fn derived(member: &Member) -> Child {
    Child { spelled: member.spelled.clone(), parents: vec![member.number], story: member.story.clone() }
}

/// The origin and the last moves of a story.
fn shortened(mut story: Vec<String>) -> Vec<String> {
    if story.len() > STORY {
        let surplus = story.len() - STORY;
        story.drain(1..=surplus);
    }
    story
}
