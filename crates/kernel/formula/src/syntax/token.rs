//! The words of a formula.

use super::{FormulaError, Span};

/// The longest text of a formula, in bytes.
const LONGEST: usize = 20_000;

#[derive(Clone, PartialEq, Debug)]
pub(super) enum Token {
    Number(f64),
    Name(String),
    /// One of `+ - * ^ ( ) [ ] , . ; =`.
    Sign(char),
    End,
}

/// The tokens of a text, each with its place; the last one is [`Token::End`].
pub(super) fn tokens(text: &str) -> Result<Vec<(Token, Span)>, FormulaError> {
    if text.len() > LONGEST {
        return Err(FormulaError::new(&(0..1), format!("the formula is longer than {LONGEST} bytes")));
    }
    let mut found = Vec::new();
    let mut rest = text.char_indices().peekable();
    while let Some(&(start, c)) = rest.peek() {
        let end = |rest: &mut std::iter::Peekable<std::str::CharIndices>| rest.peek().map_or(text.len(), |&(at, _)| at);
        if c.is_whitespace() {
            rest.next();
        } else if c == '#' {
            while rest.next_if(|&(_, c)| c != '\n').is_some() {}
        } else if c.is_ascii_digit() {
            let mut last = ' ';
            while let Some((_, c)) = rest.next_if(|&(_, c)| {
                c.is_ascii_alphanumeric() || c == '.' || (matches!(c, '+' | '-') && matches!(last, 'e' | 'E'))
            }) {
                last = c;
            }
            let span = start..end(&mut rest);
            let number = number(&text[span.clone()]).map_err(|reason| FormulaError::new(&span, reason))?;
            found.push((Token::Number(number), span));
        } else if c.is_alphabetic() || c == '_' {
            while rest.next_if(|&(_, c)| c.is_alphanumeric() || c == '_').is_some() {}
            let span = start..end(&mut rest);
            found.push((Token::Name(text[span.clone()].to_owned()), span));
        } else {
            rest.next();
            let span = start..end(&mut rest);
            let sign = match c {
                '\u{2212}' => '-',
                '\u{b7}' | '\u{d7}' => '*',
                '+' | '-' | '*' | '^' | '(' | ')' | '[' | ']' | ',' | '.' | ';' | '=' => c,
                '/' => {
                    let cure = "a formula has no division: multiply by the denominator, and by it once more if its sign can change";
                    return Err(FormulaError::new(&span, cure));
                }
                _ => return Err(FormulaError::new(&span, format!("`{c}` is not part of a formula"))),
            };
            found.push((Token::Sign(sign), span));
        }
    }
    found.push((Token::End, text.len()..text.len()));
    Ok(found)
}

/// A whole number below 2^53.
fn number(text: &str) -> Result<f64, &'static str> {
    let whole = text.parse::<u64>().ok().filter(|number| *number < 1 << 53);
    #[allow(clippy::cast_precision_loss)] // below 2^53
    let number = whole.map(|number| number as f64);
    number.ok_or("numbers in a formula are whole and below 2^53: multiply the formula by the denominator")
}
