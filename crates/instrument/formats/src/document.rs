//! TOML files whose values know their lines, for error messages.
//!
//! Suites are read through these two types instead of derived structures: an error has the line of the wrong value, an
//! unused key is an error, and numbers keep their text, before anything rounds them.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use predicament_predicates::Vertex;

use crate::coordinate::CoordinateError;
use crate::decimals::{Place, explain};
use crate::tables::TableKind;
use crate::{CorpusError, Decimals, Lines};

/// The largest index of a vertex.
const MOST_INDEX: u64 = (1 << 31) - 1;

/// The text of a file, its name, and the starts of its lines.
pub struct Document<'t> {
    file: &'t str,
    text: &'t str,
    lines: Lines,
    /// The reader of coordinates, unless a table has its own.
    exact: Decimals,
}

impl<'t> Document<'t> {
    /// A document from its name in errors and its text.
    #[must_use]
    pub fn new(file: &'t str, text: &'t str) -> Document<'t> {
        Document { file, text, lines: Lines::new(text), exact: Decimals::new(false) }
    }

    /// Parses the whole file.
    pub fn parse(&self) -> Result<Spanned<DeTable<'t>>, CorpusError> {
        DeTable::parse(self.text).map_err(|error| {
            let at = error.span().map_or(0, |span| span.start);
            self.error(at, error.message(), "correct the TOML")
        })
    }

    /// The line of a byte offset, counted from 1.
    pub fn line(&self, at: usize) -> usize {
        self.lines.of(at)
    }

    /// The error at a byte offset.
    pub fn error(&self, at: usize, message: impl Into<String>, cure: impl Into<String>) -> CorpusError {
        CorpusError::file(self.file, message, cure).at_line(self.line(at))
    }
}

/// A value of the file.
#[derive(Clone, Copy)]
pub struct Field<'d, 't> {
    document: &'d Document<'t>,
    decimals: &'d Decimals,
    key: &'d str,
    value: &'d DeValue<'t>,
    span: (usize, usize),
}

impl<'d, 't> Field<'d, 't> {
    fn new(
        document: &'d Document<'t>,
        decimals: &'d Decimals,
        key: &'d str,
        value: &'d Spanned<DeValue<'t>>,
    ) -> Field<'d, 't> {
        let Range { start, end } = value.span();
        Field { document, decimals, key, value: value.get_ref(), span: (start, end) }
    }

    /// The line of the value, from 1.
    pub fn line(&self) -> usize {
        self.document.line(self.span.0)
    }

