//! A page as data: sections of tables, pictures and sentences.
//!
//! Both kinds of page are made from the same data, so that they can't disagree; a template decides only the appearance
//! of a table.

use std::borrow::Cow;
use std::collections::BTreeMap;

use minijinja::{Value, context};
use serde_json::json;

use predicament_records::format::{length, thousands};

use crate::{Origin, Picture};

/// The number of rows above which a table is long: a page shows the first [`FEW`] rows, and the others on demand.
const LONG: usize = 60;
const FEW: usize = 30;

/// The emphasis of a cell.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Tone {
    /// No emphasis.
    #[default]
    Plain,
    /// Unimportant: printed pale.
    Muted,
    /// Right.
    Good,
    /// Expected, but worth a look.
    Notable,
    /// Wrong.
    Bad,
    /// Allowed by the backend's promise: a tie broken, a value within a tolerance.
    Legal,
    /// A small share of errors.
    Heat1,
    /// A medium share of errors.
    Heat2,
    /// A large share of errors.
    Heat3,
}

impl Tone {
    const fn class(self) -> &'static str {
        match self {
            Tone::Plain => "",
            Tone::Muted => "muted",
            Tone::Good => "good",
            Tone::Notable => "notable",
            Tone::Bad => "bad",
            Tone::Legal => "legal",
            Tone::Heat1 => "heat1",
            Tone::Heat2 => "heat2",
            Tone::Heat3 => "heat3",
        }
    }
}

/// A cell of a table.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Cell {
    text: String,
    /// A second, smaller line.
    detail: String,
    tone: Tone,
    code: bool,
    /// The explanation that a browser shows on demand.
    title: String,
    /// The anchor that it links to in a browser; empty for none.
    link: String,
    framed: bool,
}

impl Cell {
    /// A cell with a count; zero is printed pale.
    pub fn count(n: u64) -> Cell {
        Cell::from(thousands(n)).tone(if n == 0 { Tone::Muted } else { Tone::Plain })
    }

    /// A cell with text in a fixed-width font, for names and ids.
    pub fn code(text: impl Into<String>) -> Cell {
        Cell { code: true, ..Cell::from(text.into()) }
    }

    /// The cell in another tone.
    #[must_use]
    pub fn tone(self, tone: Tone) -> Cell {
        Cell { tone, ..self }
    }

    /// The cell with a second, smaller line.
    #[must_use]
    pub fn detail(self, detail: impl Into<String>) -> Cell {
        Cell { detail: detail.into(), ..self }
    }

    /// The cell with an explanation, which a browser shows on demand.
    #[must_use]
    pub fn title(self, title: impl Into<String>) -> Cell {
        Cell { title: title.into(), ..self }
    }

    /// The cell as a link to an anchor of the page, such as `#findings`; in a browser only.
    #[must_use]
    pub fn link(self, anchor: impl Into<String>) -> Cell {
        Cell { link: anchor.into(), ..self }
    }

    /// The cell in a frame; in a browser only.
    #[must_use]
    pub fn framed(self) -> Cell {
        Cell { framed: true, ..self }
    }

    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    pub(crate) fn detail_text(&self) -> &str {
        &self.detail
    }

    pub(crate) fn is_code(&self) -> bool {
        self.code
    }

    fn value(&self) -> Value {
        context! {
            text => &self.text,
            detail => &self.detail,
            code => self.code,
            title => &self.title,
            link => &self.link,
        }
    }

    /// The attribute `class` of the cell, with a blank before it; empty if there is none. It is as short as possible,
    /// as the tables of a page have a hundred thousand cells.
    fn class(&self, numeric: bool) -> Value {
        let classes = [if numeric { "n" } else { "" }, self.tone.class(), if self.framed { "framed" } else { "" }];
        let classes: Vec<&str> = classes.into_iter().filter(|class| !class.is_empty()).collect();
        Value::from_safe_string(match classes[..] {
            [] => String::new(),
            [one] => format!(" class={one}"),
            _ => format!(" class=\"{}\"", classes.join(" ")),
        })
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Cell {
        Cell { text, ..Cell::default() }
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Cell {
        Cell::from(text.to_owned())
    }
}

/// A table; the columns after the first `labels` hold numbers.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Table {
    caption: String,
    columns: Vec<String>,
    numeric: Vec<bool>,
    rows: Vec<Vec<Cell>>,
    /// The origins of columns; each applies from its column on.
    origins: Vec<(usize, Origin)>,
    /// The rows with other origins.
    rows_from: BTreeMap<usize, Origin>,
    /// True if cells are small and coloured, and heads are vertical.
    heat: bool,
    /// The scope of shares and means, for readers who see only the table.
    basis: String,
}

impl Table {
    /// A table with this caption, which may be empty.
    pub fn new(caption: impl Into<String>) -> Table {
        Table { caption: caption.into(), ..Table::default() }
    }

    /// The table as small coloured cells; in a browser only.
    #[must_use]
    pub fn heat(self) -> Table {
        Table { heat: true, ..self }
    }

    /// Sets the scope of shares and means: a table in a paper has it in its caption.
    #[must_use]
    pub fn basis(self, basis: impl Into<String>) -> Table {
        Table { basis: basis.into(), ..self }
    }

    /// Sets the origin of the columns that are added from here on, up to the next origin.
    #[must_use]
    pub fn of(mut self, origin: Origin) -> Table {
        self.origins.push((self.columns.len(), origin));
        self
    }

    pub(crate) fn origins(&self) -> impl Iterator<Item = &Origin> {
        self.origins.iter().map(|(_, origin)| origin).chain(self.rows_from.values())
    }

