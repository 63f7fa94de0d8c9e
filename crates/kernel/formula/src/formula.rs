//! A predicate as a value: its name, its polynomial, and what is derived from it.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock, RwLock};

use crate::exact;
use crate::shipped::Compiled;
use crate::{Bits, Filter, FormulaError, Order, Polynomial, Program, Syntax, Terms, lower, parse};

/// The most points of a predicate.
pub const MOST_POINTS: usize = 8;

/// The most coordinates of a point, with its weight.
pub const MOST_COORDINATES: usize = 4;

/// The definition of a predicate, before anything is derived.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Definition {
    /// The name, for suites and the command line.
    pub name: String,
    /// The meaning of the sign, in one line.
    pub about: String,
    /// The formula.
    pub text: String,
    /// The names of the points, in the order of arguments; empty for all names of the text in alphabetical order.
    pub points: Vec<String>,
    /// The number of coordinates of a point, without weights; `None` for the smallest number that fits the formula.
    pub dimension: Option<usize>,
}

impl Definition {
    /// The definition of a formula without a name.
    #[must_use]
    pub fn anonymous(text: &str) -> Definition {
        Definition {
            name: "formula".to_owned(),
            about: "the sign of a formula".to_owned(),
            text: text.to_owned(),
            points: Vec::new(),
            dimension: None,
        }
    }
}

/// A permutation of the arguments that changes at most the sign of a predicate.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Swap {
    /// The new place of each argument.
    pub to: Vec<usize>,
    /// True if the sign turns.
    pub turns: bool,
}

/// Two arguments whose exchange changes at most the sign of a predicate.
#[derive(Debug)]
struct Exchange {
    pair: [usize; 2],
    turns: bool,
}

/// Lists of terms that were derived before.
type Known<K> = RwLock<BTreeMap<K, Arc<Terms>>>;

/// A predicate: the sign of a polynomial in the coordinates of its arguments, with all derived data.
#[derive(Debug)]
pub struct Formula {
    definition: Definition,
    syntax: Syntax,
    dimension: usize,
    is_weighted: bool,
    program: Program,
    polynomial: Polynomial,
    filter: Filter,
    bits: Bits,
    compiled: Option<Compiled>,
    swaps: OnceLock<Vec<Swap>>,
    exchanges: OnceLock<Vec<Exchange>>,
    terms: Known<(Order, Vec<usize>)>,
    moved: Known<Vec<bool>>,
}

impl Formula {
    /// Reads a definition and derives filter and bits.
    ///
    /// # Errors
    /// [`FormulaError`] with the place in the formula and the reason.
    pub fn new(mut definition: Definition) -> Result<Formula, FormulaError> {
        let text = definition.text.clone();
        let whole = 0..text.len();
        let refuse = |reason: String| FormulaError { reason, span: whole.clone() };
        let syntax = parse(&text)?;
        let used = syntax.points();
        if definition.points.is_empty() {
            definition.points.clone_from(&used);
        }
        if let Some(missing) = used.iter().find(|name| !definition.points.contains(name)) {
            return Err(refuse(format!(
                "the formula uses `{missing}`, which is not one of the points {:?}",
                definition.points
            )));
        }
        if let Some(idle) = definition.points.iter().find(|name| !used.contains(name)) {
            return Err(refuse(format!("the formula does not use the point `{idle}`")));
        }
        if definition.points.len() > MOST_POINTS || definition.points.is_empty() {
            let count = definition.points.len();
            return Err(refuse(format!("a predicate has 1 to {MOST_POINTS} points, and this formula has {count}")));
        }
        let (dimension, program) = dimensioned(&syntax, &definition)?;
        let is_weighted = syntax.is_weighted(&definition.points);
        let count = dimension + usize::from(is_weighted);
        let polynomial = Polynomial::of(&program, definition.points.len(), count).map_err(&refuse)?;
        if polynomial.degree() == 0 {
            let reason = if polynomial.is_empty() { "the formula is always zero" } else { "the formula is a constant" };
            return Err(refuse(reason.to_owned()));
        }
        let filter = Filter::of(&program).map_err(&refuse)?;
        let bits = Bits::of_program(&program, polynomial.is_homogeneous());
        let compiled = Compiled::of(&definition, dimension);
        let (swaps, exchanges) = (OnceLock::new(), OnceLock::new());
        let (terms, moved) = (RwLock::default(), RwLock::default());
        Ok(Formula {
            definition,
            syntax,
            dimension,
            is_weighted,
            program,
            polynomial,
            filter,
            bits,
            compiled,
            swaps,
            exchanges,
            terms,
            moved,
        })
    }

