//! From the syntax tree to a program: the chosen order of operations.
//!
//! Determinants are expanded along the last column. Minors of the first columns are computed once for all rows. A sum
//! of three terms is (t₁ + t₂) + t₃, a sum of more is a balanced tree. So `det(a - d, b - d, c - d)` costs what a
//! hand-written orient3d does.

use std::collections::BTreeMap;

use crate::program::{Builder, Program};
use crate::syntax::{Expression, FormulaError, Function, Node, Syntax, WEIGHT};

/// The most rows of a determinant.
const MOST_ROWS: usize = 6;

/// The most operations of a program.
const MOST_OPS: usize = 5000;

/// The value of an expression: places of operations.
#[derive(Clone)]
enum Value {
    Scalar(usize),
    Vector(Vec<usize>),
}

/// The program of a formula about points of so many coordinates.
///
/// # Errors
/// [`FormulaError`] if the parts do not fit together, with the place.
pub fn lower(syntax: &Syntax, points: &[String], dimension: usize) -> Result<Program, FormulaError> {
    let mut lowering = Lowering { builder: Builder::default(), points, dimension, names: BTreeMap::new(), ops: 0 };
    for (name, expression) in &syntax.definitions {
        let value = lowering.value(expression)?;
        lowering.names.insert(name, value);
    }
    let value = lowering.scalar(&syntax.value)?;
    Ok(lowering.builder.finish(value))
}

struct Lowering<'f> {
    builder: Builder,
    points: &'f [String],
    dimension: usize,
    names: BTreeMap<&'f str, Value>,
    ops: usize,
}

impl<'f> Lowering<'f> {
    fn scalar(&mut self, expression: &'f Expression) -> Result<usize, FormulaError> {
        match self.value(expression)? {
            Value::Scalar(at) => Ok(at),
            Value::Vector(parts) => {
                let reason = format!("this is a vector of {}, and a number is needed here", parts.len());
                Err(FormulaError::new(&expression.span, reason))
            }
        }
    }

    fn vector(&mut self, expression: &'f Expression) -> Result<Vec<usize>, FormulaError> {
        match self.value(expression)? {
            Value::Vector(parts) => Ok(parts),
            Value::Scalar(_) => {
                Err(FormulaError::new(&expression.span, "this is a number, and a vector is needed here"))
            }
        }
    }

