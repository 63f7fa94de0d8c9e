//! What the columns of a table are: their names, types, units and meanings, from the one definition of its row.
//!
//! A row is a struct, and its columns are its fields. [`table!`](crate::table) makes of the struct everything that is known of the table: how a
//! line is written and read, the header, and the schema that `predicament schema` prints and files of other formats have.

use predicament_predicates::{Class, Status};
use serde::Serialize;

/// What the cells of a column are.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// UTF-8; all ids and names are text.
    Text,
    /// A whole number of 64 bits with its sign.
    Int64,
    /// A double.
    Float64,
    /// True or false.
    Bool,
    /// A moment in UTC, to the microsecond; as text `2026-01-31T23:59:59Z`.
    Timestamp,
}

impl Kind {
    /// Its name in the published schema.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Kind::Text => "text",
            Kind::Int64 => "int64",
            Kind::Float64 => "float64",
            Kind::Bool => "bool",
            Kind::Timestamp => "timestamp",
        }
    }
}

/// A column of a table.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Column {
    /// Its name, the same in every format.
    pub name: &'static str,
    /// What its cells are.
    pub kind: Kind,
    /// Whether a cell may have no value: empty in CSV.
    pub is_optional: bool,
    /// What its numbers count or measure; empty where the type says it all.
    pub unit: &'static str,
    /// What it says, as the documentation of the field has it.
    about: &'static str,
}

impl Column {
    /// A column of a table that is made of rows by [`table!`](crate::table), or of one that is made in another way.
    #[must_use]
    pub const fn new(
        name: &'static str,
        kind: Kind,
        is_optional: bool,
        unit: &'static str,
        about: &'static str,
    ) -> Column {
        let unit = if unit.is_empty() && matches!(kind, Kind::Int64) { "count" } else { unit };
        Column { name, kind, is_optional, unit, about }
    }

    /// What it says, in plain text.
    #[must_use]
    pub fn meaning(&self) -> String {
        plain(self.about)
    }
}

/// The first sentence of a documentation comment, or all of it, without the brackets of its links.
fn plain(about: &str) -> String {
    about.split_whitespace().collect::<Vec<_>>().join(" ").replace("[`", "`").replace("`]", "`")
}

/// A type that a field of a row may have.
pub trait Typed {
    /// What a column of it holds.
    const KIND: Kind;
    /// Whether there may be no value.
    const IS_OPTIONAL: bool = false;
}

macro_rules! typed {
    ($($kind:ident: $($of:ty),+;)+) => {
        $($(impl Typed for $of {
            const KIND: Kind = Kind::$kind;
        })+)+
    };
}

typed! {
    Text: String, Class, Status, crate::Interface;
    Int64: u8, i32, u32, u64;
    Float64: f64;
    Bool: bool;
}

impl<T: Typed> Typed for Option<T> {
    const KIND: Kind = T::KIND;
    const IS_OPTIONAL: bool = true;
}

/// A row and its table from one definition: the struct, how it is written and read, and what its columns are.
///
/// A field has a documentation comment, which is the meaning of its column, and may have another name for its column and a unit:
/// `pub distance: Option<f64> as "distance_over_L" ["L"],`. A whole number without a unit is a count. Behind the struct is what else is said of
/// [`Row`](crate::Row), such as its `check`. The name `serde` has to be in scope: a dependency, or `use predicament_records::serde`.
#[macro_export]
macro_rules! table {
    (
        $(#[doc = $about:literal])+
        $vis:vis struct $Row:ident [$($derive:ident),* $(,)?] in $file:literal {
            $(
                $(#[doc = $meaning:literal])+
                $field_vis:vis $field:ident: $type:ty $(as $name:literal)? $([$unit:literal])?,
            )+
        }
        $($more:tt)*
    ) => {
        $(#[doc = $about])+
        #[derive($($derive,)* $crate::serde::Serialize, $crate::serde::Deserialize)]
        #[serde(crate = "serde")]
        $vis struct $Row {
            $(
                $(#[doc = $meaning])+
                $(#[serde(rename = $name)])?
                $field_vis $field: $type,
            )+
        }

        impl $crate::Row for $Row {
            const FILE: &'static str = $file;
            const COLUMNS: &'static [&'static str] = &[$($crate::table!(@name $field $($name)?)),+];
            const ABOUT: &'static str = concat!($($about, "\n"),+);
            const SCHEMA: &'static [$crate::Column] = &[$(
                $crate::Column::new(
                    $crate::table!(@name $field $($name)?),
                    <$type as $crate::Typed>::KIND,
                    <$type as $crate::Typed>::IS_OPTIONAL,
                    concat!($($unit)?),
                    concat!($($meaning, "\n"),+),
                )
            ),+];

            $($more)*
        }
    };
    (@name $field:ident $name:literal) => { $name };
    (@name $field:ident) => { stringify!($field) };
}

/// The schema of tables for people: a heading, what a row is, and a line for each column.
#[must_use]
pub fn schema_markdown(tables: &[crate::TableSpec]) -> String {
    let mut text = String::new();
    for table in tables {
        let about = table.about();
        text += &format!("### {}\n{about}\n\n| column | type | unit | meaning |\n|---|---|---|---|\n", table.name());
        for column in table.schema {
            let kind = column.kind.name();
            let null = if column.is_optional { ", or null" } else { "" };
            let meaning = column.meaning().replace('|', "\\|");
            text += &format!("| `{}` | {kind}{null} | {} | {meaning} |\n", column.name, column.unit);
        }
        text.push('\n');
    }
    text
}

/// The schema of tables for programs.
#[must_use]
pub fn schema_json(tables: &[crate::TableSpec]) -> serde_json::Value {
    let column = |column: &Column| {
        serde_json::json!({
            "name": column.name, "type": column.kind.name(), "null": column.is_optional, "unit": column.unit,
            "meaning": column.meaning(),
        })
    };
    let table = |table: &crate::TableSpec| {
        let columns: Vec<_> = table.schema.iter().map(column).collect();
        serde_json::json!({ "table": table.name(), "file": table.file, "row": table.about(), "columns": columns })
    };
    serde_json::json!({ "format": crate::FORMAT, "tables": tables.iter().map(table).collect::<Vec<_>>() })
}

impl crate::TableSpec {
    /// The table's name: its file's, without the ending.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.file.strip_suffix(".csv").unwrap_or(self.file)
    }

    /// What a row is, in plain text; without the name of the file, which is said before.
    #[must_use]
    pub fn about(&self) -> String {
        let about = plain(self.about);
        let named = format!("`{}`: ", self.file);
        about.strip_prefix(&named).map_or_else(|| about.clone(), capitalised)
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