    /// The definition, with the names of all points.
    #[must_use]
    pub fn definition(&self) -> &Definition {
        &self.definition
    }

    /// The predicate's name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.definition.name
    }

    /// The meaning of the sign, in one line.
    #[must_use]
    pub fn about(&self) -> &str {
        &self.definition.about
    }

    /// The formula as it was written.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.definition.text
    }

    /// The names of the arguments.
    #[must_use]
    pub fn points(&self) -> &[String] {
        &self.definition.points
    }

    /// The number of arguments.
    #[must_use]
    pub fn arity(&self) -> usize {
        self.definition.points.len()
    }

    /// The number of coordinates of an argument, without its weight.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Returns true if arguments have a weight, the coordinate w behind the others.
    #[must_use]
    pub fn is_weighted(&self) -> bool {
        self.is_weighted
    }

    /// The number of coordinates of an argument, with its weight.
    #[must_use]
    pub fn coordinates(&self) -> usize {
        self.dimension + usize::from(self.is_weighted)
    }

    /// The syntax tree, for evaluations that share no code with the program.
    #[must_use]
    pub fn syntax(&self) -> &Syntax {
        &self.syntax
    }

    /// The operations, in the order of the estimate.
    #[must_use]
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// The expanded polynomial.
    #[must_use]
    pub fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }

    /// The filter of the estimate.
    #[must_use]
    pub fn filter(&self) -> &Filter {
        &self.filter
    }

    /// The bits of the integers that hold the value.
    #[must_use]
    pub fn bits(&self) -> &Bits {
        &self.bits
    }

    /// All permutations of the arguments, other than the identity, that keep or turn the sign.
    pub fn swaps(&self) -> &[Swap] {
        self.swaps.get_or_init(|| {
            let negated = self.polynomial.negated();
            let swap = |to: Vec<usize>| Some(Swap { turns: self.turns(&to, &negated)?, to });
            permutations(self.arity()).into_iter().skip(1).filter_map(swap).collect()
        })
    }

    /// True if a permutation of the arguments turns the sign, false if it keeps the sign, `None` if it does neither.
    fn turns(&self, to: &[usize], negated: &Polynomial) -> Option<bool> {
        let count = self.coordinates();
        let renamed = self.polynomial.mapped(|exponents| {
            let mut renamed = vec![0; exponents.len()];
            for (at, &exponent) in exponents.iter().enumerate() {
                renamed[to[at / count] * count + at % count] = exponent;
            }
            Some(renamed)
        })?;
        if renamed == *negated { Some(true) } else { (renamed == self.polynomial).then_some(false) }
    }

    /// Sorts arguments as far as exchanges of two keep or turn the sign; returns true if the order found turns it.
    pub fn sort<T>(&self, arguments: &mut [T], precedes: impl Fn(&T, &T) -> bool) -> bool {
        let exchanges = self.exchanges.get_or_init(|| {
            let (negated, n) = (self.polynomial.negated(), self.arity());
            let exchange = |[i, j]: [usize; 2]| {
                let mut to: Vec<usize> = (0..n).collect();
                to.swap(i, j);
                Some(Exchange { pair: [i, j], turns: self.turns(&to, &negated)? })
            };
            (0..n).flat_map(|i| (i + 1..n).map(move |j| [i, j])).filter_map(exchange).collect()
        });
        let mut turned = false;
        // Exchanges come by their first place. If two of them share a place, their other places can be exchanged, too:
        // so each place gets the first of all arguments that can come to it.
        for &Exchange { pair: [i, j], turns } in exchanges {
            if precedes(&arguments[j], &arguments[i]) {
                arguments.swap(i, j);
                turned ^= turns;
            }
        }
        turned
    }

    /// Returns true if the value is a multiple of the determinant of the arguments, taken as vectors from the origin.
    ///
    /// Then there are as many arguments as coordinates, the value is linear in each argument, and a swap of two
    /// arguments turns the sign. Only multiples of the determinant have these properties.
    #[must_use]
    pub fn is_determinant(&self) -> bool {
        let count = self.coordinates();
        let is_linear = |(exponents, _): (&[u8], i128)| {
            exponents.chunks(count).all(|point| point.iter().copied().map(u32::from).sum::<u32>() == 1)
        };
        self.arity() == count
            && self.polynomial.terms().all(is_linear)
            && self.swaps().len() + 1 == permutations(count).len()
            && self.swaps().iter().filter(|swap| swap.turns).count() == permutations(count).len() / 2
    }

    /// The estimate in doubles, and the magnitude that it must exceed for its sign to be certain.
    #[must_use]
    pub fn estimate(&self, points: &[&[f64]]) -> [f64; 2] {
        match self.compiled {
            Some(compiled) => (compiled.bounded)(points),
            None => self.interpreted(points),
        }
    }

    /// [`Formula::estimate`] by the list of operations, also if compiled code does the same.
    #[must_use]
    pub fn interpreted(&self, points: &[&[f64]]) -> [f64; 2] {
        self.filter.estimate(&self.program, |point, axis| points[point][axis])
    }

    /// The estimate in doubles alone.
    #[must_use]
    pub fn value(&self, points: &[&[f64]]) -> f64 {
        match self.compiled {
            Some(compiled) => (compiled.estimate)(points),
            None => self.program.estimate(|point, axis| points[point][axis]),
        }
    }

    /// The sign by the filter; `None` if it is not certain.
    #[must_use]
    pub fn certain(&self, points: &[&[f64]]) -> Option<Ordering> {
        let [value, bound] = self.estimate(points);
        if value.abs() > bound { value.partial_cmp(&0.0) } else { None }
    }

    /// The sign without rounding, for any finite doubles; `None` if a coordinate is not finite.
    #[must_use]
    pub fn sign(&self, points: &[&[f64]]) -> Option<Ordering> {
        if !points.iter().flat_map(|point| point.iter()).all(|x| x.is_finite()) {
            return None;
        }
        self.certain(points).or_else(|| Some(self.unfiltered(points).0))
    }

    /// The sign of finite points by exact arithmetic alone, and true if 128-bit integers sufficed.
    #[must_use]
    pub fn unfiltered(&self, points: &[&[f64]]) -> (Ordering, bool) {
        match exact::integers(&self.program, &self.bits, points) {
            Some(sign) => (sign, true),
            None => (exact::dyadic(&self.program, points), false),
        }
    }

    /// The terms that break ties for arguments with these ranks; see [`Terms::of`].
    ///
    /// # Errors
    /// The reason, if the list is too long to derive.
    pub fn terms(&self, ranks: &[usize], order: Order) -> Result<Arc<Terms>, String> {
        let key = (order, ranks.to_vec());
        let derive = || Terms::of(&self.polynomial, ranks, self.coordinates(), order);
        cached(&self.terms, key, derive)
    }

    /// The terms if some arguments move together; see [`Terms::of_moved`].
    ///
    /// # Errors
    /// The reason, if the list is too long to derive.
    pub fn moved_terms(&self, moves: &[bool]) -> Result<Arc<Terms>, String> {
        cached(&self.moved, moves.to_vec(), || Terms::of_moved(&self.polynomial, moves, self.coordinates()))
    }
}

