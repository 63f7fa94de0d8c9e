//! Backends that end their process, or never answer: tests for isolation.
//!
//! They are not part of `selftest`, which would end with them. `run --isolate` must write a row for each and continue.

use predicament_predicates::{PredicateKind, Question};

/// A way to end or block the process, at the first `orient2d`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Deadly {
    /// The backend never answers.
    Loops,
    /// The backend panics.
    Panics,
    /// The backend recurses until the stack overflows.
    OverflowsStack,
    /// The backend aborts.
    Aborts,
    /// The backend requests a quarter of all addresses, which are more than a system maps for a process.
    Hoards,
    /// The backend exits with code 0.
    Exits,
}

impl Deadly {
    /// All deadly faults.
    pub const ALL: [Deadly; 6] =
        [Deadly::Loops, Deadly::Panics, Deadly::OverflowsStack, Deadly::Aborts, Deadly::Hoards, Deadly::Exits];

    /// The fault's name after `fault:`.
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

    /// Strikes if the question is `orient2d`.
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
                let hoard: Vec<u8> = Vec::with_capacity(usize::MAX / 4);
                panic!("planted: {} bytes were there", hoard.capacity());
            }
        }
    }
}

/// Recurses beyond the available stack.
#[allow(unconditional_recursion, reason = "the fault that is planted")]
fn deeper(depth: u64) -> u64 {
    let room = std::hint::black_box([depth; 64]);
    deeper(depth + 1) + std::hint::black_box(room)[7]
}
