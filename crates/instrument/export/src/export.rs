//! The export of many runs: one file per table.

use crate::error::{LineError, WrongCell};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use predicament_records::{Column, Error, Kind, Outcome, RunFolder, TableSpec};

use crate::copies::Copies;
use crate::find::Found;
use crate::format::Format;
use crate::front::{self, FRONT, OWN_TABLES, RunRow};
use crate::place::Places;
use crate::sink::Sink;
use crate::value::{Typed, Value};

/// An observer of an export, which can stop it.
pub trait Watch {
    /// Returns true to stop; called every few thousand rows.
    fn is_stopped(&self) -> bool;

    /// Called when another run is done.
    fn done(&mut self);
}

/// A file that was written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Written {
    /// The path of the file.
    pub path: PathBuf,
    /// The number of rows.
    pub rows: u64,
    /// The size in bytes.
    pub bytes: u64,
}

/// The result of an export.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Exported {
    /// The files: runs and scenes first, then the tables in the order of the schema, then tables without a schema.
    pub files: Vec<Written>,
    /// The names of the runs that are not complete, with how they ended.
    pub incomplete: Vec<(String, String)>,
    /// Notes about facts that the files do not contain.
    pub notes: Vec<String>,
}

/// The number of rows between two checks for a stop.
const PATIENCE: u64 = 1 << 12;

/// Writes the tables of these runs into a folder, a file for each table that one of them has.
///
/// `known` are the tables with a schema; columns of other tables are text. Returns `None` if it was stopped. Then, and
/// after an error, the folder has the files that it had before.
///
/// # Errors
/// The file and line of the first item that can't be read or written, or does not match the schema.
pub fn export(
    runs: &[Found],
    known: &[TableSpec],
    format: Format,
    out: &Path,
    watch: &mut dyn Watch,
) -> Result<Option<Exported>, Error> {
    if RunFolder::is_one(out) {
        return Err(Error::new(
            out,
            "it is a run folder, and an export never overwrites its files; name another folder",
        ));
    }
    let copies = Copies::of(runs)?;
    let mut tables = Tables { format, places: Places::new(out)?, known, open: BTreeMap::new(), notes: Vec::new() };
    let mut incomplete = Vec::new();
    for found in runs {
        let run = RunFolder::open(&found.path)?;
        let row = RunRow::of(&run);
        if row.outcome != Outcome::Complete.name() {
            incomplete.push((found.run.clone(), row.outcome));
        }
        let ended = tables.add(found, &run, &copies, watch);
        // The watch tells whether the export was stopped; errors caused by the stop are ignored.
        if watch.is_stopped() {
            return Ok(None);
        }
        ended?;
        watch.done();
    }
    let (files, notes) = tables.finish()?;
    Ok(Some(Exported { files, incomplete, notes }))
}

/// The tables of an unfinished export.
struct Tables<'k> {
    format: Format,
    places: Places,
    known: &'k [TableSpec],
    /// The tables by their file name in a run folder.
    open: BTreeMap<String, Table>,
    notes: Vec<String>,
}

/// An unfinished table.
struct Table {
    /// The table's columns, including those in front.
    columns: Vec<Typed>,
    /// The file that is being written.
    place: PathBuf,
    sink: Box<dyn Sink>,
    rows: u64,
}

