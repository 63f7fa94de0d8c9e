//! The amount of a suite that is run.

use predicament_predicates::UnknownName;

/// The amount of work of a run.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub enum Level {
    /// Takes seconds: the level for testing every change.
    #[default]
    Quick,
    /// Takes up to an hour, as the suite's author chose.
    Full,
}

impl Level {
    /// The level's name on the command line.
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
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Level, UnknownName> {
        match name {
            "quick" => Ok(Level::Quick),
            "full" => Ok(Level::Full),
            _ => Err(UnknownName::new("level", name).listing("levels", ["quick", "full"])),
        }
    }
}

impl Level {
    /// The first of two values for quick, the second for full.
    #[must_use]
    pub fn of<T>(self, [quick, full]: [T; 2]) -> T {
        match self {
            Level::Quick => quick,
            Level::Full => full,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip() {
        for level in [Level::Quick, Level::Full] {
            assert_eq!(level.name().parse(), Ok(level));
        }
        assert!("slow".parse::<Level>().is_err());
    }
}