    /// The name of the file in errors.
    pub fn file(&self) -> &'t str {
        self.document.file
    }

    /// The bytes of the value in the file.
    pub fn span(&self) -> Range<usize> {
        self.span.0..self.span.1
    }

    /// The error at this value.
    pub fn error(&self, message: impl Into<String>, cure: impl Into<String>) -> CorpusError {
        self.document.error(self.span.0, message, cure)
    }

    fn wrong_type(&self, wanted: &str) -> CorpusError {
        let found = self.value.type_str();
        self.error(format!("`{}` is of type {found}", self.key), format!("write {wanted}"))
    }

    /// True if the value is a table.
    #[must_use]
    pub fn is_table(&self) -> bool {
        self.value.is_table()
    }

    /// True if the value is an array.
    #[must_use]
    pub fn is_array(&self) -> bool {
        self.value.is_array()
    }

    /// The value as a string.
    pub fn str(&self) -> Result<&'d str, CorpusError> {
        self.value.as_str().ok_or_else(|| self.wrong_type("a string"))
    }

    /// The value as an owned string.
    pub fn string(&self) -> Result<String, CorpusError> {
        self.str().map(str::to_owned)
    }

    /// The value as an array of strings.
    pub fn strings(&self) -> Result<Vec<String>, CorpusError> {
        self.items("an array of strings")?.map(|item| item.string()).collect()
    }

    /// The members of an array; `wanted` describes the expected contents.
    pub fn items(
        &self,
        wanted: &str,
    ) -> Result<impl ExactSizeIterator<Item = Field<'d, 't>> + use<'d, 't>, CorpusError> {
        let array = self.value.as_array().ok_or_else(|| self.wrong_type(wanted))?;
        let Field { document, decimals, key, .. } = *self;
        Ok(array.iter().map(move |item| Field::new(document, decimals, key, item)))
    }

    /// The key of the value.
    #[must_use]
    pub fn key(&self) -> &'d str {
        self.key
    }

    /// The values of a table with arbitrary keys, in the order of the file.
    pub fn entries(&self) -> Result<Vec<Field<'d, 't>>, CorpusError> {
        let table = self.value.as_table().ok_or_else(|| self.wrong_type("a table"))?;
        let Field { document, decimals, .. } = *self;
        let mut entries: Vec<Field<'d, 't>> =
            table.iter().map(|(key, value)| Field::new(document, decimals, key.get_ref(), value)).collect();
        entries.sort_by_key(|entry| entry.span.0);
        Ok(entries)
    }

    /// The value as one string or an array of strings, each with its position.
    pub fn one_or_more(&self) -> Result<Vec<Field<'d, 't>>, CorpusError> {
        const WANTED: &str = "a string, or an array of strings";
        let each = if self.is_array() { self.items(WANTED)?.collect() } else { vec![*self] };
        match each.iter().find(|item| !item.value.is_str()) {
            Some(wrong) => Err(wrong.wrong_type(WANTED)),
            None => Ok(each),
        }
    }

    /// The value as a table of this kind.
    pub fn fields(&self, kind: &'d TableKind) -> Result<Fields<'d, 't>, CorpusError> {
        let table = self.value.as_table().ok_or_else(|| self.wrong_type("a table"))?;
        Ok(Fields { decimals: self.decimals, ..Fields::new(self.document, kind, table, self.span.0) })
    }

    /// The value as a boolean.
    pub fn bool(&self) -> Result<bool, CorpusError> {
        self.value.as_bool().ok_or_else(|| self.wrong_type("true or false"))
    }

    /// The value as an integer in `range`.
    pub fn integer(&self, range: std::ops::RangeInclusive<u64>) -> Result<u64, CorpusError> {
        let integer = self.value.as_integer().ok_or_else(|| self.wrong_type("an integer"))?;
        let value = u64::from_str_radix(integer.as_str(), integer.radix()).ok().filter(|value| range.contains(value));
        value.ok_or_else(|| {
            let (low, high) = range.into_inner();
            self.error(format!("`{}` is {}", self.key, integer), format!("choose an integer from {low} to {high}"))
        })
    }

    /// The value as an [`integer`](Field::integer) that counts things.
    pub fn count(&self, range: std::ops::RangeInclusive<u64>) -> Result<usize, CorpusError> {
        self.integer(range).map(|value| usize::try_from(value).unwrap_or(usize::MAX))
    }

    /// The value as a positive number, read as its nearest double.
    pub fn positive(&self) -> Result<f64, CorpusError> {
        let number: Option<f64> = self.coordinate_text()?.parse().ok();
        number.filter(|x| x.is_finite() && *x > 0.0).ok_or_else(|| {
            self.error(format!("`{}` is {}", self.key, self.written()), "choose a positive number".to_owned())
        })
    }

    /// The text of a value that should be a coordinate.
    pub fn coordinate_text(&self) -> Result<&str, CorpusError> {
        match self.value {
            DeValue::String(text) => Ok(text),
            DeValue::Integer(integer) if integer.radix() == 10 => Ok(integer.as_str()),
            DeValue::Float(float) => Ok(float.as_str()),
            _ => Err(self.wrong_type("a decimal that is exactly a double, or a hex float in quotes")),
        }
    }

    /// The value as a coordinate: exactly a double, or an error; with `round = true` the nearest double.
    pub fn coordinate(&self) -> Result<f64, CorpusError> {
        let text = self.coordinate_text()?;
        self.decimals.read(text).map_err(|error| self.coordinate_error(text, &error))
    }

    /// The error for a coordinate, with its fix.
    pub fn coordinate_error(&self, text: &str, error: &CoordinateError) -> CorpusError {
        let (message, cure) = explain(Place::Tidied(self.document.file), text, error);
        self.error(message, cure)
    }

    /// The value as the index of a point.
    pub fn point(&self) -> Result<Vertex, CorpusError> {
        self.count(0..=MOST_INDEX).map(Vertex::input)
    }

    /// The value as a vertex: the index of a point, or `"c0"`, `"c1"`… for constructed vertices.
    pub fn vertex(&self) -> Result<Vertex, CorpusError> {
        if !self.value.is_str() {
            return self.point();
        }
        let text = self.str()?;
        text.parse().ok().filter(|vertex: &Vertex| vertex.is_constructed()).ok_or_else(|| {
            self.error(
                format!("`{text}` is not a vertex"),
                "write a point's index, or \"c0\" for the first \
                                construction",
            )
        })
    }

    /// The literal in the file, including quotes.
    pub fn written(&self) -> &'t str {
        &self.document.text[self.span()]
    }

    /// A string or number as written in the file, for names.
    pub fn plain(&self) -> Result<&str, CorpusError> {
        self.coordinate_text()
    }
}

/// The keys of a table, taken one by one; remaining keys are an error.
pub struct Fields<'d, 't> {
    document: &'d Document<'t>,
    decimals: &'d Decimals,
    kind: &'d TableKind,
    table: &'d DeTable<'t>,
    at: usize,
    asked: RefCell<BTreeSet<&'static str>>,
}