impl Tables<'_> {
    /// Adds all rows of a run.
    fn add(&mut self, found: &Found, run: &RunFolder, copies: &Copies, watch: &dyn Watch) -> Result<(), Error> {
        let mut copied = 0_u64;
        let front = front::cells(found, run);
        let front = front.each_ref().map(String::as_str);
        for table in OWN_TABLES {
            self.table(table.file, table.columns)?;
        }
        for record in front::own_rows(run) {
            let record = record?;
            let table = self.table(record.file, &[])?;
            let cells = record.fields.iter().map(String::as_str);
            // The cells in front come from env.json; the rows themselves from env.json and plan.json.
            let file = if record.file == OWN_TABLES[0].file { "env.json" } else { "plan.json" };
            table.push(front.into_iter().chain(cells)).map_err(|message| {
                Error::new(
                    &found.path.join(file),
                    format!("{message}; restore the file from a copy, or leave this run out"),
                )
            })?;
        }
        for file in run.tables()? {
            let path = found.path.join(&file);
            let mut places = None;
            let left_out = run.each_row(&file, |line, record| {
                if line == 1 {
                    let names: Vec<&str> = record.iter().collect();
                    places = copies.places(run, &file, &names);
                    let checked = self.table(&file, &names)?.check_header(&names);
                    return checked.map_err(|error| Error::at(&path, line, error.to_string()));
                }
                let table = self.table(&file, &[])?;
                if line.is_multiple_of(PATIENCE) && watch.is_stopped() {
                    return Err(Error::new(&path, "stopped"));
                }
                if places.is_some_and(|places| copies.has(run, places, |place| record.get(place))) {
                    copied += 1;
                    return Ok(());
                }
                let pushed = table.push(front.into_iter().chain(record));
                pushed.map_err(|error| Error::at(&path, line, error.to_string()))
            })?;
            if left_out > 0 {
                let note = format!("{}: {left_out} bytes of an unfinished scene were left out", path.display());
                self.notes.push(note);
            }
        }
        if copied > 0 {
            self.notes.push(format!(
                "{}: {copied} rows about scenes and backends that a run of the same build has judged are left out: each \
                 error counts once",
                found.run
            ));
        }
        Ok(())
    }

    /// The table for a file of a run folder; `columns` are its columns if it has no schema.
    fn table(&mut self, file: &str, columns: &[&str]) -> Result<&mut Table, Error> {
        if !self.open.contains_key(file) {
            let known = OWN_TABLES.iter().chain(self.known).find(|known| known.file == file);
            let schema = known.map_or(&[][..], |known| known.schema);
            let mut typed: Vec<Typed> = FRONT.iter().chain(schema).map(Typed::from).collect();
            if schema.is_empty() {
                let text = |name: &&str| Typed { name: (*name).to_owned(), kind: Kind::Text, is_optional: false };
                typed.extend(columns.iter().map(text));
                self.notes.push(format!("{file}: this tool does not have a schema for it, so its columns are text"));
            }
            let name = format!("{}.{}", file.strip_suffix(".csv").unwrap_or(file), self.format.ending());
            let (made, place) = (self.places.start(&name)?, self.places.place(&name));
            let sink = self.format.start(made, &typed).map_err(|error| Error::new(&place, error.to_string()))?;
            self.open.insert(file.to_owned(), Table { columns: typed, place, sink, rows: 0 });
        }
        self.open.get_mut(file).ok_or_else(|| Error::new(file.as_ref(), "the table was not started"))
    }

    /// Moves the files into their places, in the order of the schema; returns them and the notes.
    fn finish(mut self) -> Result<(Vec<Written>, Vec<String>), Error> {
        let mut rows = BTreeMap::new();
        for (file, table) in self.open {
            let name = file.strip_suffix(".csv").unwrap_or(&file).to_owned();
            table.sink.finish().map_err(|error| Error::new(&table.place, error.to_string()))?;
            rows.insert(format!("{name}.{}", self.format.ending()), table.rows);
        }
        self.places.check_others(self.format.ending())?;
        let place = |name: &str| {
            let stem = name.strip_suffix(self.format.ending()).map(|stem| stem.trim_end_matches('.'));
            let mut known = OWN_TABLES.iter().chain(self.known);
            known.position(|table| Some(table.name()) == stem).unwrap_or(usize::MAX)
        };
        let mut files: Vec<Written> = self
            .places
            .keep()?
            .into_iter()
            .map(|(path, bytes)| {
                let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
                Written { rows: rows.get(&name).copied().unwrap_or(0), bytes, path }
            })
            .collect();
        files.sort_by_cached_key(|file| {
            let name = file.path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            (place(&name), name)
        });
        self.notes.sort();
        Ok((files, self.notes))
    }
}

impl Table {
    /// Refuses a file whose columns differ from the table's.
    fn check_header(&self, names: &[&str]) -> Result<(), LineError> {
        let columns = self.columns.iter().skip(FRONT.len()).map(|column| &*column.name);
        if columns.clone().eq(names.iter().copied()) {
            Ok(())
        } else {
            Err(LineError::Head(columns.map(str::to_owned).collect()))
        }
    }

    fn push<'c>(&mut self, cells: impl Iterator<Item = &'c str>) -> Result<(), LineError> {
        let cells: Vec<&str> = cells.collect();
        if cells.len() != self.columns.len() {
            return Err(LineError::Cells { found: cells.len(), columns: self.columns.len() });
        }
        let values = self.columns.iter().zip(&cells).map(|(column, cell)| column.value(cell));
        let values: Vec<Value<'_>> = values.collect::<Result<_, WrongCell>>()?;
        let written = self.sink.push(&cells, &values);
        written.map_err(|error| LineError::Write { place: self.place.clone(), error })?;
        self.rows += 1;
        Ok(())
    }
}

impl From<&Column> for Typed {
    fn from(column: &Column) -> Typed {
        Typed { name: column.name.to_owned(), kind: column.kind, is_optional: column.is_optional }
    }
}
