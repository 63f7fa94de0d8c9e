//! The command line of the study of cuts, and its measurements.

use std::time::Duration;

use predicament_contacts::algorithm::pairs::Contacts;
use predicament_tasks::AnswerError;

use super::{Deviation, Pieces, Placement, Shape, Sides};
use crate::Common;

/// A lattice of tetrahedra cut by surfaces.
#[derive(Clone, Debug, clap::Args)]
pub struct Cut {
    /// Surfaces; all if left out
    #[arg(short, long = "shape", value_name = "SHAPE", value_enum, value_delimiter = ',')]
    pub shapes: Vec<Shape>,

    /// Placements; all if left out
    #[arg(short, long = "placement", value_name = "PLACEMENT", value_enum, value_delimiter = ',')]
    pub placements: Vec<Placement>,

    /// Backends
    #[arg(
        short,
        long = "backend",
        value_name = "BACKEND",
        value_delimiter = ',',
        default_value = "exact,sos,sos:per-mesh,tolerance"
    )]
    pub backends: Vec<String>,

    /// Cubes of the lattice along each axis, of six tetrahedra each
    #[arg(long, default_value_t = 12, value_name = "N", value_parser = clap::value_parser!(u32).range(4..=100))]
    pub cubes: u32,

    /// Tetrahedra of each scene that are compared one by one with the exact inside share, at even steps among those
    /// near the surface
    #[arg(long, default_value_t = 300, value_name = "N")]
    pub checked: usize,

    /// In each cut, exchange the inside shares of two tetrahedra: the total stays right, and each exchange must be
    /// found
    #[arg(long)]
    pub planted: bool,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// The results of a cut by one backend.
#[derive(Clone, Debug)]
pub struct Row {
    /// The surface.
    pub shape: Shape,
    /// The placement of the surface in the lattice.
    pub placement: Placement,
    /// The backend's name.
    pub backend: String,
    /// The number of tetrahedra of the lattice.
    pub tetrahedra: usize,
    /// The number of triangles of the surface.
    pub triangles: usize,
    /// The exact volume inside, rounded to the nearest double.
    pub truth: f64,
    /// The volume of the lattice.
    pub whole: f64,
    /// The number of tetrahedra near the surface; the checked ones are some of them.
    pub near: usize,
    /// The result, or the reason why there is none.
    pub made: Result<Made, AnswerError>,
}

/// The contacts, and the resulting cut.
#[derive(Clone, PartialEq, Debug)]
pub struct Made {
    /// The registered pairs.
    pub contacts: Contacts,
    /// The sides of vertices.
    pub sides: Sides,
    /// The pieces.
    pub pieces: Pieces,
    /// The errors of the shares of single tetrahedra.
    pub deviation: Deviation,
    /// The time to register the contacts.
    pub registering: Duration,
    /// The time to determine sides and pieces.
    pub cutting: Duration,
}

impl Made {
    /// The number of registered pairs of these ranks, in either order if the two differ.
    #[must_use]
    pub fn registered(&self, [s, t]: [u8; 2]) -> usize {
        let is = |[a, b]: [u8; 2]| [a, b] == [s, t] || [b, a] == [s, t];
        self.contacts.registered.iter().filter(|contact| is([contact.a.rank, contact.b.rank])).count()
    }

    /// The number of queries for vertices of the surface in tetrahedra.
    #[must_use]
    pub fn asked_in_tetrahedra(&self) -> u64 {
        self.contacts.levels.iter().filter(|level| level.ranks == [3, 0]).map(|level| level.asked).sum()
    }
}

/// The measurements of all cuts.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Each scene by each backend, in their order.
    pub rows: Vec<Row>,
}
