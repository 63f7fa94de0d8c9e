//! Faults planted in algorithms, to prove that what judges their answers can fail.
//!
//! A backend with a planted fault answers questions wrongly; these are
//! algorithms that go wrong by themselves, whatever the session says. Each
//! algorithm has its own in a module `planted`. A fault is a type, and the algorithms
//! are generic over it by constants: compiled for [`Honest`], which is what users
//! call, nothing is left of them.

/// One way for an algorithm to be wrong, known at compile time.
pub trait Fault: Sync {
    /// The name of the fault.
    const NAME: &'static str;
    /// What is wrong, in one line.
    const WHAT: &'static str;
}

/// No fault.
#[derive(Clone, Copy, Debug)]
pub struct Honest;

impl Fault for Honest {
    const NAME: &'static str = "honest";
    const WHAT: &'static str = "nothing is wrong";
}

/// A fault of the module's own trait `Planted`: the type and what it is about, its name, what is wrong, and the constant that it sets: to
/// true, or to a value of a type.
macro_rules! fault {
    ($type:ident, $about:literal, $name:literal, $what:literal, $constant:ident) => {
        fault!($type, $about, $name, $what, $constant: bool = true);
    };
    ($type:ident, $about:literal, $name:literal, $what:literal, $constant:ident: $of:ty = $value:expr) => {
        #[doc = $about]
        #[derive(Clone, Copy, Debug)]
        pub struct $type;

        impl $crate::planted::Fault for $type {
            const NAME: &'static str = $name;
            const WHAT: &'static str = $what;
        }

        impl Planted for $type {
            const $constant: $of = $value;
        }
    };
}

pub(crate) use fault;
