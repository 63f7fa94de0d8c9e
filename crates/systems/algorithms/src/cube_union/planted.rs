//! A fault planted in the union of cubes. See [`crate::planted`].

use crate::planted::{Fault, Honest};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// A cube whose upper face is on the border of a cell is not looked at there.
    const DROPS_BORDER_CUBES: bool = false;
}

impl Planted for Honest {}

/// Cubes that are looked at only in cells that they reach into.
#[derive(Clone, Copy, Debug)]
pub struct DroppedBorderCube;

impl Fault for DroppedBorderCube {
    const NAME: &'static str = "dropped-border-cube";
    const WHAT: &'static str = "a cube whose upper face is on the border of a cell is not looked at there";
}

impl Planted for DroppedBorderCube {
    const DROPS_BORDER_CUBES: bool = true;
}
