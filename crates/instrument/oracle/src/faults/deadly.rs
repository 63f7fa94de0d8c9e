//! Backends that end their process, or never answer: what isolation is for.
//!
//! They are no part of `selftest`, which would end with them: `run --isolate` has
//! to make a row of each and go on.

use predicament_predicates::{PredicateKind, Question};

/// A way to take the process along, or to keep it for ever. It strikes at the first `orient2d`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Deadly {
    /// It never answers.
    Loops,
    /// It panics.
    Panics,
    /// It calls itself until the stack is full.
    OverflowsStack,
    /// It aborts.
    Aborts,
    /// It asks for 16 TB of memory.
    Hoards,
    /// It ends the process as if all were well.
    Exits,
}

impl Deadly {
    /// All of them.
    pub const ALL: [Deadly; 6] =
        [Deadly::Loops, Deadly::Panics, Deadly::OverflowsStack, Deadly::Aborts, Deadly::Hoards, Deadly::Exits];

    /// The name after `fault:`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Deadly::Loops => "loops",
            Deadly::Panics => "panics",
            Deadly::OverflowsStack => "overflows-stack",
            Deadly::Aborts => "aborts",
            Deadly::Hoards => "hoards",
            Deadly::Exits => "exits",
        }
    }

    /// Does it, where the question is the one.
    pub(super) fn strike(self, question: Question) {
        if question.kind() != PredicateKind::Orient2d {
            return;
        }
        match self {
            Deadly::Loops => loop {
                std::thread::sleep(std::time::Duration::from_millis(1));
            },
            Deadly::Panics => panic!("planted: a panic"),
            Deadly::OverflowsStack => assert_ne!(deeper(1), 0),
            Deadly::Aborts => std::process::abort(),
            Deadly::Exits => std::process::exit(0),
            Deadly::Hoards => {
                let hoard: Vec<u8> = Vec::with_capacity(1 << 44);
                panic!("planted: {} bytes were there", hoard.capacity());
            }
        }
    }
}

/// Needs more stack than there is.
#[allow(unconditional_recursion, reason = "the fault that is planted")]
fn deeper(depth: u64) -> u64 {
    let room = std::hint::black_box([depth; 64]);
    deeper(depth + 1) + std::hint::black_box(room)[7]
}
