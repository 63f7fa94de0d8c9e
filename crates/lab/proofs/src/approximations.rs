//! The errors of constructed vertices in floating point: the constants of `exact::constructed::approximate`.

use predicament_exact::constructed::approximate::{
    LINE_PLANE, PLANES_POINT, PLANES_WEIGHT, ROOM, SEGMENTS, inner, minor, mixed, outer,
};

use crate::chain::Chain;
use crate::gappa::{Gappa, Number};
use crate::rules::{Claim, Rules};
use crate::trace::Traced;

/// The error of a computed quantity, over a product of norms.
pub struct Error {
    /// The quantity.
    pub name: &'static str,
    /// The bound in the code, in units of u, without the room for terms of second order.
    pub stated: f64,
    /// The proved bound, in units of u.
    pub proved: Number,
}

/// Proves the errors of the numerators and denominators of constructed vertices.
///
/// Entries are differences of points with slacks; a norm C bounds the permanent of a normal's component. With room
/// for terms of second order the constants are 65/64 of those stated.
///
/// # Errors
/// What is not proved.
pub fn prove(gappa: &Gappa) -> Result<Vec<Error>, String> {
    let rules = Rules { gappa, precision: 53 };
    let way = |from: &str, to: &str| -> [Traced; 3] {
        let (from, to): ([Traced; 3], [Traced; 3]) = (Traced::point(from), Traced::point(to));
        std::array::from_fn(|i| to[i] - from[i])
    };
    let flat = |v: [Traced; 3]| [v[0], v[1]];
    let (u, v, s, t) = (way("a", "b"), way("c", "d"), way("e", "f"), way("g", "h"));
    let (l, m, n) = (outer(u, v), outer(s, t), outer(way("i", "j"), way("k", "l")));
    let second = inner(m, u);
    // The terms of each, over its product of norms: a cross product counts as one, as C bounds both of its terms.
    let quantities = [
        ("w and n of two lines", minor(flat(u), flat(v)), 1.0, SEGMENTS),
        ("w and n of a line and a plane", inner(l, s), 3.0, LINE_PLANE),
        ("w of three planes", inner(l, outer(m, n)), 6.0, PLANES_WEIGHT),
        ("n of three planes", mixed([second, second], [outer(n, l)[0], outer(l, m)[0]]), 6.0, PLANES_POINT),
    ];
    let mut proved = Vec::new();
    for (name, formula, terms, stated) in quantities {
        let claim = Chain::new(&rules, Claim::slack(53)).claim(formula)?;
        let script = format!("# {name}: the error in units of u\n{{ {} * {terms} * 1b53 in ? }}\n", claim.error);
        let error = gappa.bound(&script)?;
        let holds = format!("# {name}: within the room\n{{ {error} <= {} }}\n", stated * ROOM);
        gappa.ask(&holds, &[])?;
        proved.push(Error { name, stated, proved: error });
    }
    Ok(proved)
}
