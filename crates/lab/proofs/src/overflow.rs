//! Overflow, which Gappa's numbers do not have: if the permanent is finite, so is every intermediate of the
//! determinant.

use std::collections::HashMap;

use crate::chain::is_input;
use crate::trace::{Node, Traced};

/// Checks that each intermediate of `d` is dominated by an intermediate of `p`: as computed, it is not larger in
/// magnitude.
///
/// Rounding is monotone. So a sum of magnitudes dominates the difference of dominated numbers, and a product the
/// product. If p is finite, nothing has overflowed; if not, no |d| is beyond a multiple of p.
///
/// # Errors
/// The first number that nothing dominates.
pub fn dominated(d: Traced, p: Traced) -> Result<(), String> {
    let (mut of_determinant, mut of_permanent) = (Vec::new(), Vec::new());
    collect(d, &mut of_determinant);
    collect(p, &mut of_permanent);
    let mut known = HashMap::new();
    let mut dominates = |z| of_permanent.iter().any(|&by| dominates(by, z, &mut known));
    match of_determinant.into_iter().find(|&z| !dominates(z)) {
        Some(z) => Err(format!("{} may overflow while the permanent is finite", z.text(4))),
        None => Ok(()),
    }
}

fn collect(z: Traced, all: &mut Vec<Traced>) {
    if is_input(z) || all.contains(&z) {
        return;
    }
    all.push(z);
    operands(z).into_iter().for_each(|x| collect(x, all));
}

fn operands(z: Traced) -> Vec<Traced> {
    match z.node() {
        Node::Add(x, y) | Node::Sub(x, y) | Node::Mul(x, y) | Node::Div(x, y) => vec![x, y],
        Node::Abs(x) | Node::Neg(x) | Node::Sqrt(x) => vec![x],
        Node::One | Node::Input(_) => Vec::new(),
    }
}

fn dominates(by: Traced, z: Traced, known: &mut HashMap<(Traced, Traced), bool>) -> bool {
    if by == z {
        return true;
    }
    if let Some(&is) = known.get(&(by, z)) {
        return is;
    }
    let mut both = |[a, b]: [Traced; 2], [x, y]: [Traced; 2]| {
        (dominates(a, x, known) && dominates(b, y, known)) || (dominates(a, y, known) && dominates(b, x, known))
    };
    let is = match (by.node(), z.node()) {
        // The turn of two products, whose |l + r| is the permanent where they have one sign. Where they have two, no rounding
        // and no overflow changes the sign of l − r.
        (Node::Abs(sum), Node::Sub(l, r)) if sum.node() == Node::Add(l, r) && is_product(l) && is_product(r) => true,
        (Node::Mul(a, b), Node::Mul(x, y)) => both([a, b], [x, y]),
        (Node::Add(a, b), Node::Add(x, y) | Node::Sub(x, y))
            if is_magnitude(a) && is_magnitude(b) && both([a, b], [x, y]) =>
        {
            true
        }
        (Node::Add(a, b), _) if is_magnitude(a) && is_magnitude(b) => dominates(a, z, known) || dominates(b, z, known),
        (Node::Abs(by), _) => dominates(by, z, known),
        (_, Node::Abs(z) | Node::Neg(z)) => dominates(by, z, known),
        _ => false,
    };
    known.insert((by, z), is);
    is
}

/// Returns true if the number is certainly not negative.
fn is_magnitude(z: Traced) -> bool {
    match z.node() {
        Node::One | Node::Abs(_) | Node::Sqrt(_) => true,
        Node::Input(name) => ["slack", "extent"].iter().any(|kind| name.starts_with(kind)),
        Node::Add(x, y) => is_magnitude(x) && is_magnitude(y),
        Node::Mul(x, y) => x == y || is_magnitude(x) && is_magnitude(y),
        Node::Div(..) | Node::Sub(..) | Node::Neg(_) => false,
    }
}

fn is_product(z: Traced) -> bool {
    matches!(z.node(), Node::Mul(..))
}
