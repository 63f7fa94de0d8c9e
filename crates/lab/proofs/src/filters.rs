//! The filters of `exact`: what has to be true of their constants, and the proofs.

use predicament_arithmetic::bound;
use predicament_exact::constructed::filter::{self, Approximate};
use predicament_exact::{anywhere, side::Side};

use crate::chain::{Chain, ETA, magnitude, permanent};
use crate::gappa::{Gappa, Number};
use crate::overflow::dominated;
use crate::polynomial::{Polynomial, determinant, exact};
use crate::rules::{Claim, Rules};
use crate::trace::{Node, Traced};
use crate::underflow::{Underflow, covered, divides, extent_of, is_bound, over_three_slacks, with_slacks};

/// The bits of a double's significand.
const PRECISION: u32 = 53;
/// A number that is hardly more than zero, for strict inequalities.
const MORE: &str = "1b-400";

/// A filter: the formula that the code evaluates, and the constant that it uses.
pub struct Filter {
    /// The name of the predicate.
    pub name: &'static str,
    /// The constant in the code.
    pub constant: f64,
    /// The formula, traced: determinant, permanent, and the slack of the filter for any doubles.
    formula: Formula,
    /// The kinds of filters that use the constant.
    kinds: &'static [Kind],
    /// The bound of the static filter.
    of_extents: Option<fn([f64; 3]) -> f64>,
    /// The exact determinant, from its definition.
    definition: Option<Polynomial>,
    /// The argument about near ties, if the constant needs one.
    near: Near,
}

struct Formula {
    determinant: Traced,
    permanent: Traced,
    slack: Option<Traced>,
}

/// The ways in which filters use a constant B.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// |d| ≥ S, with S from the extents of the scene.
    Static,
    /// |d| ≥ fl(B·p), where no product underflows.
    SemiStatic,
    /// |d| > fl(fl(B·p) + s), for any doubles.
    Anywhere,
    /// |d| beyond a bound from the normal and the extents: one line or plane, many points.
    Beside,
    /// |d| > fl(B·p) of constructed vertices, whose coordinates have slacks.
    Constructed,
}

impl Kind {
    /// The kind's name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Kind::Static => "static",
            Kind::SemiStatic => "semi-static",
            Kind::Anywhere => "any doubles",
            Kind::Beside => "one line or plane",
            Kind::Constructed => "constructed",
        }
    }
}

/// The argument about near ties.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Near {
    /// None: the roundings are counted.
    Counted,
    /// Half of the first of two sums.
    HalfASum,
    /// Half of the first of two sums, and the lemma of `docs/FILTERS.md` about differences.
    Lemma,
}

/// A proved constant.
pub struct Proved {
    /// The predicate.
    pub name: &'static str,
    /// The kind of filters that uses the constant.
    pub kind: &'static str,
    /// The constant in the code.
    pub constant: f64,
    /// The least double for which Gappa proves the filter.
    pub least: f64,
    /// The script for the double below, which has to be refused.
    pub below: String,
}

