//! The columns of a table: their names, types, units and meanings, from the one definition of its row.
//!
//! A row is a struct, and its columns are its fields. [`table!`](crate::table) derives from the struct how a line is
//! written and read, the header, and the schema. `predicament data schema` prints the schema, and files in other
//! formats contain it.

use predicament_predicates::{Class, Status};
use serde::Serialize;

/// The type of a column's cells.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// UTF-8; all ids and names are text.
    Text,
    /// A signed whole number of 64 bits.
    Int64,
    /// An IEEE 754 double.
    Float64,
    /// True or false.
    Bool,
    /// A moment in UTC, to the microsecond; as text `2026-01-31T23:59:59Z`.
    Timestamp,
}

impl Kind {
    /// The type's name in the published schema.
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
    /// The column's name, the same in every format.
    pub name: &'static str,
    /// The type of its cells.
    pub kind: Kind,
    /// True if a cell may have no value: empty in CSV.
    pub is_optional: bool,
    /// The unit of its numbers; empty if the type says it all.
    pub unit: &'static str,
    /// The column's meaning: the documentation of the field.
    about: &'static str,
}

impl Column {
    /// A column of a table, whether [`table!`](crate::table) makes the table or not.
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

    /// The column's meaning, in plain text.
    #[must_use]
    pub fn meaning(&self) -> String {
        plain(self.about)
    }
}

/// A documentation comment in one line, without the brackets of its links.
fn plain(about: &str) -> String {
    about.split_whitespace().collect::<Vec<_>>().join(" ").replace("[`", "`").replace("`]", "`")
}

/// A type that a field of a row may have.
pub trait Typed {
    /// The type of a column with this field.
    const KIND: Kind;
    /// True if a value may be missing.
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

/// A row and its table from one definition: the struct, its reading and writing, and its columns.
///
/// Each field needs a documentation comment, which is the meaning of its column. A field may name its column and its
/// unit: `pub distance: Option<f64> as "distance_over_L" ["L"],`. A whole number without a unit is a count. Other items
/// of [`Row`](crate::Row), such as `check`, follow the struct. The name `serde` has to be in scope: a dependency, or
/// `use predicament_records::serde`.
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

/// The schema of tables as Markdown: a heading, a description of a row, and a line for each column.
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

/// The schema of tables as JSON.
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
    /// The table's name: its file name without the ending.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.file.strip_suffix(".csv").unwrap_or(self.file)
    }

    /// The description of a row, in plain text, without the name of the file.
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
