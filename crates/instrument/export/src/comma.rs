//! CSV: cells as they were, with the columns in front.

use std::fs::File;

use predicament_records::with_cure;

use crate::sink::Sink;
use crate::value::{Typed, Value};

pub(crate) struct Comma(csv::Writer<File>);

impl Comma {
    pub fn new(file: File, columns: &[Typed]) -> Result<Comma, String> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(columns.iter().map(|column| &column.name)).map_err(told)?;
        Ok(Comma(writer))
    }
}

impl Sink for Comma {
    fn push(&mut self, cells: &[&str], _: &[Value<'_>]) -> Result<(), String> {
        self.0.write_record(cells).map_err(told)
    }

    fn finish(mut self: Box<Self>) -> Result<(), String> {
        self.0.flush().map_err(|error| with_cure(&error))
    }
}

fn told(error: csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::Io(of) => with_cure(of),
        _ => error.to_string(),
    }
}