/// All filters of `exact`.
#[must_use]
pub fn filters() -> Vec<Filter> {
    let [b, sigma] = [Traced::input("B"), Traced::input("σ")];
    // The bound B·p + s is traced, and taken apart again: its parts are what the code has computed.
    let of = |bounded: anywhere::Bounded<Traced>| {
        let Node::Add(product, slack) = bounded.bound.node() else { panic!("a bound is a sum") };
        let Node::Mul(_, permanent) = product.node() else { panic!("of a product and the slack") };
        Formula { determinant: bounded.determinant, permanent, slack: Some(slack) }
    };
    let flat: [[Traced; 2]; 4] = ["a", "b", "c", "d"].map(Traced::point);
    let solid: [[Traced; 3]; 5] = ["a", "b", "c", "d", "e"].map(Traced::point);
    let ([p, q, r, s], [a, c, d, e, f]) = (flat, solid);
    let all = &[Kind::Static, Kind::SemiStatic, Kind::Anywhere];
    let mut filters = vec![
        Filter {
            name: "orient2d",
            constant: bound::ORIENT2D,
            formula: of(anywhere::orient2d_by([p, q, r], b, sigma)),
            kinds: all,
            of_extents: Some(|[x, y, _]| bound::static_orient2d([x, y])),
            definition: Some(defined(&[&p, &q, &r], false)),
            near: Near::Counted,
        },
        Filter {
            name: "orient3d",
            constant: bound::ORIENT3D,
            formula: of(anywhere::orient3d_by([a, c, d, e], b, sigma)),
            kinds: all,
            of_extents: Some(bound::static_orient3d),
            definition: Some(defined(&[&a, &c, &d, &e], false)),
            near: Near::HalfASum,
        },
        Filter {
            name: "incircle",
            constant: bound::INCIRCLE,
            formula: of(anywhere::incircle_by([p, q, r, s], b, sigma)),
            kinds: all,
            of_extents: Some(|[x, y, _]| bound::static_incircle([x, y])),
            definition: Some(defined(&[&p, &q, &r, &s], true)),
            near: Near::Lemma,
        },
        Filter {
            name: "insphere",
            constant: bound::INSPHERE,
            formula: of(anywhere::insphere_by([a, c, d, e, f], b, sigma)),
            kinds: all,
            of_extents: Some(bound::static_insphere),
            definition: Some(defined(&[&a, &c, &d, &e, &f], true)),
            near: Near::Counted,
        },
    ];
    let line = Side::of_line([p, q], Traced::point("extent "));
    let plane = Side::of_plane([a, c, d], Traced::point("extent "));
    filters.push(Filter {
        name: "orient2d",
        constant: bound::ORIENT2D,
        formula: Formula { determinant: line.determinant(r), permanent: line.permanent, slack: None },
        kinds: &[Kind::Beside],
        of_extents: None,
        definition: Some(defined(&[&p, &q, &r], false)),
        near: Near::Counted,
    });
    filters.push(Filter {
        name: "orient3d",
        constant: bound::ORIENT3D,
        formula: Formula { determinant: plane.determinant(e), permanent: plane.permanent, slack: None },
        kinds: &[Kind::Beside],
        of_extents: None,
        definition: Some(defined(&[&a, &c, &d, &e], false)),
        near: Near::HalfASum,
    });
    let near = |x: Traced| Approximate::near(x, Traced::input(format!("slack of {}", x.text(1))));
    let flat_near = flat.map(|p| p.map(near));
    let spatial = solid.map(|p| p.map(near));
    let constructed = [
        ("compare", filter::COMPARE, filter::difference(flat_near[0][0], flat_near[1][0])),
        ("orient2d", filter::ORIENT2D, filter::turn(flat_near[0], flat_near[1], flat_near[2])),
        ("orient3d", filter::ORIENT3D, filter::volume(spatial[0], spatial[1], spatial[2], spatial[3])),
    ];
    for (name, constant, approximate) in constructed {
        let [determinant, permanent] = approximate.parts();
        filters.push(Filter {
            name,
            constant,
            formula: Formula { determinant, permanent, slack: None },
            kinds: &[Kind::Constructed],
            of_extents: None,
            definition: None,
            near: Near::Counted,
        });
    }
    filters
}

/// The determinant of rows of points, each with its squared length if it is lifted, and with a one.
fn defined<const D: usize>(points: &[&[Traced; D]], is_lifted: bool) -> Polynomial {
    let rows: Vec<Vec<Polynomial>> = points
        .iter()
        .map(|point| {
            let mut row: Vec<Polynomial> = point.iter().map(|&x| exact(x)).collect();
            if is_lifted {
                row.push(row.iter().fold(Polynomial::default(), |sum, x| sum.plus(&x.times(x), 1)));
            }
            row.push(Polynomial::constant(1));
            row
        })
        .collect();
    determinant(&rows)
}

impl Filter {
    /// Proves all uses of the filter, and finds the least constant of each.
    ///
    /// # Errors
    /// What is not proved.
    pub fn prove(&self, gappa: &Gappa) -> Result<Vec<Proved>, String> {
        let needed = self.needed(gappa).map_err(|error| format!("{}: {error}", self.name))?;
        let mut proved = Vec::new();
        for &kind in self.kinds {
            let holds = |constant: f64| gappa.proves(&needed.script(self.name, kind, constant));
            if !holds(self.constant) {
                let script = needed.script(self.name, kind, self.constant);
                return Err(format!(
                    "{}, {}: the constant in the code is not proved\n{script}",
                    self.name,
                    kind.name()
                ));
            }
            let least = least(self.constant, holds);
            let below = needed.script(self.name, kind, least.next_down());
            proved.push(Proved { name: self.name, kind: kind.name(), constant: self.constant, least, below });
        }
        Ok(proved)
    }

    /// The script that proves this constant for a kind of filters.
    ///
    /// # Errors
    /// What is not proved before.
    pub fn script(&self, gappa: &Gappa, kind: Kind, constant: f64) -> Result<String, String> {
        Ok(self.needed(gappa)?.script(self.name, kind, constant))
    }

