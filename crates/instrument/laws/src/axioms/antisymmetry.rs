//! The law of antisymmetry: an odd permutation of the arguments changes the sign.

use std::collections::BTreeMap;
use std::sync::{Mutex, OnceLock, PoisonError};

use predicament_predicates::{Derived, PredicateKind, Predicates, Question, Sign, Vertex, ZeroMeaning};

use super::{Answer, Law, Violation, says_nothing};

/// The maximum number of arguments of a predicate.
const MOST: usize = predicament_predicates::formula::MOST_POINTS;

/// An order of arguments: the index of the argument at each position, and the parity.
struct Order {
    places: [usize; MOST],
    parity: Sign,
}

/// Checks the signs of one query in every order of its arguments.
///
/// The five predicates are signs of determinants with one row (or, for the comparison, one term) per vertex, so an odd
/// permutation flips the sign. A formula has the orders that keep or flip its sign. A violation has two answers: the
/// first order whose answer is a sign, and an order that contradicts it.
///
/// # Panics
/// If the number of vertices in `args` is not the predicate's.
pub fn antisymmetry<P: Predicates + ?Sized>(
    session: &P,
    question: Question,
    args: &[Vertex],
    zero: ZeroMeaning,
) -> Vec<Violation> {
    let signs: Vec<Sign> =
        orders(question.kind()).iter().map(|order| question.ask(session, &order.of(args)[..args.len()])).collect();
    violations(question, args, &signs, zero)
}

/// Checks [`antisymmetry`] of several queries, all in one batch.
///
/// # Panics
/// If the number of vertices in a query is not the predicate's.
pub fn antisymmetry_of_all<P: Predicates + ?Sized>(
    session: &P,
    question: Question,
    queries: &[&[Vertex]],
    zero: ZeroMeaning,
) -> Vec<Vec<Violation>> {
    let (orders, arity) = (orders(question.kind()), question.kind().arity());
    let mut asked = Vec::with_capacity(queries.len() * orders.len() * arity);
    for args in queries {
        orders.iter().for_each(|order| asked.extend_from_slice(&order.of(args)[..args.len()]));
    }
    let mut signs = vec![Sign::Zero; queries.len() * orders.len()];
    question.ask_batch(session, &asked, &mut signs);
    queries
        .iter()
        .zip(signs.chunks(orders.len()))
        .map(|(args, signs)| violations(question, args, signs, zero))
        .collect()
}

/// The violations among the answers to every order.
fn violations(question: Question, args: &[Vertex], signs: &[Sign], zero: ZeroMeaning) -> Vec<Violation> {
    let answers = || orders(question.kind()).iter().zip(signs).filter(|(_, sign)| !says_nothing(**sign, zero));
    let Some((first, &sign)) = answers().next() else { return Vec::new() };
    let even = sign * first.parity;
    let answer = |order: &Order, sign| Answer { question, args: order.of(args)[..args.len()].to_vec(), sign };
    let contradictions = answers().filter(|(order, sign)| **sign * order.parity != even);
    let violation = |(order, &other): (&Order, &Sign)| Violation {
        law: Law::Antisymmetry,
        answers: vec![answer(first, sign), answer(order, other)],
    };
    contradictions.map(violation).collect()
}

impl Order {
    /// The arguments in this order; entries after the last argument are unused.
    fn of(&self, args: &[Vertex]) -> [Vertex; MOST] {
        self.places.map(|at| args[at])
    }
}

/// All orders of a predicate's arguments, the given one first.
fn orders(kind: PredicateKind) -> &'static [Order] {
    static ORDERS: [OnceLock<Vec<Order>>; PredicateKind::ALL.len()] = [const { OnceLock::new() }; 5];
    if let PredicateKind::Derived(derived) = kind {
        return orders_of_formula(derived);
    }
    ORDERS[kind.index()].get_or_init(|| {
        let mut orders = Vec::new();
        let items: Vec<Vertex> = (0..kind.arity()).map(Vertex::input).collect();
        each_order(&items, &mut |order, parity| {
            let mut places = [0; MOST];
            order.iter().zip(&mut places).for_each(|(item, place)| *place = item.index());
            orders.push(Order { places, parity });
        });
        orders
    })
}

/// The orders of a formula's arguments that keep or flip its sign, the given one first; kept for each formula.
fn orders_of_formula(derived: Derived) -> &'static [Order] {
    static KNOWN: Mutex<BTreeMap<Derived, &'static [Order]>> = Mutex::new(BTreeMap::new());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    known.entry(derived).or_insert_with(|| {
        let order = |to: &[usize], parity| {
            let mut places = [0; MOST];
            to.iter().zip(&mut places).for_each(|(&at, place)| *place = at);
            Order { places, parity }
        };
        let given: Vec<usize> = (0..derived.formula().arity()).collect();
        let mut orders = vec![order(&given, Sign::Positive)];
        orders.extend(derived.formula().swaps().iter().map(|swap| {
            let parity = if swap.turns { Sign::Negative } else { Sign::Positive };
            order(&swap.to, parity)
        }));
        orders.leak()
    })
}

/// Calls `visit` with every permutation of `items` and its parity, the given
/// order first.
pub fn each_order(items: &[Vertex], visit: &mut impl FnMut(&[Vertex], Sign)) {
    fn place(items: &mut [Vertex], at: usize, parity: Sign, visit: &mut impl FnMut(&[Vertex], Sign)) {
        if at == items.len() {
            return visit(items, parity);
        }
        for chosen in at..items.len() {
            items.swap(at, chosen);
            place(items, at + 1, if chosen == at { parity } else { -parity }, visit);
            items.swap(at, chosen);
        }
    }
    place(&mut items.to_vec(), 0, Sign::Positive, visit);
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_order_comes_once_with_the_parity_of_its_inversions() {
        let items: Vec<Vertex> = (0..5).map(Vertex::input).collect();
        let mut seen = BTreeSet::new();
        each_order(&items, &mut |order, parity| {
            let inversions = (0..5).flat_map(|i| (i..5).filter(move |&j| order[i] > order[j])).count();
            assert_eq!(parity, if inversions % 2 == 0 { Sign::Positive } else { Sign::Negative });
            assert!(seen.insert(order.to_vec()));
        });
        assert_eq!(seen.len(), 120);
    }
}