impl PartialEq for Formula {
    fn eq(&self, other: &Formula) -> bool {
        self.definition == other.definition
    }
}

impl Eq for Formula {}

fn cached<K: Ord>(known: &Known<K>, key: K, derive: impl Fn() -> Result<Terms, String>) -> Result<Arc<Terms>, String> {
    // A poisoned lock is whole: entries are added, never changed.
    let found = known.read().unwrap_or_else(std::sync::PoisonError::into_inner).get(&key).cloned();
    if let Some(found) = found {
        return Ok(found);
    }
    let terms = Arc::new(derive()?);
    let mut known = known.write().unwrap_or_else(std::sync::PoisonError::into_inner);
    Ok(Arc::clone(known.entry(key).or_insert(terms)))
}

/// The dimension of the points and the program: the smallest dimension that fits, unless it is defined.
fn dimensioned(syntax: &Syntax, definition: &Definition) -> Result<(usize, Program), FormulaError> {
    let lowered = |dimension| lower(syntax, &definition.points, dimension).map(|program| (dimension, program));
    if let Some(dimension) = definition.dimension {
        if !(1..MOST_COORDINATES).contains(&dimension) {
            let reason = format!("points have 1 to 3 coordinates besides a weight, not {dimension}");
            return Err(FormulaError { reason, span: 0..definition.text.len() });
        }
        return lowered(dimension);
    }
    // The error of the plane is the one to show: most formulas that fit nothing are mistakes about it.
    (2..MOST_COORDINATES).find_map(|dimension| lowered(dimension).ok()).map_or_else(|| lowered(2), Ok)
}

/// All permutations of 0, 1, …, n − 1; the identity is the first.
fn permutations(n: usize) -> Vec<Vec<usize>> {
    let mut found = vec![Vec::new()];
    for _ in 0..n {
        found = found
            .into_iter()
            .flat_map(|start: Vec<usize>| {
                let rest = (0..n).filter(|next| !start.contains(next)).collect::<Vec<_>>();
                rest.into_iter().map(move |next| [start.as_slice(), &[next]].concat())
            })
            .collect();
    }
    found
}