    /// Proves everything about the formula that does not depend on the constant.
    fn needed(&self, gappa: &Gappa) -> Result<Needed, String> {
        let Formula { determinant: d, permanent: p, slack } = self.formula;
        self.is_the_determinant()?;
        let rules = Rules { gappa, precision: PRECISION };
        let constructed = self.kinds == [Kind::Constructed];
        // (Beside one line or plane, extents are at most 2^200: nothing overflows.)
        if self.kinds != [Kind::Beside] {
            dominated(d, p)?;
        }
        // In the lemma's proof, permanents are those of rounded differences.
        let (of_determinant, of_permanent) = if constructed {
            (Claim::slack(PRECISION), Claim::given())
        } else if self.near == Near::Lemma {
            (Claim::given(), Claim::given())
        } else {
            (Claim::difference(PRECISION), Claim::difference(PRECISION))
        };
        let under = self.underflow(constructed)?;
        let error = self.error(&mut Chain::new(&rules, of_determinant))?;
        let mut below = Chain::new(&rules, of_permanent);
        let permanent = below.claim(p)?.error;
        let slack = match slack {
            Some(slack) => below.claim(slack)?.error,
            None => "0".to_owned(),
        };
        Ok(Needed { error, permanent, slack, under })
    }

    /// Checks that the formula is the determinant, as polynomials in the coordinates.
    fn is_the_determinant(&self) -> Result<(), String> {
        let Some(definition) = &self.definition else { return Ok(()) };
        let found = exact(self.formula.determinant);
        if found == *definition {
            return Ok(());
        }
        Err(format!("the formula is not the determinant: {found:?} in place of {definition:?}"))
    }

    /// The bound of |x + y − D| over P where a sign could be wrong, d = fl(x + y).
    fn error(&self, chain: &mut Chain) -> Result<Number, String> {
        let d = self.formula.determinant;
        if self.near == Near::Counted {
            return Ok(chain.before_last_sum(d)?.error);
        }
        let (Node::Add(x, y) | Node::Sub(x, y)) = d.node() else { return Err("no last sum".into()) };
        let (Node::Add(s, t) | Node::Sub(s, t)) = x.node() else { return Err("no first of two sums".into()) };
        let [s, t, y] = [chain.claim(s)?, chain.claim(t)?, chain.claim(y)?];
        chain.near_tie([&s, &t, &y], self.near == Near::Lemma, self.name)
    }

    /// Bounds what underflow can lose, and compares permanents.
    ///
    /// The permanent of the determinant and the exact value of p have to be the same polynomial. What η adds to it is
    /// compared with the slack.
    fn underflow(&self, constructed: bool) -> Result<Underflow, String> {
        let atom: &dyn Fn(Traced) -> Polynomial = if constructed { &with_slacks } else { &magnitude };
        // Many points are asked about one line or plane: the last of the arguments.
        let queried = if self.name == "orient2d" { "c" } else { "d" };
        let of = |z: Traced, atom: &dyn Fn(Traced) -> Polynomial| {
            let whole = permanent(z, atom);
            let is_beside = self.kinds == [Kind::Beside];
            if is_beside { whole.renamed(|symbol| extent_of(symbol, Some(queried))) } else { whole }
        };
        let [lost, whole] = of(self.formula.determinant, atom).split(ETA);
        let [lost_in_p, whole_p] = of(self.formula.permanent, &magnitude).split(ETA);
        if whole != whole_p {
            return Err(format!("the permanent is not that of the determinant: {whole_p:?} in place of {whole:?}"));
        }
        let mut anywhere = 0;
        if let Some(slack) = self.formula.slack {
            let [_, slack] = permanent(slack, &magnitude).split(ETA);
            anywhere = covered(&lost, &slack)?.max(covered(&lost_in_p, &slack)?);
        }
        if let Some(bound) = self.of_extents {
            let [lost, whole] = [lost.clone(), whole].map(|p| p.renamed(|symbol| extent_of(symbol, None)));
            divides(&lost, &whole)?;
            is_bound(&whole, self.constant, bound)?;
        }
        Ok(Underflow { anywhere, terms: lost.weight().max(lost_in_p.weight()) })
    }
}

/// The facts about a formula that do not depend on its constant.
struct Needed {
    /// |x + y − D| over P, where a sign could be wrong.
    error: Number,
    /// The error of p over P.
    permanent: Number,
    /// The error of the slack over itself.
    slack: Number,
    under: Underflow,
}

