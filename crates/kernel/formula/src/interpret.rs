//! The value of a formula in any ring of numbers, from its syntax tree alone.
//!
//! The tree is evaluated as it is written: vectors component by component, determinants by expansion along the first
//! row. Judges use this evaluation. It shares nothing with [`Program`](crate::Program), which backends use.

use std::collections::BTreeMap;

use crate::{Expression, Formula, Function, Node, WEIGHT};

/// Numbers that can be added, subtracted and multiplied.
pub trait Ring: Clone {
    /// A whole number.
    fn whole(number: f64) -> Self;

    /// The sum, or the difference if `minus` is true.
    #[must_use]
    fn plus(&self, other: &Self, minus: bool) -> Self;

    /// The product.
    #[must_use]
    fn times(&self, other: &Self) -> Self;

    /// The negative.
    #[must_use]
    fn negated(&self) -> Self;
}

/// The value of an expression.
#[derive(Clone)]
enum Value<R> {
    Scalar(R),
    Vector(Vec<R>),
    /// The coordinates of a point, and its weight.
    Point(Vec<R>, Option<R>),
}

type Names<'f, R> = BTreeMap<&'f str, Value<R>>;

/// The value of a formula at points, which end with their weights if the formula has weights.
///
/// `None` if a point is missing.
pub fn interpret<R: Ring>(formula: &Formula, points: Vec<Vec<R>>) -> Option<R> {
    if points.len() != formula.arity() {
        return None;
    }
    let mut names = Names::new();
    for (name, mut coordinates) in formula.points().iter().zip(points) {
        let weight = if formula.is_weighted() { coordinates.pop() } else { None };
        names.insert(name.as_str(), Value::Point(coordinates, weight));
    }
    for (name, expression) in &formula.syntax().definitions {
        let value = expression_value(expression, &names)?;
        names.insert(name, value);
    }
    scalar(&formula.syntax().value, &names)
}

fn scalar<R: Ring>(expression: &Expression, names: &Names<'_, R>) -> Option<R> {
    match expression_value(expression, names)? {
        Value::Scalar(number) => Some(number),
        _ => None,
    }
}

fn vector<R: Ring>(expression: &Expression, names: &Names<'_, R>) -> Option<Vec<R>> {
    match expression_value(expression, names)? {
        Value::Vector(parts) | Value::Point(parts, _) => Some(parts),
        Value::Scalar(_) => None,
    }
}

/// The sum or difference of two values of one shape.
fn sum<R: Ring>(a: &Value<R>, b: &Value<R>, minus: bool) -> Option<Value<R>> {
    Some(match (a, b) {
        (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(a.plus(b, minus)),
        (Value::Vector(a) | Value::Point(a, _), Value::Vector(b) | Value::Point(b, _)) => {
            Value::Vector(a.iter().zip(b).map(|(a, b)| a.plus(b, minus)).collect())
        }
        _ => return None,
    })
}

fn expression_value<R: Ring>(expression: &Expression, names: &Names<'_, R>) -> Option<Value<R>> {
    let of = |expression| expression_value(expression, names);
    Some(match &expression.node {
        Node::Number(number) => Value::Scalar(R::whole(*number)),
        Node::Name(name) => names.get(name.as_str())?.clone(),
        Node::Axes(inner, axes) => {
            let (parts, weight) = match of(inner)? {
                Value::Scalar(_) => return None,
                Value::Vector(parts) => (parts, None),
                Value::Point(parts, weight) => (parts, weight),
            };
            let pick = |&axis: &usize| match &weight {
                Some(weight) if axis == WEIGHT => Some(weight.clone()),
                _ => parts.get(axis).cloned(),
            };
            let mut picked: Vec<R> = axes.iter().map(pick).collect::<Option<_>>()?;
            if picked.len() == 1 { Value::Scalar(picked.remove(0)) } else { Value::Vector(picked) }
        }
        Node::Vector(parts) => {
            let mut joined = Vec::new();
            for part in parts {
                match of(part)? {
                    Value::Scalar(number) => joined.push(number),
                    Value::Vector(parts) | Value::Point(parts, _) => joined.extend(parts),
                }
            }
            Value::Vector(joined)
        }
        Node::Minus(inner) => match of(inner)? {
            Value::Scalar(number) => Value::Scalar(number.negated()),
            Value::Vector(parts) | Value::Point(parts, _) => Value::Vector(parts.iter().map(R::negated).collect()),
        },
        Node::Plus(a, b) => sum(&of(a)?, &of(b)?, false)?,
        Node::Difference(a, b) => sum(&of(a)?, &of(b)?, true)?,
        Node::Times(a, b) => match (of(a)?, of(b)?) {
            (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(a.times(&b)),
            (Value::Scalar(factor), Value::Vector(parts) | Value::Point(parts, _))
            | (Value::Vector(parts) | Value::Point(parts, _), Value::Scalar(factor)) => {
                Value::Vector(parts.iter().map(|part| part.times(&factor)).collect())
            }
            _ => return None,
        },
        Node::Power(base, exponent) => {
            let base = scalar(base, names)?;
            Value::Scalar((1..*exponent).fold(base.clone(), |power, _| power.times(&base)))
        }
        Node::Call(function, arguments) => call(*function, arguments, names)?,
    })
}

fn call<R: Ring>(function: Function, arguments: &[Expression], names: &Names<'_, R>) -> Option<Value<R>> {
    Some(match (function, arguments) {
        (Function::Det, rows) => {
            let matrix: Vec<Vec<R>> = rows.iter().map(|row| vector(row, names)).collect::<Option<_>>()?;
            Value::Scalar(determinant(&matrix))
        }
        (Function::Sq, [of]) => match expression_value(of, names)? {
            Value::Scalar(number) => Value::Scalar(number.times(&number)),
            Value::Vector(parts) | Value::Point(parts, _) => Value::Scalar(dot(&parts, &parts)?),
        },
        (Function::Dot, [a, b]) => Value::Scalar(dot(&vector(a, names)?, &vector(b, names)?)?),
        (Function::Cross, [a, b]) => {
            let (u, v) = (vector(a, names)?, vector(b, names)?);
            let turn = |i: usize, j: usize| u[i].times(&v[j]).plus(&u[j].times(&v[i]), true);
            match u.len() {
                2 => Value::Scalar(turn(0, 1)),
                3 => Value::Vector(vec![turn(1, 2), turn(2, 0), turn(0, 1)]),
                _ => return None,
            }
        }
        _ => return None,
    })
}

fn dot<R: Ring>(u: &[R], v: &[R]) -> Option<R> {
    u.iter().zip(v).map(|(x, y)| x.times(y)).reduce(|sum, term| sum.plus(&term, false))
}

/// The determinant, expanded along the first row.
fn determinant<R: Ring>(matrix: &[Vec<R>]) -> R {
    let [first, rest @ ..] = matrix else { return R::whole(1.0) };
    let term = |(column, entry): (usize, &R)| {
        let minor: Vec<Vec<R>> = rest.iter().map(|row| [&row[..column], &row[column + 1..]].concat()).collect();
        let term = if rest.is_empty() { entry.clone() } else { entry.times(&determinant(&minor)) };
        if column % 2 == 0 { term } else { term.negated() }
    };
    let terms = first.iter().enumerate().map(term);
    terms.reduce(|sum, term| sum.plus(&term, false)).unwrap_or_else(|| R::whole(0.0))
}
