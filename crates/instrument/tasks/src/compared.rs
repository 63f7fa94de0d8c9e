//! The scenes on which backends are compared: each task names its own.

/// How special the position of a scene's primitives is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Kind {
    /// Nothing is near to anything.
    General,
    /// What nearly touches does so by a few roundings, or by a few tolerances.
    Near,
    /// Zeros everywhere.
    Degenerate,
}

impl Kind {
    /// All of them, in the order of tables.
    pub const ALL: [Kind; 3] = [Kind::General, Kind::Near, Kind::Degenerate];

    /// The name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Kind::General => "general",
            Kind::Near => "near",
            Kind::Degenerate => "degenerate",
        }
    }
}

/// Scenes of one kind on which a task is compared: a family of its generators.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Compared {
    /// How special they are.
    pub kind: Kind,
    /// What makes them.
    pub family: &'static str,
    /// About how large each is, in the family's own unit.
    pub n: usize,
    /// Other keys of the generator, in TOML.
    pub keys: &'static str,
}

impl Compared {
    /// Scenes in general position.
    #[must_use]
    pub const fn general(family: &'static str, n: usize) -> Compared {
        Compared { kind: Kind::General, family, n, keys: "" }
    }

    /// Scenes that are nearly degenerate.
    #[must_use]
    pub const fn near(family: &'static str, n: usize) -> Compared {
        Compared { kind: Kind::Near, family, n, keys: "" }
    }

    /// Scenes that are degenerate.
    #[must_use]
    pub const fn degenerate(family: &'static str, n: usize) -> Compared {
        Compared { kind: Kind::Degenerate, family, n, keys: "" }
    }

    /// The same with these keys.
    #[must_use]
    pub const fn with(self, keys: &'static str) -> Compared {
        Compared { keys, ..self }
    }
}
