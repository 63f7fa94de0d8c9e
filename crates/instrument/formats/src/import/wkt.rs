//! The reader of WKT, well-known text (OGC Simple Features), one geometry after another.
//!
//! The crate `wkt` parses numbers straight to doubles; here a number must keep its text, to be read losslessly or
//! refused. Blank space and semicolons separate geometries, lines that start with `#` are comments, and the `SRID=…;`
//! of PostGIS is skipped.

use super::features::{CLOSE, DEEPEST, Feature, Geometry, Position, Shape, open};
use super::{ImportNotes, Keeps};
use crate::decimals::{Place, explain, shown};
use crate::{CorpusError, Decimals, Lines};

/// A token: a word, a number or a sign.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Token<'t> {
    /// Any other text.
    Word(&'t str),
    Open,
    Close,
    Comma,
    Semicolon,
    End,
}

/// The kind of numbers that follow x and y.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum More {
    /// Not declared: z, then m, if present.
    Unsaid,
    Z,
    M,
    Zm,
}

/// Reads a WKT file.
///
/// # Errors
/// [`CorpusError`] at the line that is wrong.
pub fn read(file: &str, text: &str, decimals: &Decimals, keeps: &mut Keeps<'_>) -> Result<Geometry, CorpusError> {
    // Skipped geometries use this reader, so that their roundings are not counted.
    let unwanted = Decimals::new(true);
    let mut number = 0;
    let mut reader = Reader { file, text, at: 0, lines: Lines::new(text), decimals, notes: ImportNotes::default() };
    let mut features = Vec::new();
    loop {
        match reader.peek() {
            Token::End => break,
            Token::Semicolon => {
                reader.next();
            }
            Token::Word(word) if word.get(..5).is_some_and(|head| head.eq_ignore_ascii_case("SRID=")) => {
                reader.next();
            }
            _ => {
                let line = reader.line();
                let mut shapes = Vec::new();
                let is_wanted = keeps(number, None);
                number += 1;
                let notes = reader.notes;
                reader.decimals = if is_wanted { decimals } else { &unwanted };
                reader.geometry(0, &mut shapes)?;
                if is_wanted {
                    features.push(Feature { name: None, line, shapes });
                } else {
                    reader.notes = notes;
                }
            }
        }
    }
    Ok(Geometry { file: file.to_owned(), features, notes: reader.notes })
}

struct Reader<'r, 't> {
    file: &'r str,
    text: &'t str,
    at: usize,
    lines: Lines,
    decimals: &'r Decimals,
    notes: ImportNotes,
}

