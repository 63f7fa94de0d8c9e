//! Arithmetic with chosen errors: every operation may be off by ε in either direction.
//!
//! The bounds of the calculus hold for all such arithmetic. Errors of real floating point stay far below the bounds;
//! errors chosen at random come nearer. The exact value is stored beside the perturbed one.

use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::rc::Rc;

use rug::Rational;

use crate::{Enclosure, Field, Ring, Root};

/// An exact value beside the value with errors.
#[derive(Clone)]
pub struct Perturbed {
    /// The exact value; its roots are enclosed to 2⁻¹⁹².
    pub exact: Rational,
    /// The result of operations that were each off by up to ε of their result.
    pub computed: Rational,
    /// The adversary; `None` for a constant, which uses the other operand's.
    adversary: Option<Adversary>,
}

/// A function that chooses each relative error.
#[derive(Clone)]
pub struct Adversary(Rc<RefCell<dyn FnMut() -> Rational>>);

impl Adversary {
    /// An adversary that calls `error` for the relative error of every operation.
    pub fn new(error: impl FnMut() -> Rational + 'static) -> Adversary {
        Adversary(Rc::new(RefCell::new(error)))
    }

    /// An input, without an error.
    #[must_use]
    pub fn input(&self, value: impl Into<Rational>) -> Perturbed {
        let exact = value.into();
        Perturbed { computed: exact.clone(), exact, adversary: Some(self.clone()) }
    }
}

impl Perturbed {
    fn rounded(adversary: Option<Adversary>, exact: Rational, value: Rational) -> Perturbed {
        let error = adversary.as_ref().map_or_else(Rational::new, |Adversary(error)| (error.borrow_mut())());
        Perturbed { exact, computed: value * (error + 1), adversary }
    }
}

macro_rules! operation {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Perturbed {
            type Output = Perturbed;

            fn $method(self, other: Perturbed) -> Perturbed {
                Perturbed::rounded(
                    self.adversary.or(other.adversary),
                    self.exact.$method(other.exact),
                    self.computed.$method(other.computed),
                )
            }
        }
    )*};
}

operation!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Perturbed {
    type Output = Perturbed;

    fn neg(self) -> Perturbed {
        Perturbed { exact: -self.exact, computed: -self.computed, adversary: self.adversary }
    }
}

impl Ring for Perturbed {
    fn abs(self) -> Perturbed {
        Perturbed { exact: self.exact.abs(), computed: self.computed.abs(), adversary: self.adversary }
    }
}

impl Field for Perturbed {
    fn one() -> Perturbed {
        Perturbed { exact: 1.into(), computed: 1.into(), adversary: None }
    }
}

impl Root for Perturbed {
    fn sqrt(self) -> Perturbed {
        let root = |x| Enclosure::exact(x).sqrt().lower;
        Perturbed::rounded(self.adversary, root(self.exact), root(self.computed))
    }
}
