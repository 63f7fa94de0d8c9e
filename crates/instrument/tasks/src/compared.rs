//! The scenes of each task on which backends are compared.

/// The degeneracy of the position of a scene's primitives.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Kind {
    /// General position: no primitives are near each other.
    General,
    /// Nearly degenerate: primitives miss contact by a few roundings, or by a few tolerances.
    Near,
    /// Degenerate: zeros everywhere.
    Degenerate,
}

impl Kind {
    /// All kinds, in the order of tables.
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
    /// The degeneracy of the scenes.
    pub kind: Kind,
    /// The generator's family.
    pub family: &'static str,
    /// The approximate size of each scene, in the family's own unit.
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

    /// Nearly degenerate scenes.
    #[must_use]
    pub const fn near(family: &'static str, n: usize) -> Compared {
        Compared { kind: Kind::Near, family, n, keys: "" }
    }

    /// Degenerate scenes.
    #[must_use]
    pub const fn degenerate(family: &'static str, n: usize) -> Compared {
        Compared { kind: Kind::Degenerate, family, n, keys: "" }
    }

    /// The same scenes with these generator keys.
    #[must_use]
    pub const fn with(self, keys: &'static str) -> Compared {
        Compared { keys, ..self }
    }
}