impl<'t> Reader<'_, 't> {
    /// Skips blank space and comments.
    fn skip(&mut self) {
        loop {
            let rest = &self.text[self.at..];
            self.at += rest.len() - rest.trim_start().len();
            if !self.text[self.at..].starts_with('#') {
                return;
            }
            self.at += self.text[self.at..].find(['\n', '\r']).unwrap_or(self.text.len() - self.at);
        }
    }

    /// The line of the next token.
    fn line(&mut self) -> usize {
        self.skip();
        self.lines.of(self.at)
    }

    fn peek(&mut self) -> Token<'t> {
        self.skip();
        let rest = &self.text[self.at..];
        match rest.chars().next() {
            None => Token::End,
            Some('(') => Token::Open,
            Some(')') => Token::Close,
            Some(',') => Token::Comma,
            Some(';') => Token::Semicolon,
            Some(_) => {
                let ends = |c: char| c.is_whitespace() || "(),;#".contains(c);
                Token::Word(&rest[..rest.find(ends).unwrap_or(rest.len())])
            }
        }
    }

    fn next(&mut self) -> Token<'t> {
        let token = self.peek();
        self.at += match token {
            Token::Word(word) => word.len(),
            Token::End => 0,
            Token::Open | Token::Close | Token::Comma | Token::Semicolon => 1,
        };
        token
    }

    fn error(&mut self, message: impl Into<String>, cure: &str) -> CorpusError {
        let line = self.line();
        CorpusError::file(self.file, message, cure).at_line(line)
    }

    /// The error for a next token that is not the expected one.
    fn unexpected(&mut self, wanted: &str) -> CorpusError {
        let found = match self.peek() {
            Token::Word(word) => format!("`{}`", shown(word)),
            Token::Open => "`(`".to_owned(),
            Token::Close => "`)`".to_owned(),
            Token::Comma => "`,`".to_owned(),
            Token::Semicolon => "`;`".to_owned(),
            Token::End => "the end of the file".to_owned(),
        };
        self.error(format!("{found} where {wanted} should be"), "write WKT such as POLYGON ((0 0, 1 0, 0 1, 0 0))")
    }

    fn expect(&mut self, token: Token<'_>, wanted: &str) -> Result<(), CorpusError> {
        if self.peek() != token {
            return Err(self.unexpected(wanted));
        }
        self.next();
        Ok(())
    }

    /// Reads `(item, item…)`, or nothing after the word `EMPTY`.
    fn list(&mut self, mut item: impl FnMut(&mut Self) -> Result<(), CorpusError>) -> Result<(), CorpusError> {
        if let Token::Word(word) = self.peek()
            && word.eq_ignore_ascii_case("EMPTY")
        {
            self.next();
            return Ok(());
        }
        self.expect(Token::Open, "`(` or EMPTY")?;
        loop {
            item(self)?;
            match self.peek() {
                Token::Comma => {
                    self.next();
                }
                Token::Close => {
                    self.next();
                    return Ok(());
                }
                _ => return Err(self.unexpected("`,` or `)`")),
            }
        }
    }

    fn geometry(&mut self, depth: usize, shapes: &mut Vec<Shape>) -> Result<(), CorpusError> {
        const KNOWN: [&str; 7] =
            ["POINT", "MULTIPOINT", "LINESTRING", "MULTILINESTRING", "POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION"];
        let Token::Word(word) = self.peek() else { return Err(self.unexpected("a geometry")) };
        let upper = word.to_ascii_uppercase();
        // `POINTZ` is `POINT Z`.
        let kind = KNOWN.iter().find_map(|known| Some((*known, more(upper.strip_prefix(known)?)?)));
        let Some((kind, mut more_numbers)) = kind else {
            let message = format!("no geometry is called `{}`", shown(word));
            return Err(self.error(message, &format!("use one of {}", KNOWN.join(", "))));
        };
        self.next();
        if let (More::Unsaid, Token::Word(word)) = (more_numbers, self.peek())
            && let Some(said) = more(&word.to_ascii_uppercase())
        {
            self.next();
            more_numbers = said;
        }
        match kind {
            "POINT" => self.list(|reader| {
                let position = reader.position(more_numbers)?;
                shapes.push(Shape::Point(position));
                if reader.peek() == Token::Close { Ok(()) } else { Err(reader.unexpected("`)`")) }
            }),
            "MULTIPOINT" => self.list(|reader| {
                // Both `((0 0), (1 1))` and `(0 0, 1 1)` are in use.
                if matches!(reader.peek(), Token::Word(word) if !word.eq_ignore_ascii_case("EMPTY")) {
                    shapes.push(Shape::Point(reader.position(more_numbers)?));
                    return Ok(());
                }
                shapes.extend(reader.positions(more_numbers)?.into_iter().map(Shape::Point));
                Ok(())
            }),
            "LINESTRING" => {
                shapes.push(Shape::Line(self.positions(more_numbers)?));
                Ok(())
            }
            "MULTILINESTRING" => self.list(|reader| {
                shapes.push(Shape::Line(reader.positions(more_numbers)?));
                Ok(())
            }),
            "POLYGON" => {
                shapes.push(self.polygon(more_numbers)?);
                Ok(())
            }
            "MULTIPOLYGON" => self.list(|reader| {
                shapes.push(reader.polygon(more_numbers)?);
                Ok(())
            }),
            _ if depth == DEEPEST => {
                Err(self.error(format!("more than {DEEPEST} nested collections"), "list their members in one"))
            }
            _ => self.list(|reader| reader.geometry(depth + 1, shapes)),
        }
    }

    fn polygon(&mut self, more: More) -> Result<Shape, CorpusError> {
        let mut rings = Vec::new();
        self.list(|reader| {
            let ring = reader.positions(more)?;
            let file = reader.file;
            rings.push(open(ring).map_err(|(line, what)| CorpusError::file(file, what, CLOSE).at_line(line))?);
            Ok(())
        })?;
        Ok(Shape::Polygon(rings))
    }

    fn positions(&mut self, more: More) -> Result<Vec<Position>, CorpusError> {
        let mut positions = Vec::new();
        self.list(|reader| {
            positions.push(reader.position(more)?);
            Ok(())
        })?;
        Ok(positions)
    }

    fn position(&mut self, more: More) -> Result<Position, CorpusError> {
        let line = self.line();
        let mut numbers: Vec<f64> = Vec::with_capacity(4);
        while let Token::Word(word) = self.peek() {
            let number = self.decimals.read(word).map_err(|why| {
                let (message, cure) = explain(Place::Data, word, &why);
                self.error(message, &cure)
            })?;
            self.next();
            numbers.push(number);
            if numbers.len() > 4 {
                break;
            }
        }
        let (height, extra) = match (more, numbers.as_slice()) {
            (More::Unsaid, [_, _]) => (None, 0),
            (More::M, [_, _, _]) => (None, 1),
            (More::Unsaid | More::Z, &[_, _, z]) => (Some(z), 0),
            (More::Unsaid | More::Zm, &[_, _, z, _]) => (Some(z), 1),
            (_, []) => return Err(self.unexpected("a number")),
            _ => {
                let wanted = match more {
                    More::Unsaid => "two to four",
                    More::Z | More::M => "three",
                    More::Zm => "four",
                };
                let message = format!("a position of {} numbers", numbers.len());
                return Err(CorpusError::file(self.file, message, format!("write {wanted}")).at_line(line));
            }
        };
        self.notes.extra_coordinates += extra;
        Ok(Position { at: [numbers[0], numbers[1]], height, line })
    }
}

/// The kind of further numbers that the suffix of a geometry's name declares.
fn more(word: &str) -> Option<More> {
    match word {
        "" => Some(More::Unsaid),
        "Z" => Some(More::Z),
        "M" => Some(More::M),
        "ZM" => Some(More::Zm),
        _ => None,
    }
}

#[cfg(test)]
mod tests;