impl<'d, 't> Fields<'d, 't> {
    /// The keys of a table that starts at this byte offset.
    pub fn new(document: &'d Document<'t>, kind: &'d TableKind, table: &'d DeTable<'t>, at: usize) -> Fields<'d, 't> {
        Fields { document, decimals: &document.exact, kind, table, at, asked: RefCell::default() }
    }

    /// Changes the reader of the table's coordinates.
    #[must_use]
    pub fn reading(self, decimals: &'d Decimals) -> Fields<'d, 't> {
        Fields { decimals, ..self }
    }

    /// The reader of the table's coordinates.
    #[must_use]
    pub fn decimals(&self) -> &'d Decimals {
        self.decimals
    }

    /// The boolean value of a key, or a default if the key is missing.
    pub fn bool_or(&self, key: &'static str, default: bool) -> Result<bool, CorpusError> {
        self.get(key).map_or(Ok(default), |field| field.bool())
    }

    /// The line where the table starts.
    pub fn line(&self) -> usize {
        self.document.line(self.at)
    }

    /// The name of the file in errors.
    pub fn file(&self) -> &'t str {
        self.document.file
    }

    /// The error about the table as a whole.
    pub fn error(&self, message: impl Into<String>, cure: impl Into<String>) -> CorpusError {
        self.document.error(self.at, message, cure)
    }

    /// The value of a key, if present.
    pub fn get(&self, key: &'static str) -> Option<Field<'d, 't>> {
        assert!(self.kind.keys.contains(&key), "{:?} leaves out {key}", self.kind);
        self.asked.borrow_mut().insert(key);
        let (key, value) = self.table.get_key_value(key)?;
        Some(Field::new(self.document, self.decimals, key.get_ref(), value))
    }

    /// The value of a key that was read before; reading it here does not make the key known.
    pub fn again(&self, key: &'static str) -> Option<Field<'d, 't>> {
        if self.asked.borrow().contains(key) { self.get(key) } else { None }
    }

    /// The value of a required key.
    pub fn required(&self, key: &'static str) -> Result<Field<'d, 't>, CorpusError> {
        self.get(key).ok_or_else(|| {
            let missing = self.error(format!("{} has no `{key}`", self.kind.name), format!("add `{key} = …`"));
            self.lacking(&format!("`{key}`"), missing)
        })
    }

    /// The error about something missing. A key that no table of the kind knows takes precedence: it may be the missing
    /// key, misspelled.
    pub fn lacking(&self, what: &str, missing: CorpusError) -> CorpusError {
        self.first_key_outside(|key| self.kind.keys.contains(&key)).map_or(missing, |(at, key)| {
            let message = format!("a {} has no key `{key}`, and {what} is missing", self.kind.name);
            self.document.error(at, message, format!("correct the key, or remove it and write {what}"))
        })
    }

    /// The first unknown key in the file, and its position.
    fn first_key_outside(&self, known: impl Fn(&str) -> bool) -> Option<(usize, &str)> {
        let keys = self.table.keys().map(|key| (key.span().start, key.get_ref().as_ref()));
        keys.filter(|&(_, key)| !known(key)).min()
    }

    /// Checks all keys, in the order of the file; `wrong` gives the message and the fix for a key that is not allowed.
    pub fn check_keys(&self, wrong: impl Fn(&str) -> Option<(String, String)>) -> Result<(), CorpusError> {
        let Some((at, key)) = self.first_key_outside(|key| wrong(key).is_none()) else { return Ok(()) };
        wrong(key).map_or(Ok(()), |(message, cure)| Err(self.document.error(at, message, cure)))
    }

    /// The string value of a key, or an empty string if the key is missing.
    pub fn string_or_empty(&self, key: &'static str) -> Result<String, CorpusError> {
        self.get(key).map_or(Ok(String::new()), |field| field.string())
    }

    /// The integer value of a key, or a default if the key is missing.
    pub fn integer_or(
        &self,
        key: &'static str,
        default: u64,
        range: std::ops::RangeInclusive<u64>,
    ) -> Result<u64, CorpusError> {
        self.get(key).map_or(Ok(default), |field| field.integer(range))
    }

    /// Refuses keys that were not read.
    pub fn finish(self) -> Result<(), CorpusError> {
        let asked = self.asked.borrow();
        self.first_key_outside(|key| asked.contains(key)).map_or(Ok(()), |(at, key)| {
            let known: Vec<_> = asked.iter().copied().collect();
            let cure = format!("remove it or use one of {}", known.join(", "));
            Err(self.document.error(at, format!("a {} has no key `{key}`", self.kind.name), cure))
        })
    }
}
