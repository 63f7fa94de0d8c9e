//! Recursive descent over the tokens of a formula.

use super::token::{Token, tokens};
use super::{Expression, FormulaError, Function, Node, Span, Syntax};

/// The deepest nesting of a formula.
const DEEPEST: usize = 100;

/// The largest exponent of a power.
const LARGEST_EXPONENT: u32 = 16;

/// Reads a formula.
///
/// # Errors
/// [`FormulaError`] with the place and the reason.
pub fn parse(text: &str) -> Result<Syntax, FormulaError> {
    let mut parser = Parser { tokens: tokens(text)?, at: 0, depth: 0 };
    let mut definitions: Vec<(String, Expression)> = Vec::new();
    loop {
        if let [(Token::Name(name), span), (Token::Sign('='), _), ..] = &parser.tokens[parser.at..] {
            let (name, span) = (name.clone(), span.clone());
            if function(&name).is_some() {
                return Err(FormulaError::new(&span, format!("`{name}` is a function; choose another name")));
            }
            if definitions.iter().any(|(defined, _)| *defined == name) {
                return Err(FormulaError::new(&span, format!("`{name}` is defined twice")));
            }
            parser.at += 2;
            let expression = parser.sum()?;
            parser.expect(';', "a definition ends with `;`")?;
            let mut used = Vec::new();
            expression.names(&mut used);
            if used.contains(&name) {
                return Err(FormulaError::new(&span, format!("`{name}` is defined by itself")));
            }
            definitions.push((name, expression));
            continue;
        }
        let value = parser.sum()?;
        let _ = parser.take(';');
        return match parser.next() {
            (Token::End, _) => Ok(Syntax { definitions, value }),
            (_, span) => Err(FormulaError::new(&span, "the formula should end here; is an operator missing?")),
        };
    }
}

fn function(name: &str) -> Option<Function> {
    Function::ALL.into_iter().find(|function| function.name() == name)
}

struct Parser {
    tokens: Vec<(Token, Span)>,
    at: usize,
    depth: usize,
}

impl Parser {
    fn peek(&self) -> &(Token, Span) {
        &self.tokens[self.at]
    }

    fn next(&mut self) -> (Token, Span) {
        let token = self.peek().clone();
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    fn take(&mut self, sign: char) -> Option<Span> {
        let found = matches!(self.peek(), (Token::Sign(next), _) if *next == sign);
        found.then(|| self.next().1)
    }

    fn expect(&mut self, sign: char, why: &str) -> Result<Span, FormulaError> {
        self.take(sign).ok_or_else(|| FormulaError::new(&self.peek().1, format!("`{sign}` is missing: {why}")))
    }

    fn sum(&mut self) -> Result<Expression, FormulaError> {
        let mut sum = self.product()?;
        loop {
            let node = if self.take('+').is_some() {
                Node::Plus
            } else if self.take('-').is_some() {
                Node::Difference
            } else {
                return Ok(sum);
            };
            let next = self.product()?;
            let span = sum.span.start..next.span.end;
            sum = Expression { node: node(Box::new(sum), Box::new(next)), span };
        }
    }

    fn product(&mut self) -> Result<Expression, FormulaError> {
        let mut product = self.factor()?;
        while self.take('*').is_some() {
            let next = self.factor()?;
            let span = product.span.start..next.span.end;
            product = Expression { node: Node::Times(Box::new(product), Box::new(next)), span };
        }
        Ok(product)
    }

    fn factor(&mut self) -> Result<Expression, FormulaError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(FormulaError::new(&self.peek().1, format!("the formula is nested deeper than {DEEPEST}")));
        }
        let factor = match self.take('-') {
            Some(Span { start, .. }) => {
                let of = self.factor()?;
                let span = start..of.span.end;
                Expression { node: Node::Minus(Box::new(of)), span }
            }
            None => self.power()?,
        };
        self.depth -= 1;
        Ok(factor)
    }

    fn power(&mut self) -> Result<Expression, FormulaError> {
        let base = self.primary()?;
        if self.take('^').is_none() {
            return Ok(base);
        }
        let (token, span) = self.next();
        let exponent = match token {
            Token::Number(number) => {
                (1..=LARGEST_EXPONENT).find(|&exponent| f64::from(exponent).total_cmp(&number).is_eq())
            }
            _ => None,
        };
        let Some(exponent) = exponent else {
            let reason = format!("an exponent is a whole number from 1 to {LARGEST_EXPONENT}");
            return Err(FormulaError::new(&span, reason));
        };
        let span = base.span.start..span.end;
        Ok(Expression { node: Node::Power(Box::new(base), exponent), span })
    }

    fn primary(&mut self) -> Result<Expression, FormulaError> {
        let (token, span) = self.next();
        let mut primary = match token {
            Token::Number(number) => Expression { node: Node::Number(number), span },
            Token::Name(name) => match (function(&name), self.take('(')) {
                (Some(function), Some(_)) => {
                    let (arguments, end) = self.list(')')?;
                    Expression { node: Node::Call(function, arguments), span: span.start..end }
                }
                (Some(_), None) => {
                    return Err(FormulaError::new(&span, format!("`{name}` is a function: write `{name}(...)`")));
                }
                (None, Some(_)) => return Err(FormulaError::new(&span, unknown(&name))),
                (None, None) => Expression { node: Node::Name(name), span },
            },
            Token::Sign('(') => {
                let mut inner = self.sum()?;
                let end = self.expect(')', "the bracket is open")?;
                inner.span = span.start..end.end;
                inner
            }
            Token::Sign('[') => {
                let (parts, end) = self.list(']')?;
                Expression { node: Node::Vector(parts), span: span.start..end }
            }
            Token::Sign(sign) => {
                return Err(FormulaError::new(&span, format!("`{sign}` is here instead of a number, a point or `(`")));
            }
            Token::End => return Err(FormulaError::new(&span, "the formula ends too early")),
        };
        while self.take('.').is_some() {
            let (token, span) = self.next();
            let axes = match &token {
                Token::Name(axes) => axes.chars().map(|c| "xyzw".find(c)).collect::<Option<Vec<usize>>>(),
                _ => None,
            };
            let Some(axes) = axes else {
                return Err(FormulaError::new(&span, "coordinates are x, y, z and w, for example `a.x` or `a.xy`"));
            };
            let span = primary.span.start..span.end;
            primary = Expression { node: Node::Axes(Box::new(primary), axes), span };
        }
        Ok(primary)
    }

    /// Expressions up to a closing bracket, and the end of that.
    fn list(&mut self, close: char) -> Result<(Vec<Expression>, usize), FormulaError> {
        let mut parts = vec![self.sum()?];
        while self.take(',').is_some() {
            parts.push(self.sum()?);
        }
        let end = self.expect(close, "the list is open")?;
        Ok((parts, end.end))
    }
}

/// The refusal of a function that formulas lack, with the cure.
fn unknown(name: &str) -> String {
    let cure = match name {
        "sqrt" | "norm" | "length" => {
            "; a formula has no roots: compare squares, for example `sq(p - a) - sq(p - b)` for distances"
        }
        "abs" | "min" | "max" => "; it is not a polynomial: split the predicate by the sign inside it",
        _ => "",
    };
    format!("no function is called `{name}`: there are det, dot, sq and cross{cure}")
}
