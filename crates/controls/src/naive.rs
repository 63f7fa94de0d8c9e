//! Predicates in plain floating point.

use predicament_predicates::{Backend, Constructs, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning};

use crate::{
    determinant::{self, Pivot},
    session::{Float, Session},
};

/// The signs of plain f64 determinants.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Naive {
    /// The point that is subtracted first.
    pub pivot: Pivot,
}

impl Float for Naive {
    #[inline]
    fn orient2d(&self, points: [[f64; 2]; 3]) -> f64 {
        determinant::orient2d(self.pivot, points)
    }

    #[inline]
    fn orient3d(&self, points: [[f64; 3]; 4]) -> f64 {
        determinant::orient3d(self.pivot, points)
    }

    #[inline]
    fn incircle(&self, points: [[f64; 2]; 4]) -> f64 {
        determinant::incircle(self.pivot, points)
    }

    #[inline]
    fn insphere(&self, points: [[f64; 3]; 5]) -> f64 {
        determinant::insphere(self.pivot, points)
    }
}

impl Backend for Naive {
    type Session<'s, T: Tally + 's> = Session<'s, Naive, T>;

    /// `naive`, `naive:first` or `naive:nalgebra`.
    fn name(&self) -> String {
        match self.pivot {
            Pivot::Last => "naive",
            Pivot::First => "naive:first",
            Pivot::Homogeneous => "naive:nalgebra",
        }
        .to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["float"]
    }

    fn constructs(&self) -> Constructs {
        Constructs::Rounds
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined> {
        Ok(Session::new(scene, *self, tally))
    }
}