    /// Two vectors of one length.
    fn pair(&mut self, [a, b]: [&'f Expression; 2]) -> Result<[Vec<usize>; 2], FormulaError> {
        let [x, y] = [self.vector(a)?, self.vector(b)?];
        if x.len() == y.len() {
            return Ok([x, y]);
        }
        Err(FormulaError::new(
            &(a.span.start..b.span.end),
            format!("vectors of {} and {} do not fit", x.len(), y.len()),
        ))
    }

    fn value(&mut self, expression: &'f Expression) -> Result<Value, FormulaError> {
        self.ops += 1;
        if self.ops > MOST_OPS {
            return Err(FormulaError::new(
                &expression.span,
                format!("the formula has more than {MOST_OPS} operations"),
            ));
        }
        Ok(match &expression.node {
            Node::Number(number) => Value::Scalar(self.builder.constant(*number)),
            Node::Name(name) => match self.names.get(name.as_str()) {
                Some(value) => value.clone(),
                None => self.point(name, expression)?,
            },
            Node::Axes(of, axes) => {
                let mut parts = self.vector(of)?;
                // The weight of a point is behind its coordinates, and not part of its vector.
                if let Node::Name(name) = &of.node
                    && !self.names.contains_key(name.as_str())
                    && let Some(point) = self.points.iter().position(|point| point == name)
                    && axes.contains(&WEIGHT)
                {
                    parts.resize(WEIGHT, usize::MAX);
                    parts.push(self.builder.coordinate(point, self.dimension));
                }
                let picked: Option<Vec<usize>> =
                    axes.iter().map(|&axis| parts.get(axis).copied().filter(|&at| at < usize::MAX)).collect();
                let Some(picked) = picked else {
                    let reason = format!("this vector has {} components", parts.len());
                    return Err(FormulaError::new(&expression.span, reason));
                };
                match picked.as_slice() {
                    &[one] => Value::Scalar(one),
                    _ => Value::Vector(picked),
                }
            }
            Node::Vector(parts) => {
                let mut joined = Vec::new();
                for part in parts {
                    match self.value(part)? {
                        Value::Scalar(at) => joined.push(at),
                        Value::Vector(parts) => joined.extend(parts),
                    }
                }
                Value::Vector(joined)
            }
            Node::Minus(of) => match self.value(of)? {
                Value::Scalar(at) => Value::Scalar(self.builder.neg(at)),
                Value::Vector(parts) => Value::Vector(parts.into_iter().map(|at| self.builder.neg(at)).collect()),
            },
            Node::Plus(a, b) => self.each([a, b], expression, Builder::add)?,
            Node::Difference(a, b) => self.each([a, b], expression, Builder::sub)?,
            Node::Times(a, b) => match (self.value(a)?, self.value(b)?) {
                (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(self.builder.mul(a, b)),
                (Value::Scalar(factor), Value::Vector(parts)) | (Value::Vector(parts), Value::Scalar(factor)) => {
                    Value::Vector(parts.into_iter().map(|at| self.builder.mul(factor, at)).collect())
                }
                (Value::Vector(_), Value::Vector(_)) => {
                    let reason = "a product of two vectors: write dot(u, v) or cross(u, v)";
                    return Err(FormulaError::new(&expression.span, reason));
                }
            },
            Node::Power(base, exponent) => {
                let base = self.scalar(base)?;
                Value::Scalar((1..*exponent).fold(base, |power, _| self.builder.mul(power, base)))
            }
            Node::Call(function, arguments) => self.call(*function, arguments, expression)?,
        })
    }

    fn point(&mut self, name: &str, expression: &Expression) -> Result<Value, FormulaError> {
        match self.points.iter().position(|point| point == name) {
            Some(point) => {
                Ok(Value::Vector((0..self.dimension).map(|axis| self.builder.coordinate(point, axis)).collect()))
            }
            None => {
                let known = self.points.join(", ");
                Err(FormulaError::new(&expression.span, format!("`{name}` is neither defined nor a point ({known})")))
            }
        }
    }

    fn each(
        &mut self,
        [a, b]: [&'f Expression; 2],
        whole: &Expression,
        op: impl Fn(&mut Builder, usize, usize) -> usize,
    ) -> Result<Value, FormulaError> {
        match (self.value(a)?, self.value(b)?) {
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(op(&mut self.builder, a, b))),
            (Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
                Ok(Value::Vector(a.into_iter().zip(b).map(|(a, b)| op(&mut self.builder, a, b)).collect()))
            }
            (Value::Vector(a), Value::Vector(b)) => {
                Err(FormulaError::new(&whole.span, format!("vectors of {} and {} do not fit", a.len(), b.len())))
            }
            _ => Err(FormulaError::new(&whole.span, "a number and a vector can not be added")),
        }
    }

    fn call(
        &mut self,
        function: Function,
        arguments: &'f [Expression],
        whole: &Expression,
    ) -> Result<Value, FormulaError> {
        let wrong = |count: &str| {
            let reason = format!("{} takes {count}, not {}", function.name(), arguments.len());
            Err(FormulaError::new(&whole.span, reason))
        };
        match (function, arguments) {
            (Function::Det, rows) => self.determinant(rows, whole),
            (Function::Sq, [of]) => Ok(Value::Scalar(match self.value(of)? {
                Value::Scalar(at) => self.builder.mul(at, at),
                Value::Vector(parts) => self.dot(&parts, &parts),
            })),
            (Function::Sq, _) => wrong("one argument"),
            (Function::Dot, [a, b]) => {
                let [a, b] = self.pair([a, b])?;
                Ok(Value::Scalar(self.dot(&a, &b)))
            }
            (Function::Cross, [a, b]) => {
                let [u, v] = self.pair([a, b])?;
                match (u.as_slice(), v.as_slice()) {
                    (&[ux, uy], &[vx, vy]) => Ok(Value::Scalar(self.minor([ux, uy], [vx, vy]))),
                    (&[ux, uy, uz], &[vx, vy, vz]) => Ok(Value::Vector(vec![
                        self.minor([uy, uz], [vy, vz]),
                        self.minor([uz, ux], [vz, vx]),
                        self.minor([ux, uy], [vx, vy]),
                    ])),
                    _ => Err(FormulaError::new(&whole.span, "cross takes two vectors of 2 or of 3 components")),
                }
            }
            _ => wrong("two arguments"),
        }
    }

    /// u₁v₂ − u₂v₁.
    fn minor(&mut self, [ux, uy]: [usize; 2], [vx, vy]: [usize; 2]) -> usize {
        let [left, right] = [self.builder.mul(ux, vy), self.builder.mul(uy, vx)];
        self.builder.sub(left, right)
    }

    fn dot(&mut self, u: &[usize], v: &[usize]) -> usize {
        let terms = u.iter().zip(v).map(|(&x, &y)| (self.builder.mul(x, y), false)).collect::<Vec<_>>();
        self.sum(&terms)
    }

    /// A sum of terms with their signs: (t₁ + t₂) + t₃, or a balanced tree if there are more.
    fn sum(&mut self, terms: &[(usize, bool)]) -> usize {
        match *terms {
            [] => self.builder.constant(0.0),
            [(at, minus)] => {
                if minus {
                    self.builder.neg(at)
                } else {
                    at
                }
            }
            _ => {
                let half = terms.len().div_ceil(2);
                let first = self.sum(&terms[..half]);
                match terms[half..] {
                    [(at, true)] => self.builder.sub(first, at),
                    ref rest => {
                        let rest = self.sum(rest);
                        self.builder.add(first, rest)
                    }
                }
            }
        }
    }

    fn determinant(&mut self, rows: &'f [Expression], whole: &Expression) -> Result<Value, FormulaError> {
        let size = rows.len();
        if size > MOST_ROWS {
            return Err(FormulaError::new(&whole.span, format!("det takes at most {MOST_ROWS} rows")));
        }
        let mut matrix = Vec::new();
        for row in rows {
            let vector = self.vector(row)?;
            if vector.len() != size {
                let reason = format!("det of {size} rows needs rows of {size}, and this row has {}", vector.len());
                return Err(FormulaError::new(&row.span, reason));
            }
            matrix.push(vector);
        }
        let mut minors = BTreeMap::new();
        Ok(Value::Scalar(self.minors(&matrix, (1 << size) - 1, &mut minors)))
    }

    /// The determinant of these rows (a set of bits) and as many of the first columns.
    fn minors(&mut self, matrix: &[Vec<usize>], rows: u32, known: &mut BTreeMap<u32, usize>) -> usize {
        if let Some(&at) = known.get(&rows) {
            return at;
        }
        let places: Vec<usize> = (0..matrix.len()).filter(|&row| rows >> row & 1 == 1).collect();
        let column = places.len() - 1;
        let value = match *places.as_slice() {
            [row] => matrix[row][0],
            [first, second] => {
                let [a, b] = [&matrix[first], &matrix[second]].map(|row| [row[0], row[1]]);
                self.minor(a, b)
            }
            _ => {
                let mut terms = Vec::new();
                for (at, &row) in places.iter().enumerate() {
                    let minor = self.minors(matrix, rows & !(1 << row), known);
                    let term = self.builder.mul(matrix[row][column], minor);
                    terms.push((term, (at + column) % 2 == 1));
                }
                self.sum(&terms)
            }
        };
        known.insert(rows, value);
        value
    }
}