impl Needed {
    /// The last step: beyond the bound, x + y exceeds its error.
    ///
    /// |d| ≤ (1 + u)|x + y|, as a sum loses nothing to underflow.
    fn script(&self, name: &str, kind: Kind, constant: f64) -> String {
        let Needed { error: k, permanent: e, slack, under } = self;
        let b = dyadic(constant);
        let u = "1b-53";
        let goals = match kind {
            // S is computed upwards, and enlarged by 8u; extents are not below any difference. An η is 2^-1075 over two
            // to five extents of 2^-140 and more.
            Kind::Static => {
                let lost = format!("{}b-375", under.terms);
                format!("B * (1 + 8b-53) * (1 - {u}) - (1 + {u}) * ({k} * (1 + {lost}) + {lost}) >= {MORE}")
            }
            Kind::SemiStatic => format!("B * (1 - {e}) * (1 - {u}) - (1 + {u}) * {k} >= {MORE}"),
            // As for the semi-static filter, with one more rounding for the slack; and the slack pays for all η, of
            // which one is 2^-115 of σ.
            Kind::Anywhere => {
                let lost = format!("{}b-115", 2 * under.anywhere);
                format!(
                    "B * (1 - {e}) * (1 - {u}) * (1 - {u}) - (1 + {u}) * {k} >= {MORE}\n  /\\ (1 - {u}) * ((1 - {slack}) * (1 - \
                     1b-40) - 1b-115 - B * {lost}) - (1 + {u}) * ({k} * {lost} + {lost}) >= {MORE}"
                )
            }
            // Enlarged by 8u too, before a slack that pays for all η.
            Kind::Beside => {
                format!("B * (1 - {e}) * (1 - {u}) * (1 + 8b-53) * (1 - {u}) * (1 - {u}) - (1 + {u}) * {k} >= {MORE}")
            }
            Kind::Constructed => {
                let lost = format!("{}b{}", under.terms, over_three_slacks());
                format!("B * (1 - {e}) * (1 - {u}) - (1 + {u}) * ({k} * (1 + {lost}) + {lost}) >= {MORE}")
            }
        };
        format!("# {name}, {}: a sign is certain beyond the bound\nB = {b};\n{{ {goals} }}\n", kind.name())
    }
}

/// A double as a whole number times a power of two, as Gappa reads it.
#[must_use]
pub fn dyadic(x: f64) -> Number {
    let bits = x.to_bits();
    let exponent = i64::try_from(bits >> 52 & 0x7ff).expect("11 bits");
    format!("{}b{}", (bits & ((1 << 52) - 1)) | 1 << 52, exponent - 1075)
}

/// The least double that `holds`, at most `constant`, which does.
///
/// Slacks are small, so the search goes down from the constant, by twice as many doubles each time.
pub(crate) fn least(constant: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut high, mut step) = (constant.to_bits(), 1);
    while holds(f64::from_bits(high - step)) {
        high -= step;
        step *= 2;
    }
    let mut low = high - step;
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if holds(f64::from_bits(middle)) { high = middle } else { low = middle }
    }
    f64::from_bits(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// These parts of the proofs need no prover.
    #[test]
    fn formulas_are_determinants_and_permanents_are_theirs() {
        let filters = filters();
        assert_eq!(filters.len(), 9);
        for filter in filters {
            filter.is_the_determinant().unwrap_or_else(|why| panic!("{why}"));
            let is_constructed = filter.kinds == [Kind::Constructed];
            let under = filter.underflow(is_constructed).unwrap_or_else(|why| panic!("{}: {why}", filter.name));
            assert!(under.terms > 0 || filter.name == "compare");
            let Formula { determinant, permanent, .. } = filter.formula;
            assert_eq!(dominated(determinant, permanent).is_ok(), filter.kinds != [Kind::Beside], "{}", filter.name);
        }
    }

    #[test]
    fn other_formulas_are_refused() {
        let with = |change: fn(&mut [Filter; 2])| {
            let mut filters = filters().into_iter();
            let [orient2d, orient3d] = [filters.next(), filters.next()].map(|filter| filter.expect("four and more"));
            let mut both = [orient2d, orient3d];
            change(&mut both);
            let [_, changed] = both;
            changed
        };
        let of_flat = with(|both| both[1].formula.determinant = both[0].formula.determinant);
        assert!(of_flat.is_the_determinant().is_err_and(|why| why.starts_with("the formula is not the determinant")));
        let of_flat = with(|both| both[1].formula.permanent = both[0].formula.permanent);
        assert!(of_flat.underflow(false).is_err_and(|why| why.starts_with("the permanent is not")));
        assert!(dominated(of_flat.formula.determinant, of_flat.formula.permanent).is_err());
        let of_flat = with(|both| both[1].formula.slack = Some(Traced::input("σ")));
        assert!(of_flat.underflow(false).is_err_and(|why| why.starts_with("the slack has no term")));
        let of_flat = with(|both| both[1].of_extents = Some(|[x, y, _]| bound::static_orient2d([x, y])));
        assert!(of_flat.underflow(false).is_err_and(|why| why.starts_with("the static bound of extents")));
    }
}
