//! The text of a formula, and its syntax tree.
//!
//! ```text
//! formula   = (name "=" sum ";")* sum
//! sum       = product (("+" | "-") product)*
//! product   = factor ("*" factor)*
//! factor    = "-" factor | power
//! power     = primary ("^" integer)?
//! primary   = whole number | name | name "." axes | function "(" sum ("," sum)* ")" | "[" sum ("," sum)* "]" | "(" sum ")"
//! axes      = one or more of x, y, z, w
//! ```
//!
//! A name is a point, or was defined before with `=`. A point is the vector of its coordinates; `a.x` is a coordinate,
//! `a.xy` the vector of two. `a.w` is the weight of a point, which is not part of the vector. `[v, s]` joins vectors
//! and scalars into one vector. The functions are `det` (of rows), `dot`, `sq` (the squared length of a vector, or the
//! square of a scalar) and `cross` (of two vectors: a scalar in the plane, a vector in space). There is no division and
//! no root: the sign of a quotient is the sign of a product, and `docs/FORMULAS.md` shows how to remove both.

mod parse;
mod token;

use std::ops::Range;

pub use parse::parse;

/// A place in the text of a formula, in bytes.
pub type Span = Range<usize>;

/// A part of a formula, with its place in the text.
#[derive(Clone, PartialEq, Debug)]
pub struct Expression {
    /// The expression.
    pub node: Node,
    /// The place in the text.
    pub span: Span,
}

/// A node of the syntax tree.
#[derive(Clone, PartialEq, Debug)]
pub enum Node {
    /// A whole number.
    Number(f64),
    /// A point, or a name that was defined before.
    Name(String),
    /// Coordinates of a point or components of a vector: a scalar if there is one, else a vector.
    Axes(Box<Expression>, Vec<usize>),
    /// Vectors and scalars joined to one vector.
    Vector(Vec<Expression>),
    /// The negative.
    Minus(Box<Expression>),
    /// A sum.
    Plus(Box<Expression>, Box<Expression>),
    /// A difference.
    Difference(Box<Expression>, Box<Expression>),
    /// A product of scalars, or of a scalar and a vector.
    Times(Box<Expression>, Box<Expression>),
    /// A power with a whole exponent of at least 1.
    Power(Box<Expression>, u32),
    /// A function of its arguments.
    Call(Function, Vec<Expression>),
}

/// The functions of formulas.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Function {
    /// The determinant of rows.
    Det,
    /// The scalar product of two vectors.
    Dot,
    /// The squared length of a vector, or the square of a scalar.
    Sq,
    /// The cross product: a scalar in the plane, a vector in space.
    Cross,
}

impl Function {
    /// All functions.
    pub const ALL: [Function; 4] = [Function::Det, Function::Dot, Function::Sq, Function::Cross];

    /// The function's name in formulas.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Function::Det => "det",
            Function::Dot => "dot",
            Function::Sq => "sq",
            Function::Cross => "cross",
        }
    }
}

/// A formula as text was read: definitions, in order, then the value.
#[derive(Clone, PartialEq, Debug)]
pub struct Syntax {
    /// Names and their expressions; each may use the names before it.
    pub definitions: Vec<(String, Expression)>,
    /// The polynomial.
    pub value: Expression,
}

impl Syntax {
    /// The names of the points, in alphabetical order: all names that the text uses and does not define.
    #[must_use]
    pub fn points(&self) -> Vec<String> {
        let mut found = Vec::new();
        let expressions = self.definitions.iter().map(|(_, expression)| expression).chain([&self.value]);
        expressions.for_each(|expression| expression.names(&mut found));
        found.retain(|name| self.definitions.iter().all(|(defined, _)| defined != name));
        found.sort_unstable();
        found.dedup();
        found
    }
}

impl Syntax {
    /// Returns true if the text reads the weight of one of these points.
    #[must_use]
    pub fn is_weighted(&self, points: &[String]) -> bool {
        let expressions = self.definitions.iter().map(|(_, expression)| expression).chain([&self.value]);
        expressions.into_iter().any(|expression| expression.reads_weight(points))
    }
}

/// The place of w among the names of coordinates.
pub const WEIGHT: usize = 3;

impl Expression {
    fn reads_weight(&self, points: &[String]) -> bool {
        match &self.node {
            Node::Number(_) | Node::Name(_) => false,
            Node::Axes(of, axes) => match &of.node {
                Node::Name(name) => points.contains(name) && axes.contains(&WEIGHT),
                _ => of.reads_weight(points),
            },
            Node::Minus(of) | Node::Power(of, _) => of.reads_weight(points),
            Node::Plus(a, b) | Node::Difference(a, b) | Node::Times(a, b) => {
                a.reads_weight(points) || b.reads_weight(points)
            }
            Node::Vector(parts) | Node::Call(_, parts) => parts.iter().any(|part| part.reads_weight(points)),
        }
    }

    fn names(&self, found: &mut Vec<String>) {
        match &self.node {
            Node::Number(_) => {}
            Node::Name(name) => found.push(name.clone()),
            Node::Axes(of, _) | Node::Minus(of) | Node::Power(of, _) => of.names(found),
            Node::Plus(a, b) | Node::Difference(a, b) | Node::Times(a, b) => {
                [a, b].into_iter().for_each(|e| e.names(found))
            }
            Node::Vector(parts) | Node::Call(_, parts) => parts.iter().for_each(|e| e.names(found)),
        }
    }
}

/// The reason why a text is not a formula, and the place in the text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FormulaError {
    /// The reason, with the cure.
    pub reason: String,
    /// The place in the text.
    pub span: Span,
}

impl FormulaError {
    pub(crate) fn new(span: &Span, reason: impl Into<String>) -> FormulaError {
        FormulaError { reason: reason.into(), span: span.clone() }
    }

    /// The error with the line of the text that it is about, and a mark below the place.
    #[must_use]
    pub fn shown(&self, text: &str) -> String {
        let start = self.span.start.min(text.len());
        let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
        let line = &text[line_start..line_end];
        let number = text[..start].matches('\n').count() + 1;
        let before = text[line_start..start].chars().count();
        let marked = text[start..self.span.end.clamp(start, line_end)].chars().count().max(1);
        format!(
            "formula, line {number}, column {}: {}\n  {line}\n  {}{}",
            before + 1,
            self.reason,
            " ".repeat(before),
            "^".repeat(marked)
        )
    }
}

impl std::fmt::Display for FormulaError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "formula, byte {}: {}", self.span.start, self.reason)
    }
}

impl std::error::Error for FormulaError {}
