//! A control: the exact backend without one of its devices.
//!
//! It measures the worth of each device: the time without it over the time of the whole. Every answer is right, as no
//! device is needed for that. Devices are constants of the type, so the control costs the backend itself nothing. The
//! control decides in the order of [`Exact`](crate::Exact), with the same filters and rungs; without nothing it settles
//! each query at the same stage, and takes the same time.
//!
//! The control decides comparisons, constructed vertices and formulas as `exact` does.

mod batches;
mod session;

use alloc::{format, string::String};
use predicament_predicates::{
    Backend, Batches, Constructs, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning,
};

use crate::stage;
pub use session::WithoutSession;

/// No device: the control that has all of them.
pub const NOTHING: usize = 0;
/// Preparation: extents, bounds, the choice of an order, and the plan. A query climbs by its own points alone.
pub const PLAN: usize = 1;
/// The filter with one bound for the scene.
pub const STATIC: usize = 2;
/// The filter with a bound for the query, and the fewer limbs of queries that it leaves open.
pub const SEMI_STATIC: usize = 3;
/// Doubles that make no error, and the zeros that are found without arithmetic.
pub const DOUBLES: usize = 4;
/// Integers of a fixed size with differences of one or two limbs.
pub const INTEGERS: usize = 5;
/// Batches: a batch becomes a loop over single queries.
pub const BATCH: usize = 6;

/// The names of the devices, in this order.
pub const DEVICES: [&str; 7] = ["nothing", "plan", "static", "semi-static", "doubles", "integers", "batch"];

/// The exact backend without the device of this index in [`DEVICES`].
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Without<const DEVICE: usize>;

impl<const DEVICE: usize> Backend for Without<DEVICE> {
    type Session<'s, T: Tally + 's> = WithoutSession<'s, T, DEVICE>;

    /// The name `exact:without=` with the name of the device.
    fn name(&self) -> String {
        format!("exact:without={}", DEVICES[DEVICE])
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &stage::NAMES
    }

    fn batches(&self, _: PredicateKind) -> Batches {
        if DEVICE == BATCH { Batches::Loop } else { Batches::Own }
    }

    fn constructs(&self) -> Constructs {
        Constructs::Keeps
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined> {
        WithoutSession::new(scene, tally)
    }
}
