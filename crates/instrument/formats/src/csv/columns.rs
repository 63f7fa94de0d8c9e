//! The choice of the columns of a CSV file that hold the coordinates.

use std::fmt;

use serde_json::Value;

use super::{is_name, is_number};
use crate::CorpusError;
use crate::decimals::shown;
use crate::document::Field;
use crate::nearest::nearest;

/// A column by its name in the header, or by its number from 1.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Column {
    /// A name, as the header spells it.
    Name(String),
    /// A number, from 1.
    Number(usize),
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Column::Name(name) => f.write_str(name),
            Column::Number(number) => number.fmt(f),
        }
    }
}

/// The columns of x and y, or of x, y and z, in this order.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Columns(Vec<Column>);

/// The cure for wrong names of columns.
const WRITE: &str =
    "write two or three columns, each by its name in the header or its number from 1: `columns = [\"lon\", \"lat\"]`";

impl Columns {
    /// Two or three columns that differ.
    ///
    /// # Errors
    /// A message that describes the wrong column.
    pub fn new(columns: Vec<Column>) -> Result<Columns, String> {
        if !(2..=3).contains(&columns.len()) {
            let (count, s) = (columns.len(), if columns.len() == 1 { "" } else { "s" });
            return Err(format!("{count} column{s} for the coordinates of a point"));
        }
        if let Some(twice) = columns.iter().enumerate().find(|(at, column)| columns[..*at].contains(column)) {
            return Err(format!("the column `{}` twice", shown(&twice.1.to_string())));
        }
        if columns.iter().any(|column| matches!(column, Column::Name(name) if name.is_empty())) {
            return Err("a column without a name".to_owned());
        }
        Ok(Columns(columns))
    }

    /// Parses columns in the form of the command line: `lon,lat` or `3,2`.
    ///
    /// # Errors
    /// A message that describes the wrong column.
    pub fn parse(text: &str) -> Result<Columns, String> {
        let column = |name: &str| match name.parse() {
            Ok(0) => Err("columns are numbered from 1".to_owned()),
            Ok(number) => Ok(Column::Number(number)),
            Err(_) => Ok(Column::Name(name.to_owned())),
        };
        Columns::new(text.split(',').map(|name| column(name.trim())).collect::<Result<_, _>>()?)
    }

    /// Reads the key `columns` of a suite.
    ///
    /// # Errors
    /// [`CorpusError`] at the line that is wrong.
    pub fn read(field: &Field<'_, '_>) -> Result<Columns, CorpusError> {
        const MOST: u64 = 1 << 20;
        let items = field.items("an array of the columns of x and y: [\"lon\", \"lat\"]")?;
        let column = |item: Field<'_, '_>| match item.str() {
            Ok(name) => Ok(Column::Name(name.trim().to_owned())),
            Err(_) => {
                item.count(1..=MOST).map(Column::Number).map_err(|error| CorpusError { cure: WRITE.into(), ..error })
            }
        };
        let columns = items.map(column).collect::<Result<_, _>>()?;
        Columns::new(columns).map_err(|message| field.error(message, WRITE))
    }

    /// The columns, in the order x, y and z.
    #[must_use]
    pub fn all(&self) -> &[Column] {
        &self.0
    }

    /// The value of the key `columns` in a suite: `["lon", "lat"]`.
    #[must_use]
    pub fn toml(&self) -> String {
        let item = |column: &Column| match column {
            Column::Name(name) => Value::from(name.as_str()).to_string(),
            Column::Number(number) => number.to_string(),
        };
        format!("[{}]", self.0.iter().map(item).collect::<Vec<_>>().join(", "))
    }
}

/// Writes the columns in the form of the command line: `lon,lat`.
impl fmt::Display for Columns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.iter().map(Column::to_string).collect::<Vec<_>>().join(","))
    }
}

/// The coordinate columns that a header names by a known convention, and the other columns.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Recognised {
    /// The columns of the coordinates.
    pub columns: Columns,
    /// The names of the other columns, in the order of the file.
    pub others: Vec<String>,
}

/// Writes one line that lists the columns that are read and the columns that are not.
impl fmt::Display for Recognised {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = |(axis, column): (&str, &Column)| format!("{axis} is the column `{column}`");
        let read: Vec<String> = ["x", "y", "z"].into_iter().zip(&self.columns.0).map(of).collect();
        f.write_str(&read.join(", "))?;
        match self.others.as_slice() {
            [] => Ok(()),
            [one] => write!(f, "; the column {} is not read", listed(std::slice::from_ref(one))),
            others => write!(f, "; the columns {} are not read", listed(others)),
        }
    }
}

/// Names that mean x, y and z by convention.
const CONVENTIONS: [&[&str]; 5] =
    [&["x", "y", "z"], &["x", "y"], &["lon", "lat"], &["longitude", "latitude"], &["easting", "northing"]];

