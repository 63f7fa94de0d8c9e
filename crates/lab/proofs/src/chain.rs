//! The proof of a whole formula: one step after the other, along the graph of its operations.

use std::collections::HashMap;

use crate::polynomial::Polynomial;
use crate::rules::{Claim, Rules};
use crate::trace::{Node, Traced};

/// The symbol of what underflow loses in a product: at most 2⁻¹⁰⁷⁵ in magnitude.
pub const ETA: &str = "η";

/// The claims about the numbers of a formula, for a given claim about differences of inputs.
pub struct Chain<'a> {
    rules: &'a Rules<'a>,
    difference: Claim,
    known: HashMap<Traced, Claim>,
}

impl<'a> Chain<'a> {
    /// The rules of the chain.
    #[must_use]
    pub fn rules(&self) -> &'a Rules<'a> {
        self.rules
    }

    /// A chain in which the difference of two inputs has this claim.
    #[must_use]
    pub fn new(rules: &'a Rules<'a>, difference: Claim) -> Chain<'a> {
        Chain { rules, difference, known: HashMap::new() }
    }

    /// The claim about a number.
    ///
    /// # Errors
    /// The script that Gappa does not prove.
    pub fn claim(&mut self, z: Traced) -> Result<Claim, String> {
        if let Some(known) = self.known.get(&z) {
            return Ok(known.clone());
        }
        let what = z.text(3);
        let claim = match z.node() {
            Node::One | Node::Input(_) => Claim::given(),
            Node::Abs(x) | Node::Neg(x) => self.claim(x)?,
            Node::Sub(x, y) if is_input(x) && is_input(y) => self.difference.clone(),
            Node::Add(x, y) | Node::Sub(x, y) => {
                let (x, y) = (self.claim(x)?, self.claim(y)?);
                self.rules.sum(&x, &y, &what)?
            }
            Node::Mul(x, y) => {
                let (x, y) = (self.claim(x)?, self.claim(y)?);
                self.rules.product(&x, &y, &what)?
            }
            Node::Sqrt(x) => {
                let x = self.claim(x)?;
                self.rules.root(&x, &what)?
            }
            Node::Div(Traced::ONE, y) => {
                let y = self.claim(y)?;
                self.rules.inverse(&y, &what)?
            }
            Node::Div(..) => return Err(format!("there is no rule for the quotient {what}")),
        };
        self.known.insert(z, claim.clone());
        Ok(claim)
    }

    /// The claim about the sum or difference that ends a formula, before it is rounded.
    ///
    /// # Errors
    /// The script that Gappa does not prove; or if the formula ends otherwise.
    pub fn before_last_sum(&mut self, z: Traced) -> Result<Claim, String> {
        match z.node() {
            Node::Sub(x, y) if is_input(x) && is_input(y) => Ok(self.difference.clone()),
            Node::Add(x, y) | Node::Sub(x, y) => {
                let (x, y) = (self.claim(x)?, self.claim(y)?);
                self.rules.sum_before_rounding(&x, &y, &z.text(3))
            }
            _ => Err(format!("{} does not end with a sum", z.text(3))),
        }
    }
}

/// Returns true if the number is given.
pub(crate) fn is_input(x: Traced) -> bool {
    matches!(x.node(), Node::Input(_))
}

/// The permanent of a number, with `atom` that of a difference of two inputs.
///
/// The η of every product is a term of it.
///
/// # Panics
/// If the formula has a quotient or a root.
#[must_use]
pub fn permanent(z: Traced, atom: &dyn Fn(Traced) -> Polynomial) -> Polynomial {
    let of = |x: Traced| permanent(x, atom);
    match z.node() {
        Node::One => Polynomial::constant(1),
        Node::Input(name) => Polynomial::symbol(&name),
        Node::Abs(x) | Node::Neg(x) => of(x),
        Node::Sub(x, y) if is_input(x) && is_input(y) => atom(z),
        Node::Add(x, y) | Node::Sub(x, y) => of(x).plus(&of(y), 1),
        Node::Mul(x, y) => of(x).times(&of(y)).plus(&Polynomial::symbol(ETA), 1),
        Node::Div(..) | Node::Sqrt(_) => panic!("{} is not a polynomial", z.text(4)),
    }
}

/// The difference of two inputs as one symbol, such as `|ax - dx|`.
#[must_use]
pub fn magnitude(difference: Traced) -> Polynomial {
    Polynomial::symbol(&format!("|{}|", difference.text(1)))
}
