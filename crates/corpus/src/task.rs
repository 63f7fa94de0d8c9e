//! What is asked of a scene, and how much of it.

use predicament_predicates::PredicateKind;

/// How much work a run does.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub enum Level {
    /// Seconds: what every change is tested with.
    #[default]
    Quick,
    /// As much as the suite's author thought worth an hour.
    Full,
}

impl Level {
    /// The name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Level::Quick => "quick",
            Level::Full => "full",
        }
    }
}

impl std::fmt::Display for Level {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Level {
    type Err = String;

    fn from_str(name: &str) -> Result<Level, String> {
        match name {
            "quick" => Ok(Level::Quick),
            "full" => Ok(Level::Full),
            _ => Err(format!("no level is called `{name}`: it is quick or full")),
        }
    }
}

/// What is asked of a scene.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Task {
    /// The order of two vertices along an axis.
    Compare,
    /// The turn of three vertices.
    Orient2d,
    /// The side of a plane.
    Orient3d,
    /// The inside of a circle.
    Incircle,
    /// The inside of a sphere.
    Insphere,
    /// The cell of a partition of a line in which a point lies (Franklin and Magalhães, 4.1).
    Interval,
    /// The region of a map in which a point lies (Franklin and Magalhães, 4.2).
    PolygonLocate,
    /// Volume, area and edge length of a union of cubes (Franklin and Magalhães, 4.3).
    CubeUnion,
    /// The contacts between two complexes in the plane (Wang et al.).
    Contacts2d,
    /// The contacts between two complexes in space (Wang et al.).
    Contacts3d,
}

impl Task {
    /// All tasks.
    pub const ALL: [Task; 10] = [
        Task::Compare,
        Task::Orient2d,
        Task::Orient3d,
        Task::Incircle,
        Task::Insphere,
        Task::Interval,
        Task::PolygonLocate,
        Task::CubeUnion,
        Task::Contacts2d,
        Task::Contacts3d,
    ];

    /// The name in suites, CSV files and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Task::Compare => PredicateKind::Compare.name(),
            Task::Orient2d => PredicateKind::Orient2d.name(),
            Task::Orient3d => PredicateKind::Orient3d.name(),
            Task::Incircle => PredicateKind::Incircle.name(),
            Task::Insphere => PredicateKind::Insphere.name(),
            Task::Interval => "interval",
            Task::PolygonLocate => "polygon-locate",
            Task::CubeUnion => "cube-union",
            Task::Contacts2d => "contacts2d",
            Task::Contacts3d => "contacts3d",
        }
    }

    /// The predicate whose signs are asked for; none for tasks that run an algorithm.
    #[must_use]
    pub const fn predicate(self) -> Option<PredicateKind> {
        match self {
            Task::Compare => Some(PredicateKind::Compare),
            Task::Orient2d => Some(PredicateKind::Orient2d),
            Task::Orient3d => Some(PredicateKind::Orient3d),
            Task::Incircle => Some(PredicateKind::Incircle),
            Task::Insphere => Some(PredicateKind::Insphere),
            Task::Interval | Task::PolygonLocate | Task::CubeUnion | Task::Contacts2d | Task::Contacts3d => None,
        }
    }
}

impl From<PredicateKind> for Task {
    fn from(kind: PredicateKind) -> Task {
        match kind {
            PredicateKind::Compare => Task::Compare,
            PredicateKind::Orient2d => Task::Orient2d,
            PredicateKind::Orient3d => Task::Orient3d,
            PredicateKind::Incircle => Task::Incircle,
            PredicateKind::Insphere => Task::Insphere,
        }
    }
}

impl std::fmt::Display for Task {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Task {
    type Err = String;

    fn from_str(name: &str) -> Result<Task, String> {
        Task::ALL
            .into_iter()
            .find(|task| task.name() == name)
            .ok_or_else(|| format!("no task is called `{name}`: tasks are {}", Task::ALL.map(Task::name).join(", ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip() {
        for task in Task::ALL {
            assert_eq!(task.name().parse(), Ok(task));
            assert_eq!(task.predicate().map(Task::from).unwrap_or(task), task);
        }
        for level in [Level::Quick, Level::Full] {
            assert_eq!(level.name().parse(), Ok(level));
        }
        assert!("hull".parse::<Task>().unwrap_err().contains("polygon-locate"));
        assert!("slow".parse::<Level>().is_err());
    }
}