/// The columns of the coordinates, if the first row names them unambiguously: it has all names of one convention, each
/// once, and does not have a name of another convention.
pub(super) fn recognised(first: &[&str]) -> Option<Recognised> {
    let lower: Vec<String> = first.iter().map(|name| name.to_lowercase()).collect();
    let is_meant = |name: &&String| CONVENTIONS.iter().any(|names| names.contains(&name.as_str()));
    let meant: Vec<&String> = lower.iter().filter(is_meant).collect();
    let fits =
        |names: &&&[&str]| meant.len() == names.len() && names.iter().all(|name| meant.iter().any(|m| m == name));
    let names = CONVENTIONS.iter().find(fits)?;
    let at: Vec<usize> = names.iter().filter_map(|name| lower.iter().position(|other| other == name)).collect();
    let columns = Columns(at.iter().map(|&at| Column::Name(first[at].to_owned())).collect());
    let others = first.iter().enumerate().filter(|(place, _)| !at.contains(place)).map(|(_, name)| (*name).to_owned());
    Some(Recognised { columns, others: others.collect() })
}

/// Names for a message, each of a bounded length.
pub(super) fn listed<T: AsRef<str>>(names: &[T]) -> String {
    let name = |name: &T| if name.as_ref().is_empty() { "``".to_owned() } else { shown(name.as_ref()) };
    names.iter().map(name).collect::<Vec<_>>().join(", ")
}

/// The columns to read, with their positions in the first row.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Chosen {
    /// The positions of the columns, from 0.
    pub(super) at: Vec<usize>,
    /// The names of the columns for messages.
    pub(super) names: Vec<String>,
    /// The number of cells of the first row; every row must have the same number.
    pub(super) width: usize,
    /// True if the first row is a header.
    pub(super) is_header: bool,
    /// The columns in the form of the command line.
    pub(super) option: String,
}

impl Chosen {
    /// Finds columns in the first row. An error is a message and its cure.
    pub(super) fn find(columns: &Columns, first: &[&str]) -> Result<Chosen, (String, String)> {
        let at = columns.0.iter().map(|column| place(column, first)).collect::<Result<Vec<usize>, _>>()?;
        if let Some(twice) = (1..at.len()).find(|&second| at[..second].contains(&at[second])) {
            let message = format!("`{}` names a column that is already named", shown(&columns.0[twice].to_string()));
            return Err((message, "name each column once".to_owned()));
        }
        let by_name = columns.0.iter().any(|column| matches!(column, Column::Name(_)));
        let is_header = by_name || at.iter().all(|&at| is_name(first[at]));
        let names = columns.0.iter().map(|column| match column {
            Column::Name(name) => format!("column `{}`", shown(name)),
            Column::Number(number) => format!("column {number}"),
        });
        Ok(Chosen { names: names.collect(), at, width: first.len(), is_header, option: columns.to_string() })
    }

    /// Refuses a row whose number of cells differs from the first row's: a cell is missing, or was split. An error is a
    /// message and its cure.
    pub(super) fn check(&self, found: usize) -> Result<(), (String, String)> {
        if found == self.width {
            return Ok(());
        }
        let first = if self.is_header { "the header" } else { "the first row" };
        let lacks = self.at.iter().zip(&self.names).find(|(at, _)| **at >= found);
        let lacks = lacks.map_or_else(String::new, |(_, name)| format!(": {name} is missing"));
        let message = format!("the row has {found} cells, {first} has {}{lacks}", self.width);
        let cure =
            format!("give every row {} cells; put a cell that contains a separator in double quotes", self.width);
        Err((message, cure))
    }
}

/// The position of a column in the first row, from 0.
fn place(column: &Column, first: &[&str]) -> Result<usize, (String, String)> {
    let is_header = !first.iter().any(|cell| is_number(cell));
    let has = if is_header { "the columns are" } else { "the first row is not a header:" };
    match column {
        Column::Number(number) if (1..=first.len()).contains(number) => Ok(number - 1),
        Column::Number(number) => {
            let message = format!("there is no column {number}: the first row has {} cells", first.len());
            Err((message, format!("choose numbers from 1 to {}", first.len())))
        }
        Column::Name(name) => {
            let mut places = first.iter().enumerate().filter(|(_, cell)| **cell == name).map(|(at, _)| at);
            match (places.next(), places.next()) {
                (Some(at), None) => Ok(at),
                (Some(_), Some(_)) => {
                    let message = format!("two columns are called `{}`", shown(name));
                    Err((message, "name the column by its number, from 1".to_owned()))
                }
                (None, _) => {
                    let message = format!("there is no column `{}`: {has} {}", shown(name), listed(first));
                    let cure = match nearest(name, first.iter().copied()).filter(|_| is_header) {
                        Some(near) => format!(
                            "did you mean `{}`? name columns of the header, or their numbers from 1",
                            shown(near)
                        ),
                        None if is_header => "name columns of the header, or their numbers from 1".to_owned(),
                        None => "name the columns by their numbers, from 1".to_owned(),
                    };
                    Err((message, cure))
                }
            }
        }
    }
}
