//! The command line of the study of parity, and its finds.

use std::collections::BTreeMap;

use super::{Census, Kind, PolygonPair, Recipe, Small, space};
use crate::{Common, Precision};

/// Random polygons that cross an odd number of times once merged.
#[derive(Clone, Debug, clap::Args)]
pub struct Parity {
    /// Closed polygons of the plane (2) or closed surfaces in space (3)
    #[arg(long, default_value_t = 2, value_name = "D", value_parser = clap::value_parser!(u8).range(2..=3))]
    pub dimension: u8,

    /// Pairs of each recipe, in each precision
    #[arg(long, default_value_t = 40_000, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub pairs: u64,

    /// Finds to shrink in each precision, evenly spread over all
    #[arg(long, default_value_t = 200, value_name = "N")]
    pub shrink: usize,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// The finds in one precision.
#[derive(Clone, PartialEq, Debug)]
pub struct Searched<C, K, S> {
    /// The precision of the tolerances.
    pub precision: Precision,
    /// The counts, and all finds.
    pub census: C,
    /// The smallest pairs that finds were shrunk to.
    pub smallest: BTreeMap<K, S>,
}

/// All smallest pairs, in the order of their numbers.
pub(super) fn all<C, K, S>(searched: &[Searched<C, K, S>]) -> impl Iterator<Item = (Precision, &K, &S)> {
    searched.iter().flat_map(|one| one.smallest.iter().map(|(kind, small)| (one.precision, kind, small)))
}

/// The finds among polygons.
pub type PlaneSearched = Searched<Census, Kind, Small<PolygonPair, Recipe>>;
/// The finds among surfaces.
pub type SpaceSearched = Searched<space::Census, space::Kind, Small<space::SurfacePair, space::Recipe>>;

/// The finds in each precision.
#[derive(Clone, PartialEq, Debug)]
pub enum Measured {
    /// The finds among polygons, by precision.
    Plane(Vec<PlaneSearched>),
    /// The finds among surfaces, by precision.
    Space(Vec<SpaceSearched>),
}
