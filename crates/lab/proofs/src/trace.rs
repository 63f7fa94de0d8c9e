//! Symbols that the formulas of the code run on: each operation is recorded, and nothing is computed.
//!
//! The functions of `predicament-exact` and `predicament-tolerance` are written over any numbers. On [`Traced`] numbers
//! they build the graph of their operations, which is then what the proofs are about.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

use predicament_arithmetic::Number;
use predicament_error_calculus::{Field, Ring, Root};

/// An operation, on the numbers of earlier operations.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// The number one.
    One,
    /// A double that the formula is given.
    Input(String),
    /// A sum, rounded.
    Add(Traced, Traced),
    /// A difference, rounded.
    Sub(Traced, Traced),
    /// A product, rounded.
    Mul(Traced, Traced),
    /// A quotient, rounded.
    Div(Traced, Traced),
    /// A square root, rounded.
    Sqrt(Traced),
    /// A magnitude, which is exact.
    Abs(Traced),
    /// A negated number, which is exact.
    Neg(Traced),
}

/// A number of a traced formula.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Traced(usize);

/// All numbers of a thread: equal operations on equal numbers are one number.
struct Arena {
    nodes: Vec<Node>,
    index: HashMap<Node, Traced>,
}

thread_local! {
    static ARENA: RefCell<Arena> =
        RefCell::new(Arena { nodes: vec![Node::One], index: HashMap::from([(Node::One, Traced(0))]) });
}

impl Traced {
    /// The number one.
    pub const ONE: Traced = Traced(0);

    /// The input with this name.
    #[must_use]
    pub fn input(name: impl Into<String>) -> Traced {
        Traced::of(Node::Input(name.into()))
    }

    /// A point whose coordinates are inputs.
    #[must_use]
    pub fn point<const D: usize>(name: &str) -> [Traced; D] {
        std::array::from_fn(|axis| Traced::input(format!("{name}{}", ["x", "y", "z"][axis])))
    }

    fn of(node: Node) -> Traced {
        ARENA.with_borrow_mut(|arena| {
            if let Some(known) = arena.index.get(&node) {
                return *known;
            }
            let new = Traced(arena.nodes.len());
            arena.nodes.push(node.clone());
            arena.index.insert(node, new);
            new
        })
    }

    /// The operation that the number is the result of.
    #[must_use]
    pub fn node(self) -> Node {
        ARENA.with_borrow(|arena| arena.nodes[self.0].clone())
    }

    /// The formula of the number, down to `depth` operations.
    #[must_use]
    pub fn text(self, depth: usize) -> String {
        if depth == 0 && !matches!(self.node(), Node::Input(_) | Node::One) {
            return "…".to_owned();
        }
        let of = |x: Traced| x.text(depth.saturating_sub(1));
        match self.node() {
            Node::One => "1".to_owned(),
            Node::Input(name) => name,
            Node::Add(x, y) => format!("({} + {})", of(x), of(y)),
            Node::Sub(x, y) => format!("({} - {})", of(x), of(y)),
            Node::Mul(x, y) => format!("{} * {}", of(x), of(y)),
            Node::Div(x, y) => format!("{} / {}", of(x), of(y)),
            Node::Sqrt(x) => format!("sqrt({})", of(x)),
            Node::Abs(x) => format!("|{}|", of(x)),
            Node::Neg(x) => format!("-{}", of(x)),
        }
    }
}

macro_rules! operation {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Traced {
            type Output = Traced;
            fn $method(self, other: Traced) -> Traced {
                Traced::of(Node::$trait(self, other))
            }
        }
    )*};
}

operation!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Traced {
    type Output = Traced;
    fn neg(self) -> Traced {
        Traced::of(Node::Neg(self))
    }
}

impl Number for Traced {
    const ONE: Traced = Traced::ONE;
    fn abs(self) -> Traced {
        Traced::of(Node::Abs(self))
    }
}

impl Ring for Traced {
    fn abs(self) -> Traced {
        Traced::of(Node::Abs(self))
    }
}

impl Field for Traced {
    fn one() -> Traced {
        Traced::ONE
    }
}

impl Root for Traced {
    fn sqrt(self) -> Traced {
        Traced::of(Node::Sqrt(self))
    }
}
