//! The bounds of `tolerance`: the errors of its quantities, which its tolerances have to exceed.

use predicament_tolerance::bounds::published::{Kind, QUANTITIES};
use predicament_tolerance::bounds::quantities::{Named, Normalization, plane, space};
use predicament_tolerance::bounds::{Verdict, algorithms, derivations};

use crate::chain::Chain;
use crate::gappa::{Gappa, Number};
use crate::rules::{Claim, Rules};
use crate::trace::{Node, Traced};

/// A proved bound.
pub struct Bound {
    /// The section of the paper, or `ours`.
    pub section: String,
    /// The bound's name, such as `E[d²]`.
    pub name: String,
    /// The stated bound, in units of ε and of L.
    pub stated: u32,
    /// The proved bound, in units of ε and of L.
    pub proved: Number,
}

/// Proves the stated bounds for a format of so many bits, in which ε is twice u.
///
/// L is 1, and coordinates are at most a half. Gappa proves each error with the roundings of the format, half of what
/// the error calculus charges.
///
/// # Errors
/// What is not proved.
pub fn prove(gappa: &Gappa, precision: u32) -> Result<Vec<Bound>, String> {
    let rules = Rules { gappa, precision };
    let computed = quantities();
    let find = |section: &str, symbol: &str| {
        let named = computed.iter().find(|named| named.section == section && named.symbol == symbol);
        named.map(|named| named.value).ok_or_else(|| format!("{symbol} of {section} is stated and not computed"))
    };
    let mut wanted = Vec::new();
    for stated in QUANTITIES {
        wanted.push((stated.section, stated.symbol, stated.kind, stated.figure, find(stated.section, stated.symbol)?));
    }
    for ours in derivations().iter().filter(|row| row.verdict() == Verdict::Ours) {
        let Some(symbol) = ours.name.strip_prefix("E[").and_then(|rest| rest.strip_suffix(']')) else { continue };
        let figure = ours.whole().ok_or_else(|| format!("{} has no bound", ours.name))?;
        let symbol = if symbol == "incircle" { "incircle" } else { "insphere" };
        wanted.push(("ours", symbol, Kind::Absolute, figure, find("ours", symbol)?));
    }
    for (section, (tolerance, width)) in widths() {
        wanted.push((section, tolerance.symbol, Kind::Relative, tolerance.printed_relative, width));
    }
    let mut proved = Vec::new();
    for (section, symbol, kind, stated, value) in wanted {
        let mut chain = Chain::new(&rules, Claim::difference(precision));
        let error = chain.claim(value).map_err(|error| format!("{symbol} of {section}: {error}"))?.error;
        let (letter, size) = match kind {
            Kind::Absolute => ("E", size(value)?),
            Kind::Relative if is_positive(value) => ("R", "1".to_owned()),
            Kind::Relative => return Err(format!("{symbol} of {section} may cancel, and has no relative error")),
        };
        let name = format!("{letter}[{symbol}]");
        let unit = format!("1b{}", precision - 1);
        let script =
            format!("# {name} of {section}, in units of the machine epsilon\n{{ {error} * {size} * {unit} in ? }}\n");
        let error = gappa.bound(&script)?;
        gappa.ask(&format!("# {name} of {section} is within what is stated\n{{ {error} <= {stated} }}\n"), &[])?;
        proved.push(Bound { section: section.to_owned(), name, stated, proved: error });
    }
    Ok(proved)
}

fn quantities() -> Vec<Named<Traced>> {
    let names = ["A", "B", "C", "D", "P", "Q"];
    let mut all = plane(&names.map(Traced::point), Normalization::Reciprocal);
    all.extend(space(&names.map(Traced::point), Normalization::Reciprocal));
    all
}

/// The middle values of the two tables of tolerances.
fn widths() -> Vec<(&'static str, (&'static predicament_tolerance::bounds::coefficient::Tolerance, Traced))> {
    let (epsilon, length) = (Traced::input("ε"), Traced::input("L"));
    let number = |value: rug::Rational| Traced::input(value.to_string());
    let figure_1 = algorithms::plane(&epsilon, &length, number).into_iter().map(|row| ("figure 1", row));
    let figure_5 = algorithms::space(&epsilon, &length, number).into_iter().map(|row| ("figure 5", row));
    figure_1.chain(figure_5).collect()
}

/// Returns true if no term of the number is negative, so that it is its own permanent.
fn is_positive(z: Traced) -> bool {
    match z.node() {
        Node::One | Node::Input(_) | Node::Abs(_) => true,
        Node::Sqrt(x) | Node::Div(Traced::ONE, x) => is_positive(x),
        Node::Mul(x, y) => x == y || (is_positive(x) && is_positive(y)),
        Node::Add(x, y) => is_positive(x) && is_positive(y),
        Node::Sub(..) | Node::Neg(_) | Node::Div(..) => false,
    }
}

/// The largest permanent, as an expression that Gappa reads, for differences of coordinates up to 1.
fn size(z: Traced) -> Result<String, String> {
    Ok(match z.node() {
        Node::One | Node::Input(_) => "1".into(),
        Node::Sub(x, y) if is_given(x) && is_given(y) => "1".into(),
        Node::Abs(x) | Node::Neg(x) => size(x)?,
        Node::Sqrt(x) => format!("sqrt({})", size(x)?),
        Node::Add(x, y) | Node::Sub(x, y) => format!("({} + {})", size(x)?, size(y)?),
        Node::Mul(x, y) if is_of_unit_vector(x, y) || is_of_unit_vector(y, x) => "1".into(),
        Node::Mul(x, y) => format!("{} * {}", size(x)?, size(y)?),
        Node::Div(..) => return Err(format!("nothing bounds {}", z.text(4))),
    })
}

fn is_given(z: Traced) -> bool {
    matches!(z.node(), Node::Input(_))
}

/// Returns true if `inverse` is 1/√s, and the square of `x` is a term of s: then |x/√s| is at most 1.
fn is_of_unit_vector(x: Traced, inverse: Traced) -> bool {
    fn has_square(sum: Traced, x: Traced) -> bool {
        match sum.node() {
            Node::Add(a, b) => has_square(a, x) || has_square(b, x),
            node => node == Node::Mul(x, x),
        }
    }
    let Node::Div(Traced::ONE, root) = inverse.node() else { return false };
    matches!(root.node(), Node::Sqrt(sum) if is_positive(sum) && has_square(sum, x))
}
