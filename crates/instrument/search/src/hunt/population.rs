//! The population of a hunt: an island of scenes for each measure, and scenes with unusual behaviour.

use predicament_corpus::Spelled;

/// A scene and its evaluation.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub spelled: Spelled,
    /// The scene's height by each measure.
    pub heights: Vec<i64>,
    /// A hash of the scene's behaviour.
    pub conduct: u64,
    /// The number of the scene in its hunt, from 1.
    pub number: u64,
    /// The numbers of the scenes that it was derived from.
    pub parents: Vec<u64>,
    /// The suite's scene at its origin, and the last moves.
    pub story: Vec<String>,
}

/// Scenes that are high by one measure.
#[derive(Clone, Debug, Default)]
pub(super) struct Island {
    /// The members, highest first, all of different height.
    pub members: Vec<Member>,
    /// Generations since the last rise.
    pub idle: u64,
    /// The greatest height ever reached on the island, and the number of that scene.
    pub peak: Option<(i64, u64)>,
}

/// The maximum number of members of an island.
const MEMBERS: usize = 12;
/// The maximum number of scenes that are kept for their behaviour.
const CURIOUS: usize = 192;
/// The number of generations without a rise after which an island is cleared.
const PATIENCE: u64 = 60;

/// All islands and curious scenes.
#[derive(Clone, Debug, Default)]
pub(super) struct Population {
    pub islands: Vec<Island>,
    /// Scenes with new behaviour, the latest last.
    pub curious: Vec<Member>,
}

impl Population {
    pub(super) fn new(measures: usize) -> Population {
        Population { islands: vec![Island::default(); measures], curious: Vec::new() }
    }

    /// Adds a scene if it is high enough, or shows new behaviour.
    pub(super) fn add(&mut self, member: &Member) {
        for (measure, island) in self.islands.iter_mut().enumerate() {
            island.add(measure, member);
        }
        if self.curious.iter().all(|other| other.conduct != member.conduct) {
            self.curious.push(member.clone());
            if self.curious.len() > CURIOUS {
                self.curious.remove(0);
            }
        }
    }

    /// Ends a generation: clears islands without a recent rise, which restart from other scenes.
    pub(super) fn age(&mut self) {
        for island in &mut self.islands {
            island.idle += 1;
            if island.idle > PATIENCE {
                island.members.clear();
                island.idle = 0;
            }
        }
    }

    /// Clears all islands, so that the next find comes from elsewhere.
    pub(super) fn scatter(&mut self) {
        for island in &mut self.islands {
            island.members.clear();
            island.idle = 0;
        }
    }
}

impl Island {
    fn add(&mut self, measure: usize, member: &Member) {
        let height = |member: &Member| member.heights.get(measure).copied().unwrap_or(i64::MIN);
        let new = height(member);
        // Scenes of equal height are most often the same scene.
        if new <= 0 || self.members.iter().any(|other| height(other) == new) {
            return;
        }
        if self.members.first().is_none_or(|best| height(best) < new) {
            self.idle = 0;
        }
        if self.peak.is_none_or(|(peak, _)| peak < new) {
            self.peak = Some((new, member.number));
        }
        let place = self.members.partition_point(|other| height(other) > new);
        if place < MEMBERS {
            self.members.insert(place, member.clone());
            self.members.truncate(MEMBERS);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn member(number: u64, heights: [i64; 2], conduct: u64) -> Member {
        let (spelled, parents, story) = (Spelled::default(), Vec::new(), Vec::new());
        Member { spelled, heights: heights.to_vec(), conduct, number, parents, story }
    }

    #[test]
    fn islands_keep_the_highest_and_the_rest_what_is_new() {
        let mut population = Population::new(2);
        for number in 1..=20 {
            let height = i64::try_from(number).unwrap();
            population.add(&member(number, [height % 13, 5], number % 3));
        }
        let numbers = |members: &[Member]| members.iter().map(|member| member.number).collect::<Vec<_>>();
        assert_eq!(numbers(&population.islands[0].members), [12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1]);
        assert_eq!(numbers(&population.islands[1].members), [1], "equally high scenes are one");
        assert_eq!(numbers(&population.curious), [1, 2, 3]);
        assert_eq!(population.islands[0].peak, Some((12, 12)));
        (0..=PATIENCE).for_each(|_| population.age());
        assert!(population.islands.iter().all(|island| island.members.is_empty() && island.peak.is_some()));
    }
}
