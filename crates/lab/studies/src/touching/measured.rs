//! The command line of the study, and its measurements.

use super::{Made, Pair};
use crate::Common;

/// Solids that touch, by several backends.
#[derive(Clone, Debug, clap::Args)]
pub struct Touching {
    /// Pairs of solids; all if left out
    #[arg(short, long = "pair", value_name = "PAIR", value_enum, value_delimiter = ',')]
    pub pairs: Vec<Pair>,

    /// Backends
    #[arg(
        short,
        long = "backend",
        value_name = "BACKEND",
        value_delimiter = ',',
        default_value = "exact,sos:per-mesh,sos,tolerance"
    )]
    pub backends: Vec<String>,

    /// Cubes of blocks and stacks along each axis
    #[arg(long, default_value_t = 3, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=40))]
    pub side: u32,

    /// Times that the triangles of spheres are divided: 8 · 4^N triangles
    #[arg(long, default_value_t = 4, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=9))]
    pub levels: u32,

    /// Rounds of timing, with the backends in turns
    #[arg(long, default_value_t = 3, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub rounds: u32,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// One pair by one backend.
#[derive(Clone, PartialEq, Debug)]
pub struct Row {
    /// The pair.
    pub pair: Pair,
    /// The backend's name.
    pub backend: String,
    /// The number of triangles of both solids.
    pub triangles: usize,
    /// The result, or the reason why there is none.
    pub made: Result<Made, String>,
    /// Seconds of the overlay in each round.
    pub overlay: Vec<f64>,
    /// Seconds of the limit in each round.
    pub limit: Vec<f64>,
}

/// The measurements of all pairs.
#[derive(Clone, PartialEq, Debug)]
pub struct Measured {
    /// Each pair by each backend, in their order.
    pub rows: Vec<Row>,
}
