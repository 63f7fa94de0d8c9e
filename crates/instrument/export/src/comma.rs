//! The CSV format: cells as they were, with the columns in front.

use crate::error::WriteError;
use std::fs::File;

use crate::sink::Sink;
use crate::value::{Typed, Value};

pub(crate) struct Comma(csv::Writer<File>);

impl Comma {
    pub fn new(file: File, columns: &[Typed]) -> Result<Comma, WriteError> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(columns.iter().map(|column| &column.name))?;
        Ok(Comma(writer))
    }
}

impl Sink for Comma {
    fn push(&mut self, cells: &[&str], _: &[Value<'_>]) -> Result<(), WriteError> {
        Ok(self.0.write_record(cells)?)
    }

    fn finish(mut self: Box<Self>) -> Result<(), WriteError> {
        Ok(self.0.flush()?)
    }
}
