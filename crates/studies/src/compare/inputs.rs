//! The scenes that are compared on: for each task general ones, nearly degenerate ones, and degenerate ones.

use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_tasks::vocabulary;

use crate::Error;

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

/// Scenes of one kind for one task.
#[derive(Clone, Copy, Debug)]
pub struct Input {
    /// The task.
    pub task: &'static str,
    /// How special they are.
    pub kind: Kind,
    /// What makes them.
    pub family: &'static str,
    /// About how large each is, in the family's own unit.
    pub n: usize,
    /// Other keys, in TOML.
    pub keys: &'static str,
}

const fn input(task: &'static str, kind: Kind, family: &'static str, n: usize, keys: &'static str) -> Input {
    Input { task, kind, family, n, keys }
}

/// All of them, by task. Coordinates of contacts are singles, so that single precision can take them.
pub const INPUTS: &[Input] = &[
    input("orient2d", Kind::General, "uniform", 1000, ""),
    input("orient2d", Kind::Near, "near", 1000, ""),
    input("orient2d", Kind::Degenerate, "degen", 1000, ""),
    input("orient3d", Kind::General, "uniform", 1000, ""),
    input("orient3d", Kind::Near, "near", 1000, ""),
    input("orient3d", Kind::Degenerate, "degen", 1000, ""),
    input("incircle", Kind::General, "uniform", 1000, ""),
    input("incircle", Kind::Near, "near", 1000, ""),
    input("incircle", Kind::Degenerate, "degen", 1000, ""),
    input("insphere", Kind::General, "uniform", 500, ""),
    input("insphere", Kind::Near, "near", 500, ""),
    input("insphere", Kind::Degenerate, "degen", 500, ""),
    input("contacts2d", Kind::General, "polygons-uniform", 120, "bits = 24"),
    input("contacts2d", Kind::Near, "polygons-near", 120, ""),
    input("contacts2d", Kind::Degenerate, "polygons-degen", 120, ""),
    input("contacts3d", Kind::General, "surfaces-uniform", 160, "bits = 24"),
    input("contacts3d", Kind::Near, "surfaces-shifted", 160, "shift = 1.0"),
    input("contacts3d", Kind::Degenerate, "surfaces-degen", 160, ""),
    input("polygon-locate", Kind::General, "tiling", 6, ""),
    input("polygon-locate", Kind::Degenerate, "bricks", 6, ""),
    input("crossings", Kind::General, "segments-uniform", 60, ""),
    input("crossings", Kind::Near, "segments-near", 30, ""),
    input("crossings", Kind::Degenerate, "segments-lattice", 30, ""),
    input("overlay2d", Kind::General, "overlay-stars", 24, ""),
    input("overlay2d", Kind::Near, "overlay-shifted", 24, ""),
    input("overlay2d", Kind::Degenerate, "overlay-squares", 16, ""),
    input("delaunay2d", Kind::General, "delaunay-uniform", 60, ""),
    input("delaunay2d", Kind::Near, "delaunay-near-ring", 60, ""),
    input("delaunay2d", Kind::Degenerate, "delaunay-grid", 64, ""),
    input("hull3d", Kind::General, "hull-ball", 60, ""),
    input("hull3d", Kind::Near, "hull-slab", 60, ""),
    input("hull3d", Kind::Degenerate, "hull-lattice", 64, ""),
    input("slice", Kind::General, "slice-torus", 48, "cut = \"random\""),
    input("slice", Kind::Degenerate, "slice-lattice", 24, "cut = \"vertices\""),
    input("cube-union", Kind::General, "cubes-uniform", 30, ""),
    input("cube-union", Kind::Degenerate, "cubes-degen", 30, ""),
    input("mesh-locate", Kind::General, "locate-torus", 48, "random = 60\nquick_stride = 0"),
    input("mesh-locate", Kind::Degenerate, "locate-tetrahedra", 48, "random = 0\nquick_stride = 3"),
    input("mesh-intersect", Kind::General, "intersect-spheres", 40, "placed = \"apart\""),
    input("mesh-intersect", Kind::Near, "intersect-spheres", 24, "placed = \"ulp\""),
    input("mesh-intersect", Kind::Degenerate, "intersect-cubes", 24, "placed = \"step\""),
];

/// So many times as large is the scene that is timed.
const TIMED: usize = 8;

impl Input {
    /// The scene of a seed.
    ///
    /// # Errors
    /// [`Error::Unfit`] where no such scene is made.
    pub fn scene(&self, seed: u64) -> Result<LoadedScene, Error> {
        self.of_size(self.n, seed)
    }

    /// A larger scene, to be timed.
    ///
    /// # Errors
    /// As [`Input::scene`].
    pub fn timed(&self, seed: u64) -> Result<LoadedScene, Error> {
        self.of_size(TIMED * self.n, seed)
    }

    fn of_size(&self, n: usize, seed: u64) -> Result<LoadedScene, Error> {
        let Input { task, family, keys, .. } = self;
        let text = format!(
            "title = \"compare\"\n[[generate]]\nname = \"{}-{seed}\"\nfamily = \"{family}\"\ntask = \"{task}\"\nn = {n}\nseed = {seed}\n{keys}\n",
            self.kind.name()
        );
        let suite = Suite::parse(vocabulary(), "compare", &text, None, &Manifest::default()).map_err(Error::unfit)?;
        // A generator needs nothing of a cache.
        suite.scenes[0].load(Level::Quick, &Cache::new("compare")).map_err(Error::unfit)
    }
}