    /// Adds columns of words, aligned on the left.
    pub fn words<S: Into<String>>(mut self, heads: impl IntoIterator<Item = S>) -> Table {
        self.columns.extend(heads.into_iter().map(Into::into));
        self.numeric.resize(self.columns.len(), false);
        self
    }

    /// Adds columns of numbers, aligned on the right.
    pub fn numbers<S: Into<String>>(mut self, heads: impl IntoIterator<Item = S>) -> Table {
        self.columns.extend(heads.into_iter().map(Into::into));
        self.numeric.resize(self.columns.len(), true);
        self
    }

    /// Adds a row: a cell for each column.
    ///
    /// # Panics
    /// If the number of cells is not that of the columns.
    pub fn push(&mut self, row: Vec<Cell>) {
        assert_eq!(row.len(), self.columns.len(), "a cell for each column");
        self.rows.push(row);
    }

    /// Adds a row with a different origin than the table's other rows.
    pub fn push_from(&mut self, origin: Origin, row: Vec<Cell>) {
        self.rows_from.insert(self.rows.len(), origin);
        self.push(row);
    }

    pub(crate) fn caption(&self) -> &str {
        &self.caption
    }

    pub(crate) fn basis_text(&self) -> &str {
        &self.basis
    }

    /// The heads, each with true if its column has numbers.
    pub(crate) fn columns(&self) -> impl Iterator<Item = (&str, bool)> {
        self.columns.iter().map(String::as_str).zip(self.numeric.iter().copied())
    }

    pub(crate) fn rows(&self) -> &[Vec<Cell>] {
        &self.rows
    }

    /// True if there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The table for a template. The later rows of a long table go to `rest`, if it is given.
    fn value(&self, rest: Option<&mut Vec<Value>>) -> Value {
        let columns = self.columns.iter().zip(&self.numeric);
        let columns: Vec<Value> =
            columns.map(|(head, &numeric)| context! { head => head, numeric => numeric }).collect();
        let rows = self.rows.iter().enumerate().map(|(at, row)| {
            let cells = row.iter().zip(&self.numeric);
            let cells = cells.map(|(cell, &numeric)| context! { class => cell.class(numeric), ..cell.value() });
            let from = self.rows_from.get(&at).map(|origin| json!([(0, origin.json())]).to_string());
            context! { cells => cells.collect::<Vec<Value>>(), from => from.unwrap_or_default() }
        });
        let mut rows: Vec<Value> = rows.collect();
        let mut more = Value::from(());
        if let Some(rest) = rest
            && rows.len() > LONG
        {
            let of = thousands(length(rows.len()));
            more = context! { at => rest.len(), shown => FEW, of => of };
            rest.push(rows.split_off(FEW).into());
        }
        let origins: Vec<_> = self.origins.iter().map(|(at, origin)| (at, origin.json())).collect();
        let from = if origins.is_empty() { String::new() } else { json!(origins).to_string() };
        context! { kind => "table", from => from, heat => self.heat, caption => &self.caption, columns => columns, rows => rows, more => more }
    }
}

/// A part of a section.
#[derive(Clone, PartialEq, Debug)]
pub enum Block {
    /// A table.
    Table(Table),
    /// A sentence, with its emphasis.
    Note(String, Tone),
    /// A command to type.
    Command(String),
    /// A plot; Markdown, which can't contain it, refers to the file instead.
    Plot {
        /// The picture.
        picture: Picture,
        /// The name of its SVG file, which [`write_pages`](crate::write_pages) writes; its PDF goes beside it.
        file: Cow<'static, str>,
        /// The alternative text.
        alt: Cow<'static, str>,
    },
    /// A PNG as a data URI; not in Markdown.
    Image {
        /// The name.
        name: String,
        /// The data URI.
        uri: String,
    },
}

impl Block {
    /// A table or, if it has no rows, a note that says so.
    pub fn table_or(table: Table, nothing: &str) -> Block {
        if table.is_empty() { Block::Note(nothing.to_owned(), Tone::Notable) } else { Block::Table(table) }
    }

    fn value(&self, rest: Option<&mut Vec<Value>>) -> Value {
        match self {
            Block::Table(table) => table.value(rest),
            Block::Note(text, tone) => context! { kind => "note", text => text, tone => tone.class() },
            Block::Command(text) => context! { kind => "command", text => text },
            Block::Plot { picture, file, alt } => {
                context! { kind => "plot", svg => Value::from_safe_string(picture.svg.clone()), file => &**file, alt => &**alt }
            }
            Block::Image { name, uri } => {
                context! { kind => "image", name => name, uri => Value::from_safe_string(uri.clone()) }
            }
        }
    }
}

/// A heading with its content.
#[derive(Clone, PartialEq, Debug)]
pub struct Section {
    /// The anchor.
    pub id: &'static str,
    /// The heading.
    pub title: &'static str,
    /// An introduction: the content of the section and how to read it.
    pub lead: String,
    /// The content.
    pub blocks: Vec<Block>,
}

impl Section {
    /// The section for a template; the later rows of long tables go to `rest`, if it is given.
    pub(crate) fn value(&self, mut rest: Option<&mut Vec<Value>>) -> Value {
        let blocks: Vec<Value> = self.blocks.iter().map(|block| block.value(rest.as_deref_mut())).collect();
        context! { id => self.id, title => self.title, lead => &self.lead, blocks => blocks }
    }
}

/// A number in large print on top of a report.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Headline {
    /// The number.
    pub number: String,
    /// The label of the number.
    pub label: &'static str,
    /// The total, the backend, or the reason why there is no number.
    pub detail: String,
    /// The emphasis.
    pub tone: Tone,
}

impl Headline {
    pub(crate) fn value(&self) -> Value {
        context! { number => &self.number, label => self.label, detail => &self.detail, tone => self.tone.class() }
    }
}
